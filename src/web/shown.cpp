// The output of a player: pictures, words and numbers of a frame.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/hexadecimal.hpp"
#include "frames/panel.hpp"
#include "frames/spots.hpp"
#include "frames/timeline.hpp"
#include "lesson/names.hpp"
#include "outlines/polygon.hpp"
#include "paint/svg.hpp"
#include "picture/term_spots.hpp"
#include "picture/text_box.hpp"
#include "run/trail.hpp"
#include "session/edit.hpp"
#include "session/hit.hpp"
#include "session/pointing.hpp"
#include "subjects/depth/penetration.hpp"
#include "subjects/run/code.hpp"
#include "web/json.hpp"
#include "web/player.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector2d;

constexpr double kTimelineHeight = 66.0;

/// Whether all texts of a panel are within it and apart.
bool fits(const Picture& picture, const Fonts& fonts) {
  constexpr double kEdge = 8.0;
  constexpr double kGap = 5.0;
  constexpr double kTouching = 0.01;
  std::vector<Rect> boxes;
  for (const Mark& mark : picture.marks) {
    const Text* text = std::get_if<Text>(&mark.shape);
    if (!text) continue;
    const Rect box = box_of(fonts, *text);
    if (box.max.x() > picture.width - kEdge) return false;
    for (const Rect& other : boxes) {
      const bool beside = box.min.x() > other.max.x() + kGap || other.min.x() > box.max.x() + kGap;
      const bool goes_on = std::abs(box.min.x() - other.max.x()) < kTouching;  // in another style
      const bool apart = box.min.y() > other.max.y() || other.min.y() > box.max.y();
      if (!beside && !goes_on && !apart) return false;
    }
    boxes.push_back(box);
  }
  return true;
}

/// The lowest pixel of a mark.
double bottom_of(const Mark& mark) {
  const auto lowest = [](const std::vector<Point>& points) {
    double y = 0.0;
    for (const Point& p : points) y = std::max(y, p.y());
    return y;
  };
  struct Visitor {
    decltype(lowest) of;
    double operator()(const Polygon& polygon) const { return of(polygon.points); }
    double operator()(const Polyline& line) const { return of(line.points); }
    double operator()(const Arrow& arrow) const { return of({arrow.from, arrow.to}); }
    double operator()(const Disk& disk) const { return disk.center.y() + disk.radius; }
    double operator()(const Cross& cross) const { return cross.center.y() + cross.radius; }
    double operator()(const Box& box) const { return box.rect.max.y(); }
    double operator()(const Text& text) const { return text.at.y() + 0.3 * text.style.size; }
  };
  return std::visit(Visitor{lowest}, mark.shape);
}

Json number(const std::string& name, double value) {
  return {name, fmt::format("{}", value), hexadecimal(value)};
}

void add_point(Json& list, const std::string& name, const Eigen::Vector3d& point, int dimension) {
  for (int i = 0; i < dimension; ++i)
    list.push_back(number(fmt::format("{}.{}", name, "xyz"[i]), point[i]));
}

/// Names and values, as decimals and as hex floats.
Json numbers(const LessonRun& run, const Frame& frame) {
  const WideState& state = run.state(frame);
  const bool is_under_way = run.gjk_step(frame) >= 0;
  Json list = Json::array();
  for (int i = 0; i < state.simplex.count; ++i) {
    const std::string name = run.pair_name(state.simplex.vertices[i].pair);
    add_point(list, name, state.simplex.vertices[i].w, run.lesson.dimension);
    if (is_under_way) list.push_back(number("weight of " + name, state.simplex.weights[i]));
  }
  if (is_under_way) {
    add_point(list, "P", state.p, run.lesson.dimension);
    add_point(list, "d", state.d, run.lesson.dimension);
    list.push_back(number("lower bound", run.bounds(frame).lower));
    list.push_back(number("upper bound", run.bounds(frame).upper));
  }
  return list;
}

/// The outcome of the run.
Json outcome(Session& session) {
  const LessonRun& run = session.run();
  const Frame& frame = session.frame();
  if (run.run(frame).trace.is_empty()) {
    Json list = Json::array();
    for (const std::string_view name : run.tour->algorithm->answers)
      list.push_back(number(std::string(name), run.algorithm_trace(frame).answer(name)));
    return list;
  }
  const WideResult& result = run.run(frame).trace.result;
  Json list = Json::array();
  list.push_back(number("distance", result.distance));
  list.push_back(number("lower bound", result.lower));
  list.push_back(number("upper bound", result.upper));
  add_point(list, "closest point of " + run.lesson.x().name, result.x, run.lesson.dimension);
  add_point(list, "closest point of " + run.lesson.y().name, result.y, run.lesson.dimension);
  if (const DepthResult* depth = depth_on_overlap(session.effects(), run, frame)) {
    list.push_back(number("penetration depth", depth->depth));
    list.push_back(number("its lower bound", depth->lower));
    list.push_back(number("its upper bound", depth->upper));
    add_point(list, "shortest way out of " + run.lesson.x().name, depth->translation,
              run.lesson.dimension);
  }
  for (const auto& [name, value] : {std::pair("verdict", std::string(name_of(result.verdict))),
                                    {"stop", std::string(name_of(result.stop))},
                                    {"iterations", std::to_string(result.iterations)}})
    list.push_back({name, value, value});
  return list;
}

Json shape_json(const LessonShape& shape, int dimension) {
  Json vertices = Json::array();
  for (const Eigen::Vector3d& v : shape.vertices) {
    Json vertex = Json::array();
    for (int i = 0; i < dimension; ++i) vertex.push_back(fmt::format("{}", v[i]));
    for (int i = 0; i < dimension; ++i) vertex.push_back(hexadecimal(v[i]));
    vertices.push_back(std::move(vertex));
  }
  return {{"name", shape.name}, {"names", shape.vertex_names}, {"vertices", std::move(vertices)}};
}

/// The names of shapes that GJK knows by their hulls alone.
Json not_convex(const LessonRun& run) {
  Json names = Json::array();
  if (run.tour->algorithm->takes_outlines || run.lesson.dimension == 3) return names;
  for (const LessonShape* shape : {&run.lesson.x(), &run.lesson.y()}) {
    if (differs_from_hull(in_plane(shape->vertices))) names.push_back(shape->name);
  }
  return names;
}

Json entries(const std::vector<Session::Kept>& history) {
  Json list = Json::array();
  for (const auto& [id, change] : history) list.push_back({{"id", id}, {"change", change}});
  return list;
}

Json numerics(const Lesson& lesson) {
  const gjk::Options& options = lesson.options;
  return {{"scalar", name_of(lesson.scalar)},
          {"direction", name_of(options.direction_rule)},
          {"regions", name_of(options.region_order)},
          {"repeated", options.stop_on_repeated_support},
          {"progress", options.stop_on_no_progress}};
}

}  // namespace

Picture Player::panel(const Frame& frame, double width) {
  Picture picture{width, panel_height_, {}, 0.0, {}};
  const Rect card{{0.0, 0.0}, {width, panel_height_}};
  picture.marks = panel_marks(session_.run(), session_.effects(), frame, fonts_, card);
  picture.marks.insert(picture.marks.begin(), {"card", Box{card, 10.0}, -1, {}});
  return picture;
}

/// One size for the panels of all frames: as wide as there is room, wider where texts would meet or
/// stick out (a page shows that smaller), and as high as the highest.
void Player::measure_panel() {
  if (session_.lesson().panel.empty()) return;
  const std::vector<Frame>& frames = session_.run().frames;
  panel_height_ = 0.0;
  panel_width_ = panel_room_;
  constexpr double kFiner = 2.0;
  constexpr double kLeastType = 14.0;
  const double widest = panel_room_ * type::kBody.size / kLeastType;
  for (const Frame& frame : frames) {
    while (panel_width_ + kFiner <= widest && !fits(panel(frame, panel_width_), fonts_))
      panel_width_ += kFiner;
  }
  constexpr double kPad = 14.0;
  double lowest = 0.0;
  for (const Frame& frame : frames) {
    for (const Mark& mark : panel(frame, panel_width_).marks)
      lowest = std::max(lowest, bottom_of(mark));
  }
  panel_height_ = std::ceil(lowest + kPad);
}

Picture Player::timeline() const {
  Picture picture{timeline_width_, kTimelineHeight, {}, 0.0, {}};
  picture.marks = timeline_marks(session_.run(), session_.index(), fonts_,
                                 {{0.0, 14.0}, {timeline_width_, kTimelineHeight}});
  return picture;
}

/// The shortest way out of the other shape, where the world is shown.
void Player::draw_depth(Picture& picture) {
  const LessonPictures::ShownView view = session_.views().front();
  const LessonRun& run = session_.run();
  if (view.kind != ViewKind::world) return;
  const DepthResult* depth = depth_on_overlap(session_.effects(), run, session_.frame());
  if (depth == nullptr) return;
  const StageMap map(view.card, view.camera);
  const Point from = map(depth->x);
  const Point to = map(depth->x + depth->translation);
  picture.marks.push_back({"direction", Arrow{from, to}, 0, {}});
  const Text label{{view.card.min.x() + 14.0, view.card.max.y() - 14.0},
                   "Arrow: the shortest way out for " + run.lesson.x().name,
                   type::kViewTitle};
  picture.marks.push_back({"direction.label", label, -1, {}});
}

/// The vertices of both shapes, however many; `shown` leaves out those that are too long to list.
std::string Player::all_vertices() const {
  const Lesson& lesson = session_.lesson();
  return dumped({{"x", shape_json(lesson.x(), lesson.dimension)},
                 {"y", shape_json(lesson.y(), lesson.dimension)}});
}

/// The whole file of which the listing is a part.
std::string Player::code_page() const {
  const code::Page page = code::page(code::language_of(session_.lesson().listing));
  return dumped({{"name", page.name}, {"text", page.text}});
}

std::string Player::panel_svg(const Theme& theme) {
  std::string values;
  for (const auto& [name, value] : session_.text().values)
    values += fmt::format("{}{} {}", values.empty() ? "" : ", ", name, value);
  return to_svg(panel(session_.frame(), panel_width_), fonts_, theme,
                "Pseudocode and values: " + values);
}

namespace {

/// A text in pieces: words, and terms with their sentences, each where it comes first.
Json in_pieces(const std::string& text, const std::vector<CourseTerm>& terms) {
  Json pieces = Json::array();
  std::set<const CourseTerm*> explained;
  std::size_t at = 0;
  for (const FoundTerm& found : find_terms(text, terms)) {
    if (!explained.insert(found.term).second) continue;
    if (found.begin > at) pieces.push_back(text.substr(at, found.begin - at));
    pieces.push_back(
        Json::array({text.substr(found.begin, found.end - found.begin), found.term->sentence}));
    at = found.end;
  }
  if (at < text.size()) pieces.push_back(text.substr(at));
  return pieces;
}

/// The boxes of terms with their sentences, but for words that are buttons.
Json terms_on(Picture panel, const Fonts& fonts, const std::vector<CourseTerm>& terms) {
  std::erase_if(panel.marks,
                [](const Mark& mark) { return mark.subject.kind != Subject::Kind::none; });
  Json out = Json::array();
  for (const TermSpot& spot : term_spots(panel, fonts, terms)) {
    const Point size = spot.box.size();
    out.push_back({spot.box.min.x(), spot.box.min.y(), size.x(), size.y(), spot.term->sentence});
  }
  return out;
}

}  // namespace

/// The stage with a ring around the selected vertex, or the handle that turns the selected shape.
std::string Player::stage_svg(Picture stage) const {
  constexpr double kAround = 7.0;
  const std::size_t count = is_vertex(hand_.selected) ? stage.marks.size() : 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Disk* disk = std::get_if<Disk>(&stage.marks[i].shape);
    if (disk == nullptr || stage.marks[i].subject != hand_.selected) continue;
    const Disk ring{disk->center, disk->radius + kAround};
    stage.marks.push_back({"selected", ring, stage.marks[i].clip, {}});
  }
  for (Mark& mark : hand_.handle_marks()) stage.marks.push_back(std::move(mark));
  return to_svg(stage, fonts_, theme_, alternative_text(session_.text()));
}

/// The frame in the colours of paper.
std::string Player::for_paper() {
  const Theme paper = theme("print");
  Json out = {{"stage", to_svg(stage_, fonts_, paper, alternative_text(session_.text()))},
              {"timeline", to_svg(timeline(), fonts_, paper, session_.text().position)}};
  if (!session_.lesson().panel.empty()) out["panel"] = panel_svg(paper);
  return dumped(out);
}

std::string Player::shown(const std::string& understood) {
  if (!opened_) return dumped({{"count", 0}});
  if (!session_.is_dragging() && std::exchange(measured_, session_.version()) != session_.version())
    measure_panel();
  const FrameText& text = session_.text();
  const LessonRun& run = session_.run();
  const Lesson& lesson = session_.lesson();
  stage_before_ = std::exchange(stage_, session_.picture());
  if (shows_depth_ && session_.index() == answering_index(run)) draw_depth(stage_);
  Json out = {{"dragging", hand_.holds()}, {"stage", stage_svg(stage_)}};
  if (const FrameQuestion* question = session_.question()) {
    out["question"] = {{"ask", question->ask},
                       {"choices", question->choices},
                       {"drawn", is_answered_in_drawing(*question)}};
    if (const std::optional<Point> origin = origin_on_page(session_))
      out["question"]["origin"] = {origin->x(), origin->y()};
    for (const VertexChoice& half : question->pair)
      out["question"]["pair"].push_back({{"of", half.shape}, {"vertices", half.vertices}});
  }
  if (const std::optional<Eye> eye = session_.eye()) {
    out["sides"] = kSides;
    out["eye"] = {eye->azimuth, eye->elevation};
  }
  if (hand_.turns_views()) return dumped(out);
  out.update({{"index", session_.index()},
              {"count", session_.frame_count()},
              {"answer", answering_index(run)},
              {"title", lesson.title},
              {"prose", text.prose},
              {"position", text.position},
              {"caption", text.caption},
              {"detail", text.detail},
              {"phase", text.phase},
              {"changed", *opened_ != lesson},
              {"undo", session_.undo_name()},
              {"redo", session_.redo_name()},
              {"hulls", not_convex(run)},
              {"timeline", to_svg(timeline(), fonts_, theme_, text.position)}});
  for (const auto& [name, words] :
       {std::pair("prose", &text.prose), {"caption", &text.caption}, {"detail", &text.detail}})
    out["terms"][name] = in_pieces(*words, terms_);
  if (!lesson.panel.empty()) {
    out["panel"] = panel_svg(theme_);
    out["terms"]["panel"] = terms_on(panel(session_.frame(), panel_width_), fonts_, terms_);
  }
  if (code::in_language(lesson, Language::pseudocode)) {
    out["listing"] = {{"language", name_of(code::language_of(lesson.listing))},
                      {"languages", names_of<Language>()}};
  }
  if (!understood.empty()) out["understood"] = understood;
  out["predicting"] = session_.is_predicting();
  if (!session_.answers().empty()) {
    const Answer& last = session_.answers().back();
    out["answers"] = {{"asked", session_.answers().size()},
                      {"right", session_.right_answers()},
                      {"chosen", last.chosen},
                      {"answer", last.right}};
    if (last.pointed && last.origin)
      out["answers"]["turned"] = Numbers(lesson)(last.turned());
    else if (last.pointed && last.place)
      out["answers"]["away"] = Numbers(lesson)((*last.pointed - *last.place).norm());
  }
  if (practising_) {
    const practice::Practice practice = practising_->noted(session_);
    out["practice"] = {{"chapter", practice.chapter()},
                       {"chapters", practice::chapters_with_practice()},
                       {"seed", practice.seed()},
                       {"answers", practice.answers()},
                       {"right", practice.right()},
                       {"repeating", practice.repeating()},
                       {"answered", practising_->outcome(session_).has_value()}};
  }
  if (session_.is_dragging()) return dumped(out);
  out["history"] = {{"past", entries(session_.past())},
                    {"now", session_.lesson_id()},
                    {"future", entries(session_.future())}};
  out["numbers"] = numbers(run, session_.frame());
  out["outcome"] = outcome(session_);
  out["numerics"] = numerics(lesson);
  out["choices"] = {{"scalar", names_of<ScalarKind>()},
                    {"direction", names_of<gjk::DirectionRule>()},
                    {"regions", names_of<gjk::RegionOrder>()}};
  if (std::max(lesson.x().vertices.size(), lesson.y().vertices.size()) <= edit::kMostEditable)
    out["shapes"] = {{"x", shape_json(lesson.x(), lesson.dimension)},
                     {"y", shape_json(lesson.y(), lesson.dimension)}};
  return dumped(out);
}

}  // namespace gjkscope
