#include "presenter.hpp"

#include <algorithm>

namespace gjkscope {
namespace {

// Seconds.
constexpr double kSettles = 0.5;  // while the window becomes as large as the screen
constexpr double kRests = 1.5;
constexpr double kFades = 0.5;
constexpr double kImage = 1.0 / 30.0;

}  // namespace

void Presenter::turn(bool on) {
  on_ = on;
  black_ = false;
  began_.reset();
  last_.reset();
  moved_.reset();
}

void Presenter::see(const Point& pointer, double now) {
  if (!on_) return;
  if (!began_) began_ = now;
  const bool moves = last_ && *last_ != pointer && now > *began_ + kSettles;
  last_ = pointer;
  if (moves) moved_ = now;
}

double Presenter::pointer_opacity(double now) const {
  if (!on_) return 1.0;
  if (!moved_) return 0.0;
  return std::clamp(1.0 - (now - *moved_ - kRests) / kFades, 0.0, 1.0);
}

std::optional<double> Presenter::wakes_at(double now) const {
  // One image more than it fades for: what it pointed at is marked no longer.
  if (!on_ || !moved_ || now > *moved_ + kRests + kFades + kImage) return std::nullopt;
  return std::max(*moved_ + kRests, now + kImage);
}

}  // namespace gjkscope
