#pragma once
// The shipped lessons, loaded and run, for tests of whatever stands on them.

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "lesson/load.hpp"
#include "run/effect_info.hpp"
#include "run/run.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::testing {

inline std::vector<Lesson> shipped_lessons() {
  std::vector<Lesson> lessons;
  for (const LoadedLesson& loaded :
       load_lessons(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "lessons", vocabulary())) {
    for (const Problem& problem : loaded.problems) ADD_FAILURE() << to_string(problem);
    if (loaded.lesson) lessons.push_back(*loaded.lesson);
  }
  return lessons;
}

/// All of them where the compiler optimises; one in four under sanitizers and in debug builds,
/// which are slow.
inline std::vector<Lesson> lessons_for_long_tests() {
#ifdef NDEBUG
  constexpr std::size_t kOneIn = 1;
#else
  constexpr std::size_t kOneIn = 4;
#endif
  const std::vector<Lesson> all = shipped_lessons();
  std::vector<Lesson> lessons;
  for (std::size_t i = 0; i < all.size(); i += kOneIn) lessons.push_back(all[i]);
  return lessons;
}

inline Lesson shipped_lesson(const std::string& id) {
  for (const Lesson& lesson : shipped_lessons()) {
    if (lesson.id == id) return lesson;
  }
  ADD_FAILURE() << "no lesson " << id;
  return {};
}

/// Its frames alone that tell, without what leads to the next lesson.
inline Lesson lesson_without_questions(const std::string& id) {
  Lesson lesson = shipped_lesson(id);
  lesson.questions.clear();
  lesson.next.clear();
  return lesson;
}

}  // namespace gjkscope::testing
