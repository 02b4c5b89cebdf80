#include "cli/transcript.hpp"

#include <fmt/format.h>

#include <string_view>

#include "frames/frame.hpp"

namespace gjkscope {
namespace {

/// A text in which Markdown finds nothing to interpret.
std::string plain_in_markdown(std::string_view text) {
  constexpr std::string_view kMarkup = "\\`*_[]<>#|~&";
  std::string out;
  for (const char c : text) {
    if (kMarkup.find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

}  // namespace

std::string transcript(const LessonRun& run, bool markdown) {
  const Lesson& lesson = run.lesson;
  EffectGraph effects(run);
  const std::vector<FrameText> texts = lesson_texts(run, effects);
  const auto plain = [&](const std::string& text) {
    return markdown ? plain_in_markdown(text) : text;
  };
  const std::string chapter = fmt::format("Chapter {}{}", lesson.chapter,
                                          lesson.source.empty() ? "" : ", " + lesson.source);
  std::string prose = texts.empty() ? "" : texts.front().prose;
  std::string out = fmt::format("{}{}\n{}{}\n\n{}\n\n", markdown ? "# " : "", plain(lesson.title),
                                markdown ? "\n" : "", plain(chapter), plain(prose));
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const FrameText& text = texts[i];
    const std::string number = fmt::format("{}.", i + 1);
    // In a list of Markdown, what belongs to an entry stands as far in as its text.
    const std::string indent(number.size() + 1, ' ');
    const std::string position = plain(text.position);
    out += markdown ? fmt::format("{} **{}**  \n", number, position)
                    : fmt::format("{} {}\n", number, position);
    if (text.prose != prose) {
      prose = text.prose;
      out += fmt::format("{}{}{}\n", indent, plain(prose), markdown ? "  " : "");
    }
    out += indent + plain(alternative_text(text)) + "\n";
  }
  return out;
}

}  // namespace gjkscope
