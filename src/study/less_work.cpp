#include "study/less_work.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace gjkscope::study {
namespace {

/// All but the start.
bool has_same_settings(const gjk::Options& a, const gjk::Options& b) {
  return a.stop_on_repeated_support == b.stop_on_repeated_support &&
         a.stop_on_no_progress == b.stop_on_no_progress && a.tolerance == b.tolerance &&
         a.iteration_cap == b.iteration_cap && a.proof == b.proof;
}

/// Nothing that `a` asks for goes beyond what `b` asks for.
bool asks_no_more(const gjk::Options& a, const gjk::Options& b) {
  return a.direction_rule == b.direction_rule && a.region_order == b.region_order &&
         (b.stop_on_repeated_support || !a.stop_on_repeated_support) &&
         (b.stop_on_no_progress || !a.stop_on_no_progress) && a.tolerance >= b.tolerance &&
         a.iteration_cap <= b.iteration_cap && a.proof <= b.proof;
}

}  // namespace

Work work_of(const std::vector<Answer>& answers) {
  Work sum;
  sum.start_vertices = 0.0;
  for (const Answer& answer : answers) {
    sum.iterations += answer.iterations;
    sum.support_queries += answer.support_queries;
    sum.start_vertices += answer.start_vertices;
    sum.settled += answer.settled;
  }
  const double share = answers.empty() ? 0.0 : 1.0 / static_cast<double>(answers.size());
  return {share * sum.iterations, share * sum.support_queries, share * sum.start_vertices,
          share * sum.settled, sum.instructions};
}

bool does_less(const Contender& less, const Contender& more, bool in_motion) {
  const Configuration& a = less.configuration;
  const Configuration& b = more.configuration;
  if (a.arithmetic != b.arithmetic || !asks_no_more(a.options, b.options)) return false;
  if (less.work.iterations > more.work.iterations ||
      less.work.support_queries > more.work.support_queries) {
    return false;
  }
  if (a.start == b.start) return !has_same_settings(a.options, b.options);
  const bool warm_against_cold = a.start == Start::warm && b.start != Start::warm;
  return warm_against_cold && in_motion && less.work.iterations < more.work.iterations;
}

std::string reason_for(const Contender& less, const Contender& more) {
  const Work& a = less.work;
  const Work& b = more.work;
  std::vector<std::string> reasons;
  if (less.configuration.options.tolerance > 0.0 && more.configuration.options.tolerance == 0.0) {
    reasons.push_back(
        fmt::format("the tolerance is one more stop test in each of {:.2f} iterations, and saves "
                    "{:.2f} iterations",
                    a.iterations, b.iterations - a.iterations));
  }
  if (a.settled > b.settled) {
    reasons.push_back(
        fmt::format("exact arithmetic settles {:.0f} % of its answers, {:.0f} % of the other's",
                    100.0 * a.settled, 100.0 * b.settled));
  }
  if (a.start_vertices > b.start_vertices) {
    reasons.push_back(fmt::format("its first simplex has {:.2f} vertices, the other's {:.2f}",
                                  a.start_vertices, b.start_vertices));
  }
  constexpr double kAlike = 1.01;
  if (a.instructions > kAlike * b.instructions) {
    reasons.push_back(fmt::format("it takes {:.0f} instructions, the other {:.0f}", a.instructions,
                                  b.instructions));
  }
  if (!reasons.empty()) return fmt::format("{}", fmt::join(reasons, "; "));
  const std::string instructions =
      std::isnan(a.instructions)
          ? ""
          : fmt::format(", {:.0f} against {:.0f} instructions", a.instructions, b.instructions);
  return fmt::format("no count explains it: {:.2f} against {:.2f} iterations{}", a.iterations,
                     b.iterations, instructions);
}

void compare_work(const std::vector<Contender>& contenders, const std::vector<Timing>& timings,
                  const Family& family, Study& study) {
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    for (std::size_t k = 0; k < contenders.size(); ++k) {
      if (i == k || timings[i].ns.empty()) continue;
      const Contender& less = contenders[i];
      const Contender& more = contenders[k];
      if (!does_less(less, more, family.in_motion)) continue;
      ++study.compared;
      const Quartiles found = ratio(timings[i], timings[k]);
      if (found.low <= kCostlier) continue;
      study.costlier.push_back({family.name, name_of(less.configuration),
                                name_of(more.configuration), found, reason_for(less, more)});
    }
  }
}

std::vector<CostlierPair> costlier_pairs(const Study& study) {
  std::vector<CostlierPair> out;
  for (const Costlier& each : study.costlier) {
    const double ratio = each.ratio.median;
    const auto same = std::find_if(out.begin(), out.end(), [&](const CostlierPair& pair) {
      return pair.less == each.less && pair.more == each.more;
    });
    if (same == out.end()) {
      out.push_back({each.less, each.more, {each.family}, ratio, ratio, each.reason});
      continue;
    }
    same->families.push_back(each.family);
    same->least = std::min(same->least, ratio);
    if (ratio > same->most) same->reason = each.reason;
    same->most = std::max(same->most, ratio);
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const auto& a, const auto& b) { return a.most > b.most; });
  return out;
}

std::string ratios_text(const CostlierPair& pair) {
  const std::string least = fmt::format("{:.2f}", pair.least);
  const std::string most = fmt::format("{:.2f}", pair.most);
  return least == most ? least : least + " to " + most;
}

std::string costlier_about(const Study& study) {
  const std::size_t pairs = costlier_pairs(study).size();
  const std::string listed = pairs == 0   ? "None does."
                             : pairs == 1 ? "One pair does:"
                                          : fmt::format("{} pairs do:", pairs);
  return fmt::format(
      "One configuration does part of another's work if arithmetic, rules and start are the same, "
      "it proves no more, its cap is no larger, its tolerance is no tighter, it has no further "
      "stop "
      "test, and it took no more iterations and support queries on a family. In motion, a warm "
      "start with fewer iterations does part of a cold one's work. That gave {} comparisons. A "
      "pair is listed if the configuration that does less took over {} times as long in at least "
      "three quarters of the repetitions: if the lower quartile of the ratio is above {}. {}",
      study.compared, kCostlier, kCostlier, listed);
}

}  // namespace gjkscope::study
