#include "picture/term_spots.hpp"

#include <algorithm>
#include <string>

#include "picture/text_box.hpp"

namespace gjkscope {
namespace {

/// Whether `text` is the line below `above`, of the same words.
bool goes_on(const Mark& above, const Mark& mark) {
  constexpr double kMost = 1.6;  // ems between base lines
  const Text& last = std::get<Text>(above.shape);
  const Text* text = std::get_if<Text>(&mark.shape);
  if (text == nullptr || mark.role != above.role || text->style != last.style) return false;
  const double down = text->at.y() - last.at.y();
  return text->at.x() == last.at.x() && down > 0.0 && down < kMost * text->style.size;
}

Rect box_of_part(const Fonts& fonts, const Text& line, std::size_t begin, std::size_t end) {
  constexpr double kAbove = 0.9;  // ems, from the base line
  constexpr double kBelow = 0.3;
  const double size = line.style.size;
  const std::string_view words = line.text;
  const double left = box_of(fonts, line).min.x();
  return {{left + fonts.width(line.style, words.substr(0, begin)), line.at.y() - kAbove * size},
          {left + fonts.width(line.style, words.substr(0, end)), line.at.y() + kBelow * size}};
}

}  // namespace

std::vector<TermSpot> term_spots(const Picture& picture, const Fonts& fonts,
                                 const std::vector<CourseTerm>& terms) {
  std::vector<TermSpot> spots;
  const std::vector<Mark>& marks = picture.marks;
  for (std::size_t next = 0; next < marks.size();) {
    const std::size_t first = next++;
    if (!std::holds_alternative<Text>(marks[first].shape)) continue;
    std::string words = std::get<Text>(marks[first].shape).text;
    for (; next < marks.size() && goes_on(marks[next - 1], marks[next]); ++next)
      words += " " + std::get<Text>(marks[next].shape).text;
    for (const FoundTerm& found : find_terms(words, terms)) {
      std::size_t start = 0;  // of the line
      for (std::size_t i = first; i < next; ++i) {
        const Text& line = std::get<Text>(marks[i].shape);
        const std::size_t begin = std::max(found.begin, start);
        const std::size_t end = std::min(found.end, start + line.text.size());
        if (begin < end)
          spots.push_back({box_of_part(fonts, line, begin - start, end - start), found.term});
        start += line.text.size() + 1;
      }
    }
  }
  return spots;
}

}  // namespace gjkscope
