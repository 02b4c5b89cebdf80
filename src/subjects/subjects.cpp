#include "subjects/subjects.hpp"

#include <algorithm>
#include <cassert>

#include "run/run.hpp"
#include "subjects/difference/minkowski.hpp"

namespace gjkscope {
namespace {

/// One kind of part of all subjects.
template <class T>
std::vector<const T*> all(std::vector<const T*> SubjectParts::*kind) {
  std::vector<const T*> out;
  for (const SubjectParts* each : all_subjects())
    out.insert(out.end(), (each->*kind).begin(), (each->*kind).end());
  return out;
}

Vocabulary make_vocabulary() {
  Vocabulary out;
  out.tours = registered_tours();
  for (const Tour* tour : out.tours) {
    if (tour->plot_title != nullptr) out.plots.push_back(tour);
  }
  out.keys = lesson_keys(out.tours);
  for (const Block* block : registered_blocks())
    out.blocks.push_back({.name = block->name,
                          .tour = block->tour,
                          .table = block->table,
                          .takes_listing = block->takes_listing,
                          .shown_of = block->shown_of});
  for (const Listing* listing : registered_listings())
    out.listings.push_back(
        {.name = listing->name, .tour = listing->tour, .shown_of = listing->shown_of});
  for (const EffectInfo* effect : registered_effects()) {
    if (effect->used_by == "view")
      out.effects.push_back({.name = effect->name,
                             .tour = effect->tour,
                             .table = effect->table,
                             .pairs_vertices = pulls(*effect, MinkowskiCloud::kName),
                             .shown_of = effect->shown_of});
  }
  return out;
}

}  // namespace

const std::vector<const SubjectParts*>& all_subjects() {
  static const std::vector<const SubjectParts*> subjects = {
#define GJKSCOPE_SUBJECT(name) &subjects::name,
#include "subjects/list.def"
#undef GJKSCOPE_SUBJECT
  };
  return subjects;
}

const std::vector<const Tour*>& registered_tours() {
  static const auto tours = all(&SubjectParts::tours);
  return tours;
}

const std::vector<const Block*>& registered_blocks() {
  static const auto blocks = all(&SubjectParts::blocks);
  return blocks;
}

const std::vector<const Listing*>& registered_listings() {
  static const auto listings = all(&SubjectParts::listings);
  return listings;
}

const std::vector<const EffectInfo*>& registered_effects() {
  static const auto effects = [] {
    auto list = all(&SubjectParts::effects);
    list.insert(list.begin(), {&effect_infos::kFrameFacts, &effect_infos::kAlgorithmFacts});
    return list;
  }();
  return effects;
}

const std::vector<const Layer*>& registered_layers() {
  static const auto layers = [] {
    auto list = all(&SubjectParts::layers);
    std::stable_sort(list.begin(), list.end(),
                     [](const Layer* a, const Layer* b) { return a->order < b->order; });
    return list;
  }();
  return layers;
}

bool pulls(const EffectInfo& effect, std::string_view name) {
  if (effect.name == name) return true;
  for (std::string_view rest = effect.needs; !rest.empty();) {
    const std::string_view need = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(need.size() + 1, rest.size()));
    const auto& effects = registered_effects();
    if (std::any_of(effects.begin(), effects.end(), [&](const EffectInfo* each) {
          return each->name == need && pulls(*each, name);
        }))
      return true;
  }
  return false;
}

std::vector<LegendEntry> legend_entries(const LessonRun& run) {
  std::vector<LegendEntry> list = subjects::run.legend;
  for (const SubjectParts* subject : all_subjects()) {
    const bool has_tour =
        std::find(subject->tours.begin(), subject->tours.end(), run.tour) != subject->tours.end();
    const bool is_of_space = subject == &subjects::space && run.lesson.dimension == 3;
    if (!has_tour && !is_of_space) continue;
    // A subject may give a mark of GJK a meaning of its own.
    for (const LegendEntry& entry : subject->legend) {
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

LessonRun run_lesson(Lesson lesson) {
  const Tour* tour = vocabulary().tour(lesson.tour);
  assert(tour != nullptr);
  return run_lesson(std::move(lesson), *tour);
}

}  // namespace gjkscope
