#include "picture/depth_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "outlines/polygon.hpp"

namespace gjkscope {

using Eigen::AlignedBox2d;
using Eigen::Vector3d;

namespace {

AlignedBox2d box_on_screen(const PointsInSpace& points) {
  AlignedBox2d box;
  for (const Vector3d& point : points) box.extend(Point(point.head<2>()));
  return box;
}

}  // namespace

Convex::Convex(std::vector<Facet> faces, const PointsInSpace& points)
    : facets(std::move(faces)), box(box_on_screen(points)) {
  for (Facet& facet : facets) {
    facet.box = box_on_screen(facet.corners);
    widest = std::max(widest, facet.box.sizes().x());
  }
  const auto left = [](const Facet& facet) { return facet.box.min().x(); };
  std::stable_sort(facets.begin(), facets.end(),
                   [&](const Facet& a, const Facet& b) { return left(a) < left(b); });
  std::vector<Point> seen;
  nearest = -std::numeric_limits<double>::infinity();
  for (const Vector3d& point : points) {
    seen.emplace_back(point.head<2>());
    nearest = std::max(nearest, point.z());
  }
  for (const int corner : convex_hull(seen)) outline.push_back(seen[corner]);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point edge = outline[(i + 1) % outline.size()] - outline[i];
    sides.push_back({{Vector3d(outline[i].x(), outline[i].y(), 0.0)},
                     Vector3d(edge.y(), -edge.x(), 0.0).normalized()});
  }
  constexpr double kMost = 1000.0;  // pixels: a size that can be seen
  touching = 1e-6 * std::min(box.sizes().norm(), kMost);
}

namespace {

/// Whether a part of a disk, a line or a polygon, which had this many corners, is worth a mark.
bool is_seen(const PointsInSpace& part, std::size_t corners) {
  constexpr double kLength = 0.5;
  constexpr double kArea = 0.25;
  if (corners == 1) return !part.empty();
  if (corners == 2) return part.size() == 2 && (part[1] - part[0]).head<2>().norm() > kLength;
  double twice = 0.0;
  for (std::size_t i = 2; i < part.size(); ++i) {
    const Vector3d a = part[i - 1] - part[0];
    const Vector3d b = part[i] - part[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return std::abs(twice) > 2.0 * kArea;
}

/// The part for which `beyond` is not positive. (Sutherland and Hodgman 1974.)
template <class Beyond>
PointsInSpace part_of(const PointsInSpace& points, const Beyond& beyond) {
  PointsInSpace out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d& a = points[i];
    const Vector3d& b = points[(i + 1) % points.size()];
    const double of_a = beyond(a);
    const double of_b = beyond(b);
    if (of_a <= 0.0) out.push_back(a);
    const bool is_way_back = points.size() == 2 && i == 1;
    if (of_a * of_b < 0.0 && !is_way_back) out.push_back(a + of_a / (of_a - of_b) * (b - a));
  }
  return out;
}

struct Parts {
  PointsInSpace behind;             ///< The thing hides it from the eye.
  std::vector<PointsInSpace> rest;  ///< All else, if some is behind.
  bool has_before = false;          ///< Some lies between the thing and the eye.
};

Parts parts_of(const PointsInSpace& points, const Convex& by) {
  Parts out;
  const AlignedBox2d box = box_on_screen(points);
  if (by.facets.empty() || !box.intersects(by.box)) return out;
  PointsInSpace left = points;
  /// Takes away what lies beyond a plane, and returns whether anything is left.
  const auto cut = [&](const Facet& plane, bool is_front) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    const auto beyond = [&](const Vector3d& point) {
      return plane.normal.dot(point - plane.corners[0]) + by.touching;
    };
    for (const Vector3d& point : left) {
      least = std::min(least, beyond(point));
      most = std::max(most, beyond(point));
    }
    if (most <= 0.0) return true;
    PointsInSpace outside =
        least >= 0.0 ? left : part_of(left, [&](const Vector3d& at) { return -beyond(at); });
    if (is_seen(outside, points.size())) {
      out.has_before = out.has_before || (is_front && most > 2.0 * by.touching);
      out.rest.push_back(std::move(outside));
    }
    if (least < 0.0) left = part_of(left, beyond);
    return least < 0.0 && is_seen(left, points.size());
  };
  for (const Facet& side : by.sides) {
    if (!cut(side, false)) return out;
  }
  // Among the planes of all facets, over each place that of the facet there is the lowest.
  auto facet = std::lower_bound(by.facets.begin(), by.facets.end(), box.min().x() - by.widest,
                                [](const Facet& each, double x) { return each.box.min().x() < x; });
  for (; facet != by.facets.end() && facet->box.min().x() <= box.max().x(); ++facet) {
    if (box.intersects(facet->box) && !cut(*facet, true)) return out;
  }
  out.behind = std::move(left);
  return out;
}

const std::vector<Facet>& parts_of(const PaintedSurface& surface) {
  return surface.is_whole ? surface.shape->facets : surface.parts;
}

/// Surfaces and loose marks of which some lie behind a thing, and the rest.
struct Pile {
  std::vector<PaintedSurface> surfaces;
  std::vector<LooseMark> loose;
};

void split(const PaintedSurface& surface, const Convex& by, Pile& behind, Pile& rest) {
  PaintedSurface hidden = surface;
  hidden.is_whole = false;
  hidden.parts.clear();
  PaintedSurface seen = hidden;
  for (const Facet& facet : parts_of(surface)) {
    Parts parts = parts_of(facet.corners, by);
    if (parts.behind.empty()) {
      seen.parts.push_back(facet);
      continue;
    }
    hidden.parts.push_back({std::move(parts.behind), facet.normal, facet.is_shaded});
    for (PointsInSpace& part : parts.rest)
      seen.parts.push_back({std::move(part), facet.normal, facet.is_shaded});
  }
  if (seen.parts.empty()) return behind.surfaces.push_back(surface);
  if (hidden.parts.empty()) return rest.surfaces.push_back(surface);
  behind.surfaces.push_back(std::move(hidden));
  rest.surfaces.push_back(std::move(seen));
}

void split(LooseMark mark, const Convex& by, std::vector<LooseMark>& behind,
           std::vector<LooseMark>& rest) {
  const bool is_deep =
      std::any_of(mark.points.begin(), mark.points.end(),
                  [&](const Vector3d& point) { return point.z() < by.nearest - by.touching; });
  Parts parts = is_deep ? parts_of(mark.points, by) : Parts{};
  if (parts.behind.empty()) return rest.push_back(std::move(mark));
  for (PointsInSpace& part : parts.rest) {
    rest.push_back(mark);
    rest.back().points = std::move(part);
  }
  mark.points = std::move(parts.behind);
  behind.push_back(std::move(mark));
}

/// Each surface is painted over what it hides of all others, and below the rest. A surface that
/// hides and is hidden takes turns: the others are cut along what it hides of them, so that no
/// circle is left, and each part goes on its own.
class Painter {
 public:
  explicit Painter(const std::vector<PaintedSurface>& surfaces)
      : goes_before_(surfaces.size(), std::vector<bool>(surfaces.size(), false)) {
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      for (std::size_t k = i + 1; k < surfaces.size(); ++k) relate(surfaces[i], surfaces[k]);
    }
  }

  void paint(Pile pile) {
    while (!pile.surfaces.empty()) {
      const auto next = next_of(pile.surfaces);
      const bool is_clear = next != pile.surfaces.end();
      const auto chosen =
          is_clear ? next
                   : std::max_element(pile.surfaces.begin(), pile.surfaces.end(),
                                      [](const PaintedSurface& a, const PaintedSurface& b) {
                                        return a.shape->facets.size() < b.shape->facets.size();
                                      });
      const PaintedSurface surface = std::move(*chosen);
      pile.surfaces.erase(chosen);
      Pile behind;
      Pile rest;
      for (LooseMark& mark : pile.loose)
        split(std::move(mark), *surface.shape, behind.loose, rest.loose);
      if (is_clear) {
        rest.surfaces = std::move(pile.surfaces);
      } else {
        for (const PaintedSurface& other : pile.surfaces)
          split(other, *surface.shape, behind, rest);
      }
      paint(std::move(behind));
      add(surface);
      pile = std::move(rest);
    }
    for (const LooseMark& mark : pile.loose) add(mark);
  }

  std::vector<Mark> marks;

 private:
  void relate(const PaintedSurface& first, const PaintedSurface& second) {
    for (const Facet& facet : second.shape->facets) {
      const Parts parts = parts_of(facet.corners, *first.shape);
      if (parts.has_before) goes_before_[first.index][second.index] = true;
      if (!parts.behind.empty()) goes_before_[second.index][first.index] = true;
    }
  }

  /// The first that no other has to be painted before; none where there are parts, of which less
  /// is known.
  std::vector<PaintedSurface>::iterator next_of(std::vector<PaintedSurface>& surfaces) const {
    const bool are_whole = std::all_of(surfaces.begin(), surfaces.end(),
                                       [](const PaintedSurface& s) { return s.is_whole; });
    if (!are_whole) return surfaces.end();
    return std::find_if(surfaces.begin(), surfaces.end(), [&](const PaintedSurface& surface) {
      return std::none_of(surfaces.begin(), surfaces.end(), [&](const PaintedSurface& other) {
        return goes_before_[other.index][surface.index];
      });
    });
  }

  void add(const std::string& role, const PointsInSpace& corners, const Subject& subject) {
    std::vector<Point> seen;
    for (const Vector3d& corner : corners) seen.emplace_back(corner.head<2>());
    if (corners.size() == 2)
      marks.push_back({role, Polyline{std::move(seen)}, -1, subject});
    else
      marks.push_back({role, Polygon{std::move(seen)}, -1, subject});
  }

  void add(const PaintedSurface& surface) {
    for (const Facet& facet : parts_of(surface)) {
      if (facet.is_shaded) add(surface.shade, facet.corners, {});
      if (!surface.is_whole) add(surface.fill, facet.corners, surface.subject);
    }
    if (surface.is_whole)
      marks.push_back({surface.fill, Polygon{surface.shape->outline}, -1, surface.subject});
  }

  void add(const LooseMark& mark) {
    if (mark.points.size() == 2) return add(mark.role, mark.points, mark.subject);
    marks.push_back({mark.role, Disk{mark.points[0].head<2>(), mark.radius}, -1, mark.subject});
  }

  std::vector<std::vector<bool>> goes_before_;
};

}  // namespace

std::vector<Mark> in_order_of_depth(std::vector<PaintedSurface> surfaces,
                                    std::vector<LooseMark> loose) {
  for (std::size_t i = 0; i < surfaces.size(); ++i) surfaces[i].index = i;
  for (const PaintedSurface& surface : surfaces) {
    if (!surface.is_opaque) continue;
    std::vector<LooseMark> hidden;
    std::vector<LooseMark> seen;
    for (LooseMark& mark : loose) {
      if (mark.hidden.empty())
        seen.push_back(std::move(mark));
      else
        split(std::move(mark), *surface.shape, hidden, seen);
    }
    for (LooseMark& mark : hidden) {
      mark.role = std::exchange(mark.hidden, {});
      seen.push_back(std::move(mark));
    }
    loose = std::move(seen);
  }
  Painter painter(surfaces);
  painter.paint({std::move(surfaces), std::move(loose)});
  return std::move(painter.marks);
}

}  // namespace gjkscope
