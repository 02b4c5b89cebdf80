#pragma once
// The layers of a stage. A layer is a value that a subject defines; it lies below or above the
// marks of the tour.

#include <string>
#include <string_view>

#include "picture/plot.hpp"
#include "picture/scene.hpp"

namespace gjkscope {

struct Layer {
  enum class On { every_view, world, difference };
  std::string_view effect = {};  ///< Drawn where a view calls for it; empty: always.
  On on = On::every_view;
  int order = 0;  ///< Those with lower numbers lie below; the tour's own marks have kOfTour.
  void (*draw)(SceneBuilder& scene) = nullptr;
  /// In frames with equal keys a view's layer is the same, and is drawn once; null: in each frame.
  EffectKey (*key)(const SceneBuilder& scene) = nullptr;

  static constexpr int kOfTour = 500;
};

}  // namespace gjkscope
