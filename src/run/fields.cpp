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

template <int D>
Json point(const gjk::Vec<double, D>& value) {
  Json out = Json::array();
  for (const double coordinate : value) out.push_back(number(coordinate));
  return out;
}
template Json point<2>(const gjk::Vec<double, 2>& value);
template Json point<3>(const gjk::Vec<double, 3>& value);

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

template <int D>
Json vertex(const gjk::SupportPoint<double, D>& value, const std::string& name,
            const RunIn<D>& run) {
  Json out;
  out["name"] = name;
  out["pair"] = {value.pair.x, value.pair.y};
  out["w"] = point<D>(value.w);
  out["x"] = point<D>(run.x().world[static_cast<std::size_t>(value.pair.x)]);
  out["y"] = point<D>(run.y().world[static_cast<std::size_t>(value.pair.y)]);
  return out;
}
template Json vertex(const gjk::SupportPoint<double, 2>& value, const std::string& name,
                     const RunIn<2>& run);
template Json vertex(const gjk::SupportPoint<double, 3>& value, const std::string& name,
                     const RunIn<3>& run);

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

template <int D>
std::string point_text(ScalarKind scalar, const gjk::Vec<double, D>& point) {
  std::vector<std::string> numbers;
  for (const double value : point) numbers.push_back(number_text(scalar, value));
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}
template std::string point_text<2>(ScalarKind scalar, const gjk::Vec<double, 2>& point);
template std::string point_text<3>(ScalarKind scalar, const gjk::Vec<double, 3>& point);

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
