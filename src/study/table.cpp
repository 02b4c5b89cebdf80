#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "study/less_work.hpp"
#include "study/report.hpp"
#include "subjects/study/results.hpp"

namespace gjkscope::study {
namespace {

std::string line_of(const Row& row) {
  return fmt::format(
      "{} {:<42} {:>9} {:>7} {:>6.1f} {:>8} {:>8} {:>8} {:>8} {:>8} {:>6} {:>6} {:>6} {:>7} "
      "{:>6}\n",
      row.on_front ? '*' : ' ', row.configuration,
      row.repetitions > 0 ? time_text(row.ns.median) : "",
      row.repetitions > 0 ? fmt::format("{:.2f}", row.ratio.median) : "", row.iterations,
      error_text(row.error), error_text(row.error_scale), error_text(row.error_units),
      error_text(row.witness_scale), error_text(row.width_scale), row.wrong, row.wrong_as_kept,
      row.undecided, row.settled, row.failed);
}

std::string heading() {
  return fmt::format(
      "  {:<42} {:>9} {:>7} {:>6} {:>8} {:>8} {:>8} {:>8} {:>8} {:>6} {:>6} {:>6} {:>7} {:>6}\n",
      "", "time", "times", "iter.", "error", "/ scale", "in u", "witness", "bounds", "wrong", "own",
      "undec.", "settled", "failed");
}

/// Rows of one configuration over all families.
Row merged(const std::vector<const Row*>& rows) {
  Row out = *rows.front();
  out.family = kAllFamilies;
  out.pairs = 0;
  out.timed_pairs = 0;
  out.failed = out.undecided = out.wrong = out.wrong_as_kept = out.broken_bounds = 0;
  out.settled = 0;
  out.instructions = 0.0;
  out.iterations = 0.0;
  out.worst = {};
  std::pair<double, double> largest(-1.0, -1.0);
  std::vector<double> middles;
  Quartiles log_ns;
  Quartiles log_ratio;
  const auto widen = [](double& to, double value) {
    if (!std::isnan(value)) to = std::isnan(to) ? value : std::max(to, value);
  };
  const auto add_log = [&](Quartiles& to, const Quartiles& value) {
    const auto share = 1.0 / static_cast<double>(rows.size());
    to.low += share * std::log(value.low);
    to.median += share * std::log(value.median);
    to.high += share * std::log(value.high);
  };
  for (const Row* row : rows) {
    out.pairs += row->pairs;
    out.repetitions = std::min(out.repetitions, row->repetitions);
    out.timed_pairs += row->timed_pairs;
    out.failed += row->failed;
    out.undecided += row->undecided;
    out.wrong += row->wrong;
    out.wrong_as_kept += row->wrong_as_kept;
    out.broken_bounds += row->broken_bounds;
    out.settled += row->settled;
    out.instructions += row->instructions / static_cast<double>(rows.size());
    out.iterations += row->iterations * row->pairs;
    out.most_iterations = std::max(out.most_iterations, row->most_iterations);
    widen(out.error_scale, row->error_scale);
    widen(out.error, row->error);
    widen(out.error_units, row->error_units);
    widen(out.error_as_kept, row->error_as_kept);
    widen(out.witness_scale, row->witness_scale);
    widen(out.width_scale, row->width_scale);
    if (!std::isnan(row->middle_error_scale)) middles.push_back(row->middle_error_scale);
    if (const std::pair error(row->error, row->error_scale); error > largest) {
      largest = error;
      out.worst = row->worst;
    }
    add_log(log_ns, row->ns);
    add_log(log_ratio, row->ratio);
  }
  out.iterations /= out.pairs;
  out.middle_error_scale =
      middles.empty() ? std::numeric_limits<double>::quiet_NaN() : quartiles(middles).median;
  const auto powers = [](const Quartiles& log) {
    return Quartiles{std::exp(log.low), std::exp(log.median), std::exp(log.high)};
  };
  out.ns = out.repetitions > 0 ? powers(log_ns) : Quartiles{};
  out.ratio = out.repetitions > 0 ? powers(log_ratio) : Quartiles{};
  return out;
}

/// A line for each configuration whose bounds did not hold somewhere: the reader has to know.
std::string broken_lines(const std::vector<const Row*>& rows) {
  std::string out;
  for (const Row* row : rows) {
    if (row->broken_bounds == 0) continue;
    out += fmt::format("  bounds did not hold for {} of {} pairs: {}\n", row->broken_bounds,
                       row->pairs, row->configuration);
  }
  return out;
}

}  // namespace

Study summary(const Study& study) {
  Study out = study;
  out.rows.clear();
  const std::vector<std::vector<const Row*>> groups = by_family(study.rows);
  std::vector<std::vector<const Row*>> families;
  for (const auto& group : groups) {
    if (group.front()->vertices == 0) families.push_back(group);
  }
  if (!families.empty()) {
    for (const Row* first : families.front()) {
      std::vector<const Row*> rows;
      for (const auto& family : families) {
        const auto same = std::find_if(family.begin(), family.end(), [&](const Row* row) {
          return row->configuration == first->configuration;
        });
        if (same != family.end()) rows.push_back(*same);
      }
      if (rows.size() == families.size()) out.rows.push_back(merged(rows));
    }
  }
  mark_front(out.rows);
  for (const auto& group : groups) {
    const bool in_motion = std::any_of(group.begin(), group.end(), [](const Row* row) {
      return row->configuration == name_of(Configuration{.start = Start::warm});
    });
    for (const Row* row : group) {
      const bool is_default = row->configuration == name_of(Configuration{});
      if (row->vertices > 0 || row->family == kOrdinary ||
          (in_motion && (is_default || row->axis == "start"))) {
        out.rows.push_back(*row);
      }
    }
  }
  return out;
}

std::string table(const Study& study) {
  if (study.rows.empty()) return "Nothing was measured.\n";
  std::string out =
      "error: |answer - distance| as a share of the larger of the two; / scale: as a share of the "
      "largest distance between\nvertices; in u: what computing alone does, in roundings (u * "
      "scale) of the answer's type; witness, bounds: shares of\nthe scale. All of these are the "
      "largest seen; none: some pair has no answer. times: of the default. wrong: overlaps\ntold "
      "wrongly; own: of the pair as the arithmetic keeps it; settled: by exact arithmetic. * on "
      "the "
      "front: nothing takes\nless time and errs no more (times within 10 % and errors within a "
      "factor of 2 count as the same).\n";
  const Study all = summary(study);
  for (const auto& group : by_family(all.rows)) {
    if (group.front()->family != kAllFamilies) continue;
    out += fmt::format("\n{} ({} pairs)\n{}", kAllFamilies, group.front()->pairs, heading());
    for (const Row* row : group) out += line_of(*row);
    out += broken_lines(group);
  }
  for (const auto& group : by_family(study.rows)) {
    const Row& first = *group.front();
    out += fmt::format("\n{} ({} pairs, {} repetitions): the default, and the front\n{}",
                       first.family, first.pairs, first.repetitions, heading());
    std::vector<const Row*> rows;
    std::copy_if(group.begin(), group.end(), std::back_inserter(rows),
                 [&](const Row* row) { return row->on_front || row == group.front(); });
    std::sort(rows.begin(), rows.end(),
              [](const Row* a, const Row* b) { return a->ns.median < b->ns.median; });
    for (const Row* row : rows) out += line_of(*row);
  }
  out += "\nDoes doing less ever cost more? " + costlier_about(study) + "\n";
  for (const CostlierPair& pair : costlier_pairs(study)) {
    out += fmt::format("  {} takes {} times as long as {} ({}): {}\n", pair.less, ratios_text(pair),
                       pair.more, fmt::join(pair.families, ", "), pair.reason);
  }
  return out;
}

}  // namespace gjkscope::study
