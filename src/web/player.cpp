#include "web/player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "answers/answers.hpp"
#include "judge/log.hpp"
#include "lesson/load.hpp"
#include "lesson/names.hpp"
#include "lesson/save.hpp"
#include "paint/svg.hpp"
#include "picture/tween.hpp"
#include "run/trace_json.hpp"
#include "run/trail.hpp"
#include "session/case_lesson.hpp"
#include "session/edit.hpp"
#include "session/hit.hpp"
#include "subjects/run/code.hpp"
#include "subjects/subjects.hpp"
#include "subjects/two_runs/log_lesson.hpp"
#include "web/json.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector2d;
using Kind = Subject::Kind;

constexpr double kFingerSlack = 24.0;  // a finger hides what it touches

void check_length(const std::string& text, const std::string& name) {
  constexpr std::size_t kMost = 1 << 21;  // bytes of a case; as of a lesson file
  if (text.size() <= kMost) return;
  throw std::runtime_error(
      fmt::format("{}: {} bytes are too many; expected at most {}", name, text.size(), kMost));
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
    if (!at(key).is_string()) throw std::runtime_error(fmt::format("'{}' is no string", key));
    return at(key).get<std::string>();
  }
  [[nodiscard]] bool flag(const char* key) const {
    if (!at(key).is_boolean())
      throw std::runtime_error(fmt::format("'{}' is neither true nor false", key));
    return at(key).get<bool>();
  }
  [[nodiscard]] std::vector<bool> flags(const char* key) const {
    const Json& list = at(key);
    if (!list.is_array() ||
        !std::all_of(list.begin(), list.end(), [](const Json& each) { return each.is_boolean(); }))
      throw std::runtime_error(fmt::format("'{}' is no list of true and false", key));
    return list.get<std::vector<bool>>();
  }
  [[nodiscard]] double real(const char* key) const {
    constexpr double kMost = 1e9;
    const Json& value = at(key);
    if (!value.is_number() || !(std::abs(value.get<double>()) <= kMost))
      throw std::runtime_error(fmt::format("'{}' is no number from -1e9 to 1e9", key));
    return value.get<double>();
  }
  template <class E>
  [[nodiscard]] E named(const char* key) const {
    const auto value = value_of<E>(text(key));
    if (value) return *value;
    throw std::runtime_error(fmt::format("there is no {} '{}'; expected one of {}", key, text(key),
                                         fmt::join(names_of<E>(), ", ")));
  }
  [[nodiscard]] int whole(const char* key) const { return static_cast<int>(std::floor(real(key))); }
  [[nodiscard]] Point point() const { return {real("x"), real("y")}; }
  [[nodiscard]] std::size_t shape() const { return text("shape") == "x" ? 0 : 1; }
};

FileText Player::held(const Files& files, const std::filesystem::path& file) {
  const auto found = files.find(file.filename().string());
  if (found == files.end()) return {std::nullopt, "the page does not hold this file"};
  return {found->second, {}};
}

Player::Player(std::array<FaceBytes, kFaceCount> fonts, std::map<std::string, std::string> themes,
               std::string_view terms)
    : fonts_(std::move(fonts)),
      theme_texts_(std::move(themes)),
      theme_(theme("light")),
      terms_(parse_terms(terms, "assets/terms.toml")),
      session_(fonts_, [this](const std::filesystem::path& file,
                              std::size_t) { return held(files_, file); }),
      hand_(session_, fonts_) {}

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
      {"practise", [](Player& p, const Asked& a) { p.practise(a); }},
  };
  static const std::map<std::string_view, Reply> changes = {
      {"replace", [](Player& p, const Asked& a) { p.replace(a); }},
      {"go", [](Player& p, const Asked& a) { p.session_.go_to(a.whole("to")); }},
      {"step", [](Player& p, const Asked& a) { p.step(a.whole("by")); }},
      {"iteration", [](Player& p, const Asked& a) { p.session_.step_iteration(a.whole("by")); }},
      {"phase", [](Player& p, const Asked& a) { p.go_to_phase(a.whole("phase")); }},
      {"press", [](Player& p, const Asked& a) { p.press(a); }},
      {"move",
       [](Player& p, const Asked& a) { p.hand_.move(a.point(), a.json.contains("snaps")); }},
      {"release", [](Player& p, const Asked&) { p.let_go(false); }},
      {"cancel", [](Player& p, const Asked&) { p.let_go(true); }},
      {"vertex", [](Player& p, const Asked& a) { p.put_vertex(a); }},
      {"add", [](Player& p, const Asked& a) { p.add_vertex(a); }},
      {"nudge", [](Player& p, const Asked& a) { p.nudge(a); }},
      {"eye", [](Player& p, const Asked& a) { p.set_eye(a); }},
      {"numerics", [](Player& p, const Asked& a) { p.set_numerics(a); }},
      {"listing", [](Player& p, const Asked& a) { p.set_language(a); }},
      {"undo", [](Player& p, const Asked&) { p.session_.undo(Session::Cameras::as_then); }},
      {"redo", [](Player& p, const Asked&) { p.session_.redo(Session::Cameras::as_then); }},
      {"reset", [](Player& p, const Asked&) { p.reset(); }},
      {"restore", [](Player& p, const Asked& a) { p.restore(a); }},
      {"predict", [](Player& p, const Asked& a) { p.session_.set_predicting(a.flag("on")); }},
      {"answer", [](Player& p, const Asked& a) { p.take_answer(a); }},
      {"task", [](Player& p, const Asked&) { p.next_task(); }},
  };
  using Tell = std::string (*)(Player&, const Asked&);
  static const std::map<std::string_view, Tell> tells = {
      {"case", [](Player& p, const Asked& a) { return p.shown(p.open_case(a)); }},
      {"point", [](Player& p, const Asked& a) { return p.linked(a.point()); }},
      {"choice", [](Player& p, const Asked& a) { return p.choice_at(a); }},
      {"lesson", [](Player& p, const Asked&) { return p.lesson_file(); }},
      {"vertices", [](Player& p, const Asked&) { return p.all_vertices(); }},
      {"code", [](Player& p, const Asked&) { return p.code_page(); }},
      {"trace", [](Player& p, const Asked&) { return p.trace(); }},
      {"frame", [](Player& p, const Asked&) { return p.whole_frame(); }},
      {"print", [](Player& p, const Asked&) { return p.for_paper(); }},
      {"tween", [](Player& p, const Asked& a) { return p.on_the_way(a); }},
  };
  try {
    const Asked asked{Json::parse(request)};
    if (asked.json.contains("command")) return printed(asked);
    const std::string what = asked.text("do");
    const auto first = before_all.find(what);
    const auto tour = changes.find(what);
    const auto tell = tells.find(what);
    if (first == before_all.end() && tour == changes.end() && tell == tells.end())
      throw std::runtime_error(fmt::format("there is no request '{}'", what));
    if (first == before_all.end() && !opened_)
      throw std::runtime_error("no lesson is open; expected the request 'open'");
    if (tell != tells.end()) return tell->second(*this, asked);
    (first != before_all.end() ? first : tour)->second(*this, asked);
    return shown();
  } catch (const std::exception& error) {
    return dumped({{"problem", error.what()}});
  }
}

std::string Player::lesson_file() const {
  return dumped({{"lesson", lesson_toml(session_.lesson())}, {"id", session_.lesson_id()}});
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

/// The stage on its way from what was shown before.
std::string Player::on_the_way(const Asked& asked) const {
  const Picture between = tween(stage_before_, stage_, asked.real("share"));
  return dumped({{"stage", stage_svg(between)}});
}

void Player::go_to_phase(int phase) {
  const std::span<const std::string_view> phases = session_.run().tour->algorithm->phases;
  if (phase < 0 || phase >= static_cast<int>(phases.size())) {
    throw std::runtime_error(
        fmt::format("this run has no phase {}; expected 0 to {}", phase, phases.size() - 1));
  }
  const std::string_view name = phases[phase];
  if (!session_.go_to_next(name))
    throw std::runtime_error(fmt::format("this run has no step '{}'", name));
}

/// Nobody steps past a question: it is answered, or gone back from.
void Player::step(int by) {
  const int one = by < 0 ? -1 : 1;
  for (; by != 0; by -= one) {
    if ((one > 0 && session_.question() != nullptr) || !session_.step(one)) return;
  }
}

void Player::reset() {
  if (practising_) return show_task();
  session_.edit("reset", *opened_);
  session_.fit();
}

/// Takes the `history` of earlier answers, with its lessons, after another player was given up.
void Player::restore(const Asked& asked) {
  const auto kept = [&](const Json& entry) {
    return Session::KeptLesson{
        {entry.at("id").get<long>(), entry.at("change").get<std::string>()},
        parsed(entry.at("lesson").get<std::string>(), asked.text("name"), files_)};
  };
  const auto list = [&](const char* key) {
    std::vector<Session::KeptLesson> entries;
    for (const Json& entry : asked.at(key)) entries.push_back(kept(entry));
    return entries;
  };
  if (!session_.restore(list("past"), kept(asked.at("now")), list("future")))
    throw std::runtime_error(session_.problem());
  session_.set_predicting(asked.flag("predicting"));
  session_.go_to(asked.whole("to"));
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
  practising_.reset();
  hand_.selected = {};
  shows_depth_ = asked.json.contains("depth");
}

/// Tasks of a chapter; `answers`: of those before, whether they were answered rightly.
void Player::practise(const Asked& asked) {
  const std::vector<int>& chapters = practice::chapters_with_practice();
  const int chapter = asked.whole("chapter");
  if (std::find(chapters.begin(), chapters.end(), chapter) == chapters.end()) {
    throw std::runtime_error(fmt::format("chapter {} has no practice; expected one of {}", chapter,
                                         fmt::join(chapters, ", ")));
  }
  const double seed = asked.real("seed");
  if (seed < 0.0) throw std::runtime_error("'seed' is negative");
  practising_.emplace(
      practice::Practice(chapter, static_cast<std::uint64_t>(seed), asked.flags("answers")));
  show_task();
}

void Player::next_task() {
  if (!practising_ || !practising_->outcome(session_))
    throw std::runtime_error("no task was answered");
  practising_->next(session_);
  show_task();
}

/// The task has a history of its own.
void Player::show_task() {
  opened_ = practising_->practice().task().lesson;
  if (!session_.restore({}, {{session_.lesson_id() + 1, ""}, *opened_}, {}))
    throw std::runtime_error(session_.problem());
  session_.fit();
  hand_.selected = {};
  practising_->begin(session_);
}

/// Another lesson as a change of this one: what a link holds.
void Player::replace(const Asked& asked) {
  const Lesson lesson = parsed(asked.text("lesson"), asked.text("name"), files_);
  if (!session_.edit("follow a link", lesson))
    throw std::runtime_error(fmt::format("{}: {}", asked.text("name"), session_.problem()));
  session_.fit();
}

Lesson Player::parsed(const std::string& text, const std::string& name, const Files& files) {
  check_length(text, name);
  const FileReader reader = [&](const std::filesystem::path& file, std::size_t) {
    return held(files, file);
  };
  LoadedLesson loaded = parse_lesson(text, name, vocabulary(), reader);
  if (!loaded.lesson) throw std::runtime_error(to_string(loaded.problems));
  return *std::move(loaded.lesson);
}

/// The lesson goes on with other shapes; they are shown as its own were.
std::string Player::open_case(const Asked& asked) {
  const std::string text = asked.text("text");
  const std::string name = asked.text("name");
  check_length(text, name);
  if (const std::optional<LoadedLesson> log = log_as_lesson(text, name)) {
    if (!log->lesson) throw std::runtime_error(to_string(log->problems));
    files_[std::filesystem::path(name).filename().string()] = text;
    change("open a log", *log->lesson);
    session_.fit();
    session_.go_to(0);
    return log->lesson->title;
  }
  const std::vector<ReadCase> cases =
      parse_cases(text, name, gjk::kMaxDimension, std::nullopt, CaseLimits::of_lessons());
  if (!cases.front().problems.empty()) throw std::runtime_error(to_string(cases.front().problems));
  const ReadCase& read = cases.front();
  const Lesson lesson = edit::with_shapes(session_.lesson(), read);
  if (!session_.edit(name, lesson)) {
    const std::vector<Problem> problems = why_case_is_not_said(lesson, read, name);
    if (problems.empty()) throw std::runtime_error(fmt::format("{}: {}", name, session_.problem()));
    throw std::runtime_error(to_string(problems));
  }
  session_.fit();
  session_.go_to(answering_index(session_.run()));
  return read.understood;
}

std::string Player::command(std::string_view request) {
  try {
    return printed({Json::parse(request)});
  } catch (const std::exception& error) {
    return dumped({{"problem", error.what()}});
  }
}

/// A lesson's text, which a name that ends with ".toml" tells, has a trace, too.
std::string Player::printed(const Asked& asked) {
  const std::string what = asked.text("command");
  const std::string text = asked.text("text");
  const std::string name = asked.text("name");
  const auto said = [](const Printed& all) { return dumped({{"out", all.out}, {"err", all.err}}); };
  if (what == "judge") {
    const judging::ReadLog read = judging::read_log(text, name);
    if (!read.log) return said({{}, to_string(read.problems) + '\n'});
    return said({{judgement_json(name, judging::judge(*read.log))}, {}});
  }
  if (what != "solve" && what != "trace")
    throw std::runtime_error(
        fmt::format("there is no command '{}'; expected solve, trace or judge", what));
  if (what == "trace" && name.ends_with(".toml")) {
    const LessonRun run = run_lesson(parsed(text, name, {}));
    return said(print_trace(traced(run), true));
  }
  const CaseOptions options{asked.named<ScalarKind>("scalar"), asked.named<ModelMethod>("method")};
  const auto cases = [&](models::Needs needs) {
    return parse_cases(text, name, gjk::kMaxDimension, needs);
  };
  if (what == "solve") return said(print_answers(cases(needs_of(options.method)), options));
  if (options.method == ModelMethod::brute) throw std::runtime_error("brute force has no trace");
  return said(print_traces(cases(needs_of_trace(options.method)), options, true));
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

void Player::let_go(bool as_it_was) {
  if (!(as_it_was ? hand_.cancel() : hand_.release())) throw std::runtime_error(session_.problem());
}

void Player::press(const Asked& asked) {
  constexpr double kHandleSlack = 15.0;  // so that the handle is as large as other buttons
  const Point at = asked.point();
  const bool by_finger = asked.json.contains("finger");
  if (asked.json.contains("ground")) {
    hand_.press({}, at);
    return;
  }
  Subject subject = gjkscope::held(hand_.subject_at(at, 2.0 * Hand::kSlack));
  // Beside a shape; in it, small shapes on a phone could not be moved as a whole.
  if (by_finger && !is_shape(subject) && subject.kind != Kind::difference)
    subject = hand_.subject_at(at, kFingerSlack);
  hand_.press(subject, at, by_finger ? kHandleSlack : Hand::kSlack);
}

/// Refuses what a lesson file could not say, with the loader's words.
void Player::change(const std::string& name, const Lesson& lesson) {
  if (!session_.edit(name, lesson)) throw std::runtime_error(session_.problem());
}

namespace {

/// A typed coordinate, read as one of a case; `name` is what it is called: "x of K".
double coordinate(const std::string& text, const std::string& name) {
  const Json holder = {{"a", Json::array({Json::array({text, 0})})},
                       {"b", Json::array({Json::array({0, 0})})}};
  const std::vector<ReadCase> read = parse_cases(dumped(holder), name);
  if (read.front().value) return read.front().value->a.front().x();
  throw std::runtime_error(fmt::format(
      "{}: '{}' is no number; expected one like 0.25, 1e-6 or 0x1.8p-1", name, text.substr(0, 40)));
}

std::runtime_error no_vertex(int index, std::size_t count) {
  return std::runtime_error(
      fmt::format("the shape has no vertex {}; expected 0 to {}", index, count - 1));
}

}  // namespace

/// Typed coordinates are read as those of a case: decimal, or hex like 0x1.8p-1.
void Player::put_vertex(const Asked& asked) {
  const std::size_t body = asked.shape();
  const int index = asked.whole("index");
  Lesson lesson = session_.lesson();
  std::vector<Eigen::Vector3d>& vertices = lesson.bodies[body].vertices;
  if (index < 0 || index >= static_cast<int>(vertices.size()))
    throw no_vertex(index, vertices.size());
  const std::string& name = lesson.bodies[body].vertex_names[index];
  Eigen::Vector3d& vertex = vertices[index];
  for (int axis = 0; axis < lesson.dimension; ++axis) {
    const std::string key(1, "xyz"[axis]);
    if (asked.json.contains(key))
      vertex[axis] = coordinate(asked.text(key.c_str()), fmt::format("{} of {}", key, name));
  }
  change("type a value", lesson);
}

/// A double click: beside an edge it adds a vertex, elsewhere nothing.
void Player::add_vertex(const Asked& asked) {
  const auto added = hand_.with_vertex(asked.point(), asked.json.contains("snaps"));
  if (!added || is_vertex(hand_.subject_at(asked.point()))) return;
  if (!added->problem.empty()) throw std::runtime_error(added->problem);
  change("add a vertex", added->lesson);
  hand_.selected = added->vertex;
}

/// Moves a vertex, or the shape where `index` is -1, by pixels of the first view of the world: what
/// a drag does, from the keyboard.
void Player::nudge(const Asked& asked) {
  const std::size_t body = asked.shape();
  const int index = asked.whole("index");
  const std::vector<LessonPictures::ShownView> views = session_.views();
  const LessonPictures::ShownView& view = views.front();
  const Vector2d right_and_up = view.camera.units_per_pixel(view.card.size().y())
                                    .cwiseProduct(Vector2d(asked.real("right"), asked.real("up")));
  const Eigen::Vector3d by = along_screen(view.camera, right_and_up);
  const PositionedRun& run = session_.run().run(session_.frame());
  const std::size_t count = run.bodies[body].world.size();
  if (index >= static_cast<int>(count)) throw no_vertex(index, count);
  Lesson lesson = session_.lesson();
  edit::nudge(lesson, body, index, run, by);
  change("move", lesson);
}

/// By degrees from where it stands, or to one side: "front", "side", "top", or "across" d.
void Player::set_eye(const Asked& asked) {
  const std::optional<Eye> now = session_.eye();
  if (!now) throw std::runtime_error("the lesson is in the plane, which has one side to be seen");
  if (!asked.json.contains("to")) {
    return session_.set_eye(
        {now->azimuth + asked.real("azimuth"), now->elevation + asked.real("elevation")});
  }
  const std::string to = asked.text("to");
  const std::optional<Eye> eye = eye_from(to, session_.run(), session_.frame());
  if (!eye) {
    throw std::runtime_error(
        fmt::format("there is no side '{}'; expected one of: {}", to, fmt::join(kSides, ", ")));
  }
  session_.set_eye(*eye);
}

void Player::set_language(const Asked& asked) {
  Lesson lesson = session_.lesson();
  const auto language = value_of<Language>(asked.text("language"));
  if (!language)
    throw std::runtime_error(fmt::format("there is no language '{}'", asked.text("language")));
  const auto listing = code::in_language(lesson, *language);
  if (!listing) throw std::runtime_error("the lesson has no listing with code");
  lesson.listing = *listing;
  change("listing", lesson);
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

std::optional<PointedChoice> Player::pointed(const Asked& asked) {
  const double slack = asked.json.contains("finger") ? kFingerSlack : Hand::kSlack;
  return pointed_choice(session_, hand_, hand_.subject_at(asked.point(), slack), asked.point());
}

/// The choice that lies at a place of the picture, and of a pair which half.
std::string Player::choice_at(const Asked& asked) {
  const std::optional<PointedChoice> found = pointed(asked);
  Json out = Json::object();
  if (found) out["choice"] = found->choice;
  if (found && found->half) out["half"] = *found->half;
  return dumped(out);
}

/// A choice; where it was pointed at, the place goes with it.
void Player::take_answer(const Asked& asked) {
  const std::string choice = asked.text("choice");
  std::optional<Eigen::Vector2d> place;
  if (asked.json.contains("x")) {
    const std::optional<PointedChoice> found = pointed(asked);
    if (found && found->choice == choice) place = found->place;
  }
  session_.answer(choice, place);
}

/// The subjects that belong to the one at a place, as the SVG names them; and the names that appear
/// where a hand comes near a vertex, as an SVG to lie on the stage, without which it stays.
std::string Player::linked(const Point& at) {
  const Picture before = session_.picture();
  const Subject pointed = hand_.is_on_handle(at) ? hand_.selected : hand_.subject_at(at);
  session_.point_at({hand_.named_at(at, pointed)});
  Picture more = session_.picture();
  session_.point_at({});
  std::set<std::string> names;
  for (const Mark& mark : more.marks) {
    if (is_linked(mark.subject, pointed)) names.insert(subject_name(mark.subject));
  }
  Json out = {{"of", subject_name(pointed)}, {"linked", names}};
  auto next = before.marks.begin();
  std::erase_if(more.marks, [&](const Mark& mark) {
    const bool is_known = next != before.marks.end() && mark == *next;
    next += is_known ? 1 : 0;
    return is_known;
  });
  if (!more.marks.empty()) out["names"] = to_svg(more, fonts_, theme_, "", {}, true);
  return dumped(out);
}

}  // namespace gjkscope
