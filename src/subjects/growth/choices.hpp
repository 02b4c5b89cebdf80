#pragma once
// Questions on plots: which of some places the next measured number has.

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "picture/frame_text.hpp"
#include "picture/plot.hpp"

namespace gjkscope {

/// A place that such a question chooses from.
struct GrowthChoice {
  std::string name;  ///< "as n"
  double ratio;      ///< To the number before.
};

/// The places at `x`, each its ratio times `before`.
inline void add_choices(Plot& plot, double x, double before,
                        std::span<const GrowthChoice> choices) {
  PlotSeries places{PlotStyle::other, "", {}, PlotJoin::none};
  for (const GrowthChoice& choice : choices) {
    places.subjects.push_back({Subject::Kind::study_dot, static_cast<int>(places.points.size())});
    places.points.emplace_back(x, before * choice.ratio);
    plot.notes.push_back({PlotStyle::other, places.points.back(), choice.name});
  }
  plot.series.push_back(std::move(places));
}

/// The choices, and the one that `ratio` is nearest to. `on_plot`: they are places of a plot, too.
inline void ask_growth(std::string_view ask, std::span<const GrowthChoice> choices, double ratio,
                       bool on_plot, FrameText& text) {
  FrameQuestion& asked = text.question.emplace();
  asked.ask = ask;
  for (const GrowthChoice& choice : choices) {
    if (on_plot)
      asked.subjects.push_back({Subject::Kind::study_dot, static_cast<int>(asked.choices.size())});
    asked.choices.push_back(choice.name);
  }
  const auto off = [&](const GrowthChoice& choice) {
    return std::abs(std::log(ratio / choice.ratio));
  };
  asked.answer =
      std::min_element(choices.begin(), choices.end(), [&](const auto& a, const auto& b) {
        return off(a) < off(b);
      })->name;
}

}  // namespace gjkscope
