#pragma once
// Pairs of shapes in families, easy and hard, for whatever speaks of many pairs: tests, benchmarks,
// the study. Needs the core alone.
//
// A seed gives the same pairs everywhere: all is made of + - * / and powers of two, and where one
// expression draws twice it draws in braces, whose order is the language's.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string_view>
#include <type_traits>
#include <vector>

#include "gjk/gjk.hpp"

namespace families {

using gjk::Vec;

/// A query that owns its vertices.
template <class S>
struct Pair {
  std::vector<Vec<S, 2>> x;
  std::vector<Vec<S, 2>> y;
  gjk::Pose<S, 2> x_pose = {};
  gjk::Pose<S, 2> y_pose = {};
  [[nodiscard]] gjk::Query<S, 2> query() const { return {{x, x_pose}, {y, y_pose}}; }
};

enum class Family : std::uint8_t {
  random,          ///< Polygons of 3 to 8 vertices, apart, close or overlapping.
  points,          ///< Points, segments and polygons against points and segments.
  collinear,       ///< Up to 4 points of one line each, on an axis or not.
  clouds,          ///< Unsorted point sets, most of whose points lie inside the hull.
  duplicates,      ///< Vertices repeated, next to each other or not.
  grid,            ///< Small integers: ties, touching, collinear triples.
  identical,       ///< The same shape twice.
  inside,          ///< One shape inside the other.
  posed,           ///< Rotated and moved by poses, at times far away together.
  needle,          ///< Triangles 1e-10 ... 1e-4 of their length wide.
  needle_polygon,  ///< One of them against a polygon.
  parallel,        ///< Facing edges that are parallel up to 1e-10 ... 1e-3.
  gap,             ///< 1e-12 ... 1e-3 apart.
  speck,           ///< 1e-30 ... 1e-12 apart; full doubles from 1e-100.
  shallow,         ///< Overlapping by 1e-6 ... 1e-3.
  touching,        ///< Touching exactly, on a dyadic grid.
  grazing,         ///< Touching up to rounding.
  tiny,            ///< Size 1e-4, 1e-6 or 1e-30.
  huge,            ///< Size 1e6 or 1e30.
  ratio,           ///< One shape 1e4 or 1e8 times the other, close to it.
  offset,          ///< Vertices 1e3 ... 1e6 from the origin; full doubles to 1e12.
  denormals,       ///< Small multiples of the smallest positive number.
};
inline constexpr std::array<std::string_view, 22> kFamilyNames = {
    "random",    "points", "collinear", "clouds",   "duplicates",     "grid",
    "identical", "inside", "posed",     "needle",   "needle-polygon", "parallel",
    "gap",       "speck",  "shallow",   "touching", "grazing",        "tiny",
    "huge",      "ratio",  "offset",    "denormals"};
inline constexpr int kFamilyCount = static_cast<int>(kFamilyNames.size());

enum class Representation : std::uint8_t {
  float_values,  ///< Every coordinate is a float.
  full_doubles,
};

/// The pair with X and Y in the other order.
template <class S>
[[nodiscard]] Pair<S> swapped(const Pair<S>& pair) {
  return {pair.y, pair.x, pair.y_pose, pair.x_pose};
}

/// The pair with its vertex lists rotated by `x` and `y` places.
template <class S>
[[nodiscard]] Pair<S> rotated(Pair<S> pair, std::size_t x, std::size_t y) {
  std::rotate(pair.x.begin(), pair.x.begin() + static_cast<long>(x % pair.x.size()), pair.x.end());
  std::rotate(pair.y.begin(), pair.y.begin() + static_cast<long>(y % pair.y.size()), pair.y.end());
  return pair;
}

/// The pair in another scalar.
/// Not inlined: where two conversions there and back stand side by side, GCC 12 leaves the rounding
/// out.
template <class To, class From>
[[nodiscard, gnu::noinline]] Pair<To> converted(const Pair<From>& pair) {
  Pair<To> out;
  const auto convert = [](const Vec<From, 2>& v) {
    return Vec<To, 2>(static_cast<To>(v[0]), static_cast<To>(v[1]));
  };
  for (const Vec<From, 2>& vertex : pair.x) out.x.push_back(convert(vertex));
  for (const Vec<From, 2>& vertex : pair.y) out.y.push_back(convert(vertex));
  const auto convert_pose = [](const gjk::Pose<From, 2>& pose) {
    return gjk::Pose<To, 2>{pose.rotation.matrix().template cast<To>(),
                            pose.translation.template cast<To>()};
  };
  out.x_pose = convert_pose(pair.x_pose);
  out.y_pose = convert_pose(pair.y_pose);
  return out;
}

/// The pair with the floats that lie nearest to its numbers.
[[nodiscard]] inline Pair<double> rounded_to_floats(const Pair<double>& pair) {
  return converted<double>(converted<float>(pair));
}

/// Largest distance between a vertex of X and one of Y.
template <class S>
[[nodiscard]] double scale_of(const Pair<S>& pair) {
  double scale = 0;
  for (const Vec<S, 2>& x : pair.x) {
    for (const Vec<S, 2>& y : pair.y) {
      const Vec<S, 2> z = (pair.y_pose.rotated(y) - pair.x_pose.rotated(x)) +
                          (pair.y_pose.translation - pair.x_pose.translation);
      scale = std::max(scale, std::hypot(static_cast<double>(z[0]), static_cast<double>(z[1])));
    }
  }
  return scale;
}

/// The pair's distance, computed in R.
template <class R, class S>
[[nodiscard]] gjk::Result<R, 2> run(const Pair<S>& pair) {
  return gjk::distance<R>(pair.query());
}

class Source {
 public:
  explicit Source(std::uint64_t seed) : bits_(seed) {}

  [[nodiscard]] double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
  }
  [[nodiscard]] int among(int low, int high) {
    return low + static_cast<int>(bits_() % static_cast<std::uint64_t>(high - low + 1));
  }
  [[nodiscard]] bool with_chance(double share) { return between(0, 1) < share; }

  /// Log-uniform by octaves: each power of two has the same share.
  [[nodiscard]] double magnitude(double low, double high) {
    const int octave = among(std::ilogb(low), std::ilogb(high));
    return std::clamp(std::ldexp(between(1, 2), octave), low, high);
  }

  template <class S>
  [[nodiscard]] std::vector<Vec<S, 2>> grid_points(int count, int size) {
    std::vector<Vec<S, 2>> vertices;
    for (int i = 0; i < count; ++i) {
      const int x = among(-size, size);
      vertices.emplace_back(static_cast<S>(x), static_cast<S>(among(-size, size)));
    }
    return vertices;
  }

  /// Two convex polygons of `count` vertices each, apart, close or overlapping.
  [[nodiscard]] Pair<double> polygons(int count) { return apart_or_not({count, count}); }

  /// A pair of the family, in a random order of arguments and with its vertex lists randomly
  /// rotated. Only S = double has anything but float values.
  template <class S>
  [[nodiscard]] Pair<S> pair(Family family,
                             Representation representation = Representation::full_doubles) {
    const bool floats =
        !std::is_same_v<S, double> || representation == Representation::float_values;
    Pair<double> made = make(family, floats);
    if (with_chance(0.5)) made = swapped(made);
    const std::array<std::size_t, 2> places = {bits_() % 64, bits_() % 64};
    made = rotated(std::move(made), places[0], places[1]);
    if (floats) made = rounded_to_floats(made);
    if constexpr (std::is_same_v<S, double>) {
      return made;
    } else {
      return converted<S>(made);
    }
  }

 private:
  using Point = Vec<double, 2>;
  using Points = std::vector<Point>;

  static constexpr double kNoGrid = 0x1p-60;

  /// A point of the unit circle, any of them, not quite equally often.
  [[nodiscard]] static Point on_circle(double quarters) {
    const double quarter = std::floor(quarters);
    const double t = quarters - quarter;
    Point first((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t));
    switch (static_cast<int>(quarter) & 3) {
      case 0:
        return first;
      case 1:
        return {-first[1], first[0]};
      case 2:
        return -first;
      default:
        return {first[1], -first[0]};
    }
  }
  [[nodiscard]] Point direction() { return on_circle(between(0, 4)); }
  [[nodiscard]] Point in_square(double size) {
    const double x = between(-size, size);
    return {x, between(-size, size)};
  }
  /// `v` as a complex number times `by`: turned, and stretched where |by| is not 1.
  [[nodiscard]] static Point turned(const Point& v, const Point& by) {
    return {v[0] * by[0] - v[1] * by[1], v[0] * by[1] + v[1] * by[0]};
  }
  static void move(Points& points, const Point& by) {
    for (Point& p : points) p += by;
  }
  static void turn(Points& points, const Point& by) {
    for (Point& p : points) p = turned(p, by);
  }
  static void scale(Points& points, double by) {
    for (Point& p : points) p *= by;
  }
  static void turn(Pair<double>& pair, const Point& by) {
    turn(pair.x, by);
    turn(pair.y, by);
  }
  static void move(Pair<double>& pair, const Point& by) {
    move(pair.x, by);
    move(pair.y, by);
  }
  static void scale(Pair<double>& pair, double by) {
    scale(pair.x, by);
    scale(pair.y, by);
  }

  /// Vertices on an ellipse of size 1 around the origin, in either sense of rotation.
  [[nodiscard]] Points polygon(int count) {
    Points vertices;
    const Point axis = direction();
    const double squash = between(0.3, 1.0);
    for (int i = 0; i < count; ++i) {
      const Point p = on_circle(4 * (i + between(0, 0.9)) / count);
      vertices.push_back(turned({p[0], squash * p[1]}, axis));
    }
    if (with_chance(0.5)) std::reverse(vertices.begin(), vertices.end());
    return vertices;
  }
  struct Placed {
    int count;
    Point centre;
  };
  [[nodiscard]] Points polygon_at(const Placed& placed) {
    Points vertices = polygon(placed.count);
    move(vertices, placed.centre);
    return vertices;
  }

  /// A triangle of length 2 around the origin, `width` times 2 wide.
  [[nodiscard]] static Points needle(double width) { return {{-1, 0}, {1, width}, {1, -width}}; }

  [[nodiscard]] static double snapped(double value, double grid) {
    return std::nearbyint(value / grid) * grid;
  }

  /// A convex shape that rests on the x-axis: on a vertex at the origin, or on an edge that holds
  /// the origin. Coordinates are multiples of `grid`.
  [[nodiscard]] Points resting(int count, bool on_edge, double grid) {
    if (count == 1) return {{0, 0}};
    if (count == 2 && on_edge) {
      return {{snapped(between(-1, 0), grid), 0}, {snapped(between(0, 1), grid), 0}};
    }
    Points shape = polygon(count);
    std::size_t lowest = 0;
    for (std::size_t i = 0; i < shape.size(); ++i) {
      if (shape[i][1] < shape[lowest][1]) lowest = i;
    }
    move(shape, Point(-shape[lowest]));
    if (on_edge) {  // cut off the lowest vertex
      const Point before = shape[(lowest + shape.size() - 1) % shape.size()];
      const Point after = shape[(lowest + 1) % shape.size()];
      const double height = between(0.1, 0.6) * std::min(before[1], after[1]);
      const double from = before[0] * height / before[1];
      const double to = after[0] * height / after[1];
      move(shape, Point(-from - between(0, 1) * (to - from), -height));
      const double shift = shape[lowest][0];
      shape[lowest] = Point(from + shift, 0);
      shape.insert(shape.begin() + static_cast<long>(lowest) + 1, Point(to + shift, 0));
    }
    for (Point& p : shape) p = Point(snapped(p[0], grid), snapped(p[1], grid));
    return shape;
  }

  struct Counts {
    int x;
    int y;
  };
  struct Facing {
    Counts counts;
    bool x_edge;
    bool y_edge;
    double grid;
  };
  /// X below the x-axis, Y above it, and both touching it; at the origin where X's edge and Y's
  /// do, or X's vertex and Y's edge, and so on.
  [[nodiscard]] Pair<double> facing(const Facing& how) {
    Pair<double> out{resting(how.counts.x, how.x_edge, how.grid),
                     resting(how.counts.y, how.y_edge, how.grid)};
    for (Point& p : out.x) p[1] = -p[1];
    return out;
  }

  /// Turns a pair made by `facing` without rounding its contact away: by quarters of a turn; where
  /// nothing of Y but a vertex comes close, by a small integer vector; where full doubles may round
  /// it a little, by any angle.
  void turn_contact(Pair<double>& pair, bool floats, bool y_edge) {
    if (!floats && with_chance(0.5)) {
      turn(pair, direction());
      move(pair, in_square(1));
    } else if (y_edge) {
      turn(pair, on_circle(among(0, 3)));
    } else {
      turn(pair, Point{among(1, 7), among(-7, 7)});
    }
  }

  [[nodiscard]] Pair<double> apart_or_not(const Counts& counts) {
    return {polygon(counts.x), polygon_at({counts.y, in_square(2.5)})};
  }

  void repeat_vertices(Points& points) {
    for (int i = among(1, 4); i > 0; --i) {
      const Point copy =
          points[static_cast<std::size_t>(among(0, static_cast<int>(points.size()) - 1))];
      const auto at = std::find(points.begin(), points.end(), copy);
      points.insert(
          with_chance(0.6) ? at : points.begin() + among(0, static_cast<int>(points.size())), copy);
    }
  }

  [[nodiscard]] Pair<double> collinear() {
    const bool on_axis = with_chance(0.4);
    const bool exact = with_chance(0.6);
    const Point along = on_axis ? on_circle(among(0, 3))
                        : exact ? Point{among(1, 7), among(-7, 7)}
                                : direction();
    const Point from = exact ? Point{among(-4, 4), among(-4, 4)} : in_square(2);
    Pair<double> out;
    for (Points* points : {&out.x, &out.y}) {
      const double shift = points == &out.y ? among(-4, 4) : 0;
      for (int i = among(1, 4); i > 0; --i) {
        const double t = exact ? among(-4, 4) * 0.25 : between(-1, 1);
        points->push_back(from + along * (shift + t));
      }
    }
    return out;
  }

  [[nodiscard]] Pair<double> clouds() {
    const Point shift = in_square(2.5);
    Pair<double> out;
    for (int i = among(6, 12); i > 0; --i) {
      out.x.push_back(in_square(1));
      out.y.push_back(in_square(1) + shift);
    }
    return out;
  }

  [[nodiscard]] Pair<double> duplicates() {
    Pair<double> out = apart_or_not({among(1, 5), among(1, 5)});
    repeat_vertices(out.x);
    if (with_chance(0.7)) repeat_vertices(out.y);
    return out;
  }

  [[nodiscard]] Pair<double> grid() {
    Pair<double> out{grid_points<double>(among(1, 6), 3), grid_points<double>(among(1, 6), 3)};
    move(out.y, Point{among(0, 6), among(-1, 1)});
    return out;
  }

  [[nodiscard]] Pair<double> identical() {
    const Points shape = with_chance(0.8) ? polygon_at({among(1, 8), in_square(2)})
                                          : grid_points<double>(among(1, 6), 3);
    return {shape, shape};
  }

  [[nodiscard]] Pair<double> inside() {
    Pair<double> out{polygon(among(3, 8)), polygon(among(1, 8))};
    scale(out.y, magnitude(1e-3, 0.5));
    move(out.y, in_square(0.2));
    return out;
  }

  [[nodiscard]] Pair<double> posed(bool floats) {
    Pair<double> out{polygon(among(1, 8)), polygon(among(1, 8))};
    const double away = with_chance(0.3) ? magnitude(1e1, floats ? 1e4 : 1e9) : 0;
    const Point far = direction() * away;
    for (gjk::Pose<double, 2>* pose : {&out.x_pose, &out.y_pose}) {
      const Point turn = direction();
      pose->rotation = Eigen::Matrix2d{{turn[0], -turn[1]}, {turn[1], turn[0]}};
      pose->translation = in_square(1.5) + far;
    }
    return out;
  }

  [[nodiscard]] Pair<double> needles() {
    Pair<double> out{needle(magnitude(1e-10, 1e-4)), needle(magnitude(1e-10, 1e-4))};
    const double tilt = magnitude(1e-10, 1e-3);
    turn(out.y, with_chance(0.7) ? direction() : on_circle(with_chance(0.5) ? tilt : 2 + tilt));
    move(out.y, in_square(1.5));
    turn(out, direction());
    return out;
  }

  [[nodiscard]] Pair<double> needle_and_polygon() {
    Pair<double> out{needle(magnitude(1e-10, 1e-4)), polygon_at({among(3, 8), in_square(1.5)})};
    turn(out, direction());
    return out;
  }

  [[nodiscard]] Pair<double> parallel(bool floats) {
    Pair<double> out = facing({{among(2, 6), among(2, 6)}, true, true, kNoGrid});
    const double tilt = magnitude(1e-10, 1e-3);
    turn(out.y, Point(1, with_chance(0.5) ? tilt : -tilt));
    const double distance = magnitude(1e-10, 1);
    move(out.y, Point{between(-1, 1), with_chance(0.3) ? -0.3 * distance : distance});
    turn_contact(out, floats, true);
    return out;
  }

  /// In contact, then moved apart by `gap`, or into each other where that is negative.
  struct Gap {
    double least;
    double most;
    double sign;
    bool turned_exactly;
  };
  [[nodiscard]] Pair<double> moved_by(const Gap& gap, bool y_edge, double grid) {
    Pair<double> out = facing({{among(1, 8), among(1, 8)}, with_chance(0.6), y_edge, grid});
    move(out.y, Point(0, gap.sign * magnitude(gap.least, gap.most)));
    turn_contact(out, gap.turned_exactly, y_edge);
    return out;
  }

  [[nodiscard]] Pair<double> touching(bool y_edge, double grid) {
    Pair<double> out = facing({{among(1, 8), among(1, 8)}, with_chance(0.6), y_edge, grid});
    turn_contact(out, true, false);
    move(out, Point{among(-64, 64) * 0.125, among(-64, 64) * 0.125});
    return out;
  }

  [[nodiscard]] Pair<double> grazing(bool y_edge) {
    Pair<double> out = facing({{among(1, 8), among(1, 8)}, with_chance(0.6), y_edge, kNoGrid});
    turn(out, direction());
    move(out, in_square(1));
    return out;
  }

  [[nodiscard]] Pair<double> tiny() {
    Pair<double> out = apart_or_not({among(1, 8), among(1, 8)});
    constexpr std::array<double, 3> kSizes = {1e-4, 1e-6, 1e-30};
    const double size = kSizes[static_cast<std::size_t>(among(0, 2))];
    scale(out, size * between(1, 2));
    return out;
  }

  [[nodiscard]] Pair<double> huge() {
    Pair<double> out = apart_or_not({among(1, 8), among(1, 8)});
    const double size = with_chance(0.5) ? 1e6 : 1e30;
    scale(out, size * between(1, 2));
    return out;
  }

  [[nodiscard]] Pair<double> ratio(bool floats, bool y_edge) {
    Pair<double> out = facing({{among(3, 8), among(1, 8)}, with_chance(0.6), y_edge, kNoGrid});
    scale(out.x, with_chance(0.5) ? 1e4 : 1e8);
    move(out.y, Point{between(-2, 2), with_chance(0.4) ? -between(0, 2) : magnitude(1e-6, 4)});
    turn_contact(out, floats, y_edge);
    return out;
  }

  [[nodiscard]] Pair<double> offset(bool floats) {
    Pair<double> out = apart_or_not({among(1, 8), among(1, 8)});
    const double away = magnitude(1e3, floats ? 1e6 : 1e12);
    move(out, Point(direction() * away));
    return out;
  }

  [[nodiscard]] Pair<double> denormals(double smallest) {
    const int size = 1 << among(0, 16);
    Pair<double> out{grid_points<double>(among(1, 6), size),
                     grid_points<double>(among(1, 6), size)};
    move(out.y, Point(among(0, 2 * size), 0));
    scale(out, smallest);
    return out;
  }

  [[nodiscard]] Pair<double> make(Family family, bool floats) {
    const double grid_step = floats ? 0x1p-12 : 0x1p-40;
    const bool y_edge = with_chance(0.5);
    switch (family) {
      case Family::random:
        return apart_or_not({among(3, 8), among(3, 8)});
      case Family::points:
        return {polygon(among(1, 2)),
                polygon_at({with_chance(0.5) ? among(1, 2) : among(3, 8), in_square(1.5)})};
      case Family::collinear:
        return collinear();
      case Family::clouds:
        return clouds();
      case Family::duplicates:
        return duplicates();
      case Family::grid:
        return grid();
      case Family::identical:
        return identical();
      case Family::inside:
        return inside();
      case Family::posed:
        return posed(floats);
      case Family::needle:
        return needles();
      case Family::needle_polygon:
        return needle_and_polygon();
      case Family::parallel:
        return parallel(floats);
      case Family::gap:
        return moved_by({1e-12, 1e-3, 1, floats}, y_edge, grid_step);
      case Family::speck:
        return moved_by({floats ? 1e-30 : 1e-100, 1e-12, 1, true}, y_edge, grid_step);
      case Family::shallow:
        return moved_by({1e-6, 1e-3, -1, floats}, y_edge, grid_step);
      case Family::touching:
        return touching(y_edge, grid_step);
      case Family::grazing:
        return grazing(y_edge);
      case Family::tiny:
        return tiny();
      case Family::huge:
        return huge();
      case Family::ratio:
        return ratio(floats, y_edge);
      case Family::offset:
        return offset(floats);
      case Family::denormals:
        return denormals(floats ? double{std::numeric_limits<float>::denorm_min()}
                                : std::numeric_limits<double>::denorm_min());
    }
    return {};
  }

  std::mt19937_64 bits_;
};

}  // namespace families
