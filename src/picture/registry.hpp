#pragma once
// All that a lesson can name, in tables: acts, panel blocks, listings and effects.

#include <span>

#include "lesson/vocabulary.hpp"
#include "picture/act.hpp"
#include "picture/blocks/blocks.hpp"
#include "picture/legend.hpp"

namespace gjkscope {

/// What the folder of an algorithm adds to the tables; algorithms/list.def names the folders.
struct ShownAlgorithm {
  std::span<const StagedAct* const> acts;
  std::span<const Block* const> blocks;
  std::span<const Listing* const> listings;
  std::span<const LegendEntry> legend = {};  ///< What its marks mean.
};

/// Each is defined in the folder of its algorithm.
namespace algorithms {
#define GJKSCOPE_ALGORITHM(name) extern const ShownAlgorithm name;
#include "algorithms/list.def"
#undef GJKSCOPE_ALGORITHM
}  // namespace algorithms

/// In the order in which lessons/README.md lists them; those of algorithms come last.
[[nodiscard]] std::span<const StagedAct* const> registered_acts();
[[nodiscard]] std::span<const Block* const> registered_blocks();
[[nodiscard]] std::span<const Listing* const> registered_listings();

/// What the marks of a run's pictures mean: those that all lessons share, and those of the folder
/// that has its act.
[[nodiscard]] std::vector<LegendEntry> legend_entries(const LessonRun& run);

/// What the loader knows of them.
[[nodiscard]] const Vocabulary& vocabulary();

/// The act of a run.
[[nodiscard]] const StagedAct& staged(const LessonRun& run);

/// Runs a lesson with the act that it names, which must be registered.
[[nodiscard]] LessonRun run_lesson(Lesson lesson);

}  // namespace gjkscope
