#pragma once
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "effects/registry.hpp"
#include "lesson/run.hpp"
#include "picture/type.hpp"

namespace gjkscope {

class App;

/// Those that views of the lesson can call for.
[[nodiscard]] std::vector<const EffectInfo*> offered_effects(const Lesson& lesson);
/// "Minkowski hull" of "minkowski-hull".
[[nodiscard]] std::string title_of(const EffectInfo& effect);
/// A view calls for it, or no longer. What would change nothing is not called for: that is said.
void toggle_effect(App& app, std::size_t view, std::string_view effect);

/// Frame by frame, whether a view of the run looks or reads otherwise with an effect than without
/// it. Nothing where that takes too long to find out, or `stop` came first.
[[nodiscard]] std::optional<std::vector<bool>> frames_changed_by(const LessonRun& run,
                                                                 const Fonts& fonts,
                                                                 std::size_t view,
                                                                 std::string_view effect,
                                                                 const std::stop_token& stop = {});

}  // namespace gjkscope
