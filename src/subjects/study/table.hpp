#pragma once
// [study]: results of `gjkscope study accuracy`, and those of them that a lesson introduces.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "lesson/tour_settings.hpp"
#include "subjects/study/results.hpp"

namespace gjkscope {

/// A configuration of the study that a lesson introduces.
struct StudyMark {
  std::string configuration;  ///< One of the family's.
  std::string beside;  ///< An earlier mark's, which it is compared with; empty: the one before.
  std::string about;   ///< A few words about it.
  std::string note;    ///< A sentence about it, for the frame that introduces it.
  friend bool operator==(const StudyMark&, const StudyMark&) = default;
};

/// Results of the study of accuracy, read from the file that the table names, and those of them
/// that a lesson introduces one after the other.
struct LessonStudy {
  static constexpr int kMostMarks = 8;  ///< As many as the panel can explain.
  std::string family;                   ///< The family of pairs that is shown.
  std::vector<StudyMark> marks;
  std::shared_ptr<const StudyResults> results;  ///< From the file; shared, as they are many.

  /// The processor that measured.
  [[nodiscard]] const std::string& processor() const { return results->processor; }
  /// The dots of all families.
  [[nodiscard]] const std::vector<StudyDot>& dots() const { return results->dots; }
  /// The dot of a configuration of the family.
  [[nodiscard]] const StudyDot& dot(const std::string& configuration) const {
    return *std::find_if(dots().begin(), dots().end(), [&](const StudyDot& each) {
      return each.family == family && each.configuration == configuration;
    });
  }
  static const SettingsKind kKind;
  friend bool operator==(const LessonStudy& a, const LessonStudy& b) {
    return a.family == b.family && a.marks == b.marks &&
           (a.results == b.results || *a.results == *b.results);
  }
};

}  // namespace gjkscope
