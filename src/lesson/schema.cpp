#include "lesson/schema.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lesson/keys.hpp"
#include "lesson/settings_kind.hpp"
#include "lesson/vocabulary.hpp"

namespace gjkscope {

std::string text_up_to(int length) { return fmt::format("text of 1 to {} characters", length); }

std::string one_of(const std::vector<std::string>& names) {
  return fmt::format("one of: {}", fmt::join(names, ", "));
}

std::vector<LessonKey> lesson_keys(const std::vector<const Tour*>& tours) {
  std::vector<LessonKey> keys = own_keys();
  for (const SettingsKind* table : settings_of(tours)) {
    std::string uses;
    for (const bool optional : {false, true}) {
      std::vector<const Tour*> takers = tours_with(tours, *table);
      std::erase_if(
          takers, [&](const Tour* tour) { return tour->needs.settings_are_optional != optional; });
      if (!takers.empty()) {
        uses += fmt::format("; {} with tour `{}`", optional ? "optional" : "required",
                            fmt::join(names_of(takers), "`, `"));
      }
    }
    keys.push_back({"", std::string(table->name), fmt::format("table [{}]", table->name), "none",
                    fmt::format("{}{}, refused with any other", table->meaning, uses)});
    const std::vector<LessonKey> more = table->keys();
    keys.insert(keys.end(), more.begin(), more.end());
  }
  return keys;
}

}  // namespace gjkscope
