#include "session/verdict_marks.hpp"

#include <algorithm>

#include "frames/stage.hpp"
#include "outlines/polygon.hpp"
#include "session/pointing.hpp"

namespace gjkscope {
namespace {

constexpr double kRing = 13.0;

/// A point of the page, or a segment.
struct Place {
  Point from;
  Point to;
};

class Verdict {
 public:
  Verdict(Picture& picture, const LessonRun& run, std::span<const LessonPictures::ShownView> views,
          const FrameQuestion& asked)
      : picture_(picture), run_(run), views_(views), asked_(asked) {}

  void mark(const std::string& choice, const std::string& role, bool strikes) {
    if (const Subject subject = subject_of(choice); subject.kind != Subject::Kind::none)
      return marks_of(subject, role, strikes);
    const std::optional<Place> place = place_of(choice);
    if (!place) return;
    if (place->from != place->to) return add(role, Polyline{{place->from, place->to}});
    ring(place->from, role, strikes);
  }

  /// Two directions from a point of the view that is asked about, equally long.
  void directions(const Answer& answer) {
    const Eigen::Vector2d& from = *answer.origin;
    const Eigen::Vector2d chosen =
        from + (*answer.place - from).norm() * (*answer.pointed - from).normalized();
    for (const LessonPictures::ShownView& shown : views_) {
      if (shown.kind != asked_.spots.front()->view) continue;
      const StageMap map(shown.card, shown.camera);
      add("verdict.right", Polyline{{map(from), map(*answer.place)}});
      add("verdict.way", Polyline{{map(from), map(chosen)}});
      add("verdict.chosen", Disk{map(chosen), 5.0});
    }
  }

  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    for (const LessonPictures::ShownView& shown : views_) {
      if (shown.kind != ViewKind::world) continue;
      const StageMap map(shown.card, shown.camera);
      add("verdict.way", Polyline{{map(from), map(to)}});
      add("verdict.chosen", Disk{map(from), 5.0});
      add("verdict.right", Disk{map(to), kRing});
    }
  }

 private:
  [[nodiscard]] std::size_t index_of(const std::string& choice) const {
    const auto found = std::find(asked_.choices.begin(), asked_.choices.end(), choice);
    return static_cast<std::size_t>(found - asked_.choices.begin());
  }
  [[nodiscard]] Subject subject_of(const std::string& choice) const {
    const std::size_t at = index_of(choice);
    return at < asked_.subjects.size() ? asked_.subjects[at] : Subject{};
  }
  /// All of its marks, as a node and its volume.
  void marks_of(const Subject& subject, const std::string& role, bool strikes) {
    const std::size_t drawn = picture_.marks.size();
    for (std::size_t i = 0; i < drawn; ++i) {
      const Mark& mark = picture_.marks[i];
      if (mark.subject != subject) continue;
      const std::optional<MarkPlace> place = gjkscope::place_of(mark);
      if (!place) continue;
      if (place->corners.empty())
        ring(place->middle, role, strikes);
      else
        picture_.marks.push_back({role, Polyline{place->corners, true}, mark.clip, {}});
    }
  }
  void ring(const Point& middle, const std::string& role, bool strikes) {
    add(role, Disk{middle, kRing});
    const Point reach = Point::Constant(0.7 * kRing);
    if (strikes) add(role, Polyline{{middle - reach, middle + reach}});
  }
  [[nodiscard]] std::optional<Place> place_of(const std::string& choice) const {
    const std::size_t at = index_of(choice);
    if (at < asked_.spots.size() && asked_.spots[at]) {
      const Spot& spot = *asked_.spots[at];
      const auto view = std::find_if(views_.begin(), views_.end(),
                                     [&](const auto& shown) { return shown.kind == spot.view; });
      if (view == views_.end()) return std::nullopt;
      const StageMap map(view->card, view->camera);
      return Place{map(spot.from), map(spot.to)};
    }
    for (const Mark& mark : picture_.marks) {
      if (name_of(run_, mark.subject) != choice) continue;
      if (const Disk* disk = std::get_if<Disk>(&mark.shape))
        return Place{disk->center, disk->center};
      if (const Polygon* polygon = std::get_if<Polygon>(&mark.shape)) {
        const Point center = centroid(polygon->points);
        return Place{center, center};
      }
    }
    return std::nullopt;
  }
  void add(const std::string& role, decltype(Mark::shape) shape) {
    picture_.marks.push_back({role, std::move(shape), -1, {}});
  }

  Picture& picture_;
  const LessonRun& run_;
  std::span<const LessonPictures::ShownView> views_;
  const FrameQuestion& asked_;
};

}  // namespace

void add_verdict(Picture& picture, const LessonRun& run,
                 std::span<const LessonPictures::ShownView> views, const FrameQuestion& asked,
                 const Answer& answer) {
  Verdict verdict(picture, run, views, asked);
  if (answer.pointed && answer.origin) return verdict.directions(answer);
  if (answer.pointed && answer.place) return verdict.line(*answer.pointed, *answer.place);
  verdict.mark(answer.right, "verdict.right", false);
  if (!answer.is_right()) verdict.mark(answer.chosen, "verdict.wrong", true);
}

}  // namespace gjkscope
