#pragma once
// A signal asks the program to stop: it finishes what it writes first.

#include <csignal>

namespace gjkscope {

/// While it lives, SIGINT and SIGTERM are noted instead of ending the process. Each only once: who
/// asks again is obeyed at once.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  /// The signal that came, or 0.
  [[nodiscard]] static int signal();

 private:
  struct sigaction interrupt_ = {};
  struct sigaction terminate_ = {};
};

}  // namespace gjkscope
