// Every frame of every shipped lesson, at several sizes: what a reader would stumble over.

#include "frames/frame.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <ostream>
#include <set>
#include <sstream>

#include "frames/timeline.hpp"
#include "lessons.hpp"
#include "picture/scene.hpp"
#include "picture/text_box.hpp"
#include "picture/theme.hpp"
#include "picture/words.hpp"
#include "run/questions.hpp"
#include "run/trail.hpp"
#include "subjects/second_run/table.hpp"
#include "subjects/study/table.hpp"
#include "subjects/subjects.hpp"
#include "texts.hpp"

namespace gjkscope {

void PrintTo(const Page& page, std::ostream* out) {
  *out << page.width * page.zoom << " x " << page.height * page.zoom;
}

namespace frame_test {

const std::filesystem::path kAssets = std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets";

const Fonts& fonts() {
  static const Fonts kFonts{kAssets / "fonts.toml"};
  return kFonts;
}

const std::vector<Theme>& themes() {
  static const std::vector<Theme> kThemes = [] {
    std::vector<Theme> all;
    for (const std::string& name : Theme::names(kAssets / "themes"))
      all.push_back(Theme::load(kAssets / "themes", name));
    return all;
  }();
  return kThemes;
}

bool inside(const Rect& outer, const Rect& inner) {
  return (inner.min.array() >= outer.min.array()).all() &&
         (inner.max.array() <= outer.max.array()).all();
}

/// True for labels of the vertices of a shape that moves.
bool moves(const Lesson& lesson, const std::string& role) {
  if (lesson.settings.as<LessonStudy>()) return true;  // each pair has shapes of its own
  if (!lesson.path_of_shapes) return false;
  const bool of_x = role == "shape.x.label";
  return !(of_x ? lesson.path_of_shapes->x() : lesson.path_of_shapes->y()).points.empty();
}

/// The claims of `Frames` on one frame after the other of a lesson; its pictures are made once.
class FrameClaims {
 public:
  explicit FrameClaims(const Lesson& lesson) : lesson_(lesson) {}

  void check(const FramePicture& frame) {
    const std::vector<std::pair<Rect, std::string>> texts = texts_of(frame);
    no_text_is_cut_off_or_covers_another(frame, texts);
    text_of_a_card_stays_in_the_card(frame, texts);
    every_character_can_be_drawn_and_every_role_has_a_style(frame);
    // In a trail they name vertices of small pictures.
    if (frame.text.phase != "trail") labels_of_vertices_that_stay_keep_their_place(frame);
    says_what_happened_and_how_it_goes_on(frame.text);
  }

 private:
  using BoxesOfTexts = std::vector<std::pair<Rect, std::string>>;

  [[nodiscard]] static BoxesOfTexts texts_of(const FramePicture& frame) {
    BoxesOfTexts texts;
    for (const Mark& mark : frame.picture.marks) {
      const Text* text = std::get_if<Text>(&mark.shape);
      if (text && !text->text.empty()) texts.emplace_back(box_of(fonts(), *text), text->text);
    }
    return texts;
  }

  static void no_text_is_cut_off_or_covers_another(const FramePicture& frame,
                                                   const BoxesOfTexts& texts) {
    const Rect page{{0.0, 0.0}, {frame.picture.width, frame.picture.height}};
    EXPECT_GT(texts.size(), 5u);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      EXPECT_TRUE(inside(page, texts[i].first)) << "cut off: " << texts[i].second;
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_FALSE(overlap(texts[i].first, texts[j].first))
            << texts[i].second << " at " << texts[i].first.min.transpose() << " to "
            << texts[i].first.max.transpose() << " | " << texts[j].second << " at "
            << texts[j].first.min.transpose() << " to " << texts[j].first.max.transpose();
      }
    }
  }

  static void text_of_a_card_stays_in_the_card(const FramePicture& frame,
                                               const BoxesOfTexts& texts) {
    std::vector<Rect> cards;
    for (const Mark& mark : frame.picture.marks) {
      if (mark.role == "card") cards.push_back(std::get<Box>(mark.shape).rect);
    }
    ASSERT_FALSE(cards.empty());
    for (const auto& [box, text] : texts) {
      for (const Rect& card : cards)
        EXPECT_TRUE(!overlap(box, card) || inside(card, box)) << "leaves its card: " << text;
    }
  }

  static void every_character_can_be_drawn_and_every_role_has_a_style(const FramePicture& frame) {
    for (const Mark& mark : frame.picture.marks) {
      for (const Theme& theme : themes())
        EXPECT_NO_THROW((void)theme.style(mark.role)) << mark.role;
      if (const Text* text = std::get_if<Text>(&mark.shape)) {
        EXPECT_EQ(Fonts::first_missing(text->text), char32_t{0}) << text->text;
      }
    }
  }

  void labels_of_vertices_that_stay_keep_their_place(const FramePicture& frame) {
    for (const Mark& mark : frame.picture.marks) {
      if (mark.role != "shape.label" && mark.role != "shape.x.label" &&
          mark.role != "shape.y.label")
        continue;
      const Text& text = std::get<Text>(mark.shape);
      if (moves(lesson_, mark.role)) continue;
      const auto topmost = std::find_if(frame.picture.clips.rbegin(), frame.picture.clips.rend(),
                                        [&](const Rect& clip) {
                                          return overlap(clip, {text.at, text.at});
                                        });
      const auto [place, added] = places_.emplace(
          fmt::format("{} {}", text.text, frame.picture.clips.rend() - topmost), text.at);
      EXPECT_EQ(place->second, text.at) << "label moves: " << text.text;
    }
  }

  static void says_what_happened_and_how_it_goes_on(const FrameText& text) {
    EXPECT_FALSE(text.caption.empty());
    EXPECT_FALSE(text.detail.empty());
    EXPECT_FALSE(text.prose.empty());
    EXPECT_EQ(text.prose.find('{'), std::string::npos) << text.prose;
    for (const std::string& words : {text.caption, text.detail}) {
      EXPECT_EQ(words.find("nan"), std::string::npos) << words;
      EXPECT_EQ(words.find("inf"), std::string::npos) << words;
    }
  }

  const Lesson& lesson_;
  std::map<std::string, Point> places_;  ///< Places of labels, by text and card.
};

class Frames : public ::testing::TestWithParam<Page> {};

TEST_P(Frames, CanBeRead) {
  ASSERT_GE(themes().size(), 4u);
  for (const Lesson& lesson : testing::lessons_for_long_tests()) {
    const LessonRun run = run_lesson(lesson);
    EffectGraph effects(run);
    const auto frames = lesson_pictures(run, effects, fonts(), GetParam());
    ASSERT_EQ(frames.size(), run.frames.size());
    FrameClaims claims(lesson);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      SCOPED_TRACE(lesson.id + ", frame " + std::to_string(i + 1));
      claims.check(frames[i]);
    }
  }
}

// A screen, a slide, a wide strip, a tall page; pages of windows that are narrower than a screen.
INSTANTIATE_TEST_SUITE_P(Sizes, Frames,
                         ::testing::Values(page_of(1280, 720), page_of(1024, 768),
                                           page_of(2560, 1080), page_of(720, 1280),
                                           Page{1000.0, 720.0, 1.0}, Page{1150.0, 720.0, 1.0},
                                           Page{1200.0, 760.0, 1.0}, Page{920.0, 800.0, 1.0}));

/// A sum as a text has it: "1.5 − 0.5 = 1.0".
struct WrittenSum {
  std::vector<std::string> terms;
  std::string total;
  bool says_rounded = false;
};

std::vector<WrittenSum> sums_in(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream in(text);
  for (std::string word; in >> word;) words.push_back(word);
  const auto number = [&](std::size_t i) {  // without a full stop, or nothing
    if (i >= words.size()) return std::string();
    std::string word = words[i].substr(0, words[i].find_last_of("0123456789") + 1);
    const bool is_number = word.find_first_not_of("−.0123456789") == std::string::npos;
    return is_number ? word : std::string();
  };
  std::vector<WrittenSum> sums;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (number(i).find('.') == std::string::npos) continue;
    WrittenSum sum{{number(i)}, ""};
    std::size_t at = i + 1;
    for (; at < words.size() && (words[at] == "+" || words[at] == "−"); at += 2) {
      if (number(at + 1).empty()) break;
      sum.terms.push_back((words[at] == "−" ? "−" : "") + number(at + 1));
    }
    if (sum.terms.size() < 2 || at >= words.size() || words[at] != "=") continue;
    sum.total = number(at + 1);
    sum.says_rounded = at + 2 < words.size() && words[at + 2] == "up";
    sums.push_back(std::move(sum));
    i = at;
  }
  return sums;
}

TEST(Captions, SumsAddUpAsTheyAreWrittenOrSayThatTheyAreRounded) {
  int in_words = 0;
  int in_panels = 0;
  int rounded = 0;
  for (const Lesson& lesson : testing::lessons_for_long_tests()) {
    const LessonRun run = run_lesson(lesson);
    EffectGraph effects(run);
    for (const FramePicture& frame : lesson_pictures(run, effects, fonts())) {
      SCOPED_TRACE(lesson.id + ": " + frame.text.caption);
      std::vector<WrittenSum> sums = sums_in(frame.text.caption);
      for (WrittenSum& sum : sums_in(frame.text.detail)) sums.push_back(std::move(sum));
      in_words += static_cast<int>(sums.size());
      // Weights stand each in a row: letter, number; then the row of their sum.
      WrittenSum weights;
      std::string row;
      for (const Mark& mark : frame.picture.marks) {
        const Text* text = std::get_if<Text>(&mark.shape);
        if (!text) continue;
        if (mark.role == "code.current" && (row == "u" || row == "v" || row == "w" || row == "t"))
          weights.terms.push_back(text->text);
        if (mark.role == "code" && row.starts_with("u + v")) {
          weights.total = text->text;
          weights.says_rounded = row.ends_with("up to rounding");
          sums.push_back(weights);
          ++in_panels;
        }
        row = text->text;
      }
      for (const WrittenSum& sum : sums) {
        rounded += sum.says_rounded ? 1 : 0;
        EXPECT_EQ(adds_up(sum.terms, sum.total), !sum.says_rounded)
            << ::testing::PrintToString(sum.terms) << " = " << sum.total;
      }
    }
  }
  EXPECT_GT(in_words, 10);
  EXPECT_GT(in_panels, 10);
  EXPECT_GT(rounded, 2);
}

std::vector<std::string> timeline_words(const LessonRun& run, int current) {
  std::vector<std::string> words;
  for (const Mark& mark : timeline_marks(run, current, fonts(), {{32.0, 644.0}, {1248.0, 696.0}})) {
    if (const Text* text = std::get_if<Text>(&mark.shape)) words.push_back(text->text);
  }
  return words;
}

TEST(Timeline, SaysInWordsWhatHappenedAndWhereQuestionsAre) {
  const LessonRun run = run_lesson(testing::shipped_lesson("polygons-gjk"));
  const auto words = timeline_words(run, static_cast<int>(run.frames.size()) - 1);
  int dropped = 0;
  int questions = 0;
  for (const Frame& frame : run.frames) {
    if (frame.question >= 0) {
      ++questions;
    } else if (frame.step >= 0 && !run.step(frame).record.dropped.empty()) {
      ++dropped;
    }
  }
  const auto count = [&](const std::string& word) {
    return std::count(words.begin(), words.end(), word);
  };
  EXPECT_GT(dropped, 0);
  EXPECT_EQ(count("drop"), dropped);
  EXPECT_GT(questions, 1);
  EXPECT_EQ(count("?"), questions);
  EXPECT_EQ(count("after the question"), 0);
  const auto at_start = timeline_words(run, 0);
  EXPECT_EQ(std::count(at_start.begin(), at_start.end(), "after the question"), 1);
}

TEST(Timeline, WithAllQuestionsFillsItsWidthAndKeepsItsStart) {
  Lesson lesson = testing::shipped_lesson("polygons-gjk");
  lesson.questions.clear();
  for (const AskInfo& ask : asks::kOfSteps) lesson.questions.push_back({std::string(ask.name), {}});
  const LessonRun run = run_lesson(lesson);
  const int count = static_cast<int>(run.frames.size());
  const Rect area{{32.0, 644.0}, {1248.0, 696.0}};
  for (int current = 0; current < count; ++current) {
    double end = 0.0;
    bool has_start = false;
    for (const Mark& mark : timeline_marks(run, current, fonts(), area)) {
      if (const Box* box = std::get_if<Box>(&mark.shape)) end = std::max(end, box->rect.max.x());
      const Text* text = std::get_if<Text>(&mark.shape);
      has_start = has_start || (text && text->text == "start");
    }
    EXPECT_NEAR(end, area.max.x(), 1e-6) << current;
    EXPECT_TRUE(has_start) << current;
  }
}

TEST(Timeline, ManyGroupsAreNumbered) {
  Lesson lesson = testing::lesson_without_questions("hierarchy-circles");
  lesson.questions = {{"win", {}}};  // then each visit has a frame of its own
  const LessonRun run = run_lesson(lesson);
  const auto words = timeline_words(run, static_cast<int>(run.frames.size()) - 1);
  for (const char* number : {"9", "10", "30"})
    EXPECT_NE(std::find(words.begin(), words.end(), number), words.end()) << number;
}

TEST(Timeline, NarrowGroupsHaveShortNames) {
  const LessonRun run = run_lesson(testing::lesson_without_questions("polygons-motion"));
  const auto words = timeline_words(run, 0);
  EXPECT_EQ(words.front(), "vertex C – vertex K") << "the current one's is whole";
  const auto is_short = [](const std::string& word) {
    return word.find(" – ") != std::string::npos && word.find("vertex") == std::string::npos &&
           word.find("edge") == std::string::npos;
  };
  EXPECT_GE(std::count_if(words.begin(), words.end(), is_short), 1);
}

TEST(Legend, StandsInThePanelWhileItsMarksAreThere) {
  const LessonRun run = run_lesson(testing::shipped_lesson("convex-pieces"));
  EffectGraph effects(run);
  int stands = 0;
  for (const FramePicture& frame : lesson_pictures(run, effects, fonts())) {
    const auto& marks = frame.picture.marks;
    const bool has_boxes = std::any_of(marks.begin(), marks.end(), [](const Mark& mark) {
      return mark.role == "piece.box" && mark.clip >= 0;
    });
    const bool is_shown = std::any_of(marks.begin(), marks.end(), [](const Mark& mark) {
      const Text* text = std::get_if<Text>(&mark.shape);
      return text && text->text == "box around a piece";
    });
    EXPECT_EQ(is_shown, has_boxes) << frame.text.caption;
    stands += is_shown ? 1 : 0;
  }
  EXPECT_GT(stands, 1);
}

TEST(Legend, OnAStageHidesNoVertex) {
  int boxes = 0;
  for (const Lesson& lesson : testing::lessons_for_long_tests()) {
    const LessonRun run = run_lesson(lesson);
    EffectGraph effects(run);
    for (const FramePicture& frame :
         lesson_pictures(run, effects, fonts(), {360.0, 620.0, 1.0, true})) {
      for (const Mark& box : frame.picture.marks) {
        if (box.role != "legend.box") continue;
        ++boxes;
        for (const Mark& mark : frame.picture.marks) {
          const Disk* disk = std::get_if<Disk>(&mark.shape);
          const Rect room = std::get<Box>(box.shape).rect;
          if (!disk || mark.clip < 0) continue;
          EXPECT_FALSE(inside(room, {disk->center, disk->center}))
              << lesson.id << ", " << mark.role << ": " << frame.text.caption;
        }
      }
    }
  }
  EXPECT_GT(boxes, 20);
}

TEST(StageMap, DrawsYAsManyTimesLargerAsTheCameraSays) {
  const StageMap map({{0.0, 0.0}, {200.0, 100.0}}, {{5.0, 1.0, 0.0}, 2.0, 10.0});
  EXPECT_EQ(map(Eigen::Vector2d(5.0, 1.0)), Point(100.0, 50.0));
  EXPECT_EQ(map(Eigen::Vector2d(5.0, 2.0)), Point(100.0, 0.0));
  EXPECT_EQ(map(Eigen::Vector2d(15.0, 1.0)), Point(150.0, 50.0));
  EXPECT_EQ(map.direction(Eigen::Vector2d(10.0, 1.0)), Point(1.0, -1.0).normalized());
}

TEST(Page, KeepsTheProportionsOfTheImageAndTheSizeOfType) {
  const Page large = page_of(3840, 2160);
  EXPECT_EQ(large.width, 1280.0);
  EXPECT_EQ(large.zoom, 3.0);
  const Page tall = page_of(720, 1280);
  EXPECT_EQ(tall.width, 1280.0);
  EXPECT_NEAR(tall.height / tall.width, 1280.0 / 720.0, 1e-12);
}

TEST(Page, ViewsStandWhereShapesAreLarger) {
  const LessonRun run = run_lesson(testing::shipped_lesson("round-shapes"));
  EffectGraph effects(run);
  LessonPictures pictures(run, effects, fonts());
  const auto is_stacked = [&](const Page& page) {
    pictures.lay_out(page, {std::nullopt, std::nullopt}, LabelScope::lesson);
    return pictures.views()[1].card.min.y() > pictures.views()[0].card.max.y();
  };
  EXPECT_FALSE(is_stacked(page_of(1280, 720)));
  EXPECT_FALSE(is_stacked(page_of(1280, 800)));
  // These shapes are wide.
  EXPECT_TRUE(is_stacked(page_of(1024, 768)));
  EXPECT_TRUE(is_stacked({.width = 1000.0, .height = 800.0}));
  EXPECT_FALSE(is_stacked({.width = 1270.0, .height = 500.0}));
}

TEST(Captions, TellTheRunOfThePentagon) {
  const LessonRun run = run_lesson(testing::shipped_lesson("polygon-evolution"));
  EffectGraph effects(run);
  const auto frames = lesson_pictures(run, effects, fonts());
  // Distance of (2.7, 2.3) from the line through (2.4, -0.4) and (0.9, 2.2), by the point-line
  // formula.
  const double distance = std::abs(2.6 * (2.7 - 2.4) + 1.5 * (2.3 + 0.4)) / std::hypot(2.6, 1.5);
  const FrameText& answer = frames[static_cast<std::size_t>(answering_index(run))].text;
  EXPECT_TRUE(answer.detail.starts_with("The distance is " + fixed(distance, 3) +
                                        ": P lies on the segment CD."))
      << answer.detail;
  EXPECT_NEAR(distance, 1.6091, 5e-5);
  EXPECT_TRUE(frames[14].text.caption.starts_with("Answer: E. Q lies beyond CD, seen from E"));
  EXPECT_EQ(frames[15].text.caption, "E is dropped: P lies on CD, so the weight of E is 0.");
  EXPECT_EQ(frames[0].text.phase, "start");
  EXPECT_EQ(frames[15].text.phase, "drop");
  EXPECT_EQ(frames[15].text.iteration, 3);
}

std::vector<FramePicture> frames_of(const std::string& id) {
  const LessonRun run = run_lesson(testing::lesson_without_questions(id));
  EffectGraph effects(run);
  return lesson_pictures(run, effects, fonts());
}

TEST(Captions, SayHowWrongAWrongOrderIs) {
  const auto frames = frames_of("triangle-wrong-order");
  ASSERT_EQ(frames.size(), 12u);
  // Q is closest to B; edges first, it is dropped onto the line AB beyond B.
  const Eigen::Vector2d a(-1.85, -0.9), b(1.55, -0.6), q(2.7, -1.25);
  const Eigen::Vector2d foot = a + (q - a).dot(b - a) / (b - a).squaredNorm() * (b - a);
  EXPECT_EQ(frames[1].text.caption,
            "Vertices first: the first true test is that of vertex B, and it is right.");
  EXPECT_TRUE(
      frames[2].text.caption.ends_with("wrong by |P′ − P| = " + fixed((foot - b).norm(), 3) + "."))
      << frames[2].text.caption;
  EXPECT_TRUE(frames[2].text.detail.starts_with(
      "P′, the projection of Q onto the line AB, is not on the edge."))
      << frames[2].text.detail;
  EXPECT_TRUE(frames[3].text.caption.ends_with("whole tests still give vertex B."))
      << frames[3].text.caption;
  EXPECT_TRUE(frames[4].text.caption.starts_with("Q moves from (2.70, −1.25) to (0.85, −1.40)."))
      << frames[4].text.caption;
}

TEST(Captions, GiveTheSameWeightsFromGAndFromQ) {
  const auto frames = frames_of("segment-barycentric");
  // A quarter of the way from A to B, on the line and off it.
  EXPECT_EQ(
      frames[2].text.caption,
      "G = uA + vB divides AB: from G to B it is u = 0.750 of the length, from A to G it is v = "
      "0.250.");
  EXPECT_EQ(frames[7].text.detail,
            "Thus from Q itself: u = 3.354 / 4.472 = 0.750 and v = 1.118 / 4.472 = 0.250.");
  EXPECT_NEAR(std::hypot(4.0, 2.0), 4.472, 5e-4);
  EXPECT_NEAR(0.75 * std::hypot(4.0, 2.0), 3.354, 5e-4);
}

TEST(Captions, TellWhichWayTheBeamTurnsAndByHowMuch) {
  const auto frames = frames_of("segment-balance");
  const std::vector<std::size_t> first = {0, 2, 6, 7};  // frames of each position
  const auto caption = [&](std::size_t position, std::size_t tick) {
    return frames[first[position] + tick].text.caption;
  };
  ASSERT_EQ(frames.size(), 10u);
  EXPECT_TRUE(caption(0, 1).ends_with("the beam stays level.")) << caption(0, 1);
  // On the ground at 15.4 degrees, by the arms across from the axle, 0.15 above the beam's middle.
  const double angle = 15.4 * 3.14159265358979 / 180.0;
  const double turning_a = 0.8 * (0.5 * std::cos(angle) - 0.15 * std::sin(angle));
  const double turning_b = 0.2 * (0.5 * std::cos(angle) + 0.15 * std::sin(angle));
  EXPECT_EQ(caption(1, 1), "A's moment is larger, " + fixed(turning_a, 3) + " against " +
                               fixed(turning_b, 3) + ": A is down by 15.4°, on the ground.");
  EXPECT_EQ(caption(1, 3),
            "With the support at G = uA + vB the moments are equal, 0.800 × 0.200 = 0.200 × 0.800: "
            "the beam is level again.");
  EXPECT_TRUE(caption(2, 0).starts_with(
      "Q has moved. With the support at G = uA + vB the moments are equal"))
      << caption(2, 0);
  EXPECT_TRUE(caption(3, 0).ends_with("A stays empty, B gets 1.200.")) << caption(3, 0);
  EXPECT_TRUE(caption(3, 1).starts_with("The support has passed B")) << caption(3, 1);
  EXPECT_TRUE(caption(3, 2).ends_with("the beam has tipped over to A.")) << caption(3, 2);
}

TEST(Captions, TellWhereTheSignsMislead) {
  const auto frames = frames_of("triangle-two-maps");
  ASSERT_EQ(frames.size(), 10u);
  EXPECT_EQ(frames[7].text.caption,
            "At Q, w = −0.455 is negative. The signs name edge AB, but vertex A is closest.");
  EXPECT_EQ(frames[8].text.caption,
            "At Q, u = −0.085 and w = −0.455 are negative. The signs name vertex B, but edge AB is "
            "closest.");
  // w by areas: QAB lies 1 below AB, C 2.2 above.
  EXPECT_NEAR(-1.0 / 2.2, -0.455, 5e-4);
}

TEST(Panel, WritesConditionsInTheOrderOfTheirValues) {
  const LessonRun run = run_lesson(testing::shipped_lesson("triangle-ordered-test"));
  EffectGraph effects(run);
  const auto frames = lesson_pictures(run, effects, fonts());
  std::vector<std::string> texts;
  for (const Mark& mark : frames.back().picture.marks) {
    if (const Text* text = std::get_if<Text>(&mark.shape)) texts.push_back(text->text);
  }
  const auto row = std::find(texts.begin(), texts.end(), "uBC ≤ 0 and vCA ≤ 0");
  ASSERT_NE(row, texts.end());
  // Weights of B on BC and of A on CA by the projections, from the lesson's coordinates.
  const Eigen::Vector2d a(-1.85, -1.05), b(1.55, -0.75), c(0.0, 1.7), q(1.1, 1.2);
  const double u_bc = (c - q).dot(c - b) / (c - b).squaredNorm();
  const double v_ca = (q - c).dot(a - c) / (a - c).squaredNorm();
  EXPECT_EQ(*(row + 1), signed_fixed(u_bc, 3) + " " + signed_fixed(v_ca, 3));
}

/// The texts of one frame.
std::vector<std::string> texts_of_frame(const std::string& lesson, std::size_t frame) {
  const LessonRun run = run_lesson(testing::shipped_lesson(lesson));
  EffectGraph effects(run);
  std::vector<std::string> texts;
  const std::vector<FramePicture> frames = lesson_pictures(run, effects, fonts());
  for (const Mark& mark : frames[frame].picture.marks) {
    if (const Text* text = std::get_if<Text>(&mark.shape)) texts.push_back(text->text);
  }
  return texts;
}

/// The text that follows a text on its row.
std::string after(const std::vector<std::string>& texts, const std::string& text, int next = 1) {
  const auto found = std::find(texts.begin(), texts.end(), text);
  EXPECT_NE(found, texts.end()) << text;
  return texts.end() - found > next ? *(found + next) : "";
}

TEST(Panel, PseudocodeKeepsTheValuesOfTheIterationBesideTheirLines) {
  // Iteration 2 of the pentagon, at its stop phase.
  const std::vector<std::string> texts = texts_of_frame("polygon-pseudocode", 10);
  EXPECT_EQ(after(texts, "drop vertices without weight"), "none");
  EXPECT_EQ(after(texts, "if d = 0: stop"), "no");
  EXPECT_EQ(after(texts, "V ← support point along d"), "D");
  EXPECT_EQ(after(texts, "if V in S or no farther: stop"), "no");
  EXPECT_EQ(after(texts, "add V to S"), "Simplex S, and V") << "not yet";
}

TEST(Panel, WeightsAreOfTheSimplexWhateverItIs) {
  const auto says = [](const Lesson& lesson, const std::string& part) {
    const LessonRun run = run_lesson(lesson);
    EffectGraph effects(run);
    const auto frames = lesson_pictures(run, effects, fonts());
    return std::any_of(frames.begin(), frames.end(), [&](const FramePicture& frame) {
      return std::any_of(frame.picture.marks.begin(), frame.picture.marks.end(),
                         [&](const Mark& mark) {
                           const Text* text = std::get_if<Text>(&mark.shape);
                           return text && text->text.find(part) != std::string::npos;
                         });
    });
  };
  Lesson lesson = testing::shipped_lesson("segment-closest");
  EXPECT_TRUE(says(lesson, "|B − A|²"));
  std::swap(lesson.options.start.pairs[0], lesson.options.start.pairs[1]);
  EXPECT_TRUE(says(lesson, "|A − B|²"));
  EXPECT_FALSE(says(lesson, "|B − A|²"));
  lesson.y().vertices.resize(1);
  lesson.y().vertex_names.resize(1);
  lesson.options.start.pairs[0] = {0, 0};
  lesson.options.start.count = 1;
  lesson.tour = "phase";
  EXPECT_FALSE(says(lesson, "|²"));
}

TEST(Panel, StopTestsAreTickedInOrderAndTheUntriedLeftOpen) {
  const std::vector<std::string> texts = texts_of_frame("stop-repeated", 6);
  EXPECT_EQ(after(texts, "Q inside S"), "2 vertices, needs 3");
  EXPECT_EQ(after(texts, "Q inside S", 2), "✗") << "of the next test, which is decided";
  EXPECT_EQ(after(texts, "P no closer"), "no P before");
  EXPECT_EQ(after(texts, "d = 0", 2), "✓") << "of the next test";
  EXPECT_EQ(after(texts, "V in S"), "C is in S");
  EXPECT_EQ(after(texts, "V in S", 2), "·");
  EXPECT_EQ(after(texts, "V no farther than S"), "·") << "nothing is compared any more";
}

TEST(Panel, StopTestsThatTheRunHasPassedKeepTheirValues) {
  const std::vector<std::string> closest = texts_of_frame("stop-repeated", 2);
  EXPECT_EQ(after(closest, "Stop tests (V: support point)"), "·") << "nothing is tested yet";
  const std::vector<std::string> direction = texts_of_frame("stop-repeated", 3);
  EXPECT_EQ(after(direction, "Q inside S"), "2 vertices, needs 3");
  EXPECT_EQ(after(direction, "P no closer", 2), "·") << "of d = 0, asked of the next phase";
  const std::vector<std::string> support = texts_of_frame("stop-repeated", 5);
  EXPECT_TRUE(after(support, "d = 0").starts_with("|d| = "));
  EXPECT_EQ(after(support, "d = 0", 2), "·") << "of the support point in S";
  // Words of a stop phase stay while the support point joins.
  const LessonRun run = run_lesson(testing::shipped_lesson("stop-contained"));
  int adds = 0;
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    if (run.frames[i].question >= 0) continue;
    if (run.frames[i].step < 0 || run.step(run.frames[i]).phase != gjk::Phase::add) continue;
    ++adds;
    const auto add = texts_of_frame("stop-contained", static_cast<int>(i));
    const auto stop = texts_of_frame("stop-contained", static_cast<int>(i) - 1);
    for (const char* test : {"Q inside S", "d = 0", "V in S", "V no farther than S"})
      EXPECT_EQ(after(add, test), after(stop, test)) << test;
  }
  EXPECT_EQ(adds, 1);
}

TEST(Panel, TheScanMarksTheSimplexOnceItIsAskedWhetherTheWinnerIsNews) {
  // Vertices C and D of the pentagon, which S has; both lie farthest.
  const std::size_t last = run_lesson(testing::shipped_lesson("stop-repeated")).frames.size() - 1;
  const std::vector<std::string> found = texts_of_frame("stop-edge-left", last - 1);
  EXPECT_EQ(std::count(found.begin(), found.end(), "in the simplex"), 0);
  const std::vector<std::string> stop = texts_of_frame("stop-repeated", last);
  EXPECT_EQ(std::count(stop.begin(), stop.end(), "in the simplex"), 2);
  const auto scan = std::find(stop.begin(), stop.end(), "Dot product with d");
  const std::vector<std::string> rows(scan, stop.end());
  EXPECT_EQ(after(rows, "C"), "in the simplex");
  EXPECT_EQ(after(rows, "C", 2), "5.250");
  EXPECT_EQ(after(rows, "D", 2), "5.250") << "no less than C";
  const LessonRun right = run_lesson(testing::shipped_lesson("stop-edge-right"));
  const std::vector<std::string> no_scan =
      texts_of_frame("stop-edge-right", static_cast<std::size_t>(answering_index(right)));
  EXPECT_EQ(std::count(no_scan.begin(), no_scan.end(), "in the simplex"), 0) << "nothing was found";
}

TEST(Pictures, AVertexIsDroppedOrKeptBesideItsWeight) {
  // The weight of D, from the projection of Q onto CD.
  const LessonRun collinear = run_lesson(testing::shipped_lesson("collinear"));
  const Eigen::Vector3d& q = collinear.runs[0].x().world[0];
  const Eigen::Vector3d& c = collinear.runs[0].y().world[2];
  const Eigen::Vector3d& d = collinear.runs[0].y().world[3];
  const double of_d = (q - c).dot(d - c) / (d - c).squaredNorm();
  const auto has = [](const std::vector<std::string>& texts, const std::string& text) {
    return std::find(texts.begin(), texts.end(), text) != texts.end();
  };
  const std::vector<std::string> closest = texts_of_frame("collinear", 2);
  const std::vector<std::string> drop = texts_of_frame("collinear", 3);
  for (const double weight : {of_d, 1.0 - of_d}) {
    EXPECT_FALSE(has(closest, fixed(weight, 3)));
    EXPECT_TRUE(has(drop, fixed(weight, 3))) << weight;
  }
  EXPECT_TRUE(has(drop, "0")) << "B, which is dropped";

  // The panel marks the weights that are kept, if it has them.
  const LessonRun pentagon = run_lesson(testing::shipped_lesson("polygon-evolution"));
  EffectGraph of_pentagon(pentagon);
  const auto frames = lesson_pictures(pentagon, of_pentagon, fonts());
  int drops = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Frame& frame = pentagon.frames[i];
    if (frame.step < 0 || frame.question >= 0) continue;
    const bool drops_vertices = pentagon.step(frame).phase == gjk::Phase::drop;
    const auto marked =
        std::count_if(frames[i].picture.marks.begin(), frames[i].picture.marks.end(),
                      [](const Mark& mark) { return mark.role == "highlight.pass"; });
    EXPECT_EQ(marked, drops_vertices ? pentagon.state(frame).simplex.count : 0) << i + 1;
    drops += drops_vertices;
  }
  EXPECT_EQ(drops, 1) << "none where nothing is dropped";
}

TEST(Captions, NameTiesAreasOfZeroAndWhatTheSecondRunFinds) {
  const auto holds = [](const std::vector<std::string>& texts, const std::string& words) {
    return std::any_of(texts.begin(), texts.end(), [&](const std::string& text) {
      return text.find(words) != std::string::npos;
    });
  };
  EXPECT_TRUE(holds(texts_of_frame("collinear", 2), "BCD has area 0 and no area fractions"));
  EXPECT_TRUE(holds(texts_of_frame("collinear", 6), "B, C and D lie equally far along d"));
  EXPECT_TRUE(holds(texts_of_frame("collinear", 6), "B is not in the simplex: it was dropped."));
  EXPECT_TRUE(holds(texts_of_frame("polygons-gjk", 24), "In X, D lies as far as C."));
  EXPECT_TRUE(holds(texts_of_frame("minkowski-support", 0), "leads from P to O"));
  EXPECT_TRUE(holds(texts_of_frame("minkowski-support", 5), "its length does not matter"));
  EXPECT_TRUE(holds(texts_of_frame("direction-half", 5), "Half precision finds B"));
  EXPECT_TRUE(holds(texts_of_frame("nonconvex-vertex", 4), "B can never win"));
}

TEST(Captions, DoNotUseWeightsBeforeALessonHasThem) {
  for (const char* id : {"segment-regions", "triangle-features"}) {
    for (const FramePicture& frame : frames_of(id)) {
      for (const Mark& mark : frame.picture.marks) {
        const Text* text = std::get_if<Text>(&mark.shape);
        if (!text) continue;
        for (const char* word : {"eight", "dot(", "u =", "AB =", "BC =", "uABC"})
          EXPECT_EQ(text->text.find(word), std::string::npos) << id << ": " << text->text;
      }
    }
  }
  EXPECT_EQ(frames_of("triangle-features")[0].text.caption,
            "Q lies in region A: its projections onto both edges at A fall beyond A.");
}

TEST(Panel, ARoundingErrorIsNoDistance) {
  const std::vector<std::string> before = texts_of_frame("stop-edge-left", 2);
  EXPECT_EQ(after(before, "Distance lies in"), "[0.000, 0.000]");
  const std::vector<std::string> exact = texts_of_frame("stop-edge-left", 6);
  EXPECT_EQ(after(exact, "Distance lies in"), "[0.000, 0.000]");
}

/// The lesson's query from a vertex: an iteration in which both runs do the same.
Lesson direction_half_from_b() {
  Lesson lesson = testing::shipped_lesson("direction-half");
  lesson.options.start.count = 1;
  lesson.questions.clear();
  return lesson;
}

TEST(Captions, SayWhichNumbersRoundingMade) {
  const LessonRun run = run_lesson(direction_half_from_b());
  const std::vector<FrameText> texts = testing::texts_of(run);
  const Eigen::Vector2d b(-90.0, -35.0), d(120.0, -15.0), q(0.5, -26.5);
  EXPECT_TRUE(texts[1].detail.ends_with("exact arithmetic has " + fixed((q - b).norm(), 3) + "."))
      << texts[1].detail;
  EXPECT_TRUE(texts[3].caption.ends_with("exact arithmetic has " + fixed((q - b).dot(d), 3) + "."))
      << texts[3].caption;
  EXPECT_TRUE(texts[4].detail.ends_with("exact arithmetic has " + fixed((q - b).norm(), 3) + "."))
      << texts[4].detail;
}

TEST(Panel, TwoRunsAreColouredOnlyWhereTheyDiffer) {
  const LessonRun run = run_lesson(direction_half_from_b());
  EffectGraph effects(run);
  const auto frames = lesson_pictures(run, effects, fonts());
  const auto coloured = [&](std::size_t frame, const std::string& words) {
    for (const Mark& mark : frames[frame].picture.marks) {
      const Text* text = std::get_if<Text>(&mark.shape);
      if (text && text->text == words) return mark.role == "fail" || mark.role == "pass";
    }
    ADD_FAILURE() << "no " << words;
    return false;
  };
  EXPECT_FALSE(coloured(1, "−90")) << "P is B in both runs, with other digits";
  EXPECT_TRUE(coloured(6, "−26.375"));
}

TEST(Panel, TheMapsComeBeforeWhatTheySayOfQ) {
  const auto shown = [](int frame) {
    const std::vector<std::string> texts = texts_of_frame("triangle-two-maps", frame);
    return std::find(texts.begin(), texts.end(), "✗ not the same") != texts.end();
  };
  EXPECT_FALSE(shown(0));
  EXPECT_FALSE(shown(7));
  EXPECT_TRUE(shown(8));
}

/// The names in a list with commas between them.
std::vector<std::string_view> names_in(std::string_view list) {
  std::vector<std::string_view> names;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(','), list.size());
    names.push_back(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return names;
}

TEST(Effects, OnlyTheOnesThatAMarkNeedsAreComputedAndEachPullsWhatItSays) {
  std::set<std::pair<std::string_view, std::string_view>> pulls;
  for (const Lesson& lesson : testing::shipped_lessons()) {
    const LessonRun run = run_lesson(lesson);
    EffectGraph effects(run);
    (void)lesson_pictures(run, effects, fonts());
    pulls.insert(effects.pulls().begin(), effects.pulls().end());
    std::set<std::string> called;
    for (const LessonView& view : lesson.views)
      called.insert(view.effects.begin(), view.effects.end());
    const bool counts =
        std::find(lesson.panel.begin(), lesson.panel.end(), "counters") != lesson.panel.end();
    // Effects that these pull themselves, and those that they pull.
    std::set<std::string> wanted = called;
    if (counts) wanted.insert("touched-points");
    for (const EffectInfo* effect : registered_effects()) {
      if (!wanted.contains(std::string(effect->name))) continue;
      for (const EffectInfo* other : registered_effects()) {
        if (gjkscope::pulls(*effect, other->name)) wanted.emplace(other->name);
      }
    }
    for (const EffectInfo* effect : registered_effects()) {
      const bool wanted_by_view = called.contains(std::string(effect->name));
      // In space the differences are drawn by their hull there.
      const bool is_of_solid =
          lesson.dimension == 3 && wanted_by_view && effect->name.starts_with("minkowski-");
      const long runs = effects.count(is_of_solid ? "difference-solid" : effect->name).runs;
      if (wanted_by_view) {
        EXPECT_GT(runs, 0) << lesson.id << " calls for " << effect->name
                           << " and draws nothing of it";
      }
      if (!wanted.contains(std::string(effect->name)) && effect->used_by == "view") {
        EXPECT_EQ(runs, 0) << lesson.id << " does not call for " << effect->name;
      }
      EXPECT_LE(effects.count(effect->name).runs, effects.count(effect->name).pulls);
    }
  }
  for (const EffectInfo* effect : registered_effects()) {
    std::set<std::string_view> pulled;
    for (const auto& [from, to] : pulls) {
      if (from == effect->name) pulled.insert(to);
    }
    const std::vector<std::string_view> needs = names_in(effect->needs);
    EXPECT_EQ(pulled, std::set<std::string_view>(needs.begin(), needs.end())) << effect->name;
  }
}

TEST(Grid, LinesAreRoundNumbersApartAndNumbersHaveRoom) {
  for (Lesson lesson : testing::lessons_for_long_tests()) {
    if (lesson.dimension == 3) continue;  // which has a floor
    SCOPED_TRACE(lesson.id);
    for (LessonView& view : lesson.views) {
      if (shows_shapes(view.kind)) view.effects.emplace_back("grid");
    }
    const LessonRun run = run_lesson(lesson);
    EffectGraph effects(run);
    LessonPictures pictures(run, effects, fonts());
    const Picture picture = pictures.picture(0);
    for (const LessonPictures::ShownView& shown : pictures.views()) {
      std::vector<double> xs;
      std::vector<double> ys;
      std::vector<Rect> numbers;
      for (const Mark& mark : picture.marks) {
        const auto is_here = [&](const Point& p) { return inside(shown.card, {p, p}); };
        if (const Polyline* line = std::get_if<Polyline>(&mark.shape);
            line && mark.role.starts_with("grid.") && is_here(line->points[0])) {
          const bool is_upright = line->points[0].x() == line->points[1].x();
          const double at = is_upright ? line->points[0].x() : line->points[0].y();
          (is_upright ? xs : ys).push_back(at);
          const StageMap map(shown.card, shown.camera);
          if (mark.role == "grid.axis") {
            const Point origin = map(Eigen::Vector2d::Zero());
            EXPECT_NEAR(is_upright ? origin.x() : origin.y(), at, 1e-6);
          }
        }
        const Text* text = std::get_if<Text>(&mark.shape);
        if (text && mark.role == "grid.number" && is_here(text->at))
          numbers.push_back(box_of(fonts(), *text));
      }
      for (const std::vector<double>* places : {&xs, &ys}) {
        EXPECT_LT(places->size(), 30u);
        std::vector<double> apart;
        for (std::size_t i = 1; i < places->size(); ++i)
          apart.push_back(std::abs((*places)[i] - (*places)[i - 1]));
        for (const double each : apart) {
          EXPECT_GE(each, 63.0);
          EXPECT_NEAR(apart.front(), each, 1e-3);
        }
      }
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        EXPECT_TRUE(inside(shown.card, numbers[i]))
            << numbers[i].min.transpose() << " to " << numbers[i].max.transpose() << " in "
            << shown.card.min.transpose() << " to " << shown.card.max.transpose();
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(numbers[i], numbers[j]));
      }
    }
  }
}

/// The numbers of two runs, by the height of their row: "fail" has that of the first, "pass" that
/// of the second.
std::map<double, std::map<std::string, const Text*>> rows_that_differ(const Picture& picture) {
  std::map<double, std::map<std::string, const Text*>> rows;
  for (const Mark& mark : picture.marks) {
    const Text* text = std::get_if<Text>(&mark.shape);
    if (text && text->style == type::kCodeBold && (mark.role == "fail" || mark.role == "pass"))
      rows[text->at.y()][mark.role] = text;
  }
  return rows;
}

TEST(TwoRuns, DigitsThatDifferAreUnderlined) {
  const LessonRun run = run_lesson(testing::shipped_lesson("direction-half"));
  EffectGraph effects(run);
  int differing = 0;
  for (const FramePicture& frame : lesson_pictures(run, effects, fonts())) {
    for (const auto& [y, texts] : rows_that_differ(frame.picture)) {
      if (texts.size() != 2) continue;
      const std::u32string one = code_points(texts.at("fail")->text);
      const std::u32string other = code_points(texts.at("pass")->text);
      if (one == U"–" || other == U"–") continue;
      std::size_t same = 0;
      while (same < std::min(one.size(), other.size()) && one[same] == other[same]) ++same;
      for (const auto& [role, text] : texts) {
        const std::size_t length = code_points(text->text).size();
        double underlined = 0.0;
        for (const Mark& mark : frame.picture.marks) {
          const Box* box = std::get_if<Box>(&mark.shape);
          if (box && mark.role == role && box->rect.max.x() == text->at.x() &&
              std::abs(box->rect.min.y() - y) < 6.0)
            underlined = box->rect.size().x();
        }
        EXPECT_NEAR(fonts().width(type::kCodeBold, std::string(length - same, '0')), underlined,
                    1e-6)
            << texts.at("fail")->text << " | " << texts.at("pass")->text;
        ++differing;
      }
    }
  }
  EXPECT_GT(differing, 10);
}

/// Two polygons in double, and in exact arithmetic beside it.
LessonRun two_runs_of_polygons() {
  Lesson lesson = testing::shipped_lesson("polygons-gjk");
  lesson.settings = TourSettings(LessonSecond{.scalar = ScalarKind::exact});
  for (LessonView& view : lesson.views) view.effects.emplace_back("second-run");
  lesson.panel = {"pseudocode", "two-runs"};
  return run_lesson(lesson);
}

TEST(TwoRuns, TellOfPWhereThePanelHasIt) {
  const LessonRun run = two_runs_of_polygons();
  EffectGraph effects(run);
  int shown = 0;
  for (const FramePicture& frame : lesson_pictures(run, effects, fonts())) {
    const std::string start = "In exact arithmetic P = (";
    const std::size_t at = frame.text.detail.find(start);
    if (at == std::string::npos) continue;
    const std::string rest = frame.text.detail.substr(at + start.size());
    const auto number = [](std::string text) {
      const std::string minus = "−";
      if (text.starts_with(minus)) text.replace(0, minus.size(), "-");
      return std::strtod(text.c_str(), nullptr);
    };
    const double x = number(rest.substr(0, rest.find(", ")));
    constexpr double kRounding = 0.002;  // the caption rounds to three decimals
    const auto is_x = [&](const Mark& mark) {
      const Text* text = std::get_if<Text>(&mark.shape);
      const bool is_value = mark.role == "pass" || mark.role == "code";
      return text && is_value && std::abs(number(text->text) - x) < kRounding;
    };
    EXPECT_TRUE(std::any_of(frame.picture.marks.begin(), frame.picture.marks.end(), is_x))
        << frame.text.detail;
    ++shown;
  }
  EXPECT_GT(shown, 0);
}

TEST(TwoRuns, NumbersThatDifferAreWrittenApart) {
  const LessonRun run = two_runs_of_polygons();
  EffectGraph effects(run);
  int pairs = 0;
  for (const FramePicture& frame : lesson_pictures(run, effects, fonts())) {
    for (const auto& [y, texts] : rows_that_differ(frame.picture)) {
      if (texts.size() != 2) continue;
      const Text& first = *texts.at("fail");
      const Text& second = *texts.at("pass");
      EXPECT_NE(first.text, second.text);
      // They do not meet.
      EXPECT_GT(second.at.x() - fonts().width(second.style, second.text), first.at.x());
      ++pairs;
    }
  }
  EXPECT_GT(pairs, 0);
}

TEST(Panel, SmallValuesAreNoZerosInTheListing) {
  Lesson lesson = testing::shipped_lesson("polygons-gjk");
  for (LessonShape& shape : lesson.bodies) {
    for (Eigen::Vector3d& vertex : shape.vertices) vertex *= 1e-6;
  }
  lesson.expect = {};
  const LessonRun run = run_lesson(lesson);
  EffectGraph effects(run);
  int values = 0;
  for (const FramePicture& frame : lesson_pictures(run, effects, fonts())) {
    for (const Mark& mark : frame.picture.marks) {
      const Text* text = std::get_if<Text>(&mark.shape);
      if (!text || text->text.front() != '(' || !mark.role.starts_with("code")) continue;
      EXPECT_NE(std::string::npos, text->text.find_first_of("123456789")) << text->text;
      ++values;
    }
  }
  EXPECT_GT(values, 10);
}

TEST(Panel, TheStopOfARunLightsOneLine) {
  for (const char* id : {"polygons-gjk", "reported-diamonds", "stop-vertex", "stop-repeated"}) {
    Lesson lesson = testing::shipped_lesson(id);
    lesson.listing = "gjk";
    if (!lesson.has_block("pseudocode")) lesson.panel.insert(lesson.panel.begin(), "pseudocode");
    const LessonRun run = run_lesson(lesson);
    EffectGraph effects(run);
    const auto frames = lesson_pictures(run, effects, fonts());
    const auto& marks = frames.back().picture.marks;
    const auto lit = std::count_if(marks.begin(), marks.end(), [](const Mark& mark) {
      const Text* text = std::get_if<Text>(&mark.shape);
      return text && mark.role == "code.current" && mark.subject.kind == Subject::Kind::phase;
    });
    EXPECT_EQ(1, lit) << id;
  }
}

TEST(Panel, AValueThatDoesNotFitTakesRoomFromTheListing) {
  Lesson lesson = testing::shipped_lesson("polygons-gjk");
  for (std::size_t body = 0; body < 2; ++body) {
    LessonShape& shape = lesson.bodies[body];
    for (std::size_t i = 0; i < shape.vertices.size(); ++i)
      shape.vertex_names[i] = fmt::format("{}{}", body == 0 ? "x" : "y", 11 + i);
  }
  lesson.expect = {};
  lesson.scalar = ScalarKind::half;
  const LessonRun run = run_lesson(lesson);
  EffectGraph effects(run);
  int supports = 0;
  for (const FramePicture& frame : lesson_pictures(run, effects, fonts())) {
    if (frame.text.phase != "support") continue;
    const auto& marks = frame.picture.marks;
    EXPECT_TRUE(std::any_of(marks.begin(), marks.end(), [](const Mark& mark) {
      const Text* text = std::get_if<Text>(&mark.shape);
      return text && mark.role == "code.value" && text->text.starts_with("y1");
    }));
    ++supports;
  }
  EXPECT_GT(supports, 0);
}

}  // namespace frame_test
}  // namespace gjkscope
