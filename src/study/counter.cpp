#include "study/counter.hpp"

#ifdef __linux__
#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace gjkscope::study {

#ifdef __linux__

Counter::Counter(Kind kind) {
  perf_event_attr wanted = {};
  wanted.size = sizeof wanted;
  const bool is_hardware = kind == Kind::instructions;
  wanted.type = is_hardware ? PERF_TYPE_HARDWARE : PERF_TYPE_SOFTWARE;
  wanted.config = is_hardware ? std::uint64_t{PERF_COUNT_HW_INSTRUCTIONS}
                              : std::uint64_t{PERF_COUNT_SW_TASK_CLOCK};
  wanted.exclude_kernel = 1;
  wanted.exclude_hv = 1;
  constexpr int kThisThread = 0;
  constexpr int kAnyProcessor = -1;
  constexpr int kNoGroup = -1;
  file_ = static_cast<int>(
      ::syscall(SYS_perf_event_open, &wanted, kThisThread, kAnyProcessor, kNoGroup, 0ul));
}

Counter::~Counter() {
  if (file_ >= 0) ::close(file_);
}

std::optional<std::uint64_t> Counter::read() const {
  std::uint64_t count = 0;
  if (file_ < 0 || ::read(file_, &count, sizeof count) != sizeof count) return std::nullopt;
  return count;
}

#else

Counter::Counter(Kind) : file_(-1) {}
Counter::~Counter() = default;
std::optional<std::uint64_t> Counter::read() const { return std::nullopt; }

#endif

}  // namespace gjkscope::study
