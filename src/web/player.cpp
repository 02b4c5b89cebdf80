#include "web/player.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "effects/penetration.hpp"
#include "lesson/load.hpp"
#include "lesson/names.hpp"
#include "lesson/save.hpp"
#include "paint/svg.hpp"
#include "picture/panel.hpp"
#include "picture/registry.hpp"
#include "picture/text_box.hpp"
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
constexpr double kTimelineHeight = 66.0;
constexpr std::size_t kMostPairs = 100'000;  // differences that are drawn one by one
constexpr std::size_t kMostText = 1 << 21;   // bytes of a case; as of a lesson file

std::string lines(const std::vector<Problem>& problems) {
  std::vector<std::string> all;
  for (const Problem& problem : problems) all.push_back(to_string(problem));
  return fmt::format("{}", fmt::join(all, "\n"));
}

std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Texts that grow past the left or right edge move in.
void enlarge_small_type(Picture& picture, const Fonts& fonts) {
  constexpr double kEdge = 6.0;
  for (Mark& mark : picture.marks) {
    Text* text = std::get_if<Text>(&mark.shape);
    if (!text || text->style.size >= kSmallestType) continue;
    text->style.size = kSmallestType;
    const Rect box = box_of(fonts, *text);
    text->at.x() += std::max(0.0, kEdge - box.min.x());
    text->at.x() -= std::max(0.0, box.max.x() - (picture.width - kEdge));
  }
}

/// Whether all texts of a panel are within it and apart.
bool fits(const Picture& picture, const Fonts& fonts) {
  constexpr double kEdge = 6.0;
  constexpr double kGap = 2.0;
  std::vector<Rect> boxes;
  for (const Mark& mark : picture.marks) {
    const Text* text = std::get_if<Text>(&mark.shape);
    if (!text) continue;
    const Rect box = box_of(fonts, *text);
    if (box.max.x() > picture.width - kEdge) return false;
    for (const Rect& other : boxes) {
      const bool beside = box.min.x() > other.max.x() + kGap || other.min.x() > box.max.x() + kGap;
      const bool apart = box.min.y() > other.max.y() || other.min.y() > box.max.y();
      if (!beside && !apart) return false;
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
  return {name, fmt::format("{}", value), fmt::format("{:a}", value)};
}

void add_point(Json& list, const std::string& name, const Vector2d& point) {
  list.push_back(number(name + ".x", point.x()));
  list.push_back(number(name + ".y", point.y()));
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
Json outcome(Session& session) {
  const LessonRun& run = session.run();
  const Frame& frame = session.frame();
  const gjk::Result<double, 2>& result = run.run(frame).trace.result;
  Json list = Json::array();
  list.push_back(number("distance", result.distance));
  list.push_back(number("lower bound", result.lower));
  list.push_back(number("upper bound", result.upper));
  add_point(list, "closest point of " + run.lesson.x().name, result.x);
  add_point(list, "closest point of " + run.lesson.y().name, result.y);
  if (const depth::Result<double>* depth = depth_on_overlap(session.effects(), run, frame)) {
    list.push_back(number("penetration depth", depth->depth));
    list.push_back(number("its lower bound", depth->lower));
    list.push_back(number("its upper bound", depth->upper));
    add_point(list, "shortest way out of " + run.lesson.x().name, depth->translation);
  }
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
  [[nodiscard]] std::size_t shape() const { return text("shape") == "x" ? 0 : 1; }
};

/// What is being dragged, since where.
struct Player::Drag {
  Subject subject;
  std::size_t stage = 0;
  Point last;
  bool moved = false;
};

FileText Player::held(const Files& files, const std::filesystem::path& file) {
  const auto found = files.find(file.filename().string());
  if (found == files.end()) return {std::nullopt, "the page does not hold this file"};
  return {found->second, {}};
}

Player::Player(std::array<FaceBytes, kFaceCount> fonts, std::map<std::string, std::string> themes)
    : fonts_(std::move(fonts)),
      theme_texts_(std::move(themes)),
      theme_(theme("light")),
      session_(fonts_, [this](const std::filesystem::path& file, std::size_t) {
        return held(files_, file);
      }) {}

Theme Player::theme(std::string_view wanted) const {
  const ThemeTexts texts = [&](std::string_view name) -> std::optional<std::string> {
    const auto found = theme_texts_.find(std::string(name));
    if (found == theme_texts_.end()) return std::nullopt;
    return found->second;
  };
  return Theme::read(texts, wanted);
}

std::string Player::answer(std::string_view request) {
  using Reply = void (*)(Player&, const Asked&);
  static const std::map<std::string_view, Reply> before_all = {
      {"open", [](Player& p, const Asked& a) { p.open(a); }},
      {"layout", [](Player& p, const Asked& a) { p.set_layout(a); }},
  };
  static const std::map<std::string_view, Reply> changes = {
      {"replace", [](Player& p, const Asked& a) { p.replace(a); }},
      {"case", [](Player& p, const Asked& a) { p.open_case(a); }},
      {"go", [](Player& p, const Asked& a) { p.session_.go_to(a.whole("to")); }},
      {"step", [](Player& p, const Asked& a) { p.session_.step(a.whole("by")); }},
      {"iteration", [](Player& p, const Asked& a) { p.session_.step_iteration(a.whole("by")); }},
      {"phase", [](Player& p, const Asked& a) { p.go_to_phase(a.whole("phase")); }},
      {"press", [](Player& p, const Asked& a) { p.press(a.point()); }},
      {"move", [](Player& p, const Asked& a) { p.move(a.point()); }},
      {"release", [](Player& p, const Asked&) { p.release(); }},
      {"vertex", [](Player& p, const Asked& a) { p.put_vertex(a); }},
      {"nudge", [](Player& p, const Asked& a) { p.nudge(a); }},
      {"numerics", [](Player& p, const Asked& a) { p.set_numerics(a); }},
      {"undo", [](Player& p, const Asked&) { p.session_.undo(); }},
      {"redo", [](Player& p, const Asked&) { p.session_.redo(); }},
      {"reset", [](Player& p, const Asked&) { p.reset(); }},
      {"predict", [](Player& p, const Asked& a) { p.session_.set_predicting(a.flag("on")); }},
      {"answer", [](Player& p, const Asked& a) { p.session_.answer(a.text("choice")); }},
  };
  using Tell = std::string (*)(Player&, const Asked&);
  static const std::map<std::string_view, Tell> tells = {
      {"point", [](Player& p, const Asked& a) { return p.linked(a.point()); }},
      {"lesson", [](Player& p, const Asked&) { return p.lesson_file(); }},
      {"trace", [](Player& p, const Asked&) { return p.trace(); }},
      {"frame", [](Player& p, const Asked&) { return p.whole_frame(); }},
  };
  try {
    const Asked asked{Json::parse(request)};
    const std::string what = asked.text("do");
    if (what == "solve") return traced_cases(asked);
    const auto first = before_all.find(what);
    const auto act = changes.find(what);
    const auto tell = tells.find(what);
    if (first == before_all.end() && act == changes.end() && tell == tells.end())
      throw std::runtime_error(fmt::format("there is no request '{}'", what));
    if (first == before_all.end() && !opened_) throw std::runtime_error("there is no lesson yet");
    if (tell != tells.end()) return tell->second(*this, asked);
    (first != before_all.end() ? first : act)->second(*this, asked);
    return shown();
  } catch (const std::exception& error) {
    return dumped({{"problem", error.what()}});
  }
}

std::string Player::lesson_file() const {
  return dumped({{"lesson", lesson_toml(session_.lesson())}});
}

std::string Player::trace() const {
  return dumped({{"trace", trace_json(traced(session_.run()))}});
}

/// As an export draws it.
std::string Player::whole_frame() const {
  EffectGraph effects(session_.run());
  LessonPictures pictures(session_.run(), effects, fonts_);
  const std::string svg =
      to_svg(pictures.picture(session_.index()), fonts_, theme_, alternative_text(session_.text()));
  return dumped({{"svg", svg}});
}

void Player::go_to_phase(int phase) {
  if (!session_.go_to_next(session_.run().phase_name(phase)))
    throw std::runtime_error("this run has no such step");
}

void Player::reset() {
  session_.edit("reset", *opened_);
  session_.fit();
}

void Player::open(const Asked& asked) {
  Files files;
  if (asked.json.contains("files")) {
    for (const auto& [name, text] : asked.at("files").items())
      files[name] = text.get<std::string>();
  }
  Lesson lesson = parsed(asked.text("lesson"), asked.text("name"), files);
  if (!session_.open(lesson, {})) throw std::runtime_error(session_.problem());
  files_ = std::move(files);
  opened_ = std::move(lesson);
  shows_depth_ = asked.json.contains("depth");
}

/// Another lesson as a change of this one: what a link holds.
void Player::replace(const Asked& asked) {
  const Lesson lesson = parsed(asked.text("lesson"), asked.text("name"), files_);
  if (!session_.edit("follow a link", lesson))
    throw std::runtime_error(fmt::format("{}: {}", asked.text("name"), session_.problem()));
  session_.fit();
}

Lesson Player::parsed(const std::string& text, const std::string& name, const Files& files) {
  if (text.size() > kMostText) {
    throw std::runtime_error(fmt::format("{}: {} bytes are too many; expected at most {}", name,
                                         text.size(), kMostText));
  }
  const FileReader reader = [&](const std::filesystem::path& file, std::size_t) {
    return held(files, file);
  };
  LoadedLesson loaded = parse_lesson(text, name, vocabulary(), reader);
  if (!loaded.lesson) throw std::runtime_error(lines(loaded.problems));
  return *std::move(loaded.lesson);
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
  lesson.x() = plain.x();
  lesson.y() = plain.y();
  lesson.options.start = plain.options.start;
  lesson.path_of_shapes.reset();
  lesson.questions.clear();
  lesson.expect = {};
  lesson.expect.stop = gjk::StopReason::repeated_support;
  for (LessonView& view : lesson.views) view.camera.reset();
  if (lesson.x().vertices.size() * lesson.y().vertices.size() > kMostPairs) {
    for (LessonView& view : lesson.views) view.effects.clear();
  }
  change(name, lesson);
  session_.fit();
  session_.go_to(session_.frame_count() - 1);
}

/// Traces of cases in the plane or in space, as `gjkscope trace --json` prints them.
std::string Player::traced_cases(const Asked& asked) {
  const auto scalar = value_of<ScalarKind>(asked.text("scalar"));
  if (!scalar) throw std::runtime_error("there is no such scalar");
  Json traces = Json::array();
  for (const ReadCase& read :
       parse_cases(asked.text("text"), asked.text("name"), gjk::kMaxDimension)) {
    if (!read.problems.empty()) throw std::runtime_error(lines(read.problems));
    traces.push_back(read.value ? trace_json(traced(*read.value, read.name, *scalar))
                                : trace_json(traced(*read.in_space, read.name, *scalar)));
  }
  return dumped({{"traces", std::move(traces)}});
}

void Player::set_layout(const Asked& asked) {
  constexpr double kLeast = 200.0;
  constexpr double kMost = 10000.0;
  const auto length = [&](const char* key) { return std::clamp(asked.real(key), kLeast, kMost); };
  theme_ = theme(asked.text("theme"));
  session_.set_page({length("width"), length("height"), 1.0, true});
  panel_room_ = length("panel");
  measured_ = -1;
  timeline_width_ = length("timeline");
}

bool Player::at_end() const { return session_.index() + 1 == session_.frame_count(); }

void Player::release() {
  session_.end_drag();
  drag_.reset();
  if (!session_.problem().empty()) throw std::runtime_error(session_.problem());
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
  const std::size_t body = of_x ? 0 : 1;
  const PositionedRun& run = session_.run().run(session_.frame());
  const auto& world = of_x ? run.x().world : run.y().world;
  session_.drag([&](Lesson& lesson) {
    if (!is_vertex || world.size() == 1) return edit::move_shape(lesson, body, by);
    const int index = of_x ? subject.x : subject.y;
    edit::put_vertex(lesson, body, index, run.bodies[body].placement, to_view(stage, at));
  });
  drag.last = at;
}

/// Refuses what a lesson file could not say, with the loader's words.
void Player::change(const std::string& name, const Lesson& lesson) {
  if (!session_.edit(name, lesson))
    throw std::runtime_error(fmt::format("{}: {}", name, session_.problem()));
}

/// Typed coordinates are read as those of a case: decimal, or hex like 0x1.8p-1.
void Player::put_vertex(const Asked& asked) {
  const std::size_t body = asked.shape();
  const int index = asked.whole("index");
  Lesson lesson = session_.lesson();
  std::vector<Vector2d>& vertices = lesson.bodies[body].vertices;
  if (index < 0 || index >= static_cast<int>(vertices.size()))
    throw std::runtime_error("there is no such vertex");
  Json point = Json::array();
  point.push_back(asked.text("x"));
  point.push_back(asked.text("y"));
  const std::string typed = fmt::format(R"({{"a": [{}], "b": [[0, 0]]}})", dumped(point));
  const std::vector<ReadCase> read = parse_cases(typed, "typed");
  if (!read.front().value) {
    throw std::runtime_error(
        fmt::format("({}, {}) is no point: expected numbers like 0.25, 1e-6 or 0x1.8p-1",
                    asked.text("x"), asked.text("y")));
  }
  vertices[static_cast<std::size_t>(index)] = read.front().value->a.front();
  change("type a value", lesson);
}

/// Moves a vertex, or the shape where `index` is -1, by pixels of the first view of the world: what
/// a drag does, from the keyboard.
void Player::nudge(const Asked& asked) {
  const std::size_t body = asked.shape();
  const int index = asked.whole("index");
  const std::vector<LessonPictures::Stage> stages = session_.views();
  const LessonPictures::Stage& stage = stages.front();
  const double unit = stage.camera.height / stage.card.size().y();
  const Vector2d by = unit * Vector2d(asked.real("right"), asked.real("up"));
  const PositionedRun& run = session_.run().run(session_.frame());
  const auto& world = run.bodies[body].world;
  if (index >= static_cast<int>(world.size())) throw std::runtime_error("there is no such vertex");
  Lesson lesson = session_.lesson();
  if (index < 0 || world.size() == 1) {
    edit::move_shape(lesson, body, by);
  } else {
    edit::put_vertex(lesson, body, index, run.bodies[body].placement,
                     world[static_cast<std::size_t>(index)] + by);
  }
  change("move", lesson);
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
  change("numerics", lesson);
}

/// The subjects that belong to the one at a place, as the SVG names them.
std::string Player::linked(const Point& at) {
  const Subject pointed = subject_at(session_.picture(), fonts_, at, kSlack);
  std::set<std::string> names;
  for (const Mark& mark : session_.picture().marks) {
    if (is_linked(mark.subject, pointed)) names.insert(subject_name(mark.subject));
  }
  return dumped({{"of", subject_name(pointed)}, {"linked", names}});
}

Picture Player::panel(const Frame& frame, double width) {
  Picture picture{width, panel_height_, {}, 0.0, {}};
  const Rect card{{0.0, 0.0}, {width, panel_height_}};
  picture.marks = panel_marks(session_.run(), session_.effects(), frame, fonts_, card);
  picture.marks.insert(picture.marks.begin(), {"card", Box{card, 10.0}, -1, {}});
  enlarge_small_type(picture, fonts_);
  return picture;
}

/// One size for the panels of all frames: as wide as there is room, wider where texts would meet or
/// stick out (a page squeezes that), and as high as the highest.
void Player::measure_panel() {
  if (session_.lesson().panel.empty()) return;
  const std::vector<Frame>& frames = session_.run().frames;
  panel_height_ = 0.0;
  panel_width_ = panel_room_;
  for (const double wider : {368.0, 424.0}) {
    const bool all_fit = std::all_of(frames.begin(), frames.end(), [&](const Frame& frame) {
      return fits(panel(frame, panel_width_), fonts_);
    });
    if (all_fit) break;
    panel_width_ = std::max(panel_width_, wider);
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
  enlarge_small_type(picture, fonts_);
  return picture;
}

/// The shortest way out of the other shape, where the world is shown.
void Player::draw_depth(Picture& picture) {
  const LessonPictures::Stage stage = session_.views().front();
  const LessonRun& run = session_.run();
  if (stage.kind != ViewKind::world) return;
  const depth::Result<double>* depth = depth_on_overlap(session_.effects(), run, session_.frame());
  if (depth == nullptr) return;
  const StageMap map(stage.card, stage.camera);
  const Point from = map(depth->x);
  const Point to = map(depth->x + depth->translation);
  picture.marks.push_back({"direction", Arrow{from, to}, 0, {}});
  const Text label{{stage.card.min.x() + 14.0, stage.card.max.y() - 14.0},
                   "Arrow: the shortest way out for " + run.lesson.x().name,
                   type::kViewTitle};
  picture.marks.push_back({"direction.label", label, -1, {}});
}

std::string Player::shown() {
  if (!opened_) return dumped({{"count", 0}});
  if (!session_.is_dragging() && std::exchange(measured_, session_.version()) != session_.version())
    measure_panel();
  const FrameText& text = session_.text();
  const LessonRun& run = session_.run();
  const Lesson& lesson = session_.lesson();
  Picture stage = session_.picture();
  if (shows_depth_ && at_end()) draw_depth(stage);
  enlarge_small_type(stage, fonts_);
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
    out["panel"] = to_svg(panel(session_.frame(), panel_width_), fonts_, theme_,
                          "Pseudocode and values: " + values);
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
  out["outcome"] = outcome(session_);
  out["numerics"] = numerics(lesson);
  out["choices"] = {{"scalar", names_of<ScalarKind>()},
                    {"direction", names_of<gjk::DirectionRule>()},
                    {"regions", names_of<gjk::RegionOrder>()}};
  if (std::max(lesson.x().vertices.size(), lesson.y().vertices.size()) <= edit::kMostEditable)
    out["shapes"] = {{"x", shape_json(lesson.x())}, {"y", shape_json(lesson.y())}};
  return dumped(out);
}

}  // namespace gjkscope
