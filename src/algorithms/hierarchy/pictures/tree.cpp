#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/hierarchy/pictures/shown.hpp"

namespace gjkscope::searches {
namespace {

using models::SearchPhase;

/// Levels below the root that are drawn node by node; what lies deeper is one mark each.
constexpr int kMostDepth = 5;

constexpr double kLargest = 6.0;  // radius of a node
constexpr double kLeast = 2.2;
constexpr double kCurrent = 9.0;

/// A square that lies on its side.
Polygon square(const Point& center, double radius) {
  const double r = 0.9 * radius;
  return {
      {center + Point(-r, -r), center + Point(r, -r), center + Point(r, r), center + Point(-r, r)}};
}

/// How a node looks; `radius` is that of a disk.
Mark symbol(NodeState state, const Point& at, double radius) {
  switch (state) {
    case NodeState::ahead:
      return {"tree.ahead", Disk{at, radius}};
    case NodeState::waiting:
      return {"tree.waiting", diamond(at, 1.25 * radius)};
    case NodeState::visited:
      return {"tree.visited", Disk{at, radius}};
    case NodeState::cut:
      return {"tree.cut", square(at, radius)};
    case NodeState::off:
      return {"tree.off", Disk{at, 0.45 * radius}};
  }
  return {};
}

/// One tree, its root above.
class TreePicture {
 public:
  TreePicture(SceneBuilder& scene, const Shown& shown, bool of_x, const Rect& area)
      : scene_(scene),
        shown_(shown),
        of_x_(of_x),
        area_(area),
        tree_(shown.search.tree(of_x)),
        states_(shown.node_states(of_x)),
        depths_(tree_.size()) {
    for (std::size_t i = 1; i < tree_.size(); ++i) {
      depths_[i] = depths_[static_cast<std::size_t>(tree_[i].parent)] + 1;
      depth_ = std::max(depth_, depths_[i]);
    }
    has_more_ = depth_ > kMostDepth;
    depth_ = std::min(depth_, kMostDepth);
    const double across = std::min<double>(tree_[0].count, std::exp2(depth_));
    radius_ = std::clamp(0.42 * area_.size().x() / across, kLeast, kLargest);
  }

  void draw() {
    for (std::size_t i = 1; i < tree_.size(); ++i) {
      if (is_drawn(i)) link(i);
    }
    for (std::size_t i = 0; i < tree_.size(); ++i) {
      if (is_drawn(i)) node(i);
    }
    scene_.out.marks.push_back(
        {of_x_ ? "shape.x.label" : "shape.y.label",
         Text{{area_.min.x(), area_.min.y() + 6.0}, shown_.name(of_x_), type::kVertex}});
    const std::string count = fmt::format("{} segments", tree_[0].count);
    scene_.out.marks.push_back(
        {"body.muted",
         Text{{area_.max.x(), area_.min.y() + 6.0}, count, type::kBody, Align::right}});
  }

 private:
  [[nodiscard]] bool is_drawn(std::size_t i) const { return depths_[i] <= depth_; }
  /// It stands for what lies below it, too.
  [[nodiscard]] bool is_heap(std::size_t i) const {
    return has_more_ && depths_[i] == depth_ && !tree_[i].is_leaf();
  }
  [[nodiscard]] Point place(std::size_t i) const {
    const double along = (tree_[i].first + 0.5 * tree_[i].count) / tree_[0].count;
    const double down = depth_ == 0 ? 0.0 : static_cast<double>(depths_[i]) / depth_;
    return area_.min + Point(along * area_.size().x(), down * area_.size().y());
  }
  [[nodiscard]] bool is_current(std::size_t i) const {
    return shown_.has_pair() && shown_.node_index(of_x_) == static_cast<int>(i);
  }
  /// Of what a mark stands for, the liveliest.
  [[nodiscard]] NodeState state(std::size_t i) const {
    if (!is_heap(i)) return states_[i];
    bool waits = false;
    bool goes_on = false;
    for (std::size_t k = i; k < tree_.size() && !(k > i && depths_[k] <= depths_[i]); ++k) {
      waits = waits || states_[k] == NodeState::waiting;
      goes_on = goes_on || states_[k] == NodeState::visited;
    }
    return waits ? NodeState::waiting : goes_on ? NodeState::visited : states_[i];
  }

  void link(std::size_t i) {
    const Point from = place(static_cast<std::size_t>(tree_[i].parent));
    const bool is_off = states_[i] == NodeState::off;
    scene_.out.marks.push_back(
        {is_off ? "tree.link.off" : "tree.link", Polyline{{from, place(i)}}});
  }

  void node(std::size_t i) {
    const Point at = place(i);
    const int index = static_cast<int>(i);
    const Subject subject = of_x_ ? Subject{Subject::Kind::tree_node, index}
                                  : Subject{Subject::Kind::tree_node, -1, index};
    if (is_heap(i)) {
      const double below = 2.2 * radius_;
      scene_.out.marks.push_back(
          {states_[i] == NodeState::off ? "tree.heap.off" : "tree.heap",
           Polygon{{at, at + Point(radius_, below), at + Point(-radius_, below)}}, -1, subject});
    }
    Mark mark = symbol(state(i), at, radius_);
    if (is_current(i)) {
      mark = shown_.is_cut() ? Mark{"tree.current", square(at, kCurrent)}
                             : Mark{"tree.current", Disk{at, kCurrent}};
      const bool is_left = at.x() < area_.center().x();
      scene_.out.marks.push_back(
          {of_x_ ? "shape.x.label" : "shape.y.label",
           Text{at + Point(is_left ? kCurrent + 5.0 : -kCurrent - 5.0, 5.0), of_x_ ? "a" : "b",
                type::kVertex, is_left ? Align::left : Align::right}});
    }
    mark.subject = subject;
    scene_.out.marks.push_back(std::move(mark));
  }

  SceneBuilder& scene_;
  const Shown& shown_;
  bool of_x_;
  Rect area_;
  const std::vector<TreeNode>& tree_;
  std::vector<NodeState> states_;
  std::vector<int> depths_;
  int depth_ = 0;
  bool has_more_ = false;
  double radius_ = kLargest;
};

/// What the symbols mean, in two rows at the foot of the view.
void key(SceneBuilder& scene, const Fonts& fonts, const Rect& area) {
  struct Entry {
    std::optional<NodeState> state;  ///< None: the node that is visited.
    std::string_view text;
  };
  constexpr std::array<Entry, 6> kEntries = {{{std::nullopt, "now"},
                                              {NodeState::waiting, "waits"},
                                              {NodeState::ahead, "not yet"},
                                              {NodeState::visited, "visited"},
                                              {NodeState::cut, "cut"},
                                              {NodeState::off, "spared"}}};
  constexpr std::size_t kColumns = 3;
  constexpr double kRow = 24.0;
  const double rise = 0.5 * fonts.cap_height(type::kText);
  for (std::size_t i = 0; i < kEntries.size(); ++i) {
    const auto column = static_cast<double>(i % kColumns);
    const auto row = static_cast<double>(i / kColumns);
    const Point at =
        area.min + Point(10.0 + column * area.size().x() / kColumns, kRow * (row + 0.5));
    const auto& [state, text] = kEntries[i];
    scene.out.marks.push_back(state ? symbol(*state, at, kLargest)
                                    : Mark{"tree.current", Disk{at, kCurrent}});
    scene.out.marks.push_back(
        {"legend", Text{at + Point(16.0, rise), std::string(text), type::kText}});
  }
}

}  // namespace

bool trees(SceneBuilder& scene, const Fonts& fonts) {
  if (scene.view.kind != ViewKind::plot) return false;
  const Shown shown(scene.run, scene.frame);
  if (shown.is_refused()) return true;
  constexpr double kTitle = 62.0;
  constexpr double kKey = 56.0;
  constexpr double kSide = 16.0;
  constexpr double kBetween = 46.0;
  const Rect& card = scene.map.area();
  const double height = 0.5 * (card.size().y() - kTitle - kKey - kBetween) - 8.0;
  double top = card.min.y() + kTitle;
  for (const bool of_x : {true, false}) {
    TreePicture(scene, shown, of_x,
                {{card.min.x() + kSide, top}, {card.max.x() - kSide, top + height}})
        .draw();
    top += height + kBetween;
  }
  key(scene, fonts, {{card.min.x() + kSide, card.max.y() - kKey}, card.max - Point(kSide, 0.0)});
  return true;
}

std::string trees_title(const LessonRun& run) {
  return run.lesson.volumes == VolumeKind::boxes ? "The trees of boxes" : "The trees of circles";
}

}  // namespace gjkscope::searches
