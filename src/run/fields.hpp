#pragma once
// The parts that traces are written with, whatever the algorithm: numbers, points, vertices and
// scans as JSON, and lines of text.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "run/run.hpp"

namespace gjkscope::fields {

using Json = nlohmann::ordered_json;

/// Shortest decimal and hexadecimal float. JSON has no NaN or infinity: null, and the name in hex.
[[nodiscard]] Json number(double value);
/// A vector of any size.
using Vector = Eigen::Ref<const Eigen::VectorXd>;
[[nodiscard]] Json point(const Vector& value);
/// Values of d · vertex, each with the vertex's name.
[[nodiscard]] Json scan(const std::vector<gjk::ScanEntry<double>>& entries,
                        const std::vector<std::string>& names);

/// A vertex of Z, with the vertices of the shapes in the world that it is the difference of.
[[nodiscard]] Json vertex(const WideVertex& value, const std::string& name,
                          const PositionedRun& run);

/// As few digits as name a value of the scalar.
[[nodiscard]] std::string number_text(ScalarKind scalar, double value);
[[nodiscard]] std::string point_text(ScalarKind scalar, const Vector& point);
/// A line of a trace: its label stands in a column of its own.
[[nodiscard]] std::string line(std::string_view label, std::string_view text);
/// The value that `number` has written.
[[nodiscard]] double double_of(const Json& number);

/// The values of a trace's JSON as text.
struct Values {
  explicit Values(const Json& document);

  [[nodiscard]] std::string number(const Json& value) const;
  [[nodiscard]] std::string point(const Json& coordinates) const;
  /// Any value: "[1, 2]", "yes", "at K, depth 1.5".
  [[nodiscard]] std::string any(const Json& value) const;
  /// "Y: K 1.5 (largest), L 0.5"
  [[nodiscard]] std::string scan(const std::string& shape, const Json& entries, int best) const;
  /// "no-progress: no (left 2, right 1)"
  [[nodiscard]] std::string stop_test(const Json& test) const;
  /// "1 to 2": `lower` and `upper` of a step or a result.
  [[nodiscard]] std::string bounds(const Json& from) const;
  [[nodiscard]] std::string verdict(const Json& result) const;

  ScalarKind scalar;
  std::string x;  ///< Names of the shapes.
  std::string y;
};

/// A trace that has no text of its own: a line for each step and each value of its result.
[[nodiscard]] std::string text(const Json& document, std::string_view name, const Json& trace);

}  // namespace gjkscope::fields
