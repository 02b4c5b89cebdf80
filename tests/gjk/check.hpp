#pragma once
// Tools for a test program, in one header: the core must prove itself on a machine that has only a
// compiler and Eigen. A program is a list of TESTs, each a claim, and `main` from main.cpp; named
// files of it run alone: gjk-tests simplex_test.

#include <cstdio>
#include <exception>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace check {

/// Failed checks printed for one test; the others are only counted.
inline constexpr int kPrintedFailures = 10;

/// How many of `count` random cases are tried: all where the compiler optimises, a tenth in debug
/// builds and under sanitizers, which take 20 times as long.
[[nodiscard]] constexpr int cases(int count) {
#ifdef NDEBUG
  return count;
#else
  return count / 10;
#endif
}

struct Test {
  std::string_view file;  ///< "simplex_test"
  const char* claim;
  void (*run)();
};

struct Session {
  std::vector<Test> tests;
  std::vector<std::string> arguments;  ///< The command line's arguments besides names of files.
  std::string context;  ///< Named by a failure besides the check: seed, pair, family.
  int failures = 0;     ///< Failures of the running test.
};
[[nodiscard]] inline Session& session() {
  static Session the_session;
  return the_session;
}

struct Registration {
  Registration(std::string_view path, const char* claim, void (*run)()) {
    const std::string_view file = path.substr(path.find_last_of('/') + 1);
    session().tests.push_back({file.substr(0, file.find('.')), claim, run});
  }
};

/// Names the case at hand, "seed 7 pair 12", in every failure until the end of the scope.
class Context {
 public:
  template <class... Parts>
  explicit Context(const Parts&... parts) : outer_(session().context) {
    std::ostringstream text;
    ((text << parts << ' '), ...);
    session().context = outer_ + text.str();
  }
  ~Context() { session().context = outer_; }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

 private:
  std::string outer_;
};

template <class T>
[[nodiscard]] std::string print(const T& value) {
  std::ostringstream text;
  text.precision(21);
  if constexpr (std::is_enum_v<T>) {
    text << static_cast<int>(value);
  } else {
    text << value;
  }
  return text.str();
}

inline void fail(const char* file, int line, const std::string& what) {
  Session& the_session = session();
  if (++the_session.failures > kPrintedFailures) return;
  std::printf("%s:%d: %s%s%s\n", file, line, what.c_str(),
              the_session.context.empty() ? "" : "\n  at ", the_session.context.c_str());
}

template <class E, class A>
void equal(const char* file, int line, const char* text, const E& expected, const A& actual) {
  if (expected == actual) return;
  fail(file, line,
       std::string(text) + "\n  expected " + print(expected) + "\n  actual   " + print(actual));
}

template <class E, class A, class T>
void near(const char* file, int line, const char* text, const E& expected, const A& actual,
          const T& tolerance) {
  const auto error = expected < actual ? actual - expected : expected - actual;
  if (error <= tolerance) return;
  fail(file, line,
       std::string(text) + "\n  expected  " + print(expected) + "\n  actual    " + print(actual) +
           "\n  tolerance " + print(tolerance));
}

}  // namespace check

/// TEST(name, "claim") { ... }
#define TEST(name, claim)                                            \
  static void name();                                                \
  static const check::Registration name##_is(__FILE__, claim, name); \
  static void name()
#define CHECK(...) \
  ((__VA_ARGS__) ? void() : check::fail(__FILE__, __LINE__, "not true: " #__VA_ARGS__))
#define CHECK_EQ(expected, actual) check::equal(__FILE__, __LINE__, #actual, expected, actual)
#define CHECK_NEAR(expected, actual, tolerance) \
  check::near(__FILE__, __LINE__, #actual, expected, actual, tolerance)
