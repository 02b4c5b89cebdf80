// What the summary of a study comes to, in words. Every number is read from its rows, and every
// sentence holds whatever they are.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/report.hpp"

namespace gjkscope::study {
namespace {

using RowList = std::vector<const Row*>;

std::string share_text(double ratio) { return fmt::format("{:.2f}", ratio); }

std::string times_text(const Row& row) {
  return fmt::format("{} × ({})", share_text(row.ratio.median), time_text(row.ns.median));
}

std::string times_text(const Row& a, const Row& b) { return share_text(a.ns.median / b.ns.median); }

class Advice {
 public:
  explicit Advice(const Study& summary) : study_(summary) {
    for (const auto& group : by_family(summary.rows)) {
      const Row& first = *group.front();
      if (first.family == kAllFamilies) all_ = group;
      if (first.family == kOrdinary) ordinary_ = group;
      if (find(group, "double, warm start") != nullptr) motion_ = group;
      if (first.vertices > 0) sizes_.push_back(group);
    }
  }

  [[nodiscard]] std::string text() const {
    if (all_.empty() || all_.front()->repetitions == 0) {
      return "# What accuracy costs\n\nNo family was measured whole.\n";
    }
    return introduction() + digits() + choices() + surprises() + vertices();
  }

 private:
  [[nodiscard]] static const Row* find(const RowList& rows, std::string_view name) {
    const auto found = std::find_if(rows.begin(), rows.end(),
                                    [&](const Row* row) { return row->configuration == name; });
    return found == rows.end() ? nullptr : *found;
  }

  [[nodiscard]] std::string introduction() const {
    const Machine& machine = study_.machine;
    return fmt::format(
        "# What accuracy costs\n\n"
        "{} configurations of the core answered {} pairs of shapes, easy and hard, and were judged "
        "by exact runs.\nTime is the geometric mean over the families of pairs, of medians of at "
        "least {} interleaved repetitions; × is the\nshare of the default's time, taken within "
        "each "
        "repetition. Errors are the largest over all pairs.\n\n"
        "Measured {}on {}, one thread, {}, `{}`, commit {}, seed {}.\n\n",
        all_.size(), all_.front()->pairs, all_.front()->repetitions,
        study_.complete ? "" : "in part, for the run was interrupted, ", machine.processor,
        machine.compiler, machine.flags, machine.commit, study_.seed);
  }

  /// Of the rows that `suit` and are as fast as any of them, but for what is noise or a matter of
  /// the processor, the first: the plainest. A cap buys no accuracy.
  template <class Suits>
  [[nodiscard]] static const Row* fastest(const RowList& rows, Suits suits) {
    constexpr double kAlike = 1.25;
    RowList all;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(all), [&](const Row* row) {
      return row->failed == 0 && row->axis != "cap" && suits(*row);
    });
    if (all.empty()) return nullptr;
    const auto time = [](const Row* row) { return row->ratio.median; };
    const Row* best = *std::min_element(
        all.begin(), all.end(), [&](const Row* x, const Row* y) { return time(x) < time(y); });
    return *std::find_if(all.begin(), all.end(),
                         [&](const Row* row) { return time(row) <= kAlike * time(best); });
  }

  [[nodiscard]] std::string digits() const {
    std::string out =
        "## To be sure of k digits\n\n"
        "The fastest configuration whose error was at most half a unit of digit k, on every pair: "
        "of the scale (the largest\ndistance between a vertex of X and one of Y), and, which is "
        "harder, of the distance itself. Of those that take at most a quarter more time, the "
        "plainest.\n\n";
    if (!ordinary_.empty()) {
      out += "### For ordinary shapes\n\n" + fmt::format("The family \"{}\".\n\n", kOrdinary) +
             digit_table(ordinary_) + "\n";
    }
    out += "### For all shapes, hard ones included\n\n" + digit_table(all_);
    const auto is_right = [](const Row& row) { return row.wrong + row.undecided == 0; };
    const Row* verdict = fastest(all_, is_right);
    const Row* proved = fastest(
        all_, [&](const Row& row) { return is_right(row) && effort_of(row) == Effort::proof; });
    if (verdict != nullptr) {
      out += fmt::format(
          "\nNever wrong or undecided on whether these shapes overlap, at the least cost: {}, {}.",
          verdict->configuration, times_text(*verdict));
      if (proved != nullptr && proved != verdict) {
        out += fmt::format(" With a proof for each pair: {}, {}.", proved->configuration,
                           times_text(*proved));
      }
      // The rule of three: 0 of n leaves room for 3 / n, with 95 % confidence.
      out += fmt::format(
          "\nWithout a proof, what none of {} pairs showed may still happen to one in {}.\n",
          verdict->pairs, verdict->pairs / 3);
    }
    for (const Row* row : all_) {
      if (row->broken_bounds == 0) continue;
      out += fmt::format("\nIts bounds did not hold for {} of {} pairs: {}.\n", row->broken_bounds,
                         row->pairs, row->configuration);
    }
    return out + "\n";
  }

  /// One line for all numbers of digits that the same configurations give.
  [[nodiscard]] static std::string digit_table(const RowList& rows) {
    struct Line {
      int first = 0;
      int last = 0;
      const Row* scale = nullptr;
      const Row* relative = nullptr;
    };
    std::vector<Line> lines;
    for (int k = 1; k <= 33; ++k) {
      const double limit = 0.5 * std::pow(10.0, -k);
      const Row* scale = fastest(rows, [&](const Row& row) { return row.error_scale <= limit; });
      const Row* relative =
          fastest(rows, [&](const Row& row) { return row.relative_error <= limit; });
      if (scale == nullptr && relative == nullptr) break;
      const bool same =
          !lines.empty() && lines.back().scale == scale && lines.back().relative == relative;
      if (same) {
        lines.back().last = k;
      } else {
        lines.push_back({k, k, scale, relative});
      }
    }
    std::string out =
        "| digits | of the scale | costs | of the distance | costs |\n"
        "| --- | --- | --- | --- | --- |\n";
    for (const Line& line : lines) {
      const std::string digits = line.first == line.last
                                     ? std::to_string(line.first)
                                     : fmt::format("{} to {}", line.first, line.last);
      out += fmt::format("| {} | {} | {} |\n", digits, cells(line.scale), cells(line.relative));
    }
    return out;
  }

  [[nodiscard]] static std::string cells(const Row* row) {
    if (row == nullptr) return "nothing here | ";
    return fmt::format("{} | {}", row->configuration, times_text(*row));
  }

  [[nodiscard]] std::string choices() const {
    std::string out =
        "## What each choice does\n\n"
        "\"in u\" is what computing alone did, in units of u times the scale, u of the answer's "
        "type. "
        "Keeping coordinates in half\nor float rounds them, which is in the error and not in "
        "these. "
        "\"wrong\" and \"open\" count pairs whose overlap was told\nwrongly or left undecided; "
        "\"none\" "
        "means that some pair got no answer. * on the Pareto front of time and error.\n\n"
        "| configuration | × | error | relative | in u | wrong | open | iterations | |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (const Row* row : all_) {
      out +=
          fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", row->configuration,
                      share_text(row->ratio.median), error_text(row->error_scale),
                      error_text(row->relative_error), error_text(row->error_units), row->wrong,
                      row->undecided, iterations_text(row->iterations), row->on_front ? "*" : "");
    }
    return out + "\n";
  }

  /// How two configurations differ. Where both keep coordinates as floats, of the pairs as these:
  /// what keeping them does is the same for both.
  void compare(std::string& out, const RowList& rows, std::string_view question,
               std::string_view name, std::string_view with) const {
    const Row* a = find(rows, name);
    const Row* b = find(rows, with);
    if (a == nullptr || b == nullptr) return;
    const bool floats = name.starts_with("float") && with.starts_with("float");
    const auto relative = [&](const Row& row) {
      return error_text(floats ? row.relative_error_as_kept : row.relative_error);
    };
    const auto wrong = [&](const Row& row) {
      return (floats ? row.wrong_as_kept : row.wrong) + row.undecided;
    };
    out += fmt::format(
        "- **{}** *{}* takes {} of the time of *{}*.\n  {}argest error, as a share of the "
        "distance: {} against {}. Overlaps told wrongly or left open: {} against {} of {}.\n",
        question, name, times_text(*a, *b), with, floats ? "Of the pairs as floats: l" : "L",
        relative(*a), relative(*b), wrong(*a), wrong(*b), a->pairs);
  }

  [[nodiscard]] std::string surprises() const {
    std::string out = "## Questions one would ask\n\n";
    compare(out, all_, "What does the proof cost?", "double", "double, loop only");
    compare(out, all_, "Do more digits stand in for a proof?", "long double, loop only", "double");
    compare(out, all_, "And twice the digits?", "quad, loop only", "double");
    compare(out, all_, "Is float enough to compute in, once coordinates are floats?", "float",
            "float in double");
    compare(out, all_, "Does the direction matter, where nothing checks the loop?",
            "double, loop only, towards O", "double, loop only");
    compare(out, all_, "And where the answer is proved?", "double, towards O", "double");
    compare(out, all_, "Does the order of the region tests matter?",
            "float, loop only, edges first", "float, loop only");
    compare(out, all_, "Is a repeated support point enough to stop?",
            "double, stop: repeated support", "double");
    compare(out, all_, "What does stopping early save?", "double, gap 1e-01", "double");
    compare(out, motion_, "What does a warm start save, in motion?", "double, warm start",
            "double");
    if (const Row* cap = least_cap(); cap != nullptr) {
      out += fmt::format(
          "- **How many iterations are enough?** *{}* errs by no more than the run without a cap, "
          "on all "
          "of these pairs.\n",
          cap->configuration);
    }
    return out + "\n";
  }

  /// The smallest cap with which no pair is worse off.
  [[nodiscard]] const Row* least_cap() const {
    for (const Row* row : all_) {
      if (row->axis == "cap" && row->failed == 0 && row->undecided <= all_.front()->undecided &&
          row->error_scale <= all_.front()->error_scale) {
        return row;
      }
    }
    return nullptr;
  }

  [[nodiscard]] std::string vertices() const {
    if (sizes_.empty()) return "";
    std::string out = "## Larger polygons\n\n| vertices | pairs |";
    std::string rule = "| --- | --- |";
    for (const Row* row : sizes_.front()) {
      out += fmt::format(" {} |", row->configuration);
      rule += " --- |";
    }
    out += "\n" + rule + "\n";
    for (const RowList& rows : sizes_) {
      out += fmt::format("| {} | {} |", rows.front()->vertices, rows.front()->pairs);
      for (const Row* row : rows) out += fmt::format(" {} |", time_text(row->ns.median));
      out += "\n";
    }
    return out;
  }

  const Study& study_;
  RowList all_;
  RowList ordinary_;
  RowList motion_;
  std::vector<RowList> sizes_;
};

}  // namespace

std::string advice(const Study& summary) { return Advice(summary).text(); }

}  // namespace gjkscope::study
