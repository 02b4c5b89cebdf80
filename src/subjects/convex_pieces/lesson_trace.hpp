#pragma once
// outlines/pieces.hpp on the shapes of a lesson: cut into triangles, merged into convex pieces, and
// the least distance over pairs of pieces.

#include <array>
#include <optional>

#include "outlines/pieces.hpp"
#include "run/outline_trace.hpp"

namespace gjkscope {

/// Closed outlines that do not meet themselves or each other; holes are taken.
extern const Algorithm kConvexPiecesAlgorithm;

enum class PiecesPhase : std::uint8_t { triangle, merge, fewest, pair };

/// One triangle cut off, one diagonal asked about, a shape that fewer pieces would do for, or one
/// pair of pieces.
struct PiecesStep {
  PiecesPhase phase = PiecesPhase::triangle;
  bool of_x = true;  ///< Not of a pair.
  int index = 0;     ///< In Pieces::triangles, Pieces::merges or PiecesAnswer::runs; else 0.
};

class PiecesTrace final : public OutlineTrace {
 public:
  PiecesTrace(std::optional<Refusal> refused, const OutlinesOfRun& outlines);

  [[nodiscard]] int steps() const override { return static_cast<int>(all.size()); }
  [[nodiscard]] StepInfo info(int index) const override;
  [[nodiscard]] double answer(std::string_view name) const override;

  models::Pieces x;
  models::Pieces y;
  models::PiecesAnswer result;
  std::vector<PiecesStep> all;

  /// The fewest pieces there can be, and corners that turn in; of shapes that are no single outline
  /// none.
  std::array<std::vector<std::vector<int>>, 2> fewest;
  std::array<std::vector<int>, 2> turning_in;

  [[nodiscard]] const models::Pieces& of(bool of_x) const { return of_x ? x : y; }
  [[nodiscard]] const std::vector<std::vector<int>>& fewest_of(bool of_x) const {
    return fewest[of_x ? 0 : 1];
  }

 protected:
  [[nodiscard]] fields::Json step_json(const Lesson& lesson, int index) const override;
  [[nodiscard]] fields::Json result_json(const Lesson& lesson) const override;
};

/// "ABCD": the corners of a piece or triangle.
template <class Corners>
[[nodiscard]] std::string corners_name(const LessonShape& shape, const Corners& corners) {
  std::string name;
  for (const int corner : corners) name += shape.vertex_names[corner];
  return name;
}

/// Only for traces of runs of a tour that shows this algorithm.
[[nodiscard]] inline const PiecesTrace& pieces_trace(const AlgorithmTrace& trace) {
  return static_cast<const PiecesTrace&>(trace);
}

}  // namespace gjkscope
