#include <algorithm>

#include "check.hpp"

int main(int argc, char** argv) {
  check::Session& session = check::session();
  std::vector<std::string_view> chosen;
  for (const std::string_view argument : std::vector<std::string_view>(argv + 1, argv + argc)) {
    const bool is_file =
        std::any_of(session.tests.begin(), session.tests.end(),
                    [&](const check::Test& test) { return test.file == argument; });
    if (!is_file && argument.ends_with("_test")) {
      std::printf("no file of tests is called %.*s\n", static_cast<int>(argument.size()),
                  argument.data());
      return 2;
    }
    if (is_file)
      chosen.push_back(argument);
    else
      session.arguments.emplace_back(argument);
  }
  if (!chosen.empty()) {
    std::erase_if(session.tests, [&](const check::Test& test) {
      return std::find(chosen.begin(), chosen.end(), test.file) == chosen.end();
    });
  }
  int failed = 0;
  for (const check::Test& test : session.tests) {
    session.failures = 0;
    try {
      test.run();
    } catch (const std::exception& error) {
      check::fail(__FILE__, __LINE__, std::string("unexpected exception: ") + error.what());
    }
    const bool passed = session.failures == 0;
    std::printf("%s  %s\n", passed ? "ok    " : "FAILED", test.claim);
    if (session.failures > check::kPrintedFailures) {
      std::printf("  %d checks failed in all\n", session.failures);
    }
    failed += passed ? 0 : 1;
  }
  std::printf("%zu tests, %d failed\n", session.tests.size(), failed);
  return failed == 0 ? 0 : 1;
}
