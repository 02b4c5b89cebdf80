#pragma once
// Pictures between two pictures: films, pages and the window show the same.

#include "picture/picture.hpp"

namespace gjkscope {

/// How long it takes from one picture to the next.
inline constexpr double kTweenSeconds = 0.3;

/// The picture at the share `t` of the way: `from` at 0 or less, `to` at 1 or more. In a view a
/// mark that is in both moves at constant speed from where it was to where it is; what is new
/// appears, and what is gone fades in its place, but for texts, which are gone at once. Marks are
/// the same that have one role and kind, and stand for one subject (texts: have one wording); of
/// several such the first is the first. What is outside of all views is that of `to`, and so is
/// everything where the views themselves differ.
[[nodiscard]] Picture tween(const Picture& from, const Picture& to, double t);

}  // namespace gjkscope
