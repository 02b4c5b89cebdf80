#pragma once
// Results of `gjkscope study accuracy`, as far as lessons show them: how fast and how accurate each
// way to answer the pairs of a family is, and the pair that it answers worst.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gjkscope {

/// A way to answer on a family of pairs.
struct StudyDot {
  std::string family;
  std::string configuration;  ///< "float, loop only"
  std::string axis;           ///< The setting that it varies: "arithmetic", "cap", ...
  std::string proof;          ///< How far answers are proved: "none", "bounds", "exact".
  int pairs = 0;
  int wrong = 0;          ///< Pairs of which it says wrongly whether they overlap,
  int undecided = 0;      ///< or leaves it open,
  int settled = 0;        ///< or which exact arithmetic settled.
  bool on_front = false;  ///< No other one of the family is as fast and as accurate.
  double ns = 0.0;        ///< Per query, the median.
  double ratio = 0.0;     ///< Its time to the default configuration's.
  /// The largest seen: |answer - distance| as a share of the larger of the two. Nothing: to some
  /// pair it gave no answer.
  std::optional<double> error;
  // The pair with that error.
  std::vector<Eigen::Vector2d> x;
  std::vector<Eigen::Vector2d> y;
  std::optional<double> answer;  ///< The distance that it gave.
  double distance = 0.0;         ///< The exact one, rounded.
  friend bool operator==(const StudyDot&, const StudyDot&) = default;
};

struct StudyResults {
  std::string processor;       ///< The processor of the machine that measured.
  std::vector<StudyDot> dots;  ///< The timed rows of accuracy.json, in the order of the file.
  friend bool operator==(const StudyResults&, const StudyResults&) = default;
};
/// Throws std::runtime_error that says what is wrong with which row.
[[nodiscard]] StudyResults parse_study_results(std::string_view json);

/// Those of one family.
[[nodiscard]] std::vector<StudyDot> of_family(const std::vector<StudyDot>& dots,
                                              std::string_view family);

/// Those on the front, from fast to accurate.
[[nodiscard]] std::vector<StudyDot> front_of(const std::vector<StudyDot>& dots);

/// The cost of an answer: time and error are both better when smaller.
struct Cost {
  double ns = 0.0;
  double error = 0.0;
};
/// Times that differ by no more than this factor count as the same, and so do errors: the one could
/// be another on the next machine, the other with the next pair.
inline constexpr double kSameTime = 1.1;
inline constexpr double kSameError = 2.0;
/// Not one digit of an answer is right when its error is above this.
inline constexpr double kNoDigit = 0.5;
/// Marks the costs on the front: nothing takes less time and errs no more. From the fastest on,
/// each errs less than the one before, and stands for all that take the same time and err as much:
/// it is the first of these in the list, so list the plainest way first. Costs of which not one
/// digit is right have no place there.
[[nodiscard]] std::vector<bool> front_of(const std::vector<Cost>& costs);

/// "1.2e-16", "0", "none" (infinite), "" (no number).
[[nodiscard]] std::string error_text(double error);

/// Names of the families, in the order of their first dots.
[[nodiscard]] std::vector<std::string> families_in(const std::vector<StudyDot>& dots);

}  // namespace gjkscope
