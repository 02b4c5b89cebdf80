#pragma once
// Logs that any GJK can write: docs/log-format.md.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/lesson.hpp"
#include "lesson/problem.hpp"

namespace gjkscope::judging {

/// In the plane z = 0.
using Point = Eigen::Vector3d;

/// A line about an iteration; members are empty where it says nothing. Z is the difference y - x.
struct Iteration {
  int line = 0;                          ///< In the file, from 1.
  std::vector<gjk::VertexPair> simplex;  ///< Before vertices are dropped.
  std::vector<Point> points;             ///< The same as points of Z.
  std::vector<gjk::VertexPair> kept;     ///< After that.
  std::vector<Point> kept_points;
  std::vector<double> weights;  ///< For the kept vertices, or, not logged, the simplex.
  std::optional<Point> closest;
  std::optional<Point> direction;
  std::optional<gjk::VertexPair> support;
  std::optional<Point> support_point;
};

struct Answer {
  int line = 0;
  std::optional<double> distance;
  std::optional<bool> overlap;
  std::optional<Point> x;  ///< The closest points.
  std::optional<Point> y;
  std::optional<double> depth;       ///< How deep the shapes lie in each other.
  std::optional<Point> translation;  ///< Moves x until they just touch.
};

struct Log {
  int dimension = 2;
  bool a_is_x = true;  ///< The log's difference is b - a; else a - b, and x is b.
  ScalarKind scalar = ScalarKind::double_;
  double tolerance = 0;  ///< The distance may be too large by this share of it.
  std::vector<Point> x;  ///< Finite; never empty.
  std::vector<Point> y;
  std::vector<Iteration> iterations;
  std::optional<Answer> answer;
  bool cut_off = false;  ///< The last line was left out, because it does not end.

  // How findings write it.
  std::vector<std::string> x_names;  ///< Names of vertices; empty: "a0", "a1", ...
  std::vector<std::string> y_names;
  std::string x_name;  ///< The shapes' names; empty: "a" and "b".
  std::string y_name;
  int digits = 10;
};

/// A log, or problems.
struct ReadLog {
  std::optional<Log> log;
  std::vector<Problem> problems;  ///< Empty exactly when there is a log.
};

/// `file` names the log in problems.
[[nodiscard]] ReadLog read_log(std::string_view text, std::string_view file);

}  // namespace gjkscope::judging
