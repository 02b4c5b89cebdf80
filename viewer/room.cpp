#include "room.hpp"

#include <algorithm>

namespace gjkscope {
namespace {

// Pixels at scale 1.
constexpr double kTabs = 780.0;           // a bar that has the drawers' names
constexpr double kBesideLessons = 760.0;  // of the stage
constexpr double kMostOver = 0.8;         // of a stage that a drawer lies over

}  // namespace

Room room_of(const RoomWish& wish) {
  const auto [width, height, scale, density, presenting, notices, lessons, drawer, is_chosen] =
      wish;
  Room room;
  room.stage = {{0.0, 0.0}, {width, height}};
  if (presenting) return room;
  room.bar = std::min(kBar * scale, 0.5 * height);
  room.folded =
      width < kTabs * scale || height - (2.0 * kBar + kStatus) * scale < kStageHeight * density;
  room.has_status = !room.folded;
  room.stage.min.y() = std::min(room.bar + notices, 0.5 * height);
  if (!room.folded) room.stage.max.y() -= (kBar + kStatus) * scale;
  const double wanted = drawer ? std::max(*drawer, kNarrowestDrawer) * scale : 0.0;
  const double least = kStageWidth * density;
  if (lessons && width - kLessonsWidth * scale - wanted >= kBesideLessons * scale)
    room.lessons = kLessonsWidth * scale;
  room.stage.min.x() = room.lessons;
  if (!drawer) return room;
  const double spare = width - room.lessons - least;
  const double beside = std::min(wanted, spare);
  room.drawer_is_over = beside < kNarrowestDrawer * scale || (is_chosen && wanted > beside);
  room.drawer = room.drawer_is_over ? std::min(wanted, kMostOver * width) : beside;
  if (beside >= kNarrowestDrawer * scale) room.stage.max.x() -= beside;
  return room;
}

}  // namespace gjkscope
