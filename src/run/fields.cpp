#include "run/fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/hexadecimal.hpp"
#include "lesson/names.hpp"

namespace gjkscope::fields {

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
    one["name"] = names[static_cast<std::size_t>(entry.index)];
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
  out["x"] = point(run.x().world[static_cast<std::size_t>(value.pair.x)].head(dimension));
  out["y"] = point(run.y().world[static_cast<std::size_t>(value.pair.y)].head(dimension));
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

std::string scan_text(ScalarKind scalar, const std::string& shape,
                      const std::vector<std::string>& names,
                      const std::vector<gjk::ScanEntry<double>>& entries, int best) {
  // A line that can be read; JSON has them all. Among many vertices, those that lie farthest.
  constexpr std::size_t kMost = 24;
  constexpr std::size_t kFarthest = 8;
  std::vector<gjk::ScanEntry<double>> listed = entries;
  if (entries.size() > kMost) {
    std::stable_sort(listed.begin(), listed.end(),
                     [](const auto& a, const auto& b) { return a.value > b.value; });
    listed.resize(kFarthest);
  }
  std::vector<std::string> parts;
  for (const gjk::ScanEntry<double>& entry : listed) {
    parts.push_back(fmt::format("{} {}{}", names[static_cast<std::size_t>(entry.index)],
                                number_text(scalar, entry.value),
                                entry.index == best ? " (largest)" : ""));
  }
  if (listed.size() < entries.size())
    parts.push_back(fmt::format("and {} that lie less far", entries.size() - listed.size()));
  return fmt::format("{}: {}", shape, fmt::join(parts, ", "));
}

}  // namespace gjkscope::fields
