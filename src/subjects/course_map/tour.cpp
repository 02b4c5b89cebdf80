// A map of the course: a picture for each chapter, and what each of them makes use of.

#include <fmt/format.h>

#include <array>

#include "subjects/course_map/tiles.hpp"
#include "subjects/guess/subject.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::maps_of_course {
namespace {

using Eigen::Vector2d;
using namespace sizes;

struct Chapter {
  std::string_view title;  ///< As in assets/chapters.toml.
  std::string_view caption;
  std::string_view detail;
};

constexpr int kChapters = 9;
constexpr int kOfGjk = 4;  // chapters that each make use of the one before
constexpr int kColumns = 5;
constexpr std::array<Chapter, kChapters> kCourse = {{
    {"Point to segment", "Chapter 1: which point of a segment is closest to Q?",
     "An end, or a point between: three cases, and two numbers that tell which."},
    {"Point to triangle", "Chapter 2: which point of a triangle is closest to Q?",
     "Each edge is a segment, so chapter 1 is used three times. New: areas, and the inside."},
    {"Point to polygon", "Chapter 3: which point of a convex polygon is closest to Q? This is GJK.",
     "A triangle inside the polygon stands in for it; a segment has no inside. A loop changes it "
     "until it holds the answer."},
    {"Polygon to polygon", "Chapter 4: which points of two convex polygons are closest?",
     "The differences of their points form one polygon, and the origin O stands in for Q."},
    {"Minkowski sums", "Chapter 5: what else the difference of two shapes tells.",
     "Moving among obstacles, proofs that an answer is right, how deep shapes overlap."},
    {"Numerics", "Chapter 6: what rounding does to all this.",
     "Needles, shapes far away, shapes that touch: where programs answered wrongly, and why."},
    {"Features and general models", "Chapter 7: shapes that move, and shapes that are not convex.",
     "Walking along both outlines, cutting into convex pieces, trees of boxes and circles."},
    {"Mistakes",
     "Chapter 8: what goes wrong in programs, and how to find the step that is to blame.",
     "A loop with one wrong line runs beside the right loop until they differ."},
    {"In space", "Chapter 9: the same loop for polyhedra.",
     "To read on: van den Bergen, Collision Detection in Interactive 3D Environments (2004), a "
     "program; Ericson, Real-Time Collision Detection (2005), with code; Muratori, Implementing "
     "GJK, a film."},
}};

constexpr double kWidth = 3.6;
constexpr double kHeight = 2.3;
constexpr double kBetween = 0.9;
constexpr double kBelow = 0.85;  // for the title

/// Lower left corner of a chapter's picture.
Vector2d corner(int chapter) {
  const int row = chapter / kColumns;
  const int column = chapter % kColumns;
  // The second row has one picture less, over the same width.
  const double apart =
      row == 0 ? kWidth + kBetween : (kColumns - 1) * (kWidth + kBetween) / (kColumns - 2);
  return {column * apart, -row * (kHeight + kBelow)};
}

/// The chapters that a frame describes.
int chapter_of(const Frame& frame) { return frame.part; }

void frames(LessonRun& run, int index) { guesses::add_part_frames(run, index, kChapters + 1); }

Tick tick(const LessonRun&, const Frame& frame) {
  const int chapter = chapter_of(frame);
  if (chapter == 0) return {.group = "start"};
  return {.group = chapter <= kOfGjk ? "GJK" : "beyond",
          .label = fmt::format("chapter {}", chapter),
          .short_label = std::to_string(chapter)};
}

constexpr AskInfo kAskUses{"uses", "the solved problem that a new one makes use of", "of chapter"};
constexpr std::array kAsks = {kAskUses};

int answering_step(const LessonRun&, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const int chapter = chapter_of(frame);
  return chapter >= 3 && chapter <= kOfGjk && question.at.value_or(chapter) == chapter ? frame.step
                                                                                       : -1;
}

void question(const Story& story, FrameText& text) {
  const int next = chapter_of(story.frame) + 1;
  FrameQuestion& asked = text.question.emplace(FrameQuestion{std::string(kAskUses.name), {}, {}});
  for (int i = 0; i + 1 < next; ++i) {
    const Vector2d middle = corner(i) + 0.5 * Vector2d(kWidth, kHeight);
    const Vector2d half(0.5 * (kWidth - kHeight), 0.0);
    asked.choices.emplace_back(kCourse[i].title);
    asked.spots.push_back(
        Spot{ViewKind::world, Vector2d(middle - half), Vector2d(middle + half), 0.5 * kHeight});
  }
  asked.answer = asked.choices.back();
  text.caption = next == kOfGjk
                     ? "Question: the closest points of two polygons. Which solved problem can "
                       "this become?"
                     : "Question: picture 3 shows a polygon. Which is the largest solved problem "
                       "that fits into it, again and again?";
}

void words(const Story& story, FrameText& text) {
  const int chapter = chapter_of(story.frame);
  if (chapter == 0) {
    text.caption = "A map of this course: arrows will show which problem makes use of which.";
    text.detail =
        "Its goal is GJK, named after Gilbert, Johnson and Keerthi, who published it in 1988. It "
        "follows the slides of Catto (2010) and Larsen (1998).";
    return;
  }
  const Chapter& at = kCourse[static_cast<std::size_t>(chapter) - 1];
  text.caption = at.caption;
  text.detail = at.detail;
}

/// Draws in the lower left corner of a chapter's picture.
struct Tile {
  SceneBuilder& scene;
  Vector2d origin;
  [[nodiscard]] Point at(double x, double y) const {
    return scene.at(Vector2d(origin + Vector2d(x, y)));
  }
  void shape(const std::string& role, const std::vector<Vector2d>& corners) const {
    std::vector<Point> points;
    for (const Vector2d& each : corners) points.push_back(at(each.x(), each.y()));
    scene.area(role, points);
  }
  void line(double x0, double y0, double x1, double y1) const {
    scene.line("closest.line", at(x0, y0), at(x1, y1));
    scene.disk("closest", at(x1, y1), kClosestRadius);
  }
  void query(double x, double y) const { scene.cross("query", at(x, y), kPointRadius); }
};

void picture(SceneBuilder& scene, int chapter) {
  const Tile tile{scene, corner(chapter)};
  switch (chapter) {
    case 0:
      scene.line("shape", tile.at(0.6, 0.5), tile.at(3.0, 0.9));
      tile.line(1.4, 1.9, 1.607, 0.668);
      return tile.query(1.4, 1.9);
    case 1:
      tile.shape("shape", {{0.4, 0.4}, {2.2, 0.4}, {1.3, 1.9}});
      tile.line(2.9, 1.7, 1.858, 0.97);
      return tile.query(2.9, 1.7);
    case 2:
      tile.shape("shape", {{0.3, 0.9}, {1.0, 0.3}, {2.0, 0.4}, {2.3, 1.1}, {1.6, 1.9}, {0.7, 1.8}});
      tile.shape("simplex", {{0.3, 0.9}, {2.3, 1.1}, {1.6, 1.9}});
      tile.line(3.0, 2.0, 2.116, 1.31);
      return tile.query(3.0, 2.0);
    case 4:
      tile.shape("hull", {{0.5, 1.0}, {1.2, 0.4}, {2.5, 0.4}, {3.0, 1.1}, {2.4, 1.9}, {1.1, 1.9}});
      scene.cross("origin", tile.at(1.5, 1.0), kOriginRadius);
      return;
    case 5:
      tile.shape("shape", {{0.3, 1.0}, {3.2, 1.06}, {0.35, 1.12}});
      scene.line("rounded.x", tile.at(0.3, 1.35), tile.at(3.3, 1.45));
      return tile.line(2.0, 1.75, 2.02, 1.1);
    case 6: {
      const std::vector<Vector2d> corners = {{0.4, 0.3}, {3.0, 0.3}, {3.0, 1.9}, {2.4, 1.9},
                                             {2.4, 0.9}, {1.0, 0.9}, {1.0, 1.9}, {0.4, 1.9}};
      std::vector<Point> points;
      for (const Vector2d& each : corners) points.push_back(tile.at(each.x(), each.y()));
      scene.add("path.end", Polyline{points, true});
      tile.shape("shape.y", {{1.4, 1.4}, {2.0, 1.3}, {1.8, 1.9}});
      return tile.line(2.0, 1.3, 2.0, 0.9);
    }
    case 7:
      scene.line("shape", tile.at(0.6, 0.5), tile.at(3.0, 0.9));
      scene.line("guess.way", tile.at(1.4, 1.9), tile.at(3.0, 0.9));
      tile.line(1.4, 1.9, 1.607, 0.668);
      return tile.query(1.4, 1.9);
    case 8:
      tile.shape("shape", {{0.5, 0.5}, {2.9, 0.3}, {3.0, 1.0}, {1.6, 2.0}});
      scene.line("shape", tile.at(2.9, 0.3), tile.at(1.6, 2.0));
      return scene.add("shape.hidden", Polyline{{tile.at(0.5, 0.5), tile.at(3.0, 1.0)}});
    default:  // the lesson's own shapes
      return;
  }
}

void stage(SceneBuilder& scene) {
  const int current = chapter_of(scene.frame);
  for (int i = 0; i < kChapters; ++i) {
    const Vector2d low = corner(i);
    const Vector2d high = low + Vector2d(kWidth, kHeight);
    const Rect box{{scene.at(low).x(), scene.at(high).y()},
                   {scene.at(high).x(), scene.at(low).y()}};
    const bool is_current = i + 1 == current && scene.frame.question < 0;
    scene.add(is_current ? "map.tile.current" : "map.tile", Box{box, 8.0});
    if (i > 0 && i < kOfGjk && i < current) {
      const Point from(box.min.x() - 4.0, box.center().y());
      const double gap = scene.map.scale() * kBetween;
      scene.arrow("map.uses", from, from - Point(gap - 8.0, 0.0));
    }
    scene.out.marks.push_back({"map.title", Text{{box.center().x(), box.max.y() + 20.0},
                                                 fmt::format("{}  {}", i + 1, kCourse[i].title),
                                                 is_current ? type::kStrong : type::kText,
                                                 Align::center}});
    picture(scene, i);
  }
  const WideResult& result = scene.positioned.trace.result;
  scene.line("closest.line", scene.at(result.x), scene.at(result.y));
  for (const Eigen::Vector3d& point : {result.x, result.y})
    scene.disk("closest", scene.at(point), kClosestRadius);
}

/// All pictures, and the titles below them.
void reach(const LessonRun&, int, ViewKind, Eigen::AlignedBox2d& seen) {
  seen.extend(Vector2d(0.0, corner(kColumns).y() - kBelow));
  seen.extend(corner(kColumns - 1) + Vector2d(kWidth, kHeight));
}

const Tour kTour{
    .name = "course-map",
    .meaning = "chapter on a map of the course; the shapes make the picture of chapter 4",
    .needs = {.path = PathUse::refused,
              .most_vertices = 8,
              .why_no_until = "frames go through the chapters"},
    .add_frames = frames,
    .asks = kAsks,
    .answering_step = answering_step,
    .algorithm = &kGjkAlgorithm,
    .knows = guesses::knows_nothing,
    .position = position_in_lesson,
    .tick = tick,
    .words = words,
    .stage = stage,
    .reach = reach,
    .question = question,
    .values = guesses::values,
};

}  // namespace
}  // namespace gjkscope::maps_of_course

namespace gjkscope {

std::vector<Rect> tiles_of_map(const Picture& picture) {
  constexpr double kTitle = 30.0;  // below a tile
  std::vector<Rect> tiles;
  for (const Mark& mark : picture.marks) {
    if (!mark.role.starts_with("map.tile")) continue;
    tiles.push_back(std::get<Box>(mark.shape).rect);
    tiles.back().max.y() += kTitle;
  }
  return tiles;
}

std::string style_of_tile(const Rect& tile, const Point& whole) {
  const Point at = 100.0 * tile.min.cwiseQuotient(whole);
  const Point size = 100.0 * tile.size().cwiseQuotient(whole);
  return fmt::format("left: {:.2f}%; top: {:.2f}%; width: {:.2f}%; height: {:.2f}%", at.x(), at.y(),
                     size.x(), size.y());
}

const SubjectParts subjects::course_map{
    .tours = {&maps_of_course::kTour},
    .legend = {{"map.uses", "makes use of"}},
};

}  // namespace gjkscope
