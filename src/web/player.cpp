#include "web/player.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "depth/depth.hpp"
#include "effects/registry.hpp"
#include "lesson/load.hpp"
#include "lesson/names.hpp"
#include "lesson/save.hpp"
#include "lesson/scalar.hpp"
#include "lesson/widen.hpp"
#include "paint/svg.hpp"
#include "picture/panel.hpp"
#include "picture/registry.hpp"
#include "picture/timeline.hpp"
#include "session/edit.hpp"
#include "session/hit.hpp"
#include "trace/trace_json.hpp"

namespace gjkscope {
namespace {

using Json = nlohmann::ordered_json;
using Eigen::Vector2d;
using Kind = Subject::Kind;

constexpr double kSlack = 7.0;          // pixels around a point or a line that still hit it
constexpr double kSmallestType = 14.0;  // on a phone; a frame's smallest is 12
constexpr double kTimelineHeight = 56.0;
constexpr std::size_t kMostPairs = 100'000;  // differences that are drawn one by one
constexpr std::size_t kMostText = 1 << 21;   // bytes of a case; as of a lesson file

std::string lines(const std::vector<Problem>& problems) {
  std::vector<std::string> out;
  for (const Problem& problem : problems) out.push_back(to_string(problem));
  return fmt::format("{}", fmt::join(out, "\n"));
}

std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void enlarge_small_type(Picture& picture) {
  for (Mark& mark : picture.marks) {
    if (Text* text = std::get_if<Text>(&mark.shape))
      text->style.size = std::max(text->style.size, kSmallestType);
  }
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
  return {name, fmt::format("{}", value), fmt::format("{:a}", value)};
}

void add_point(Json& list, const std::string& name, const Vector2d& point) {
  list.push_back(number(name + ".x", point.x()));
  list.push_back(number(name + ".y", point.y()));
}

/// How deep the shapes of the run lie in each other; nothing when they are apart.
void add_depth(Json& list, const PositionedRun& run, ScalarKind scalar) {
  const gjk::Verdict verdict = run.trace.result.verdict;
  if (verdict != gjk::Verdict::touching && verdict != gjk::Verdict::overlapping) return;
  with_scalar(scalar, [&]<class S>(std::type_identity<S>) {
    const auto x = narrowed_all<S, 2>(run.x_world);
    const auto y = narrowed_all<S, 2>(run.y_world);
    const auto found = depth::penetration<S>(gjk::Query<S, 2>{{x}, {y}});
    list.push_back(number("penetration depth", widened(found.depth)));
    list.push_back(number("its lower bound", widened(found.lower)));
    list.push_back(number("its upper bound", widened(found.upper)));
    add_point(list, "shortest way out of X", widened(found.translation));
  });
}

/// Names and values, as decimals and as hex floats.
Json numbers(const LessonRun& run, const Frame& frame) {
  const gjk::State<double, 2>& state = run.state(frame);
  Json list = Json::array();
  for (int i = 0; i < state.simplex.count; ++i) {
    const std::string name = run.pair_name(state.simplex.vertices[i].pair);
    add_point(list, name, state.simplex.vertices[i].w);
    if (frame.step >= 0) list.push_back(number("weight of " + name, state.simplex.weights[i]));
  }
  if (frame.step >= 0) {
    add_point(list, "P", state.p);
    add_point(list, "d", state.d);
    list.push_back(number("lower bound", run.bounds(frame).lower));
    list.push_back(number("upper bound", run.bounds(frame).upper));
  }
  return list;
}

/// What the run comes to.
Json outcome(const LessonRun& run, const Frame& frame) {
  const PositionedRun& here = run.run(frame);
  const gjk::Result<double, 2>& result = here.trace.result;
  Json list = Json::array();
  list.push_back(number("distance", result.distance));
  list.push_back(number("lower bound", result.lower));
  list.push_back(number("upper bound", result.upper));
  add_point(list, "closest point of " + run.lesson.x.name, result.x);
  add_point(list, "closest point of " + run.lesson.y.name, result.y);
  add_depth(list, here, run.lesson.scalar);
  for (const auto& [name, value] : {std::pair("verdict", std::string(name_of(result.verdict))),
                                    {"stop", std::string(name_of(result.stop))},
                                    {"iterations", std::to_string(result.iterations)}})
    list.push_back({name, value, value});
  return list;
}

Json shape_json(const LessonShape& shape) {
  Json vertices = Json::array();
  for (const Vector2d& v : shape.vertices) {
    vertices.push_back({fmt::format("{}", v.x()), fmt::format("{}", v.y()),
                        fmt::format("{:a}", v.x()), fmt::format("{:a}", v.y())});
  }
  return {{"name", shape.name}, {"names", shape.vertex_names}, {"vertices", std::move(vertices)}};
}

template <class E>
Json json_names() {
  Json names = Json::array();
  for (const auto& [name, value] : Named<E>::kTable) names.push_back(name);
  return names;
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

/// A request, read key by key; throws std::runtime_error that says which key is not what it should.
struct Player::Asked {
  Json json;

  [[nodiscard]] const Json& at(const char* key) const {
    const auto found = json.find(key);
    if (found == json.end()) throw std::runtime_error(fmt::format("the request has no '{}'", key));
    return *found;
  }
  [[nodiscard]] std::string text(const char* key) const {
    if (!at(key).is_string()) throw std::runtime_error(fmt::format("'{}' is not a text", key));
    return at(key).get<std::string>();
  }
  [[nodiscard]] bool flag(const char* key) const {
    if (!at(key).is_boolean()) throw std::runtime_error(fmt::format("'{}' is no boolean", key));
    return at(key).get<bool>();
  }
  [[nodiscard]] double real(const char* key) const {
    constexpr double kMost = 1e9;
    const Json& value = at(key);
    if (!value.is_number() || !(std::abs(value.get<double>()) <= kMost))
      throw std::runtime_error(fmt::format("'{}' is not a number of a moderate size", key));
    return value.get<double>();
  }
  [[nodiscard]] int whole(const char* key) const { return static_cast<int>(std::floor(real(key))); }
  [[nodiscard]] Point point() const { return {real("x"), real("y")}; }
  [[nodiscard]] edit::Which shape() const {
    return text("shape") == "x" ? edit::Which::x : edit::Which::y;
  }
};

/// What is being dragged, since where.
struct Player::Drag {
  Subject subject;
  std::size_t stage = 0;
  Point last;
  bool moved = false;
};

Player::Player(std::array<FaceBytes, kFaceCount> fonts, std::map<std::string, std::string> themes)
    : fonts_(std::move(fonts)),
      theme_texts_(std::move(themes)),
      theme_(Theme::read(
          [&](std::string_view name) -> std::optional<std::string> {
            const auto found = theme_texts_.find(std::string(name));
            if (found == theme_texts_.end()) return std::nullopt;
            return found->second;
          },
          "light")),
      session_(fonts_) {}

std::string Player::answer(std::string_view request) {
  try {
    const Asked asked{Json::parse(request)};
    const std::string what = asked.text("do");
    if (what == "open") {
      open(asked);
    } else if (what == "layout") {
      set_layout(asked);
    } else if (!opened_) {
      throw std::runtime_error("there is no lesson yet");
    } else if (what == "case") {
      open_case(asked);
    } else if (what == "go") {
      session_.go_to(asked.whole("to"));
    } else if (what == "step") {
      session_.step(asked.whole("by"));
    } else if (what == "iteration") {
      session_.step_iteration(asked.whole("by"));
    } else if (what == "phase") {
      if (!session_.go_to_next(session_.run().phase_name(asked.whole("phase"))))
        throw std::runtime_error("this run has no such step");
    } else if (what == "press") {
      press(asked.point());
    } else if (what == "move") {
      move(asked.point());
    } else if (what == "release") {
      session_.end_drag();
      drag_.reset();
      if (!session_.problem().empty()) throw std::runtime_error(session_.problem());
      panel_height_ = panel_height();
    } else if (what == "point") {
      return linked(asked.point(), kSlack);
    } else if (what == "vertex") {
      put_vertex(asked);
    } else if (what == "numerics") {
      set_numerics(asked);
    } else if (what == "undo") {
      session_.undo();
    } else if (what == "redo") {
      session_.redo();
    } else if (what == "reset") {
      session_.edit("reset", *opened_);
      session_.fit();
    } else if (what == "predict") {
      session_.set_predicting(asked.flag("on"));
    } else if (what == "answer") {
      session_.answer(asked.text("choice"));
    } else if (what == "lesson") {
      return dumped({{"lesson", lesson_toml(session_.lesson())}});
    } else if (what == "trace") {
      return dumped({{"trace", trace_json(traced(session_.run()))}});
    } else if (what == "frame") {
      EffectGraph effects(session_.run());
      LessonPictures pictures(session_.run(), effects, fonts_);
      return dumped({{"svg", to_svg(pictures.picture(session_.index()), fonts_, theme_,
                                    alternative_text(session_.text()))}});
    } else {
      throw std::runtime_error(fmt::format("there is no request '{}'", what));
    }
    return shown();
  } catch (const std::exception& error) {
    return dumped({{"problem", error.what()}});
  }
}

void Player::open(const Asked& asked) {
  results_.clear();
  if (asked.json.contains("files")) {
    for (const auto& [name, text] : asked.at("files").items())
      results_[name] = text.get<std::string>();
  }
  const FileReader read = [&](const std::filesystem::path& file, std::size_t) -> FileText {
    const auto found = results_.find(file.filename().string());
    if (found == results_.end()) return {std::nullopt, "the page does not hold this file"};
    return {found->second, {}};
  };
  const std::string text = asked.text("lesson");
  if (text.size() > kMostText) throw std::runtime_error("the lesson is too large");
  LoadedLesson loaded = parse_lesson(text, asked.text("name"), vocabulary(), read);
  if (!loaded.lesson) throw std::runtime_error(lines(loaded.problems));
  open_sound(*std::move(loaded.lesson));
}

/// The lesson goes on with other shapes; they are shown as its own were.
void Player::open_case(const Asked& asked) {
  const std::string text = asked.text("text");
  const std::string name = asked.text("name");
  if (text.size() > kMostText) {
    throw std::runtime_error(fmt::format("{}: {} bytes are too many; expected at most {}", name,
                                         text.size(), kMostText));
  }
  const std::vector<ReadCase> cases = parse_cases(text, name);
  if (!cases.front().value) throw std::runtime_error(lines(cases.front().problems));
  const Lesson plain = lesson_of(*cases.front().value, cases.front().name, ScalarKind::double_);
  Lesson lesson = session_.lesson();
  lesson.x = plain.x;
  lesson.y = plain.y;
  lesson.options.start = plain.options.start;
  lesson.path_of_shapes.reset();
  lesson.questions.clear();
  lesson.expect = {};
  lesson.expect.stop = gjk::StopReason::repeated_support;
  for (LessonView& view : lesson.views) view.camera.reset();
  if (lesson.x.vertices.size() * lesson.y.vertices.size() > kMostPairs) {
    for (LessonView& view : lesson.views) view.effects.clear();
  }
  const LoadedLesson read = parse_lesson(lesson_toml(lesson), name, vocabulary());
  if (!read.lesson) throw std::runtime_error(lines(read.problems));
  if (!session_.edit("other shapes", *read.lesson))
    throw std::runtime_error(fmt::format("{}: {}", name, session_.problem()));
  session_.fit();
  session_.go_to(session_.frame_count() - 1);
  panel_height_ = panel_height();
}

void Player::open_sound(Lesson lesson) {
  if (!session_.open(lesson, {})) throw std::runtime_error(session_.problem());
  opened_ = std::move(lesson);
  panel_height_ = panel_height();
}

void Player::set_layout(const Asked& asked) {
  constexpr double kLeast = 200.0;
  constexpr double kMost = 10000.0;
  const auto length = [&](const char* key) { return std::clamp(asked.real(key), kLeast, kMost); };
  const std::string theme = asked.text("theme");
  theme_ = Theme::read(
      [&](std::string_view name) -> std::optional<std::string> {
        const auto found = theme_texts_.find(std::string(name));
        if (found == theme_texts_.end()) return std::nullopt;
        return found->second;
      },
      theme);
  session_.set_page({length("width"), length("height"), 1.0, true});
  panel_width_ = length("panel");
  timeline_width_ = length("timeline");
  if (opened_) panel_height_ = panel_height();
}

namespace {

std::optional<std::size_t> stage_at(const Session& session, const Point& p) {
  const std::vector<LessonPictures::Stage> stages = session.views();
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const Rect& card = stages[i].card;
    if ((p.array() >= card.min.array()).all() && (p.array() <= card.max.array()).all()) return i;
  }
  return std::nullopt;
}

Vector2d to_view(const LessonPictures::Stage& stage, const Point& p) {
  const Point off = p - stage.card.center();
  return stage.camera.center +
         Vector2d(off.x(), -off.y()) * (stage.camera.height / stage.card.size().y());
}

}  // namespace

void Player::press(const Point& at) {
  drag_.reset();
  const Subject subject = subject_at(session_.picture(), fonts_, at, 2.0 * kSlack);
  const std::optional<std::size_t> stage = stage_at(session_, at);
  if (!stage) return;
  const bool in_world = session_.views()[*stage].kind == ViewKind::world;
  const bool of_shapes = subject.kind == Kind::vertex_of_x || subject.kind == Kind::vertex_of_y ||
                         subject.kind == Kind::shape_x || subject.kind == Kind::shape_y;
  const bool of_difference =
      subject.kind == Kind::difference || subject.kind == Kind::difference_vertex;
  if (in_world ? of_shapes : of_difference)
    drag_ = std::make_shared<Drag>(Drag{subject, *stage, at});
}

void Player::move(const Point& at) {
  if (!drag_) return;
  Drag& drag = *drag_;
  constexpr double kStill = 2.0;  // pixels: a tap is not a drag
  if (!drag.moved && (at - drag.last).norm() < kStill) return;
  const Subject subject = drag.subject;
  const bool is_vertex = subject.kind == Kind::vertex_of_x || subject.kind == Kind::vertex_of_y;
  if (!std::exchange(drag.moved, true))
    session_.begin_drag(is_vertex ? "move a vertex" : "move a shape");
  const LessonPictures::Stage stage = session_.views()[drag.stage];
  const Vector2d by = to_view(stage, at) - to_view(stage, drag.last);
  const bool of_x = subject.kind == Kind::vertex_of_x || subject.kind == Kind::shape_x;
  const edit::Which which = of_x ? edit::Which::x : edit::Which::y;
  const PositionedRun& run = session_.run().run(session_.frame());
  const auto& world = of_x ? run.x_world : run.y_world;
  session_.drag([&](Lesson& lesson) {
    if (!is_vertex || world.size() == 1) return edit::move_shape(lesson, which, by);
    const int index = of_x ? subject.x : subject.y;
    edit::put_vertex(lesson, which, index, edit::placement_of(run, which), to_view(stage, at));
  });
  drag.last = at;
}

namespace {

/// Refuses what a lesson file could not say, with the loader's words.
void require_sound(const Lesson& lesson, const FileReader& read) {
  const LoadedLesson loaded = parse_lesson(lesson_toml(lesson), "lesson", vocabulary(), read);
  if (loaded.lesson) return;
  std::string why;
  for (const Problem& problem : loaded.problems) {
    why += fmt::format("{}{}", why.empty() ? "" : "; ", problem.what);
    if (!problem.expected.empty()) why += fmt::format(", expected {}", problem.expected);
  }
  throw std::runtime_error("this lesson cannot have that: " + why);
}

}  // namespace

/// Typed coordinates are read as those of a case: decimal, or hex like 0x1.8p-1.
void Player::put_vertex(const Asked& asked) {
  const edit::Which which = asked.shape();
  const int index = asked.whole("index");
  Lesson lesson = session_.lesson();
  std::vector<Vector2d>& vertices = edit::shape_of(lesson, which).vertices;
  if (index < 0 || index >= static_cast<int>(vertices.size()))
    throw std::runtime_error("there is no such vertex");
  const Json typed = {{"a", {{asked.text("x"), asked.text("y")}}}, {"b", {{0, 0}}}};
  const std::vector<ReadCase> read = parse_cases(dumped(typed), "typed");
  if (!read.front().value) {
    throw std::runtime_error(
        fmt::format("({}, {}) is no point: expected numbers like 0.25, 1e-6 or 0x1.8p-1",
                    asked.text("x"), asked.text("y")));
  }
  vertices[static_cast<std::size_t>(index)] = read.front().value->a.front();
  if (!lesson.study) require_sound(lesson, read_file);
  if (!session_.edit("type a value", lesson)) throw std::runtime_error(session_.problem());
}

void Player::set_numerics(const Asked& asked) {
  Lesson lesson = session_.lesson();
  const auto choose = [&](const char* key, auto& target) {
    const auto value = value_of<std::remove_reference_t<decltype(target)>>(asked.text(key));
    if (!value) throw std::runtime_error(fmt::format("there is no {} '{}'", key, asked.text(key)));
    target = *value;
  };
  choose("scalar", lesson.scalar);
  choose("direction", lesson.options.direction_rule);
  choose("regions", lesson.options.region_order);
  lesson.options.stop_on_repeated_support = asked.flag("repeated");
  lesson.options.stop_on_no_progress = asked.flag("progress");
  if (!lesson.study) require_sound(lesson, read_file);
  if (!session_.edit("numerics", lesson)) throw std::runtime_error(session_.problem());
}

/// The subjects that belong to the one at a place, as the SVG names them.
std::string Player::linked(const Point& at, double slack) {
  const Subject pointed = subject_at(session_.picture(), fonts_, at, slack);
  std::set<std::string> names;
  for (const Mark& mark : session_.picture().marks) {
    if (is_linked(mark.subject, pointed)) names.insert(subject_name(mark.subject));
  }
  return dumped({{"of", subject_name(pointed)}, {"linked", names}});
}

Picture Player::panel() {
  Picture picture{panel_width_, panel_height_, {}, 0.0, {}};
  const Rect card{{0.0, 0.0}, {panel_width_, panel_height_}};
  picture.marks = panel_marks(session_.run(), session_.effects(), session_.frame(), fonts_, card);
  picture.marks.insert(picture.marks.begin(), {"card", Box{card, 10.0}, -1, {}});
  enlarge_small_type(picture);
  return picture;
}

/// Room for the panel of every frame, so that it keeps its height.
double Player::panel_height() {
  constexpr double kPad = 14.0;
  if (session_.lesson().panel.empty()) return 0.0;
  double lowest = 0.0;
  for (const Frame& frame : session_.run().frames) {
    const Rect card{{0.0, 0.0}, {panel_width_, 0.0}};
    for (const Mark& mark : panel_marks(session_.run(), session_.effects(), frame, fonts_, card))
      lowest = std::max(lowest, bottom_of(mark));
  }
  return std::ceil(lowest + kPad);
}

Picture Player::timeline() const {
  Picture picture{timeline_width_, kTimelineHeight, {}, 0.0, {}};
  picture.marks = timeline_marks(session_.run(), session_.index(), fonts_,
                                 {{0.0, 0.0}, {timeline_width_, kTimelineHeight}});
  enlarge_small_type(picture);
  return picture;
}

std::string Player::shown() {
  if (!opened_) return dumped({{"index", 0}, {"count", 0}});
  const FrameText& text = session_.text();
  const LessonRun& run = session_.run();
  const Lesson& lesson = session_.lesson();
  Picture stage = session_.picture();
  enlarge_small_type(stage);
  Json out = {{"index", session_.index()},
              {"count", session_.frame_count()},
              {"title", lesson.title},
              {"prose", text.prose},
              {"position", text.position},
              {"caption", text.caption},
              {"detail", text.detail},
              {"phase", text.phase},
              {"dragging", drag_ != nullptr},
              {"changed", *opened_ != lesson},
              {"undo", session_.undo_name()},
              {"redo", session_.redo_name()},
              {"stage", to_svg(stage, fonts_, theme_, alternative_text(text))},
              {"timeline", to_svg(timeline(), fonts_, theme_, text.position)}};
  std::string values;
  for (const auto& [name, value] : text.values)
    values += fmt::format("{}{} {}", values.empty() ? "" : ", ", name, value);
  if (!lesson.panel.empty())
    out["panel"] = to_svg(panel(), fonts_, theme_, "Pseudocode and values: " + values);
  if (const FrameQuestion* question = session_.question())
    out["question"] = {{"ask", question->ask}, {"choices", question->choices}};
  out["predicting"] = session_.is_predicting();
  if (!session_.answers().empty()) {
    const Answer& last = session_.answers().back();
    out["answers"] = {{"asked", session_.answers().size()},
                      {"right", session_.right_answers()},
                      {"chosen", last.chosen},
                      {"answer", last.right}};
  }
  if (session_.is_dragging()) return dumped(out);
  out["numbers"] = numbers(run, session_.frame());
  out["outcome"] = outcome(run, session_.frame());
  out["numerics"] = numerics(lesson);
  out["choices"] = {{"scalar", json_names<ScalarKind>()},
                    {"direction", json_names<gjk::DirectionRule>()},
                    {"regions", json_names<gjk::RegionOrder>()}};
  if (std::max(lesson.x.vertices.size(), lesson.y.vertices.size()) <= edit::kMostEditable)
    out["shapes"] = {{"x", shape_json(lesson.x)}, {"y", shape_json(lesson.y)}};
  return dumped(out);
}

}  // namespace gjkscope
