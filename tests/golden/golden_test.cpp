// The known results of every lesson: the outcome that its file states, its trace and its
// transcript, a few pictures as lists of marks, and fewer still as pixels. A change that is meant
// is taken over by `scripts/golden`, and shows in the diff.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include "cli/transcript.hpp"
#include "fonts.hpp"
#include "frames/frame.hpp"
#include "golden/golden_text.hpp"
#include "golden/pixels.hpp"
#include "lessons.hpp"
#include "paint/canvas.hpp"
#include "paint/png.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace golden_test {

namespace fs = std::filesystem;

const fs::path kGolden = fs::path(GJKSCOPE_SOURCE_DIR) / "tests" / "golden";
const fs::path kAssets = fs::path(GJKSCOPE_SOURCE_DIR) / "assets";

/// scripts/golden names the lessons to write anew in GJKSCOPE_GOLDEN, or "all".
bool writes(const std::string& lesson) {
  const char* named = std::getenv("GJKSCOPE_GOLDEN");
  if (named == nullptr) return false;
  std::istringstream in(named);
  for (std::string name; in >> name;) {
    if (name == "all" || name == lesson) return true;
  }
  return false;
}

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

void write(const fs::path& file, const std::string& bytes) {
  std::ofstream out(file, std::ios::binary);
  out << bytes;
  ASSERT_TRUE(out.flush()) << file;
}

std::vector<fs::path> files_in(const char* folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(kGolden / folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

constexpr const char* kOtherFonts =
    "The pictures of tests/golden were made with other fonts than those that are installed: see "
    "tests/golden/fonts.txt. `scripts/golden` without a lesson makes all anew.";

void hold(const std::string& lesson, const std::string& expected, const std::string& got) {
  const golden::Difference difference = golden::first_difference(expected, got);
  if (difference.where.empty()) return;
  ADD_FAILURE() << lesson << " differs first at " << difference.where
                << "\n  expected: " << difference.expected << "\n  got:      " << difference.got
                << "\nIf that is meant: scripts/golden " << lesson;
}

/// Compares, or writes where scripts/golden asks for it.
void hold_to(const fs::path& file, const std::string& lesson, const std::string& got) {
  if (writes(lesson)) return write(file, got);
  if (!fs::exists(file)) {
    ADD_FAILURE() << lesson << " has no " << fs::relative(file, GJKSCOPE_SOURCE_DIR).string()
                  << " yet: look at its frames, then run\n  scripts/golden " << lesson;
    return;
  }
  hold(lesson, read(file), got);
}

/// A file for each lesson, and no other.
void hold_each(const char* folder, const std::function<std::string(const LessonRun&)>& text_of) {
  std::set<fs::path> known;
  for (const Lesson& lesson : testing::shipped_lessons()) {
    const fs::path file = kGolden / folder / (lesson.id + ".txt");
    known.insert(file);
    hold_to(file, lesson.id, text_of(run_lesson(lesson)));
  }
  for (const fs::path& file : files_in(folder))
    EXPECT_TRUE(known.contains(file)) << file << " is of no lesson: delete it";
}

/// "polygon-evolution-0015", with what follows a dot or nothing: frame 15 of polygon-evolution.
struct FrameName {
  std::string lesson;
  std::size_t frame = 0;  ///< From 0.
};
FrameName frame_name(const fs::path& file) {
  const std::string name = file.filename().string();
  const std::string stem = name.substr(0, name.find('.'));
  const std::size_t hyphen = stem.rfind('-');
  return {stem.substr(0, hyphen), std::stoul(stem.substr(hyphen + 1)) - 1};
}

class GoldenPictures : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (writes("all")) write(kGolden / "fonts.txt", golden::names_of(testing::fonts()));
  }

  /// The picture that a file is named after, counted without the frames that ask; frames of a
  /// lesson are made once.
  const Picture* picture_of(const fs::path& file) {
    const FrameName name = frame_name(file);
    auto found = frames_.find(name.lesson);
    if (found == frames_.end()) {
      Lesson lesson = testing::shipped_lesson(name.lesson);
      lesson.questions.clear();
      const LessonRun run = run_lesson(std::move(lesson));
      EffectGraph effects(run);
      found = frames_.emplace(name.lesson, lesson_pictures(run, effects, fonts)).first;
    }
    if (name.frame < found->second.size()) return &found->second[name.frame].picture;
    ADD_FAILURE() << name.lesson << " has no frame " << name.frame + 1;
    return nullptr;
  }

  const Fonts& fonts = testing::fonts();

 private:
  std::map<std::string, std::vector<FramePicture>> frames_;
};

TEST(Golden, EveryLessonStatesItsOutcomeAndKeepsItsWord) {
  for (const Lesson& lesson : testing::shipped_lessons()) {
    const LessonRun run = run_lesson(lesson);
    const Expectation& expect = lesson.expect;
    if (!run.tour->algorithm->takes_outlines) {
      EXPECT_TRUE(expect.stop && expect.supports && expect.distance)
          << lesson.path << ": [expect] needs 'stop', 'supports' and 'distance'";
    } else {
      EXPECT_FALSE(expect.answers.empty()) << lesson.path << ": [expect] needs 'answer'";
      EXPECT_EQ(expect.stop.has_value(), !run.tour->algorithm->stops.empty())
          << lesson.path << ": [expect] needs 'stop' where the algorithm has stop reasons";
    }
    for (const Problem& problem : check_expectation(run)) ADD_FAILURE() << to_string(problem);
  }
}

TEST(Golden, TracesAreThoseThatWereLookedAt) { hold_each("traces", golden::trace); }

TEST(Golden, TranscriptsAreThoseThatWereLookedAt) {
  hold_each("transcripts", [](const LessonRun& run) { return transcript(run, false); });
}

/// Systems differ in libraries and fonts, yet traces and words are the same bytes on all.
TEST(Golden, TracesAndWordsAreTheSameBytesEverywhere) {
  const fs::path file = kGolden / "checksums.txt";
  std::string got;
  for (const Lesson& lesson : testing::shipped_lessons())
    got += golden::checksums(run_lesson(lesson));
  if (std::getenv("GJKSCOPE_GOLDEN") != nullptr) return write(file, got);
  const golden::Difference difference = golden::first_difference(read(file), got);
  EXPECT_EQ(difference.expected, difference.got)
      << "`gjkscope trace LESSON` and `gjkscope transcript LESSON` print what differs. If it is "
         "meant: "
         "scripts/golden LESSON";
}

TEST_F(GoldenPictures, MarksAreThoseThatWereLookedAt) {
  const std::vector<fs::path> files = files_in("pictures");
  EXPECT_GE(files.size(), 3u);
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.filename().string());
    const Picture* picture = picture_of(file);
    if (!picture) continue;
    const std::string lesson = frame_name(file).lesson;
    const std::string got = golden::marks(*picture);
    if (golden::fonts_are_those_of_goldens()) {
      hold_to(file, lesson, got);
    } else {
      ASSERT_FALSE(writes(lesson)) << kOtherFonts;
      hold(lesson, golden::without_places_of_words(read(file)),
           golden::without_places_of_words(got));
    }
  }
}

/// Files are called LESSON-FRAME.THEME.png.
TEST_F(GoldenPictures, PixelsAreThoseThatWereLookedAt) {
  constexpr int kWidth = 640;
  constexpr int kHeight = 360;
  const std::vector<fs::path> files = files_in("pixels");
  EXPECT_GE(files.size(), 2u);
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.filename().string());
    const Picture* picture = picture_of(file);
    if (!picture) continue;
    const std::string theme = file.stem().extension().string().substr(1);
    CanvasOptions options;
    options.width = kWidth;
    options.height = kHeight;
    options.zoom = page_of(kWidth, kHeight).zoom;
    Canvas canvas(fonts, Theme::load(kAssets / "themes", theme), options);
    const Image image = canvas.paint(*picture);
    const std::string lesson = frame_name(file).lesson;
    if (writes(lesson)) {
      ASSERT_TRUE(golden::fonts_are_those_of_goldens()) << kOtherFonts;
      const std::vector<std::uint8_t> png = encode_png(image);
      write(file, std::string(png.begin(), png.end()));
      continue;
    }
    EXPECT_TRUE(golden::looks_like(read(file), image))
        << "If that is meant: scripts/golden " << lesson;
  }
}

TEST(GoldenPixels, AnotherDrawerOrDialogIsNoMatterOfLetters) {
  const std::string kLooks[] = {"shapes", "values", "numerics-dark", "palette",
                                "keys",   "export", "presenting",    "narrow"};
  for (const std::string& one : kLooks) {
    for (const std::string& other : kLooks) {
      if (one == other) continue;
      const auto look = [](const std::string& name) {
        return golden::decoded(read(kGolden / "window" / (name + ".png")));
      };
      EXPECT_GT(golden::share_of_other_squares(look(one), look(other)), golden::kInkOthers)
          << one << " and " << other;
    }
  }
}

TEST(GoldenText, TheFirstDifferenceIsNamedByItsStep) {
  LessonRun run = run_lesson(testing::shipped_lesson("polygon-evolution"));
  const std::string expected = golden::trace(run);
  EXPECT_EQ(golden::first_difference(expected, expected).where, "");
  for (WideStep& step : run.runs[0].trace.steps) {
    if (step.iteration == 2 && step.phase == gjk::Phase::support) step.after.support.pair.y = 0;
  }
  const golden::Difference difference = golden::first_difference(expected, golden::trace(run));
  EXPECT_EQ(difference.where, "iteration 2, scan");
  EXPECT_NE(difference.expected.find("D"), std::string::npos);
  EXPECT_EQ(golden::first_difference("start\n  a\n", "start\n").got, "(nothing)");
}

}  // namespace golden_test
}  // namespace gjkscope
