#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "answers/answers.hpp"
#include "depth/instances.hpp"
#include "lesson/case.hpp"
#include "lesson/names.hpp"
#include "outlines/brute.hpp"
#include "outlines/lin_canny.hpp"
#include "outlines/pieces.hpp"
#include "outlines/search.hpp"
#include "run/scalar.hpp"
#include "run/widen.hpp"

namespace gjkscope {
namespace {

using Json = nlohmann::ordered_json;

template <class S, int D>
using Points = std::vector<gjk::Vec<S, D>>;

template <class S, int D>
Json json_of(const gjk::Vec<S, D>& point) {
  Json out = Json::array();
  for (const S& coordinate : point) out.push_back(widened(coordinate));
  return out;
}

/// How deep shapes that overlap lie in each other. A number that exceeds the largest becomes null.
template <class S, int D>
void add_depth(Json& answer, const Points<S, D>& x, const Points<S, D>& y) {
  const auto result = depth::penetration<S>(gjk::Query<S, D>{{x}, {y}});
  answer["depth"] = widened(result.depth);
  answer["depth_lower"] = widened(result.lower);
  answer["depth_upper"] = widened(result.upper);
  answer["direction"] = json_of(result.direction);
  answer["translation"] = json_of(result.translation);
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

template <class S, int D>
Json solve(const CaseIn<D>& value, Json answer) {
  const Points<S, D> x = narrowed_all<S, D>(value.a);
  const Points<S, D> y = narrowed_all<S, D>(value.b);
  const gjk::Result<S, D> result = gjk::distance<S>(gjk::Query<S, D>{{x}, {y}});
  gjk::Error error = result.error;
  // An exact run cannot overflow, but the doubles that are printed can; so can the upper bound when
  // the distance itself does not.
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
  const bool overlaps =
      result.verdict == gjk::Verdict::touching || result.verdict == gjk::Verdict::overlapping;
  answer["overlap"] = result.verdict == gjk::Verdict::undecided ? Json() : Json(overlaps);
  answer["verdict"] = name_of(result.verdict);
  answer["settled"] = result.settled;
  answer["a"] = json_of(result.x);
  answer["b"] = json_of(result.y);
  answer["iterations"] = result.iterations;
  answer["stop"] = name_of(result.stop);
  if (overlaps) add_depth<S, D>(answer, x, y);
  return answer;
}

Json json_of(const models::Feature& feature) {
  if (feature.index < 0) return nullptr;
  return {{"kind", feature.is_vertex ? "vertex" : "segment"},
          {"outline", feature.outline},
          {"index", feature.index}};
}

struct ModelsAnswer {
  models::Answer answer;
  long visits = 0;
};

ModelsAnswer answer_of(const models::SearchResult& found) { return {found.answer, found.visits}; }

ModelsAnswer answer_of(const models::Model& a, const models::Model& b, ModelMethod method) {
  switch (method) {
    case ModelMethod::brute: {
      const models::BruteAnswer found = models::brute(a, b);
      return {found.answer, found.visits};
    }
    case ModelMethod::pieces: {
      const models::PiecesAnswer found =
          models::pieces_distance(a, b, models::pieces_of(a), models::pieces_of(b));
      return {found.answer, found.visits};
    }
    case ModelMethod::boxes:
      return answer_of(models::search<models::Box>(a, b));
    case ModelMethod::circles:
      return answer_of(models::search<models::Circle>(a, b));
    case ModelMethod::lin_canny: {
      const models::WalkResult found = models::lin_canny(models::walk_query(a, b));
      return {found.answer, found.steps};
    }
  }
  return {};
}

Json solve(const OutlineCase& value, ModelMethod method, Json answer) {
  const auto [found, visits] =
      answer_of(models::model_of(value.a), models::model_of(value.b), method);
  if (!std::isfinite(found.distance)) {
    answer["error"] =
        fmt::format("{}: {}", name_of(gjk::Error::overflow), explained(gjk::Error::overflow));
    return answer;
  }
  answer["distance"] = found.distance;
  answer["overlap"] = found.overlap;
  answer["a"] = json_of<double, 2>(found.a);
  answer["b"] = json_of<double, 2>(found.b);
  answer["features"] = {{"a", json_of(found.on_a)}, {"b", json_of(found.on_b)}};
  answer["visits"] = visits;
  return answer;
}

Json solve(const ReadCase& read, const CaseOptions& options) {
  const ScalarKind scalar = options.scalar;
  Json answer;
  answer["case"] = read.name;
  if (!read.understood.empty()) answer["understood"] = read.understood;
  if (read.outlines) {
    answer["method"] = name_of(options.method);
    return solve(*read.outlines, options.method, std::move(answer));
  }
  answer["scalar"] = name_of(scalar);
  if (!read.problems.empty()) {
    answer["error"] = to_string(read.problems.front());
    return answer;
  }
  return with_scalar(scalar, [&]<class S>(std::type_identity<S>) {
    return read.value ? solve<S>(*read.value, std::move(answer))
                      : solve<S>(*read.in_space, std::move(answer));
  });
}

}  // namespace

models::Needs needs_of(ModelMethod method) {
  switch (method) {
    case ModelMethod::pieces:
      return models::Needs::simple;
    case ModelMethod::lin_canny:
      return models::Needs::convex;
    default:
      return models::Needs::segments;
  }
}

Printed print_answers(const std::vector<ReadCase>& cases, const CaseOptions& options) {
  Printed printed;
  for (const ReadCase& read : cases) {
    for (const Problem& problem : read.problems) printed.err += to_string(problem) + '\n';
    const Json answer = solve(read, options);
    if (read.problems.empty() && answer.contains("error"))
      printed.err += fmt::format("{}: {}\n", read.name, answer["error"].get<std::string>());
    // Names may hold bytes that are not UTF-8.
    printed.out.push_back(answer.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n');
  }
  return printed;
}

}  // namespace gjkscope
