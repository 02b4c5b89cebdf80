#include <algorithm>
#include <cmath>
#include <numbers>

#include "outlines/polygon.hpp"
#include "subjects/hierarchy/shown.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::searches {
namespace {

using Eigen::Vector2d;
using models::Box;
using models::Circle;
using models::SearchPhase;
using namespace sizes;

constexpr int kCorners = 64;  // of a circle

Vector2d unit(int corner) {
  const double angle = 2.0 * std::numbers::pi * (corner + 0.5) / kCorners;
  return {std::cos(angle), std::sin(angle)};
}

/// All points within `more` of the volume, as a polygon.
std::vector<Vector2d> outline_of(const Volume& volume, double more = 0.0) {
  std::vector<Vector2d> out;
  if (const Circle* circle = std::get_if<Circle>(&volume)) {
    for (int i = 0; i < kCorners; ++i)
      out.push_back(circle->center + (circle->radius + more) * unit(i));
    return out;
  }
  const Box& box = std::get<Box>(volume);
  if (more == 0.0)
    return {box.low, {box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()}};
  for (int i = 0; i < kCorners; ++i) {
    const Vector2d towards = unit(i);
    const Vector2d corner = (towards.array() > 0.0).select(box.high, box.low);
    out.push_back(corner + more * towards);
  }
  return out;
}

/// The ends of the shortest way between two volumes that are apart.
std::pair<Vector2d, Vector2d> gap_of(const Volume& a, const Volume& b) {
  if (const Circle* circle = std::get_if<Circle>(&a)) {
    const Circle& other = std::get<Circle>(b);
    const Vector2d difference = (other.center - circle->center).normalized();
    return {circle->center + circle->radius * difference, other.center - other.radius * difference};
  }
  const Box& p = std::get<Box>(a);
  const Box& q = std::get<Box>(b);
  // Along an axis on which the boxes overlap, the ends are in the middle of the part they share.
  const Vector2d low = p.low.cwiseMax(q.low);
  const Vector2d high = p.high.cwiseMin(q.high);
  const Vector2d middle = 0.5 * (low + high);
  const auto within = [&](const Box& box) {
    return Vector2d(middle.cwiseMax(box.low).cwiseMin(box.high));
  };
  return {within(p), within(q)};
}

class Stage {
 public:
  explicit Stage(SceneBuilder& scene) : scene_(scene), shown_(shown_in<Shown>(scene)) {}

  void draw() {
    if (shown_.is_refused()) return;
    if (shown_.is_distance() && shown_.has_pair() && shown_.state.candidate) below_ = band();
    quiet_volumes();
    if (shown_.has_tiles()) tiles();
    if (scene_.frame.step < 0 || shown_.is_answer) extra();
    if (shown_.is_cut()) hatch();
    // All of it lies below the shapes, which can be taken hold of wherever they are.
    scene_.out.marks.insert(scene_.out.marks.begin(), below_.begin(), below_.end());
    if (shown_.has_pair()) pair();
    if (shown_.is(SearchPhase::descend)) children();
    if (shown_.halves() &&
        scene_.run.lesson.asks(kAskHalf.name,
                               shown_.state.visits + (shown_.is(SearchPhase::descend) ? 1 : 0)))
      halves(*shown_.halves());
    if (shown_.is(SearchPhase::leaf)) segments();
    candidate();
  }

 private:
  [[nodiscard]] std::vector<Point> mapped(const std::vector<Vector2d>& points) const {
    std::vector<Point> out;
    for (const Vector2d& point : points) out.push_back(scene_.at(point));
    return out;
  }
  [[nodiscard]] const Volume& volume_of(bool of_x, int node) const {
    return shown_.search.tree(of_x)[node].volume;
  }
  [[nodiscard]] static Subject subject(bool of_x, int node) {
    return of_x ? Subject{Subject::Kind::tree_node, node}
                : Subject{Subject::Kind::tree_node, -1, node};
  }

  /// The points that are nearer to `a` than the candidate's segments to each other.
  [[nodiscard]] std::vector<Mark> band() const {
    const double delta = shown_.state.candidate->high;
    return {{"volume.band", Polygon{mapped(outline_of(shown_.node(true).volume, delta))}}};
  }

  /// Not to be seen, but lit up where a node is pointed at, or where the hand is on them. Those
  /// that the picture of the tree sums up have none.
  void quiet_volumes() {
    for (const bool of_x : {true, false}) {
      const std::vector<TreeNode>& tree = shown_.search.tree(of_x);
      const std::vector<int> depths = depths_of(tree);
      for (int i = 0; i < static_cast<int>(tree.size()); ++i) {
        if (depths[i] > kMostDepth) continue;
        below_.push_back(
            {"region.hidden", Polygon{mapped(outline_of(tree[i].volume))}, -1, subject(of_x, i)});
      }
    }
  }

  [[nodiscard]] bool shows(Extra extra) const {
    return extra_of(scene_.run, scene_.frame) == extra;
  }
  [[nodiscard]] bool is_known(Extra extra) const {
    return searches::is_known(scene_.run, scene_.frame, extra);
  }

  /// The leaves of both trees, unless their number is asked for.
  void tiles() {
    if (scene_.run.lesson.asks(kAskTiles.name) && !is_known(Extra::tiles)) return;
    for (const bool of_x : {true, false}) {
      for (const TreeNode& node : shown_.search.tree(of_x)) {
        if (node.is_leaf())
          below_.push_back({"volume.tile", Polyline{mapped(outline_of(node.volume)), true}});
      }
    }
  }

  void circle(const std::string& role, int leaf) {
    scene_.add(role, Polyline{mapped(outline_of(volume_of(true, leaf))), true});
  }

  void extra() {
    if (shows(Extra::node)) {
      const int node = node_on_path(shown_.search.tree_x).node;
      const TreeNode& bounding = shown_.search.tree_x[node];
      for (int i = bounding.first; i < bounding.first + bounding.count; ++i) {
        const models::Segment& s = shown_.search.x.segments[shown_.search.segments_x[i]];
        scene_.line("volume.bounded", scene_.at(s.a), scene_.at(s.b));
      }
      volume(true, node, "volume.x");
    }
    if (shows(Extra::tiles)) {
      const TiledSegment longest = longest_segment(shown_);
      const models::Segment& s = shown_.search.x.segments[longest.segment];
      scene_.line("volume.bounded", scene_.at(s.a), scene_.at(s.b));
      if (!is_known(Extra::tiles)) return;
      for (const int leaf : longest.leaves) circle("volume.tile.marked", leaf);
    }
    if (shows(Extra::split)) split();
  }

  /// All tiles in one circle, and the lines that could halve them; then both halves.
  void split() {
    const std::vector<TreeNode>& tree = shown_.search.tree_x;
    const SplitOfTiles split = split_of(tree, 0);
    volume(true, 0, "volume.x");
    for (const int axis : {0, 1}) {
      if (is_known(Extra::split) && axis != split.axis()) continue;
      const auto [from, to] = line_of(split, axis);
      scene_.line("volume.split", scene_.at(from), scene_.at(to));
      if (is_known(Extra::split)) continue;
      scene_.out.moving_labels.push_back(
          scene_.label(axis == 0 ? "split:upright" : "split:level", axis == 0 ? "upright" : "level",
                       "volume.x.label", type::kSmallVertex, scene_.at(to), 0.0,
                       axis == 0 ? Point(1.0, 0.0) : Point(0.0, -1.0)));
    }
    if (!is_known(Extra::split)) return;
    for (const int leaf : split.leaves[0]) circle("volume.half", leaf);
    for (const int child : {tree[0].left, tree[0].right}) volume(true, child, "volume.child");
  }

  /// The centers and radii of the circles that are visited.
  void centers() {
    const Circle& a = std::get<Circle>(shown_.node(true).volume);
    const Circle& b = std::get<Circle>(shown_.node(false).volume);
    scene_.line("volume.centers", scene_.at(a.center), scene_.at(b.center));
    for (const Circle* each : {&a, &b})
      scene_.disk("volume.centers", scene_.at(each->center), kClosestRadius);
  }

  void hatch() {
    for (const bool of_x : {true, false}) {
      const std::size_t before = scene_.out.marks.size();
      scene_.hatched("region.hatch", mapped(outline_of(shown_.node(of_x).volume)));
      const auto first = scene_.out.marks.begin() + static_cast<std::ptrdiff_t>(before);
      below_.insert(below_.end(), first, scene_.out.marks.end());
      scene_.out.marks.erase(first, scene_.out.marks.end());
    }
  }

  void volume(bool of_x, int node, const std::string& role) {
    const std::vector<Point> corners = mapped(outline_of(volume_of(of_x, node)));
    // As a line: what lies inside stays to be taken hold of.
    scene_.add(role, Polyline{corners, true});
    scene_.outline(corners);
  }

  void pair() {
    for (const bool of_x : {true, false}) {
      const std::vector<Point> corners = mapped(outline_of(shown_.node(of_x).volume));
      volume(of_x, shown_.node_index(of_x), of_x ? "volume.x" : "volume.y");
      const Point middle = 0.5 * (corners[0] + corners[corners.size() / 2]);
      LabelRequest label = scene_.label(of_x ? "a" : "b", of_x ? "a" : "b",
                                        of_x ? "volume.x.label" : "volume.y.label", type::kVertex,
                                        corners[0], 0.0, corners[0] - middle);
      label.other_anchors = {corners.begin() + 1, corners.end()};
      scene_.out.moving_labels.push_back(std::move(label));
    }
    if (std::holds_alternative<Circle>(shown_.node(true).volume) &&
        scene_.run.lesson.asks(kAskGap.name, shown_.state.visits))
      centers();
    if (shown_.is_cut()) gap("gap", shown_.state.pair);
  }

  void gap(const std::string& id, const models::NodePair& pair) {
    const auto [of_x, of_y] = gap_of(volume_of(true, pair.a), volume_of(false, pair.b));
    scene_.line("gap.exact", scene_.at(of_x), scene_.at(of_y));
    scene_.length_label(id, pair.bound, scene_.at(of_x), scene_.at(of_y));
  }

  [[nodiscard]] Point middle_of(const Halves& halves, bool is_left) const {
    return centroid(mapped(outline_of(volume_of(halves.of_x, halves.node(is_left)))));
  }
  /// The names of two halves, and their distances once frames have shown them.
  void halves(const Halves& halves) {
    for (const bool is_left : {true, false}) {
      const models::NodePair& pair = is_left ? halves.left : halves.right;
      const std::string name = is_left ? "left" : "right";
      std::vector<Point> corners = mapped(outline_of(volume_of(halves.of_x, halves.node(is_left))));
      // On the side where the other half is not.
      const Point away = middle_of(halves, is_left) - middle_of(halves, !is_left);
      std::sort(corners.begin(), corners.end(),
                [&](const Point& a, const Point& b) { return a.dot(away) > b.dot(away); });
      LabelRequest label =
          scene_.label("half:" + name, name, halves.of_x ? "volume.x.label" : "volume.y.label",
                       type::kSmallVertex, corners[0], 0.0, away);
      label.other_anchors = {corners.begin() + 1,
                             corners.begin() + static_cast<std::ptrdiff_t>(corners.size() / 2)};
      scene_.out.moving_labels.push_back(std::move(label));
      if (shown_.is(SearchPhase::descend)) continue;
      volume(halves.of_x, halves.node(is_left), "volume.child");
      if (pair.bound > 0.0) gap("gap:" + name, pair);
    }
  }

  void children() {
    const bool of_x = !shown_.step->record.takes_b_apart;
    for (const int child : {shown_.node(of_x).left, shown_.node(of_x).right})
      volume(of_x, child, "volume.child");
  }

  void segment(bool of_x, int index) {
    const models::Segment& s = shown_.search.model(of_x).segments[index];
    scene_.line("volume.segment", scene_.at(s.a), scene_.at(s.b));
  }
  void segments() {
    segment(true, shown_.step->record.segments.first);
    segment(false, shown_.step->record.segments.second);
    if (shown_.step->record.measured && !shown_.step->record.better)
      shortest_line(scene_, shown_.search, *shown_.step->record.measured, "gap.answer", "measured",
                    "");
  }

  void candidate() {
    const bool ends = shown_.state.stop == models::SearchStop::meet;
    if (!shown_.state.candidate || (!shown_.is_distance() && !ends)) return;
    shortest_line(scene_, shown_.search, *shown_.state.candidate, "closest.line", "candidate",
                  shown_.is_answer ? "" : "δ = ");
  }

  SceneBuilder& scene_;
  const Shown& shown_;
  std::vector<Mark> below_;
};

}  // namespace

void shortest_line(SceneBuilder& scene, const TracedSearch& search, const models::Nearest& pair,
                   const std::string& role, const std::string& id, const std::string& before) {
  const models::Answer closest = models::answer_of(pair, search.x, search.y);
  const Point x = scene.at(closest.a);
  const Point y = scene.at(closest.b);
  scene.line(role, x, y);
  for (const Point& point : {x, y}) scene.disk("closest", point, kClosestRadius);
  if ((y - x).norm() < 1.0) return;
  scene.out.moving_labels.push_back(
      scene.label(id, before + Numbers(scene.run.lesson)(closest.distance), "distance.label",
                  type::kSmallVertex, 0.5 * (x + y), 2.0, Point(x.y() - y.y(), y.x() - x.x())));
}

std::pair<Vector2d, Vector2d> line_of(const SplitOfTiles& split, int axis) {
  constexpr double kBeyond = 0.3;  // of the spread, to both sides
  const int other = 1 - axis;
  Vector2d from = split.middle;
  const double half = (0.5 + kBeyond) * split.spread[other];
  Vector2d to = from;
  from[other] -= half;
  to[other] += half;
  return {from, to};
}

void stage(SceneBuilder& scene) { Stage(scene).draw(); }

}  // namespace gjkscope::searches
