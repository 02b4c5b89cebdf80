#pragma once
// Error against time, for everything that buys accuracy: each configuration answers the pairs of
// each family, is judged by the exact truth, and timed beside the others.

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "study/configuration.hpp"
#include "study/family.hpp"
#include "study/interleave.hpp"

namespace gjkscope::study {

/// The pair that a configuration answers worst.
struct WorstCase {
  std::string json;       ///< For `gjkscope solve` and `gjkscope trace`.
  double answer = 0.0;    ///< The distance that it gave; NaN where it gave none.
  double distance = 0.0;  ///< The exact one, rounded.
};

/// One configuration on one family. Errors are the largest seen over all pairs. `error` is
/// |answer - distance| as a share of the larger of the two: 0 is exact, 1 is not one digit right.
/// Those named `..._scale` are divided by the scale of their pair, the largest distance between a
/// vertex of X and one of Y.
struct Row {
  std::string family;
  int vertices = 0;  ///< See Family.
  std::string configuration;
  std::string axis;
  std::string proof;  ///< See proof_name.

  int pairs = 0;
  int timed_pairs = 0;  ///< The first so many were timed.
  int repetitions = 0;  ///< Each asks about every timed pair.
  Quartiles ns;         ///< Per query. Without repetitions all of these are 0.
  Quartiles ratio;      ///< To the default configuration, repetition by repetition.
  double instructions = std::numeric_limits<double>::quiet_NaN();  ///< Per query; see Counter.
  double iterations = 0.0;                                         ///< On average.
  int most_iterations = 0;
  int settled = 0;  ///< Pairs on which exact arithmetic had to run on.

  int failed = 0;         ///< Pairs without an answer, or with one that is no number.
  int undecided = 0;      ///< The answer leaves open whether the shapes overlap.
  int wrong = 0;          ///< It says so wrongly, of the pair as it was given,
  int wrong_as_kept = 0;  ///< of the pair as the configuration keeps it.
  int broken_bounds = 0;  ///< The distance does not lie between the bounds.

  /// For the pairs as they were given; infinity when there is a pair without answer.
  double error = 0.0;
  double error_scale = 0.0;
  double middle_error_scale = 0.0;  ///< The median over the pairs that have an answer.
  /// For the pairs as they are kept: the error of computing alone.
  double error_as_kept = 0.0;
  double error_units = 0.0;    ///< In units of u * scale, u of the type of the answer.
  double witness_scale = 0.0;  ///< See Judgement::witness.
  double width_scale = 0.0;    ///< The width of the bounds; NaN without bounds.

  bool on_front = false;  ///< See mark_front.
  WorstCase worst;
};

/// The machine and the program that measured.
struct Machine {
  std::string processor;
  int threads = 0;  ///< The machine's threads; the study uses one.
  std::string compiler;
  std::string flags;
  std::string commit;  ///< When the program was configured.
};
[[nodiscard]] Machine this_machine();

/// A configuration that does part of another's work and takes longer; see less_work.hpp.
struct Costlier {
  std::string family;
  std::string less;
  std::string more;
  Quartiles ratio;     ///< The time of `less` to that of `more`, repetition by repetition.
  std::string reason;  ///< By what was counted.
};

struct Plan {
  std::uint64_t seed = 1;
  bool quick = false;
  Sizes sizes;
  double seconds_per_family = 7.0;    ///< Seconds of timing, about.
  double seconds_per_turn = 2e-4;     ///< At least: shorter ones are at the mercy of the clock.
  std::vector<Case> reported;         ///< See families_of.
  std::vector<std::string> families;  ///< Names of those that are asked about; empty: all.
};
[[nodiscard]] Plan plan(bool quick);

struct Study {
  Machine machine;
  std::uint64_t seed = 0;
  bool quick = false;
  bool complete = true;  ///< It was not interrupted.
  int families_planned = 0;
  double seconds = 0.0;
  std::vector<Row> rows;
  int compared = 0;  ///< Pairs of configurations, family by family, of which one does less.
  std::vector<Costlier> costlier;
};

struct Watch {
  std::function<bool()> go_on = [] { return true; };
  /// How much is done, from 0 to 1, and what is being done.
  std::function<void(double share, const std::string& what)> tell = [](double, const std::string&) {
  };
};

/// The families that the plan asks about. Throws std::runtime_error for a name that none has.
[[nodiscard]] std::vector<Family> families_of(const Plan& plan);

/// All but times and instructions depends on the plan alone. Ended early by `watch`, it has the
/// rows of the families that were done, and of the one that was being timed.
[[nodiscard]] Study study_accuracy(const Plan& plan, const Watch& watch = {});

/// The rows of a family without times: what `study_accuracy` has for it, for these configurations
/// alone. `seed` is for the names of the worst cases.
[[nodiscard]] std::vector<Row> judged_rows(const Family& family,
                                           const std::vector<Configuration>& configurations,
                                           std::uint64_t seed);

/// Sets `on_front` in the rows of each family: see front_of. Their order is that of
/// `configurations`, the plainest first.
void mark_front(std::vector<Row>& rows);

/// Rows by family, in order of their first appearance.
[[nodiscard]] std::vector<std::vector<const Row*>> by_family(const std::vector<Row>& rows);

}  // namespace gjkscope::study
