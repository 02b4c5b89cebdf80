#include "frames/trail.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "frames/stage.hpp"
#include "picture/close_up.hpp"
#include "picture/plot.hpp"
#include "picture/text_box.hpp"
#include "picture/words.hpp"
#include "run/trail.hpp"
#include "subjects/difference/minkowski.hpp"

namespace gjkscope {
namespace {

constexpr double kGap = 8.0;          // between cells
constexpr double kNarrowest = 110.0;  // cell: its caption needs so much
constexpr double kCorner = 6.0;
constexpr double kLine = 20.0;   // of a cell's caption
constexpr double kInside = 8.0;  // of a cell, beside its caption
constexpr double kRoom = 26.0;   // around what a cell shows, for labels; in a small one
constexpr double kShare = 0.16;  // of its shorter side

bool shows_z(const LessonRun& run, const LessonView& view) {
  return view.kind == ViewKind::difference || run.point_query();
}

/// The first view that shows Z, or else the last.
std::size_t view_of_cells(const LessonRun& run) {
  const std::vector<LessonView>& views = run.lesson.views;
  for (std::size_t i = 0; i + 1 < views.size(); ++i) {
    if (shows_z(run, views[i])) return i;
  }
  return views.size() - 1;
}

/// The box around what a view shows of the run: Z and O, or both shapes.
Rect seen(const LessonRun& run, const LessonView& view, const StageMap& map) {
  const auto box_of = [&](const Body& body) {
    Rect box{map(body.world.front()), map(body.world.front())};
    for (const Eigen::Vector3d& vertex : body.world)
      box = {box.min.cwiseMin(map(vertex)), box.max.cwiseMax(map(vertex))};
    return box;
  };
  const Rect x = box_of(run.runs.front().x());
  const Rect y = box_of(run.runs.front().y());
  if (view.kind == ViewKind::world) return {x.min.cwiseMin(y.min), x.max.cwiseMax(y.max)};
  const Point o = map(Eigen::Vector3d::Zero().eval());
  return {o.cwiseMin(y.min - x.max + o), o.cwiseMax(y.max - x.min + o)};
}

double room_around(const Point& cell) { return std::min(kRoom, kShare * cell.minCoeff()); }

/// The camera, moved to what the view shows of the run, and as near as has room in a cell.
Camera fitted(const LessonRun& run, const LessonView& view, Camera camera, const Rect& cell) {
  const Rect box = seen(run, view, StageMap(cell, camera, HUGE_VAL));
  const Point off = box.center() - cell.center();
  const Eigen::Vector2d difference =
      camera.units_per_pixel(cell.size().y()).cwiseProduct(Eigen::Vector2d(off.x(), -off.y()));
  camera.center += camera.eye
                       ? Eigen::Vector3d(axes_of(*camera.eye).topRows<2>().transpose() * difference)
                       : in_space(difference);
  const Point room = (cell.size() - Point::Constant(2.0 * room_around(cell.size()))).cwiseMax(1.0);
  camera.height *= (box.size().array() / room.array()).maxCoeff();
  return camera;
}

/// "2: S = {N−C, K−D}"
std::string caption_of(const LessonRun& run, const Frame& frame) {
  const WideSimplex& simplex = run.state(frame).simplex;
  const SimplexWords words(run, simplex);
  std::string names;
  for (const int i : words.order(simplex.all()))
    names += (names.empty() ? "" : ", ") + words.vertex(i);
  return fmt::format("{}: S = {{{}}}", run.step(frame).iteration, names);
}

/// Adds the marks of one step in a cell, and of its labels those that have room.
void draw_cell(Scene& scene, Scene step, const Rect& cell, const Fonts& fonts) {
  // The floor has no room, and names of vertices that the step is not about have none either.
  std::erase_if(step.marks, [](const Mark& mark) {
    return mark.role.starts_with("floor.") || mark.role.starts_with("triad");
  });
  std::erase_if(step.fixed_labels,
                [](const LabelRequest& label) { return label.role == "cloud.label"; });
  // Marks of points are as large as usual in a cell of this size, and smaller in smaller ones.
  constexpr double kUsual = 160.0;
  const double small = std::clamp(cell.size().minCoeff() / kUsual, 0.5, 1.0);
  for (Mark& mark : step.marks) {
    if (Disk* disk = std::get_if<Disk>(&mark.shape)) disk->radius *= small;
    if (Cross* cross = std::get_if<Cross>(&mark.shape)) cross->radius *= small;
    if (mark.role == "support.vertex") {
      const std::vector<Point>& corners = std::get<Polygon>(mark.shape).points;
      mark.shape = diamond(0.5 * (corners[0] + corners[2]), small * sizes::kSupportRadius);
    }
    Arrow* const arrow = std::get_if<Arrow>(&mark.shape);
    if (arrow == nullptr) continue;
    const Point difference = arrow->to - arrow->from;
    arrow->to =
        arrow->from + std::min(1.0, 0.3 * cell.size().minCoeff() / difference.norm()) * difference;
    for (LabelRequest& label : step.moving_labels) {
      if (label.id.starts_with("arrow:")) label.anchor = 0.4 * arrow->from + 0.6 * arrow->to;
    }
  }
  const Point margin = Point::Constant(24.0);  // that is left when marks are cut
  for (Mark& mark : cut(step.marks, {cell.min + margin, cell.max - margin}))
    scene.marks.push_back(std::move(mark));
  LabelPlacer placer(fonts, {cell.min + Point(4.0, 0.0), cell.max - Point(4.0, 4.0)});
  placer.begin_frame(step.obstacles);
  std::vector<Rect> taken;
  for (const auto* labels : {&step.moving_labels, &step.fixed_labels}) {
    for (const LabelRequest& label : *labels) {
      Mark mark = placer.place(label, false);
      const Rect box = box_of(fonts, std::get<Text>(mark.shape));
      const bool is_free = std::none_of(taken.begin(), taken.end(),
                                        [&](const Rect& other) { return overlap(box, other); });
      const bool is_in = (box.min.array() >= cell.min.array()).all() &&
                         (box.max.array() <= cell.max.array()).all();
      if (!is_in || !is_free || placer.is_crossed(box) || leader_line(label, box)) {
        placer.take_back(label.id);
        continue;
      }
      taken.push_back(box);
      scene.marks.push_back(std::move(mark));
    }
  }
}

/// Both bounds of the distance after each iteration. A bound as small as the rounding error of a
/// distance of 0 is shown as 0.
std::vector<Mark> bounds_marks(const PositionedRun& run, const Fonts& fonts, const Rect& area) {
  PlotSeries upper{.style = PlotStyle::first, .name = "at most", .points = {}};
  PlotSeries lower{.style = PlotStyle::second, .name = "at least", .points = {}};
  constexpr double kRounding = 1e-12;  // of the size of Y: far less than frames show
  double size = 0.0;
  for (const Eigen::Vector3d& vertex : run.y().world)
    size = std::max(size, (vertex - run.y().world.front()).norm());
  for (std::size_t i = 0; i < run.bounds.size(); ++i) {
    const double iteration = run.trace.steps[i].iteration;
    for (PlotSeries* series : {&upper, &lower}) {
      if (!series->points.empty() && series->points.back().x() == iteration)
        series->points.pop_back();
    }
    const double bound = run.bounds[i].upper;
    upper.points.emplace_back(iteration, bound < kRounding * size ? 0.0 : bound);
    lower.points.emplace_back(iteration, run.bounds[i].lower);
  }
  double most = 0.0;
  for (const Eigen::Vector2d& p : upper.points) most = std::max(most, p.y());
  Plot plot;
  plot.x = {.low = 0.5, .high = upper.points.back().x() + 0.5, .title = "iteration"};
  plot.y = {.low = 0.0, .high = most > 0.0 ? 1.05 * most : 1.0, .title = "distance"};
  plot.series = {std::move(upper), std::move(lower)};
  return plot_marks(plot, fonts, area);
}

}  // namespace

bool has_cells(const LessonRun& run, std::size_t view) { return view == view_of_cells(run); }

Scene trail_scene(const LessonRun& run, EffectGraph& effects, std::size_t view,
                  const Camera& camera, const Rect& area, const Fonts& fonts) {
  Scene scene;
  if (!has_cells(run, view)) {
    scene.marks = bounds_marks(run.runs.front(), fonts, area);
    return scene;
  }
  LessonView shown = run.lesson.views[view];
  std::erase_if(shown.effects, [](const auto& name) { return name != MinkowskiHull::kName; });
  const std::vector<Frame> frames = frames_of_trail(run);
  const bool has_plot = run.lesson.views.size() == 1;
  const std::size_t count = frames.size() + (has_plot ? 1 : 0);

  // As many columns as show most of each iteration.
  const Point box = seen(run, shown, StageMap(area, camera, HUGE_VAL)).size().cwiseMax(1e-9);
  std::size_t columns = 1;
  double largest = 0.0;
  Point size = Point::Zero();
  for (std::size_t c = 1; c <= count; ++c) {
    const Point cells(static_cast<double>(c), std::ceil(static_cast<double>(count) / c));
    const Point each = (area.size() + Point(kGap, kGap)).cwiseQuotient(cells) - Point(kGap, kGap);
    const Point stage = each - Point(0.0, kLine);
    const Point room = stage - Point::Constant(2.0 * room_around(stage));
    const double scale = (room.array() / box.array()).minCoeff();
    if (c > 1 && (each.x() < kNarrowest || scale <= largest)) continue;
    columns = c;
    largest = scale;
    size = each;
  }
  const auto cell_at = [&](std::size_t i) {
    const std::size_t row = i / columns;
    const Point at(static_cast<double>(i % columns), static_cast<double>(row));
    const Point corner = area.min + at.cwiseProduct(size + Point(kGap, kGap));
    return Rect{corner, corner + size};
  };

  std::vector<std::vector<std::string>> captions;
  std::size_t lines = 1;
  for (const Frame& frame : frames) {
    captions.push_back(
        wrapped(fonts, type::kText, caption_of(run, frame), size.x() - 2.0 * kInside));
    lines = std::max(lines, captions.back().size());
  }
  for (std::size_t i = 0; i < frames.size(); ++i) {
    Rect cell = cell_at(i);
    scene.marks.push_back({"card.cell", Box{cell, kCorner}});
    for (std::size_t k = 0; k < captions[i].size(); ++k) {
      const Point at(kInside, kLine * static_cast<double>(k + 1));
      scene.marks.push_back({"body", Text{cell.min + at, captions[i][k], type::kText}});
    }
    cell.min.y() += kLine * static_cast<double>(lines) + 4.0;
    StillLayers drawn;
    const StageMap map(cell, fitted(run, shown, camera, cell));
    draw_cell(scene, stage_scene(run, effects, frames[i], shown, map, fonts, drawn), cell, fonts);
  }
  if (!has_plot) return scene;
  // The plot takes the rest of the last row.
  const Rect rest{cell_at(frames.size()).min, area.max};
  for (Mark& mark : bounds_marks(run.runs.front(), fonts, rest))
    scene.marks.push_back(std::move(mark));
  return scene;
}

}  // namespace gjkscope
