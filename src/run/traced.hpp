#pragma once
// The content of a trace, for a lesson in the plane or a case in either dimension.

#include <string>
#include <string_view>
#include <vector>

#include "run/run.hpp"

namespace gjkscope {

struct TracedShape {
  std::string name;
  std::vector<std::string> vertex_names;
  std::vector<Eigen::Vector3d> vertices;  ///< Before they are turned and moved; z = 0 in the plane.
  Placement placement;                    ///< In the first run.
  std::vector<int> outlines = {};         ///< As in LessonShape.
  double radius = 0.0;                    ///< As in LessonShape.
};

struct Traced {
  std::string id;
  std::string title;
  ScalarKind scalar = ScalarKind::double_;
  gjk::Options options;
  TracedShape x;
  TracedShape y;
  std::vector<PositionedRun> runs;
  std::vector<std::string> headings;      ///< One for each run, where there are several.
  const LessonRun* lesson_run = nullptr;  ///< The run that it was made of; none for a case.

  [[nodiscard]] int dimension() const { return runs.front().trace.dimension; }
};

/// The run must outlive the result.
[[nodiscard]] Traced traced(const LessonRun& run);

/// Vertices are called x1, x2, ... and y1, y2, ... D: 2 or 3.
template <int D>
[[nodiscard]] Traced traced(const CaseIn<D>& shapes, std::string_view name, ScalarKind scalar);

}  // namespace gjkscope
