#pragma once
// All methods for two convex outlines, side by side, as the algorithm of a lesson: what each needs
// at a position, from scratch and with what it knows of the position before (Larsen 1998,
// "Conclusions").

#include <array>

#include "lesson/algorithm.hpp"
#include "outlines/lin_canny.hpp"
#include "outlines/search.hpp"
#include "run/outline_trace.hpp"
#include "run/run.hpp"

namespace gjkscope {

enum class Method : std::uint8_t {
  gjk_cold,
  gjk_warm,   ///< Starts from the last simplex.
  lin_canny,  ///< Starts from the last pair of features.
  tree_cold,
  tree_pair,   ///< The last pair of segments is the first candidate.
  tree_front,  ///< Starts where the last search ended, and from its pair.
};
inline constexpr std::array<Method, 6> kMethods = {Method::gjk_cold,  Method::gjk_warm,
                                                   Method::lin_canny, Method::tree_cold,
                                                   Method::tree_pair, Method::tree_front};
/// "GJK, last simplex"
[[nodiscard]] std::string_view name_of(Method method);
/// The unit that it is counted in: "iterations"
[[nodiscard]] std::string_view unit_of(Method method);

/// Results of all methods at one position.
struct MethodsTrace {
  std::array<long, kMethods.size()> steps = {};  ///< In the unit of each method.
  std::array<double, kMethods.size()> distances = {};
  models::Answer answer;  ///< The answer of the tree.
  std::optional<Refusal> refusal;

  // Starts for the next position.
  gjk::WarmStart simplex;
  models::RingFeature on_x;
  models::RingFeature on_y;
  std::pair<int, int> segments = {-1, -1};
  /// Pairs of nodes that were cut or measured. Below them lie all pairs of leaves.
  std::vector<models::NodePair> front;
  long from_roots = 0;  ///< Visits of the last search from the roots.

  [[nodiscard]] bool is_refused() const { return refusal.has_value(); }
  [[nodiscard]] long at(Method method) const { return steps[static_cast<std::size_t>(method)]; }
};

extern const Algorithm kMethodsAlgorithm;

/// The results in run `index`; nullptr when the lesson shows another algorithm.
[[nodiscard]] const MethodsTrace* methods_trace(const LessonRun& run, int index);

}  // namespace gjkscope
