#pragma once
// Pasted shapes: the JSON that `gjkscope solve` and `gjkscope trace` read; and all forms of
// paste.hpp, of which a text holds one case.
//
//   {"dimension": 2, "a": [[x, y], ...], "b": [[x, y], ...]}
//   {"dimension": 3, "a": [[x, y, z], ...], "b": [[x, y, z], ...]}
//
//   {"dimension": 2, "outlines_a": [[[x, y], ...], ...], "outlines_b": [[[x, y], ...], ...]}
//
// The dimension is 2 where it is left out. `a` is X, `b` is Y: point sets whose convex hulls count,
// in any order. A coordinate is a number, or a string that holds one ("0.1",
// "0x1.999999999999ap-4"); it means the nearest double. `name`, `why`, `source`,
// `expected_distance` and `expected_overlap` are optional; other keys are ignored. Outlines are
// closed, and a first point that is repeated at the end counts once;
// {"open": [[x, y], ...]} is an open chain; beside outlines, points are their hull. A text holds
// any number of cases, one after the other (one a line, for example), or in arrays.

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/lesson.hpp"
#include "lesson/problem.hpp"
#include "outlines/outline.hpp"

namespace gjkscope {

template <int D>
struct CaseIn {
  std::vector<gjk::Vec<double, D>> a;  ///< X; never empty.
  std::vector<gjk::Vec<double, D>> b;  ///< Y; never empty.
  friend bool operator==(const CaseIn&, const CaseIn&) = default;
};
using Case = CaseIn<2>;

/// General models: `outlines_a` and `outlines_b`.
struct OutlineCase {
  std::vector<models::Outline> a;
  std::vector<models::Outline> b;
};

/// A case's own words and expectations. An entry of another type than it should have is left out.
struct CaseNotes {
  std::string why;
  std::string source;
  std::optional<double> expected_distance;
  std::optional<bool> expected_overlap;
};

/// Limits of a case that becomes a lesson; by itself a case may hold anything finite.
struct CaseLimits {
  std::size_t points = std::numeric_limits<std::size_t>::max();  ///< In a shape.
  double magnitude = std::numeric_limits<double>::max();         ///< The largest coordinate.
  [[nodiscard]] static CaseLimits of_lessons();
};

/// One case of a text, as far as it could be read.
struct ReadCase {
  std::string name;  ///< Its `name`, or the file's; the second of a file has "#2" added, and so on.
  Place place;       ///< Its beginning.
  std::optional<Case> value;
  std::optional<CaseIn<3>> in_space;
  std::optional<OutlineCase> outlines;
  CaseNotes notes;
  std::vector<Problem> problems;  ///< Empty exactly when one of the three is there.
  std::string understood;         ///< "X has 4 vertices, Y 5, in the plane"; empty of JSON.
  bool has_one_shape = false;     ///< Its problem: the other one may be in a second file.
};

/// All cases of a text; `file` names it in problems. A text without any is a problem, too. A case
/// that cannot be read does not keep the others from being read. A caller that knows only the plane
/// asks for dimensions up to 2, and others are problems; a caller that takes outlines says what
/// they must be like. Points beyond `limits` are problems.
[[nodiscard]] std::vector<ReadCase> parse_cases(
    std::string_view text, std::string_view file, int most_dimension = 2,
    std::optional<models::Needs> outlines = std::nullopt, const CaseLimits& limits = {});

struct NamedText {
  std::string file;
  std::string text;
};
/// The case of two texts that hold one shape each; nothing where they do not.
[[nodiscard]] std::optional<ReadCase> paired_case(const NamedText& x, const NamedText& y,
                                                  int most_dimension,
                                                  std::optional<models::Needs> outlines);

/// One case on a line of its own, with a line break: its coordinates read back to the same bits.
/// They must be finite. An empty name is left out. D: 2 or 3.
template <int D>
[[nodiscard]] std::string case_json(const CaseIn<D>& value, std::string_view name);

/// The text of one case with other shapes: its other keys stay, but for those that tell of the
/// shapes that were there (expected_..., witness_...). Nothing where the text holds no case, more
/// than one, one of another dimension, or one in another form than JSON.
template <int D>
[[nodiscard]] std::optional<std::string> case_json_kept(std::string_view original,
                                                        const CaseIn<D>& value);

/// "x1", "x2", ...: as many as there are vertices.
[[nodiscard]] std::vector<std::string> numbered_names(char letter, std::size_t vertices);

/// A case as a lesson without words, to run and trace it: vertices x1, x2, ... and y1, y2, ...
template <int D>
[[nodiscard]] Lesson lesson_of(const CaseIn<D>& value, std::string_view name, ScalarKind scalar);
[[nodiscard]] inline Lesson lesson_of(const Case& value, std::string_view name, ScalarKind scalar) {
  return lesson_of<2>(value, name, scalar);
}
/// The same of outlines, which must be closed.
[[nodiscard]] Lesson lesson_of(const OutlineCase& value, std::string_view name);

}  // namespace gjkscope
