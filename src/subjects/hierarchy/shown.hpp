#pragma once
// The search over two trees in pictures: what a frame shows of it, and what its tours draw and say.

#include <array>
#include <optional>

#include "picture/block.hpp"
#include "picture/tour.hpp"
#include "run/algorithm_facts.hpp"
#include "subjects/hierarchy/lesson_trace.hpp"
#include "subjects/hierarchy/table.hpp"

namespace gjkscope::searches {

inline constexpr AskInfo kAskDescend{"descend", "whether the search descends or cuts", "at visit"};
inline constexpr AskInfo kAskHalf{
    "half", "which half of a volume is cut, or for a distance visited first", "at visit"};
inline constexpr AskInfo kAskTable{
    "table", "whether two tiles are measured or their segments are in the table", "at visit"};
inline constexpr AskInfo kAskWin{"win", "whether a pair of volumes is too far apart to matter",
                                 "at visit"};
inline constexpr AskInfo kAskPieces{
    "cut-to-pieces", "which of the shapes can be cut into convex pieces", "at position"};
inline constexpr AskInfo kAskPairs{"all-pairs", "how many pairs of segments there are",
                                   "at position"};
inline constexpr AskInfo kAskNode{"node", "which node of the tree has a volume", "at position"};
inline constexpr AskInfo kAskTiles{"tiles", "how many tiles the longest segment has",
                                   "at position"};
inline constexpr AskInfo kAskSplit{"split", "the line that halves the tiles of a shape",
                                   "at position"};
inline constexpr AskInfo kAskTileSize{
    "tile-size", "how many pairs of segments are measured with larger tiles", "at position"};
inline constexpr AskInfo kAskVolume{
    "volume", "with which volumes the search visits the fewest pairs", "at position"};
inline constexpr AskInfo kAskFirstLeaf{
    "first-leaf", "whether a pair of volumes can be cut before segments are measured", "at visit"};
inline constexpr AskInfo kAskDearer{
    "dearer", "whether the distance of two boxes takes more operations than whether they meet",
    "at visit"};
inline constexpr AskInfo kAskGap{"gap", "how far apart two circles are", "at visit"};
inline constexpr AskInfo kAskWider{"wider", "how many visits a search for a meeting takes",
                                   "at position"};

/// Frames besides the steps, each where a lesson asks what it answers: at the start the shape that
/// can be cut into pieces, all pairs of segments, a node and its volume, the tiles of a segment,
/// the halves of all tiles; at the answer sizes of tiles, and volumes, against visits.
enum class Extra : std::uint8_t { pieces, pairs, node, tiles, split, tile_size, volume };
/// The question that each of them answers.
inline constexpr std::array<const AskInfo*, 7> kExtraAsks = {
    &kAskPieces, &kAskPairs, &kAskNode, &kAskTiles, &kAskSplit, &kAskTileSize, &kAskVolume};
/// That of a frame which shows one, or asks for it.
[[nodiscard]] std::optional<Extra> extra_of(const LessonRun& run, const Frame& frame);
/// The frame shows what `extra` answers, or comes after those that do.
[[nodiscard]] bool is_known(const LessonRun& run, const Frame& frame, Extra extra);

/// Searches with more visits are summed up: frames show their milestones alone.
inline constexpr long kMostVisits = 40;

/// The state of a node in a frame.
enum class NodeState : std::uint8_t {
  ahead,    ///< Not reached yet: an ancestor waits or is visited.
  waiting,  ///< Waits in a pair.
  visited,  ///< Was visited, in a pair that was not cut.
  cut,      ///< Was visited in pairs that were cut alone.
  off       ///< Below what was cut: never reached.
};

/// The halves into which a volume was taken apart, each with the other shape's volume.
struct Halves {
  bool of_x = true;
  models::NodePair left;
  models::NodePair right;
  bool is_left_first = true;

  [[nodiscard]] int node(bool is_left) const {
    const models::NodePair& pair = is_left ? left : right;
    return of_x ? pair.a : pair.b;
  }
};

/// The part of the search that a frame shows.
struct Shown {
  Shown(const LessonRun& run, const Frame& frame);

  const Lesson& lesson;
  const TracedSearch& search;
  int over = 0;                              ///< Steps that are over.
  const models::SearchStep* step = nullptr;  ///< The last of them; none at the start.
  const models::SearchState& state;          ///< The state after that step.
  bool is_answer = false;                    ///< The frame after the last step.

  [[nodiscard]] bool is_refused() const { return search.trace.steps.empty(); }
  [[nodiscard]] bool is(models::SearchPhase phase) const {
    return step != nullptr && !is_answer && step->phase == phase;
  }
  [[nodiscard]] bool is_distance() const { return search.options.goal == models::Goal::distance; }
  /// A pair is visited.
  [[nodiscard]] bool has_pair() const {
    return step != nullptr && !is_answer && !is(models::SearchPhase::contain);
  }
  /// A leaf whose segments are as far apart as the candidate that they replace.
  [[nodiscard]] bool is_tie() const {
    const auto& before = (step - 1)->after.candidate;
    return before && models::compare_distances(*before, *state.candidate) == 0;
  }
  [[nodiscard]] bool is_cut() const { return is(models::SearchPhase::bound) && step->record.cut; }
  [[nodiscard]] int node_index(bool of_x) const { return of_x ? state.pair.a : state.pair.b; }
  [[nodiscard]] const TreeNode& node(bool of_x) const {
    return search.tree(of_x)[node_index(of_x)];
  }
  /// Leaves are small circles; several may have the same segment.
  [[nodiscard]] bool has_tiles() const { return trees_of(lesson).volumes == VolumeKind::tiles; }
  [[nodiscard]] bool are_leaves() const { return node(true).is_leaf() && node(false).is_leaf(); }
  [[nodiscard]] const std::string& name(bool of_x) const {
    return (of_x ? lesson.x() : lesson.y()).name;
  }
  /// The halves that the last step made, or the visit before it; nothing for other steps.
  [[nodiscard]] std::optional<Halves> halves() const;
  /// "box", "circle"
  [[nodiscard]] std::string_view volume() const;
  /// "boxes", "circles"
  [[nodiscard]] std::string_view volumes() const;
  /// The states of all nodes of a tree.
  [[nodiscard]] std::vector<NodeState> node_states(bool of_x) const;
};

/// A node of X's tree two levels below the root, and the way to a leaf that leads over it.
struct NodeOnPath {
  int node = 0;
  std::vector<int> path;
};
[[nodiscard]] NodeOnPath node_on_path(const std::vector<TreeNode>& tree);
/// The longest segment of X, and its tiles among the leaves of X's tree.
struct TiledSegment {
  int segment = 0;
  double length = 0.0;
  std::vector<int> leaves;
};
[[nodiscard]] TiledSegment longest_segment(const Shown& shown);
/// The two halves of the tiles below a node, and where lines along both axes would halve them.
struct SplitOfTiles {
  std::array<std::vector<int>, 2> leaves;
  Eigen::Vector2d spread;  ///< That of their centers.
  Eigen::Vector2d middle;
  [[nodiscard]] int axis() const { return spread.y() > spread.x() ? 1 : 0; }
};
[[nodiscard]] SplitOfTiles split_of(const std::vector<TreeNode>& tree, int node);
/// The line that halves them along an axis, as far as it is drawn.
[[nodiscard]] std::pair<Eigen::Vector2d, Eigen::Vector2d> line_of(const SplitOfTiles& split,
                                                                  int axis);
/// "x2x3"
[[nodiscard]] std::string segment_name(const Shown& shown, bool of_x, int index);
/// Operations of two tests of boxes, counted as they run.
struct BoxTests {
  int meet = 0;      ///< Comparisons until it is known that the boxes are apart, or meet.
  int distance = 0;  ///< Operations that their distance takes.
};
[[nodiscard]] BoxTests tests_of(const models::Box& a, const models::Box& b);

/// The step that ends the visit of a pair.
[[nodiscard]] bool ends_visit(const models::SearchStep& step);

// blocks.cpp
extern const Block kCollideCounters;
extern const Block kDistanceCounters;
extern const Block kBoxTests;
extern const Block kTable;
extern const Listing kCollideListing;
extern const Listing kDistanceListing;

// orders.cpp
extern const Tour kOrders;
extern const Block kOrderCounters;

// stage.cpp
void stage(SceneBuilder& scene);
/// The closest points of two segments, a line between them, and its length after `before`.
void shortest_line(SceneBuilder& scene, const TracedSearch& search, const models::Nearest& pair,
                   const std::string& role, const std::string& id, const std::string& before);

// tree.cpp
/// Levels below the root that are drawn node by node; what lies deeper is one mark each.
inline constexpr int kMostDepth = 5;
/// The depth of each node of a tree: levels from the root.
[[nodiscard]] std::vector<int> depths_of(const std::vector<TreeNode>& tree);
/// A view of both trees.
bool trees(SceneBuilder& scene, const Fonts& fonts);
std::string trees_title(const LessonRun& run);
/// For trees that are too deep to be drawn node by node: the most segments in one of the lowest
/// marks; 0 when both trees are drawn as they are.
[[nodiscard]] int most_in_heap(const Shown& shown);
/// How a node looks; `radius` is that of a disk.
[[nodiscard]] Mark node_mark(NodeState state, const Point& at, double radius);
/// The node that is visited.
[[nodiscard]] Mark current_mark(const Point& at, bool is_cut = false);
/// A ring around a node that the search for a meeting visits, too.
[[nodiscard]] Mark met_mark(const Point& at);
inline constexpr double kNodeRadius = 6.0;  ///< The largest.
/// An entry of the key: the meaning of a mark, and a mark like it in a given place.
struct KeyEntry {
  Mark (*mark)(const Point& at) = nullptr;
  std::string_view text;
};
/// Draws the key at the foot of a view's card, in rows of three, two at most: entries whose marks
/// the view has.
void key(SceneBuilder& scene, const Fonts& fonts, std::span<const KeyEntry> entries);
/// The places of the two trees, one above the other, between a view's title and its key.
[[nodiscard]] std::array<Rect, 2> tree_areas(const Rect& card);

// words.cpp
void words(const Story& story, FrameText& text);
void question(const Story& story, FrameText& text);
void values(const Story& story, FrameText& text);

}  // namespace gjkscope::searches
