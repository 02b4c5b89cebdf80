#include "memory.hpp"

#include <fmt/format.h>

#include <sstream>

namespace gjkscope {

std::vector<std::string> memory_lines(const Memory& memory) {
  std::vector<std::string> out;
  for (const std::string& lesson : memory.finished) out.push_back("finished " + lesson);
  if (memory.stopped)
    out.push_back(fmt::format("stopped {} {}", memory.stopped->lesson, memory.stopped->frame));
  for (const auto& [lesson, run, step] : memory.wrong)
    out.push_back(fmt::format("wrong {} {} {}", lesson, run, step));
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
  }
  return out;
}

}  // namespace gjkscope
