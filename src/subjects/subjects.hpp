#pragma once
// The subjects, and all that a lesson can name of them: tours, panel blocks, listings and effects.

#include <vector>

#include "lesson/vocabulary.hpp"
#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/legend.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

/// All that the folder of a subject makes visible.
struct SubjectParts {
  std::vector<const Tour*> tours = {};
  std::vector<const Block*> blocks = {};
  std::vector<const Listing*> listings = {};
  std::vector<const Layer*> layers = {};
  std::vector<const EffectInfo*> effects = {};
  /// Meanings of its marks, in the order of the legend. Those of `run` count in all lessons, others
  /// in lessons with one of the subject's tours, and those of `space` where the lesson is.
  std::vector<LegendEntry> legend = {};
  /// Adds to the words of a step, of any tour.
  void (*adds)(const Story& story, FrameText& text) = nullptr;
};

namespace subjects {
#define GJKSCOPE_SUBJECT(name) extern const SubjectParts name;
#include "subjects/list.def"
#undef GJKSCOPE_SUBJECT
}  // namespace subjects

/// In the order of list.def.
[[nodiscard]] const std::vector<const SubjectParts*>& all_subjects();

/// In the order in which lessons/README.md lists them.
[[nodiscard]] const std::vector<const Tour*>& registered_tours();
[[nodiscard]] const std::vector<const Block*>& registered_blocks();
[[nodiscard]] const std::vector<const Listing*>& registered_listings();
/// In the order in which `explain` lists them.
[[nodiscard]] const std::vector<const EffectInfo*>& registered_effects();
/// From the lowest to the highest.
[[nodiscard]] const std::vector<const Layer*>& registered_layers();

/// True when an effect is the one called `name`, or needs it, directly or through other effects.
[[nodiscard]] bool pulls(const EffectInfo& effect, std::string_view name);

/// Meanings of the marks in a run's pictures.
[[nodiscard]] std::vector<LegendEntry> legend_entries(const LessonRun& run);

/// The names and needs that the loader checks.
[[nodiscard]] const Vocabulary& vocabulary();

/// Runs a lesson with the tour that it names, which must be registered.
[[nodiscard]] LessonRun run_lesson(Lesson lesson);

}  // namespace gjkscope
