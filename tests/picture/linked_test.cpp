// World and difference side by side: both views show the same step, and the words say what it says.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "frames/frame.hpp"
#include "lessons.hpp"
#include "picture/text_box.hpp"
#include "run/facts.hpp"
#include "run/trail.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace linked_test {

using testing::shipped_lesson;

std::vector<FramePicture> pictures_of(const LessonRun& run) {
  const Fonts fonts(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  EffectGraph effects(run);
  return lesson_pictures(run, effects, fonts);
}

/// Marks of a role in a view; in none: labels, and those of the panel.
template <class Shape>
std::vector<Shape> marks(const FramePicture& frame, const std::string& role, int view) {
  std::vector<Shape> out;
  for (const Mark& mark : frame.picture.marks) {
    const Shape* shape = std::get_if<Shape>(&mark.shape);
    if (shape && mark.role == role && mark.clip == view) out.push_back(*shape);
  }
  return out;
}

double length(const Polyline& line) { return (line.points.back() - line.points.front()).norm(); }

TEST(Linked, TheSupportPairLightsUpInAllThreePlaces) {
  const LessonRun run = run_lesson(shipped_lesson("minkowski-support"));
  const auto frames = pictures_of(run);
  ASSERT_EQ(frames.size(), 18u) << "four parts in four iterations, two questions";
  for (std::size_t i = 0; i < frames.size(); ++i) {
    SCOPED_TRACE(i + 1);
    const SupportPart part = *support_part(run, run.frames[i]);
    EXPECT_EQ(marks<Polygon>(frames[i], "support.vertex", 0).size(),
              static_cast<std::size_t>(std::min(static_cast<int>(part), 2)));
    // A vertex of S stays in sight in a second, larger diamond.
    const WideState& state = run.state(run.frames[i]);
    const std::size_t diamonds = has_pair(state.simplex, state.support.pair) ? 2 : 1;
    EXPECT_EQ(marks<Polygon>(frames[i], "support.vertex", 1).size(),
              part == SupportPart::of_z ? diamonds : 0u);
  }
}

TEST(Linked, BothViewsShowTheSameShortestWay) {
  // The lesson promises both views at one scale.
  const LessonRun run = run_lesson(shipped_lesson("minkowski-distance"));
  int ways = 0;
  for (const FramePicture& frame : pictures_of(run)) {
    const auto world = marks<Polyline>(frame, "closest.line", 0);
    const auto difference = marks<Polyline>(frame, "closest.line", 1);
    ASSERT_EQ(world.size(), difference.size());
    if (world.empty()) continue;
    ++ways;
    EXPECT_NEAR(length(world[0]), length(difference[0]), 1e-9);
    const Point along_world = world[0].points[1] - world[0].points[0];
    const Point along_difference = difference[0].points[1] - difference[0].points[0];
    EXPECT_NEAR(std::abs(along_world.dot(along_difference)),
                along_world.norm() * along_difference.norm(), 1e-9)
        << "they are parallel";
  }
  EXPECT_EQ(ways, 4);
}

/// The share of a card below its title that is taken by the box of what is drawn there with its
/// labels, but for lines that leave the card.
double share_filled(const FramePicture& frame, const Rect& card, int view, const Fonts& fonts) {
  constexpr double kTitle = 38.0;
  const Rect inner{card.min + Point(0.0, kTitle), card.max};
  Eigen::AlignedBox2d drawn;
  const auto extend = [&](const std::vector<Point>& points) {
    const Eigen::AlignedBox2d room(card.min, card.max);
    if (std::all_of(points.begin(), points.end(),
                    [&](const Point& point) { return room.contains(point); }))
      for (const Point& point : points) drawn.extend(point);
  };
  for (const Mark& mark : frame.picture.marks) {
    if (mark.role.starts_with("view-title") || mark.role.starts_with("legend")) continue;
    if (const Text* text = std::get_if<Text>(&mark.shape)) {
      const Rect box = box_of(fonts, *text);
      extend({box.min, box.max});
    }
    if (mark.clip != view) continue;
    if (const Polygon* polygon = std::get_if<Polygon>(&mark.shape)) extend(polygon->points);
    if (const Polyline* line = std::get_if<Polyline>(&mark.shape)) extend(line->points);
    if (const Disk* disk = std::get_if<Disk>(&mark.shape)) {
      const Point radius = Point::Constant(disk->radius);
      extend({disk->center - radius, disk->center + radius});
    }
  }
  return drawn.volume() / inner.size().prod();
}

TEST(Linked, TwoViewsUseTheirRoom) {
  const Fonts fonts(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  std::vector<double> shares;
  for (const Lesson& lesson : testing::lessons_for_long_tests()) {
    const bool fits = lesson.views.size() == 2 &&
                      std::all_of(lesson.views.begin(), lesson.views.end(), [](const auto& view) {
                        return shows_shapes(view.kind) && !view.camera;
                      });
    if (!fits || lesson.path_of_shapes) continue;  // a path needs room for all of it
    const LessonRun run = run_lesson(lesson);
    for (const FramePicture& frame : pictures_of(run)) {
      int view = 0;
      for (const Mark& mark : frame.picture.marks) {
        if (mark.role != "card" || view == 2) continue;
        shares.push_back(share_filled(frame, std::get<Box>(mark.shape).rect, view, fonts));
        ++view;
      }
    }
  }
  ASSERT_GT(shares.size(), 200u);
  const auto middle = shares.begin() + static_cast<std::ptrdiff_t>(shares.size() / 2);
  std::nth_element(shares.begin(), middle, shares.end());
  EXPECT_GE(*middle, 0.6);
}

TEST(Linked, PairsAreNamedInTheColoursOfBothShapesAndLinked) {
  const LessonRun run = run_lesson(shipped_lesson("polygons-gjk"));
  int links = 0;
  for (const FramePicture& frame : pictures_of(run)) {
    links += static_cast<int>(marks<Polyline>(frame, "pair.link", 0).size());
    for (const char* role : {"simplex.label", "support.label"}) {
      for (const Text& text : marks<Text>(frame, role, -1)) {
        if (text.align == Align::left) continue;  // of the panel
        ASSERT_EQ(text.tones.size(), 3u) << text.text;
        EXPECT_EQ(text.tones[0].role, "shape.y.label");
        EXPECT_EQ(text.tones[2].role, "shape.x.label");
        EXPECT_EQ(text.tones[0].text + text.tones[1].text + text.tones[2].text, text.text);
      }
    }
  }
  EXPECT_GT(links, 10);
}

TEST(Linked, EveryCornerOfTheDifferenceIsNamedByItsPair) {
  const LessonRun run = run_lesson(shipped_lesson("polygons-gjk"));
  const auto frames = pictures_of(run);
  std::set<std::string> names;
  for (const char* role : {"cloud.label", "simplex.label"}) {
    for (const Text& text : marks<Text>(frames[0], role, -1)) names.insert(text.text);
  }
  EXPECT_EQ(names,
            (std::set<std::string>{"K−C", "K−D", "L−D", "L−E", "M−A", "M−E", "N−A", "N−B", "N−C"}));
}

TEST(Linked, WarmStartsAreChartedBesideColdOnes) {
  const LessonRun run = run_lesson(testing::lesson_without_questions("polygons-motion"));
  const auto frames = pictures_of(run);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    // One bar a position so far, and one in the key; the first run starts cold, too.
    EXPECT_EQ(marks<Box>(frames[i], "chart.cold", -1).size(), i + 3);
    EXPECT_EQ(marks<Box>(frames[i], "chart.warm", -1).size(), i + 1);
  }
}

TEST(Linked, EveryLessonCanBeToldByAnswersSupportPointsAndWeights) {
  const Fonts fonts(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  for (Lesson lesson : testing::lessons_for_long_tests()) {
    // Parts that go with the lesson's own tour stay away.
    std::erase_if(lesson.views, [](const LessonView& view) { return view.kind == ViewKind::plot; });
    std::erase_if(lesson.panel, [](const std::string& name) {
      const Term& block = *find_term(vocabulary().blocks, name);
      return !block.tour.empty() || !block.table.empty();
    });
    for (LessonView& view : lesson.views) std::erase(view.effects, "second-run");
    lesson.listing = "gjk";
    lesson.phases.clear();
    lesson.settings = {};
    lesson.questions.clear();
    for (const char* tour : {"answer", "support", "witness"}) {
      lesson.tour = tour;
      const LessonRun run = run_lesson(lesson);
      EffectGraph effects(run);
      for (const FramePicture& frame : lesson_pictures(run, effects, fonts)) {
        EXPECT_FALSE(frame.text.caption.empty()) << lesson.id;
        EXPECT_FALSE(frame.text.detail.empty()) << lesson.id;
      }
    }
  }
}

TEST(LinkedCaptions, SayWhatWasComputed) {
  // By hand: d = −(N − C) = −(2.4, 2.7); dot(d, L) = −2.4·1.25 + 2.7·0.3 = −2.19;
  // dot(−d, D) = −2.4·1.1 + 2.7·1.15 = 0.465.
  const auto support = pictures_of(run_lesson(shipped_lesson("minkowski-support")));
  EXPECT_EQ(support[4].text.caption,
            "L−D is the support point of Z: dot(d, L−D) = −2.190 + 0.465 = −1.725.");
  // K = (0.1, 1) against the line through B = (−0.6, 0) and C = (−1.6, 1.6):
  // weight of C = ((K − B)·(C − B)) / |C − B|² = (−0.7 + 1.6) / 3.56 = 0.253.
  const auto witness = pictures_of(run_lesson(shipped_lesson("polygons-witness")));
  EXPECT_EQ(witness[0].text.caption,
            "P = 0.747 (K−B) + 0.253 (K−C) is the point of Z closest to O.");
  EXPECT_EQ(witness[1].text.detail,
            "Both differences come from K, so y is K itself: (0.10, 1.00).");
  EXPECT_EQ(witness[2].text.caption,
            "The same weights on the vertices of X give x = 0.747 B + 0.253 C.");
  const auto slide =
      pictures_of(run_lesson(testing::lesson_without_questions("minkowski-translate")));
  EXPECT_EQ(slide[1].text.caption,
            "The robot moved by (0.25, 1.50), so Z slides by (−0.25, −1.50), the opposite way.");
  EXPECT_EQ(slide[6].text.caption,
            "Both moved by (0.50, −0.50): Z and everything in it stay where they were.");
}

TEST(LinkedCaptions, TouchingIsNotCalledOverlap) {
  Lesson lesson = testing::lesson_without_questions("minkowski-translate");
  const LessonRun shipped = run_lesson(lesson);
  const PositionedRun& last = shipped.runs.back();
  // B of the robot lies between N and R of the obstacle, and A and C lie beyond their line. All of
  // it exactly: coordinates are multiples of 1/4.
  const Eigen::Vector3d& n = last.y().world[3];
  const Eigen::Vector3d& r = last.y().world[4];
  const Eigen::Vector3d outwards(n.y() - r.y(), r.x() - n.x(), 0.0);
  EXPECT_EQ(last.x().world[1], 0.5 * (n + r));
  for (const Eigen::Vector3d& y : last.y().world) EXPECT_GE(outwards.dot(y - n), 0.0);
  EXPECT_LT(outwards.dot(last.x().world[0] - n), 0.0);
  EXPECT_LT(outwards.dot(last.x().world[2] - n), 0.0);
  const std::string touches =
      "The robot touches the obstacle: p lies on the boundary of the grown obstacle, O on that of "
      "Z.";
  EXPECT_EQ(pictures_of(shipped).back().text.caption, touches);

  // A step towards the obstacle, and one away from it.
  Eigen::Vector3d& goal = lesson.path_of_shapes->x().points.back();
  goal += 0.125 * outwards;
  EXPECT_EQ(pictures_of(run_lesson(lesson)).back().text.caption,
            "The robot and the obstacle overlap: p lies inside the grown obstacle, O inside Z.");
  goal -= 0.25 * outwards;
  EXPECT_TRUE(pictures_of(run_lesson(lesson)).back().text.caption.starts_with("Z slides by"));
  // Vertex on vertex.
  goal =
      shipped.runs.back().y().placement.translate + lesson.y().vertices[3] - lesson.x().vertices[1];
  EXPECT_EQ(pictures_of(run_lesson(lesson)).back().text.caption, touches);
}

TEST(LinkedCaptions, TheSlabProvesTheDistance) {
  const LessonRun run = run_lesson(shipped_lesson("slab-certificate"));
  const auto frames = pictures_of(run);
  // 1.3557 is the distance of K = (0.3, 0.8) from the line through C = (−0.9, −0.75) and
  // D = (−1.1, 1.15).
  const double distance = std::abs(1.9 * (0.3 + 0.9) + 0.2 * (0.8 + 0.75)) / std::hypot(1.9, 0.2);
  EXPECT_NEAR(distance, 1.3557, 5e-5);
  const FramePicture& answer = frames[static_cast<std::size_t>(answering_index(run))];
  EXPECT_EQ(answer.text.caption,
            "Stop: the empty slab is as wide as the closest points are apart, 1.356.");
  for (const FramePicture& frame : frames) {
    const bool has_slab = !marks<Polygon>(frame, "slab", 0).empty();
    EXPECT_EQ(has_slab, !marks<Polygon>(frame, "slab", 1).empty()) << "in both views";
  }
}

}  // namespace linked_test
}  // namespace gjkscope
