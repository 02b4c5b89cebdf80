#pragma once
// Pictures compared pixel by pixel.

#include <gtest/gtest.h>

#include <string>

#include "paint/image.hpp"
#include "picture/type.hpp"

namespace gjkscope::golden {

/// Software renderers round differently on other processors. A pixel counts as another when a
/// channel is off by more than kNoise of 255: antialiased edges stay below, a moved line is far
/// above. kOthers of the pixels may be: a label that moves by a pixel makes about ten times as
/// many.
inline constexpr int kNoise = 40;
inline constexpr double kOthers = 2e-4;

/// 1 where the sizes differ.
[[nodiscard]] double share_of_others(const Image& a, const Image& b);

/// Words in another release of a font are other pixels, a few of them elsewhere, but about as much
/// ink: squares of kSquare pixels keep their mean colour to within kInk of 255, but for kInkOthers
/// of the squares.
inline constexpr int kSquare = 40;
inline constexpr double kInk = 12.0;
inline constexpr double kInkOthers = 0.06;

/// The share of squares whose mean colour differs by more than kInk in a channel; 1 where the sizes
/// differ.
[[nodiscard]] double share_of_other_squares(const Image& a, const Image& b);

/// Without pixels where it is no PNG.
[[nodiscard]] Image decoded(const std::string& png);

/// The faces of frames and their releases, a line a face.
[[nodiscard]] std::string names_of(const Fonts& fonts);
/// Whether they are those of tests/golden/fonts.txt, with which the pictures there were made.
[[nodiscard]] bool fonts_are_those_of_goldens();

/// Whether `got` shows what `expected`, a PNG of tests/golden or docs, shows: pixel by pixel with
/// the fonts of goldens, with others square by square.
[[nodiscard]] ::testing::AssertionResult looks_like(const std::string& expected, const Image& got);

}  // namespace gjkscope::golden
