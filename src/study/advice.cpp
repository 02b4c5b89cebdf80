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
        "by "
        "exact runs.\nTime is the geometric mean over the families of pairs, of medians of at "
        "least {} "
        "interleaved repetitions; × is the\nshare of the default's time, taken within each "
        "repetition. Errors are the largest over all pairs.\n\n"
        "Measured {}on {}, one thread, {}, `{}`, commit {}, seed {}.\n\n",
        all_.size(), all_.front()->pairs, all_.front()->repetitions,
        study_.complete ? "" : "in part, for the run was interrupted, ", machine.processor,
        machine.compiler, machine.flags, machine.commit, study_.seed);
  }

  /// The fastest row that `suits`.
  template <class Suits>
  [[nodiscard]] const Row* fastest(Suits suits) const {
    const Row* best = nullptr;
    for (const Row* row : all_) {
      if (row->failed > 0 || !suits(*row)) continue;
      if (best == nullptr || row->ratio.median < best->ratio.median) best = row;
    }
    return best;
  }

  [[nodiscard]] std::string digits() const {
    std::string out =
        "## To be sure of k digits\n\n"
        "The fastest configuration whose error was at most half a unit of digit k, on every pair: "
        "of "
        "the scale (the largest\ndistance between a vertex of X and one of Y), and, which is "
        "harder, "
        "of the distance itself.\n\n"
        "| digits | of the scale | costs | of the distance | costs |\n"
        "| --- | --- | --- | --- | --- |\n";
    for (const int k : {1, 2, 3, 4, 6, 8, 10, 12, 14, 15, 30}) {
      const double limit = 0.5 * std::pow(10.0, -k);
      const Row* scale = fastest([&](const Row& row) { return row.error_scale <= limit; });
      const Row* relative = fastest([&](const Row& row) { return row.relative_error <= limit; });
      if (scale == nullptr && relative == nullptr) continue;
      out += fmt::format("| {} | {} | {} |\n", k, cells(scale), cells(relative));
    }
    const Row* verdict = fastest([](const Row& row) { return row.wrong + row.undecided == 0; });
    if (verdict != nullptr) {
      out += fmt::format(
          "\nNever wrong or undecided on whether the shapes overlap, at the least cost: {}, {}.\n",
          verdict->configuration, times_text(*verdict));
    }
    for (const Row* row : all_) {
      if (row->broken_bounds == 0) continue;
      out += fmt::format("\nIts bounds did not hold for {} of {} pairs: {}.\n", row->broken_bounds,
                         row->pairs, row->configuration);
    }
    return out + "\n";
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

  /// "A takes 0.9 of the time of B; its error is 1e-7 and not 1e-16, 3 overlaps are told wrongly."
  void compare(std::string& out, const RowList& rows, std::string_view question,
               std::string_view name, std::string_view with) const {
    const Row* a = find(rows, name);
    const Row* b = find(rows, with);
    if (a == nullptr || b == nullptr) return;
    out += fmt::format(
        "- **{}** *{}* takes {} of the time of *{}*. Largest error: {} of the scale against {}, "
        "and {} "
        "of the distance\n  against {}. Overlaps told wrongly or left open: {} against {} of {}.\n",
        question, name, times_text(*a, *b), with, error_text(a->error_scale),
        error_text(b->error_scale), error_text(a->relative_error), error_text(b->relative_error),
        a->wrong + a->undecided, b->wrong + b->undecided, a->pairs);
  }

  [[nodiscard]] std::string surprises() const {
    std::string out = "## Questions one would ask\n\n";
    compare(out, all_, "What does the proof cost?", "double", "double, loop only");
    compare(out, all_, "Do more digits stand in for a proof?", "long double, loop only", "double");
    compare(out, all_, "And twice the digits?", "quad, loop only", "double");
    compare(out, all_, "Is float enough to compute in, once coordinates are floats?", "float",
            "float in double");
    compare(out, all_, "What do eight pairs at once cost?", "float in batch", "float in double");
    compare(out, all_, "Does the direction matter, where nothing checks the loop?",
            "float, loop only, towards O", "float, loop only");
    compare(out, all_, "And where the answer is proved?", "float, towards O", "float");
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
  RowList motion_;
  std::vector<RowList> sizes_;
};

}  // namespace

std::string advice(const Study& summary) { return Advice(summary).text(); }

}  // namespace gjkscope::study
