#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "effects/registry.hpp"
#include "lesson/lesson.hpp"

namespace gjkscope {

class App;

/// Those that views of the lesson can call for.
[[nodiscard]] std::vector<const EffectInfo*> offered_effects(const Lesson& lesson);
/// "Minkowski hull" of "minkowski-hull".
[[nodiscard]] std::string title_of(const EffectInfo& effect);
/// A view calls for it, or no longer.
void toggle_effect(App& app, std::size_t view, std::string_view effect);

}  // namespace gjkscope
