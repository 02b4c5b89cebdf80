#pragma once
// [trees]: what bounds segments in trees of volumes.

#include <array>
#include <string_view>
#include <utility>

#include "lesson/lesson.hpp"
#include "lesson/names.hpp"
#include "lesson/tour_settings.hpp"

namespace gjkscope {

enum class VolumeKind { boxes, circles, tiles };

template <>
struct Named<VolumeKind> {
  static constexpr std::array<std::pair<std::string_view, VolumeKind>, 3> kTable = {
      {{"boxes", VolumeKind::boxes},
       {"circles", VolumeKind::circles},
       {"tiles", VolumeKind::tiles}}};
};

struct LessonTrees {
  VolumeKind volumes = VolumeKind::boxes;
  double tile = 0.5;  ///< Largest radius of the circles that tile segments.
  static const SettingsKind kKind;
  friend bool operator==(const LessonTrees&, const LessonTrees&) = default;
};

/// Those of a lesson, or the defaults.
[[nodiscard]] inline LessonTrees trees_of(const Lesson& lesson) {
  const LessonTrees* trees = lesson.settings.as<LessonTrees>();
  return trees != nullptr ? *trees : LessonTrees{};
}

}  // namespace gjkscope
