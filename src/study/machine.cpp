
#include <fstream>
#include <thread>

#include "study/accuracy.hpp"

namespace gjkscope::study {
namespace {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

}  // namespace

Machine this_machine() {
  return {processor_name(), static_cast<int>(std::thread::hardware_concurrency()),
          GJKSCOPE_COMPILER, GJKSCOPE_FLAGS, GJKSCOPE_COMMIT};
}

}  // namespace gjkscope::study
