#include "subjects/study/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "subjects/study/subject.hpp"

namespace gjkscope {
namespace {

std::optional<double> number_or_none(const nlohmann::ordered_json& value) {
  return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

std::vector<Eigen::Vector2d> points_of(const nlohmann::ordered_json& list) {
  std::vector<Eigen::Vector2d> points;
  for (const auto& [x, y] : list.get<std::vector<std::pair<double, double>>>())
    points.emplace_back(x, y);
  if (points.empty()) throw std::runtime_error("a shape has no vertices");
  return points;
}

StudyDot dot_of(const nlohmann::ordered_json& row) {
  StudyDot dot;
  row.at("family").get_to(dot.family);
  row.at("configuration").get_to(dot.configuration);
  row.at("axis").get_to(dot.axis);
  row.at("proof").get_to(dot.proof);
  row.at("pairs").get_to(dot.pairs);
  row.at("wrong").get_to(dot.wrong);
  row.at("undecided").get_to(dot.undecided);
  row.at("settled").get_to(dot.settled);
  row.at("front").get_to(dot.on_front);
  row.at("ns").get_to(dot.ns);
  row.at("ratio").get_to(dot.ratio);
  dot.error = number_or_none(row.at("error"));
  const nlohmann::ordered_json& worst = row.at("worst");
  dot.answer = number_or_none(worst.at("answer"));
  worst.at("distance").get_to(dot.distance);
  dot.x = points_of(worst.at("case").at("a"));
  dot.y = points_of(worst.at("case").at("b"));
  return dot;
}

}  // namespace

StudyResults parse_study_results(std::string_view json) {
  constexpr const char* kExpected = "expected the accuracy.json of `gjkscope study accuracy`";
  const nlohmann::ordered_json read = nlohmann::ordered_json::parse(json, nullptr, false);
  if (read.is_discarded()) throw std::runtime_error(fmt::format("not JSON; {}", kExpected));
  if (!read.is_object() || !read.contains("rows") || !read["rows"].is_array())
    throw std::runtime_error(fmt::format("no rows; {}", kExpected));
  StudyResults out;
  try {
    read.at("machine").at("processor").get_to(out.processor);
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("machine: {}; {}", error.what(), kExpected));
  }
  int number = 0;
  for (const nlohmann::ordered_json& row : read["rows"]) {
    ++number;
    try {
      if (row.at("repetitions").get<int>() > 0) out.dots.push_back(dot_of(row));
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("row {}: {}; {}", number, error.what(), kExpected));
    }
  }
  if (out.dots.empty()) throw std::runtime_error(fmt::format("no row was timed; {}", kExpected));
  return out;
}

std::vector<StudyDot> of_family(const std::vector<StudyDot>& dots, std::string_view family) {
  std::vector<StudyDot> out;
  std::copy_if(dots.begin(), dots.end(), std::back_inserter(out),
               [&](const StudyDot& dot) { return dot.family == family; });
  return out;
}

std::vector<StudyDot> front_of(const std::vector<StudyDot>& dots) {
  std::vector<StudyDot> out;
  std::copy_if(dots.begin(), dots.end(), std::back_inserter(out),
               [](const StudyDot& dot) { return dot.on_front; });
  std::sort(out.begin(), out.end(),
            [](const StudyDot& a, const StudyDot& b) { return a.ns < b.ns; });
  return out;
}

std::vector<bool> front_of(const std::vector<Cost>& costs) {
  std::vector<bool> out(costs.size(), false);
  double wanted = kNoDigit;
  while (true) {
    double fastest = std::numeric_limits<double>::infinity();
    for (const Cost& cost : costs) {
      if (cost.error <= wanted) fastest = std::min(fastest, cost.ns);
    }
    if (std::isinf(fastest)) return out;
    const auto is_as_fast = [&](const Cost& cost) { return cost.ns <= kSameTime * fastest; };
    double least = wanted;
    for (const Cost& cost : costs) {
      if (is_as_fast(cost)) least = std::min(least, cost.error);
    }
    const double most = std::min(wanted, kSameError * least);
    const auto plainest = std::find_if(costs.begin(), costs.end(), [&](const Cost& cost) {
      return is_as_fast(cost) && cost.error <= most;
    });
    out[plainest - costs.begin()] = true;
    if (plainest->error == 0.0) return out;
    wanted = plainest->error / kSameError;
  }
}

std::vector<std::string> families_in(const std::vector<StudyDot>& dots) {
  std::vector<std::string> names;
  for (const StudyDot& dot : dots) {
    if (std::find(names.begin(), names.end(), dot.family) == names.end())
      names.push_back(dot.family);
  }
  return names;
}

std::string error_text(double error) {
  if (std::isnan(error)) return "";
  if (std::isinf(error)) return "none";
  if (error == 0.0) return "0";
  return error >= 0.1 && error < 1000.0 ? fmt::format("{:.2g}", error)
                                        : fmt::format("{:.1e}", error);
}

}  // namespace gjkscope
