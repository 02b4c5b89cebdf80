#pragma once
// What is asked: two convex shapes, where they stand, and how the run shall decide.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <type_traits>

#include "gjk/error_free.hpp"
#include "gjk/linear.hpp"

namespace gjk {

namespace detail {
/// At most half of its digits are used by each coordinate: products of two such numbers are exact.
template <class S, int D>
[[nodiscard]] bool has_few_digits(const Vec<S, D>& a) {
  Vec<S, D> rest;
  for (int i = 0; i < D; ++i) rest[i] = halves(S(a[i])).lo;
  return is_zero(rest);
}
}  // namespace detail

/// How a shape is turned: any matrix. One that rounding, or intent, left short of orthonormal
/// stretches the shape, and the answer is that of the stretched shape. Measured once, when it is
/// set, so that queries need not look at it again.
template <class S, int D>
class Rotation {
 public:
  using Matrix = Eigen::Matrix<S, D, D>;
  /// What sizes are measured in.
  using Size = RunScalar<Default, S>;

  Rotation() = default;
  /// From a matrix, or an expression of Eigen's that makes one.
  template <class Derived>
  // NOLINTNEXTLINE(google-explicit-constructor): a matrix stands for what it does.
  Rotation(const Eigen::MatrixBase<Derived>& matrix) : matrix_(matrix) {
    for (int i = 0; i < D; ++i) {
      const bool is_unit = is_zero(Vec<S, D>(col(i) - Matrix::Identity().col(i)));
      turns_ = turns_ || !is_unit;
    }
    if constexpr (!ScalarTraits<S>::kExact) {
      if (turns_) measure();
    }
  }

  [[nodiscard]] const Matrix& matrix() const { return matrix_; }
  [[nodiscard]] const S& operator()(int row, int column) const { return matrix_(row, column); }
  [[nodiscard]] auto col(int i) const { return matrix_.col(i); }

  /// It is not the identity.
  [[nodiscard]] bool turns() const { return turns_; }
  /// How much longer than a vector its image can be: 1 for a rotation; a NaN or an infinity where
  /// an entry is one. Not of exact scalars.
  [[nodiscard]] const Size& stretch() const { return stretch_; }
  /// Products with coordinates of few digits are exact.
  [[nodiscard]] bool has_few_digits() const { return few_digits_; }

 private:
  void measure() {
    for (int i = 0; i < D; ++i) few_digits_ = few_digits_ && detail::has_few_digits<S, D>(col(i));
    const auto column = [&](int i) -> Vec<Size, D> {
      return converted<Size, S, D>(Vec<S, D>(col(i)));
    };
    Size longest_sq(1);
    Size skewed(0);
    for (int i = 0; i < D; ++i) {
      longest_sq = larger(longest_sq, dot(column(i), column(i)));  // a NaN comes through `skewed`
      for (int k = 0; k < i; ++k) skewed = skewed + magnitude(dot(column(i), column(k)));
    }
    stretch_ = (Size(1) + longest_sq + skewed) / Size(2);  // at least the root
  }

  Matrix matrix_ = Matrix::Identity();
  Size stretch_ = Size(1);
  bool turns_ = false;
  bool few_digits_ = true;
};

/// Where a shape stands: world = rotation * local + translation.
template <class S, int D>
struct Pose {
  Rotation<S, D> rotation;
  Vec<S, D> translation = Vec<S, D>::Zero();

  /// rotation * local, computed in R.
  template <class R = S>
  [[nodiscard]] Vec<R, D> rotated(const Vec<R, D>& local) const {
    if (!rotation.turns()) return local;
    Vec<R, D> world;
    for (int row = 0; row < D; ++row) {
      world[row] = ScalarTraits<R>::from(rotation(row, 0)) * local[0];
      for (int k = 1; k < D; ++k) {
        world[row] = world[row] + R(ScalarTraits<R>::from(rotation(row, k)) * local[k]);
      }
    }
    return world;
  }
  /// rotation^T * world: what a direction looks like to the shape.
  template <class R = S>
  [[nodiscard]] Vec<R, D> direction_to_local(const Vec<R, D>& world) const {
    if (!rotation.turns()) return world;
    Vec<R, D> local;
    for (int column = 0; column < D; ++column) {
      local[column] = ScalarTraits<R>::from(rotation(0, column)) * world[0];
      for (int k = 1; k < D; ++k) {
        local[column] = local[column] + R(ScalarTraits<R>::from(rotation(k, column)) * world[k]);
      }
    }
    return local;
  }
};

/// A few points of the plane, coordinate by coordinate and the last one repeated: for scans that
/// look at several at a time.
struct Rows {
  static constexpr int kCount = 8;
  alignas(16) double x[kCount];
  alignas(16) double y[kCount];
};

/// Some points, borrowed, and what a query needs to know of them all: measured once, when the range
/// is wrapped, so that queries with the same shape at other poses do not look at every vertex
/// again.
template <class S, int D>
class Points {
 public:
  Points() = default;
  // NOLINTBEGIN(google-explicit-constructor): a list of points stands for its hull.
  /// From anything that a span can view: std::vector, std::array, std::span. Not from a temporary.
  template <class Range>
  requires(!std::is_same_v<Range, Points> &&
           std::is_convertible_v<const Range&, std::span<const Vec<S, D>>>)
      Points(const Range& points)
      : points_(points) {
    note(kMoreThanFour, size() > 4);
    note(kLarge, size() > Rows::kCount);
    if constexpr (!ScalarTraits<S>::kExact) measure();
    note(kUnusable, empty() || !finite_);
    if constexpr (!ScalarTraits<S>::kExact) {
      note(kRing, D == 2 && size() >= kRingFrom && is_strictly_convex_ring());
    }
  }
  // NOLINTEND(google-explicit-constructor)

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] bool empty() const { return points_.empty(); }
  [[nodiscard]] const Vec<S, D>& operator[](std::size_t i) const { return points_[i]; }
  [[nodiscard]] auto begin() const { return points_.begin(); }
  [[nodiscard]] auto end() const { return points_.end(); }

  /// No coordinate is a NaN or an infinity.
  [[nodiscard]] bool is_finite() const { return finite_; }
  /// Corners of the bounding box.
  [[nodiscard]] const Vec<S, D>& low() const { return low_; }
  [[nodiscard]] const Vec<S, D>& high() const { return high_; }
  /// The point that the points are measured from: their own origin, or the middle when they lie
  /// around neither, so that rounding follows their size and not their place.
  [[nodiscard]] const Vec<S, D>& centre() const { return centre_; }
  /// It is not their own origin.
  [[nodiscard]] bool is_centred() const { return has(kCentred); }
  /// Distance from `centre` to the farthest point, up to a rounding or two; no denormal is too
  /// small.
  [[nodiscard]] const S& radius() const { return radius_; }
  /// Distance from `centre` to the mean of the points, which lies in their hull; as exact.
  [[nodiscard]] const S& to_mean() const { return to_mean_; }
  /// Indices of two points that lie far apart: at least as far as the longest side of the box.
  [[nodiscard]] const std::array<int, 2>& far_apart() const { return far_apart_; }
  /// The points are the corners of a convex polygon, in order, none on the line through its
  /// neighbours. Looked for in the plane, from kRingFrom points on.
  [[nodiscard]] bool is_ring() const { return has(kRing); }

  static constexpr std::size_t kRingFrom = 32;

  /// So few that scans turn all of them into the world, rather than a direction into their frame.
  [[nodiscard]] bool is_small() const { return !has(kLarge); }
  /// Of a small shape in the plane whose runs are in double: the points, seen from their centre.
  [[nodiscard]] const Rows& rows() const { return rows_; }

  /// What a query has to know before it begins, as bits, so that those of two shapes can be asked
  /// at once.
  static constexpr std::uint8_t kUnusable = 1;  ///< No points, or not all of them finite.
  static constexpr std::uint8_t kCentred = 2;
  static constexpr std::uint8_t kMoreThanFour = 4;
  static constexpr std::uint8_t kLarge = 8;  ///< Not small.
  static constexpr std::uint8_t kRing = 16;
  static constexpr std::uint8_t kManyDigits = 32;  ///< Products with a rotation round.
  [[nodiscard]] unsigned traits() const { return traits_; }

 private:
  [[nodiscard]] bool has(unsigned trait) const { return (traits_ & trait) != 0; }
  void note(unsigned trait, bool holds) {
    traits_ = static_cast<std::uint8_t>(holds ? traits_ | trait : traits_ & ~trait);
  }

  void measure() {
    if (points_.empty()) return;
    low_ = points_[0];
    high_ = points_[0];
    bool few_digits = true;
    for (const Vec<S, D>& point : points_) {
      finite_ = finite_ && gjk::is_finite(point);
      few_digits = few_digits && detail::has_few_digits(point);
      low_ = low_.cwiseMin(point);
      high_ = high_.cwiseMax(point);
    }
    note(kManyDigits, !few_digits);
    int longest = 0;
    (high_ / S(2) - low_ / S(2)).maxCoeff(&longest);
    for (int i = 0; i < static_cast<int>(points_.size()); ++i) {
      if (points_[i][longest] == low_[longest]) far_apart_[0] = i;
      if (points_[i][longest] == high_[longest]) far_apart_[1] = i;
    }
    const Vec<S, D> middle = low_ / S(2) + high_ / S(2);
    note(kCentred, norm_max(Vec<S, D>(high_ - middle)) < norm_max(middle));
    if (is_centred()) centre_ = middle;
    if constexpr (D == 2 && std::is_same_v<RunScalar<Default, S>, double>) fill_rows();
    const S size =
        std::max(norm_max(Vec<S, D>(high_ - centre_)), norm_max(Vec<S, D>(low_ - centre_)));
    if (!finite_ || !(S(0) < size) || !ScalarTraits<S>::is_finite(size)) return;
    // In a unit of length in which no square overflows, and none that matters underflows.
    const int exponent = ScalarTraits<S>::exponent(size);
    S radius_sq(0);
    Vec<S, D> sum = Vec<S, D>::Zero();
    for (const Vec<S, D>& point : points_) {
      const Vec<S, D> scaled = from_centre(point, exponent);
      radius_sq = std::max(radius_sq, dot(scaled, scaled));
      sum = sum + scaled;
    }
    const auto length = [&](const S& scaled) {
      const S out = ScalarTraits<S>::scaled(scaled, exponent);
      const bool below = ScalarTraits<S>::scaled(out, -exponent) < scaled;
      return below ? S(out + std::numeric_limits<S>::denorm_min()) : out;
    };
    radius_ = length(ScalarTraits<S>::root(radius_sq));
    to_mean_ = length(ScalarTraits<S>::root(dot(sum, sum)) / static_cast<S>(points_.size()));
  }

  [[nodiscard]] Vec<S, D> from_centre(const Vec<S, D>& point, int exponent) const {
    Vec<S, D> out;
    for (int i = 0; i < D; ++i) {
      out[i] = ScalarTraits<S>::scaled(S(point[i] - centre_[i]), -exponent);
    }
    return out;
  }

  void fill_rows() {
    const auto placed = [&](const Vec<S, D>& point, int axis) {
      return static_cast<double>(point[axis]) - static_cast<double>(centre_[axis]);
    };
    for (std::size_t i = 0; is_small() && i < Rows::kCount; ++i) {
      const Vec<S, D>& point = points_[std::min(i, size() - 1)];
      rows_.x[i] = placed(point, 0);
      rows_.y[i] = placed(point, 1);
    }
  }

  /// All turns go the same way beyond rounding, and the edges go round once.
  [[nodiscard, gnu::noinline]] bool is_strictly_convex_ring() const {
    const std::size_t count = points_.size();
    int turns = 0;
    int crossings = 0;
    Vec<S, D> before = points_[0] - points_[count - 1];
    for (std::size_t i = 0; i < count; ++i) {
      const Vec<S, D> edge = points_[i + 1 == count ? 0 : i + 1] - points_[i];
      const S left = before[0] * edge[1];
      const S right = before[1] * edge[0];
      const S rounding =
          S(8) * ScalarTraits<S>::unit_roundoff() * (magnitude(left) + magnitude(right));
      if (!(rounding < magnitude(S(left - right))) || !(S(0) < rounding)) return false;
      turns += right < left ? 1 : -1;
      crossings += upwards(before) != upwards(edge) ? 1 : 0;
      before = edge;
    }
    return crossings == 2 &&
           (turns == static_cast<int>(count) || -turns == static_cast<int>(count));
  }
  static bool upwards(const Vec<S, D>& edge) {
    return S(0) < edge[1] || (edge[1] == S(0) && S(0) < edge[0]);
  }

  std::span<const Vec<S, D>> points_;
  Rows rows_ = {};
  Vec<S, D> low_ = Vec<S, D>::Zero();
  Vec<S, D> high_ = Vec<S, D>::Zero();
  Vec<S, D> centre_ = Vec<S, D>::Zero();
  S radius_ = S(0);
  S to_mean_ = S(0);
  std::array<int, 2> far_apart_ = {};
  bool finite_ = true;
  std::uint8_t traits_ = kUnusable;
};

/// The convex hull of some points: a point, a segment, a polygon, a point set. Order and repetition
/// of vertices do not matter.
template <class S, int D>
struct Shape {
  Points<S, D> vertices;
  Pose<S, D> pose = {};
};

/// GJK computes distance(X, Y) as the distance of the origin O from the Minkowski difference Z = Y
/// - X. A point query "Q against a polygon" has X = {Q}: then Z is the polygon seen from Q, and O
/// stands where Q does.
template <class S, int D>
struct Query {
  Shape<S, D> x;
  Shape<S, D> y;
};

/// How the search direction is built from the simplex and its closest point P.
enum class DirectionRule : std::uint8_t {
  perpendicular,   ///< Normal of the simplex, flipped towards O; P is not used (Catto 2010, "An
                   ///< accurate search direction").
  towards_origin,  ///< d = O - P, with the round-off of P (Catto 2010, "A bad direction").
};

/// The order in which Voronoi regions are tested; the first region whose test holds is taken. Where
/// rounding leaves no region whose test holds, or makes O lie in a simplex whose weights put P
/// elsewhere, the region with the nearest point is taken.
enum class RegionOrder : std::uint8_t {
  vertices_first,  ///< Vertices, edges, ..., interior: the slides' order.
  edges_first,     ///< Edges before vertices. Exact arithmetic cannot tell the difference; rounding
                   ///< can.
  unchecked,       ///< Vertices first, and every test is believed: the last region is what is left
                   ///< over, as on the slides.
};

/// Indices of the vertices of X and Y whose difference is a vertex of the simplex.
struct VertexPair {
  int x = 0;
  int y = 0;
  friend constexpr bool operator==(const VertexPair& a, const VertexPair& b) {
    return ((a.x ^ b.x) | (a.y ^ b.y)) == 0;  // one branch, where the defaulted one has two
  }
};

inline constexpr int kMaxDimension = 3;

/// A simplex to begin with: what `Result::warm` of one query hands to `Options::start` of the next.
struct WarmStart {
  std::array<VertexPair, kMaxDimension + 1> pairs = {};
  int count = 0;  ///< The first so many of `pairs`, 0 to D+1.
  friend bool operator==(const WarmStart& a, const WarmStart& b) {
    return std::equal(a.pairs.begin(), a.pairs.begin() + a.count, b.pairs.begin(),
                      b.pairs.begin() + b.count);
  }
};

/// How far an answer is checked.
enum class Proof : std::uint8_t {
  none,    ///< Not at all: |P| and the weighted vertices, as the loop left them (the textbook).
  bounds,  ///< Bounds that include rounding; close distances are computed anew.
  exact,   ///< Exact arithmetic runs on where the bounds are wide or leave the verdict open.
};

/// Iterations after which the run gives up and says so. GJK in the plane needs 3 to 6 on average
/// for any number of vertices (Larsen 1998, "GJK - Running Time"); tests/gjk/distance_test.cpp
/// asserts that random pairs stay far below.
inline constexpr int kDefaultIterationCap = 64;

/// How a run decides. All of it is data, so that a lesson can show what goes wrong with another
/// choice.
struct Options {
  DirectionRule direction_rule = DirectionRule::perpendicular;
  RegionOrder region_order = RegionOrder::vertices_first;

  /// Stop when the support point is already a vertex of the simplex (Catto 2010, termination case
  /// 1).
  bool stop_on_repeated_support = true;
  /// Stop when the support point lies no farther along d than the simplex does, or when P comes no
  /// nearer to O.
  bool stop_on_no_progress = true;
  /// Stop when lower >= (1 - tolerance) * upper; relative, 0 switches it off.
  double tolerance = 0.0;
  int iteration_cap = kDefaultIterationCap;

  Proof proof = Proof::exact;

  /// The first simplex. Empty, the run starts from the support point along the line between the
  /// centres of the two shapes, which saves an iteration or two.
  WarmStart start = {};
};

/// Why a query was refused. Each names the first thing found wrong.
enum class Error : std::uint8_t {
  none,
  x_has_no_vertices,
  y_has_no_vertices,
  x_not_finite,  ///< A vertex or the pose of X holds a NaN or an infinity.
  y_not_finite,
  overflow,     ///< The distance, a witness point, or a pose's entries exceed the scalar's range.
  underflow,    ///< Coordinates so small that no unit of length saves their products: Eigen::half.
  bad_start,    ///< A start pair names no vertex, or their count is not 0 to D+1.
  bad_options,  ///< The iteration cap is below 1, or the tolerance is not in [0, 1).
};

}  // namespace gjk
