#include "picture/labels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "outlines/polygon.hpp"

namespace gjkscope {
namespace {

// Costs of a place, in arbitrary units that only compare: leaving the stage is worse than covering
// a label, that worse than standing close to one, that worse than covering a mark, that worse than
// an unexpected side; moving must be worth at least one covered line.
constexpr double kOutside = 1e6;
constexpr double kOverLabel = 1e5;
constexpr double kByLabel = 1e4;  // however many marks another place covers
constexpr double kOverCircle = 120.0;
constexpr double kOverSegment = 100.0;
constexpr double kOverPassing = 20.0;
constexpr int kBuried = 64;      // marks under a label: more are no worse
constexpr int kMostPassing = 4;  // lines that count: where many pass, near is better than free
constexpr double kWrongSide = 12.0;
constexpr double kFarther = 8.0;
constexpr double kFarKept = 1.7;      // a pixel that a label stays farther away: moves from 24 on
constexpr double kOtherAnchor = 8.0;  // each further one
constexpr double kMove = 40.0;
constexpr double kOverPassingNow = 60.0;  // more, in the one frame that the line is in
constexpr double kAcross = 30.0;          // a line between a label and what it names
constexpr double kNear = 30.0;
constexpr double kNearerToAnother = 30.0;  // a mark that the label does not name
constexpr double kClearance = 4.0;         // pixels between a label and what it must not touch
constexpr double kLabelClearance = 6.0;    // and between two labels, which would read as one
constexpr double kAreaClearance = 18.0;  // and between the name of an area and a mark with its own
constexpr double kLineClearance = 9.0;   // and a line, which it has room to keep away from
constexpr double kSideKept = 8.0;        // times kWrongSide, for labels that keep their side
constexpr int kDirections = 24;
constexpr int kRings = 7;
constexpr int kFixedRings = 4;  // of what stays in place, and has a single one
constexpr int kMostRings = 40;  // of what finds no room nearer

Rect box_around(const Point& center, const Point& size) {
  return {center - 0.5 * size, center + 0.5 * size};
}

Rect grown(const Rect& box, double by) {
  return {box.min - Point(by, by), box.max + Point(by, by)};
}

bool contains(const Rect& outer, const Rect& inner) {
  return outer.min.x() <= inner.min.x() && outer.min.y() <= inner.min.y() &&
         inner.max.x() <= outer.max.x() && inner.max.y() <= outer.max.y();
}

/// Clips the segment's parameter range against the box, side by side (Liang and Barsky 1984).
bool hits(const Rect& box, const Obstacles::Segment& segment) {
  const auto is_beside = [&](int axis) {
    return std::max(segment.a[axis], segment.b[axis]) < box.min[axis] ||
           std::min(segment.a[axis], segment.b[axis]) > box.max[axis];
  };
  if (is_beside(0) || is_beside(1)) return false;
  double enter = 0.0;
  double leave = 1.0;
  const Point d = segment.b - segment.a;
  for (int axis = 0; axis < 2; ++axis) {
    const double low = box.min[axis] - segment.a[axis];
    const double high = box.max[axis] - segment.a[axis];
    if (d[axis] == 0.0) {
      if (low > 0.0 || high < 0.0) return false;
      continue;
    }
    enter = std::max(enter, std::min(low / d[axis], high / d[axis]));
    leave = std::min(leave, std::max(low / d[axis], high / d[axis]));
  }
  return enter <= leave;
}

Point nearest_in(const Rect& box, const Point& to) {
  return to.cwiseMax(box.min).cwiseMin(box.max);
}

double distance(const Rect& box, const Point& to) { return (nearest_in(box, to) - to).norm(); }

bool hits(const Rect& box, const Obstacles::Circle& circle) {
  return distance(box, circle.center) < circle.radius;
}

/// True if the segments have a point in common that is no end of either.
bool cross(const Obstacles::Segment& p, const Obstacles::Segment& q) {
  const auto side = [](const Obstacles::Segment& of, const Point& point) {
    const Point d = of.b - of.a;
    const Point to = point - of.a;
    return d.x() * to.y() - d.y() * to.x();
  };
  return side(p, q.a) * side(p, q.b) < 0.0 && side(q, p.a) * side(q, p.b) < 0.0;
}

}  // namespace

bool is_inside(std::span<const Point> polygon, const Rect& box) {
  const double orientation = signed_area(polygon);
  const Point corners[] = {
      box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i];
    const Point edge = polygon[(i + 1) % polygon.size()] - a;
    for (const Point& corner : corners) {
      const Point to = corner - a;
      if ((edge.x() * to.y() - edge.y() * to.x()) * orientation < 0.0) return false;
    }
  }
  return true;
}

std::optional<Obstacles::Segment> leader_line(const LabelRequest& request, const Rect& label) {
  Point anchor = request.anchor;
  for (const Point& other : request.other_anchors)
    if (distance(label, other) < distance(label, anchor)) anchor = other;
  const Point from = nearest_in(label, anchor);
  const double length = (anchor - from).norm();
  if (length <= request.gap + kLeaderFrom) return std::nullopt;
  const Point along = (anchor - from) / length;
  const Point to = anchor - 0.6 * request.gap * along;
  return Obstacles::Segment{from + 2.0 * along, to};
}

LabelPlacer::LabelPlacer(const Fonts& fonts, const Rect& bounds)
    : fonts_(fonts), bounds_(bounds), segments_(bounds), passing_(bounds), circles_(bounds) {}

void LabelPlacer::begin_frame(const Obstacles& obstacles) {
  segments_.clear();
  passing_.clear();
  circles_.clear();
  taken_.clear();
  leaders_.clear();
  grounds_ = obstacles.grounds;
  add(obstacles);
}

void LabelPlacer::add(const Obstacles& obstacles) {
  segments_.add(obstacles.segments);
  passing_.add(obstacles.passing);
  circles_.add(obstacles.circles);
}

Point LabelPlacer::size_of(const std::string& text, const TextStyle& style) const {
  return {fonts_.width(style, text), fonts_.cap_height(style) + 0.22 * style.size};
}

LabelPlacer::Cover LabelPlacer::cover_of(const Rect& box, double least) const {
  const Rect clear = grown(box, kClearance);
  Cover cover{contains(bounds_, clear) ? 0.0 : kOutside};
  const Rect apart = grown(box, kLabelClearance);
  for (const Rect& label : taken_) {
    if (overlap(apart, label)) cover.cost += overlap(box, label) ? kOverLabel : kByLabel;
  }
  for (const Obstacles::Segment& leader : leaders_)
    cover.cost += hits(clear, leader) ? kByLabel : 0.0;
  int met = 0;
  const auto is_enough = [&](double each) {
    return [&, each](const auto& item) {
      if (hits(clear, item.shape)) {
        cover.cost += each * item.count;
        ++met;
      }
      return cover.cost >= least || met >= kBuried;
    };
  };
  if (cover.cost < least && !circles_.any_near(clear, is_enough(kOverCircle)))
    (void)segments_.any_near(clear, is_enough(kOverSegment));
  cover.is_buried = met >= kBuried;
  return cover;
}

double LabelPlacer::cost_of_neighbours(const Rect& box, const LabelRequest& request) const {
  // Gaps hold what is drawn at the anchor and a little more; so a tie goes to what is named.
  const double own = distance(box, request.anchor) - request.gap;
  const bool is_ambiguous =
      circles_.any_near(grown(box, std::max(own + 2.0, 0.0)), [&](const auto& item) {
        const Obstacles::Circle& circle = item.shape;
        return (circle.center - request.anchor).norm() > request.gap &&
               distance(box, circle.center) - circle.radius < own + 2.0;
      });
  return is_ambiguous ? kNearerToAnother : 0.0;
}

double LabelPlacer::cost_of_leader(const Rect& box, const LabelRequest& request) const {
  const std::optional<Obstacles::Segment> leader = leader_line(request, box);
  if (!leader) return 0.0;
  const bool crosses = std::any_of(taken_.begin(), taken_.end(),
                                   [&](const Rect& label) { return hits(label, *leader); });
  return crosses ? kByLabel : 0.0;
}

double LabelPlacer::cost_of_passing(const Rect& box, bool in_frame) const {
  const Rect clear = grown(box, kClearance);
  int passing = 0;
  (void)passing_.any_near(clear, [&](const auto& item) {
    passing += hits(clear, item.shape) ? 1 : 0;
    return passing >= kMostPassing;
  });
  return kOverPassing * static_cast<double>(passing) +
         (in_frame && passing > 0 ? kOverPassingNow : 0.0);
}

Mark LabelPlacer::mark_at(const Rect& box, const std::string& text, const std::string& role,
                          const TextStyle& style) const {
  const double base = box.max.y() - 0.22 * style.size * 0.5;
  return {role, Text{{box.center().x(), base}, text, style, Align::center}};
}

Mark LabelPlacer::mark_of(const LabelRequest& request, const Rect& box) const {
  Mark mark = mark_at(box, request.text, request.role, request.style);
  std::get<Text>(mark.shape).tones = request.tones;
  return mark;
}

Mark LabelPlacer::place(const LabelRequest& request, bool fixed) {
  const Point size = size_of(request.text, request.style);
  const auto known = places_.find(request.id);
  const bool moves = known != places_.end();
  // A place for all frames must avoid the lines of every frame, unless the label may step aside. A
  // place for one frame must avoid the lines of that frame.
  const bool in_frame = !fixed || moves;
  const bool minds_passing = in_frame || !request.steps_aside;
  const auto center = [&](const Kept& place) -> Point {
    return request.anchor + place.beside + 0.5 * place.face.cwiseProduct(size);
  };
  const auto is_cut_off = [&](const Point& middle) {
    const Point difference = middle - request.anchor;
    const double length = difference.norm();
    if (length <= request.gap) return false;
    const Obstacles::Segment visible{request.anchor + request.gap / length * difference, middle};
    return segments_.any_near(visible.box(),
                              [&](const auto& item) { return cross(visible, item.shape); });
  };
  if (fixed && moves && !request.steps_aside) {
    const Rect box = box_around(center(known->second), size);
    taken_.push_back(box);
    return mark_of(request, box);
  }
  double best_cost = std::numeric_limits<double>::infinity();
  bool is_buried = false;
  Kept best;
  const auto consider = [&](const Kept& place, double extra) {
    if (extra >= best_cost) return;
    const Rect box = box_around(center(place), size);
    const Cover cover = cover_of(box, best_cost);
    if (extra + cover.cost >= best_cost) return;
    const double cost = extra + cover.cost + (in_frame ? cost_of_neighbours(box, request) : 0.0) +
                        cost_of_leader(box, request) +
                        (minds_passing ? cost_of_passing(box, in_frame) : 0.0) +
                        (is_cut_off(box.center()) ? kAcross : 0.0);
    if (cost < best_cost) {
      best_cost = cost;
      best = place;
      is_buried = cover.is_buried;
    }
  };
  if (moves) {
    // A label that had to go far away comes back once there is room.
    const bool comes_back = !fixed && request.other_anchors.empty();
    const double away = comes_back ? known->second.beside.norm() - request.gap : 0.0;
    consider(known->second, kFarKept * std::max(away, 0.0));
  }
  const double start = request.towards.norm() > 0.0
                           ? std::atan2(request.towards.y(), request.towards.x())
                           : -0.25 * std::numbers::pi;
  const int rings = fixed && request.other_anchors.empty() ? kFixedRings : kRings;
  const auto consider_beside = [&](const Point& anchor, double extra) {
    // A label that lies on a mesh of lines would lie on it farther away, too.
    const auto goes_on = [&](int ring) {
      return ring < kMostRings && best_cost >= kByLabel && !is_buried;
    };
    for (int ring = 0; ring < rings || goes_on(ring); ++ring) {
      for (int k = 0; k < kDirections; ++k) {
        const double turn = 2.0 * std::numbers::pi * k / kDirections;
        const Point d(std::cos(start + turn), std::sin(start + turn));
        // The box touches the free circle with the side or corner that faces the anchor.
        const Point face = d / std::max(std::abs(d.x()), std::abs(d.y()));
        const double side = request.keeps_side ? kSideKept * kWrongSide : kWrongSide;
        consider({anchor - request.anchor + d * (request.gap + 7.0 * ring), face},
                 extra + side * (1.0 - std::cos(turn)) + kFarther * ring + (moves ? kMove : 0.0));
      }
    }
  };
  consider_beside(request.anchor, 0.0);
  double extra = 0.0;
  for (const Point& anchor : request.other_anchors) consider_beside(anchor, extra += kOtherAnchor);
  // A label with a place for all frames steps aside for a frame, and then is back.
  if (!fixed || !moves) places_[request.id] = best;
  const Rect box = box_around(center(best), size);
  taken_.push_back(box);
  return mark_of(request, box);
}

void LabelPlacer::take_back(const std::string& id) {
  places_.erase(id);
  taken_.pop_back();
}

bool LabelPlacer::is_crossed(const Rect& label) const {
  const auto crosses = [&](const auto& item) { return hits(label, item.shape); };
  return segments_.any_near(label, crosses) || passing_.any_near(label, crosses) ||
         circles_.any_near(label, crosses) ||
         std::any_of(grounds_.begin(), grounds_.end(),
                     [&](const Rect& ground) { return overlap(label, ground); });
}

std::vector<Mark> LabelPlacer::place_inside(const AreaLabelRequest& request, bool in_any_case) {
  const Point size = size_of(request.text, request.style);
  Rect extent{request.polygon[0], request.polygon[0]};
  for (const Point& point : request.polygon) {
    extent.min = extent.min.cwiseMin(point);
    extent.max = extent.max.cwiseMax(point);
  }
  extent.min = extent.min.cwiseMax(bounds_.min);
  extent.max = extent.max.cwiseMin(bounds_.max);
  const Point middle = centroid(request.polygon);
  std::optional<Point> best;
  double best_cost = in_any_case ? std::numeric_limits<double>::infinity() : kOverCircle;
  const auto consider = [&](const Point& center, double extra) {
    const Rect box = box_around(center, size);
    if (extra >= best_cost || !is_inside(request.polygon, grown(box, 3.0 * kClearance))) return;
    const Rect wide = grown(box, kAreaClearance);
    const Rect aside = grown(box, kLineClearance);
    const double on_marks = cover_of(box, best_cost).cost;
    if (extra + on_marks >= best_cost) return;
    const bool near =
        circles_.any_near(wide, [&](const auto& item) { return hits(wide, item.shape); }) ||
        segments_.any_near(aside, [&](const auto& item) { return hits(aside, item.shape); });
    const double cost = extra + on_marks + cost_of_passing(box, false) + (near ? kNear : 0.0);
    if (cost < best_cost) {
      best_cost = cost;
      best = center;
    }
  };
  const auto known = places_.find(request.id);
  if (known != places_.end()) consider(known->second.beside, 0.0);
  constexpr double kStep = 10.0;
  for (double y = extent.min.y() + kStep; y < extent.max.y(); y += kStep) {
    for (double x = extent.min.x() + kStep; x < extent.max.x(); x += kStep) {
      consider({x, y},
               0.05 * (Point(x, y) - middle).norm() + (known != places_.end() ? kMove : 0.0));
    }
  }
  if (!best) {
    if (!request.otherwise) return {};
    return {place(*request.otherwise, false)};
  }
  places_[request.id] = {*best, Point::Zero()};
  const Rect box = box_around(*best, size);
  taken_.push_back(grown(box, 2.0 * kLabelClearance));
  return {mark_at(box, request.text, request.role, request.style)};
}

}  // namespace gjkscope
