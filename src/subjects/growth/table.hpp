#pragma once
// [growth]: random polygons that runs are measured with, and how long methods take on outlines of
// these sizes.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lesson/tour_settings.hpp"

namespace gjkscope {

/// How long each method takes for the distance of two outlines, in nanoseconds, at each size of a
/// [growth]: what `gjkscope study models` has measured.
struct GrowthTimes {
  std::string machine;
  std::vector<double> pairs;       ///< All pairs of segments.
  std::vector<double> pieces;      ///< Convex pieces, cut beforehand; of sizes that are cut.
  std::vector<double> boxes;       ///< Trees of boxes, built beforehand,
  std::vector<double> circles;     ///< of circles,
  std::vector<double> remembered;  ///< of boxes, from the closest pair of the position before,
  std::vector<double> collide;     ///< and only to find whether they collide.
  std::vector<double> build;       ///< Both trees of boxes.
  friend bool operator==(const GrowthTimes&, const GrowthTimes&) = default;
};
/// By their names in files.
inline constexpr std::array<std::pair<std::string_view, std::vector<double> GrowthTimes::*>, 7>
    kGrowthTimes = {{{"pairs", &GrowthTimes::pairs},
                     {"pieces", &GrowthTimes::pieces},
                     {"boxes", &GrowthTimes::boxes},
                     {"circles", &GrowthTimes::circles},
                     {"remembered", &GrowthTimes::remembered},
                     {"collide", &GrowthTimes::collide},
                     {"build", &GrowthTimes::build}}};

/// Runs to be measured: pairs of random convex polygons, `runs` of them with each number of
/// vertices.
struct LessonGrowth {
  std::vector<int> vertices;  ///< The vertices of each of the two polygons, ascending.
  int runs = 100;
  int seed = 1;              ///< The seed of the random polygons.
  double tolerance = 0.001;  ///< Counted besides the whole run: the iterations until
                             ///< lower >= (1 - tolerance) * upper.
  std::optional<GrowthTimes> times = {};
  static const SettingsKind kKind;
  friend bool operator==(const LessonGrowth&, const LessonGrowth&) = default;
};

}  // namespace gjkscope
