#include "lesson/vocabulary.hpp"

#include <algorithm>
#include <iterator>

#include "lesson/settings_kind.hpp"

namespace gjkscope {

std::vector<std::string_view> TourNeeds::required_tables() const {
  std::vector<std::string_view> names;
  if (path == PathUse::needed) names.emplace_back("path");
  if (settings != nullptr && !settings_are_optional) names.push_back(settings->name);
  return names;
}

const AskInfo* Tour::ask(std::string_view asked) const {
  const auto found = std::find_if(asks.begin(), asks.end(),
                                  [&](const AskInfo& each) { return each.name == asked; });
  return found == asks.end() ? nullptr : &*found;
}

const Tour* Vocabulary::tour(std::string_view name) const {
  const auto found = std::find_if(tours.begin(), tours.end(),
                                  [&](const Tour* each) { return each->name == name; });
  return found == tours.end() ? nullptr : *found;
}

bool has_settings(const Lesson& lesson, std::string_view name) {
  const SettingsKind* kind = lesson.settings.kind();
  return name.empty() || (kind != nullptr && kind->name == name);
}

const Term* find_term(const std::vector<Term>& terms, std::string_view name) {
  const auto found =
      std::find_if(terms.begin(), terms.end(), [&](const Term& term) { return term.name == name; });
  return found == terms.end() ? nullptr : &*found;
}

std::vector<std::string> names_of(const std::vector<Term>& terms) {
  std::vector<std::string> names;
  for (const Term& term : terms) names.emplace_back(term.name);
  return names;
}

std::vector<std::string> names_of(const std::vector<const Tour*>& tours) {
  std::vector<std::string> names;
  for (const Tour* tour : tours) names.emplace_back(tour->name);
  return names;
}

std::vector<const SettingsKind*> settings_of(const std::vector<const Tour*>& tours) {
  std::vector<const SettingsKind*> kinds;
  for (const Tour* tour : tours) {
    const SettingsKind* kind = tour->needs.settings;
    if (kind != nullptr && std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
      kinds.push_back(kind);
  }
  return kinds;
}

std::vector<const Tour*> tours_with(const std::vector<const Tour*>& tours,
                                    const SettingsKind& kind) {
  std::vector<const Tour*> out;
  std::copy_if(tours.begin(), tours.end(), std::back_inserter(out),
               [&](const Tour* tour) { return tour->needs.settings == &kind; });
  return out;
}

}  // namespace gjkscope
