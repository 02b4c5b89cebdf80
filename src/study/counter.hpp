#pragma once
// The processor's counters, on systems that let a program read them.

#include <cstdint>
#include <optional>

namespace gjkscope::study {

/// Counts what the calling thread does, outside of the kernel, from its construction on.
class Counter {
 public:
  enum class Kind : std::uint8_t {
    instructions,  ///< Retired; only where there are hardware counters.
    nanoseconds,   ///< Processor time; kept by the kernel itself.
  };
  explicit Counter(Kind kind);
  ~Counter();
  Counter(const Counter&) = delete;
  Counter& operator=(const Counter&) = delete;

  /// Nothing where the system does not count.
  [[nodiscard]] std::optional<std::uint64_t> read() const;

 private:
  int file_;
};

}  // namespace gjkscope::study
