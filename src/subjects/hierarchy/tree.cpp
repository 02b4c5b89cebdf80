#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "picture/text_box.hpp"
#include "subjects/growth/subject.hpp"
#include "subjects/hierarchy/shown.hpp"

namespace gjkscope::searches {
namespace {

constexpr double kLeast = 2.2;  // radius of a node
constexpr double kCurrent = 9.0;
constexpr double kSide = 16.0;  // edge of the card to a tree
constexpr double kKey = 56.0;   // height

/// A square that lies on its side.
Polygon square(const Point& center, double radius) {
  const double r = 0.9 * radius;
  return {
      {center + Point(-r, -r), center + Point(r, -r), center + Point(r, r), center + Point(-r, r)}};
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
        depths_(depths_of(tree_)) {
    for (const int depth : depths_) depth_ = std::max(depth_, depth);
    has_more_ = depth_ > kMostDepth;
    depth_ = std::min(depth_, kMostDepth);
    const double across = std::min<double>(tree_[0].count, std::exp2(depth_));
    radius_ = std::clamp(0.42 * area_.size().x() / across, kLeast, kNodeRadius);
  }

  void draw(const Fonts& fonts) {
    for (std::size_t i = 1; i < tree_.size(); ++i) {
      if (is_drawn(i)) link(i);
    }
    for (std::size_t i = 0; i < tree_.size(); ++i) {
      if (is_drawn(i)) node(i);
    }
    scene_.out.marks.push_back(
        {of_x_ ? "shape.x.label" : "shape.y.label",
         Text{{area_.min.x(), area_.min.y() + 6.0}, shown_.name(of_x_), type::kVertex}});
    const std::string count =
        fmt::format("{} {}", tree_[0].count, shown_.has_tiles() ? "tiles" : "segments");
    const Text text{{area_.max.x(), area_.min.y() + 6.0}, count, type::kBody, Align::right};
    if (!meets_a_node(box_of(fonts, text))) scene_.out.marks.push_back({"body.muted", text});
  }

 private:
  [[nodiscard]] bool is_drawn(std::size_t i) const { return depths_[i] <= depth_; }
  /// It stands for what lies below it, too.
  [[nodiscard]] bool is_heap(std::size_t i) const {
    return has_more_ && depths_[i] == depth_ && !tree_[i].is_leaf();
  }
  [[nodiscard]] bool meets_a_node(const Rect& words) const {
    const Point room = Point::Constant(radius_ + type::kBody.size);
    for (std::size_t i = 0; i < tree_.size(); ++i) {
      if (is_drawn(i) && overlap(words, {place(i) - room, place(i) + room})) return true;
    }
    return false;
  }
  [[nodiscard]] Point place(std::size_t i) const {
    const double along = (tree_[i].first + 0.5 * tree_[i].count) / tree_[0].count;
    const double down = depth_ == 0 ? 0.0 : static_cast<double>(depths_[i]) / depth_;
    return area_.min + Point(along * area_.size().x(), down * area_.size().y());
  }
  /// The node that a question at the start asked for.
  [[nodiscard]] bool is_asked_node(std::size_t i) const {
    return of_x_ && scene_.frame.step < 0 && extra_of(scene_.run, scene_.frame) == Extra::node &&
           is_known(scene_.run, scene_.frame, Extra::node) &&
           node_on_path(tree_).node == static_cast<int>(i);
  }
  /// Visited by the search for a meeting, too, where the answer compares both.
  [[nodiscard]] bool is_met(std::size_t i) const {
    if (!shown_.is_answer || !scene_.run.lesson.asks(kAskWider.name)) return false;
    const std::vector<models::SearchStep>& steps = shown_.search.collide.steps;
    return std::any_of(steps.begin(), steps.end(), [&](const models::SearchStep& step) {
      return step.phase == models::SearchPhase::bound &&
             (of_x_ ? step.after.pair.a : step.after.pair.b) == static_cast<int>(i);
    });
  }
  [[nodiscard]] bool is_current(std::size_t i) const {
    return shown_.has_pair() && shown_.node_index(of_x_) == static_cast<int>(i);
  }
  /// True when the node stands for the visited one, which lies below it.
  [[nodiscard]] bool is_current_below(std::size_t i) const {
    if (!is_heap(i) || !shown_.has_pair()) return false;
    const auto current = static_cast<std::size_t>(shown_.node_index(of_x_));
    return i < current && tree_[i].first <= tree_[current].first &&
           tree_[current].first + tree_[current].count <= tree_[i].first + tree_[i].count;
  }
  /// The liveliest state of the nodes that a mark stands for.
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
      const bool holds_current = is_current_below(i);
      const double half = holds_current ? kCurrent : radius_;
      const double below = 2.2 * half;
      scene_.out.marks.push_back({holds_current                  ? "tree.current"
                                  : states_[i] == NodeState::off ? "tree.heap.off"
                                                                 : "tree.heap",
                                  Polygon{{at, at + Point(half, below), at + Point(-half, below)}},
                                  -1, subject});
      if (holds_current) name(at + Point(0.0, below - kCurrent), true);
    }
    Mark mark = node_mark(state(i), at, radius_);
    if (is_current(i)) {
      mark = current_mark(at, shown_.is_cut());
      name(at, tree_[i].is_leaf());
    }
    if (is_asked_node(i)) mark = {"tree.better", Disk{at, kCurrent}};
    if (is_met(i)) scene_.out.marks.push_back(met_mark(at));
    mark.subject = subject;
    scene_.out.marks.push_back(std::move(mark));
  }

  /// The letter of the node that is visited: below one at the foot of the tree, else beside it.
  void name(const Point& at, bool is_below) {
    const bool is_left = at.x() < area_.center().x();
    const Point beside(is_left ? kCurrent + 5.0 : -kCurrent - 5.0, 5.0);
    scene_.out.marks.push_back({of_x_ ? "volume.x.label" : "volume.y.label",
                                Text{at + (is_below ? Point(0.0, kCurrent + 15.0) : beside),
                                     of_x_ ? "a" : "b", type::kVertex,
                                     is_below  ? Align::center
                                     : is_left ? Align::left
                                               : Align::right}});
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
  double radius_ = kNodeRadius;
};

}  // namespace

std::vector<int> depths_of(const std::vector<TreeNode>& tree) {
  std::vector<int> depths(tree.size());
  for (std::size_t i = 1; i < tree.size(); ++i) depths[i] = depths[tree[i].parent] + 1;
  return depths;
}

Mark node_mark(NodeState state, const Point& at, double radius) {
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

Mark current_mark(const Point& at, bool is_cut) {
  if (is_cut) return {"tree.current", square(at, kCurrent)};
  return {"tree.current", Disk{at, kCurrent}};
}

Mark met_mark(const Point& at) { return {"tree.met", Disk{at, kCurrent + 3.0}}; }

void key(SceneBuilder& scene, const Fonts& fonts, std::span<const KeyEntry> entries) {
  constexpr std::size_t kColumns = 3;
  constexpr double kRow = 24.0;
  const Rect& card = scene.map.area();
  const Point start(card.min.x() + kSide + 10.0, card.max.y() - kKey);
  const double width = (card.size().x() - 2.0 * kSide) / kColumns;
  const double rise = 0.5 * fonts.cap_height(type::kText);
  const std::size_t drawn = scene.out.marks.size();
  std::size_t count = 0;
  for (const KeyEntry& entry : entries) {
    const std::string role = entry.mark(start).role;
    const auto end = scene.out.marks.begin() + static_cast<std::ptrdiff_t>(drawn);
    if (std::none_of(scene.out.marks.begin(), end,
                     [&](const Mark& mark) { return mark.role == role; }))
      continue;
    const auto column = static_cast<double>(count % kColumns);
    const std::size_t rows_above = count / kColumns;
    const auto row = static_cast<double>(rows_above);
    const Point at = start + Point(column * width, kRow * (row + 0.5));
    scene.out.marks.push_back(entry.mark(at));
    scene.out.marks.push_back(
        {"legend", Text{at + Point(16.0, rise), std::string(entry.text), type::kText}});
    ++count;
  }
}

std::array<Rect, 2> tree_areas(const Rect& card) {
  constexpr double kTitle = 62.0;
  constexpr double kBetween = 46.0;
  constexpr double kBelow = 38.0;  // a letter under the lowest marks
  const double height = 0.5 * (card.size().y() - kTitle - kBetween - kBelow - kKey);
  const Point corner = card.min + Point(kSide, kTitle);
  const Point size(card.size().x() - 2.0 * kSide, height);
  const Point down(0.0, height + kBetween);
  return {Rect{corner, corner + size}, Rect{corner + down, corner + down + size}};
}

namespace {

/// Visits and measured pairs against the size of tiles, as far as the frame tells them.
Plot plot_of_tiles(const SceneBuilder& scene, const Shown& shown) {
  const std::vector<TileSize>& sizes = shown.search.tile_sizes;
  const double own = trees_of(shown.lesson).tile;
  PlotSeries visits{PlotStyle::first, "tiles: visits", {}};
  PlotSeries measured{PlotStyle::third, "tiles: pairs measured", {}};
  double most = 10.0;
  for (const TileSize& size : sizes) {
    const bool has_measured =
        size.radius <= own || is_known(scene.run, scene.frame, Extra::tile_size);
    visits.points.emplace_back(size.radius, static_cast<double>(size.result.visits));
    most = std::max(most, static_cast<double>(size.result.visits));
    if (has_measured)
      measured.points.emplace_back(size.radius, static_cast<double>(size.result.measured));
  }
  Plot plot;
  plot.x = {sizes.front().radius, sizes.back().radius, true, "largest radius of a tile"};
  plot.series = {std::move(visits), std::move(measured)};
  if (is_known(scene.run, scene.frame, Extra::volume)) {
    const auto level = [&](PlotStyle style, std::string name, const models::SearchResult& result) {
      const auto at = static_cast<double>(result.visits);
      most = std::max(most, at);
      plot.series.push_back(
          {style, std::move(name), {{plot.x.low, at}, {plot.x.high, at}}, PlotJoin::lines, false});
    };
    level(PlotStyle::limit, "boxes: visits", shown.search.of_boxes);
    level(PlotStyle::second, "circles of segments: visits", shown.search.of_circles);
  }
  plot.y = {1.0, std::pow(10.0, std::ceil(std::log10(most))), true, "pairs"};
  plot.current = own;
  return plot;
}

}  // namespace

bool trees(SceneBuilder& scene, const Fonts& fonts) {
  if (scene.view.kind != ViewKind::plot) return false;
  const Shown& shown = shown_in<Shown>(scene);
  if (shown.is_refused()) return true;
  if (shown.is_answer && scene.frame.part >= 0) {
    layers::add_plot(scene, plot_of_tiles(scene, shown), fonts);
    return true;
  }
  const auto [above, below] = tree_areas(scene.map.area());
  TreePicture(scene, shown, true, above).draw(fonts);
  TreePicture(scene, shown, false, below).draw(fonts);
  constexpr std::array<KeyEntry, 7> kEntries = {
      {{[](const Point& at) { return current_mark(at); }, "a and b"},
       {[](const Point& at) { return met_mark(at); }, "collide"},
       {[](const Point& at) { return node_mark(NodeState::waiting, at, kNodeRadius); }, "waits"},
       {[](const Point& at) { return node_mark(NodeState::ahead, at, kNodeRadius); }, "not yet"},
       {[](const Point& at) { return node_mark(NodeState::visited, at, kNodeRadius); }, "visited"},
       {[](const Point& at) { return node_mark(NodeState::cut, at, kNodeRadius); }, "cut"},
       {[](const Point& at) { return node_mark(NodeState::off, at, kNodeRadius); }, "spared"}}};
  key(scene, fonts, kEntries);
  return true;
}

int most_in_heap(const Shown& shown) {
  int most = 0;
  for (const bool of_x : {true, false}) {
    // Halves are rounded up.
    int count = shown.search.tree(of_x)[0].count;
    for (int depth = 0; depth < kMostDepth; ++depth) count = (count + 1) / 2;
    if (count > 1) most = std::max(most, count);
  }
  return most;
}

std::string trees_title(const LessonRun& run) {
  return trees_of(run.lesson).volumes == VolumeKind::boxes ? "The trees of boxes"
                                                           : "The trees of circles";
}

}  // namespace gjkscope::searches
