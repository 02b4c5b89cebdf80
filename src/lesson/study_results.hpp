#pragma once
// What `gjkscope study accuracy` has found out, as far as lessons show it: how fast and how
// accurate each way to answer the pairs of a family is, and the pair that it answers worst.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gjkscope {

/// A way to answer on a family of pairs. No number: to some pair it gave no answer.
struct StudyDot {
  std::string family;
  std::string configuration;  ///< "float, loop only"
  std::string axis;           ///< What the configuration varies: "arithmetic", "cap", ...
  int pairs = 0;
  int wrong = 0;                ///< Pairs of which it says wrongly whether they overlap,
  int undecided = 0;            ///< or leaves it open.
  bool on_front = false;        ///< No other one of the family is as fast and as accurate.
  double ns = 0.0;              ///< Per query, the median.
  double ratio = 0.0;           ///< Of that to the default configuration's.
  std::optional<double> error;  ///< Of the distance, the largest, as a share of the pair's scale.
  // The pair with that error.
  std::vector<Eigen::Vector2d> x;
  std::vector<Eigen::Vector2d> y;
  std::optional<double> answer;  ///< The distance that it gave.
  double distance = 0.0;         ///< The exact one, rounded.
  friend bool operator==(const StudyDot&, const StudyDot&) = default;
};

/// The timed rows of accuracy.json, in the order of the file. Throws std::runtime_error that says
/// what is wrong with which row.
[[nodiscard]] std::vector<StudyDot> parse_study_results(std::string_view json);

/// Those of one family.
[[nodiscard]] std::vector<StudyDot> of_family(const std::vector<StudyDot>& dots,
                                              std::string_view family);

/// Those of them that nothing else beats in time and error together, from fast to accurate.
[[nodiscard]] std::vector<StudyDot> front_of(const std::vector<StudyDot>& dots);

/// "1.2e-16", "0", "none" (infinite), "" (no number).
[[nodiscard]] std::string error_text(double error);
/// "86 ns", "1.23 µs", "34.5 ms", "2.1 s".
[[nodiscard]] std::string time_text(double ns);

/// Names of the families, in the order of their first dots.
[[nodiscard]] std::vector<std::string> families_in(const std::vector<StudyDot>& dots);

}  // namespace gjkscope
