// A library as a program for `gjkscope judge --program`: cases on standard input, one a line,
// answers on standard output.

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <iostream>

#include "lesson/case.hpp"
#include "libraries.hpp"

namespace {

using namespace bench;

template <int D>
std::vector<Library<D>> libraries() {
  std::vector<Library<D>> out = peers<D>(Peers::all);
  out.insert(out.begin(), {core_double<D>(), core_float<D>()});
  return out;
}

/// The answer of the library whose name begins so, as JSON.
template <int D>
std::string answer(std::string_view name, const gjkscope::CaseIn<D>& value) {
  static const std::vector<Library<D>> all = libraries<D>();
  for (const Library<D>& library : all) {
    if (!library.name.starts_with(name)) continue;
    if (std::max(value.a.size(), value.b.size()) > library.max_vertices)
      return R"({"error":"too many vertices"})";
    const std::vector<Pair<D>> pairs = {{value.a, value.b}};
    const double distance = library.prepare(pairs).answer(0);
    if (distance == kGaveUp) return R"({"error":"gave up"})";
    if (!library.measures) return fmt::format(R"({{"overlap":{}}})", distance == 0);
    return std::isfinite(distance) ? fmt::format(R"({{"distance":{}}})", distance)
                                   : R"({"distance":null})";
  }
  return R"({"error":"there is no such library in this dimension"})";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: peer LIBRARY, where LIBRARY is how one of these names begins:\n");
    for (const auto& library : libraries<2>()) fmt::print(stderr, "  {}\n", library.name);
    for (const auto& library : libraries<3>()) fmt::print(stderr, "  {}, in space\n", library.name);
    return 2;
  }
  for (std::string line; std::getline(std::cin, line);) {
    const std::vector<gjkscope::ReadCase> read = gjkscope::parse_cases(line, "<stdin>", 3);
    const auto& one = read.front();
    fmt::print("{}\n", one.value      ? answer<2>(argv[1], *one.value)
                       : one.in_space ? answer<3>(argv[1], *one.in_space)
                                      : std::string(R"({"error":"this is no case"})"));
    std::fflush(stdout);
  }
}
