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
#include <initializer_list>
#include <limits>
#include <random>
#include <string_view>
#include <type_traits>
#include <vector>

#include "study/pair.hpp"

namespace families {

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
  tiny,            ///< Size 1e-4, 1e-6 or 1e-30; in space full doubles from 1e-150.
  huge,            ///< Size 1e6 or 1e30; in space full doubles to 1e150.
  ratio,           ///< One shape 1e4 or 1e8 (in space full doubles: 1e12) times the other, close.
  offset,          ///< Vertices 1e3 ... 1e6 from the origin; full doubles to 1e12.
  denormals,       ///< Small multiples of the smallest positive number.
  // In space alone:
  flat,    ///< Plates 1e-10 ... 1e-4 of their size thick.
  sliver,  ///< Tetrahedra whose vertices lie in a plane up to 1e-10 ... 1e-4.
  grain,   ///< One shape 1e-12 ... 1e-6 times the other, not far away.
  ulp,     ///< Touching exactly, but for one coordinate that is one unit in the last place off.
};
inline constexpr std::array<std::string_view, 26> kFamilyNames = {
    "random",    "points",   "collinear", "clouds",         "duplicates", "grid",  "identical",
    "inside",    "posed",    "needle",    "needle-polygon", "parallel",   "gap",   "speck",
    "shallow",   "touching", "grazing",   "tiny",           "huge",       "ratio", "offset",
    "denormals", "flat",     "sliver",    "grain",          "ulp"};
inline constexpr int kFamilyCount = 22;  ///< The families of the plane.
inline constexpr int kSpaceFamilyCount = static_cast<int>(kFamilyNames.size());

enum class Representation : std::uint8_t {
  float_values,  ///< Every coordinate is a float.
  full_doubles,
};

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

  template <class S, int D = 2>
  [[nodiscard]] std::vector<Vec<S, D>> grid_points(int count, int size) {
    std::vector<Vec<S, D>> vertices(static_cast<std::size_t>(count));
    for (Vec<S, D>& v : vertices) {
      for (int i = 0; i < D; ++i) v[i] = static_cast<S>(among(-size, size));
    }
    return vertices;
  }

  /// Two convex polygons of `count` vertices each, apart, close or overlapping.
  [[nodiscard]] Pair<double> polygons(int count) { return apart_or_not<2>({count, count}); }

  /// A pair of the family, in a random order of arguments and with its vertex lists randomly
  /// rotated. Only S = double has anything but float values.
  template <class S, int D = 2>
  [[nodiscard]] Pair<S, D> pair(Family family,
                                Representation representation = Representation::full_doubles) {
    const bool floats =
        !std::is_same_v<S, double> || representation == Representation::float_values;
    Pair<double, D> made = make<D>(family, floats);
    if (D == 3 && family != Family::posed && with_chance(0.25)) pose_exactly(made);
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
  template <int D>
  using Point = Vec<double, D>;
  template <int D>
  using Points = std::vector<Point<D>>;
  /// Turns, and stretches where its columns are longer than 1.
  template <int D>
  using Turn = Eigen::Matrix<double, D, D>;

  static constexpr double kNoGrid = 0x1p-60;
  /// How far centers are from each other, at most, along each axis: some shapes overlap.
  template <int D>
  static constexpr double kSpread = D == 2 ? 2.5 : 1.0;

  /// A point of the unit circle, any of them, not quite equally often.
  [[nodiscard]] static Point<2> on_circle(double quarters) {
    const double quarter = std::floor(quarters);
    const double t = quarters - quarter;
    Point<2> first((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t));
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
  /// 1 goes to `by`, a complex number.
  [[nodiscard]] static Turn<2> turn_to(const Point<2>& by) {
    return Turn<2>{{by[0], -by[1]}, {by[1], by[0]}};
  }
  /// By the quaternion (a, v), times its length squared: integers where those are.
  [[nodiscard]] static Turn<3> turn_by(double a, const Point<3>& v) {
    const double real = a * a - (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    Turn<3> out;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      out(i, i) = real + 2 * (v[i] * v[i]);
      out(i, j) = 2 * (v[i] * v[j] - a * v[k]);
      out(j, i) = 2 * (v[i] * v[j] + a * v[k]);
    }
    return out;
  }

  template <int D>
  [[nodiscard]] Turn<D> any_turn() {
    if constexpr (D == 2) {
      return turn_to(direction<2>());
    } else {
      for (;;) {
        const double a = between(-1, 1);
        const Point<3> v = in_box<3>(1);
        const double length_sq = a * a + (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        if (length_sq > 0.0625 && length_sq <= 1) return turn_by(a, v) / length_sq;
      }
    }
  }
  /// Takes axes to axes.
  template <int D>
  [[nodiscard]] Turn<D> quarter_turn() {
    if constexpr (D == 2) {
      return turn_to(on_circle(among(0, 3)));
    } else {
      Turn<3> out = Turn<3>::Zero();
      const int first = among(0, 2);
      const Turn<2> rest = turn_to(on_circle(among(0, 3)));
      for (int i = 0; i < 3; ++i) {
        const int row = (i + first) % 3;
        if (i == 2) out(row, 2) = 1;
        for (int k = 0; i < 2 && k < 2; ++k) out(row, k) = rest(i, k);
      }
      return out;
    }
  }
  /// A turn of small integers, with columns of the same length.
  template <int D>
  [[nodiscard]] Turn<D> integer_turn() {
    if constexpr (D == 2) {
      return turn_to(Point<2>{among(1, 7), among(-7, 7)});
    } else {
      const Point<3> axis = in_grid<3>(2);
      return turn_by(among(1, 2), axis);
    }
  }

  template <int D>
  [[nodiscard]] Point<D> direction() {
    if constexpr (D == 2) {
      return on_circle(between(0, 4));
    } else {
      return any_turn<3>().col(0);
    }
  }
  template <int D>
  [[nodiscard]] Point<D> in_box(double size) {
    Point<D> out;
    for (int i = 0; i < D; ++i) out[i] = between(-size, size);
    return out;
  }
  template <int D>
  [[nodiscard]] Point<D> in_grid(int size) {
    Point<D> out;
    for (int i = 0; i < D; ++i) out[i] = among(-size, size);
    return out;
  }
  /// Height 0: the last coordinate.
  template <int D>
  [[nodiscard]] Point<D> in_ground(double size) {
    Point<D> out = Point<D>::Zero();
    for (int i = 0; i < D - 1; ++i) out[i] = between(-size, size);
    return out;
  }
  template <int D>
  [[nodiscard]] static Point<D> turned(const Point<D>& v, const Turn<D>& by) {
    return gjk::Pose<double, D>{by}.rotated(v);
  }
  template <int D>
  static void move(Points<D>& points, const Point<D>& by) {
    for (Point<D>& p : points) p += by;
  }
  template <int D>
  static void turn(Points<D>& points, const Turn<D>& by) {
    for (Point<D>& p : points) p = turned<D>(p, by);
  }
  template <int D>
  static void scale(Points<D>& points, double by) {
    for (Point<D>& p : points) p *= by;
  }
  template <int D>
  static void turn(Pair<double, D>& pair, const Turn<D>& by) {
    turn<D>(pair.x, by);
    turn<D>(pair.y, by);
  }
  template <int D>
  static void move(Pair<double, D>& pair, const Point<D>& by) {
    move<D>(pair.x, by);
    move<D>(pair.y, by);
  }
  template <int D>
  static void scale(Pair<double, D>& pair, double by) {
    scale<D>(pair.x, by);
    scale<D>(pair.y, by);
  }

  /// Vertices on an ellipse of size 1 around the origin, in either sense of rotation.
  [[nodiscard]] Points<2> polygon(int count) {
    Points<2> vertices;
    const Turn<2> axis = any_turn<2>();
    const double squash = between(0.3, 1.0);
    for (int i = 0; i < count; ++i) {
      const Point<2> p = on_circle(4 * (i + between(0, 0.9)) / count);
      vertices.push_back(turned<2>({p[0], squash * p[1]}, axis));
    }
    if (with_chance(0.5)) std::reverse(vertices.begin(), vertices.end());
    return vertices;
  }
  /// A polygon in space; a box; or vertices on an ellipsoid.
  [[nodiscard]] Points<3> solid(int count) {
    Points<3> vertices;
    if (count > 2 && with_chance(0.15)) {
      for (const Point<2>& p : polygon(count)) vertices.emplace_back(p[0], p[1], 0);
    } else if (count == 8 && with_chance(0.7)) {
      for (int i = 0; i < 8; ++i) {
        vertices.emplace_back((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
      }
      scale<3>(vertices, 0.5);
    } else {
      for (int i = 0; i < count; ++i) vertices.push_back(direction<3>());
    }
    const Point<3> squash{between(0.3, 1), between(0.3, 1), 1};
    for (Point<3>& p : vertices) p = p.cwiseProduct(squash);
    turn<3>(vertices, any_turn<3>());
    return vertices;
  }
  /// A convex shape around the origin: a polygon, or a solid.
  template <int D>
  [[nodiscard]] Points<D> shape(int count) {
    if constexpr (D == 2) {
      return polygon(count);
    } else {
      return solid(count);
    }
  }
  template <int D>
  struct Placed {
    int count;
    Point<D> center;
  };
  template <int D>
  [[nodiscard]] Points<D> shape_at(const Placed<D>& placed) {
    Points<D> vertices = shape<D>(placed.count);
    move<D>(vertices, placed.center);
    return vertices;
  }

  /// A triangle, or a tetrahedron, of length 2 around the origin, `width` times 2 wide.
  template <int D>
  [[nodiscard]] static Points<D> needle(double width) {
    if constexpr (D == 2) {
      return {{-1, 0}, {1, width}, {1, -width}};
    } else {
      return {{-1, 0, 0}, {1, width, 0}, {1, -width, width}, {1, -width, -width}};
    }
  }
  /// Two squares of size 2, `width` times 2 apart.
  [[nodiscard]] static Points<3> plate(double width) {
    Points<3> out;
    for (const double height : {-width, width}) {
      for (int i = 0; i < 4; ++i) {
        out.emplace_back((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, height);
      }
    }
    return out;
  }
  /// Two edges of length 2 that cross, `width` times 2 apart.
  [[nodiscard]] static Points<3> sliver(double width) {
    return {{-1, 0, width}, {1, 0, width}, {0, -1, -width}, {0, 1, -width}};
  }

  [[nodiscard]] static double snapped(double value, double grid) {
    return std::nearbyint(value / grid) * grid;
  }
  template <int D>
  [[nodiscard]] static Point<D> snapped(Point<D> p, double grid) {
    for (int i = 0; i < D; ++i) p[i] = snapped(p[i], grid);
    return p;
  }

  /// A convex shape that rests on the x-axis: on a vertex at the origin, or on an edge that holds
  /// the origin. Coordinates are multiples of `grid`.
  [[nodiscard]] Points<2> polygon_at_rest(int count, bool on_edge, double grid) {
    if (count == 1) return {{0, 0}};
    if (count == 2 && on_edge) {
      return {{snapped(between(-1, 0), grid), 0}, {snapped(between(0, 1), grid), 0}};
    }
    Points<2> shape = polygon(count);
    std::size_t lowest = 0;
    for (std::size_t i = 0; i < shape.size(); ++i) {
      if (shape[i][1] < shape[lowest][1]) lowest = i;
    }
    move<2>(shape, Point<2>(-shape[lowest]));
    if (on_edge) {  // cut off the lowest vertex
      const Point<2> before = shape[(lowest + shape.size() - 1) % shape.size()];
      const Point<2> after = shape[(lowest + 1) % shape.size()];
      const double height = between(0.1, 0.6) * std::min(before[1], after[1]);
      const double from = before[0] * height / before[1];
      const double to = after[0] * height / after[1];
      move<2>(shape, Point<2>(-from - between(0, 1) * (to - from), -height));
      const double shift = shape[lowest][0];
      shape[lowest] = Point<2>(from + shift, 0);
      shape.insert(shape.begin() + static_cast<long>(lowest) + 1, Point<2>(to + shift, 0));
    }
    for (Point<2>& p : shape) p = snapped<2>(p, grid);
    return shape;
  }
  /// The same on the plane of x and y: on a vertex at the origin, on an edge or a face (1 or 2
  /// dimensions) that holds it.
  [[nodiscard]] Points<3> solid_at_rest(int count, int contact, double grid) {
    const Point<3> a = snapped<3>(in_ground<3>(1), grid);
    const Point<3> b = snapped<3>(in_ground<3>(1), grid);
    Points<3> out = {Point<3>::Zero()};
    if (contact == 1) out = {a, Point<3>(-a * among(1, 2))};
    if (contact == 2 && count % 2 == 0) out = {a, b, -a, -b};
    if (contact == 2 && count % 2 == 1) out = {a, b, -a - b};
    while (static_cast<int>(out.size()) < count) {
      Point<3> p = in_ground<3>(1);
      p[2] = between(0.1, 1.5);
      out.push_back(snapped<3>(p, grid));
    }
    return out;
  }
  template <int D>
  [[nodiscard]] Points<D> resting(int count, int contact, double grid) {
    if constexpr (D == 2) {
      return polygon_at_rest(count, contact != 0, grid);
    } else {
      return solid_at_rest(count, contact, grid);
    }
  }
  /// Dimensions of a face: 0 of a vertex.
  template <int D>
  [[nodiscard]] int contact(double chance_of_edge) {
    return D == 2 ? static_cast<int>(with_chance(chance_of_edge)) : among(0, 2);
  }

  struct Counts {
    int x;
    int y;
  };
  struct Facing {
    Counts counts;
    int x_contact;
    int y_contact;
    double grid;
  };
  /// X below height 0, Y above it, and both touching it; at the origin where X's edge and Y's
  /// do, or X's vertex and Y's edge, and so on.
  template <int D>
  [[nodiscard]] Pair<double, D> facing(const Facing& how) {
    Pair<double, D> out{resting<D>(how.counts.x, how.x_contact, how.grid),
                        resting<D>(how.counts.y, how.y_contact, how.grid)};
    for (Point<D>& p : out.x) p[D - 1] = -p[D - 1];
    return out;
  }

  /// Turns a pair made by `facing` without rounding its contact away: by quarters of a turn; where
  /// nothing of Y but a vertex comes close, by small integers; where full doubles may round it a
  /// little, by any angle.
  template <int D>
  void turn_contact(Pair<double, D>& pair, bool floats, bool y_edge) {
    if (!floats && with_chance(0.5)) {
      turn<D>(pair, any_turn<D>());
      move<D>(pair, in_box<D>(1));
    } else if (y_edge) {
      turn<D>(pair, quarter_turn<D>());
    } else {
      turn<D>(pair, integer_turn<D>());
    }
  }

  /// The same place in the world, to the bit, by a pose that both shapes have.
  template <int D>
  void pose_exactly(Pair<double, D>& pair) {
    const Turn<D> by = quarter_turn<D>();
    turn<D>(pair, Turn<D>(by.transpose()));
    pair.x_pose.rotation = pair.y_pose.rotation = by;
    pair.x_pose.translation = pair.y_pose.translation = in_grid<D>(8);
  }

  template <int D>
  [[nodiscard]] Pair<double, D> apart_or_not(const Counts& counts) {
    return {shape<D>(counts.x), shape_at<D>({counts.y, in_box<D>(kSpread<D>)})};
  }

  template <int D>
  void repeat_vertices(Points<D>& points) {
    for (int i = among(1, 4); i > 0; --i) {
      const Point<D> copy = points[among(0, static_cast<int>(points.size()) - 1)];
      const auto at = std::find(points.begin(), points.end(), copy);
      points.insert(
          with_chance(0.6) ? at : points.begin() + among(0, static_cast<int>(points.size())), copy);
    }
  }

  [[nodiscard]] Pair<double> collinear() {
    const bool on_axis = with_chance(0.4);
    const bool exact = with_chance(0.6);
    const Point<2> along = on_axis ? on_circle(among(0, 3))
                           : exact ? Point<2>{among(1, 7), among(-7, 7)}
                                   : direction<2>();
    const Point<2> from = exact ? Point<2>{among(-4, 4), among(-4, 4)} : in_box<2>(2);
    Pair<double> out;
    for (Points<2>* points : {&out.x, &out.y}) {
      const double shift = points == &out.y ? among(-4, 4) : 0;
      for (int i = among(1, 4); i > 0; --i) {
        const double t = exact ? among(-4, 4) * 0.25 : between(-1, 1);
        points->push_back(from + along * (shift + t));
      }
    }
    return out;
  }
  /// In a common line, or each in a line or a plane through the same point.
  [[nodiscard]] Pair<double, 3> coplanar() {
    const bool exact = with_chance(0.6);
    const auto vector = [&] { return exact ? in_grid<3>(3) : direction<3>(); };
    const Point<3> from = exact ? vector() : in_box<3>(2);
    const Point<3> common = vector();
    const int planes = among(0, 2);  // of the two shapes
    Pair<double, 3> out;
    for (Points<3>* points : {&out.x, &out.y}) {
      const bool is_y = points == &out.y;
      const Point<3> other = vector() * (planes > (is_y ? 1 : 0) ? 1.0 : 0.0);
      const double shift = is_y ? among(-4, 4) : 0;
      for (int i = among(1, 6); i > 0; --i) {
        const double s = exact ? among(-4, 4) * 0.25 : between(-1, 1);
        const double t = exact ? among(-4, 4) * 0.25 : between(-1, 1);
        points->push_back(from + common * (shift + s) + other * t);
      }
    }
    return out;
  }

  template <int D>
  [[nodiscard]] Pair<double, D> clouds() {
    const Point<D> shift = in_box<D>(D == 2 ? 2.5 : 1.8);
    Pair<double, D> out;
    for (int i = among(6, 12); i > 0; --i) {
      out.x.push_back(in_box<D>(1));
      out.y.push_back(in_box<D>(1) + shift);
    }
    return out;
  }

  template <int D>
  [[nodiscard]] Pair<double, D> duplicates() {
    Pair<double, D> out = apart_or_not<D>({among(1, 5), among(1, 5)});
    repeat_vertices<D>(out.x);
    if (with_chance(0.7)) repeat_vertices<D>(out.y);
    return out;
  }

  template <int D>
  [[nodiscard]] Pair<double, D> grid() {
    Pair<double, D> out{grid_points<double, D>(among(1, 6), 3),
                        grid_points<double, D>(among(1, 6), 3)};
    Point<D> by = Point<D>::Zero();
    by[0] = among(0, 6);
    by[1] = among(-1, 1);
    move<D>(out.y, by);
    if (D == 3 && with_chance(0.3)) {  // in a plane
      for (Points<D>* points : {&out.x, &out.y}) {
        for (Point<D>& p : *points) p[D - 1] = 0;
      }
      turn<D>(out, integer_turn<D>());
    }
    return out;
  }

  template <int D>
  [[nodiscard]] Pair<double, D> identical() {
    const Points<D> same = with_chance(0.8) ? shape_at<D>({among(1, 8), in_box<D>(2)})
                                            : grid_points<double, D>(among(1, 6), 3);
    return {same, same};
  }

  template <int D>
  [[nodiscard]] Pair<double, D> inside() {
    Pair<double, D> out{shape<D>(among(D == 2 ? 3 : 7, 8)), shape<D>(among(1, 8))};
    scale<D>(out.y, magnitude(1e-3, 0.5));
    move<D>(out.y, in_box<D>(D == 2 ? 0.2 : 0.1));
    return out;
  }

  template <int D>
  [[nodiscard]] Pair<double, D> posed(bool floats) {
    Pair<double, D> out{shape<D>(among(1, 8)), shape<D>(among(1, 8))};
    const double away = with_chance(0.3) ? magnitude(1e1, floats ? 1e4 : 1e9) : 0;
    const Point<D> far = direction<D>() * away;
    for (gjk::Pose<double, D>* pose : {&out.x_pose, &out.y_pose}) {
      pose->rotation = any_turn<D>();
      pose->translation = in_box<D>(D == 2 ? 1.5 : 0.8) + far;
    }
    return out;
  }

  [[nodiscard]] Pair<double> needles() {
    Pair<double> out{needle<2>(magnitude(1e-10, 1e-4)), needle<2>(magnitude(1e-10, 1e-4))};
    const double tilt = magnitude(1e-10, 1e-3);
    turn<2>(out.y, with_chance(0.7) ? any_turn<2>()
                                    : turn_to(on_circle(with_chance(0.5) ? tilt : 2 + tilt)));
    move<2>(out.y, in_box<2>(1.5));
    turn<2>(out, any_turn<2>());
    return out;
  }
  /// Two shapes that are nearly flat, or nearly lines: at any angle to each other or nearly none.
  [[nodiscard]] Pair<double, 3> thin(Points<3> (*thin_shape)(double)) {
    Pair<double, 3> out{thin_shape(magnitude(1e-10, 1e-4)), thin_shape(magnitude(1e-10, 1e-4))};
    const double tilt = magnitude(1e-10, 1e-3);
    turn<3>(out.y, with_chance(0.7) ? any_turn<3>() : turn_by(1, in_box<3>(1) * tilt));
    const double away = magnitude(1e-6, 1);
    move<3>(out.y, Point<3>(in_box<3>(1) * away));
    turn<3>(out, any_turn<3>());
    return out;
  }

  template <int D>
  [[nodiscard]] Pair<double, D> thin_and_not(Points<D> (*thin_shape)(double)) {
    Pair<double, D> out{thin_shape(magnitude(1e-10, 1e-4)),
                        shape_at<D>({among(3, 8), in_box<D>(D == 2 ? 1.5 : 0.8)})};
    turn<D>(out, any_turn<D>());
    return out;
  }

  template <int D>
  [[nodiscard]] Pair<double, D> parallel(bool floats) {
    const auto edge_or_face = [&] { return D == 2 ? 1 : among(1, 2); };
    const auto count = [&] { return D == 2 ? among(2, 6) : among(2, 8); };
    Pair<double, D> out = facing<D>({{count(), count()}, edge_or_face(), edge_or_face(), kNoGrid});
    const double tilt = magnitude(1e-10, 1e-3);
    if constexpr (D == 2) {
      turn<D>(out.y, turn_to({1, with_chance(0.5) ? tilt : -tilt}));
    } else if (with_chance(0.7)) {
      turn<D>(out.y, turn_by(1, in_ground<3>(1) * tilt));
    }
    const double distance = magnitude(1e-10, 1);
    Point<D> by = in_ground<D>(1);
    by[D - 1] = with_chance(0.3) ? -0.3 * distance : distance;
    move<D>(out.y, by);
    turn_contact<D>(out, floats, true);
    return out;
  }

  /// In contact, then moved apart by `gap`, or into each other where that is negative.
  struct Gap {
    double least;
    double most;
    double sign;
    bool turned_exactly;
  };
  template <int D>
  [[nodiscard]] Pair<double, D> moved_by(const Gap& gap, int y_contact, double grid) {
    Pair<double, D> out = facing<D>({{among(1, 8), among(1, 8)}, contact<D>(0.6), y_contact, grid});
    Point<D> by = Point<D>::Zero();
    by[D - 1] = gap.sign * magnitude(gap.least, gap.most);
    move<D>(out.y, by);
    turn_contact<D>(out, gap.turned_exactly, y_contact != 0);
    return out;
  }

  template <int D>
  [[nodiscard]] Pair<double, D> touching(int y_contact, double grid) {
    Pair<double, D> out = facing<D>({{among(1, 8), among(1, 8)}, contact<D>(0.6), y_contact, grid});
    turn_contact<D>(out, true, false);
    move<D>(out, Point<D>(in_grid<D>(64) * 0.125));
    return out;
  }

  /// One coordinate of one vertex is as little off as `floats` or doubles allow.
  [[nodiscard]] Pair<double, 3> nearly_touching(int y_contact, double grid, bool floats) {
    Pair<double, 3> out = touching<3>(y_contact, grid);
    Points<3>& points = with_chance(0.5) ? out.x : out.y;
    double& value = points[among(0, std::min(2, static_cast<int>(points.size()) - 1))][among(0, 2)];
    const double to = with_chance(0.5) ? 1e9 : -1e9;
    value = floats ? double{std::nextafter(static_cast<float>(value), static_cast<float>(to))}
                   : std::nextafter(value, to);
    return out;
  }

  template <int D>
  [[nodiscard]] Pair<double, D> grazing(int y_contact) {
    Pair<double, D> out =
        facing<D>({{among(1, 8), among(1, 8)}, contact<D>(0.6), y_contact, kNoGrid});
    turn<D>(out, any_turn<D>());
    move<D>(out, in_box<D>(1));
    return out;
  }

  template <int D>
  [[nodiscard]] Pair<double, D> sized(std::initializer_list<double> sizes) {
    Pair<double, D> out = apart_or_not<D>({among(1, 8), among(1, 8)});
    const double size = sizes.begin()[among(0, static_cast<int>(sizes.size()) - 1)];
    scale<D>(out, size * between(1, 2));
    return out;
  }
  template <int D>
  [[nodiscard]] Pair<double, D> tiny(bool floats) {
    return D == 2 || floats ? sized<D>({1e-4, 1e-6, 1e-30})
                            : sized<D>({1e-6, 1e-30, 1e-90, 1e-150});
  }
  template <int D>
  [[nodiscard]] Pair<double, D> huge(bool floats) {
    if constexpr (D == 3) {
      return floats ? sized<D>({1e6, 1e30}) : sized<D>({1e6, 1e30, 1e90, 1e150});
    }
    Pair<double, D> out = apart_or_not<D>({among(1, 8), among(1, 8)});
    const double size = with_chance(0.5) ? 1e6 : 1e30;
    scale<D>(out, size * between(1, 2));
    return out;
  }

  template <int D>
  [[nodiscard]] Pair<double, D> ratio(bool floats, int y_contact) {
    Pair<double, D> out =
        facing<D>({{among(3, 8), among(1, 8)}, contact<D>(0.6), y_contact, kNoGrid});
    scale<D>(out.x, with_chance(0.5) ? 1e4 : D == 2 || floats || with_chance(0.5) ? 1e8 : 1e12);
    Point<D> by = in_ground<D>(2);
    by[D - 1] = with_chance(0.4) ? -between(0, 2) : magnitude(1e-6, 4);
    move<D>(out.y, by);
    turn_contact<D>(out, floats, y_contact != 0);
    return out;
  }

  [[nodiscard]] Pair<double, 3> grain() {
    Pair<double, 3> out{solid(among(3, 8)), solid(among(1, 8))};
    scale<3>(out.y, magnitude(1e-12, 1e-6));
    move<3>(out.y, in_box<3>(0.6));
    return out;
  }

  template <int D>
  [[nodiscard]] Pair<double, D> offset(bool floats) {
    Pair<double, D> out = apart_or_not<D>({among(1, 8), among(1, 8)});
    const double away = magnitude(1e3, floats ? 1e6 : 1e12);
    move<D>(out, Point<D>(direction<D>() * away));
    return out;
  }

  template <int D>
  [[nodiscard]] Pair<double, D> denormals(double smallest) {
    const int size = 1 << among(0, 16);
    Pair<double, D> out{grid_points<double, D>(among(1, 6), size),
                        grid_points<double, D>(among(1, 6), size)};
    Point<D> by = Point<D>::Zero();
    by[0] = among(0, 2 * size);
    move<D>(out.y, by);
    scale<D>(out, smallest);
    return out;
  }

  template <int D>
  [[nodiscard]] Pair<double, D> make(Family family, bool floats) {
    const double grid_step = floats ? 0x1p-12 : 0x1p-40;
    const int y_contact = contact<D>(0.5);
    switch (family) {
      case Family::random:
        return apart_or_not<D>({among(D + 1, 8), among(D + 1, 8)});
      case Family::points:
        return {shape<D>(among(1, D)),
                shape_at<D>({with_chance(0.5) ? among(1, D) : among(D + 1, 8),
                             in_box<D>(D == 2 ? 1.5 : 0.8)})};
      case Family::clouds:
        return clouds<D>();
      case Family::duplicates:
        return duplicates<D>();
      case Family::grid:
        return grid<D>();
      case Family::identical:
        return identical<D>();
      case Family::inside:
        return inside<D>();
      case Family::posed:
        return posed<D>(floats);
      case Family::needle_polygon:
        return thin_and_not<D>(needle<D>);
      case Family::parallel:
        return parallel<D>(floats);
      case Family::gap:
        return moved_by<D>({1e-12, 1e-3, 1, floats}, y_contact, grid_step);
      case Family::speck:
        return moved_by<D>({floats ? 1e-30 : 1e-100, 1e-12, 1, true}, y_contact, grid_step);
      case Family::shallow:
        return moved_by<D>({1e-6, 1e-3, -1, floats}, y_contact, grid_step);
      case Family::touching:
        return touching<D>(y_contact, grid_step);
      case Family::grazing:
        return grazing<D>(y_contact);
      case Family::tiny:
        return tiny<D>(floats);
      case Family::huge:
        return huge<D>(floats);
      case Family::ratio:
        return ratio<D>(floats, y_contact);
      case Family::offset:
        return offset<D>(floats);
      case Family::denormals:
        return denormals<D>(floats ? double{std::numeric_limits<float>::denorm_min()}
                                   : std::numeric_limits<double>::denorm_min());
      default:
        return make_of<D>(family, floats);
    }
  }

  /// Makes pairs of the families that the plane and space have their own ways to make.
  template <int D>
  [[nodiscard]] Pair<double, D> make_of(Family family, bool floats) {
    if constexpr (D == 2) {
      return family == Family::collinear ? collinear() : needles();
    } else {
      switch (family) {
        case Family::collinear:
          return coplanar();
        case Family::needle:
          return thin(needle<3>);
        case Family::flat:
          return with_chance(0.5) ? thin(plate) : thin_and_not<3>(plate);
        case Family::sliver:
          return with_chance(0.5) ? thin(sliver) : thin_and_not<3>(sliver);
        case Family::grain:
          return grain();
        default:
          return nearly_touching(contact<3>(0), floats ? 0x1p-12 : 0x1p-40, floats);
      }
    }
  }

  std::mt19937_64 bits_;
};

}  // namespace families
