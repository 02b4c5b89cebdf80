#include "lesson/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace gjkscope {

namespace {

/// Lower case, '-' for '_' and ' '.
std::string folded(std::string_view name) {
  std::string out(name);
  for (char& c : out) {
    c = c == '_' || c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return out;
}

/// Edits (insert, delete, replace, swap of neighbours) that turn `a` into `b`: the optimal string
/// alignment distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1);  // row i-2
  std::vector<std::size_t> above(b.size() + 1);   // row i-1
  std::vector<std::size_t> row(b.size() + 1);     // row i
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(above);
    above.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

int character_count(std::string_view utf8) {
  return static_cast<int>(std::count_if(utf8.begin(), utf8.end(), starts_character));
}

std::string to_string(const Problem& problem) {
  std::string out =
      fmt::format("{}:{}:{}: {}", problem.file, problem.line, problem.column, problem.what);
  if (!problem.expected.empty()) out += "; expected " + problem.expected;
  if (!problem.nearest.empty()) out += fmt::format("; did you mean '{}'?", problem.nearest);
  return out;
}

std::string to_string(const std::vector<Problem>& problems) {
  std::string out;
  for (const Problem& problem : problems) out += (out.empty() ? "" : "\n") + to_string(problem);
  return out;
}

std::string in_one_line(const std::vector<Problem>& problems) {
  if (problems.empty()) return "";
  // A slip of the fingers explains what is missing, too.
  const auto helps = std::find_if(problems.begin(), problems.end(),
                                  [](const Problem& each) { return !each.nearest.empty(); });
  const Problem& first = helps == problems.end() ? problems.front() : *helps;
  constexpr std::size_t kShort = 60;
  std::string out;
  if (!first.nearest.empty()) out += fmt::format("did you mean '{}'? ", first.nearest);
  out += fmt::format("{}:{}:{}: {}", first.file.substr(first.file.rfind('/') + 1), first.line,
                     first.column, first.what);
  if (first.nearest.empty() && !first.expected.empty() && first.expected.size() <= kShort)
    out += "; expected " + first.expected;
  if (problems.size() > 1) out += fmt::format(" (and {} more)", problems.size() - 1);
  return out;
}

std::string nearest_name(std::string_view name, const std::vector<std::string>& known) {
  const std::string wanted = folded(name);
  std::string nearest;
  std::size_t smallest = 0;
  for (const std::string& candidate : known) {
    const std::size_t longer = std::max(wanted.size(), candidate.size());
    const std::size_t shorter = std::min(wanted.size(), candidate.size());
    if (longer - shorter > longer / 3) continue;
    const std::size_t distance = edit_distance(wanted, folded(candidate));
    if (distance <= longer / 3 && (nearest.empty() || distance < smallest)) {
      nearest = candidate;
      smallest = distance;
    }
  }
  return nearest;
}

}  // namespace gjkscope
