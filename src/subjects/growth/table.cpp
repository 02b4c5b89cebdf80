#include "subjects/growth/table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "lesson/settings_kind.hpp"
#include "subjects/growth/subject.hpp"

namespace gjkscope {
namespace {

using toml_file::Field;
using toml_file::Table;

constexpr int kSizes = 16;
constexpr int kMeasuredVertices = 1'000'000;  // of one polygon
constexpr int kMeasuredTogether = 2'000'000;  // of all sizes: a second or so
constexpr int kMeasuredRuns = 200;            // with each number of vertices
constexpr int kLargestSeed = 1'000'000'000;
constexpr int kMachineLength = 80;
constexpr double kNanoseconds = 1e15;  // that a method takes

void growth_keys(KeyPass& keys, LessonGrowth& growth) {
  keys("vertices", kRequired,
       fmt::format("numbers of vertices of each of the two polygons; their sum is at most {}",
                   kMeasuredTogether),
       fmt::format("list of 2 to {} whole numbers from 3 to {}, ascending", kSizes,
                   kMeasuredVertices))
      .other_list(as_texts(growth.vertices));
  keys("runs", "", "runs with each number of vertices, of which frames show the averages")
      .whole_number(growth.runs, 1, kMeasuredRuns);
  keys("seed", "", "of the random polygons: the same number gives the same ones")
      .whole_number(growth.seed, 0, kLargestSeed);
  keys("tolerance", "", "frames also count the iterations until lower >= (1 - tolerance) * upper",
       "number of at least 0 and below 1")
      .number(growth.tolerance, 0.0, std::nextafter(1.0, 0.0));
  keys("times", "none",
       "with tour `general-growth`: how long methods take, as `gjkscope study models` measures and "
       "writes it",
       "table [growth.times]")
      .other();
}

void times_keys(KeyPass& keys, GrowthTimes& times) {
  keys("machine", kRequired, "what it was measured on").text(times.machine, kMachineLength);
  constexpr std::array<std::string_view, kGrowthTimes.size()> kMeanings = {
      "all pairs of segments",
      "convex pieces, cut beforehand, up to the largest that are cut",
      "trees of boxes, built beforehand",
      "trees of circles",
      "trees of boxes, from the closest pair of the position before",
      "trees of boxes, only to find whether they collide",
      "building both trees of boxes"};
  for (std::size_t i = 0; i < kGrowthTimes.size(); ++i) {
    keys(kGrowthTimes[i].first, kRequired, std::string(kMeanings[i]),
         fmt::format("list of numbers from 1 to {:g}, one a size: nanoseconds", kNanoseconds))
        .other_list(as_texts(times.*kGrowthTimes[i].second));
  }
}

/// Pieces are timed up to the largest outlines that are cut, all else at each size.
GrowthTimes read_times(const TableSource& source, const Table& table, std::size_t sizes) {
  GrowthTimes times;
  source.read_keys(table, times_keys, times);
  for (const auto& [name, member] : kGrowthTimes) {
    const Field field = table[name];
    std::vector<double>& list = times.*member;
    for (const Field& entry :
         source.reader.entries(field, fmt::format("number from 1 to {:g}", kNanoseconds))) {
      if (const std::optional<double> ns = source.reader.number(entry, 1.0, kNanoseconds))
        list.push_back(*ns);
    }
    const bool fits =
        list.size() == sizes || (member == &GrowthTimes::pieces && list.size() < sizes);
    if (field && field.node->is_array() && !fits) {
      source.problems.add(
          field.place(), fmt::format("{} times for {} sizes", list.size(), sizes),
          fmt::format("those that `gjkscope study models` measures at {} sizes", sizes));
    }
  }
  return times;
}

TourSettings read_growth(const TableSource& source) {
  LessonGrowth growth;
  const Field vertices = source.table["vertices"];
  const std::vector<Field> sizes =
      source.reader.entries(vertices, fmt::format("whole number from 3 to {}", kMeasuredVertices));
  if (vertices && vertices.node->is_array() && (sizes.size() < 2 || sizes.size() > kSizes))
    source.problems.add(vertices, fmt::format("'vertices' has {} entries", sizes.size()));
  for (const Field& entry : sizes) {
    const std::optional<int> size = source.reader.whole_number(entry, 3, kMeasuredVertices);
    if (!size) continue;
    if (!growth.vertices.empty() && *size <= growth.vertices.back()) {
      source.problems.add(entry.place(),
                          fmt::format("{} vertices after {}", *size, growth.vertices.back()),
                          "ascending numbers");
    }
    growth.vertices.push_back(*size);
  }
  const long all = std::accumulate(growth.vertices.begin(), growth.vertices.end(), 0L);
  if (all > kMeasuredTogether) {
    source.problems.add(vertices.place(), fmt::format("{} vertices in all", all),
                        fmt::format("a sum of at most {}", kMeasuredTogether));
  }
  source.read_keys(source.table, growth_keys, growth);
  if (const auto times = source.reader.table(source.table["times"], "growth.times"))
    growth.times = read_times(source, *times, growth.vertices.size());
  return TourSettings(std::move(growth));
}

void write_growth(const TourSettings& table, TomlText& out) {
  const LessonGrowth& growth = *table.as<LessonGrowth>();
  out.table("[growth]");
  out.lines(written_keys(growth, growth_keys));
  if (!growth.times) return;
  out.table("[growth.times]");
  out.lines(written_keys(*growth.times, times_keys));
}

}  // namespace

const SettingsKind LessonGrowth::kKind = {
    "growth", "random polygons that runs are measured with",
    [] {
      return listed_keys<LessonGrowth>("growth", growth_keys,
                                       listed_keys<GrowthTimes>("growth.times", times_keys));
    },
    read_growth, write_growth};

}  // namespace gjkscope
