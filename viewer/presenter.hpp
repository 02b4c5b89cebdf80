#pragma once
// The window in a lecture: the whole screen for the picture, a black screen, and a ring that shows
// the pointer while it moves.

#include <optional>

#include "picture/picture.hpp"

namespace gjkscope {

class Presenter {
 public:
  [[nodiscard]] bool is_on() const { return on_; }
  void turn(bool on);
  [[nodiscard]] bool is_black() const { return black_; }
  void blacken(bool black) { black_ = black; }

  /// Takes the place of the pointer, in each frame.
  void see(const Point& pointer, double now);
  /// From 0 to 1: the pointer is there after it has moved, and fades when it rests.
  [[nodiscard]] double pointer_opacity(double now) const;
  /// When the pointer looks otherwise than now; nothing when it rests and is gone.
  [[nodiscard]] std::optional<double> wakes_at(double now) const;

 private:
  bool on_ = false;
  bool black_ = false;
  std::optional<double> began_;  ///< Set when the first frame is seen.
  std::optional<Point> last_;
  std::optional<double> moved_;
};

}  // namespace gjkscope
