#pragma once
// The walk over two trees of bounding volumes (outlines/search.hpp) as the algorithm of a lesson:
// over the segments of two shapes as a run places them, and as JSON and text.

#include <array>
#include <variant>

#include "lesson/algorithm.hpp"
#include "outlines/search.hpp"
#include "run/outline_trace.hpp"
#include "run/run.hpp"

namespace gjkscope {

/// Whichever a lesson asks for (`trees.volumes`).
using Volume = std::variant<models::Box, models::Circle>;
using TreeNode = models::Node<Volume>;

/// The result of a search with tiles of at most this radius.
struct TileSize {
  double radius = 0.0;
  models::SearchResult result;
};

/// The trace of a search with the shapes of one run. A is X, B is Y.
struct TracedSearch {
  models::Model x;
  models::Model y;
  std::vector<TreeNode> tree_x;
  std::vector<TreeNode> tree_y;
  std::vector<int> segments_x;  ///< Those of the items of X's tree, in its order.
  models::SearchOptions options;
  models::SearchTrace trace;       ///< Without steps where shapes are refused.
  models::SearchTrace left_first;  ///< For a distance: the same search, the left child first.
  models::SearchTrace collide;     ///< For a distance: the search for a meeting in the same trees.
  /// For tiles: the same search with tiles of other sizes, the smallest first, and in trees over
  /// whole segments.
  std::vector<TileSize> tile_sizes;
  models::SearchResult of_boxes;
  models::SearchResult of_circles;
  std::optional<Refusal> refusal;

  [[nodiscard]] const models::Model& model(bool of_x) const { return of_x ? x : y; }
  [[nodiscard]] const std::vector<TreeNode>& tree(bool of_x) const {
    return of_x ? tree_x : tree_y;
  }
  /// Pairs of segments that brute force would look at.
  [[nodiscard]] long pairs() const {
    return static_cast<long>(x.segments.size()) * static_cast<long>(y.segments.size());
  }
};

extern const Algorithm kHierarchyCollide;
extern const Algorithm kHierarchyDistance;

/// The search of run `index`; nullptr where the lesson shows another algorithm.
[[nodiscard]] const TracedSearch* search_trace(const LessonRun& run, int index);

/// "descend"
[[nodiscard]] std::string_view name_of(models::SearchPhase phase);
/// "apart"
[[nodiscard]] std::string_view name_of(models::SearchStop stop);

}  // namespace gjkscope
