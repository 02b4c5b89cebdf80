#pragma once
// A program on trial: families of pairs that it is asked about, and what it gets wrong.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lesson/names.hpp"
#include "trial/program.hpp"

namespace gjkscope::judging {

/// The fault of an answer. docs/judge-program.md says when each holds.
enum class Fault : std::uint8_t {
  none,
  missed,
  invented,
  inaccurate,
  points,
  depth,
  not_finite,
  gave_up,
  nonsense,
  silent,
  crashed,
};
inline constexpr int kFaultCount = 11;

struct TrialOptions {
  std::string command;
  std::vector<std::string> families;  ///< By name; empty: all.
  int dimension = 0;                  ///< 2, 3, or 0 for both.
  int pairs = 2000;                   ///< In each family.
  std::uint64_t seed = 1;
  bool reduces = true;    ///< The smallest failing case is looked for.
  bool in_float = false;  ///< Coordinates are floats, and so may be what the program computes in.
  Patience patience;
};

/// The smallest case that the program fails on.
struct FailingCase {
  Fault fault = Fault::none;
  std::string text;    ///< The case, as JSON.
  std::string answer;  ///< The program's, or how it ended.
  double distance = 0;
  double depth = 0;  ///< The true one, if that is the fault.
};

struct FamilyTrial {
  std::string family;
  int dimension = 2;
  int asked = 0;
  std::array<int, kFaultCount> faults = {};
  double worst = 0;  ///< The largest relative error.
  std::optional<FailingCase> smallest;
};

/// Tries all families in turn, and calls `each` after each of them. Stops, and says why, after a
/// family without any answer.
[[nodiscard]] std::string try_program(const TrialOptions& options,
                                      const std::function<void(const FamilyTrial&)>& each);

/// "3 m, 1 r"; "." where there is none.
[[nodiscard]] std::string faults_text(const FamilyTrial& trial);

/// Names of the families, of the plane or of both.
[[nodiscard]] std::vector<std::string> family_names();

}  // namespace gjkscope::judging

template <>
struct gjkscope::Named<gjkscope::judging::Fault> {
  using Fault = gjkscope::judging::Fault;
  static constexpr std::array<std::pair<std::string_view, Fault>, 10> kTable = {
      {{"missed", Fault::missed},
       {"invented", Fault::invented},
       {"inaccurate", Fault::inaccurate},
       {"points", Fault::points},
       {"depth", Fault::depth},
       {"not-finite", Fault::not_finite},
       {"gave-up", Fault::gave_up},
       {"nonsense", Fault::nonsense},
       {"silent", Fault::silent},
       {"crashed", Fault::crashed}}};
};
