#pragma once
#include <filesystem>
#include <stdexcept>
#include <utility>
#include <vector>

#include "lesson/load.hpp"
#include "subjects/subjects.hpp"

namespace bench {

/// Throws std::runtime_error with the first problem of one that cannot be loaded.
inline std::vector<gjkscope::Lesson> shipped_lessons() {
  std::vector<gjkscope::Lesson> lessons;
  for (gjkscope::LoadedLesson& loaded : gjkscope::load_lessons(
           std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "lessons", gjkscope::vocabulary())) {
    if (!loaded.lesson) throw std::runtime_error(to_string(loaded.problems.front()));
    lessons.push_back(std::move(*loaded.lesson));
  }
  return lessons;
}

}  // namespace bench
