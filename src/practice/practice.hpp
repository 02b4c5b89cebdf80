#pragma once
// Practice of a chapter, one task after the other, for whatever shows lessons.

#include <cstdint>

#include "practice/schedule.hpp"
#include "practice/task.hpp"

namespace gjkscope::practice {

class Practice {
 public:
  /// For a chapter that has practice. The same seed and answers give the same tasks.
  Practice(int chapter, std::uint64_t seed)
      : kinds_(kinds_of(chapter)), schedule_(static_cast<int>(kinds_.size())), draws_(seed) {
    make();
  }
  [[nodiscard]] const Task& task() const { return task_; }
  /// The task was answered; the next one is made.
  void answer(bool is_right) {
    schedule_.answer(is_right);
    ++answered_;
    right_ += is_right ? 1 : 0;
    make();
  }
  [[nodiscard]] int chapter() const { return kinds_.front().chapter; }
  [[nodiscard]] int answered() const { return answered_; }
  [[nodiscard]] int right() const { return right_; }
  /// Kinds that went wrong, and come again.
  [[nodiscard]] int repeating() const { return schedule_.repeating(); }

 private:
  void make() {
    task_ = make_task(kinds_[static_cast<std::size_t>(schedule_.kind())], draws_.next());
  }

  std::span<const Kind> kinds_;
  Schedule schedule_;
  Draws draws_;
  Task task_;
  int answered_ = 0;
  int right_ = 0;
};

}  // namespace gjkscope::practice
