#include "outlines/outline.hpp"

#include <algorithm>
#include <numeric>

#include "outlines/nearest.hpp"

namespace models {
namespace {

Point at(const Outline& outline, std::size_t i) {
  return outline.points[i % outline.points.size()];
}

/// The outline without points that repeat the one before, as it turns.
Ring distinct_points(const Outline& outline) {
  Ring ring;
  for (std::size_t i = 0; i < outline.points.size(); ++i) {
    if (outline.points[i] == at(outline, i + 1)) continue;
    ring.points.push_back(outline.points[i]);
    ring.index.push_back(static_cast<int>(i));
  }
  return ring;
}

/// The turn at the lowest of the leftmost points: the way around of an outline that does not meet
/// itself.
int orientation(const Ring& ring) {
  const auto first = static_cast<int>(
      std::min_element(ring.points.begin(), ring.points.end(), before) - ring.points.begin());
  return turn(ring.points[ring.previous(first)], ring.points[first], ring.points[ring.next(first)]);
}

Flaw check_points(const std::vector<Outline>& outlines) {
  if (outlines.empty()) return {Fault::no_outline};
  for (int i = 0; i < static_cast<int>(outlines.size()); ++i) {
    const std::vector<Point>& points = outlines[i].points;
    for (int k = 0; k < static_cast<int>(points.size()); ++k) {
      if (!points[k].allFinite()) return {Fault::not_finite, i, k};
    }
    if (points.size() < 2) return {Fault::too_few_points, i};
  }
  return {};
}

/// Two segments of an outline, one after the other, may meet in the point between them alone.
bool folds_back(const Segment& s, const Segment& next) {
  return turn(s.a, s.b, next.b) == 0 && along(s.b, s.a, next.b) > 0;
}

/// The first two segments of closed outlines that meet, but for neighbours in their common point.
Flaw check_meetings(const Model& model) {
  std::vector<Segment> segments;
  std::vector<int> next;  ///< The segment that follows in the same outline.
  for (std::size_t i = 0, first = 0; i < model.segments.size(); ++i) {
    const Segment& s = model.segments[i];
    if (s.index == 0) first = segments.size();
    if (s.a != s.b) segments.push_back(s);
    const bool ends = i + 1 == model.segments.size() || model.segments[i + 1].index == 0;
    if (!ends) continue;
    if (segments.size() < first + 2) return {Fault::not_simple, s.outline};
    for (std::size_t k = first; k < segments.size(); ++k) {
      next.push_back(static_cast<int>(k + 1 == segments.size() ? first : k + 1));
    }
  }
  const auto low = [&](int i) { return std::min(segments[i].a.x(), segments[i].b.x()); };
  const auto high = [&](int i) { return std::max(segments[i].a.x(), segments[i].b.x()); };
  std::vector<int> order(segments.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return low(i) != low(j) ? low(i) < low(j) : i < j; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size() && low(order[j]) <= high(order[i]); ++j) {
      const auto [one, two] = std::minmax(order[i], order[j]);
      const Segment& s = segments[one];
      const Segment& t = segments[two];
      const bool clash = next[one] == two   ? folds_back(s, t)
                         : next[two] == one ? folds_back(t, s)
                                            : meet(s, t);
      if (!clash) continue;
      const Fault fault = s.outline == t.outline ? Fault::not_simple : Fault::outlines_meet;
      return {fault, s.outline, s.index, t.outline, t.index};
    }
  }
  return {};
}

}  // namespace

Model model_of(std::vector<Outline> outlines) {
  Model model{std::move(outlines), {}};
  for (std::size_t i = 0; i < model.outlines.size(); ++i) {
    const Outline& outline = model.outlines[i];
    const std::size_t count = outline.points.size() - (outline.closed ? 0 : 1);
    for (std::size_t k = 0; k < count; ++k) {
      model.segments.push_back(
          {outline.points[k], at(outline, k + 1), static_cast<int>(i), static_cast<int>(k)});
    }
  }
  return model;
}

std::string_view name_of(Fault fault) {
  switch (fault) {
    case Fault::none:
      return "none";
    case Fault::no_outline:
      return "no outline";
    case Fault::too_few_points:
      return "too few points";
    case Fault::not_finite:
      return "not finite";
    case Fault::open_chain:
      return "open chain";
    case Fault::not_simple:
      return "not simple";
    case Fault::outlines_meet:
      return "outlines meet";
    case Fault::several_outlines:
      return "more than one outline";
    case Fault::not_convex:
      return "not convex";
  }
  return "";
}

Flaw check(const std::vector<Outline>& outlines, Needs needs) {
  if (const Flaw flaw = check_points(outlines); flaw.fault != Fault::none) return flaw;
  if (needs == Needs::segments) return {};
  for (int i = 0; i < static_cast<int>(outlines.size()); ++i) {
    if (!outlines[i].closed) return {Fault::open_chain, i};
  }
  if (needs == Needs::closed) return {};
  if (needs == Needs::simple) return check_meetings(model_of(outlines));
  if (outlines.size() > 1) return {Fault::several_outlines, 1};
  return is_convex(outlines.front()) ? Flaw{} : Flaw{Fault::not_convex};
}

int Ring::segment(int i) const {
  if (!reversed) return index[i];
  return index[next(i)];
}

Ring ring_of(const Outline& outline) {
  Ring ring = distinct_points(outline);
  if (orientation(ring) < 0) {
    std::reverse(ring.points.begin(), ring.points.end());
    std::reverse(ring.index.begin(), ring.index.end());
    ring.reversed = true;
  }
  return ring;
}

bool is_convex(const Outline& outline) {
  const Ring ring = distinct_points(outline);
  if (ring.size() < 3) return false;
  int side = 0;
  int lowest =
      0;  ///< Corners where the outline turns back from the left: one, if it goes around once.
  for (int i = 0; i < ring.size(); ++i) {
    const Point& from = ring.points[ring.previous(i)];
    const Point& at = ring.points[i];
    const Point& to = ring.points[ring.next(i)];
    const int here = turn(from, at, to);
    if (here == 0 && along(at, from, to) > 0) return false;
    if (here * side < 0) return false;
    if (here != 0) side = here;
    if (before(at, from) && before(at, to)) ++lowest;
  }
  return lowest == 1;
}

}  // namespace models
