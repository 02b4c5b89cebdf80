#include "session/practising.hpp"

#include <algorithm>

namespace gjkscope {

void Practising::begin(Session& session) {
  session.set_predicting(false);
  session.set_asking(true);
  const std::vector<Frame>& frames = session.run().frames;
  const auto asking = std::find_if(frames.begin(), frames.end(),
                                   [](const Frame& frame) { return frame.question >= 0; });
  session.go_to(static_cast<int>(asking - frames.begin()));
  version_ = session.version();
}

bool Practising::is_shown(const Session& session) const {
  return session.version() == version_ && session.is_asking() && !session.is_predicting();
}

std::optional<bool> Practising::outcome(const Session& session) const {
  if (!is_shown(session)) return std::nullopt;
  bool right = true;
  for (int i = 0; i < session.frame_count(); ++i) {
    if (session.run().frames[i].question < 0) continue;
    const Answer* given = session.given(i);
    if (given == nullptr) return std::nullopt;
    right = right && given->is_right();
  }
  return right;
}

practice::Practice Practising::noted(const Session& session) const {
  practice::Practice after = practice_;
  if (const std::optional<bool> is_right = outcome(session)) after.answer(*is_right);
  return after;
}

}  // namespace gjkscope
