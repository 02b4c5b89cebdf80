#include "lesson/toml_patch.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace gjkscope {
namespace {

/// Bytes [begin, end) of a text.
struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;
  [[nodiscard]] std::string_view in(std::string_view text) const {
    return text.substr(begin, end - begin);
  }
};

/// One past the string that begins at `at` with one of the two quotes, or three of them.
std::size_t past_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool is_long = text.substr(at, 3) == three;
  at += is_long ? 3 : 1;
  while (at < text.size()) {
    if (quote == '"' && text[at] == '\\') {
      at += 2;
    } else if (is_long ? text.substr(at, 3) == three : text[at] == quote) {
      at += is_long ? 3 : 1;
      while (is_long && at < text.size() && text[at] == quote) ++at;  // of the text itself
      return at;
    } else {
      ++at;
    }
  }
  return text.size();
}

std::size_t end_of_line(std::string_view text, std::size_t at) {
  return std::min(text.find('\n', at), text.size());
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

Range trimmed(std::string_view text, Range range) {
  while (range.begin < range.end && is_blank(text[range.begin])) ++range.begin;
  while (range.begin < range.end && is_blank(text[range.end - 1])) --range.end;
  return range;
}

/// Walks over a value and what stands inside: `on` gets each character that is neither in a string
/// nor in a comment, with how many brackets are open around it, until it gives false.
template <class On>
std::size_t walk(std::string_view text, std::size_t at, const On& on,
                 std::vector<Range>* comments = nullptr) {
  int depth = 0;
  while (at < text.size()) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = past_string(text, at);
      continue;
    }
    if (c == '#' && depth > 0) {
      const std::size_t end = end_of_line(text, at);
      if (comments) comments->push_back(trimmed(text, {at, end}));
      at = end;
      continue;
    }
    if (c == ']' || c == '}') --depth;
    if (!on(c, depth, at)) return at;
    if (c == '[' || c == '{') ++depth;
    ++at;
  }
  return at;
}

/// The value that begins at `at`: to the end of its line, or to where its brackets close.
Range value_at(std::string_view text, std::size_t at) {
  const std::size_t end = walk(text, at, [](char c, int depth, std::size_t) {
    return depth > 0 || (c != '\n' && c != '#');
  });
  return trimmed(text, {at, end});
}

/// The entries of a list, or of a table between braces; nothing where the value is neither.
std::vector<Range> entries_of(std::string_view text, Range value) {
  std::vector<Range> entries;
  if (value.begin == value.end || (text[value.begin] != '[' && text[value.begin] != '{'))
    return entries;
  const std::string_view inside = text.substr(0, value.end - 1);
  Range entry;  // as far as it goes: comments behind it are no part of it
  bool has_begun = false;
  for (std::size_t at = value.begin + 1; at < inside.size();) {
    const char c = inside[at];
    if (c == '#') {
      at = end_of_line(inside, at);
    } else if (c == ',') {
      if (std::exchange(has_begun, false)) entries.push_back(entry);
      ++at;
    } else if (is_blank(c)) {
      ++at;
    } else {
      if (!std::exchange(has_begun, true)) entry.begin = at;
      if (c == '"' || c == '\'') {
        at = past_string(inside, at);
      } else if (c == '[' || c == '{') {
        at = walk(inside, at,
                  [&](char each, int depth, std::size_t here) {
                    return !(depth == 0 && (each == ']' || each == '}') && here > at);
                  }) +
             1;
      } else {
        ++at;
      }
      entry.end = at;
    }
  }
  if (has_begun) entries.push_back(entry);
  return entries;
}

struct Entry {
  std::string key;
  Range lines;  ///< With the line break.
  Range value;
};

/// A header with the keys below it; the first has none.
struct Section {
  std::string name;  ///< "[[views]]" and its place in the array.
  Range header;      ///< With the line break.
  std::vector<Entry> entries;
  [[nodiscard]] const Entry* find(std::string_view key) const {
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.key == key; });
    return found == entries.end() ? nullptr : &*found;
  }
  /// The offset at which another key goes.
  [[nodiscard]] std::size_t end() const {
    return entries.empty() ? header.end : entries.back().lines.end;
  }
};

std::vector<Section> sections_of(std::string_view text) {
  std::vector<Section> sections(1);
  std::map<std::string, int> places;
  const auto through = [&](std::size_t at) {
    return std::min(end_of_line(text, at) + 1, text.size());
  };
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at;
    while (at < text.size() && (text[at] == ' ' || text[at] == '\t')) ++at;
    if (at == text.size()) break;
    if (text[at] == '#' || text[at] == '\n' || text[at] == '\r') {
      at = through(at);
    } else if (text[at] == '[') {
      const bool is_array = text.substr(at, 2) == "[[";
      const std::size_t end = std::min(text.find(']', at), text.size());
      std::string name;
      for (const char c : text.substr(at, end - at)) {
        if (!is_blank(c)) name += c;
      }
      if (is_array) name += std::to_string(places[name]++);
      at = through(end);
      sections.push_back({name, {begin, at}, {}});
    } else {
      const std::size_t equals = std::min(text.find('=', at), text.size());
      const Range key = trimmed(text, {at, equals});
      const Range value = value_at(text, std::min(equals + 1, text.size()));
      at = through(std::max(value.end, equals));
      sections.back().entries.push_back({std::string(key.in(text)), {begin, at}, value});
    }
  }
  return sections;
}

const Section* find(const std::vector<Section>& sections, const std::string& name) {
  const auto found = std::find_if(sections.begin(), sections.end(),
                                  [&](const Section& each) { return each.name == name; });
  return found == sections.end() ? nullptr : &*found;
}

class Patch {
 public:
  Patch(std::string_view original, std::string_view before, std::string_view after)
      : original_(original), before_(before), after_(after) {}

  std::string apply() {
    const std::vector<Section> here = sections_of(original_);
    const std::vector<Section> was = sections_of(before_);
    const std::vector<Section> wanted = sections_of(after_);
    std::size_t last = 0;  // where a table goes that is not there
    for (const Section& section : wanted) {
      const Section* mine = find(here, section.name);
      if (mine) {
        change(*mine, find(was, section.name), section);
        last = std::max(last, mine->end());
      } else {
        std::string text =
            section.name.empty() ? "" : "\n" + std::string(section.header.in(after_));
        for (const Entry& entry : section.entries) text += entry.lines.in(after_);
        insert(last, text);
      }
    }
    for (const Section& section : was) {
      const Section* mine = find(here, section.name);
      if (!mine || find(wanted, section.name)) continue;
      erase(mine->header);
      for (const Entry& entry : mine->entries) erase(entry.lines);
    }
    return written();
  }

 private:
  struct Edit {
    Range range;
    std::string text;
  };

  void change(const Section& mine, const Section* was, const Section& wanted) {
    std::size_t last = mine.header.end;
    for (const Entry& entry : wanted.entries) {
      const Entry* now = mine.find(entry.key);
      if (now) last = now->lines.end;
      const Entry* old = was ? was->find(entry.key) : nullptr;
      if (old && old->value.in(before_) == entry.value.in(after_)) continue;
      if (!now) {
        insert(last, std::string(entry.lines.in(after_)));
      } else {
        set(*now, old, entry.value);
      }
    }
    for (const Entry& entry : was ? was->entries : std::vector<Entry>()) {
      const Entry* now = mine.find(entry.key);
      if (now && !wanted.find(entry.key)) erase(now->lines);
    }
  }

  void set(const Entry& now, const Entry* old, Range value) {
    const std::vector<Range> mine = entries_of(original_, now.value);
    const std::vector<Range> was = old ? entries_of(before_, old->value) : std::vector<Range>();
    const std::vector<Range> wanted = entries_of(after_, value);
    if (!mine.empty() && mine.size() == was.size() && mine.size() == wanted.size()) {
      for (std::size_t i = 0; i < mine.size(); ++i) {
        if (was[i].in(before_) != wanted[i].in(after_))
          edits_.push_back({mine[i], std::string(wanted[i].in(after_))});
      }
      return;
    }
    std::string above;
    for (const Range& comment : comments_in(now.value))
      above += std::string(comment.in(original_)) + "\n";
    if (!above.empty()) insert(now.lines.begin, above);
    edits_.push_back({now.value, std::string(value.in(after_))});
  }

  [[nodiscard]] std::vector<Range> comments_in(Range value) const {
    std::vector<Range> comments;
    walk(
        original_.substr(0, value.end), value.begin, [](char, int, std::size_t) { return true; },
        &comments);
    return comments;
  }

  void insert(std::size_t at, const std::string& text) { edits_.push_back({{at, at}, text}); }

  /// Lines go, their comments stay.
  void erase(Range lines) {
    const std::string_view text = lines.in(original_);
    std::string comments;
    for (std::size_t at = 0; at < text.size();) {
      if (text[at] == '"' || text[at] == '\'') {
        at = past_string(text, at);
      } else if (text[at] == '#') {
        const std::size_t end = end_of_line(text, at);
        comments += std::string(trimmed(text, {at, end}).in(text)) + "\n";
        at = end;
      } else {
        ++at;
      }
    }
    edits_.push_back({lines, comments});
  }

  /// The original with all edits, none of which overlap.
  std::string written() {
    // Text put between two lines comes before edits of the second one.
    std::stable_sort(edits_.begin(), edits_.end(), [](const Edit& a, const Edit& b) {
      return std::pair(a.range.begin, a.range.end) < std::pair(b.range.begin, b.range.end);
    });
    std::string out;
    std::size_t at = 0;
    for (const Edit& edit : edits_) {
      out += original_.substr(at, edit.range.begin - at);
      const bool is_whole_line = !edit.text.empty() && edit.text.back() == '\n';
      if (is_whole_line && !out.empty() && out.back() != '\n') out += '\n';  // the last line's
      out += edit.text;
      at = edit.range.end;
    }
    return out += original_.substr(at);
  }

  std::string_view original_;
  std::string_view before_;
  std::string_view after_;
  std::vector<Edit> edits_;
};

}  // namespace

std::string patched_toml(std::string_view original, std::string_view before,
                         std::string_view after) {
  return Patch(original, before, after).apply();
}

}  // namespace gjkscope
