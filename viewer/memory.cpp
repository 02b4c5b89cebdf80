#include "memory.hpp"

#include <fmt/format.h>

#include <sstream>

namespace gjkscope {
namespace {

void read_practised(const std::string& line, std::map<int, Memory::Practised>& out) {
  std::istringstream words(line);
  int chapter = 0;
  std::string answers;
  Memory::Practised practised;
  if (!(words >> chapter >> practised.seed)) return;
  words >> answers;
  for (const char answer : answers) practised.answers.push_back(answer == '1');
  out[chapter] = std::move(practised);
}

}  // namespace

std::vector<std::string> memory_lines(const Memory& memory) {
  std::vector<std::string> out;
  for (const std::string& lesson : memory.finished) out.push_back("finished " + lesson);
  if (memory.stopped)
    out.push_back(fmt::format("stopped {} {}", memory.stopped->lesson, memory.stopped->frame));
  for (const auto& [lesson, run, step] : memory.wrong)
    out.push_back(fmt::format("wrong {} {} {}", lesson, run, step));
  for (const auto& [chapter, practised] : memory.practised) {
    out.push_back(fmt::format("practised {} {} ", chapter, practised.seed));
    for (const bool is_right : practised.answers) out.back() += is_right ? '1' : '0';
  }
  return out;
}

Memory memory_of(const std::vector<std::string>& lines) {
  Memory out;
  for (const std::string& line : lines) {
    std::istringstream words(line);
    std::string kind;
    std::string lesson;
    words >> kind >> lesson;
    int run = 0;
    int at = 0;
    if (kind == "finished" && !lesson.empty()) out.finished.insert(lesson);
    if (kind == "stopped" && words >> at && at >= 0) out.stopped = {lesson, at};
    if (kind == "wrong" && words >> run >> at) out.wrong.insert({lesson, run, at});
    if (kind == "practised") read_practised(line.substr(kind.size()), out.practised);
  }
  return out;
}

}  // namespace gjkscope
