// Shapes of the world take up their card.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "fonts.hpp"
#include "frames/frame.hpp"
#include "lessons.hpp"
#include "picture/text_box.hpp"
#include "run/trail.hpp"

namespace gjkscope::fill_test {

bool is_of_shapes(const std::string& role) {
  return role.starts_with("shape") || role.starts_with("query");
}

/// The marks' points, each with room around it.
struct Extent {
  Eigen::AlignedBox2d box;
  Eigen::AlignedBox2d card;

  void add(const Point& p, double radius) {
    const Point around = Point::Constant(radius);
    const Eigen::AlignedBox2d seen = Eigen::AlignedBox2d(p - around, p + around).intersection(card);
    if (!seen.isEmpty()) box.extend(seen);
  }
  void operator()(const Polygon& polygon) {
    for (const Point& p : polygon.points) add(p, 0.0);
  }
  void operator()(const Polyline& line) {
    for (const Point& p : line.points) add(p, 0.0);
  }
  void operator()(const Disk& disk) { add(disk.center, disk.radius); }
  void operator()(const Cross& cross) { add(cross.center, cross.radius); }
  void operator()(const Arrow&) {}
  void operator()(const Box&) {}
  void operator()(const Text&) {}
};

/// The larger of the shares of the width and of the height that the box around the marks of shapes
/// takes of the card below its title, less what the names of vertices take beside that box. A point
/// outside of the card counts for nothing. 1 where there is no shape.
double share(const Picture& picture, const Rect& card) {
  Extent shapes{{}, {card.min, card.max}};
  for (const Mark& mark : picture.marks) {
    const bool is_here =
        mark.clip >= 0 &&
        overlap(picture.clips[static_cast<std::size_t>(mark.clip)], {card.center(), card.center()});
    if (is_here && is_of_shapes(mark.role))
      std::visit([&](const auto& s) { shapes(s); }, mark.shape);
  }
  if (shapes.box.isEmpty()) return 1.0;
  Eigen::AlignedBox2d named = shapes.box;
  double title = 0.0;
  for (const Mark& mark : picture.marks) {
    const Box* box = std::get_if<Box>(&mark.shape);
    if (box && mark.role == "view-title.box" && overlap(box->rect, card))
      title = box->rect.max.y() - card.min.y();
    const Text* text = std::get_if<Text>(&mark.shape);
    if (!text || !is_of_shapes(mark.role)) continue;
    const Rect name = box_of(testing::fonts(), *text);
    if (overlap(name, card)) named.extend(name.min).extend(name.max);
  }
  const Point room = card.size() - Point(0.0, title) - (named.sizes() - shapes.box.sizes());
  return (shapes.box.sizes().array() / room.array()).maxCoeff();
}

TEST(Fill, InNineOfTenWorldViewsShapesTakeHalfOfTheRoom) {
  int views = 0;
  int narrow = 0;
  std::string which;
  for (Lesson lesson : testing::lessons_for_long_tests()) {
    lesson.questions.clear();
    const LessonRun run = run_lesson(lesson);
    EffectGraph effects(run);
    LessonPictures pictures(run, effects, testing::fonts());
    int of_lesson = 0;
    double least = 1.0;
    for (int i = 0; i < static_cast<int>(run.frames.size()); ++i) {
      if (is_trail(run.frames[static_cast<std::size_t>(i)])) continue;
      const Picture picture = pictures.picture(i);
      for (const LessonPictures::ShownView& view : pictures.views()) {
        if (view.kind != ViewKind::world) continue;
        const double taken = share(picture, view.card);
        ++views;
        of_lesson += taken < 0.5 ? 1 : 0;
        least = std::min(least, taken);
      }
    }
    narrow += of_lesson;
    if (of_lesson > 0) which += fmt::format("{}: {} frames, {:.2f}\n", lesson.id, of_lesson, least);
  }
  EXPECT_GT(views, 300);
  EXPECT_LE(10 * narrow, views) << narrow << " of " << views << ":\n" << which;
}

}  // namespace gjkscope::fill_test
