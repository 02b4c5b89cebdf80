#include "lesson/keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "base/decimal.hpp"

namespace gjkscope {

using namespace limits;

namespace {

constexpr std::string_view kPoints = "list of points [x, y]";

std::string list_of_turns() { return fmt::format("list of numbers from {} to {}", -kTurn, kTurn); }

void state_start(KeyPass& key, const Lesson& lesson) {
  const auto& start = lesson.options.start;
  if (start.count == 0) return key.other(as_text("center-to-center"));
  if (start.count == 1 && start.pairs[0] == gjk::VertexPair{}) return key.other();
  std::vector<std::string> names;
  for (int i = 0; i < start.count; ++i) {
    std::string name = lesson.y().vertex_names[start.pairs[i].y];
    if (lesson.x().vertices.size() > 1) name += "-" + lesson.x().vertex_names[start.pairs[i].x];
    names.push_back(as_text(name));
  }
  key.other_list(names);
}

}  // namespace

void head_keys(KeyPass& keys, Lesson& lesson) {
  keys("title", kRequired, "heading of every frame").text(lesson.title, kTitleLength);
  keys("chapter", kRequired, "chapter that the lesson belongs to")
      .whole_number(lesson.chapter, 0, kLastChapter);
  keys("order", kRequired, "place within the chapter").whole_number(lesson.order, 1, kLastOrder);
  keys("source", "none", "where the matter is taught").text(lesson.source, kSourceLength);
  keys("prose", kRequired, "what to look for, with placeholders; two lines of a frame")
      .long_text(lesson.prose, kProseLength);
  keys("opening", "none", "why the lesson is there: heads the words of the first frame")
      .long_text(lesson.opening, kOpeningLength);
  keys("next", "none", "what the next lesson answers: ends the words of the last frame")
      .long_text(lesson.next, kNextLength);
  keys("in_space", "none", "name of the lesson that shows the same in space: the page links to it")
      .text(lesson.in_space, kLessonIdLength);
  keys("shapes", kRequired, "the two shapes", "table [shapes]").other();
  keys("query", "its defaults", "how GJK runs", "table [query]").other();
  keys("steps", "its defaults", "which frames there are", "table [steps]").other();
  keys("path", "the shapes stay where they are", "positions of the shapes, one run each",
       "table [path]")
      .other();
  keys("views", kRequired, "the stages, from left to right",
       fmt::format("1 to {} tables [[views]]", kMostViews))
      .other();
  keys("panel", "no panel", "the side panel", "table [panel]").other();
  keys("questions", "none", "what frames ask before they tell it", "tables [[questions]]").other();
  keys("expect", kRequired, "what the run must come to; it is checked", "table [expect]").other();
}

void shape_keys(KeyPass& keys, LessonShape& shape) {
  keys("name", "X or Y", "name that frames show; what `Q` is in a point query")
      .text(shape.name, kShapeNameLength);
  keys("names", "the shape's name for a single vertex, else x1, x2, ... or y1, y2, ...",
       "names of the vertices, unique over both shapes",
       fmt::format("list of vertex names of 1 to {} characters, none a blank, comma or hyphen",
                   kVertexNameLength))
      .other_list(as_texts(shape.vertex_names));
  keys("vertices", kRequired,
       fmt::format("corners in drawing order, 1 to {} of them (a limit of drawing)", kVertices),
       std::string(kPoints))
      .other_list(as_texts(shape.vertices, keys.dimension));
  keys("outlines", "all vertices are one outline",
       "how many vertices each outline has, one outline after the other: counter-clockwise around "
       "what is solid, clockwise around a hole; only with tours of outlines",
       fmt::format("list of whole numbers of at least {} that add up to the vertices",
                   kOutlineVertices))
      .other_list(as_texts(shape.outlines));
  keys("translate", "", "where the shape's own origin stands").point(shape.translate);
  keys("rotate", "", "degrees counter-clockwise, before `translate`; in space about `axis`")
      .number(shape.rotate_degrees, -kTurn, kTurn);
  keys("axis", "[0, 0, 1]",
       "in space: the direction that the shape turns about, which is seen from its tip",
       "point [x, y, z]")
      .other(in_brackets(shape.axis, keys.dimension));
  keys("radius", "",
       "the shape is all points within this distance of the hull of the vertices; GJK asks about "
       "the hull, and frames that tell the end subtract the radii; only with tours whose "
       "frames tell how a run of GJK ends")
      .number(shape.radius, 0.0, keys.largest);
}

void query_keys(KeyPass& keys, Lesson& lesson) {
  gjk::Options& options = lesson.options;
  keys("scalar", "", "numbers that the run computes with")
      .choice<ScalarKind>(lesson.scalar, "scalar");
  keys("direction", "", "how the search direction is built")
      .choice<gjk::DirectionRule>(options.direction_rule, "direction rule");
  keys("regions", "",
       "order of the region tests; unchecked: vertices first, and each of them is believed")
      .choice<gjk::RegionOrder>(options.region_order, "region order");
  std::optional<std::array<bool, 2>> stop = {
      {options.stop_on_repeated_support, options.stop_on_no_progress}};
  keys("stop", "",
       "stop tests that may be left out; origin inside, zero direction and the cap always apply")
      .stop_tests(stop);
  options.stop_on_repeated_support = (*stop)[0];
  options.stop_on_no_progress = (*stop)[1];
  keys("tolerance", "", "stop when lower >= (1 - tolerance) * upper; 0 leaves this test out",
       "number of at least 0 and below 1")
      .number(options.tolerance, 0.0, std::nextafter(1.0, 0.0));
  keys("cap", "", "iterations after which the run gives up")
      .whole_number(options.iteration_cap, 1, kCap);
  state_start(keys("start", "the first vertices of X and Y",
                   "first simplex: names of vertices of Y in a point query, else pairs like "
                   "\"K-C\", Y's vertex first",
                   fmt::format("list of 1 to {} simplex vertices (in space {}), or "
                               "\"center-to-center\"",
                               kSimplexVertices, kSimplexVertices + 1)),
              lesson);
  keys("warm", "",
       "along a path, each run but the first starts from the final simplex of the one before")
      .yes_or_no(lesson.warm_start);
}

void steps_keys(KeyPass& keys, Lesson& lesson) {
  keys("tour", "phase", "how the run becomes frames: what one frame is", "name of a tour")
      .other(as_text(lesson.tour));
  keys("until", "the whole run",
       "frames end with the first step of this phase; along a path each shows it (else the closest "
       "point)")
      .choice<gjk::Phase>(lesson.until, "phase");
  std::vector<std::string> phases;
  for (const gjk::Phase phase : lesson.phases) phases.push_back(as_text(name_of(phase)));
  keys("phases", "all of them", "with tour `phase`: the phases that get a frame",
       fmt::format("list of: {}", fmt::join(names_of<gjk::Phase>(), ", ")))
      .other_list(phases);
}

void path_keys(KeyPass& keys, LessonPath& path) {
  keys("points", "X stays where it is",
       fmt::format("2 to {} corners of the way of X: translations", kPositions),
       std::string(kPoints))
      .other_list(as_texts(path.x().points, keys.dimension));
  keys("turns", "X does not turn",
       "degrees that X is turned by at its corners, as many as `points`; needs a clock",
       list_of_turns())
      .other_list(as_texts(path.x().turns));
  keys("frames", "the corners themselves", "positions at equal steps along the path")
      .whole_number(path.frames, 2, kPositions);
  keys("seconds", "no clock",
       "a clock: each shape passes its corners at equal times, `frames` are at equal steps of time")
      .number(path.seconds, kShortest, kLongest);
  keys("Y", "Y stays where it is", "how Y moves meanwhile; needs a clock", "table [path.Y]")
      .other();
}

void y_path_keys(KeyPass& keys, LessonMotion& motion) {
  keys("points", kRequired, "corners of the way of Y, as those of X", std::string(kPoints))
      .other_list(motion.points.empty() ? std::nullopt
                                        : std::optional(as_texts(motion.points, keys.dimension)));
  keys("turns", "Y does not turn",
       "degrees that Y is turned by at its corners, as many as `points`", list_of_turns())
      .other_list(as_texts(motion.turns));
}

void view_keys(KeyPass& keys, LessonView& view) {
  keys("show", kRequired, "the two shapes, Y - X, or what the tour plots",
       "world, difference, or a tour that fills a view")
      .other();
  keys("title", "none", "heading of the view").text(view.title, kViewTitleLength);
  keys("camera", "fits what is drawn", "the part of the world that is seen",
       "table { center = [x, y], height = h, stretch = s }")
      .table(view.camera, camera_keys);
  keys("close-up", "none", "a part of the view, enlarged in a corner",
       "table { center = [x, y], height = h, corner = c }")
      .table(view.close_up, close_up_keys);
  keys("eye", "looks across d", "in space: from which side the view is seen",
       "table { azimuth = a, elevation = e }")
      .other(view.eye ? in_braces(written_keys(*view.eye, eye_keys)) : std::string());
  keys("effects", "none", "what is drawn beyond the shapes and the run", "list of effects")
      .other_list(as_texts(view.effects));
}

void camera_keys(KeyPass& keys, Camera& camera) {
  keys("center", kRequired, "middle of the view").point(camera.center);
  keys("height", kRequired, "height of the view in world units")
      .number(camera.height, kSmallestCameraHeight, kLargest);
  keys("stretch", "",
       "y is drawn so many times larger than x; with another number than 1, angles are not true")
      .number(camera.stretch, 1.0 / kMostStretch, kMostStretch);
}

void eye_keys(KeyPass& keys, Eye& eye) {
  keys("azimuth", "",
       "degrees that the eye walks around z, counter-clockwise; at 0 x points to the right")
      .always()
      .number(eye.azimuth, -kTurn, kTurn);
  keys("elevation", "", "degrees that the eye stands above the plane of x and y")
      .always()
      .number(eye.elevation, -kUpright, kUpright);
}

void close_up_keys(KeyPass& keys, CloseUp& close_up) {
  Camera& camera = close_up.camera;
  keys("center", kRequired, "middle of what is enlarged").point(camera.center);
  keys("height", kRequired, "height of what is enlarged in world units")
      .number(camera.height, kSmallestCameraHeight, kLargest);
  keys("stretch", "", "as for a camera").number(camera.stretch, 1.0 / kMostStretch, kMostStretch);
  keys("corner", "", "where it stands in the view")
      .always()
      .choice<CardCorner>(close_up.corner, "corner");
}

void panel_keys(KeyPass& keys, Lesson& lesson) {
  keys("blocks", "none", "blocks from top to bottom", "list of panel blocks")
      .other_list(as_texts(lesson.panel));
  keys("listing", "none", "what the block `pseudocode` shows; needed with that block and only then",
       "name of a listing")
      .other(lesson.listing.empty() ? "" : as_text(lesson.listing));
}

void question_keys(KeyPass& keys, LessonQuestion& question) {
  keys("ask", kRequired, "what is asked; each tour has questions of its own", "name of a question")
      .other(as_text(question.ask));
  keys("at", "each that can",
       "iteration that answers; where frames do not follow a run of GJK, the part that is asked "
       "about")
      .whole_number(question.at, 1, kCap);
}

void expect_keys(KeyPass& keys, Expectation& expect) {
  keys("stop", "required where GJK runs",
       "why the run ends; the last run of a path. Where GJK is not run, a stop reason of the "
       "tour's own algorithm, as `gjkscope trace` names it",
       "one of: repeated-support, origin-inside, zero-direction, not-nearer, no-progress, "
       "within-tolerance, iteration-cap")
      .other(expect.stop ? as_text(*expect.stop) : "");
  keys("supports", "not checked", "support points in the order found, as in `query.start`",
       "list of simplex vertices")
      .other_list(expect.supports ? std::optional(as_texts(*expect.supports)) : std::nullopt);
  keys("distance", "not checked", "distance, to the digits written", "number of at least 0")
      .number(expect.distance, 0.0, 4.0 * kLargest);
  std::vector<std::string> answers;
  for (const auto& [name, value] : expect.answers)
    answers.push_back(key_line(name, decimal(value)));
  keys("answer", "not checked",
       "what the tour's own algorithm comes to, to the digits written; with `depth`: the "
       "penetration depth, `{ depth = 0.5 }`",
       "table of numbers of at least 0")
      .other(answers.empty() ? "" : in_braces(answers));
}

std::vector<LessonKey> own_keys() {
  const std::string required(kRequired);
  std::vector<LessonKey> out;
  for (const std::vector<LessonKey>& keys :
       {listed_keys<Lesson>("", head_keys),
        {{"shapes", "X", "table [shapes.X]", required,
          "shape X; a point query has a single vertex"},
         {"shapes", "Y", "table [shapes.Y]", required, "shape Y"}},
        listed_keys<LessonShape>("shapes.X", shape_keys),
        listed_keys<Lesson>("query", query_keys),
        listed_keys<Lesson>("steps", steps_keys),
        listed_keys<LessonPath>("path", path_keys),
        listed_keys<LessonMotion>("path.Y", y_path_keys),
        listed_keys<LessonView>("views", view_keys),
        listed_keys<Camera>("views.camera", camera_keys),
        listed_keys<Eye>("views.eye", eye_keys),
        listed_keys<CloseUp>("views.close-up", close_up_keys),
        listed_keys<Lesson>("panel", panel_keys),
        listed_keys<LessonQuestion>("questions", question_keys),
        listed_keys<Expectation>("expect", expect_keys)})
    out.insert(out.end(), keys.begin(), keys.end());
  return out;
}

}  // namespace gjkscope
