#pragma once
// The division of the window among its parts. Below some size the bars fold before the stage
// shrinks, and what has no room beside the stage lies over it.

#include <optional>

#include "picture/picture.hpp"

namespace gjkscope {

// Pixels at scale 1.
inline constexpr double kBar = 38.0;     // of one row
inline constexpr double kStatus = 24.0;  // below the transport
inline constexpr double kLessonsWidth = 280.0;
inline constexpr double kDrawerWidth = 400.0;
inline constexpr double kNarrowestDrawer = 240.0;
/// The smallest window.
inline constexpr double kLeastWidth = 520.0;
inline constexpr double kLeastHeight = 400.0;
/// The smallest stage that holds the whole page of a frame in type of 12 pixels.
inline constexpr double kStageWidth = 570.0;
inline constexpr double kStageHeight = 540.0;

struct RoomWish {
  double width = 0.0;  ///< The window's, in pixels, as all lengths here.
  double height = 0.0;
  double scale = 1.0;    ///< The panels'.
  double density = 1.0;  ///< The screen's, and so that of the stage's type.
  bool presenting = false;
  double notices = 0.0;           ///< Height of their lines below the bar.
  bool lessons = false;           ///< The list is wanted beside the stage.
  std::optional<double> drawer;   ///< Its width at scale 1; nothing: none is open.
  bool drawer_is_chosen = false;  ///< A hand has made it as wide, even if it covers the stage.
};

struct Room {
  Rect stage;
  bool folded = false;      ///< One bar holds menus and transport; drawers are in a menu.
  double bar = 0.0;         ///< Its height.
  bool has_status = false;  ///< A line below the transport.
  double lessons = 0.0;     ///< Width of their list beside the stage.
  double drawer = 0.0;      ///< Width of the drawer.
  bool drawer_is_over = false;
};

[[nodiscard]] Room room_of(const RoomWish& wish);

}  // namespace gjkscope
