#include "run/fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "base/hexadecimal.hpp"
#include "lesson/names.hpp"

namespace gjkscope::fields {
namespace {

std::string words(std::string key) {
  std::replace(key.begin(), key.end(), '_', ' ');
  return key;
}

}  // namespace

Json number(double value) {
  Json out;
  out["value"] = std::isfinite(value) ? Json(value) : Json();
  out["hex"] = std::isfinite(value) ? hexadecimal(value) : fmt::format("{}", value);
  return out;
}

Json point(const Vector& value) {
  Json out = Json::array();
  for (const double coordinate : value) out.push_back(number(coordinate));
  return out;
}

Json scan(const std::vector<gjk::ScanEntry<double>>& entries,
          const std::vector<std::string>& names) {
  Json out = Json::array();
  for (const gjk::ScanEntry<double>& entry : entries) {
    Json one;
    one["index"] = entry.index;
    one["name"] = names[entry.index];
    one["value"] = number(entry.value);
    one["improves"] = entry.improves;
    out.push_back(std::move(one));
  }
  return out;
}

Json vertex(const WideVertex& value, const std::string& name, const PositionedRun& run) {
  const int dimension = run.trace.dimension;
  Json out;
  out["name"] = name;
  out["pair"] = {value.pair.x, value.pair.y};
  out["w"] = point(value.w.head(dimension));
  out["x"] = point(run.x().world[value.pair.x].head(dimension));
  out["y"] = point(run.y().world[value.pair.y].head(dimension));
  return out;
}

std::string number_text(ScalarKind scalar, double value) {
  switch (scalar) {
    case ScalarKind::half:
      return fmt::format("{:.5g}", value);
    case ScalarKind::single:
      return fmt::format("{}", static_cast<float>(value));
    default:
      return fmt::format("{}", value);
  }
}

std::string point_text(ScalarKind scalar, const Vector& point) {
  std::vector<std::string> numbers;
  for (const double value : point) numbers.push_back(number_text(scalar, value));
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

std::string line(std::string_view label, std::string_view text) {
  constexpr int kColumn = 11;
  return fmt::format("  {:<{}}{}\n", label, kColumn, text);
}

double double_of(const Json& number) {
  if (number["value"].is_null())
    return std::strtod(number["hex"].get<std::string>().c_str(), nullptr);
  return number["value"];
}

Values::Values(const Json& document)
    : scalar(*value_of<ScalarKind>(document["scalar"].get<std::string>())),
      x(document["x"]["name"]),
      y(document["y"]["name"]) {}

std::string Values::number(const Json& value) const {
  return number_text(scalar, double_of(value));
}

std::string Values::point(const Json& coordinates) const {
  std::vector<std::string> numbers;
  for (const Json& coordinate : coordinates) numbers.push_back(number(coordinate));
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

std::string Values::any(const Json& value) const {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_object() && value.contains("hex")) return number(value);
  std::vector<std::string> parts;
  if (value.is_array()) {
    for (const Json& part : value) parts.push_back(any(part));
    return fmt::format("[{}]", fmt::join(parts, ", "));
  }
  if (value.is_number_float()) return number_text(scalar, value);
  if (!value.is_object()) return value.dump();
  for (const auto& [key, part] : value.items()) parts.push_back(words(key) + " " + any(part));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string Values::scan(const std::string& shape, const Json& entries, int best) const {
  // A line that can be read; JSON has them all. Among many vertices, those that lie farthest.
  constexpr std::size_t kMost = 24;
  constexpr std::size_t kFarthest = 8;
  std::vector<Json> listed(entries.begin(), entries.end());
  if (entries.size() > kMost) {
    std::stable_sort(listed.begin(), listed.end(), [](const Json& a, const Json& b) {
      return double_of(a["value"]) > double_of(b["value"]);
    });
    listed.resize(kFarthest);
  }
  std::vector<std::string> parts;
  for (const Json& entry : listed) {
    parts.push_back(fmt::format("{} {}{}", entry["name"].get<std::string>(), number(entry["value"]),
                                entry["index"] == best ? " (largest)" : ""));
  }
  if (listed.size() < entries.size())
    parts.push_back(fmt::format("and {} that lie less far", entries.size() - listed.size()));
  return fmt::format("{}: {}", shape, fmt::join(parts, ", "));
}

std::string Values::stop_test(const Json& test) const {
  const std::string name = test["test"];
  if (test.contains("enabled") && !test["enabled"]) return name + ": off";
  if (!test["tried"]) return name + ": not tried";
  return fmt::format("{}: {} (left {}, right {})", name, test["holds"] ? "yes" : "no",
                     number(test["left"]), number(test["right"]));
}

std::string Values::bounds(const Json& from) const {
  return fmt::format("{} to {}", number(from["lower"]), number(from["upper"]));
}

std::string Values::verdict(const Json& result) const {
  return fmt::format("{}{}", result["verdict"].get<std::string>(),
                     result["settled"] ? ", settled in exact arithmetic" : "");
}

std::string text(const Json& document, std::string_view name, const Json& trace) {
  const Values values(document);
  if (trace.contains("refused"))
    return fmt::format("\n{}\n", name) + line("refused", values.any(trace["refused"]));
  std::string out;
  int iteration = 0;
  if (trace.contains("steps")) {
    for (Json step : trace["steps"]) {
      if (out.empty() || step["iteration"] != iteration)
        out += fmt::format("\n{}, iteration {}\n", name, step["iteration"].get<int>());
      iteration = step["iteration"];
      const std::string phase = step["phase"];
      step.erase("phase");
      step.erase("iteration");
      out += line(phase, values.any(step));
    }
  }
  out += fmt::format("\n{}, result\n", name);
  for (const auto& [key, value] : trace.items()) {
    if (key == "steps") continue;
    const bool is_table =
        value.is_array() && !value.empty() && value[0].is_object() && !value[0].contains("hex");
    std::string label = words(key);
    for (const Json& row : is_table ? value : Json::array({value})) {
      out += line(label, values.any(row));
      label.clear();
    }
  }
  return out;
}

}  // namespace gjkscope::fields
