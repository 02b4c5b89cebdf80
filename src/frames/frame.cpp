#include "frames/frame.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string_view>

#include "frames/caption.hpp"
#include "frames/panel.hpp"
#include "frames/stage.hpp"
#include "frames/timeline.hpp"
#include "frames/trail.hpp"
#include "picture/close_up.hpp"
#include "picture/layer.hpp"
#include "picture/legend.hpp"
#include "picture/text_box.hpp"
#include "picture/words.hpp"
#include "run/trail.hpp"
#include "subjects/grid/grid.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace {

constexpr double kMargin = 32.0;
constexpr double kCardGap = 12.0;
constexpr double kCardCorner = 10.0;
constexpr double kCardBorder = 2.0;  // at most: marks and words stay inside of it
constexpr double kHaloCorner = 4.0;
constexpr double kProseLine = 21.0;
constexpr double kTimelineHeight = 52.0;
constexpr double kCaptionLine = 27.0;
constexpr int kCaptionLines = 3;
constexpr double kPanelHeight = 440.0;    // below them
constexpr double kTall = 1.2;             // height over width
constexpr double kTallest = 1300.0;       // views above a panel need as much
constexpr double kSquarish = 0.65;        // more than that of screens, 16 to 10
constexpr double kNarrowestCard = 250.0;  // titles and legends of plots need so much

const Point kAround(92.0, 100.0);    // of a plot: room for labels and a title
constexpr double kTitleLine = 22.0;  // of a view's title, base line to base line
constexpr double kBeside = 28.0;     // a view's title, on both sides

/// "6.3", "630", "2·10⁵"
std::string magnification(double times) {
  constexpr double kLargest = 1e5;  // that is written out
  if (times >= kLargest) return power_text(times, 2);
  const double unit = times < 10.0 ? 0.1 : std::pow(10.0, std::floor(std::log10(times)) - 1.0);
  const double rounded = std::round(times / unit) * unit;
  return times < 10.0 ? fixed(rounded, 1) : grouped(rounded);
}

using Cards = std::vector<Rect>;

/// The places of all parts; the same for all frames of a lesson.
struct Layout {
  Cards views;
  std::optional<Rect> panel;
  double prose_y = 0.0;
  double caption_y = 0.0;
  Rect timeline;
};

/// Views stand one below the other, and above the panel.
bool is_tall(const Page& page) {
  return page.height > kTall * page.width && (page.bare || page.height >= kTallest);
}

/// Narrower than a screen: words take more lines. Only a window has such pages.
bool is_narrow(const Page& page) {
  return !page.bare && page.width < Page{}.width && !is_tall(page);
}

/// A stage as narrow as on a phone.
bool is_slim(const Page& page) {
  constexpr double kSlim = 600.0;
  return page.bare && page.width < kSlim;
}

/// Views may stand one below the other, beside the panel.
bool may_stack(const Page& page) {
  return is_narrow(page) || is_slim(page) || (!page.bare && page.height > kSquarish * page.width);
}

/// `stacks` decides whether views stand one below the other, given the cards of both arrangements.
Layout layout_of(const LessonRun& run, int prose_lines, int caption_lines, const Page& page,
                 const std::function<bool(const Cards& beside, const Cards& stacked)>& stacks) {
  const auto [width, height, zoom, bare, captions] = page;
  Layout layout;
  layout.timeline = {{kMargin, height - kMargin - kTimelineHeight + 14.0},
                     {width - kMargin, height - kMargin + 14.0}};
  const double end = bare ? height - 20.0 : layout.timeline.min.y() - 32.0;  // of the words
  const double bottom = bare && !captions ? height : end - caption_lines * kCaptionLine;
  layout.caption_y = bottom + 33.0;
  layout.prose_y = 70.0;
  const double top = 64.0 + kProseLine * prose_lines;
  const int views = static_cast<int>(run.lesson.views.size());
  const Rect cards =
      bare ? Rect{{0.0, 0.0}, {width, bottom}} : Rect{{kMargin, top}, {width - kMargin, bottom}};
  const bool has_panel = !bare && !run.lesson.panel.empty();
  if (is_tall(page)) {
    const double panel = has_panel ? kPanelHeight + kCardGap : 0.0;
    const double card = (cards.size().y() - kCardGap * (views - 1) - panel) / views;
    Rect next = cards;
    for (int i = 0; i < views; ++i) {
      next.max.y() = next.min.y() + card;
      layout.views.push_back(next);
      next.min.y() = next.max.y() + kCardGap;
    }
    if (has_panel) layout.panel = Rect{next.min, cards.max};
    return layout;
  }
  Rect column = cards;
  if (has_panel) {
    const bool is_wide = views == 1 && cards.size().x() - kCardGap - kWidePanel >= kNarrowestCard;
    const double panel = is_wide ? kWidePanel : kNarrowPanel;
    layout.panel = Rect{{cards.max.x() - panel, cards.min.y()}, cards.max};
    column.max.x() = layout.panel->min.x() - kCardGap;
  }
  const auto cards_along = [&](int along) {
    const double step = (column.size()[along] + kCardGap) / views;
    Cards out(static_cast<std::size_t>(views), column);
    for (int i = 0; i < views; ++i) {
      out[i].min[along] += i * step;
      out[i].max[along] = out[i].min[along] + step - kCardGap;
    }
    return out;
  };
  const Cards beside = cards_along(0);
  const Cards stacked = cards_along(1);
  layout.views = stacks(beside, stacked) ? stacked : beside;
  return layout;
}

std::string position_of(const LessonRun& run, int index) {
  const Frame& frame = run.frames[index];
  if (frame.question < 0) return run.tour->position(run, index);
  if (!run.tour->follows_run) return fmt::format("step {} · question", index + 1);
  // How many iterations there are would tell whether this is the last.
  return fmt::format("iteration {} · question", run.answering_iteration(frame));
}

std::string default_title(const LessonRun& run, const LessonView& view) {
  if (!view.title.empty()) return view.title;
  if (view.kind == ViewKind::world)
    return fmt::format("World: {} and {}", run.lesson.x().name, run.lesson.y().name);
  if (view.kind == ViewKind::plot) return run.tour->plot_title(run);
  return fmt::format("Minkowski difference Z = {} − {}", run.lesson.y().name, run.lesson.x().name);
}

/// The lines of a title. When it takes two lines, "Z = Y − X" is the second.
std::vector<std::string> title_lines(const Fonts& fonts, const std::string& title, double width) {
  const std::size_t equation = title.find(" Z = ");
  if (equation == std::string::npos || fonts.width(type::kViewTitle, title) <= width)
    return wrapped(fonts, type::kViewTitle, title, width);
  std::vector<std::string> lines =
      wrapped(fonts, type::kViewTitle, title.substr(0, equation), width);
  for (std::string& line : wrapped(fonts, type::kViewTitle, title.substr(equation + 1), width))
    lines.push_back(std::move(line));
  return lines;
}

bool contains(const Rect& card, const Point& point) {
  return (point.array() >= card.min.array()).all() && (point.array() <= card.max.array()).all();
}

}  // namespace

std::string alternative_text(const FrameText& text) {
  return text.detail.empty() ? text.caption : text.caption + " " + text.detail;
}

namespace {

/// The last frame answers the questions that were asked right before it.
void tell_answers(std::vector<FrameText>& texts) {
  FrameText& answering = texts.back();
  std::string& detail = answering.detail;
  std::vector<std::string> answers;
  for (std::size_t i = texts.size() - 1; i > 0 && texts[i - 1].question; --i) {
    FrameQuestion& asked = *texts[i - 1].question;
    asked.reason = answering.caption;
    if (!asked.refuted.empty()) detail += (detail.empty() ? "" : " ") + asked.refuted;
    answers.insert(answers.begin(), asked.answer);
  }
  std::string& caption = answering.caption;
  if (answers.size() > 1) {
    caption = fmt::format("Answers: first {}. {}", fmt::join(answers, ", then "), caption);
  } else if (!answers.empty()) {
    const bool starts_so = caption.starts_with(answers[0] + " ");
    caption = fmt::format("Answer: {}{}", starts_so ? "" : answers[0] + ". ", caption);
  }
}

}  // namespace

std::vector<FrameText> lesson_texts(const LessonRun& run, EffectGraph& effects) {
  std::vector<FrameText> texts;
  for (const Frame& frame : run.frames) {
    texts.push_back(frame_text(run, effects, frame));
    texts.back().position = position_of(run, static_cast<int>(texts.size()) - 1);
    if (frame.question < 0) tell_answers(texts);
  }
  if (texts.empty()) return texts;
  if (!run.lesson.opening.empty()) {
    FrameText& first = texts.front();
    first.detail = first.caption + (first.detail.empty() ? "" : " ") + first.detail;
    first.caption = run.lesson.opening;
  }
  if (!run.lesson.next.empty()) {
    std::string& detail = texts.back().detail;
    detail += (detail.empty() ? "" : " ") + run.lesson.next;
  }
  return texts;
}

Page page_of(int width, int height) {
  const Page smallest;
  const double zoom = std::min(width / smallest.width, height / smallest.height);
  return {width / zoom, height / zoom, zoom};
}

namespace {

/// Marks of a picture, and words on it.
struct PageWriter {
  Picture& picture;
  void add(std::string role, decltype(Mark::shape) shape) {
    picture.marks.push_back({std::move(role), std::move(shape)});
  }
  void write(std::string role, const Point& at, const std::string& words, const TextStyle& style,
             Align align = Align::left) {
    add(std::move(role), Text{at, words, style, align});
  }
  /// Lines downwards from `at`; returns the base line of what comes next.
  double write_lines(const std::string& role, Point at, const std::vector<std::string>& lines,
                     const TextStyle& style, double height) {
    for (const std::string& line : lines) {
      write(role, at, line, style);
      at.y() += height;
    }
    return at.y();
  }
  void append(std::vector<Mark> marks) {
    std::move(marks.begin(), marks.end(), std::back_inserter(picture.marks));
  }
};

/// In space, where lines may lead anywhere, a point moved in would turn those that lead to it.
bool is_magnified(const LessonRun& run, const LessonPictures::ShownView& view) {
  if (run.lesson.dimension == 2) return false;
  const double scale = StageMap(view.card, view.camera).scale();
  return std::any_of(run.runs.begin(), run.runs.end(), [&](const PositionedRun& positioned) {
    return std::any_of(positioned.bodies.begin(), positioned.bodies.end(), [&](const Body& body) {
      return std::any_of(body.world.begin(), body.world.end(), [&](const auto& vertex) {
        return scale * (vertex - view.camera.center).norm() > StageMap::kFarthest;
      });
    });
  });
}

}  // namespace

/// One view of the lesson: its scenes, and the labels' memory.
struct LessonPictures::View {
  std::size_t index;  ///< Among the lesson's views.
  ShownView shown;
  LessonView of;
  LabelPlacer placer;
  std::vector<std::optional<Scene>> scenes;  ///< One for each frame, once it was asked for.
  StillLayers still_layers = {};
  bool has_fixed_labels = false;
  std::set<std::string> left_out = {};  ///< Ids of fixed labels without room.
  std::vector<std::string> title = {};  ///< Line by line.
  Rect title_box = {};
  bool is_close_up = false;
  /// Its marks are cut at the card: what is far is farther than painters can tell.
  bool is_cut = false;
  int clip = -1;  ///< Index in the picture that is drawn.
  std::unique_ptr<View> close_up = nullptr;

  /// The card below the title.
  [[nodiscard]] Rect below_title() const {
    return {{shown.card.min.x(), title_box.max.y()}, shown.card.max};
  }
  /// Keeps labels off the title and the close-up.
  void reserve() {
    placer.reserve(title_box);
    if (close_up) placer.reserve(close_up->shown.card);
  }
  /// A camera may leave vertices outside of the view, and a close-up may stand on them; their
  /// labels stay away, too.
  [[nodiscard]] bool shows(const LabelRequest& label) const {
    return contains(shown.card, label.anchor) && !left_out.contains(label.id) &&
           !(close_up && contains(close_up->shown.card, label.anchor));
  }
  void place_fixed(const Fonts& fonts, const LabelRequest& label) {
    const Mark mark = placer.place(label, true);
    const auto leader = leader_line(label, box_of(fonts, std::get<Text>(mark.shape)));
    if (!leader) return;
    if (!label.needs_room) return placer.avoid(*leader);
    placer.take_back(label.id);
    left_out.insert(label.id);
  }
  /// A ring around what is enlarged, and a line from there to where it is.
  void tell_close_up(Scene& scene) const {
    constexpr double kRing = 12.0;
    const StageMap map(shown.card, shown.camera);
    const Rect& card = close_up->shown.card;
    const std::vector<Eigen::Vector2d> seen = StageMap(card, close_up->shown.camera).visible();
    const Rect part{map(seen[3]), map(seen[1])};
    if (contains(card, part.center())) return;
    const double radius = std::max(kRing, 0.5 * part.size().maxCoeff());
    const Point difference = card.center() - part.center();
    const Obstacles::Segment line{part.center() + radius / difference.norm() * difference,
                                  card.center()};
    scene.marks.push_back({"inset.line", Polyline{{line.a, line.b}}});
    scene.marks.push_back({"inset.line", Disk{part.center(), radius}});
    scene.obstacles.segments.push_back(line);
  }
};

LessonPictures::LessonPictures(const LessonRun& run, EffectGraph& effects, const Fonts& fonts,
                               const Page& page, LabelScope scope)
    : run_(run), effects_(effects), fonts_(fonts), texts_(lesson_texts(run, effects)) {
  lay_out(page, CameraOverrides(run.lesson.views.size()), scope);
}

LessonPictures::~LessonPictures() = default;

namespace {

Camera camera_in(const CameraOverride& seen, const Rect& card) {
  Camera camera = seen.camera;
  camera.height *= std::max(1.0, seen.aspect * card.size().y() / card.size().x());
  return camera;
}

}  // namespace

void LessonPictures::lay_out(const Page& page, const CameraOverrides& cameras, LabelScope scope,
                             std::optional<bool> stacked) {
  page_ = page;
  scope_ = scope;
  views_.clear();
  explained_.clear();
  const double text_width = page_.width - 2.0 * kMargin;
  std::size_t prose_lines = 0;
  std::set<std::string_view> proses;
  for (const FrameText& text : texts_) {
    if (!proses.insert(text.prose).second) continue;
    prose_lines =
        std::max(prose_lines, wrapped(fonts_, type::kProse, text.prose, text_width).size());
  }
  std::size_t caption_lines = kCaptionLines;
  for (const FrameText& text : texts_) {
    const std::size_t lines = wrapped(fonts_, type::kCaption, text.caption, text_width).size() +
                              wrapped(fonts_, type::kDetail, text.detail, text_width).size();
    caption_lines = std::max(caption_lines, lines);
  }
  const auto camera_on = [&](std::size_t view, const Rect& card) {
    // One that was set on shapes of the other dimension shows nothing of these.
    const bool fits =
        cameras[view] && cameras[view]->camera.eye.has_value() == (run_.lesson.dimension == 3);
    return fits ? camera_in(*cameras[view], card) : camera_of(run_, run_.lesson.views[view], card);
  };
  const auto scale = [&](std::size_t view, const Rect& card) {
    const Point room = (card.size() - kAround).cwiseMax(1.0);
    const LessonView& of = run_.lesson.views[view];
    return shows_shapes(of.kind) ? StageMap(card, camera_of(run_, of, card)).scale()
                                 : room.minCoeff();
  };
  // Whatever shows the lesson's shapes larger, wherever a hand has moved the view since; but cards
  // that are too narrow for words never stand side by side.
  const auto stacks = [&](const Cards& beside, const Cards& below) {
    if (!may_stack(page_)) return false;
    double larger = 1.0;
    bool has_words = !page_.bare;
    for (std::size_t i = 0; i < below.size(); ++i) {
      if (!stacked) larger *= scale(i, below[i]) / scale(i, beside[i]);
      has_words = has_words || !shows_shapes(run_.lesson.views[i].kind);
    }
    return stacked.value_or(larger >= 1.0) || (has_words && beside[0].size().x() < kNarrowestCard);
  };
  const Layout layout = layout_of(run_, static_cast<int>(prose_lines),
                                  static_cast<int>(caption_lines), page_, stacks);
  panel_ = layout.panel;
  stacked_ = layout.views.size() > 1 && layout.views[0].min.x() == layout.views[1].min.x();
  prose_y_ = layout.prose_y;
  caption_y_ = layout.caption_y;
  timeline_ = layout.timeline;
  for (std::size_t i = 0; i < run_.lesson.views.size(); ++i) {
    const LessonView& view = run_.lesson.views[i];
    const Rect& card = layout.views[i];
    const Camera camera = camera_on(i, card);
    const std::vector<std::string> title =
        title_lines(fonts_, default_title(run_, view), card.size().x() - kBeside);
    Point title_size(0.0, 38.0 + kTitleLine * static_cast<double>(title.size() - 1));
    for (const std::string& line : title) {
      title_size.x() = std::max(title_size.x(), fonts_.width(type::kViewTitle, line) + kBeside);
    }
    const auto made = [&](const Rect& on, const Camera& seen_by) {
      const Rect inner{on.min + Point(4, 4), on.max - Point(4, 4)};
      return View{i,
                  {on, view.kind, seen_by},
                  view,
                  LabelPlacer(fonts_, inner),
                  std::vector<std::optional<Scene>>(run_.frames.size())};
    };
    View& shown = views_.emplace_back(made(card, camera));
    shown.is_cut = is_magnified(run_, shown.shown);
    shown.title = title;
    shown.title_box = {card.min, card.min + title_size};
    if (!view.close_up) continue;
    const Rect corner = close_up_in(card, view.close_up->corner);
    View near = made(corner, view.close_up->camera);
    std::erase(near.of.effects, std::string(Grid::kName));
    near.is_close_up = true;
    near.is_cut = true;
    const double times =
        StageMap(corner, near.shown.camera).scale() / StageMap(card, shown.shown.camera).scale();
    near.title = {"× " + magnification(times)};
    const Point size(fonts_.width(type::kText, near.title[0]) + 16.0, 30.0);
    near.title_box = {{corner.min.x(), corner.max.y() - size.y()},
                      {corner.min.x() + size.x(), corner.max.y()}};
    shown.close_up = std::make_unique<View>(std::move(near));
  }
}

std::vector<LessonPictures::ShownView> LessonPictures::views() const {
  std::vector<ShownView> list;
  for (const View& view : views_) list.push_back(view.shown);
  return list;
}

const Scene& LessonPictures::scene(View& view, std::size_t index) {
  std::optional<Scene>& scene = view.scenes[index];
  if (!scene) {
    const double farthest = view.is_cut ? HUGE_VAL : StageMap::kFarthest;
    const StageMap map(view.shown.card, view.shown.camera, farthest);
    const Frame& frame = run_.frames[index];
    if (is_trail(frame)) {
      const Rect area = view.below_title();
      const Point inset = Point::Constant(kCardGap);
      scene = trail_scene(run_, effects_, view.index, view.shown.camera,
                          {area.min + Point(inset.x(), 4.0), area.max - inset}, fonts_);
      return *scene;
    }
    FrameInView in{&run_, &effects_, frame};
    if (run_.tour->in_view != nullptr) in = run_.tour->in_view(run_, effects_, frame, view.index);
    scene = stage_scene(*in.run, *in.effects, in.frame, view.of, map, fonts_, view.still_layers);
    if (in.adds != nullptr) {
      SceneBuilder more(run_, effects_, frame, view.of, map);
      in.adds(more);
      scene->append(more.out);
    }
    if (view.is_cut) scene->marks = cut(scene->marks, view.shown.card);
    if (view.close_up) view.tell_close_up(*scene);
  }
  return *scene;
}

/// Labels of things that stay get a place that suits every frame.
void LessonPictures::place_fixed_labels(View& view, std::size_t shown) {
  if (view.has_fixed_labels) return;
  view.has_fixed_labels = true;
  std::vector<const Scene*> scenes;
  for (std::size_t i = 0; i < run_.frames.size(); ++i) {
    if (scope_ == LabelScope::frame && i != shown) continue;
    const Scene& of_frame = scene(view, i);
    if (!of_frame.fixed_labels.empty() || !of_frame.area_labels.empty())
      scenes.push_back(&of_frame);
  }
  view.placer.begin_frame({});
  for (const Scene* of_frame : scenes) view.placer.add(of_frame->obstacles);
  view.reserve();
  std::set<std::string> placed;
  for (const bool needs_room : {false, true}) {
    for (const Scene* of_frame : scenes) {
      for (const LabelRequest& label : of_frame->fixed_labels) {
        if (label.needs_room == needs_room && view.shows(label) && placed.insert(label.id).second)
          view.place_fixed(fonts_, label);
      }
    }
  }
  // No place could be kept for an area that is another one in each frame.
  std::map<std::string, const AreaLabelRequest*> areas;
  std::set<std::string> change;
  for (const Scene* of_frame : scenes) {
    for (const AreaLabelRequest& label : of_frame->area_labels) {
      const AreaLabelRequest& first = *areas.try_emplace(label.id, &label).first->second;
      if (first.polygon != label.polygon || first.text != label.text) change.insert(label.id);
    }
  }
  for (const auto& [id, label] : areas) {
    if (!change.contains(id)) (void)view.placer.place_inside(*label, true);
  }
}

/// While something is dragged no other frame is looked at, and nothing is new.
std::vector<LegendEntry> LessonPictures::marks_to_explain(std::size_t view, std::size_t index) {
  if (scope_ == LabelScope::frame) return {};
  constexpr std::size_t kMost = 4;
  if (explained_.empty()) {
    explained_.resize(run_.frames.size() * views_.size());
    std::vector<std::set<std::string_view>> roles(explained_.size());
    for (std::size_t at = 0; at < roles.size(); ++at) {
      if (is_trail(run_.frames[at / views_.size()])) continue;  // it has no room for them
      for (const Mark& mark : scene(views_[at % views_.size()], at / views_.size()).marks)
        roles[at].insert(roles[at].end(), mark.role);
    }
    for (const LegendEntry& entry : legend_entries(run_)) {
      // In a point query words speak of S only when a run is followed.
      const bool of_s = entry.role == "simplex.vertex";
      if (of_s && run_.point_query() && !run_.tour->follows_run) continue;
      for (std::size_t at = 0; at < explained_.size(); ++at) {
        if (!roles[at].contains(entry.role) ||
            !mark_of(scene(views_[at % views_.size()], at / views_.size()), entry.role))
          continue;
        if (explained_[at].size() < kMost) explained_[at].push_back(entry);
        break;
      }
    }
    explained_marks_.clear();
    for (const std::vector<LegendEntry>& entries : explained_)
      explained_marks_.insert(explained_marks_.end(), entries.begin(), entries.end());
  }
  return explained_[index * views_.size() + view];
}

/// Entries whose marks are in this frame, in the order in which they were first explained.
std::vector<LegendRow> LessonPictures::standing_legend(std::size_t index) {
  std::vector<LegendRow> rows;
  for (const LegendEntry& entry : explained_marks_) {
    const Mark* mark = nullptr;
    for (std::size_t view = 0; view < views_.size() && mark == nullptr; ++view)
      mark = mark_of(scene(views_[view], index), entry.role);
    if (mark != nullptr) rows.push_back({mark, entry.text});
  }
  return rows;
}

namespace {

/// The free part of a panel below its marks.
Rect spare_part(const Rect& panel, const std::vector<Mark>& marks) {
  constexpr double kGap = 8.0;
  constexpr double kDescent = 0.3;  // of a letter's size
  double low = panel.min.y();
  for (const Mark& mark : marks) {
    if (const Text* text = std::get_if<Text>(&mark.shape))
      low = std::max(low, text->at.y() + kDescent * text->style.size);
    if (const Box* box = std::get_if<Box>(&mark.shape)) low = std::max(low, box->rect.max.y());
    if (const Polyline* line = std::get_if<Polyline>(&mark.shape)) {
      for (const Point& point : line->points) low = std::max(low, point.y());
    }
  }
  return {{panel.min.x() + kGap, low + kGap}, panel.max - Point(kGap, kGap)};
}

}  // namespace

/// The legend in the spare part of the panel: entries that are new in this frame, then older ones
/// as far as there is room. Empty if the new ones do not fit.
std::vector<Mark> LessonPictures::legend_in(const Rect& spare, std::size_t index) {
  std::size_t unexplained = 0;
  for (std::size_t view = 0; view < views_.size(); ++view)
    unexplained += marks_to_explain(view, index).size();
  std::vector<LegendRow> rows = standing_legend(index);
  const auto fits = [&] {
    return (legend_size(rows, fonts_).array() <= spare.size().array()).all();
  };
  while (rows.size() > unexplained && !fits()) rows.erase(rows.begin());
  return rows.empty() || !fits() ? std::vector<Mark>() : legend(rows, spare.min, fonts_);
}

/// A label beside its anchor, a line that leads there where it is far, and a halo on marks.
void LessonPictures::draw_label(Picture& picture, View& view, const LabelRequest& label,
                                bool fixed) {
  const int clip = view.clip;
  const Mark placed = view.placer.place(label, fixed);
  const Rect box = box_of(fonts_, std::get<Text>(placed.shape));
  draw_leader(picture, view, label, box);
  if (view.placer.is_crossed(box))
    picture.marks.push_back({"label.halo", Box{box, kHaloCorner}, clip});
  picture.marks.push_back(placed);
}

void LessonPictures::draw_leader(Picture& picture, View& view, const LabelRequest& label,
                                 const Rect& box) {
  const auto line = leader_line(label, box);
  if (!line) return;
  view.placer.avoid(*line);
  picture.marks.push_back({"leader", Polyline{{line->a, line->b}}, view.clip});
}

/// Marks and labels of a view, on a card that is there.
void LessonPictures::draw(Picture& picture, View& view, std::size_t index) {
  place_fixed_labels(view, index);
  // Nothing moves between a trail, whose clips are others, and the frame before it.
  const Rect card = is_trail(run_.frames[index]) ? view.below_title() : view.shown.card;
  view.clip = static_cast<int>(picture.clips.size());
  const Point border = Point::Constant(kCardBorder);
  picture.clips.push_back({card.min + border, card.max - border});
  const Scene& of_frame = scene(view, index);
  for (const Mark& mark : of_frame.marks) {
    picture.marks.push_back(mark);
    picture.marks.back().clip = view.clip;
  }
  view.placer.begin_frame(of_frame.obstacles);
  view.reserve();
  // Labels that keep their place come first, so that none steps aside to where they stand.
  std::set<std::string> drawn;
  for (const bool steps_aside : {false, true}) {
    for (const LabelRequest& label : of_frame.fixed_labels) {
      if (label.steps_aside != steps_aside || !view.shows(label)) continue;
      if (drawn.insert(label.id).second) draw_label(picture, view, label, true);
    }
  }
  for (const AreaLabelRequest& label : of_frame.area_labels) {
    std::vector<Mark> name = view.placer.place_inside(label);
    // Beside its area it has a line that leads there, if it is far.
    for (const Mark& mark : name) {
      const Rect box = box_of(fonts_, std::get<Text>(mark.shape));
      if (label.otherwise && !is_inside(label.polygon, box))
        draw_leader(picture, view, *label.otherwise, box);
      if (view.placer.is_crossed(box))
        picture.marks.push_back({"label.halo", Box{box, kHaloCorner}, view.clip});
    }
    PageWriter{picture}.append(std::move(name));
  }
  for (const LabelRequest& label : of_frame.moving_labels) {
    if (view.shows(label)) draw_label(picture, view, label, false);
  }
}

void LessonPictures::draw_pointed(Picture& picture, View& view, std::size_t index,
                                  std::span<const Subject> pointed) {
  if (pointed.empty() || !shows_shapes(view.shown.kind) || is_trail(run_.frames[index])) return;
  const Scene& of_frame = scene(view, index);
  const StageMap map(view.shown.card, view.shown.camera);
  SceneBuilder more(run_, effects_, run_.frames[index], view.of, map);
  for (const Subject& subject : pointed) {
    layers::vertex_name(more, subject,
                        std::any_of(of_frame.marks.begin(), of_frame.marks.end(),
                                    [&](const Mark& mark) { return mark.subject == subject; }));
  }
  for (Mark& mark : more.out.marks) {
    mark.clip = view.clip;
    picture.marks.push_back(std::move(mark));
  }
  std::set<std::string> named;
  for (const auto* labels : {&of_frame.fixed_labels, &of_frame.moving_labels}) {
    for (const LabelRequest& label : *labels) {
      if (view.shows(label)) named.insert(label.id);
    }
  }
  for (LabelRequest& label : more.out.moving_labels) {
    if (!view.shows(label) || !named.insert(label.id).second) continue;
    // Its place is no place of a label of the lesson.
    label.id = "pointed:" + label.id;
    draw_label(picture, view, label, false);
  }
}

/// A part of a view once more, larger: the same marks, seen by a camera that is nearer.
void LessonPictures::draw_close_up(Picture& picture, View& near, std::size_t index) {
  PageWriter page{picture};
  const Rect& card = near.shown.card;
  page.add("inset", Box{card, kCardCorner});
  draw(picture, near, index);
  page.write("inset.label", {card.min.x() + 10.0, card.max.y() - 10.0}, near.title[0], type::kText);
}

Picture LessonPictures::picture(int index, const FrameText& text,
                                std::span<const Subject> pointed) {
  const auto at = static_cast<std::size_t>(index);
  const double text_width = page_.width - 2.0 * kMargin;
  Picture picture;
  picture.width = page_.width;
  picture.height = page_.height;
  picture.clip_corner = kCardCorner - kCardBorder;
  PageWriter page{picture};

  if (!page_.bare) {
    page.write("title", {kMargin, 44.0}, run_.lesson.title, type::kTitle);
    const double beside = text_width - fonts_.width(type::kTitle, run_.lesson.title) - kMargin;
    if (fonts_.width(type::kPosition, text.position) <= beside) {
      page.write("position", {page_.width - kMargin, 44.0}, text.position, type::kPosition,
                 Align::right);
    }
    page.write_lines("prose", {kMargin, prose_y_},
                     wrapped(fonts_, type::kProse, text.prose, text_width), type::kProse,
                     kProseLine);
  }

  std::vector<Mark> panel;
  bool on_stage = true;  // stands what explains marks
  if (panel_) {
    panel = panel_marks(run_, effects_, run_.frames[at], fonts_, *panel_);
    std::vector<Mark> explained = legend_in(spare_part(*panel_, panel), at);
    on_stage = explained.empty();
    std::move(explained.begin(), explained.end(), std::back_inserter(panel));
  }
  for (std::size_t i = 0; i < views_.size(); ++i) {
    View& view = views_[i];
    const Rect& card = view.shown.card;
    page.add("card", Box{card, kCardCorner});
    const std::size_t first_label = picture.marks.size();
    draw(picture, view, at);
    std::vector<Rect> words = {view.title_box};
    if (view.close_up) words.push_back(view.close_up->shown.card);
    for (std::size_t k = first_label; k < picture.marks.size(); ++k) {
      if (const Text* label = std::get_if<Text>(&picture.marks[k].shape))
        words.push_back(box_of(fonts_, *label));
    }
    if (on_stage) {
      std::vector<LegendRow> rows;
      for (const LegendEntry& entry : marks_to_explain(i, at))
        rows.push_back({mark_of(scene(view, at), entry.role), entry.text});
      std::vector<Mark> explained =
          legend_on_stage(std::move(rows), scene(view, at), card, words, fonts_);
      for (Mark& mark : explained) {
        if (mark.role != "legend.box") continue;
        mark.clip = view.clip;
        view.placer.reserve(std::get<Box>(mark.shape).rect);
      }
      page.append(std::move(explained));
    }
    draw_pointed(picture, view, at, pointed);
    if (view.close_up && !is_trail(run_.frames[at])) draw_close_up(picture, *view.close_up, at);
    page.add("view-title.box",
             Box{{card.min + Point::Constant(kCardBorder), view.title_box.max - Point(6.0, 3.0)},
                 kCardCorner - kCardBorder});
    const bool is_of_bounds = is_trail(run_.frames[at]) && !has_cells(run_, i);
    // A tour may fill a view of the shapes with its plot.
    const bool is_of_tour = view.shown.kind != ViewKind::plot && run_.tour->plot_title != nullptr &&
                            !is_trail(run_.frames[at]) &&
                            mark_of(scene(view, at), "plot.axis") != nullptr;
    page.write_lines("view-title", card.min + Point(14.0, 26.0),
                     is_of_bounds ? std::vector<std::string>{"Distance, as proved"}
                     : is_of_tour ? std::vector<std::string>{run_.tour->plot_title(run_)}
                                  : view.title,
                     type::kViewTitle, kTitleLine);
  }
  if (panel_) {
    page.add("card", Box{*panel_, kCardCorner});
    page.append(std::move(panel));
  }

  if (page_.bare && !page_.captions) return picture;
  const char* const role = text.is_right   ? (*text.is_right ? "caption.right" : "caption.wrong")
                           : text.question ? "caption.question"
                                           : "caption";
  const double detail_y = page.write_lines(
      role, {kMargin, caption_y_}, wrapped(fonts_, type::kCaption, text.caption, text_width),
      type::kCaption, kCaptionLine);
  page.write_lines("detail", {kMargin, detail_y},
                   wrapped(fonts_, type::kDetail, text.detail, text_width), type::kDetail,
                   kCaptionLine);
  if (!page_.bare) page.append(timeline_marks(run_, index, fonts_, timeline_));
  return picture;
}

std::vector<FramePicture> lesson_pictures(const LessonRun& run, EffectGraph& effects,
                                          const Fonts& fonts, const Page& page) {
  LessonPictures pictures(run, effects, fonts, page);
  std::vector<FramePicture> out;
  for (int i = 0; i < static_cast<int>(run.frames.size()); ++i)
    out.push_back({pictures.picture(i), pictures.texts()[i]});
  return out;
}

}  // namespace gjkscope
