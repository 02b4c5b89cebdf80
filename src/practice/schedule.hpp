#pragma once
// The order of kinds in practice: what went wrong comes again.

#include <vector>

namespace gjkscope::practice {

/// Which kind comes next. Kinds come one after the other, again and again; one that was answered
/// wrongly comes again after one other task, after three more and after seven more, and from the
/// first of these again where it is wrong once more. A plain value.
class Schedule {
 public:
  /// For at least one kind.
  explicit Schedule(int kinds) : kinds_(static_cast<std::size_t>(kinds)) {}
  /// The kind of the next task, from 0.
  [[nodiscard]] int kind() const;
  /// The task of that kind was answered.
  void answer(bool is_right);
  /// Kinds that come again.
  [[nodiscard]] int repeating() const;

 private:
  struct State {
    int stage = -1;  ///< How often it has come again since it was wrong; -1: it was not.
    int due = 0;     ///< The task that it comes again as.
    int last = -1;   ///< The task that it was last.
    friend bool operator==(const State&, const State&) = default;
  };
  std::vector<State> kinds_;
  int task_ = 0;

 public:
  friend bool operator==(const Schedule&, const Schedule&) = default;
};

}  // namespace gjkscope::practice
