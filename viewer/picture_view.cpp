#include "picture_view.hpp"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>  // which window lies below the others

#include <algorithm>
#include <cmath>

#include "app.hpp"
#include "imgui_vec.hpp"
#include "outlines/polygon.hpp"
#include "picture/text_box.hpp"
#include "picture/tween.hpp"
#include "picture/words.hpp"
#include "session/edit.hpp"
#include "session/hit.hpp"
#include "session/pointing.hpp"
#include "subjects/course_map/tiles.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector2d;
using Kind = Subject::Kind;

constexpr double kDirectionReach = 14.0;  // frame pixels around the point that it is dragged from

}  // namespace

PictureView::PictureView(App& app)
    : app_(app), session_(app.session()), hand_(session_, app.fonts()) {}

double PictureView::lay_out(const Rect& area, double density) {
  area_ = area;
  const Point size = area.size().cwiseMax(1.0);
  const Page smallest;
  constexpr double kReadable = 12.0 / 16.0;  // of the size of most type
  if (size.x() < kStageWidth * density || size.y() < kStageHeight * density) {
    zoom_ = kReadable * density;
    session_.set_page({.width = std::max(size.x() / zoom_, kBarest),
                       .height = std::max(size.y() / zoom_, kBarest),
                       .zoom = zoom_,
                       .bare = true,
                       .captions = true});
    return zoom_;
  }
  // In steps, so that the fonts are not built anew for every pixel by which a window grows.
  constexpr double kSteps = 32.0;
  // The page becomes narrower, down to kNarrow, when there is no room for the usual one; then type
  // becomes smaller, down to 12 pixels; then the page becomes narrower again, down to kNarrowest.
  const double usual = std::min(size.x() / smallest.width, size.y() / smallest.height);
  const double across =
      std::max(size.x() / kNarrow, std::min(kReadable * density, size.x() / kNarrowest));
  const double narrow = std::min({density, across, size.y() / smallest.height});
  const double fitting = std::max(usual, narrow);
  zoom_ = std::max(std::floor(fitting * kSteps) / kSteps, kReadable * density);
  session_.set_page(
      {std::max(size.x() / zoom_, kNarrowest), std::max(size.y() / zoom_, smallest.height), zoom_});
  return zoom_;
}

Vector2d PictureView::grid(std::size_t view) const {
  return app_.snaps() ? hand_.round_step(view) : Vector2d::Zero();
}

Picture PictureView::picture_now() {
  const Picture& picture = session_.picture();
  if (picture != shown_) {
    const bool steps = session_.version() == shown_version_ && session_.index() != shown_index_;
    motion_.reset();
    if (steps && app_.moves()) motion_ = Motion{std::move(shown_), app_.now()};
    shown_ = picture;
    shown_version_ = session_.version();
    shown_index_ = session_.index();
    terms_ = term_spots(picture, app_.fonts(), app_.terms());
  }
  if (!motion_) return picture;
  const double share = (app_.now() - motion_->start) / kTweenSeconds;
  Picture between = tween(motion_->from, picture, share);
  if (share >= 1.0) motion_.reset();
  return between;
}

void PictureView::draw(const AtlasFonts& fonts) {
  const Picture picture = picture_now();
  constexpr ImGuiWindowFlags kBackdrop = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                         ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav |
                                         ImGuiWindowFlags_NoSavedSettings |
                                         ImGuiWindowFlags_NoFocusOnAppearing;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  std::size_t next = 0;
  std::vector<ImGuiWindow*> parts;
  // A list holds 65,536 vertices; large pictures take several, each in a window of its own.
  while (parts.empty() || next < picture.marks.size()) {
    ImGui::SetNextWindowPos(vec(area_.min));
    ImGui::SetNextWindowSize(vec(area_.size()));
    ImGui::Begin(fmt::format("##picture{}", parts.size()).c_str(), nullptr,
                 kBackdrop | ImGuiWindowFlags_NoBringToFrontOnFocus);
    parts.push_back(ImGui::GetCurrentWindow());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const DrawPlacement placement{area_.min, zoom_, ImGui::GetIO().Fonts->TexID};
    next = paint_marks(list, picture, next, app_.theme(), fonts, placement);
    if (next >= picture.marks.size()) {
      draw_highlights(picture, fonts);
      if (underlines_terms_ && !motion_) underline_terms();
    }
    ImGui::End();
  }
  ImGui::PopStyleVar();
  // Below all that may lie over the stage.
  for (auto part = parts.rbegin(); part != parts.rend(); ++part)
    ImGui::BringWindowToDisplayBack(*part);
}

/// Rings around what is pointed at and what belongs to it, and around what is selected.
void PictureView::draw_highlights(const Picture& picture, const AtlasFonts& fonts) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  // The colour of the words, which is no shape's.
  const Color words = *app_.theme().style("title").fill;
  const ImU32 ink = IM_COL32(words.r, words.g, words.b, 255);
  const ImU32 wash = IM_COL32(words.r, words.g, words.b, 40);
  const auto width = static_cast<float>(2.0 * zoom_);
  if (press_ && press_->drags_direction) {
    const std::optional<Point> origin = origin_on_page(session_);
    if (origin) list.AddLine(vec(to_pixel(*origin)), vec(to_pixel(press_->last)), ink, width);
  }
  std::vector<Rect> rings;
  for (const Mark& mark : picture.marks) {
    const bool pointed = is_linked(mark.subject, hovered_);
    const bool is_selected = mark.subject.kind != Kind::none && mark.subject == hand_.selected;
    if (!pointed && !is_selected) continue;
    if (const Disk* disk = std::get_if<Disk>(&mark.shape)) {
      const double radius = disk->radius + (is_selected ? 7.0 : 5.0);
      list.AddCircle(vec(to_pixel(disk->center)), static_cast<float>(zoom_ * radius), ink, 0,
                     width);
      rings.push_back(
          {disk->center - Point::Constant(radius), disk->center + Point::Constant(radius)});
    } else if (const Text* text = std::get_if<Text>(&mark.shape)) {
      const Rect box = box_of(app_.fonts(), *text);
      list.AddRectFilled(vec(to_pixel(box.min - Point(4.0, 4.0))),
                         vec(to_pixel(box.max + Point(4.0, 5.0))), wash, 4.0f);
    } else if (const Polygon* polygon = std::get_if<Polygon>(&mark.shape);
               polygon && mark.subject.kind != Kind::region) {
      std::vector<ImVec2> points;
      for (const Point& p : polygon->points) points.push_back(vec(to_pixel(p)));
      const Rect& clip = picture.clips[std::max(mark.clip, 0)];
      list.PushClipRect(vec(to_pixel(clip.min)), vec(to_pixel(clip.max)), true);
      list.AddPolyline(points.data(), static_cast<int>(points.size()), ink, ImDrawFlags_Closed,
                       width);
      list.PopClipRect();
    } else if (const Box* box = std::get_if<Box>(&mark.shape);
               box && mark.subject.kind == Kind::frame) {
      list.AddRect(vec(to_pixel(box->rect.min)), vec(to_pixel(box->rect.max)), ink, 3.0f, 0, width);
    }
  }
  // Labels stand on rings, and the handle on all.
  Picture labels{picture.width, picture.height, picture.clips, picture.clip_corner, {}};
  for (const Mark& mark : picture.marks) {
    const Text* text = std::get_if<Text>(&mark.shape);
    if (text && mark.clip >= 0 && std::any_of(rings.begin(), rings.end(), [&](const Rect& ring) {
          return overlap(ring, box_of(app_.fonts(), *text));
        }))
      labels.marks.push_back(mark);
  }
  for (Mark& mark : hand_.handle_marks()) labels.marks.push_back(std::move(mark));
  (void)paint_marks(list, labels, 0, app_.theme(), fonts,
                    {area_.min, zoom_, ImGui::GetIO().Fonts->TexID});
  const double opacity = app_.presenter().pointer_opacity(app_.now());
  if (app_.is_presenting() && opacity > 0.0) {
    const auto alpha = static_cast<int>(std::lround(255.0 * opacity));
    list.AddCircle(ImGui::GetIO().MousePos, static_cast<float>(20.0 * zoom_),
                   IM_COL32(words.r, words.g, words.b, alpha), 0, static_cast<float>(3.0 * zoom_));
  }
}

void PictureView::underline_terms() const {
  constexpr double kDot = 2.0;   // frame pixels
  constexpr double kStep = 4.0;  // from dot to dot
  const Color words = *app_.theme().style("prose").fill;
  for (const TermSpot& spot : terms_) {
    for (double x = spot.box.min.x(); x + kDot <= spot.box.max.x(); x += kStep) {
      const Point dot(x, spot.box.max.y());
      ImGui::GetWindowDrawList()->AddRectFilled(vec(to_pixel(dot)),
                                                vec(to_pixel(dot + Point(kDot, 1.5))),
                                                IM_COL32(words.r, words.g, words.b, 255));
    }
  }
}

void PictureView::explain_term(const Point& page) {
  constexpr float kWidth = 26.0f;  // ems
  for (const TermSpot& spot : terms_) {
    if (!overlap(spot.box, {page, page})) continue;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(kWidth * ImGui::GetFontSize());
    ImGui::TextUnformatted(spot.term->sentence.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    return;
  }
}

Rect PictureView::last_card() {
  Rect card = {to_page(area_.min), to_page(area_.max)};
  for (const Mark& mark : session_.picture().marks) {
    if (mark.role == "card") card = std::get<Box>(mark.shape).rect;
  }
  return {to_pixel(card.min), to_pixel(card.max)};
}

std::vector<Rect> PictureView::empty_cards() {
  std::vector<Rect> out;
  for (const LessonPictures::ShownView& view : session_.views()) {
    if (shows_shapes(view.kind) && !is_in_sight(session_.picture(), view.card))
      out.push_back({to_pixel(view.card.min), to_pixel(view.card.max)});
  }
  return out;
}

std::optional<Rect> PictureView::words_of_choices() {
  constexpr double kAbove = 22.0;  // its base line, frame pixels
  const FrameText& text = session_.text();
  if (!text.question) return std::nullopt;
  const bool lists =
      !text.question->pair.empty() || text.detail == listed_choices(text.question->choices);
  std::optional<Point> at;
  for (const Mark& mark : session_.picture().marks) {
    if (mark.role != "detail" || (lists && at)) continue;
    at = std::get<Text>(mark.shape).at;
  }
  if (!at) return std::nullopt;
  if (!lists) at->y() += kAbove;
  const double right = session_.page().width - at->x();
  return Rect{to_pixel({at->x(), at->y() - kAbove}), to_pixel({right, at->y()})};
}

std::optional<Point> PictureView::pixel_of(const Subject& subject) {
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

void PictureView::take_pointer() {
  const ImGuiIO& io = ImGui::GetIO();
  const Point pixel(io.MousePos.x, io.MousePos.y);
  const bool inside = std::isfinite(pixel.x()) && std::abs(pixel.x()) < 1e6 &&
                      (pixel.array() >= area_.min.array()).all() &&
                      (pixel.array() < area_.max.array()).all();
  const bool ours = inside && !io.WantCaptureMouse && !app_.has_dialog() && app_.shows_pointer();
  const Point page = to_page(pixel);
  underlines_terms_ = ours && !press_ && !app_.is_presenting() && !hand_.view_at(page);
  if (press_) {
    if (io.MouseDown[0]) {
      continue_drag(page);
    } else {
      let_go();
    }
    return;
  }
  hovered_ = ours ? hand_.subject_at(page) : app_.pointed_in_panel;
  // Not while the picture is on its way to another: it would be there at once.
  if (!motion_)
    session_.point_at({hand_.selected, ours ? hand_.named_at(page, hovered_) : hovered_});
  if (!ours) return;
  if (!motion_) explain_term(page);
  if (is_vertex(hovered_) || is_shape(hovered_) || hovered_.kind == Kind::study_dot ||
      (!session_.question() && chapter_at(page)))
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  const std::optional<std::size_t> view = hand_.view_at(page);
  if (view && io.MouseWheel != 0.0f) zoom(*view, page, std::pow(1.15, -io.MouseWheel));
  if (!io.MouseClicked[0]) return;
  if (clicks_ == 2) {
    double_click(page);
  } else {
    press(hovered_, page);
  }
}

std::optional<int> PictureView::frame_at(const Point& page) {
  std::optional<int> nearest;
  double least = HUGE_VAL;
  for (const Mark& mark : session_.picture().marks) {
    const Box* box = mark.subject.kind == Kind::frame ? std::get_if<Box>(&mark.shape) : nullptr;
    if (!box) continue;
    const Rect& rect = box->rect;
    if (page.y() < rect.min.y() - Hand::kSlack || page.y() > rect.max.y() + Hand::kSlack) continue;
    const double off = std::max({rect.min.x() - page.x(), page.x() - rect.max.x(), 0.0});
    if (off < least) {
      least = off;
      nearest = mark.subject.x;
    }
  }
  return nearest;
}

std::optional<int> PictureView::chapter_at(const Point& page) {
  const std::vector<Rect> tiles = tiles_of_map(session_.picture());
  const auto tile = std::find_if(tiles.begin(), tiles.end(), [&](const Rect& each) {
    return overlap(each, {page, page});
  });
  if (tile == tiles.end()) return std::nullopt;
  return static_cast<int>(tile - tiles.begin()) + 1;
}

void PictureView::press(const Subject& subject, const Point& page) {
  if (!session_.question()) {
    if (app_.offer_click(subject)) return;
    if (const std::optional<int> chapter = chapter_at(page)) return app_.open_chapter(*chapter);
  }
  if (const std::optional<int> frame = frame_at(page)) {
    app_.stop_playing();
    session_.go_to(*frame);
    press_ = Press{.last = page, .on_timeline = true};
    return;
  }
  if (subject.kind == Kind::phase) {
    app_.stop_playing();
    const std::string_view phase = session_.run().tour->algorithm->phases[subject.x];
    if (!session_.go_to_next(phase)) app_.say(fmt::format("this run has no step '{}'", phase));
    return;
  }
  const std::optional<std::size_t> view = hand_.view_at(page);
  if (!view) return;
  press_ = Press{.last = page};
  const std::optional<Point> origin = origin_on_page(session_);
  if (origin && (page - *origin).norm() < kDirectionReach) {
    press_->drags_direction = true;
    press_->aim = Subject{};
    return;
  }
  if (session_.question() && !hand_.is_on_handle(page)) press_->aim = subject;
  // A press on anything else moves the view.
  if (!hand_.press(subject, page)) press_->view = view;
  if (is_vertex(hand_.selected)) {
    const std::size_t body = body_of(hand_.selected);
    const Lesson& lesson = session_.lesson();
    if (lesson.dimension == 2 && is_convex(in_plane(lesson.bodies[body].vertices)))
      press_->convex = body;
  }
}

void PictureView::continue_drag(const Point& page) {
  Press& press = *press_;
  if (press.on_timeline) {
    if (const std::optional<int> frame = frame_at({page.x(), press.last.y()}))
      session_.go_to(*frame);
    return;
  }
  if (press.drags_direction) {
    press.last = page;
    return;
  }
  if (!press.view) {
    press.moved = hand_.move(page, app_.snaps()) || press.moved;
    return;
  }
  if (session_.is_settling() || (!press.moved && (page - press.last).norm() < Hand::kStill)) return;
  press.moved = true;
  Camera camera = session_.views()[*press.view].camera;
  camera.center -= hand_.to_view(*press.view, page) - hand_.to_view(*press.view, press.last);
  session_.set_camera(*press.view, camera);
  press.last = page;
}

void PictureView::release() {
  if (!hand_.release()) {
    app_.say(session_.problem(), true);
  } else if (press_ && press_->moved && press_->convex) {
    const LessonShape& shape = session_.lesson().bodies[*press_->convex];
    if (!is_convex(in_plane(shape.vertices))) {
      app_.say(fmt::format("{} has a dent: GJK sees its hull, which the effect 'shape hull' shows",
                           shape.name));
    }
  }
  press_.reset();
}

void PictureView::let_go() {
  const Press press = *press_;
  release();
  if (!press.moved && press.aim) app_.asking().click(*press.aim, press.last);
}

void PictureView::double_click(const Point& page) {
  const std::optional<std::size_t> view = hand_.view_at(page);
  if (!view || session_.views()[*view].kind != ViewKind::world || is_vertex(hovered_)) return;
  std::optional<Hand::WithVertex> added = hand_.with_vertex(page, app_.snaps());
  if (!added) return session_.fit();
  if (!added->problem.empty()) return app_.say(added->problem);
  if (app_.edit("add a vertex", std::move(added->lesson))) hand_.selected = added->vertex;
}

void PictureView::zoom(std::size_t view, const Point& page, double factor) {
  const Eigen::Vector3d fixed = hand_.to_view(view, page);
  Camera camera = session_.views()[view].camera;
  const double height = camera.height * factor;
  if (!(height > 1e-12 && height < 1e12)) return;
  camera.center = fixed + factor * (camera.center - fixed);
  camera.height = height;
  session_.set_camera(view, camera);
}

}  // namespace gjkscope
