#include "lesson/vocabulary.hpp"

#include <algorithm>
#include <iterator>

#include "lesson/table_kind.hpp"

namespace gjkscope {

std::vector<std::string_view> ActNeeds::required_tables() const {
  std::vector<std::string_view> names;
  if (path == PathUse::needed) names.emplace_back("path");
  if (table != nullptr && !table_is_optional) names.push_back(table->name);
  return names;
}

const AskInfo* Act::ask(std::string_view asked) const {
  const auto found = std::find_if(asks.begin(), asks.end(),
                                  [&](const AskInfo& each) { return each.name == asked; });
  return found == asks.end() ? nullptr : &*found;
}

const Act* Vocabulary::act(std::string_view name) const {
  const auto found =
      std::find_if(acts.begin(), acts.end(), [&](const Act* each) { return each->name == name; });
  return found == acts.end() ? nullptr : *found;
}

bool has_table(const Lesson& lesson, std::string_view name) {
  const TableKind* kind = lesson.table.kind();
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

std::vector<std::string> names_of(const std::vector<const Act*>& acts) {
  std::vector<std::string> names;
  for (const Act* act : acts) names.emplace_back(act->name);
  return names;
}

std::vector<const TableKind*> tables_of(const std::vector<const Act*>& acts) {
  std::vector<const TableKind*> tables;
  for (const Act* act : acts) {
    const TableKind* table = act->needs.table;
    if (table != nullptr && std::find(tables.begin(), tables.end(), table) == tables.end())
      tables.push_back(table);
  }
  return tables;
}

std::vector<const Act*> acts_with(const std::vector<const Act*>& acts, const TableKind& table) {
  std::vector<const Act*> out;
  std::copy_if(acts.begin(), acts.end(), std::back_inserter(out),
               [&](const Act* act) { return act->needs.table == &table; });
  return out;
}

}  // namespace gjkscope
