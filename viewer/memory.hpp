#pragma once
// The memory of a reader of lessons, from one start of the window to the next.

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace gjkscope {

struct Memory {
  struct Place {
    std::string lesson;
    int frame = 0;  ///< From 0, where no questions stand between the frames.
    friend bool operator==(const Place&, const Place&) = default;
  };
  /// The run, and the step of it that answers.
  struct Asked {
    std::string lesson;
    int run = 0;
    int step = 0;
    friend auto operator<=>(const Asked&, const Asked&) = default;
  };
  /// Tasks of a chapter: what they were made from, and which were answered rightly.
  struct Practised {
    std::uint64_t seed = 0;
    std::vector<bool> answers;
    friend bool operator==(const Practised&, const Practised&) = default;
  };
  std::set<std::string> finished;  ///< Lessons that were stepped to their end.
  std::optional<Place> stopped;
  std::set<Asked> wrong;               ///< Questions to repeat: not answered right since.
  std::map<int, Practised> practised;  ///< By chapter.
  friend bool operator==(const Memory&, const Memory&) = default;
};

/// One line for each thing, and the reverse; a line that says nothing of the kind is left out.
[[nodiscard]] std::vector<std::string> memory_lines(const Memory& memory);
[[nodiscard]] Memory memory_of(const std::vector<std::string>& lines);

}  // namespace gjkscope
