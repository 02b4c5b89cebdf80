#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>
#include <type_traits>

#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "depth/depth.hpp"
#include "geometry/rational.hpp"
#include "lesson/case.hpp"
#include "lesson/names.hpp"
#include "lesson/scalar.hpp"

namespace gjkscope {
namespace {

using Json = nlohmann::ordered_json;
using Eigen::Vector2d;

template <class S>
using Points = std::vector<gjk::Vec<S, 2>>;

template <class S>
Points<S> converted(const std::vector<Vector2d>& points) {
  Points<S> out;
  for (const Vector2d& point : points) {
    out.push_back(gjk::Vec<S, 2>(static_cast<S>(point[0]), static_cast<S>(point[1])));
  }
  return out;
}

template <class S>
double widened(const S& value) {
  if constexpr (std::is_same_v<S, Rational>) {
    return to_double(value);
  } else {
    return static_cast<double>(value);
  }
}

template <class S>
Json json_of(const gjk::Vec<S, 2>& point) {
  return Json::array({widened<S>(point[0]), widened<S>(point[1])});
}

/// Whether the shapes share a point. Where the run left it undecided, exact arithmetic on the same
/// coordinates decides.
template <class S>
bool overlap(const gjk::Result<S, 2>& result, const Points<S>& x, const Points<S>& y) {
  if (result.verdict != gjk::Verdict::undecided) return result.verdict != gjk::Verdict::separated;
  const auto exact = [](const Points<S>& points) {
    Points<Rational> out;
    for (const gjk::Vec<S, 2>& point : points) {
      out.emplace_back(Rational(widened<S>(point[0])), Rational(widened<S>(point[1])));
    }
    return out;
  };
  const Points<Rational> exact_x = exact(x);
  const Points<Rational> exact_y = exact(y);
  return gjk::distance(gjk::Query<Rational, 2>{{exact_x}, {exact_y}}).distance_sq == 0;
}

/// How deep shapes that overlap lie in each other. A number that exceeds the largest becomes null.
template <class S>
void add_depth(Json& answer, const Points<S>& x, const Points<S>& y) {
  const auto result = depth::penetration<S>(gjk::Query<S, 2>{{x}, {y}});
  answer["depth"] = widened(result.depth);
  answer["depth_lower"] = widened(result.lower);
  answer["depth_upper"] = widened(result.upper);
  answer["direction"] = json_of(result.direction);
  answer["translation"] = json_of<S>(result.translation);
}

std::string_view explained(gjk::Error error) {
  switch (error) {
    case gjk::Error::overflow:
      return "the distance exceeds the largest number";
    case gjk::Error::underflow:
      return "the coordinates are too small for the scalar";
    case gjk::Error::x_not_finite:
      return "a coordinate of 'a' exceeds the range of the scalar";
    case gjk::Error::y_not_finite:
      return "a coordinate of 'b' exceeds the range of the scalar";
    default:
      return "the query is refused";
  }
}

template <class S>
Json solve(const Case& value, Json answer) {
  const Points<S> x = converted<S>(value.a);
  const Points<S> y = converted<S>(value.b);
  const gjk::Result<S, 2> result = gjk::distance<S>(gjk::Query<S, 2>{{x}, {y}});
  gjk::Error error = result.error;
  // An exact run knows no largest number, its answer does; and a bound may lie above the distance.
  if (error == gjk::Error::none && !std::isfinite(widened(result.upper)))
    error = gjk::Error::overflow;
  if (error != gjk::Error::none) {
    answer["error"] = fmt::format("{}: {}", name_of(error), explained(error));
    return answer;
  }
  answer["distance"] = widened(result.distance);
  answer["lower"] = widened(result.lower);
  answer["upper"] = widened(result.upper);
  if constexpr (std::is_same_v<S, Rational>) {
    answer["distance_squared"] = to_string(result.distance_sq);
  }
  const bool overlaps = overlap(result, x, y);
  answer["overlap"] = overlaps;
  answer["verdict"] = name_of(result.verdict);
  answer["settled"] = result.settled;
  answer["a"] = json_of<S>(result.x);
  answer["b"] = json_of<S>(result.y);
  answer["iterations"] = result.iterations;
  answer["stop"] = name_of(result.stop);
  if (overlaps) add_depth(answer, x, y);
  return answer;
}

Json solve(const ReadCase& read, ScalarKind scalar) {
  Json answer;
  answer["case"] = read.name;
  answer["scalar"] = name_of(scalar);
  if (!read.value) {
    answer["error"] = to_string(read.problems.front());
    return answer;
  }
  return with_scalar(scalar, [&]<class S>(std::type_identity<S>) {
    return solve<S>(*read.value, std::move(answer));
  });
}

}  // namespace

int solve_command(const Environment& env, const std::vector<std::string>& files,
                  ScalarKind scalar) {
  int exit_code = kDone;
  for (const std::string& file : files) {
    const std::optional<std::string> text = read_text(env, file);
    if (!text) {
      exit_code = kCannot;
      continue;
    }
    const std::string name = file == "-" ? "<stdin>" : file;
    for (const ReadCase& read : parse_cases(*text, name)) {
      for (const Problem& problem : read.problems) env.err << to_string(problem) << '\n';
      const Json answer = solve(read, scalar);
      if (read.value && answer.contains("error")) {
        env.err << fmt::format("{}: {}\n", read.name, answer["error"].get<std::string>());
      }
      if (answer.contains("error") && exit_code == kDone) exit_code = kProblem;
      // Names may hold bytes that are not UTF-8.
      env.out << answer.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
    }
  }
  return flushed(env) ? exit_code : kCannot;
}

}  // namespace gjkscope
