#include "study/accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>

#include "study/counter.hpp"
#include "study/less_work.hpp"
#include "study/truth.hpp"
#include "subjects/study/results.hpp"

namespace gjkscope::study {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kLeastRepetitions = 5;
constexpr std::size_t kMostRepetitions = 101;
constexpr double kJudgingShare = 0.3;  ///< The share of a family's time spent on judging, about.

/// The truth about each pair of a family, as it was given and as configurations keep it.
class Truths {
 public:
  explicit Truths(const Family& family) : family_(family) {
    for (const DoublePair& pair : family.pairs) {
      given_.push_back(truth_of(pair));
      scales_.push_back(families::scale_of(pair));
    }
  }
  [[nodiscard]] const std::vector<Truth<2>>& given() const { return given_; }
  [[nodiscard]] const std::vector<double>& scales() const { return scales_; }

  /// The truth about pairs rounded to floats or halves; for pairs that go beyond the range of these
  /// it is empty.
  [[nodiscard]] const std::vector<Truth<2>>& as_kept(Arithmetic arithmetic,
                                                     const std::vector<DoublePair>& kept) {
    switch (arithmetic) {
      case Arithmetic::half:
        return rounded(half_, kept);
      case Arithmetic::single:
      case Arithmetic::single_in_double:
        return rounded(single_, kept);
      default:
        return given_;
    }
  }

 private:
  static bool is_finite(const std::vector<Eigen::Vector2d>& points) {
    return std::all_of(points.begin(), points.end(),
                       [](const Eigen::Vector2d& p) { return p.allFinite(); });
  }
  [[nodiscard]] const std::vector<Truth<2>>& rounded(std::vector<Truth<2>>& truths,
                                                     const std::vector<DoublePair>& kept) const {
    for (std::size_t i = truths.size(); i < kept.size(); ++i) {
      const DoublePair& pair = kept[i];
      const bool same = pair.x == family_.pairs[i].x && pair.y == family_.pairs[i].y;
      const bool finite = is_finite(pair.x) && is_finite(pair.y);
      truths.push_back(same ? given_[i] : finite ? truth_of(pair) : Truth<2>{});
    }
    return truths;
  }

  const Family& family_;
  std::vector<Truth<2>> given_;
  std::vector<double> scales_;
  std::vector<Truth<2>> single_;
  std::vector<Truth<2>> half_;
};

/// |answer - distance| as a share of the larger of the two.
double share_of_larger(double error, double distance, double answer) {
  return error > 0.0 ? error / std::max(distance, answer) : 0.0;
}

/// All but the times.
Row judged_row(const Configuration& configuration, const Family& family, const Asked& asked,
               Truths& truths, std::uint64_t seed) {
  Row row;
  row.family = family.name;
  row.vertices = family.vertices;
  row.configuration = name_of(configuration);
  row.axis = axis_of(configuration);
  row.proof = proof_name(configuration.options.proof);
  row.pairs = static_cast<int>(family.pairs.size());
  const std::vector<Truth<2>>& as_kept = truths.as_kept(configuration.arithmetic, asked.kept);
  std::vector<double> errors;
  std::size_t worst = 0;
  std::pair<double, double> largest(-1.0, -1.0);  // error, error / scale
  long iterations = 0;
  bool has_bounds = false;
  for (std::size_t i = 0; i < family.pairs.size(); ++i) {
    const Answer& answer = asked.answers[i];
    const Truth<2>& given = truths.given()[i];
    const Judgement found = judge(answer, {given, as_kept[i]});
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::pair<double, double> error(kInfinity, kInfinity);
    const double scale = truths.scales()[i];
    if (!found.failed) {
      const auto distance = static_cast<double>(answer.distance);
      error = {share_of_larger(found.error, given.distance, distance),
               scale > 0.0 ? found.error / scale : 0.0};
      errors.push_back(error.second);
      row.error_as_kept = std::max(
          row.error_as_kept, share_of_larger(found.error_as_kept, as_kept[i].distance, distance));
      if (scale > 0.0) {
        row.error_units = std::max(
            row.error_units, found.error_as_kept / scale / unit_roundoff(configuration.arithmetic));
        row.witness_scale = std::max(row.witness_scale, found.witness / scale);
        if (answer.has_bounds) row.width_scale = std::max(row.width_scale, found.width / scale);
      }
      has_bounds = has_bounds || answer.has_bounds;
    }
    if (error > largest) {
      largest = error;
      worst = i;
    }
    row.error = std::max(row.error, error.first);
    row.error_scale = std::max(row.error_scale, error.second);
    row.failed += found.failed;
    row.undecided += found.undecided;
    row.wrong += found.wrong;
    row.wrong_as_kept += found.wrong_as_kept;
    row.broken_bounds += found.broken_bounds;
    iterations += answer.iterations;
    row.most_iterations = std::max(row.most_iterations, answer.iterations);
    row.settled += answer.settled;
  }
  row.iterations = static_cast<double>(iterations) / static_cast<double>(family.pairs.size());
  row.middle_error_scale = errors.empty() ? kNoNumber : quartiles(errors).median;
  if (!has_bounds) row.width_scale = kNoNumber;

  const Answer& answer = asked.answers[worst];
  row.worst.json = case_json(
      Case{family.pairs[worst].x, family.pairs[worst].y},
      family.name + ", seed " + std::to_string(seed) + ", pair " + std::to_string(worst + 1));
  row.worst.answer = answer.refused ? kNoNumber : static_cast<double>(answer.distance);
  row.worst.distance = truths.given()[worst].distance;
  return row;
}

/// Judges and times all configurations on one family. `share`: how much of it is done.
class FamilyStudy {
 public:
  FamilyStudy(const Plan& plan, const Family& family, const Watch& watch,
              std::function<void(double)> tell)
      : plan_(plan), family_(family), timed_(family), watch_(watch), tell_(std::move(tell)) {
    const auto most = static_cast<std::size_t>(std::max(1, plan.sizes.timed_pairs));
    timed_.pairs.resize(std::min(timed_.pairs.size(), most));
  }

  /// Adds rows, and comparisons, to `study`: nothing when it was interrupted before all
  /// configurations were judged.
  void add_to(Study& study) {
    const std::vector<Configuration> all =
        family_.vertices > 0 ? configurations_by_size() : configurations(plan_.quick);
    Truths truths(family_);
    std::vector<Row> out;
    std::vector<Contender> contenders;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!watch_.go_on()) return;
      if (all[i].start == Start::warm && !family_.in_motion) continue;
      const Asked asked = ask(all[i], family_);
      out.push_back(judged_row(all[i], family_, asked, truths, plan_.seed));
      Asked timed = ask(all[i], timed_);
      contestants_.push_back(std::move(timed.contestant));
      contenders.push_back({all[i], work_of(timed.answers)});
      tell_(kJudgingShare * static_cast<double>(i + 1) / static_cast<double>(all.size()));
    }
    const std::vector<Timing> timings = timed();
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i].timed_pairs = static_cast<int>(timed_.pairs.size());
      out[i].repetitions = static_cast<int>(timings[i].ns.size());
      if (timings[i].ns.empty()) continue;
      out[i].ns = quartiles(timings[i].ns);
      out[i].ratio = ratio(timings[i], timings[0]);
      out[i].instructions = contenders[i].work.instructions = instructions_of(contestants_[i]);
    }
    std::move(out.begin(), out.end(), std::back_inserter(study.rows));
    compare_work(contenders, timings, family_, study);
  }

 private:
  /// Per query, of one repetition when everything is warm; NaN where they are not counted.
  [[nodiscard]] double instructions_of(const Contestant& contestant) const {
    const Counter counter(Counter::Kind::instructions);
    const std::optional<std::uint64_t> before = counter.read();
    if (!before) return std::numeric_limits<double>::quiet_NaN();
    keep(contestant.sweep());
    return static_cast<double>(*counter.read() - *before) /
           static_cast<double>(timed_.pairs.size());
  }

  /// As many repetitions as the plan's time allows.
  [[nodiscard]] std::vector<Timing> timed() {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    // `interleave` asks up to twice for each contestant before the first turn.
    const auto asked_by = [&](std::size_t repetitions) {
      return static_cast<double>((repetitions + 2) * contestants_.size());
    };
    const double least = asked_by(kLeastRepetitions);
    const double most = asked_by(kMostRepetitions);
    double asked = 0.0;
    return interleave(
        contestants_, timed_.pairs.size(), kMostRepetitions,
        [&] {
          const std::chrono::duration<double> passed = Clock::now() - begin;
          const double of_time = passed.count() / plan_.seconds_per_family;
          const double share = std::max(std::min(of_time, asked / least), asked / most);
          tell_(kJudgingShare + (1.0 - kJudgingShare) * std::min(1.0, share));
          return watch_.go_on() && (asked++ < least || of_time < 1.0);
        },
        plan_.seconds_per_turn);
  }

  const Plan& plan_;
  const Family& family_;
  Family timed_;  ///< Its first pairs.
  const Watch& watch_;
  std::function<void(double)> tell_;
  std::vector<Contestant> contestants_;
};

}  // namespace

Plan plan(bool quick) {
  Plan out;
  out.quick = quick;
  if (quick) {
    out.sizes = {64, 32, 64};
    out.seconds_per_family = 0.4;
  }
  return out;
}

std::vector<Family> families_of(const Plan& plan) {
  std::vector<Family> all = families_of(plan.seed, plan.sizes, plan.reported);
  if (plan.families.empty()) return all;
  for (const std::string& name : plan.families) {
    const bool is_known = std::any_of(all.begin(), all.end(),
                                      [&](const Family& family) { return family.name == name; });
    if (is_known) continue;
    std::string known;
    for (const Family& family : all)
      known += fmt::format("{}'{}'", known.empty() ? "" : ", ", family.name);
    throw std::runtime_error(
        fmt::format("there is no family '{}'; expected one of: {}", name, known));
  }
  std::erase_if(all, [&](const Family& family) {
    return std::count(plan.families.begin(), plan.families.end(), family.name) == 0;
  });
  return all;
}

Study study_accuracy(const Plan& plan, const Watch& watch) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  Study out;
  out.machine = this_machine();
  out.seed = plan.seed;
  out.quick = plan.quick;
  watch.tell(0.0, "families");
  const std::vector<Family> families = families_of(plan);
  out.families_planned = static_cast<int>(families.size());
  for (std::size_t i = 0; i < families.size() && out.complete; ++i) {
    const auto tell = [&](double share) {
      watch.tell((static_cast<double>(i) + share) / static_cast<double>(families.size()),
                 families[i].name);
    };
    FamilyStudy(plan, families[i], watch, tell).add_to(out);
    out.complete = watch.go_on();
  }
  mark_front(out.rows);
  out.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return out;
}

std::vector<Row> judged_rows(const Family& family, const std::vector<Configuration>& configurations,
                             std::uint64_t seed) {
  Truths truths(family);
  std::vector<Row> out;
  for (const Configuration& each : configurations) {
    if (each.start == Start::warm && !family.in_motion) continue;
    out.push_back(judged_row(each, family, ask(each, family), truths, seed));
  }
  return out;
}

std::vector<std::vector<const Row*>> by_family(const std::vector<Row>& rows) {
  std::vector<std::vector<const Row*>> out;
  for (const Row& row : rows) {
    const auto same = std::find_if(out.begin(), out.end(), [&](const auto& group) {
      return group.front()->family == row.family;
    });
    if (same == out.end()) {
      out.push_back({&row});
    } else {
      same->push_back(&row);
    }
  }
  return out;
}

void mark_front(std::vector<Row>& rows) {
  std::map<std::string, std::vector<Row*>> families;
  for (Row& row : rows) families[row.family].push_back(&row);
  for (const auto& [name, family] : families) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    std::vector<Cost> costs;
    for (const Row* row : family)
      costs.push_back({row->repetitions > 0 ? row->ns.median : kNone, row->error});
    const std::vector<bool> front = front_of(costs);
    for (std::size_t i = 0; i < family.size(); ++i) family[i]->on_front = front[i];
  }
}

}  // namespace gjkscope::study
