#include "subjects/two_runs/log_lesson.hpp"

#include <fmt/format.h>

#include "judge/judge.hpp"
#include "lesson/names.hpp"
#include "lesson/save.hpp"
#include "run/run.hpp"
#include "subjects/second_run/table.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace {

LessonShape shape_of(const std::vector<judging::Point>& points, std::string name, char letter) {
  LessonShape shape;
  shape.name = std::move(name);
  shape.vertex_names = numbered_names(letter, points.size());
  for (const judging::Point& p : points)
    shape.vertices.push_back(in_space(Eigen::Vector2d(p.head<2>())));
  return shape;
}

}  // namespace

std::optional<LoadedLesson> log_as_lesson(std::string_view text,
                                          const std::filesystem::path& file) {
  if (text.substr(0, text.find('\n')).find("\"gjk_log\"") == std::string_view::npos)
    return std::nullopt;
  judging::ReadLog read = judging::read_log(text, file.string());
  if (!read.log) return LoadedLesson{std::nullopt, std::move(read.problems)};
  if (read.log->dimension != 2) {
    return LoadedLesson{std::nullopt,
                        {{file.string(), 1, 1, "a log in space, which is not drawn",
                          "a log in the plane; `gjkscope judge` checks both", ""}}};
  }
  Lesson lesson;
  lesson.id = file.stem().string();
  lesson.title = fmt::format("A log of {} {}", read.log->iterations.size(),
                             read.log->iterations.size() == 1 ? "iteration" : "iterations");
  lesson.prose = "Left is GJK from where the log starts, right the run of the log.";
  lesson.x() = shape_of(read.log->x, "X", 'x');
  lesson.y() = shape_of(read.log->y, "Y", 'y');
  lesson.tour = "two-runs";
  lesson.views = {{ViewKind::difference, "GJK: Z = Y − X", {}, {}},
                  {ViewKind::difference, "The log: Z = Y − X", {}, {}}};
  lesson.panel = {"both-runs", "two-answers"};
  LessonSecond second;
  second.log = std::make_shared<const judging::Log>(*std::move(read.log));
  lesson.settings = TourSettings(std::move(second));
  lesson.settings.file = NamedFile{file.filename().string(), std::make_shared<std::string>(text)};
  lesson.expect.stop = name_of(run_lesson(lesson).runs.front().trace.result.stop);
  // The loader says what a lesson cannot hold.
  return parse_lesson(lesson_toml(lesson), file, vocabulary(),
                      [&](const std::filesystem::path&, int) {
                        return FileText{.text = std::string(text), .problem = {}};
                      });
}

}  // namespace gjkscope
