// Cases (src/lesson/case.hpp) in the window: opened, pasted, compared with what they expect, saved.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app.hpp"
#include "base/file.hpp"
#include "files.hpp"
#include "lesson/load.hpp"
#include "outlines/polygon.hpp"
#include "picture/words.hpp"
#include "session/edit.hpp"
#include "subjects/shape_hull/shape_hull.hpp"
#include "subjects/subjects.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

namespace fs = std::filesystem;

/// Text as prose that stands for itself.
std::string as_prose(std::string_view text) {
  std::string out;
  for (const char c : text) {
    out += c;
    if (c == '{' || c == '}') out += c;
  }
  return out;
}

/// A sentence, with a full stop where it has none.
std::string sentence(std::string text) {
  if (!text.empty() && std::string_view(".!?").find(text.back()) == std::string_view::npos)
    text += '.';
  return text;
}

/// True if the vertices in their order are no convex outline; GJK sees their hull.
bool shows_another_outline(const std::vector<Eigen::Vector2d>& vertices) {
  return vertices.size() > 3 && !is_convex(vertices);
}

}  // namespace

App::ReadLesson App::read_case(std::string_view text, const std::string& file) const {
  const std::vector<ReadCase> cases = parse_cases(text, file, 3);
  const ReadCase& first = cases.front();
  if (!first.problems.empty()) return {std::nullopt, first.problems, cases.size()};
  const bool has_name = first.name != file;
  std::optional<Lesson> lesson =
      lesson_around(first, has_name ? first.name : fs::path(file).stem().string());
  if (!lesson)
    return {std::nullopt, load_lesson(opening_lesson(paths_.share), vocabulary()).problems};
  const std::string why = sentence(first.notes.why.empty() ? "Shapes of a case" : first.notes.why);
  lesson->prose = as_prose(why);
  if (!first.notes.source.empty()) {
    lesson->source = first.notes.source;
    lesson->prose += as_prose(" Source: " + sentence(first.notes.source));
  }
  std::string hulls;
  for (const LessonShape& shape : lesson->bodies) {
    if (first.in_space || !shows_another_outline(in_plane(shape.vertices))) continue;
    hulls += (hulls.empty() ? "" : " and of ") + shape.name;
    for (LessonView& view : lesson->views) {
      if (view.kind == ViewKind::world && !view.calls_for(ShapeHull::kName))
        view.effects.emplace_back(ShapeHull::kName);
    }
  }
  if (!hulls.empty()) lesson->prose += fmt::format(" GJK sees the hull of {}.", hulls);
  const std::size_t pairs = lesson->x().vertices.size() * lesson->y().vertices.size();
  if (pairs > edit::kMostPairs) {
    lesson->prose +=
        fmt::format(" Z has {} differences: of its outline only what the run finds is drawn.",
                    grouped(static_cast<double>(pairs)));
  }
  NotedCase noted{lesson->x().vertices, lesson->y().vertices, first.notes};
  return {std::move(lesson), {}, cases.size(), std::move(noted), first.understood};
}

void App::note(std::optional<NotedCase> noted) {
  constexpr std::size_t kMostNoted = 20;
  if (!noted) return;
  noted_cases_.insert(noted_cases_.begin(), *std::move(noted));
  if (noted_cases_.size() > kMostNoted) noted_cases_.pop_back();
}

void App::open_pasted(const std::string& text, const std::string& name) {
  // A lesson's text is one, too.
  LoadedLesson loaded = parse_lesson(text, "pasted.toml", vocabulary());
  if (loaded.lesson) {
    loaded.lesson->path.clear();
    (void)show(*std::move(loaded.lesson), {}, name, true);
    return;
  }
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  const bool is_json = begin != std::string::npos && (text[begin] == '{' || text[begin] == '[');
  if (!is_json && text.find_first_of("0123456789") == std::string::npos) {
    return say(begin == std::string::npos ? "there is no text to paste"
                                          : "what was pasted is no case; a case looks like "
                                            R"({"a": [[0, 0], [1, 0]], "b": [[3, 1], [4, 2]]})",
               true);
  }
  ReadLesson read = read_case(text, name);
  if (!read.lesson) return say(read.problems);
  note(std::move(read.noted));
  if (!show(*std::move(read.lesson), {}, name, true)) return;
  if (read.cases > 1) say(fmt::format("the first of {} cases", read.cases));
  if (!read.understood.empty()) say(read.understood);
}

std::optional<Lesson> App::lesson_around(const ReadCase& read, const std::string& name) const {
  // A case has no words and no views: it is shown as the opening lesson shows its shapes.
  const fs::path file = opening_lesson(paths_.share);
  LoadedLesson loaded = parse_lesson(read_whole(file), file, vocabulary());
  if (!loaded.lesson) return std::nullopt;
  Lesson lesson = edit::with_shapes(*std::move(loaded.lesson), read);
  lesson.id = name;
  lesson.path.clear();
  lesson.title = name;
  lesson.prose = "Shapes of a case.";
  lesson.source.clear();
  lesson.options = {};
  return lesson;
}

const CaseNotes* App::case_notes() const {
  const Lesson& lesson = session_.lesson();
  const auto found =
      std::find_if(noted_cases_.begin(), noted_cases_.end(), [&](const NotedCase& each) {
        return each.x == lesson.x().vertices && each.y == lesson.y().vertices;
      });
  return found == noted_cases_.end() ? nullptr : &found->notes;
}

std::string App::compared_with_case() const {
  const CaseNotes* notes = case_notes();
  const WideTrace& trace = session_.run().run(session_.frame()).trace;
  if (notes == nullptr || trace.is_empty()) return "";
  const WideResult& result = trace.result;
  const bool overlaps = result.distance == 0.0;
  std::string text;
  if (notes->expected_overlap) {
    text = fmt::format("expected: {}; this run: {}", *notes->expected_overlap ? "overlap" : "apart",
                       *notes->expected_overlap == overlaps ? "the same"
                       : overlaps                           ? "overlap"
                                                            : "apart");
  }
  if (notes->expected_distance) {
    const double off = result.distance - *notes->expected_distance;
    text += fmt::format(
        "{}distance {}: {}", text.empty() ? "expected: " : "; ",
        number_text(*notes->expected_distance, hexadecimal),
        off == 0.0 ? "this run has exactly that" : fmt::format("this run is off by {:.3g}", off));
  }
  return text;
}

void App::save_case_to(const fs::path& file) {
  const PositionedRun& run = session_.run().run(session_.frame());
  try {
    const bool is_own = file == session_.file();
    std::string text =
        with_case(run, [&](const auto& shapes) { return case_json(shapes, session_.lesson().id); });
    std::string note;
    for (const std::string& there : is_own ? texts_to_keep(file) : std::vector<std::string>()) {
      if (parse_cases(there, file.string()).size() > 1) {
        return say(fmt::format("{} holds more than one case: save this one as a file of its own",
                               file.filename().string()),
                   true);
      }
      const std::optional<std::string> kept =
          with_case(run, [&](const auto& shapes) { return case_json_kept(there, shapes); });
      if (!kept) continue;
      if (there.find("\"expected_") != std::string::npos &&
          kept->find("\"expected_") == std::string::npos)
        note = "; what it expected was of other shapes, and is left out";
      text = *kept;
      break;
    }
    note = keep_beside(file) + note;
    write_whole(file, std::string_view(text));
    files_.note_written(file, std::move(text));
    // A lesson is more than its shapes: it stays unsaved, in its own file.
    const bool is_case = session_.file().empty() || session_.file().extension() == ".json";
    if (is_case) {
      is_missing_ = false;
      looked_at_ = file;
      session_.mark_saved(file, session_.lesson());
      remember_recent(file);
      keep_unsaved();
    }
    say(fmt::format("saved {}{}{}", is_case ? "" : "the shapes in ", file.string(), note));
  } catch (const std::runtime_error& error) {
    say(error.what(), true);
  }
}

}  // namespace gjkscope
