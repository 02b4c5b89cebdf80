#pragma once
// The record that a file holds of its export: lesson, steps, cases, and what it was made from.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lesson/case.hpp"

namespace gjkscope {

/// The keyword of a record among the texts of a PNG.
inline constexpr const char* kRecordKeyword = "gjkscope";

struct RecordedFrame {
  int step = 1;  ///< From 1.
  std::string caption;
  /// As they stand in the world.
  std::variant<Case, CaseIn<3>> shapes;
};

struct Record {
  std::string lesson;                 ///< Its id,
  std::string toml;                   ///< and its file, from which it can be read again.
  std::string key;                    ///< The Fingerprint of all that the file was made from.
  std::vector<RecordedFrame> frames;  ///< Those that the file shows.
};

/// As JSON in ASCII; coordinates are hexadecimal floats. A frame without a case shows that of the
/// frame before.
[[nodiscard]] std::string record_text(const Record& record);
/// The record in the bytes of a PNG, APNG, SVG, PDF or GIF; nothing where there is none.
[[nodiscard]] std::optional<Record> find_record(std::span<const std::uint8_t> file);

/// Sums up what a file is made from, in 64 bits: equal inputs, equal sums (FNV-1a).
class Fingerprint {
 public:
  void add(std::string_view bytes);
  [[nodiscard]] std::string hex() const;

 private:
  std::uint64_t sum_ = 0xcbf29ce484222325;
};

}  // namespace gjkscope
