#include "lesson/schema.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lesson/names.hpp"
#include "lesson/settings_kind.hpp"
#include "lesson/stop_tests.hpp"
#include "lesson/vocabulary.hpp"

namespace gjkscope {

namespace {

std::vector<LessonKey> own_keys() {
  using namespace limits;
  const std::string camera_height =
      fmt::format("number from {} to {}", kSmallestCameraHeight, kLargest);
  const std::string stretch = fmt::format("number from {} to {}", 1.0 / kMostStretch, kMostStretch);
  const std::string required(kRequired);
  const std::string point_list = "list of points [x, y]";
  const std::string list_of_turns = fmt::format("list of numbers from {} to {}", -kTurn, kTurn);
  return {
      {"", "title", text_up_to(kTitleLength), required, "heading of every frame"},
      {"", "chapter", fmt::format("whole number from 0 to {}", kLastChapter), required,
       "chapter that the lesson belongs to"},
      {"", "order", fmt::format("whole number from 1 to {}", kLastOrder), required,
       "place within the chapter"},
      {"", "source", text_up_to(kSourceLength), "none", "where the matter is taught"},
      {"", "prose", text_up_to(kProseLength), required,
       "what to look for, with placeholders; two lines of a frame"},
      {"", "opening", text_up_to(kOpeningLength), "none",
       "why the lesson is there: heads the words of the first frame"},
      {"", "next", text_up_to(kNextLength), "none",
       "what the next lesson answers: ends the words of the last frame"},
      {"", "in_space", text_up_to(kLessonIdLength), "none",
       "name of the lesson that shows the same in space: the page links to it"},
      {"", "shapes", "table [shapes]", required, "the two shapes"},
      {"", "query", "table [query]", "its defaults", "how GJK runs"},
      {"", "steps", "table [steps]", "its defaults", "which frames there are"},
      {"", "path", "table [path]", "the shapes stay where they are",
       "positions of the shapes, one run each"},
      {"", "views", fmt::format("1 to {} tables [[views]]", kMostViews), required,
       "the stages, from left to right"},
      {"", "panel", "table [panel]", "no panel", "the side panel"},
      {"", "questions", "tables [[questions]]", "none", "what frames ask before they tell it"},
      {"", "expect", "table [expect]", required, "what the run must come to; it is checked"},

      {"shapes", "X", "table [shapes.X]", required, "shape X; a point query has a single vertex"},
      {"shapes", "Y", "table [shapes.Y]", required, "shape Y"},

      {"shapes.X", "name", text_up_to(kShapeNameLength), "X or Y",
       "name that frames show; what `Q` is in a point query"},
      {"shapes.X", "names",
       fmt::format("list of vertex names of 1 to {} characters, none a blank, comma or hyphen",
                   kVertexNameLength),
       "the shape's name for a single vertex, else x1, x2, ... or y1, y2, ...",
       "names of the vertices, unique over both shapes"},
      {"shapes.X", "vertices", point_list, required,
       fmt::format("corners in drawing order, 1 to {} of them (a limit of drawing)", kVertices)},
      {"shapes.X", "outlines",
       fmt::format("list of whole numbers of at least {} that add up to the vertices",
                   kOutlineVertices),
       "all vertices are one outline",
       "how many vertices each outline has, one outline after the other: counter-clockwise around "
       "what is solid, clockwise around a hole; only with tours of outlines"},
      {"shapes.X", "translate", "point [x, y]", "[0, 0]", "where the shape's own origin stands"},
      {"shapes.X", "rotate", fmt::format("number from {} to {}", -kTurn, kTurn), "0",
       "degrees counter-clockwise, before `translate`; in space about `axis`"},
      {"shapes.X", "axis", "point [x, y, z]", "[0, 0, 1]",
       "in space: the direction that the shape turns about, which is seen from its tip"},
      {"shapes.X", "radius", fmt::format("number from 0 to {}", kLargest), "0",
       "the shape is all points within this distance of the hull of the vertices; GJK asks about "
       "the hull, and frames that tell the end subtract the radii; only with tours whose "
       "frames tell how a run of GJK ends"},

      {"query", "scalar", one_of(names_of<ScalarKind>()), "double",
       "numbers that the run computes with"},
      {"query", "direction", one_of(names_of<gjk::DirectionRule>()), "perpendicular",
       "how the search direction is built"},
      {"query", "regions", one_of(names_of<gjk::RegionOrder>()), "vertices-first",
       "order of the region tests; unchecked: vertices first, and each of them is believed"},
      {"query", "stop", std::string(kStopTests), "both",
       "stop tests that may be left out; origin inside, zero direction and the cap always apply"},
      {"query", "tolerance", "number of at least 0 and below 1", "0",
       "stop when lower >= (1 - tolerance) * upper; 0 leaves this test out"},
      {"query", "cap", fmt::format("whole number from 1 to {}", kCap),
       std::to_string(gjk::kDefaultIterationCap), "iterations after which the run gives up"},
      {"query", "start",
       fmt::format("list of 1 to {} simplex vertices (in space {}), or \"center-to-center\"",
                   kSimplexVertices, kSimplexVertices + 1),
       "the first vertices of X and Y",
       "first simplex: names of vertices of Y in a point query, else pairs like \"K-C\", Y's "
       "vertex first"},
      {"query", "warm", "true or false", "false",
       "along a path, each run but the first starts from the final simplex of the one before"},

      {"steps", "tour", "name of a tour", "phase", "how the run becomes frames: what one frame is"},
      {"steps", "until", one_of(names_of<gjk::Phase>()), "the whole run",
       "frames end with the first step of this phase; along a path each shows it (else the closest "
       "point)"},
      {"steps", "phases", fmt::format("list of: {}", fmt::join(names_of<gjk::Phase>(), ", ")),
       "all of them", "with tour `phase`: the phases that get a frame"},

      {"path", "points", point_list, "X stays where it is",
       fmt::format("2 to {} corners of the way of X: translations", kPositions)},
      {"path", "turns", list_of_turns, "X does not turn",
       "degrees that X is turned by at its corners, as many as `points`; needs a clock"},
      {"path", "frames", fmt::format("whole number from 2 to {}", kPositions),
       "the corners themselves", "positions at equal steps along the path"},
      {"path", "seconds", fmt::format("number from {} to {}", kShortest, kLongest), "no clock",
       "a clock: each shape passes its corners at equal times, `frames` are at equal steps of "
       "time"},
      {"path", "Y", "table [path.Y]", "Y stays where it is",
       "how Y moves meanwhile; needs a clock"},
      {"path.Y", "points", point_list, required, "corners of the way of Y, as those of X"},
      {"path.Y", "turns", list_of_turns, "Y does not turn",
       "degrees that Y is turned by at its corners, as many as `points`"},

      {"views", "show", "world, difference, or a tour that fills a view", required,
       "the two shapes, Y - X, or what the tour plots"},
      {"views", "title", text_up_to(kViewTitleLength), "none", "heading of the view"},
      {"views", "camera", "table { center = [x, y], height = h, stretch = s }",
       "fits what is drawn", "the part of the world that is seen"},
      {"views", "close-up", "table { center = [x, y], height = h, corner = c }", "none",
       "a part of the view, enlarged in a corner"},
      {"views", "eye", "table { azimuth = a, elevation = e }", "looks across d",
       "in space: from which side the view is seen"},
      {"views", "effects", "list of effects", "none",
       "what is drawn beyond the shapes and the run"},

      {"views.camera", "center", "point [x, y]", required, "middle of the view"},
      {"views.camera", "height", camera_height, required, "height of the view in world units"},
      {"views.camera", "stretch", stretch, "1",
       "y is drawn so many times larger than x; with another number than 1, angles are not true"},
      {"views.eye", "azimuth", fmt::format("number from {} to {}", -kTurn, kTurn), "0",
       "degrees that the eye walks around z, counter-clockwise; at 0 x points to the right"},
      {"views.eye", "elevation", fmt::format("number from {} to {}", -kUpright, kUpright), "0",
       "degrees that the eye stands above the plane of x and y"},
      {"views.close-up", "center", "point [x, y]", required, "middle of what is enlarged"},
      {"views.close-up", "height", camera_height, required,
       "height of what is enlarged in world units"},
      {"views.close-up", "stretch", stretch, "1", "as for a camera"},
      {"views.close-up", "corner", one_of(names_of<CardCorner>()), "bottom right",
       "where it stands in the view"},

      {"panel", "blocks", "list of panel blocks", "none", "blocks from top to bottom"},
      {"panel", "listing", "name of a listing", "none",
       "what the block `pseudocode` shows; needed with that block and only then"},

      {"questions", "ask", "name of a question", required,
       "what is asked; each tour has questions of its own"},
      {"questions", "at", fmt::format("whole number from 1 to {}", kCap), "each that can",
       "iteration that answers; where frames do not follow a run of GJK, the part that is asked "
       "about"},

      {"expect", "stop",
       "one of: repeated-support, origin-inside, zero-direction, not-nearer, no-progress, "
       "within-tolerance, "
       "iteration-cap",
       "required where GJK runs",
       "why the run ends; the last run of a path. Where GJK is not run, a stop reason of the "
       "tour's own algorithm, as `gjkscope trace` names it"},
      {"expect", "supports", "list of simplex vertices", "not checked",
       "support points in the order found, as in `query.start`"},
      {"expect", "distance", "number of at least 0", "not checked",
       "distance, to the digits written"},
      {"expect", "answer", "table of numbers of at least 0", "not checked",
       "what the tour's own algorithm comes to, to the digits written; with `depth`: the "
       "penetration depth, `{ depth = 0.5 }`"},
  };
}

}  // namespace

std::string text_up_to(int length) { return fmt::format("text of 1 to {} characters", length); }

std::string one_of(const std::vector<std::string>& names) {
  return fmt::format("one of: {}", fmt::join(names, ", "));
}

std::vector<LessonKey> lesson_keys(const std::vector<const Tour*>& tours) {
  std::vector<LessonKey> keys = own_keys();
  for (const SettingsKind* table : settings_of(tours)) {
    std::string uses;
    for (const bool optional : {false, true}) {
      std::vector<const Tour*> takers = tours_with(tours, *table);
      std::erase_if(
          takers, [&](const Tour* tour) { return tour->needs.settings_are_optional != optional; });
      if (!takers.empty()) {
        uses += fmt::format("; {} with tour `{}`", optional ? "optional" : "required",
                            fmt::join(names_of(takers), "`, `"));
      }
    }
    keys.push_back({"", std::string(table->name), fmt::format("table [{}]", table->name), "none",
                    fmt::format("{}{}, refused with any other", table->meaning, uses)});
    const std::vector<LessonKey> more = table->keys();
    keys.insert(keys.end(), more.begin(), more.end());
  }
  return keys;
}

}  // namespace gjkscope
