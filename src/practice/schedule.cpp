#include "practice/schedule.hpp"

#include <algorithm>
#include <array>

namespace gjkscope::practice {

namespace {
/// Other tasks before a kind comes again.
constexpr std::array kOthers = {1, 3, 7};
}  // namespace

int Schedule::kind() const {
  // First those that are due, the longest wait first; then those that are asked in turn, the
  // longest since their last task first; then those that wait, the earliest first.
  const auto before = [&](const State& a, const State& b) {
    const auto rank = [&](const State& state) {
      const bool waits = state.stage >= 0;
      return waits ? (state.due <= task_ ? 0 : 2) : 1;
    };
    if (rank(a) != rank(b)) return rank(a) < rank(b);
    return rank(a) == 1 ? a.last < b.last : a.due < b.due;
  };
  return static_cast<int>(std::min_element(kinds_.begin(), kinds_.end(), before) - kinds_.begin());
}

void Schedule::answer(bool is_right) {
  State& state = kinds_[kind()];
  state.last = task_;
  if (!is_right) {
    state.stage = 0;
  } else if (state.stage >= 0) {
    ++state.stage;
  }
  if (state.stage == static_cast<int>(kOthers.size())) state.stage = -1;
  if (state.stage >= 0) state.due = task_ + 1 + kOthers[state.stage];
  ++task_;
}

int Schedule::repeating() const {
  return static_cast<int>(std::count_if(kinds_.begin(), kinds_.end(),
                                        [](const State& state) { return state.stage >= 0; }));
}

}  // namespace gjkscope::practice
