#pragma once
// Practice in a session, which opens each task as a lesson that asks its own questions.

#include <optional>

#include "practice/practice.hpp"
#include "session/session.hpp"

namespace gjkscope {

class Practising {
 public:
  explicit Practising(practice::Practice practice) : practice_(std::move(practice)) {}
  [[nodiscard]] const practice::Practice& practice() const { return practice_; }
  /// The session has opened the task's lesson: it asks, from the first question on.
  void begin(Session& session);
  /// Whether the session shows the task, and nothing of it was changed.
  [[nodiscard]] bool is_shown(const Session& session) const;
  /// Whether all answers to the task that is shown were right; nothing before all are given.
  [[nodiscard]] std::optional<bool> outcome(const Session& session) const;
  /// The practice after the task that is shown, if all its questions were answered: on to the next.
  [[nodiscard]] practice::Practice noted(const Session& session) const;
  /// Goes on to the next task, which is to be opened.
  void next(const Session& session) { practice_ = noted(session); }

 private:
  practice::Practice practice_;
  long version_ = -1;  ///< The session's, while it shows the task.
};

}  // namespace gjkscope
