#include "picture/legend.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "picture/hatch.hpp"

namespace gjkscope {
namespace {

constexpr double kGlyph = 28.0;
constexpr double kLegendPad = 12.0;
constexpr double kLegendRow = 24.0;

/// A mark like those of the scene, of the size of a letter.
struct Glyph {
  Point center;

  decltype(Mark::shape) operator()(const Disk& disk) const {
    return Disk{center, std::min(disk.radius, 6.0)};
  }
  decltype(Mark::shape) operator()(const Polygon& polygon) const {
    constexpr double kMark = 30.0;  // larger ones are areas
    const auto [left, right] =
        std::minmax_element(polygon.points.begin(), polygon.points.end(),
                            [](const Point& a, const Point& b) { return a.x() < b.x(); });
    if (polygon.points.size() == 4 && right->x() - left->x() < kMark) return diamond(center, 7.0);
    return Box{{center - Point(8.0, 6.0), center + Point(8.0, 6.0)}, 2.0};
  }
  decltype(Mark::shape) operator()(const Polyline&) const {
    return Polyline{{center - Point(9.0, 0.0), center + Point(9.0, 0.0)}};
  }
  decltype(Mark::shape) operator()(const Arrow&) const {
    return Arrow{center - Point(9.0, 0.0), center + Point(9.0, 0.0)};
  }
  decltype(Mark::shape) operator()(const Cross&) const { return Cross{center, 7.0}; }
  decltype(Mark::shape) operator()(const Box& box) const {
    const Point half = (0.5 * box.rect.size()).cwiseMin(Point(8.0, 6.0));
    return Box{{center - half, center + half}, std::min(box.corner, 2.0)};
  }
  decltype(Mark::shape) operator()(const Text& text) const { return text; }
};

/// One of its lines alone would not tell what is hatched.
std::vector<Polyline> hatched_sign(const Point& center) {
  constexpr double kSpacing = 5.0;
  const Point half(9.0, 7.0);
  const Rect box{center - half, center + half};
  return hatch({{box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}}},
               kSpacing, box);
}

/// The part of a segment that lies in a box.
double length_in(const Rect& box, const Obstacles::Segment& segment) {
  const Point difference = segment.b - segment.a;
  double from = 0.0;
  double to = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double low = box.min[axis] - segment.a[axis];
    const double high = box.max[axis] - segment.a[axis];
    if (difference[axis] == 0.0 && (low > 0.0 || high < 0.0)) return 0.0;
    if (difference[axis] == 0.0) continue;
    from = std::max(from, std::min(low / difference[axis], high / difference[axis]));
    to = std::min(to, std::max(low / difference[axis], high / difference[axis]));
  }
  return std::max(to - from, 0.0) * difference.norm();
}

/// Pixels of lines that a legend may cover: hiding a part of a line is better than not naming it.
constexpr double kMostHidden = 40.0;

/// Pixels that a box hides, the worst first: of marks that labels keep away from, and of lines that
/// pass.
using Hidden = std::pair<double, double>;

Hidden hidden_by(const Rect& box, const Obstacles& obstacles) {
  Hidden hidden;
  for (const Obstacles::Segment& segment : obstacles.segments)
    hidden.first += length_in(box, segment);
  for (const Obstacles::Segment& segment : obstacles.passing)
    hidden.second += length_in(box, segment);
  for (const Obstacles::Circle& circle : obstacles.circles) {
    const bool is_in = (circle.center.array() > box.min.array() - circle.radius).all() &&
                       (circle.center.array() < box.max.array() + circle.radius).all();
    if (is_in) hidden.first += kMostHidden;
  }
  return hidden;
}

/// The area that each row hides; the first row's upper left corner is `at`.
std::vector<Rect> boxes_of(const std::vector<LegendRow>& rows, Point at, const Fonts& fonts) {
  std::vector<Rect> boxes;
  at.y() += 0.5 * kLegendPad;
  for (const LegendRow& row : rows) {
    const double width = kGlyph + fonts.width(type::kText, row.text) + 2.0 * kLegendPad;
    boxes.push_back({at, at + Point(width, kLegendRow)});
    at.y() += kLegendRow;
  }
  return boxes;
}

/// The place at the edges of a card at which rows hide least, and no words; none if they would.
std::optional<Point> place_for(const std::vector<LegendRow>& rows, const Scene& scene,
                               const Rect& card, const std::vector<Rect>& words,
                               const Fonts& fonts) {
  constexpr int kPlaces = 6;  // along each edge
  std::optional<Point> best;
  Hidden least(kMostHidden, 0.0);
  const Point size = legend_size(rows, fonts);
  const Point room = card.size() - size;
  if ((room.array() < 0.0).any()) return std::nullopt;
  for (const Point& edge : {Point(0.0, 1.0), Point(1.0, 0.0), Point(0.0, 0.0)}) {
    for (int i = 0; i <= kPlaces; ++i) {
      const double along = static_cast<double>(i) / kPlaces;
      // The lower edge, the right one, the upper one.
      const Point share = edge.x() > 0.0 ? Point(1.0, along) : Point(along, edge.y());
      const Point at = card.min + share.cwiseProduct(room);
      const Rect box{at, at + size};
      if (std::any_of(words.begin(), words.end(),
                      [&](const Rect& word) { return overlap(box, word); }))
        continue;
      Hidden hidden;
      for (const Rect& row : boxes_of(rows, at, fonts)) {
        const auto [marks, passing] = hidden_by(row, scene.obstacles);
        hidden.first += marks;
        hidden.second += passing;
      }
      if (hidden >= least) continue;
      best = at;
      least = hidden;
    }
  }
  return best;
}

constexpr double kSame = 0.5;  // pixels between ends that are drawn as one

bool are_same(const Point& a, const Point& b) { return (a - b).norm() < kSame; }

/// Whether a mark that is drawn later leaves nothing to be seen of one: a disk in the middle of a
/// larger disk or of a diamond, a line between the same ends.
bool hides(const Mark& later, const Mark& mark) {
  if (later.role == mark.role) return false;
  if (const Disk* disk = std::get_if<Disk>(&mark.shape)) {
    if (const Disk* over = std::get_if<Disk>(&later.shape))
      return over->radius < sizes::kRingRadius &&
             (over->center - disk->center).norm() + disk->radius < over->radius + kSame;
    const Polygon* over = std::get_if<Polygon>(&later.shape);
    if (over == nullptr || over->points.size() != 4) return false;
    const double half = 0.5 * (over->points[2] - over->points[0]).norm();
    constexpr double kAround = 1.35;  // radii of a disk: half of the diamond around it
    constexpr double kMost = 15.0;    // half of a diamond; larger ones are areas
    return are_same(0.5 * (over->points[0] + over->points[2]), disk->center) &&
           half > kAround * disk->radius && half < kMost;
  }
  const Polyline* line = std::get_if<Polyline>(&mark.shape);
  const Polyline* over = std::get_if<Polyline>(&later.shape);
  if (line == nullptr || over == nullptr || line->points.size() != 2 || over->points.size() != 2)
    return false;
  const Point& from = over->points[0];
  const Point& to = over->points[1];
  return (are_same(line->points[0], from) && are_same(line->points[1], to)) ||
         (are_same(line->points[0], to) && are_same(line->points[1], from));
}

/// A line that is hardly a dot, or an area that the lines around it cover.
bool is_too_small(const Mark& mark) {
  const Polygon* area = std::get_if<Polygon>(&mark.shape);
  const Polyline* line = std::get_if<Polyline>(&mark.shape);
  if (area == nullptr && line == nullptr) return false;
  const std::vector<Point>& points = area ? area->points : line->points;
  double around = 0.0;
  double twice_area = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& from = points[i];
    const Point& to = points[(i + 1) % points.size()];
    around += (to - from).norm();
    twice_area += (from - points[0]).x() * (to - points[0]).y() -
                  (from - points[0]).y() * (to - points[0]).x();
  }
  constexpr double kShortest = 4.0;  // pixels of a line
  constexpr double kThinnest = 3.5;  // pixels from the middle of an area to its edges
  return area ? std::abs(twice_area) < kThinnest * around : around < 2.0 * kShortest;
}

}  // namespace

const Mark* mark_of(const Scene& scene, std::string_view role) {
  const auto is_seen = [&](const Mark& mark) {
    const auto later = scene.marks.begin() + (&mark - scene.marks.data()) + 1;
    return mark.role == role && !is_too_small(mark) &&
           std::none_of(later, scene.marks.end(),
                        [&](const Mark& other) { return hides(other, mark); });
  };
  const auto found = std::find_if(scene.marks.begin(), scene.marks.end(), is_seen);
  return found == scene.marks.end() ? nullptr : &*found;
}

Point legend_size(const std::vector<LegendRow>& rows, const Fonts& fonts) {
  double width = 0.0;
  for (const LegendRow& row : rows)
    width = std::max(width, kGlyph + fonts.width(type::kText, row.text) + 2.0 * kLegendPad);
  return {width, kLegendRow * static_cast<double>(rows.size()) + kLegendPad};
}

std::vector<Mark> legend(const std::vector<LegendRow>& rows, const Point& at, const Fonts& fonts) {
  std::vector<Mark> marks;
  for (const Rect& box : boxes_of(rows, at, fonts)) marks.push_back({"legend.box", Box{box, 4.0}});
  const double x = at.x() + kLegendPad;
  double y = at.y() + 0.5 * (kLegendRow + kLegendPad);
  for (const LegendRow& row : rows) {
    const Point center(x + 10.0, y);
    if (row.mark->role.ends_with(".hatch")) {
      for (Polyline& line : hatched_sign(center))
        marks.push_back({row.mark->role, std::move(line)});
    } else {
      marks.push_back({row.mark->role, std::visit(Glyph{center}, row.mark->shape)});
    }
    const double base = y + 0.5 * fonts.cap_height(type::kText);
    marks.push_back({"legend", Text{{x + kGlyph, base}, std::string(row.text), type::kText}});
    y += kLegendRow;
  }
  return marks;
}

std::vector<Mark> legend_on_stage(std::vector<LegendRow> rows, const Scene& scene, const Rect& card,
                                  const std::vector<Rect>& words, const Fonts& fonts) {
  const Point frame(1.0, 1.0);
  const Rect room{card.min + frame, card.max - frame};
  for (; !rows.empty(); rows.pop_back()) {
    if (const auto at = place_for(rows, scene, room, words, fonts)) return legend(rows, *at, fonts);
  }
  return {};
}

}  // namespace gjkscope
