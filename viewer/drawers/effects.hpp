#pragma once
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "picture/scene.hpp"
#include "run/effect_info.hpp"
#include "run/graph.hpp"

namespace gjkscope {

class App;

/// Those that views of the lesson can call for.
[[nodiscard]] std::vector<const EffectInfo*> offered_effects(const Lesson& lesson);
/// "Minkowski hull" of "minkowski-hull".
[[nodiscard]] std::string title_of(const EffectInfo& effect);
/// A view calls for it, or no longer. What would change nothing is not called for: that is said.
void toggle_effect(App& app, std::size_t view, std::string_view effect);

/// A run of its own, whose views call for effects one by one.
class EffectTrial {
 public:
  /// `known`: what is computed of this run already.
  EffectTrial(const LessonRun& run, const EffectGraph& known, const Fonts& fonts);
  EffectTrial(const EffectTrial&) = delete;
  EffectTrial& operator=(const EffectTrial&) = delete;

  /// Frame by frame, whether a view looks or reads otherwise with an effect than without it.
  /// Nothing where that takes too long to find out, or `stop` came first.
  [[nodiscard]] std::optional<std::vector<bool>> frames_changed_by(
      std::size_t view, std::string_view effect, const std::stop_token& stop = {});
  [[nodiscard]] const Lesson& lesson() const { return run_.lesson; }

 private:
  void call_for(std::size_t view, std::string_view effect, bool on);
  [[nodiscard]] Scene scene(std::size_t view, std::size_t frame, const StageMap& map);

  LessonRun run_;
  EffectGraph effects_;
  const Fonts& fonts_;
};

}  // namespace gjkscope
