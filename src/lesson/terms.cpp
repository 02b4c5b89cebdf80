#include "lesson/terms.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <stdexcept>

namespace gjkscope {
namespace {

bool is_in_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         static_cast<unsigned char>(c) >= 0x80;
}

char small_letter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool begins_with(std::string_view text, std::string_view form) {
  if (text.size() < form.size() || (text.size() > form.size() && is_in_word(text[form.size()])))
    return false;
  return std::equal(form.begin(), form.end(), text.begin(),
                    [](char a, char b) { return small_letter(a) == small_letter(b); });
}

}  // namespace

std::vector<CourseTerm> parse_terms(std::string_view text, std::string_view name) {
  const auto fail = [&](const toml::source_region& at, std::string_view what) {
    throw std::runtime_error(
        fmt::format("{}:{}:{}: {}; expected [term] with 'lesson', 'sentence' and, if it has other "
                    "forms, 'forms'",
                    name, at.begin.line, at.begin.column, what));
  };
  const auto text_in = [&](const toml::node& node) {
    const toml::value<std::string>* value = node.as_string();
    if (value == nullptr) fail(node.source(), "this is no text");
    return value->get();
  };
  std::vector<CourseTerm> terms;
  try {
    const toml::table file = toml::parse(text);
    for (const auto& [key, node] : file) {
      const toml::table* table = node.as_table();
      if (table == nullptr) fail(node.source(), fmt::format("'{}' is no table", key.str()));
      CourseTerm& term =
          terms.emplace_back(CourseTerm{std::string(key.str()), {std::string(key.str())}, {}, {}});
      for (const auto& [what, value] : *table) {
        if (what == "lesson") {
          term.lesson = text_in(value);
        } else if (what == "sentence") {
          term.sentence = text_in(value);
        } else if (what == "forms" && value.is_array()) {
          for (const toml::node& form : *value.as_array()) term.forms.push_back(text_in(form));
        } else {
          fail(what.source(), fmt::format("'{}' is not known here", what.str()));
        }
      }
      if (term.lesson.empty() || term.sentence.empty())
        fail(node.source(), fmt::format("'{}' lacks a lesson or a sentence", term.name));
    }
  } catch (const toml::parse_error& error) {
    fail(error.source(), error.description());
  }
  return terms;
}

std::vector<FoundTerm> find_terms(std::string_view text, const std::vector<CourseTerm>& terms) {
  std::vector<FoundTerm> found;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (at > 0 && is_in_word(text[at - 1])) continue;
    FoundTerm longest{at, at, nullptr};
    for (const CourseTerm& term : terms) {
      for (const std::string& form : term.forms) {
        if (form.size() > longest.end - at && begins_with(text.substr(at), form))
          longest = {at, at + form.size(), &term};
      }
    }
    if (longest.term == nullptr) continue;
    found.push_back(longest);
    at = longest.end - 1;
  }
  return found;
}

}  // namespace gjkscope
