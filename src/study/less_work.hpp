#pragma once
// Does doing less ever cost more? Of some pairs of configurations one does part of the other's
// work. Where it takes longer all the same, the study says so, and why.

#include <limits>
#include <string>
#include <vector>

#include "study/accuracy.hpp"
#include "study/answer.hpp"

namespace gjkscope::study {

/// The work behind the timed answers: averages over the queries.
struct Work {
  double iterations = 0.0;
  double support_queries = 0.0;
  double start_vertices = 1.0;  ///< Vertices of the first simplex.
  double settled = 0.0;         ///< The share of queries on which exact arithmetic ran on.
  double instructions = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not counted.
};
[[nodiscard]] Work work_of(const std::vector<Answer>& answers);

struct Contender {
  Configuration configuration;
  Work work;
};

/// True when `less` does part of what `more` does: in the same arithmetic and by the same rules it
/// proves no more, has no larger cap, no tighter tolerance (0 is the tightest: run to the end), no
/// stop test that the other lacks, the same start, is not the same in all of these, and took no
/// more iterations and support queries. A warm start does part of a cold one's work only in motion,
/// where each pair is the one before, a moment later, and only if it took fewer iterations.
[[nodiscard]] bool does_less(const Contender& less, const Contender& more, bool in_motion);

/// Why `less` may take longer than `more` all the same, by what was counted.
[[nodiscard]] std::string reason_for(const Contender& less, const Contender& more);

/// A configuration that does less is listed when it took more than this many times as long in at
/// least three quarters of the repetitions: when the lower quartile of the ratio is above it.
inline constexpr double kCostlier = 1.05;

/// Compares all contenders on a family, `timings` in the same order.
void compare_work(const std::vector<Contender>& contenders, const std::vector<Timing>& timings,
                  const Family& family, Study& study);

/// Two configurations of which the first does less and takes longer, over all families in which it
/// does.
struct CostlierPair {
  std::string less;
  std::string more;
  std::vector<std::string> families;
  double least = 0.0;  ///< The least of the median ratios,
  double most = 0.0;
  std::string reason;  ///< where it is largest.
};
/// The largest ratio first.
[[nodiscard]] std::vector<CostlierPair> costlier_pairs(const Study& study);
/// "1.07", "1.07 to 1.31"
[[nodiscard]] std::string ratios_text(const CostlierPair& pair);
/// Says in whole sentences what was compared, by which rule a pair is listed, and how many are.
[[nodiscard]] std::string costlier_about(const Study& study);

}  // namespace gjkscope::study
