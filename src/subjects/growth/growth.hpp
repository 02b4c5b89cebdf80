#pragma once
#include <optional>

#include "run/graph.hpp"

namespace gjkscope {

/// Part of the last step, after which runs of other sizes are shown: an index into
/// LessonGrowth::vertices; as many as there are: all sizes; one more: runs that are slow.
[[nodiscard]] std::optional<int> shown_size(const LessonRun& run, const Frame& frame);
/// A frame about slow runs, or one that asks about them.
[[nodiscard]] bool is_slow(const LessonRun& run, const Frame& frame);

/// The cost of GJK as polygons grow: traced runs on pairs of random convex polygons that lie apart,
/// with each number of vertices in the lesson's [growth]. They decide as the lesson's query says,
/// and start from the first vertices, or center to center where the lesson does. The same on every
/// machine: nothing is timed, and the polygons come of sums, products and quotients alone. No
/// shapes of the lesson are part of it.
struct Growth {
  static constexpr std::string_view kName = "growth";
  static constexpr std::string_view kNeeds = "";
  /// Larsen's report of iterations, "on average for any problem size" (1998, slide "GJK - Running
  /// Time").
  static constexpr int kLarsenLeast = 3;
  static constexpr int kLarsenMost = 6;
  /// The first run of a size, as it stands in the difference Y - X.
  struct Example {
    std::vector<Eigen::Vector2d> cloud;    ///< Every difference; empty where they are too many.
    std::vector<Eigen::Vector2d> hull;     ///< Corners of Z, evenly thinned where they are many.
    std::vector<Eigen::Vector2d> touched;  ///< Differences computed, in the order found.
    Eigen::Vector2d closest;               ///< The closest point to the origin.
  };
  /// Polygons of one size. What is counted is an average over the runs.
  struct Sample {
    int vertices = 0;  ///< The vertices of each of the two polygons.
    int runs = 0;
    double iterations = 0.0;
    int most_iterations = 0;        ///< The most of any run.
    double within_tolerance = 0.0;  ///< Iterations until the bounds were that close.
    double support_calls = 0.0;
    double touched_points = 0.0;    ///< Computed ones of the vertices * vertices points y - x.
    double seen_vertices = 0.0;     ///< Dot products: vertices that the support calls looked at.
    double scanned_vertices = 0.0;  ///< The same for plain scans, which look at all vertices.
    Example example;
    bool is_climbed = false;  ///< Large polygons are climbed, small ones are scanned.
  };
  using Value = std::vector<Sample>;
  /// Whether the values are the same, whatever the shapes.
  static bool is_same(const LessonRun& one, const LessonRun& other);
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// Runs that need as many iterations as there are vertices: X is a point, and each iteration finds
/// the vertex of Y that is next, half as far to the other side. Exact, for doubles soon see no
/// difference.
struct SlowGrowth {
  static constexpr std::string_view kName = "slow-growth";
  static constexpr std::string_view kNeeds = "";
  static constexpr int kMost = 30;  ///< Sizes of the lesson up to here.
  static constexpr int kDrawn = 10;
  struct Run {
    int vertices = 0;
    int iterations = 0;
  };
  using Value = std::vector<Run>;
  static EffectKey key(const LessonRun&, const Frame&) { return {-1, -1, -1}; }
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
  /// The run with that many vertices, in the difference.
  static Growth::Example example(int vertices);
};

}  // namespace gjkscope
