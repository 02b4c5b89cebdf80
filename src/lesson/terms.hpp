#pragma once
// Terms of the course: assets/terms.toml.

#include <string>
#include <string_view>
#include <vector>

namespace gjkscope {

struct CourseTerm {
  std::string name;
  std::vector<std::string> forms;  ///< All that texts may call it, the name among them.
  std::string lesson;              ///< Id of the lesson that says the sentence.
  std::string sentence;
};

/// Throws std::runtime_error, with the place, where the text is not of this form; `name` stands for
/// the file.
[[nodiscard]] std::vector<CourseTerm> parse_terms(std::string_view text, std::string_view name);

struct FoundTerm {
  std::size_t begin = 0;
  std::size_t end = 0;
  const CourseTerm* term = nullptr;  ///< One of those that were looked for.
};

/// The terms that a text uses, in order. They are whole words, small or capital; of forms that
/// begin at the same word the longest counts.
[[nodiscard]] std::vector<FoundTerm> find_terms(std::string_view text,
                                                const std::vector<CourseTerm>& terms);

}  // namespace gjkscope
