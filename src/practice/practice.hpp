#pragma once
// Practice of a chapter, one task after the other, for whatever shows lessons.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "practice/schedule.hpp"
#include "practice/task.hpp"

namespace gjkscope::practice {

class Practice {
 public:
  /// For a chapter that has practice, where so many tasks were answered, rightly or not. The same
  /// seed and answers give the same tasks.
  explicit Practice(int chapter, std::uint64_t seed, const std::vector<bool>& answers = {})
      : kinds_(kinds_of(chapter)),
        seed_(seed),
        schedule_(static_cast<int>(kinds_.size())),
        draws_(seed) {
    for (const bool is_right : answers) {
      static_cast<void>(draws_.next());  // the seed of the task
      take(is_right);
    }
    make();
  }
  [[nodiscard]] const Task& task() const { return task_; }
  /// The task was answered; the next one is made.
  void answer(bool is_right) {
    take(is_right);
    make();
  }
  [[nodiscard]] int chapter() const { return kinds_.front().chapter; }
  [[nodiscard]] std::uint64_t seed() const { return seed_; }
  /// True for each task that was answered rightly.
  [[nodiscard]] const std::vector<bool>& answers() const { return answers_; }
  [[nodiscard]] int right() const {
    return static_cast<int>(std::count(answers_.begin(), answers_.end(), true));
  }
  /// Kinds that went wrong, and come again.
  [[nodiscard]] int repeating() const { return schedule_.repeating(); }

 private:
  void take(bool is_right) {
    schedule_.answer(is_right);
    answers_.push_back(is_right);
  }
  void make() { task_ = make_task(kinds_[schedule_.kind()], draws_.next()); }

  std::span<const Kind> kinds_;
  std::uint64_t seed_;
  Schedule schedule_;
  Draws draws_;
  std::vector<bool> answers_;
  Task task_;
};

}  // namespace gjkscope::practice
