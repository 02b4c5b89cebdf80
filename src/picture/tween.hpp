#pragma once
// Pictures between two pictures: films, pages and the window show the same.

#include "picture/picture.hpp"

namespace gjkscope {

/// How long it takes from one picture to the next.
inline constexpr double kTweenSeconds = 0.3;

/// The picture at the share `t` of the way: `from` at 0 or less, `to` at 1 or more. In a view a
/// mark that is in both moves at constant speed from its old to its new place. New marks appear,
/// old ones fade in their place, and old texts are gone at once. Two marks are the same if they
/// have one role, kind and subject (texts: one wording); of several such marks the first is the
/// same as the first. Marks outside of all views are those of `to`; so are all marks if the views
/// differ.
[[nodiscard]] Picture tween(const Picture& from, const Picture& to, double t);

}  // namespace gjkscope
