#include "check.hpp"

int main(int argc, char** argv) {
  check::Session& session = check::session();
  session.arguments.assign(argv + 1, argv + argc);
  int failed = 0;
  for (const check::Test& test : session.tests) {
    session.failures = 0;
    session.silent = test.must_fail;
    try {
      test.run();
    } catch (const std::exception& error) {
      check::fail(__FILE__, __LINE__, std::string("unexpected exception: ") + error.what());
    }
    const bool as_expected = (session.failures > 0) == test.must_fail;
    const char* outcome = !as_expected ? "FAILED" : test.must_fail ? "defect" : "ok    ";
    std::printf("%s  %s\n", outcome, test.claim);
    if (test.must_fail && !as_expected) std::printf("  the defect is gone: make it a TEST\n");
    if (session.failures > check::kPrintedFailures) {
      std::printf("  %d checks failed in all\n", session.failures);
    }
    failed += as_expected ? 0 : 1;
  }
  std::printf("%zu tests, %d failed\n", session.tests.size(), failed);
  return failed == 0 ? 0 : 1;
}
