#pragma once
// Convex shapes, and where they stand in the world.

#include <ranges>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "gjk/proof/measures.hpp"
#include "gjk/vector.hpp"

namespace gjk {

/// How a shape is turned: any matrix. A matrix that is not orthonormal stretches the shape, and
/// answers are for the stretched shape. It is measured when it is set, so that queries need not.
template <class S, int D>
class Rotation {
 public:
  using Matrix = Eigen::Matrix<S, D, D>;
  using Size = RunScalar<Default, S>;

  Rotation() = default;
  /// From a matrix, or an Eigen expression of one.
  template <class Derived>
  // NOLINTNEXTLINE(google-explicit-constructor): every matrix is a Rotation.
  Rotation(const Eigen::MatrixBase<Derived>& matrix) : matrix_(matrix) {
    turns_ = matrix_ != Matrix::Identity();
    if constexpr (!ScalarTraits<S>::kExact) {
      if (!turns_) return;
      const auto product = [&](int i, int k) {
        return dot<Size, D>(converted<Size, S, D>(col(i)), converted<Size, S, D>(col(k)));
      };
      Size longest_sq(1);
      Size skewed(0);
      for (int i = 0; i < D; ++i) {
        longest_sq = larger(longest_sq, product(i, i));  // `skewed` carries any NaN
        for (int k = 0; k < i; ++k) skewed = skewed + magnitude(product(i, k));
      }
      stretch_ = (Size(1) + longest_sq + skewed) / Size(2);  // >= sqrt(longest_sq + skewed)
    }
  }

  [[nodiscard]] const Matrix& matrix() const { return matrix_; }
  [[nodiscard]] const S& operator()(int row, int column) const { return matrix_(row, column); }
  [[nodiscard]] auto col(int i) const { return matrix_.col(i); }

  /// True when the matrix is not the identity.
  [[nodiscard]] bool turns() const { return turns_; }
  /// A bound of |image| / |vector|: about 1 for a rotation, NaN or infinite when an entry is. Not
  /// measured for exact scalars.
  [[nodiscard]] const Size& stretch() const { return stretch_; }

 private:
  Matrix matrix_ = Matrix::Identity();
  Size stretch_ = Size(1);
  bool turns_ = false;
};

/// The place of a shape: world = rotation * local + translation.
template <class S, int D>
struct Pose {
  Rotation<S, D> rotation;
  Vec<S, D> translation = Vec<S, D>::Zero();

  /// rotation * local, computed in R.
  template <class R = S>
  [[nodiscard]] Vec<R, D> rotated(const Vec<R, D>& local) const {
    if (!rotation.turns()) return local;
    Vec<R, D> world;
    for (int i = 0; i < D; ++i) {
      world[i] = ScalarTraits<R>::from(rotation(i, 0)) * local[0];
      for (int k = 1; k < D; ++k)
        world[i] = world[i] + R(ScalarTraits<R>::from(rotation(i, k)) * local[k]);
    }
    return world;
  }
  /// A world direction in the shape's frame: rotation^T * world, computed in R.
  template <class R = S>
  [[nodiscard]] Vec<R, D> direction_to_local(const Vec<R, D>& world) const {
    if (!rotation.turns()) return world;
    Vec<R, D> local;
    for (int i = 0; i < D; ++i) {
      local[i] = ScalarTraits<R>::from(rotation(0, i)) * world[0];
      for (int k = 1; k < D; ++k)
        local[i] = local[i] + R(ScalarTraits<R>::from(rotation(k, i)) * world[k]);
    }
    return local;
  }
};

/// Owns points, and measures them once: for shapes that many queries ask about, in any pose.
template <class S, int D>
class MeasuredShape {
 public:
  /// Order and repetition of points do not matter.
  explicit MeasuredShape(std::vector<Vec<S, D>> points)
      : points_(std::move(points)), measures_(points_) {}

  [[nodiscard]] const std::vector<Vec<S, D>>& points() const { return points_; }
  [[nodiscard]] const Measures<S, D>& measures() const { return measures_; }

 private:
  std::vector<Vec<S, D>> points_;
  Measures<S, D> measures_;
};

/// The convex hull of some points (order and repetition do not matter), at a pose. Borrows the
/// points, so temporaries, which would be gone before the query is answered, do not compile.
template <class S, int D>
class Shape {
 public:
  Pose<S, D> pose = {};

  Shape() = default;
  // NOLINTBEGIN(google-explicit-constructor): a list of points stands for its hull.
  // NOLINTBEGIN(bugprone-forwarding-reference-overload): a Shape is no range.
  /// From anything that a span can view: std::vector, std::array, std::span. Each query measures
  /// the points anew, so they may change between queries.
  template <std::ranges::borrowed_range Range>
  requires(std::is_convertible_v<Range, std::span<const Vec<S, D>>>)
      Shape(Range&& points, const Pose<S, D>& at = {})
      : pose(at), vertices_(points) {}
  // NOLINTEND(bugprone-forwarding-reference-overload)
  Shape(const MeasuredShape<S, D>& shape, const Pose<S, D>& at = {})
      : pose(at), vertices_(shape.points()), measures_(&shape.measures()) {}
  Shape(const MeasuredShape<S, D>&& shape, const Pose<S, D>& at = {}) = delete;
  // NOLINTEND(google-explicit-constructor)

  [[nodiscard]] std::span<const Vec<S, D>> vertices() const { return vertices_; }
  /// Null when each query measures the points anew.
  [[nodiscard]] const Measures<S, D>* measures() const { return measures_; }

 private:
  std::span<const Vec<S, D>> vertices_;
  const Measures<S, D>* measures_ = nullptr;
};
template <class Range>
Shape(Range&&) -> Shape<typename std::ranges::range_value_t<Range>::Scalar,
                        std::ranges::range_value_t<Range>::RowsAtCompileTime>;

}  // namespace gjk
