#include "picture/registry.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "effects/minkowski.hpp"
#include "effects/registry.hpp"
#include "picture/acts/acts.hpp"

namespace gjkscope {

namespace {

constexpr std::array kAlgorithms = {
#define GJKSCOPE_ALGORITHM(name) &algorithms::name,
#include "algorithms/list.def"
#undef GJKSCOPE_ALGORITHM
};

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

/// The values of a table, and those that algorithms add to it.
template <class T>
std::vector<T> all(std::span<const T> own, std::span<const T> ShownAlgorithm::*more) {
  std::vector<T> out(own.begin(), own.end());
  for (const ShownAlgorithm* each : kAlgorithms)
    out.insert(out.end(), (each->*more).begin(), (each->*more).end());
  return out;
}

Vocabulary make_vocabulary() {
  Vocabulary out;
  for (const StagedAct* staged : registered_acts()) {
    out.acts.push_back(&staged->act);
    if (staged->plot_title != nullptr) out.plots.push_back(&staged->act);
  }
  out.keys = lesson_keys(out.acts);
  for (const Block* block : registered_blocks())
    out.blocks.push_back({block->name, block->act, block->second_run, block->takes_listing});
  for (const Listing* listing : registered_listings())
    out.listings.push_back({listing->name, listing->act});
  for (const EffectInfo& effect : registered_effects()) {
    if (effect.used_by == "view")
      out.effects.push_back({.name = effect.name,
                             .act = effect.act,
                             .second_run = effect.second_run,
                             .pairs_vertices = effect.pulls(MinkowskiCloud::kName)});
  }
  return out;
}

}  // namespace

std::span<const StagedAct* const> registered_acts() {
  static const auto acts = all<const StagedAct*>(kActs, &ShownAlgorithm::acts);
  return acts;
}

std::span<const Block* const> registered_blocks() {
  static const auto blocks = all<const Block*>(kBlocks, &ShownAlgorithm::blocks);
  return blocks;
}

std::span<const Listing* const> registered_listings() {
  static const auto listings = all<const Listing*>(kListings, &ShownAlgorithm::listings);
  return listings;
}

std::vector<LegendEntry> legend_entries(const LessonRun& run) {
  std::vector<LegendEntry> list(own_legend_entries().begin(), own_legend_entries().end());
  for (const ShownAlgorithm* folder : kAlgorithms) {
    if (std::find(folder->acts.begin(), folder->acts.end(), &staged(run)) == folder->acts.end())
      continue;
    // What an algorithm says of a mark that GJK has, too, counts.
    for (const LegendEntry& entry : folder->legend) {
      const auto own = std::find_if(list.begin(), list.end(), [&](const LegendEntry& other) {
        return other.role == entry.role;
      });
      own == list.end() ? list.push_back(entry) : void(*own = entry);
    }
  }
  return list;
}

const Vocabulary& vocabulary() {
  static const Vocabulary all = make_vocabulary();
  return all;
}

const StagedAct& staged(const LessonRun& run) {
  const std::span<const StagedAct* const> acts = registered_acts();
  return **std::find_if(acts.begin(), acts.end(),
                        [&](const StagedAct* each) { return &each->act == run.act; });
}

LessonRun run_lesson(Lesson lesson) {
  const Act* act = vocabulary().act(lesson.act);
  assert(act != nullptr);
  return run_lesson(std::move(lesson), *act);
}

}  // namespace gjkscope
