#pragma once
// How numbers, points and simplices are written, in captions and panels alike.

#include <string>
#include <string_view>
#include <vector>

#include "run/run.hpp"

namespace gjkscope {

/// "−0.331", with a true minus sign; zero has no sign.
[[nodiscard]] std::string fixed(double value, int decimals);
/// The same, positive numbers with a plus sign.
[[nodiscard]] std::string signed_fixed(double value, int decimals);

/// With so many significant digits, trailing zeros dropped; in scientific notation where that is
/// shorter.
[[nodiscard]] std::string significant(double value, int digits);

/// Whether numbers as they are written add up to one as it is written.
[[nodiscard]] bool adds_up(const std::vector<std::string>& terms, const std::string& sum);
/// "3.612 − 0.478 = 3.135 up to rounding": the last words only where it is so.
[[nodiscard]] std::string difference_as_written(const std::string& from, const std::string& minus,
                                                const std::string& difference);

/// "2.0·10⁻⁷", with so many significant digits; "0.36" where no power is needed.
[[nodiscard]] std::string power_text(double value, int digits);
/// "⁻¹²"
[[nodiscard]] std::string raised(int exponent);

/// "1,203": the whole number next to a value, its digits in groups of three.
[[nodiscard]] std::string grouped(double value);

/// "B, C and D"; of many "B, C, D, E and 96 more".
[[nodiscard]] std::string and_list(std::vector<std::string> names);
/// "B  ·  C  ·  D": to choose from.
[[nodiscard]] std::string listed_choices(const std::vector<std::string>& choices);

/// With a capital letter first, of ASCII.
[[nodiscard]] std::string capitalized(std::string text);

/// Numbers of one lesson: three decimals in double and exact lessons, all digits that tell values
/// apart in half (5) and float (9, trailing zeros dropped) ones. Very large and very small numbers
/// in scientific notation.
class Numbers {
 public:
  explicit Numbers(const Lesson& lesson) : scalar_(lesson.scalar), dimension_(lesson.dimension) {}
  [[nodiscard]] std::string operator()(double value) const;
  /// "(0.50, −1.25)", in space with three coordinates; where all of these digits would be zeros, or
  /// the numbers are large, with a power of ten: "(0.00, 1.00)·10⁻⁴".
  template <class V>
  [[nodiscard]] std::string point(const Eigen::MatrixBase<V>& value, int decimals = 2) const {
    return point_text(in_space(value.eval()), decimals);
  }
  /// A barycentric weight: three decimals where the scalar is not the point.
  [[nodiscard]] std::string weight(double value) const;

 private:
  [[nodiscard]] std::string point_text(const Eigen::Vector3d& value, int decimals) const;

  ScalarKind scalar_;
  int dimension_;
};

/// How one simplex of a run is called.
class SimplexWords {
 public:
  SimplexWords(const LessonRun& run, const WideSimplex& simplex);

  [[nodiscard]] std::string vertex(int i) const;
  /// The vertices of a face in the order of its name: a triangle's third edge is CA, not AC, and an
  /// edge that a run starts with has its direction.
  [[nodiscard]] std::vector<int> order(gjk::Face face) const;
  /// "CE", or "N−C, L−D" where vertices are pairs.
  [[nodiscard]] std::string face(gjk::Face face) const;
  /// "vertex E", "segment CE", "triangle CDE"; for pairs "segment from K−C to L−D". A side of a
  /// triangle is an edge.
  [[nodiscard]] std::string kind_and_face(gjk::Face face) const;
  /// "u", "vAB", "wABC": the slides' name of a vertex's barycentric coordinate in a face; for pairs
  /// "weight of K−C".
  [[nodiscard]] std::string coordinate(gjk::Face face, int vertex) const;
  /// The terms of a region test in the order in which the slides write them: edges AB, BC, CA, and
  /// u, v, w within each.
  [[nodiscard]] std::vector<gjk::RegionTerm<double>> terms(
      const gjk::RegionTest<double>& test) const;
  /// "0.312 B + 0.688 C"
  [[nodiscard]] std::string combination(gjk::Face face, const Numbers& numbers) const;

 private:
  const LessonRun& run_;
  const WideSimplex& simplex_;
  bool cyclic_ = false;
};

/// The vertices of X or of Y that a simplex of pairs is made of: "vertex K", "edge CD", "triangle
/// KLM".
[[nodiscard]] std::string feature_name(const LessonRun& run, const WideSimplex& simplex, bool of_x);

/// The test that ends a run in a stop step: "V in S", "P no closer"; "no" where none does.
[[nodiscard]] std::string stop_test(const LessonRun& run, const Frame& frame);
/// All there are in lessons.
[[nodiscard]] std::vector<std::string> stop_tests(const LessonRun& run);

/// The query point: "Q", or "O" between polygons.
[[nodiscard]] std::string query_name(const LessonRun& run);

}  // namespace gjkscope
