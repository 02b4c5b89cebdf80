#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gjk/vector.hpp"
#include "subjects/hierarchy/shown.hpp"

namespace gjkscope::searches {
namespace {

using models::SearchPhase;
using models::SearchStop;

std::string counted(long count, std::string_view what) {
  return fmt::format("{} {}{}", count == 1 ? "one" : grouped(static_cast<double>(count)), what,
                     count == 1 ? "" : "s");
}

class Telling {
 public:
  Telling(const Story& story, FrameText& text)
      : story_(story), text_(text), shown_(shown_in<Shown>(story)) {}

  void tell() {
    if (shown_.is_refused()) return refused();
    if (story_.frame.part >= 0) return extra(static_cast<Extra>(story_.frame.part));
    if (shown_.is_answer) return answer();
    if (shown_.step == nullptr) return start();
    switch (shown_.step->phase) {
      case SearchPhase::visit:
        return visit();
      case SearchPhase::bound:
        cut();
        break;
      case SearchPhase::leaf:
        leaf();
        break;
      case SearchPhase::descend:
        descend();
        break;
      case SearchPhase::contain:
        return contain();
    }
    visits_before();
  }

 private:
  [[nodiscard]] const std::string& x() const { return shown_.name(true); }
  [[nodiscard]] const std::string& y() const { return shown_.name(false); }
  [[nodiscard]] std::string delta() const {
    return "δ = " + story_.numbers(shown_.state.candidate->high);
  }
  [[nodiscard]] std::string bound() const { return story_.numbers(shown_.state.pair.bound); }
  [[nodiscard]] long pairs_below() const {
    return static_cast<long>(shown_.node(true).count) * shown_.node(false).count;
  }

  /// Visits since the last frame that have none, because they ended as this one does.
  void visits_before() {
    if (shown_.search.trace.result.visits > kMostVisits) return;
    long trace = 0;
    for (const Frame& frame : story_.run.frames) {
      if (frame.run == story_.frame.run && frame.step < story_.frame.step)
        trace = Shown(story_.run, frame).state.visits;
    }
    const long along = shown_.state.visits - trace - 1;
    if (along == 1) text_.detail += " The visit before it ended the same way.";
    if (along > 1)
      text_.detail += fmt::format(" The {} visits before it ended the same way.", along);
  }

  void refused() {
    text_.caption = fmt::format("The search does not take {}.",
                                words_of(*shown_.search.refusal, shown_.lesson));
  }

  void start() {
    text_.caption = fmt::format(
        "Each shape has a tree of {}: the root holds all segments, a leaf one.", shown_.volumes());
    if (shown_.has_tiles())
      text_.caption =
          fmt::format("Small circles tile the segments. A tree bounds these {} and {} tiles.",
                      shown_.search.tree(true)[0].count, shown_.search.tree(false)[0].count);
    text_.detail = "The pair of the two roots waits. ";
    if (!shown_.lesson.asks(kAskPairs.name)) text_.detail = pairs() + " " + text_.detail;
    if (shown_.search.options.remembered)
      text_.detail += fmt::format("The last pair gives a candidate at once: {}.", delta());
    else
      text_.detail += "Next: visit it.";
    const int most = most_in_heap(shown_);
    if (most > 0) text_.detail += fmt::format(" A triangle stands for up to {} segments.", most);
  }

  /// "12 · 10 = 120 pairs of segments."
  [[nodiscard]] std::string pairs() const {
    return fmt::format("{} · {} = {} pairs of segments.", shown_.search.x.segments.size(),
                       shown_.search.y.segments.size(),
                       grouped(static_cast<double>(shown_.search.pairs())));
  }

  void extra(Extra extra) {
    switch (extra) {
      case Extra::pieces:
        return pieces();
      case Extra::pairs:
        text_.caption = pairs() + " Brute force tests them all.";
        text_.detail = "Trees are to spare most of these tests.";
        return;
      case Extra::node:
        return node();
      case Extra::tiles:
        return tiles();
      case Extra::split:
        return split();
      case Extra::tile_size:
        return tile_sizes();
      case Extra::volume:
        return of_volumes();
    }
  }

  void pieces() {
    std::string can;
    for (const bool of_x : {true, false}) {
      const models::Flaw flaw =
          models::check(shown_.search.model(of_x).outlines, models::Needs::simple);
      if (flaw.fault == models::Fault::none)
        can += fmt::format(" {} has one, with an inside to cut.", shown_.name(of_x));
      else
        text_.caption = fmt::format("{} has no such outline: {}.", shown_.name(of_x),
                                    models::name_of(flaw.fault));
    }
    text_.caption += can;
    text_.detail =
        "A list of triangles need not bound an inside. Trees take its segments all the same.";
  }

  void node() {
    const std::vector<TreeNode>& tree = shown_.search.tree_x;
    const TreeNode& node = tree[node_on_path(tree).node];
    text_.caption = fmt::format("The node has {} leaves below it: its {} bounds these {} segments.",
                                node.count, shown_.volume(), node.count);
    text_.detail = fmt::format("Its children bound {} and {} of them, each with a smaller {}.",
                               tree[node.left].count, tree[node.right].count, shown_.volume());
  }

  void tiles() {
    const TiledSegment longest = longest_segment(shown_);
    const double tile = trees_of(shown_.lesson).tile;
    text_.caption = fmt::format("Edge {} is {} long: {} tiles of at most {} cover it.",
                                segment_name(shown_, true, longest.segment),
                                story_.numbers(longest.length), longest.leaves.size(), tile);
    text_.detail =
        fmt::format("{} and {} have {} and {} tiles. Many leaves point to one segment.", x(), y(),
                    shown_.search.tree(true)[0].count, shown_.search.tree(false)[0].count);
  }

  void split() {
    const SplitOfTiles split = split_of(shown_.search.tree_x, 0);
    text_.caption = fmt::format("{} and {} tiles: halves, and a circle around each.",
                                split.leaves[0].size(), split.leaves[1].size());
    text_.detail = "Each half is halved the same way, down to single tiles: a tree from the top.";
  }

  /// The size of the lesson, and the largest.
  void tile_sizes() {
    const std::vector<TileSize>& sizes = shown_.search.tile_sizes;
    const models::SearchResult& own = shown_.search.trace.result;
    const TileSize& large = sizes.back();
    const TileSize& small = sizes.front();
    text_.caption =
        fmt::format("Tiles of {}: {} visits, but {} pairs measured, in place of {}.", large.radius,
                    large.result.visits, large.result.measured, own.measured);
    text_.detail =
        fmt::format("Tiles of {} take {} visits. Larsen: tiling may be the most critical factor.",
                    small.radius, small.result.visits);
  }

  void of_volumes() {
    const models::SearchResult& own = shown_.search.trace.result;
    const models::SearchResult& boxes = shown_.search.of_boxes;
    const models::SearchResult& circles = shown_.search.of_circles;
    text_.caption =
        fmt::format("Visits: {} with boxes, {} with circles of segments, {} with tiles.",
                    boxes.visits, circles.visits, own.visits);
    text_.detail = fmt::format(
        "Measured are {}, {} and {} pairs. Larsen says of 1998: Quinlan's code is the fastest, on "
        "triangles in space.",
        boxes.measured, circles.measured, own.measured);
  }

  [[nodiscard]] std::string_view content() const { return shown_.has_tiles() ? "tile" : "segment"; }
  /// "a holds 6 segments of X, b one segment of Y."
  [[nodiscard]] std::string contents() const {
    return fmt::format("a holds {} of {}, b {} of {}. ",
                       counted(shown_.node(true).count, content()), x(),
                       counted(shown_.node(false).count, content()), y());
  }
  /// "Visit 3: boxes a and b"
  [[nodiscard]] std::string visited() const {
    return fmt::format("Visit {}: {} a and b", shown_.state.visits, shown_.volumes());
  }

  void visit() {
    text_.caption = fmt::format("Visit {}: the pair of {} a of {} and b of {}.",
                                shown_.state.visits, shown_.volumes(), x(), y());
    const std::optional<Halves> halves = shown_.halves();
    if (halves && shown_.lesson.asks(kAskHalf.name, shown_.state.visits))
      text_.caption = fmt::format("Visit {}: the {} half comes first. From here on it is {} {}.",
                                  shown_.state.visits, halves->is_left_first ? "left" : "right",
                                  shown_.volume(), halves->of_x ? "a" : "b");
    text_.detail = contents();
    if (!shown_.is_distance())
      text_.detail += fmt::format("Next: do the {} meet?", shown_.volumes());
    else if (shown_.lesson.asks(kAskFirstLeaf.name, shown_.state.visits))
      text_.detail += fmt::format("Next: how far are the {} apart?", shown_.volumes());
    else if (!shown_.state.candidate)
      text_.detail += "No segments are measured yet, so nothing can be cut.";
    else
      text_.detail += fmt::format("The band around a is δ wide. Next: does b reach it?");
  }

  void cut() {
    const bool is_one = pairs_below() == 1;
    const std::string spared =
        is_one ? fmt::format("The pair of {}s is not tested.", content())
               : fmt::format("{} pairs of {}s are spared: {} in a times {} in b.",
                             grouped(static_cast<double>(pairs_below())), content(),
                             shown_.node(true).count, shown_.node(false).count);
    if (shown_.is_distance()) {
      text_.caption =
          fmt::format("{} are {} apart, farther than {}: cut.", visited(), bound(), delta());
      text_.detail = "No segment in a is closer to one in b than δ. " + spared;
    } else {
      text_.caption = fmt::format("{} are {} apart: cut.", visited(), bound());
      text_.detail = "No segment in a meets one in b. " + spared;
    }
  }

  void looked_up() {
    text_.caption =
        fmt::format("Visit {}: both are tiles. Their segments are in the table: look it up.",
                    shown_.state.visits);
    text_.detail = fmt::format("Other tiles of the same two segments came earlier. {} so far.",
                               capitalized(counted(shown_.state.hits, "hit")));
  }

  void leaf() {
    const models::SearchRecord& record = shown_.step->record;
    if (record.hit) return looked_up();
    const std::string length = story_.numbers(record.measured->high);
    if (record.measured->meet) {
      text_.caption = fmt::format("Visit {}: both are leaves, and their segments meet: stop.",
                                  shown_.state.visits);
      text_.detail = "The shapes overlap. What still waits does not matter.";
    } else if (!shown_.is_distance()) {
      text_.caption = fmt::format("Visit {}: both are leaves. Their segments do not meet.",
                                  shown_.state.visits);
      text_.detail =
          fmt::format("The {} meet, the segments do not: a {} is larger than its segment.",
                      shown_.volumes(), shown_.volume());
    } else if (record.better && shown_.is_tie()) {
      text_.caption = fmt::format("Visit {}: both are leaves. Their segments are {} apart, too.",
                                  shown_.state.visits, length);
      text_.detail =
          "They share the closest vertex. Among equally close pairs the first in the outlines is "
          "taken.";
    } else if (record.better) {
      text_.caption =
          fmt::format("Visit {}: both are leaves. Their segments are {} apart: that is δ now.",
                      shown_.state.visits, length);
      text_.detail = "They are the candidate. From now on pairs that are farther apart are cut.";
    } else {
      text_.caption =
          fmt::format("Visit {}: both are leaves. Their segments are {} apart, not less than {}.",
                      shown_.state.visits, length, delta());
      text_.detail = fmt::format(
          "The {} were near enough, the segments are not. The candidate stays.", shown_.volumes());
    }
  }

  void descend() {
    const bool takes_b = shown_.step->record.takes_b_apart;
    if (!shown_.is_distance()) {
      text_.caption = fmt::format("{} meet: descend.", visited());
    } else if (!shown_.state.candidate) {
      text_.caption =
          fmt::format("{} are {} apart, and δ is still ∞: descend.", visited(), bound());
    } else {
      text_.caption =
          fmt::format("{} are {} apart, not more than {}: descend.", visited(), bound(), delta());
    }
    text_.detail = contents() + fmt::format("Each half of {} waits with {}, the {} one first.",
                                            takes_b ? "b" : "a", takes_b ? "a" : "b",
                                            shown_.is_distance() ? "nearer" : "left");
  }

  void contain() {
    text_.caption = shown_.is_distance() ? "Nothing waits: no pair is nearer than the candidate."
                                         : "Nothing waits: no two segments meet.";
    text_.detail = shown_.state.inside ? "But one shape lies inside the other, so they overlap."
                                       : "One shape could still lie inside the other. A vertex of "
                                         "each is tested: neither does.";
  }

  void answer() {
    const models::SearchResult& result = shown_.search.trace.result;
    const std::string cost =
        fmt::format("{} and {} of {} pairs of segments", counted(result.visits, "visit"),
                    grouped(static_cast<double>(result.measured)),
                    grouped(static_cast<double>(shown_.search.pairs())));
    if (result.stop != SearchStop::apart) {
      text_.caption = fmt::format("{} and {} overlap: known after {}.", x(), y(), cost);
      if (result.stop == SearchStop::contained)
        text_.detail = "No segments meet: one shape lies inside the other.";
      return;
    }
    if (!shown_.is_distance()) {
      text_.caption = fmt::format("{} and {} do not meet: known after {}.", x(), y(), cost);
      text_.detail = "Each cut spared all pairs of segments below it.";
      return;
    }
    text_.caption =
        fmt::format("The distance is {}: {}.", story_.numbers(result.answer.distance), cost);
    if (shown_.has_tiles()) {
      text_.detail =
          fmt::format("{} {} looked up in place of being measured again.",
                      capitalized(counted(result.hits, "pair")), result.hits == 1 ? "was" : "were");
      return;
    }
    const models::SearchResult& other = shown_.search.left_first.result;
    text_.detail = fmt::format("With the left child always first: {} and {}.",
                               counted(other.visits, "visit"), counted(other.measured, "pair"));
    if (shown_.lesson.asks(kAskWider.name))
      text_.detail += fmt::format(" Whether they meet is known after {}: the ringed nodes.",
                                  counted(shown_.search.collide.result.visits, "visit"));
  }

  const Story& story_;
  FrameText& text_;
  const Shown& shown_;
};

}  // namespace

void words(const Story& story, FrameText& text) { Telling(story, text).tell(); }

namespace {

void ask_about_halves(const Story& story, const Shown& shown, FrameText& text) {
  const Halves halves = *shown.halves();
  const std::string_view whole = halves.of_x ? "a" : "b";
  const std::string_view other = halves.of_x ? "b" : "a";
  FrameQuestion& asked = text.question.emplace();
  asked.ask = kAskHalf.name;
  for (const bool is_left : {true, false}) {
    asked.choices.push_back(fmt::format("{} half of {}", is_left ? "left" : "right", whole));
    const int node = halves.node(is_left);
    asked.subjects.push_back(
        {Subject::Kind::tree_node, halves.of_x ? node : -1, halves.of_x ? -1 : node});
  }
  const auto away = [&](double bound) {
    return bound > 0.0 ? fmt::format("is {} from {}", story.numbers(bound), other)
                       : fmt::format("meets {}", other);
  };
  asked.refuted = fmt::format("The left half {}, the right half {}.", away(halves.left.bound),
                              away(halves.right.bound));
  if (shown.is_distance()) {
    asked.answer = asked.choices[halves.is_left_first ? 0 : 1];
    text.caption = fmt::format(
        "Question: which half of {} is nearer to {}, so that it is visited first? Point at it.",
        whole, other);
    return;
  }
  asked.choices.insert(asked.choices.end(), {"both", "neither"});
  asked.subjects.resize(asked.choices.size());
  const bool cuts_left = halves.left.bound > 0.0;
  const bool cuts_right = halves.right.bound > 0.0;
  asked.answer = asked.choices[cuts_left ? (cuts_right ? 2 : 0) : cuts_right ? 1 : 3];
  text.caption = fmt::format(
      "Question: which half of {} does not meet {}, so that it is cut? Point at it.", whole, other);
}

}  // namespace

namespace {

void ask_for_pieces(const Shown& shown, FrameText& text, FrameQuestion& asked) {
  const auto is_simple = [&](bool of_x) {
    return models::check(shown.search.model(of_x).outlines, models::Needs::simple).fault ==
           models::Fault::none;
  };
  asked.choices = {shown.name(true), shown.name(false), "both", "neither"};
  asked.subjects = {{Subject::Kind::shape_x}, {Subject::Kind::shape_y}, {}, {}};
  asked.answer = asked.choices[is_simple(true)    ? (is_simple(false) ? 2 : 0)
                               : is_simple(false) ? 1
                                                  : 3];
  asked.refuted = "Cutting takes closed outlines that do not meet.";
  text.caption =
      "Question: which of the two has one outline that does not cross itself, to be cut into "
      "convex "
      "pieces? Point at it.";
}

void ask_for_pairs(const Shown& shown, FrameText& text, FrameQuestion& asked) {
  const auto x = static_cast<long>(shown.search.x.segments.size());
  const auto y = static_cast<long>(shown.search.y.segments.size());
  for (const long count : {x + y, x * y / 2, x * y})
    asked.choices.push_back(grouped(static_cast<double>(count)));
  asked.answer = asked.choices.back();
  asked.refuted =
      fmt::format("{} is the number of segments: each of {} has a pair with each of {}.",
                  asked.choices.front(), shown.name(true), shown.name(false));
  text.caption =
      fmt::format("Question: {} has {} segments, {} has {}. How many pairs does brute force test?",
                  shown.name(true), x, shown.name(false), y);
}

void ask_for_node(const Shown& shown, FrameText& text, FrameQuestion& asked) {
  const std::vector<TreeNode>& tree = shown.search.tree_x;
  const NodeOnPath on_path = node_on_path(tree);
  std::vector<std::string> counts;
  for (std::size_t level = 0; level < on_path.path.size(); ++level) {
    const int node = on_path.path[level];
    asked.choices.push_back(level == 0 ? "the root" : fmt::format("level {}", level));
    asked.subjects.push_back({Subject::Kind::tree_node, node, -1});
    if (node == on_path.node)
      asked.answer = asked.choices.back();
    else
      counts.push_back(std::to_string(tree[node].count));
  }
  asked.refuted = fmt::format("Nodes of the other levels bound {}.", fmt::join(counts, ", "));
  text.caption = fmt::format(
      "Question: the {} bounds the green segments of {}. Which node of the tree is it? A leaf has "
      "one "
      "segment. Point at it.",
      shown.volume(), shown.name(true));
}

void ask_for_tiles(const Story& story, const Shown& shown, FrameText& text, FrameQuestion& asked) {
  const TiledSegment longest = longest_segment(shown);
  const double tile = trees_of(shown.lesson).tile;
  const std::size_t count = longest.leaves.size();
  for (const std::size_t each : {std::size_t{1}, count, 2 * count})
    asked.choices.push_back(std::to_string(each));
  asked.answer = asked.choices[1];
  asked.refuted = fmt::format("A tile covers {} of it at most, twice its radius.", 2.0 * tile);
  text.caption = fmt::format(
      "Question: tiles are circles of radius {} at most. How many does edge {} need, {} long?",
      tile, segment_name(shown, true, longest.segment), story.numbers(longest.length));
}

void ask_for_split(const Story& story, const Shown& shown, FrameText& text, FrameQuestion& asked) {
  const SplitOfTiles split = split_of(shown.search.tree_x, 0);
  asked.choices = {"the upright line", "the level line"};
  for (const int axis : {0, 1}) {
    const auto [from, to] = line_of(split, axis == 0 ? 0 : 1);
    asked.spots.emplace_back(Spot(ViewKind::world, from, to));
  }
  asked.answer = asked.choices[split.axis()];
  asked.refuted = fmt::format(
      "Middles of tiles lie {} apart across and {} in height: halves of the longer way are "
      "smaller.",
      story.numbers(split.spread.x()), story.numbers(split.spread.y()));
  text.caption = fmt::format(
      "Question: all tiles of {} are in one circle. Which line halves them, for small circles "
      "below? "
      "Point at it.",
      shown.name(true));
}

void ask_for_tile_size(const Shown& shown, FrameText& text, FrameQuestion& asked) {
  const models::SearchResult& own = shown.search.trace.result;
  const TileSize& large = shown.search.tile_sizes.back();
  asked.choices = {"fewer", "as many", "more"};
  asked.answer = asked.choices[large.result.measured < own.measured    ? 0
                               : large.result.measured == own.measured ? 1
                                                                       : 2];
  asked.refuted =
      "A large circle reaches far off its segment, so fewer pairs of tiles are cut by their "
      "bounds.";
  text.caption = fmt::format(
      "Question: tiles of {} take {} visits, not {}. Are fewer pairs of segments measured than {}, "
      "as "
      "many, or more?",
      large.radius, large.result.visits, own.visits, own.measured);
}

void ask_for_volume(const Shown& shown, FrameText& text, FrameQuestion& asked) {
  const long own = shown.search.trace.result.visits;
  const long boxes = shown.search.of_boxes.visits;
  const long circles = shown.search.of_circles.visits;
  asked.choices = {"boxes of segments", "circles of segments",
                   fmt::format("tiles of {}", trees_of(shown.lesson).tile)};
  asked.answer = asked.choices[boxes <= std::min(circles, own) ? 0 : circles <= own ? 1 : 2];
  asked.refuted = "By visits Quinlan's tiles are not bound to win: more leaves need more levels.";
  text.caption =
      "Question: with which of these volumes does the search for this distance visit the fewest "
      "pairs?";
}

void ask_extra(const Story& story, const Shown& shown, Extra extra, FrameText& text) {
  FrameQuestion& asked = text.question.emplace();
  asked.ask = kExtraAsks[static_cast<std::size_t>(extra)]->name;
  switch (extra) {
    case Extra::pieces:
      return ask_for_pieces(shown, text, asked);
    case Extra::pairs:
      return ask_for_pairs(shown, text, asked);
    case Extra::node:
      return ask_for_node(shown, text, asked);
    case Extra::tiles:
      return ask_for_tiles(story, shown, text, asked);
    case Extra::split:
      return ask_for_split(story, shown, text, asked);
    case Extra::tile_size:
      return ask_for_tile_size(shown, text, asked);
    case Extra::volume:
      return ask_for_volume(shown, text, asked);
  }
}

void ask_for_wider(const Shown& shown, FrameText& text) {
  FrameQuestion& asked = text.question.emplace();
  asked.ask = kAskWider.name;
  const long distance = shown.search.trace.result.visits;
  const long collide = shown.search.collide.result.visits;
  asked.choices = {grouped(static_cast<double>(collide))};
  for (const long count : {(collide + distance) / 2, distance})
    if (count > collide) asked.choices.push_back(grouped(static_cast<double>(count)));
  asked.answer = asked.choices.front();
  asked.refuted =
      "A search for a meeting ends at every gap, the one for the distance only beyond δ.";
  text.caption = fmt::format(
      "Question: the distance took {} visits. In the same trees, how many does collide take, to "
      "find "
      "out whether they meet?",
      grouped(static_cast<double>(distance)));
}

void ask_for_first_leaf(const Shown& shown, FrameText& text) {
  FrameQuestion& asked = text.question.emplace();
  asked.ask = kAskFirstLeaf.name;
  asked.choices = {"cut: nothing in a meets anything in b",
                   "descend: a leaf has to be reached first"};
  asked.answer = asked.choices[1];
  asked.refuted =
      "To cut is right for collide alone: here δ stays ∞ until two leaves are measured.";
  text.caption = fmt::format(
      "Question: the {} a and b do not meet. Can the search for the distance cut them, as collide "
      "does?",
      shown.volumes());
}

void ask_for_dearer(const Shown& shown, FrameText& text) {
  FrameQuestion& asked = text.question.emplace();
  asked.ask = kAskDearer.name;
  const BoxTests tests = tests_of(std::get<models::Box>(shown.node(true).volume),
                                  std::get<models::Box>(shown.node(false).volume));
  asked.choices = {"that they meet or not", "how far they are apart", "both as many"};
  asked.answer = asked.choices[tests.meet > tests.distance   ? 0
                               : tests.meet < tests.distance ? 1
                                                             : 2];
  asked.refuted =
      fmt::format("That is {} operations to {}: one gap along x or y shows that they do not meet.",
                  tests.distance, tests.meet);
  text.caption =
      "Question: which takes more comparisons and sums for the boxes a and b, that they meet or "
      "not, or "
      "how far they are apart?";
}

void ask_for_gap(const Story& story, const Shown& shown, FrameText& text) {
  FrameQuestion& asked = text.question.emplace();
  asked.ask = kAskGap.name;
  const models::Circle& a = std::get<models::Circle>(shown.node(true).volume);
  const models::Circle& b = std::get<models::Circle>(shown.node(false).volume);
  const Eigen::Vector2d difference = b.center - a.center;
  const double between = gjk::length(difference);
  for (const double apart :
       {between, between - std::max(a.radius, b.radius), between - a.radius - b.radius})
    asked.choices.push_back(story.numbers(apart));
  asked.answer = story.numbers(shown.state.pair.bound);
  asked.refuted = "Both radii go off the way between the centers; else segments could be nearer.";
  text.caption = fmt::format(
      "Question: the centers of a and b are {} apart, their radii are {} and {}. How far apart are "
      "the "
      "circles?",
      story.numbers(between), story.numbers(a.radius), story.numbers(b.radius));
}

}  // namespace

void question(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  if (const std::optional<Extra> extra = extra_of(story.run, story.frame);
      extra &&
      story.run.asked(story.frame).ask == kExtraAsks[static_cast<std::size_t>(*extra)]->name)
    return ask_extra(story, shown, *extra, text);
  const std::string& ask = story.run.asked(story.frame).ask;
  if (ask == kAskWider.name) return ask_for_wider(shown, text);
  if (ask == kAskFirstLeaf.name) return ask_for_first_leaf(shown, text);
  if (ask == kAskDearer.name) return ask_for_dearer(shown, text);
  if (ask == kAskGap.name) return ask_for_gap(story, shown, text);
  if (story.run.asked(story.frame).ask == kAskHalf.name)
    return ask_about_halves(story, shown, text);
  const models::SearchRecord& record = shown.search.trace.steps[story.frame.answering_step].record;
  const bool is_distance = shown.is_distance();
  FrameQuestion& asked = text.question.emplace();
  if (story.run.asked(story.frame).ask == kAskTable.name) {
    asked.ask = kAskTable.name;
    asked.choices = {"measure their segments", "look it up in the table"};
    asked.answer = asked.choices[record.hit ? 1 : 0];
    text.caption =
        fmt::format("Question: a is a tile of {}, b of {}. Measure these segments, or look it up?",
                    segment_name(shown, true, record.segments.first),
                    segment_name(shown, false, record.segments.second));
    return;
  }
  asked.ask = is_distance ? kAskWin.name : kAskDescend.name;
  asked.choices = is_distance ? std::vector<std::string>{"no", "yes: cut"}
                              : std::vector<std::string>{"descend", "cut"};
  asked.answer = asked.choices[record.cut ? 1 : 0];
  text.caption = is_distance
                     ? fmt::format("Question: are the {} a and b farther apart than δ = {}?",
                                   shown.volumes(), story.numbers(shown.state.candidate->high))
                     : fmt::format("Question: descend into the {}, or cut?", shown.volumes());
}

void values(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  const auto put = [&](std::string name, std::string value) {
    text.values.emplace_back(std::move(name), std::move(value));
  };
  put("x", shown.name(true));
  put("y", shown.name(false));
  if (shown.is_refused()) return;
  put("pairs", grouped(static_cast<double>(shown.search.pairs())));
  put("visits", grouped(static_cast<double>(shown.state.visits)));
  put("tests", grouped(static_cast<double>(shown.state.measured)));
  if (shown.has_tiles()) put("looked up", grouped(static_cast<double>(shown.state.hits)));
  if (shown.is_distance() && shown.state.candidate)
    put("candidate", story.numbers(shown.state.candidate->high));
  if (shown.is_answer && shown.is_distance())
    put("distance", story.numbers(shown.search.trace.result.answer.distance));
}

}  // namespace gjkscope::searches
