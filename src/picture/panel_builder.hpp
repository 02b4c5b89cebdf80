#pragma once
// The writer of the panel's blocks: rows downwards from the top of a card, and the values that the
// frame's step knows.

#include <optional>
#include <string>
#include <vector>

#include "picture/picture.hpp"
#include "picture/words.hpp"
#include "run/facts.hpp"
#include "run/graph.hpp"

namespace gjkscope {

/// Distances in frame pixels.
namespace rows {
inline constexpr double kPad = 16.0;  // card edge to text
inline constexpr double kRow = 23.0;  // base line to base line
inline constexpr double kTightRow = 20.0;
inline constexpr double kBlockGap = 15.0;  // around the rule between blocks
}  // namespace rows

/// Writes blocks downwards from the top of a card.
struct PanelBuilder {
  PanelBuilder(const LessonRun& lesson_run, EffectGraph& graph, const Frame& shown,
               const Fonts& type_faces, const Rect& card);

  // Writing
  void add(std::string role, decltype(Mark::shape) shape);
  /// On the current row.
  void write(std::string role, double x, std::string text, const TextStyle& style,
             Align align = Align::left);
  void heading(std::string text);
  /// A number and what it counts.
  void row(const std::string& what, const std::string& value);
  /// Between two blocks.
  void rule();
  /// A box behind the current row, and `below` pixels more.
  void highlight(const std::string& role = "highlight", double below = 0.0);
  /// A bar from zero, on a track from `low` to `high`.
  void bar(double x0, double x1, double low, double high, double value, const std::string& role);

  /// The numbers that decide a region test.
  [[nodiscard]] std::string test_values(const gjk::RegionTest<double>& test) const;

  const LessonRun& run;
  EffectGraph& effects;
  const Frame& frame;
  const Fonts& fonts;
  const WideState& state;
  const FrameFacts::Value& knows;
  Numbers numbers;
  SimplexWords words;
  double left;           ///< Left edge of the text.
  double right;          ///< Right edge of the text.
  double y;              ///< Base line of the current row.
  Subject subject = {};  ///< The subject of all that is written from here on.
  std::vector<Mark> marks;
};

}  // namespace gjkscope
