#include "picture/registry.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "effects/registry.hpp"
#include "picture/acts/acts.hpp"

namespace gjkscope {
namespace {

constexpr std::array kActs = {
#define GJKSCOPE_ACT(name) &acts::k##name,
#include "picture/acts/list.def"
#undef GJKSCOPE_ACT
};

constexpr std::array kBlocks = {
#define GJKSCOPE_BLOCK(name) &blocks::k##name,
#include "picture/blocks/list.def"
#undef GJKSCOPE_BLOCK
};

constexpr std::array kListings = {
#define GJKSCOPE_LISTING(name) &listings::k##name,
#include "picture/blocks/listings.def"
#undef GJKSCOPE_LISTING
};

Vocabulary make_vocabulary() {
  Vocabulary out;
  for (const StagedAct* staged : kActs) {
    out.acts.push_back(&staged->act);
    if (staged->plot_title != nullptr) out.plots.push_back(&staged->act);
  }
  for (const Block* block : kBlocks)
    out.blocks.push_back({block->name, block->act, block->second_run, block->takes_listing});
  for (const Listing* listing : kListings) out.listings.push_back({listing->name, listing->act});
  for (const EffectInfo& effect : registered_effects()) {
    if (effect.used_by == "view")
      out.effects.push_back({effect.name, effect.act, effect.second_run});
  }
  return out;
}

}  // namespace

std::span<const StagedAct* const> registered_acts() { return kActs; }
std::span<const Block* const> registered_blocks() { return kBlocks; }
std::span<const Listing* const> registered_listings() { return kListings; }

const Vocabulary& vocabulary() {
  static const Vocabulary all = make_vocabulary();
  return all;
}

const StagedAct& staged(const LessonRun& run) {
  return **std::find_if(kActs.begin(), kActs.end(),
                        [&](const StagedAct* each) { return &each->act == run.act; });
}

LessonRun run_lesson(Lesson lesson) {
  const Act* act = vocabulary().act(lesson.act);
  assert(act != nullptr);
  return run_lesson(std::move(lesson), *act);
}

}  // namespace gjkscope
