// The picture in the window: where it stands, what is under the pointer, and what a hand does to
// it.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app.hpp"
#include "geometry/polygon.hpp"
#include "imgui_vec.hpp"
#include "picture/text_box.hpp"
#include "picture/words.hpp"
#include "session/hit.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector2d;
using Kind = Subject::Kind;

constexpr double kToolbar = 38.0;     // of one row
constexpr double kMostToolbar = 0.4;  // of the window
constexpr double kLessons = 216.0;
constexpr double kDrawer = 400.0;
constexpr double kSlack = 7.0;        // frame pixels around a point or a line that still hit it
constexpr double kHandleAway = 30.0;  // of the rotation handle from its shape, frame pixels
constexpr double kHandleRadius = 7.0;
constexpr double kSmallestZoom = 0.3;

bool is_vertex(const Subject& subject) {
  return subject.kind == Kind::vertex_of_x || subject.kind == Kind::vertex_of_y;
}
bool is_shape(const Subject& subject) {
  return subject.kind == Kind::shape_x || subject.kind == Kind::shape_y;
}
edit::Which which_of(const Subject& subject) {
  return subject.kind == Kind::vertex_of_x || subject.kind == Kind::shape_x ? edit::Which::x
                                                                            : edit::Which::y;
}
int index_of(const Subject& subject) {
  return subject.kind == Kind::vertex_of_x ? subject.x : subject.y;
}

double snapped(double value, double grid) {
  return grid > 0.0 ? grid * std::round(value / grid) : value;
}
Vector2d snapped(const Vector2d& value, double grid) {
  return {snapped(value.x(), grid), snapped(value.y(), grid)};
}

}  // namespace

double App::layout(double width, double height, double density) {
  ui_scale_ = panel_size_ * density;
  window_width_ = width;
  window_height_ = height;
  Rect area{{0.0, 0.0}, {width, height}};
  if (!presenting_) {
    area.min.y() +=
        std::min(std::max(kToolbar * ui_scale_, toolbar_height_), kMostToolbar * height);
    if (lessons_shown_) area.min.x() += kLessons * ui_scale_;
    if (drawer_ != Drawer::none) area.max.x() -= kDrawer * ui_scale_;
  }
  area_ = area;
  const Point size = area.size().cwiseMax(1.0);
  const Page smallest;
  // In steps, so that the fonts are not built anew for every pixel by which a window grows.
  constexpr double kSteps = 32.0;
  const double fitting = std::min(size.x() / smallest.width, size.y() / smallest.height);
  zoom_ = std::max(std::floor(fitting * kSteps) / kSteps, kSmallestZoom);
  session_.set_page({std::max(size.x() / zoom_, smallest.width),
                     std::max(size.y() / zoom_, smallest.height), zoom_});
  return zoom_;
}

Point App::to_page(const Point& pixel) const { return (pixel - area_.min) / zoom_; }
Point App::to_pixel(const Point& on_page) const { return area_.min + zoom_ * on_page; }

std::optional<std::size_t> App::stage_at(const Point& on_page) const {
  const std::vector<LessonPictures::Stage> stages = session_.stages();
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const Rect& card = stages[i].card;
    if ((on_page.array() >= card.min.array()).all() && (on_page.array() <= card.max.array()).all())
      return i;
  }
  return std::nullopt;
}

Vector2d App::to_view(std::size_t stage, const Point& on_page) const {
  const LessonPictures::Stage shown = session_.stages()[stage];
  const Point off = on_page - shown.card.center();
  return shown.camera.center +
         Vector2d(off.x(), -off.y()) * (shown.camera.height / shown.card.size().y());
}

/// Above the selected shape, in the first view of the world; an empty rectangle where there is
/// none.
Rect App::rotation_handle(edit::Which which) const {
  const PositionedRun& run = session_.run().run(session_.frame());
  const auto& world = which == edit::Which::x ? run.x_world : run.y_world;
  if (world.size() < 2) return {};
  for (const LessonPictures::Stage& stage : session_.stages()) {
    if (stage.kind != ViewKind::world) continue;
    const StageMap map(stage.card, stage.camera);
    Point top = map(world.front());
    double left = top.x();
    double right = top.x();
    for (const Vector2d& vertex : world) {
      const Point p = map(vertex);
      left = std::min(left, p.x());
      right = std::max(right, p.x());
      if (p.y() < top.y()) top = p;
    }
    const Point inset(kHandleRadius + 2.0, kHandleRadius + 2.0);
    const Point center = Point(0.5 * (left + right), top.y() - kHandleAway)
                             .cwiseMax(stage.card.min + inset)
                             .cwiseMin(stage.card.max - inset);
    return {center - Point::Constant(kHandleRadius), center + Point::Constant(kHandleRadius)};
  }
  return {};
}

std::optional<Point> App::rotation_handle_at(edit::Which which) const {
  const Rect handle = rotation_handle(which);
  if (handle.size().x() == 0.0) return std::nullopt;
  return to_pixel(handle.center());
}

void App::draw(const AtlasFonts& fonts) {
  pointed_in_panel_ = {};
  draw_picture(fonts);
  if (!presenting_) {
    draw_toolbar();
    if (lessons_shown_) draw_lessons();
    draw_drawer();
  }
  draw_dialogs();
  draw_message();
  point_at_picture();
  draw_dot_tooltip();
}

void App::draw_picture(const AtlasFonts& fonts) {
  const Picture& picture = session_.picture();
  constexpr ImGuiWindowFlags kBackdrop = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                         ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav |
                                         ImGuiWindowFlags_NoSavedSettings |
                                         ImGuiWindowFlags_NoFocusOnAppearing;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  std::size_t next = 0;
  // A list holds 65,536 vertices; large pictures take several, each in a window of its own.
  for (int part = 0; part == 0 || next < picture.marks.size(); ++part) {
    ImGui::SetNextWindowPos(vec(area_.min));
    ImGui::SetNextWindowSize(vec(area_.size()));
    ImGui::Begin(fmt::format("##picture{}", part).c_str(), nullptr,
                 kBackdrop | (part == 0 ? ImGuiWindowFlags_NoBringToFrontOnFocus : 0));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const DrawPlacement placement{area_.min, zoom_, ImGui::GetIO().Fonts->TexID};
    next = paint_marks(list, picture, next, theme_, fonts, placement);
    if (next >= picture.marks.size()) draw_highlights();
    ImGui::End();
  }
  ImGui::PopStyleVar();
}

/// Rings around what is pointed at and what belongs to it, and around what is selected.
void App::draw_highlights() {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 ink = is_dark() ? IM_COL32(255, 214, 10, 255) : IM_COL32(213, 94, 0, 255);
  const ImU32 wash = is_dark() ? IM_COL32(255, 214, 10, 46) : IM_COL32(213, 94, 0, 40);
  const auto width = static_cast<float>(2.0 * zoom_);
  for (const Mark& mark : session_.picture().marks) {
    const bool pointed = is_linked(mark.subject, hovered_);
    const bool selected = mark.subject.kind != Kind::none && mark.subject == selected_;
    if (!pointed && !selected) continue;
    if (const Disk* disk = std::get_if<Disk>(&mark.shape)) {
      const double radius = zoom_ * (disk->radius + (selected ? 7.0 : 5.0));
      list.AddCircle(vec(to_pixel(disk->center)), static_cast<float>(radius), ink, 0, width);
    } else if (const Text* text = std::get_if<Text>(&mark.shape)) {
      const Rect box = box_of(fonts_, *text);
      list.AddRectFilled(vec(to_pixel(box.min - Point(4.0, 4.0))),
                         vec(to_pixel(box.max + Point(4.0, 5.0))), wash, 4.0f);
    } else if (const Polygon* polygon = std::get_if<Polygon>(&mark.shape);
               polygon && mark.subject.kind != Kind::region) {
      std::vector<ImVec2> points;
      for (const Point& p : polygon->points) points.push_back(vec(to_pixel(p)));
      const Rect& clip = session_.picture().clips[static_cast<std::size_t>(std::max(mark.clip, 0))];
      list.PushClipRect(vec(to_pixel(clip.min)), vec(to_pixel(clip.max)), true);
      list.AddPolyline(points.data(), static_cast<int>(points.size()), ink, ImDrawFlags_Closed,
                       width);
      list.PopClipRect();
    } else if (const Box* box = std::get_if<Box>(&mark.shape);
               box && mark.subject.kind == Kind::frame) {
      list.AddRect(vec(to_pixel(box->rect.min)), vec(to_pixel(box->rect.max)), ink, 3.0f, 0, width);
    }
  }
  if (is_shape(selected_)) {
    const Rect handle = rotation_handle(which_of(selected_));
    if (handle.size().x() > 0.0) {
      list.AddCircleFilled(vec(to_pixel(handle.center())),
                           static_cast<float>(zoom_ * kHandleRadius), ink);
      list.AddText(vec(to_pixel(handle.center() + Point(11.0, -9.0))), ink, "turn");
    }
  }
  if (presenting_) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    list.AddCircle(mouse, 26.0f, ink, 0, 4.0f);
  }
}

std::optional<Point> App::place_of(const Subject& subject) {
  for (const Mark& mark : session_.picture().marks) {
    if (mark.subject != subject) continue;
    if (const Disk* disk = std::get_if<Disk>(&mark.shape)) return to_pixel(disk->center);
    if (const Box* box = std::get_if<Box>(&mark.shape)) return to_pixel(box->rect.center());
    if (const Text* text = std::get_if<Text>(&mark.shape))
      return to_pixel(text->at + Point(text->align == Align::right ? -4.0 : 4.0, -4.0));
    if (const Polygon* polygon = std::get_if<Polygon>(&mark.shape)) {
      return to_pixel(centroid(polygon->points));
    }
  }
  return std::nullopt;
}

// Input ------------------------------------------------------------------------------------------

void App::point_at_picture() {
  const ImGuiIO& io = ImGui::GetIO();
  const Point pixel(io.MousePos.x, io.MousePos.y);
  const bool inside = std::isfinite(pixel.x()) && std::abs(pixel.x()) < 1e6 &&
                      (pixel.array() >= area_.min.array()).all() &&
                      (pixel.array() < area_.max.array()).all();
  const bool ours = inside && !io.WantCaptureMouse && dialog_ == Dialog::none;
  const Point on_page = to_page(pixel);
  if (drag_) {
    if (io.MouseDown[0]) {
      continue_drag(on_page);
    } else {
      release();
    }
    return;
  }
  hovered_ = ours ? subject_at(session_.picture(), fonts_, on_page, kSlack) : pointed_in_panel_;
  if (!ours) return;
  if (is_vertex(hovered_) || is_shape(hovered_) || hovered_.kind == Kind::study_dot)
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  const std::optional<std::size_t> stage = stage_at(on_page);
  if (stage && io.MouseWheel != 0.0f) zoom(*stage, on_page, std::pow(1.15, -io.MouseWheel));
  if (!io.MouseClicked[0]) return;
  if (clicks_ == 2) {
    double_click(on_page);
  } else {
    press_on(hovered_, on_page);
  }
}

std::string App::name_of_subject(const Subject& subject) const {
  const LessonRun& run = session_.run();
  switch (subject.kind) {
    case Kind::vertex_of_x:
      return run.lesson.x.vertex_names[static_cast<std::size_t>(subject.x)];
    case Kind::vertex_of_y:
      return run.lesson.y.vertex_names[static_cast<std::size_t>(subject.y)];
    case Kind::difference_vertex:
      return run.pair_name({subject.x, subject.y});
    case Kind::region:
      return SimplexWords(run, run.state(session_.frame()).simplex)
          .face(static_cast<gjk::Face>(subject.x));
    default:
      return {};
  }
}

void App::press_on(const Subject& subject, const Point& on_page) {
  if (const FrameQuestion* question = session_.question()) {
    const std::string name = name_of_subject(subject);
    const auto& choices = question->choices;
    if (!name.empty() && std::find(choices.begin(), choices.end(), name) != choices.end())
      return answer(name);
  }
  if (subject.kind == Kind::frame) {
    playing_ = false;
    session_.go_to(subject.x);
    drag_ = Drag{subject, 0, on_page, Vector2d::Zero()};
    return;
  }
  if (subject.kind == Kind::study_dot)
    return open_worst_run(dots()[static_cast<std::size_t>(subject.x)]);
  if (subject.kind == Kind::phase) {
    playing_ = false;
    if (!session_.go_to_next(session_.run().phase_name(subject.x))) say("this run has no such step");
    return;
  }
  const std::optional<std::size_t> stage = stage_at(on_page);
  if (!stage) return;
  if (is_shape(selected_)) {
    const Rect handle = rotation_handle(which_of(selected_));
    if (handle.size().x() > 0.0 && (on_page - handle.center()).norm() <= kHandleRadius + kSlack) {
      session_.begin_drag("turn a shape");
      drag_ = Drag{selected_, *stage, on_page, to_view(*stage, on_page), true};
      return;
    }
  }
  drag_ = Drag{subject, *stage, on_page, to_view(*stage, on_page)};
  selected_ = is_vertex(subject) || is_shape(subject) ? subject : Subject{};
}

void App::continue_drag(const Point& on_page) {
  Drag& drag = *drag_;
  if (drag.subject.kind == Kind::frame) {
    const Subject now =
        subject_at(session_.picture(), fonts_, {on_page.x(), drag.last.y()}, 2.0 * kSlack);
    if (now.kind == Kind::frame) session_.go_to(now.x);
    return;
  }
  constexpr double kStill = 2.0;  // frame pixels: a click is not a drag
  if (!drag.moved && (on_page - drag.last).norm() < kStill) return;
  const bool first = !drag.moved;
  drag.moved = true;
  const Vector2d before = to_view(drag.stage, drag.last);
  const Vector2d now = to_view(drag.stage, on_page);
  const edit::Which which = which_of(drag.subject);
  const LessonPictures::Stage stage = session_.stages()[drag.stage];
  const bool in_world = stage.kind == ViewKind::world;

  if (drag.turns) {
    const PositionedRun& run = session_.run().run(session_.frame());
    const auto& world = which == edit::Which::x ? run.x_world : run.y_world;
    const Vector2d middle = centroid(world);
    const Vector2d a = before - middle;
    const Vector2d b = now - middle;
    double degrees = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)) * 180.0 / std::numbers::pi;
    if (snap_ > 0.0) {
      constexpr double kStep = 15.0;
      degrees = snapped(degrees, kStep);
      if (degrees == 0.0) return;
    }
    session_.drag([&](Lesson& lesson) { edit::turn_shape(lesson, which, degrees); });
    drag.last = on_page;
    return;
  }
  const bool moves_point = is_vertex(drag.subject) && in_world;
  const bool moves_shape = is_shape(drag.subject) && in_world;
  const bool moves_difference = !in_world && (drag.subject.kind == Kind::difference ||
                                              drag.subject.kind == Kind::difference_vertex);
  if (!moves_point && !moves_shape && !moves_difference) {
    // What cannot be moved moves the view.
    Camera camera = stage.camera;
    camera.center -= now - before;
    session_.set_camera(drag.stage, camera);
    drag.last = on_page;
    return;
  }
  if (first) session_.begin_drag(moves_point ? "move a vertex" : "move a shape");
  const PositionedRun& run = session_.run().run(session_.frame());
  if (moves_point) {
    const auto& world = which == edit::Which::x ? run.x_world : run.y_world;
    const int index = index_of(drag.subject);
    const Vector2d to = snapped(now, snap_);
    session_.drag([&](Lesson& lesson) {
      if (world.size() == 1) return edit::move_shape(lesson, which, to - world.front());
      edit::put_vertex(lesson, which, index, edit::placement_of(run, which), to);
    });
  } else if (moves_difference) {
    // Z = Y - X goes where Y goes.
    session_.drag([&](Lesson& lesson) { edit::move_shape(lesson, edit::Which::y, now - before); });
  } else {
    const Vector2d by = snapped(Vector2d(now - drag.start_in_view), snap_) -
                        snapped(Vector2d(before - drag.start_in_view), snap_);
    session_.drag([&](Lesson& lesson) { edit::move_shape(lesson, which, by); });
  }
  drag.last = on_page;
}

void App::release() {
  session_.end_drag();
  drag_.reset();
}

void App::double_click(const Point& on_page) {
  const std::optional<std::size_t> stage = stage_at(on_page);
  if (!stage || session_.stages()[*stage].kind != ViewKind::world) return;
  if (is_vertex(hovered_)) return;
  const Vector2d at = to_view(*stage, on_page);
  const LessonPictures::Stage shown = session_.stages()[*stage];
  const double reach = 2.0 * kSlack * shown.camera.height / shown.card.size().y();
  const PositionedRun& run = session_.run().run(session_.frame());
  const auto of_x = edit::nearest_edge(run.x_world, at);
  const auto of_y = edit::nearest_edge(run.y_world, at);
  const bool is_x = of_x && (!of_y || of_x->distance < of_y->distance);
  const auto& edge = is_x ? of_x : of_y;
  if (!edge || edge->distance > reach) return session_.fit();
  const edit::Which which = is_x ? edit::Which::x : edit::Which::y;
  if (edit::shape_of(session_.lesson(), which).vertices.size() >= edit::kMostEditable)
    return say(fmt::format("shapes of {} vertices and more are not edited vertex by vertex",
                           edit::kMostEditable));
  Lesson tried = session_.lesson();
  const int index = edit::insert_vertex(tried, which, edge->edge, edit::placement_of(run, which),
                                        snapped(at, snap_));
  if (!is_sound(tried)) return;
  session_.change("add a vertex", [&](Lesson& lesson) { lesson = tried; });
  selected_ = is_x ? Subject{Kind::vertex_of_x, index} : Subject{Kind::vertex_of_y, -1, index};
}

void App::zoom(std::size_t stage, const Point& on_page, double factor) {
  const Vector2d fixed = to_view(stage, on_page);
  Camera camera = session_.stages()[stage].camera;
  const double height = camera.height * factor;
  if (!(height > 1e-12 && height < 1e12)) return;
  camera.center = fixed + factor * (camera.center - fixed);
  camera.height = height;
  session_.set_camera(stage, camera);
}

}  // namespace gjkscope
