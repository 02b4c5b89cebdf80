// Listings that are code: the pages are the files that tests run, each step has its line, and
// values stand where the variables are.

#include "subjects/run/code.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "base/file.hpp"
#include "fonts.hpp"
#include "frames/frame.hpp"
#include "gjk/textbook.hpp"
#include "lessons.hpp"
#include "picture/text_box.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace code_test {

using testing::fonts;
using testing::shipped_lesson;

const std::vector<Language> kCode = {Language::cpp, Language::python};
/// A lesson for each listing that has code.
const std::vector<std::string> kLessons = {
    "segment-closest",  "triangle-interior",  "simplex",
    "nonconvex-vertex", "polygon-pseudocode", "polygons-gjk"};

LessonRun run_in(const std::string& id, Language language) {
  Lesson lesson = shipped_lesson(id);
  lesson.listing = code::in_language(lesson.listing, language).value();
  return run_lesson(std::move(lesson));
}

std::vector<FramePicture> frames_of(const LessonRun& run) {
  EffectGraph effects(run);
  return lesson_pictures(run, effects, fonts());
}

std::string texts_of(const FramePicture& frame, std::string_view role) {
  std::string out;
  for (const Mark& mark : frame.picture.marks) {
    const Text* text = std::get_if<Text>(&mark.shape);
    if (text && mark.role == role) out += (out.empty() ? "" : " ") + text->text;
  }
  return out;
}

TEST(Code, PagesAreTheFilesAndEachLineOfAStepIsThereOnce) {
  for (const Language language : kCode) {
    const code::Page page = code::page(language);
    SCOPED_TRACE(page.name);
    EXPECT_EQ(page.text,
              read_whole(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "tests" / "gjk" / page.name));
    EXPECT_EQ(80, std::count(page.text.begin(), page.text.end(), '\n'));
    for (const std::string_view marked : code::marked_lines(language)) {
      int found = 0;
      for (std::size_t at = 0; at < page.text.size(); at = page.text.find('\n', at) + 1) {
        const std::size_t begin = page.text.find_first_not_of(' ', at);
        found += page.text.substr(begin).starts_with(marked) ? 1 : 0;
      }
      EXPECT_EQ(1, found) << marked;
    }
  }
}

TEST(Code, ThereIsALessonForEachListingThatHasCode) {
  std::set<std::string> shown;
  std::set<std::string> have;
  for (const Language language : kCode) {
    for (const std::string& id : kLessons)
      shown.insert(code::in_language(shipped_lesson(id).listing, language).value());
  }
  for (const Listing* each : registered_listings()) {
    if (code::language_of(each->name) != Language::pseudocode) have.insert(std::string(each->name));
  }
  EXPECT_EQ(shown, have);
  EXPECT_EQ(std::nullopt, code::in_language("lin-canny", Language::python));
  EXPECT_EQ("gjk", code::in_language("gjk.py", Language::pseudocode));
}

TEST(Code, EachStepHasItsLineWithinThePanelAndNothingOverlaps) {
  for (const std::string& id : kLessons) {
    for (const Language language : kCode) {
      const LessonRun run = run_in(id, language);
      const std::vector<FramePicture> frames = frames_of(run);
      for (std::size_t i = 0; i < frames.size(); ++i) {
        SCOPED_TRACE(fmt::format("{} in {}, frame {}", id, code::page(language).name, i + 1));
        EXPECT_FALSE(texts_of(frames[i], "code.current").empty());
        std::vector<Rect> boxes;
        for (const Mark& mark : frames[i].picture.marks) {
          const Text* text = std::get_if<Text>(&mark.shape);
          const bool is_line = text && mark.role.starts_with("code");
          if (is_line) boxes.push_back(box_of(fonts(), *text));
        }
        for (std::size_t a = 0; a < boxes.size(); ++a) {
          EXPECT_LE(boxes[a].max.x(), 1280.0 - 32.0 - 12.0);
          EXPECT_LE(boxes[a].max.y(), 600.0);
          for (std::size_t b = 0; b < a; ++b) {
            const bool beside = boxes[a].min.x() >= boxes[b].max.x() - 0.1 ||
                                boxes[b].min.x() >= boxes[a].max.x() - 0.1;
            const bool below = boxes[a].min.y() >= boxes[b].max.y() - 0.1 ||
                               boxes[b].min.y() >= boxes[a].max.y() - 0.1;
            EXPECT_TRUE(beside || below);
          }
        }
      }
    }
  }
}

TEST(Code, ThePageTakesTheStepsThatTheFramesShow) {
  for (const char* id : {"polygon-pseudocode", "polygons-gjk"}) {
    const LessonRun run = run_in(id, Language::cpp);
    const WideTrace& trace = run.run(run.frames[0]).trace;
    const auto start = trace.initial.simplex.vertices[0].pair;
    const PositionedRun& shapes = run.run(run.frames[0]);
    const textbook::Output out =
        textbook::gjk({in_plane(shapes.x().world), in_plane(shapes.y().world), start.x, start.y});
    EXPECT_DOUBLE_EQ(trace.result.distance, out.distance);
    EXPECT_EQ(trace.result.iterations, out.iterations);
    ASSERT_EQ(static_cast<std::size_t>(trace.result.simplex.count), out.simplex.size());
    for (std::size_t i = 0; i < out.simplex.size(); ++i) {
      EXPECT_EQ(trace.result.simplex.vertices[i].pair.x, out.simplex[i].index_x);
      EXPECT_EQ(trace.result.simplex.vertices[i].pair.y, out.simplex[i].index_y);
    }
  }
}

TEST(Code, TheLineIsThatOfThePhase) {
  for (const Language language : kCode) {
    const bool is_cpp = language == Language::cpp;
    const std::map<std::string, std::string> kLines = {
        {"drop", "s = closest(s)"},
        {"support", is_cpp ? "const int far_x" : "far_x, far_y"},
        {"add", is_cpp ? "s.push_back(" : "s.append("},
        {"stop", is_cpp ? "if (v.index_x" : "if v.index_x"}};
    const LessonRun run = run_in("polygons-gjk", language);
    int seen = 0;
    const std::vector<FramePicture> frames = frames_of(run);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const FramePicture& frame = frames[i];
      const auto line = kLines.find(frame.text.phase);
      if (line == kLines.end() || run.frames[i].question >= 0) continue;
      EXPECT_TRUE(texts_of(frame, "code.current").starts_with(line->second))
          << frame.text.phase << ": " << texts_of(frame, "code.current");
      ++seen;
    }
    EXPECT_GT(seen, 5);
  }
}

TEST(Code, VariablesHaveTheValuesOfTheStep) {
  const LessonRun run = run_in("polygons-gjk", Language::cpp);
  int seen = 0;
  const std::vector<FramePicture> frames = frames_of(run);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames[i].text.phase != "support" || run.frames[i].question >= 0) continue;
    const WideState& state = run.state(run.frames[i]);
    const std::string texts = texts_of(frames[i], "code.value");
    EXPECT_NE(std::string::npos,
              texts.find(fmt::format("{} {}", state.support.pair.x, state.support.pair.y)))
        << texts;
    ++seen;
  }
  EXPECT_GT(seen, 1);
}

TEST(Code, ATestThatThePageDoesWithoutMarksNoLine) {
  Lesson lesson = shipped_lesson("polygons-gjk");
  lesson.listing = "gjk.cpp";
  lesson.options.stop_on_repeated_support = false;
  lesson.expect = {};
  const LessonRun run = run_lesson(std::move(lesson));
  ASSERT_EQ(gjk::StopReason::no_progress, run.run(run.frames[0]).trace.result.stop);
  const std::vector<FramePicture> frames = frames_of(run);
  EXPECT_EQ("", texts_of(frames.back(), "code.current"));
  EXPECT_NE(std::string::npos, texts_of(frames.back(), "body").find("this page does without"));
}

}  // namespace code_test
}  // namespace gjkscope
