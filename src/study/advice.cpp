// The summary of a study in words. Every number is read from its rows, and every sentence holds
// whatever they are.

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

using RowList = std::vector<const Row*>;

std::string share_text(double ratio) { return fmt::format("{:.2f}", ratio); }

std::string times_text(const Row& row) {
  return fmt::format("{} × ({})", share_text(row.ratio.median), time_text(row.ns.median));
}

std::string times_text(const Row& a, const Row& b) { return share_text(a.ns.median / b.ns.median); }

constexpr const char* kWords = R"(## Words

| in a name | means |
| --- | --- |
| `double` | Runs of the core as it is by default. Vertices and the run are in numbers of 53 bits, about 16 digits, and every answer is proved: it comes with bounds that include rounding, and exact arithmetic runs on where they are wide or leave open whether the shapes overlap (`Proof::exact`). |
| `half`, `float` | The same in numbers of 11 and 24 bits, about 3 and 7 digits. Vertices are rounded to these, too. |
| `float in double` | Vertices are rounded to float; the run computes in double. |
| `long double`, `quad` | Vertices are doubles; the run computes in numbers of 64 and 113 bits, about 19 and 34 digits. |
| `exact` | Fractions of whole numbers. Only the answer is rounded, to double. |
| `bounds only` | No exact arithmetic afterwards (`Proof::bounds`). |
| `loop only` | No bounds either (`Proof::none`): the answer is the length of P as the loop left it, as in a textbook. |
| `tolerance t` | Stops as soon as its bounds differ by less than the share t of the upper one. |
| `cap k` | Gives up after k iterations. |
| `towards O` | Searches along O − P instead of perpendicular to the simplex. |
| `edges first`, `regions unchecked` | Tests the regions of edges before those of vertices; believes every region test. |
| `stop: repeated support`, `stop: no progress` | Leaves out the other of these two stop tests. |
| `first vertices`, `warm start` | Starts from the first vertex of each shape; from the last simplex of the pair before. |

)";

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
    return introduction() + kWords + digits() + costlier() + choices() + questions() + vertices();
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
        "{} ways to run GJK, called configurations, answered {} pairs of shapes, easy and hard. "
        "Exact arithmetic judged every\nanswer. All of them run through the same code, "
        "`gjk::distance`; measuring the shapes is not in the times.\n\n"
        "- *Error* is |answer − distance| as a share of the larger of the two: 1e-07 means that "
        "about seven digits are right, 1 that\n  none is. *Error / scale* divides by the largest "
        "distance between a vertex of X and one of Y instead. Both are the largest\n  seen over "
        "all pairs.\n"
        "- *Time* is the geometric mean over the families of pairs, of medians of at least {} "
        "repetitions. × is the share of the\n  time of *double*, taken within each repetition, "
        "in which all configurations take turns.\n\n"
        "Measured {}on {}, one thread, {}, `{}`, commit {}, seed {}.\n\n",
        all_.size(), all_.front()->pairs, all_.front()->repetitions,
        study_.complete ? "" : "in part, for the run was interrupted, ", machine.processor,
        machine.compiler, machine.flags, machine.commit, study_.seed);
  }

  /// The first, which is the plainest, of the rows that `suit` and are as fast as any of them, but
  /// for noise or a matter of the processor. A cap buys no accuracy.
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
        "## Which configuration gives k digits?\n\n"
        "The fastest one whose error was at most half a unit of digit k on every pair. Of those "
        "that take at most a quarter more\ntime, the plainest.\n\n";
    if (!ordinary_.empty()) {
      out += "### For ordinary shapes\n\n" + fmt::format("The family \"{}\".\n\n", kOrdinary) +
             digit_table(ordinary_) + "\n";
    }
    out += "### For all shapes, hard ones included\n\n" + digit_table(all_);
    const auto is_right = [](const Row& row) { return row.wrong + row.undecided == 0; };
    const Row* verdict = fastest(all_, is_right);
    const Row* proved =
        fastest(all_, [&](const Row& row) { return is_right(row) && row.proof == "exact"; });
    if (verdict != nullptr) {
      out += fmt::format("\nThe fastest that got \"overlap or not\" right for every pair: {}, {}.",
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
      out += fmt::format("\nThe bounds of *{}* did not hold for {} of {} pairs.\n",
                         row->configuration, row->broken_bounds, row->pairs);
    }
    return out + "\n";
  }

  /// One line for all numbers of digits that the same configurations give.
  [[nodiscard]] static std::string digit_table(const RowList& rows) {
    struct Line {
      int first = 0;
      int last = 0;
      const Row* of_distance = nullptr;
      const Row* of_scale = nullptr;
    };
    std::vector<Line> lines;
    for (int k = 1; k <= 33; ++k) {
      const double limit = 0.5 * std::pow(10.0, -k);
      const Row* of_distance = fastest(rows, [&](const Row& row) { return row.error <= limit; });
      const Row* of_scale = fastest(rows, [&](const Row& row) { return row.error_scale <= limit; });
      if (of_distance == nullptr && of_scale == nullptr) break;
      const bool same = !lines.empty() && lines.back().of_distance == of_distance &&
                        lines.back().of_scale == of_scale;
      if (same) {
        lines.back().last = k;
      } else {
        lines.push_back({k, k, of_distance, of_scale});
      }
    }
    std::string out =
        "| digits | of the distance | costs | of the scale | costs |\n"
        "| --- | --- | --- | --- | --- |\n";
    for (const Line& line : lines) {
      const std::string digits = line.first == line.last
                                     ? std::to_string(line.first)
                                     : fmt::format("{} to {}", line.first, line.last);
      out +=
          fmt::format("| {} | {} | {} |\n", digits, cells(line.of_distance), cells(line.of_scale));
    }
    return out;
  }

  [[nodiscard]] static std::string cells(const Row* row) {
    if (row == nullptr) return "nothing here | ";
    return fmt::format("{} | {}", row->configuration, times_text(*row));
  }

  [[nodiscard]] std::string costlier() const {
    std::string out =
        "## Does doing less ever cost more?\n\n" + wrapped(costlier_about(study_)) + "\n\n";
    const std::vector<CostlierPair> pairs = costlier_pairs(study_);
    if (pairs.empty()) return out;
    out +=
        "| does less | than | takes, × | in families | because |\n| --- | --- | --- | --- | --- "
        "|\n";
    for (const CostlierPair& pair : pairs) {
      out += fmt::format("| {} | {} | {} | {} | {} |\n", pair.less, pair.more, ratios_text(pair),
                         fmt::join(pair.families, ", "), pair.reason);
    }
    return out + "\n";
  }

  [[nodiscard]] static std::string wrapped(const std::string& text) {
    constexpr std::size_t kWidth = 120;
    std::string out;
    std::size_t length = 0;
    std::size_t begin = 0;
    while (begin < text.size()) {
      const std::size_t end = std::min(text.find(' ', begin), text.size());
      const std::string word = text.substr(begin, end - begin);
      const bool breaks = length > 0 && length + 1 + word.size() > kWidth;
      out += length == 0 ? word : (breaks ? "\n" : " ") + word;
      length = breaks || length == 0 ? word.size() : length + 1 + word.size();
      begin = end + 1;
    }
    return out;
  }

  [[nodiscard]] std::string choices() const {
    std::string out =
        "## What each configuration does\n\n"
        "\"in u\" is what computing alone did, in roundings: in units of u times the scale, u of "
        "the answer's type. Rounding the\nvertices to half or float is in the error and not in "
        "these. \"wrong\" and \"open\" count pairs whose overlap was told wrongly\nor left "
        "undecided, \"settled\" those on which exact arithmetic ran on. Error \"none\": some pair "
        "got no answer. * marks the\nfront: nothing takes less time and errs no more, where times "
        "within 10 % and errors within a factor of 2 count as the same.\n\n"
        "| configuration | × | error | error / scale | in u | wrong | open | settled | iterations "
        "| |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (const Row* row : all_) {
      out += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {:.1f} | {} |\n",
                         row->configuration, share_text(row->ratio.median), error_text(row->error),
                         error_text(row->error_scale), error_text(row->error_units), row->wrong,
                         row->undecided, row->settled, row->iterations, row->on_front ? "*" : "");
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
    const auto error = [&](const Row& row) {
      return error_text(floats ? row.error_as_kept : row.error);
    };
    const auto wrong = [&](const Row& row) {
      return (floats ? row.wrong_as_kept : row.wrong) + row.undecided;
    };
    out += fmt::format(
        "- **{}** *{}* takes {} × the time of *{}*.\n  {} {} against {}. \"Overlap or not\" is "
        "wrong or left open for {} against {} of {} pairs.\n",
        question, name, times_text(*a, *b), with,
        floats ? "Judged by the pairs as floats, its error is" : "Its error is", error(*a),
        error(*b), wrong(*a), wrong(*b), a->pairs);
  }

  [[nodiscard]] std::string questions() const {
    std::string out = "## Questions\n\n";
    compare(out, all_, "What does the proof cost?", "double", "double, loop only");
    compare(out, all_, "Do more digits replace a proof?", "long double, loop only", "double");
    compare(out, all_, "And twice the digits?", "quad, loop only", "double");
    compare(out, all_, "If vertices are floats, should the run compute in float?", "float",
            "float in double");
    compare(out, all_, "Does the direction matter if nothing checks the loop?",
            "double, loop only, towards O", "double, loop only");
    compare(out, all_, "And if the answer is proved?", "double, towards O", "double");
    compare(out, all_, "Does the order of the region tests matter?",
            "float, loop only, edges first", "float, loop only");
    compare(out, all_, "Is a repeated support point enough to stop?",
            "double, stop: repeated support", "double");
    compare(out, all_, "What does stopping early save?", "double, tolerance 1e-01", "double");
    compare(out, motion_, "What does a warm start save in motion?", "double, warm start", "double");
    if (const Row* cap = least_cap(); cap != nullptr) {
      out += fmt::format(
          "- **How many iterations are enough?** With *{}* no error is larger than without a cap, "
          "on all of these pairs.\n",
          cap->configuration);
    }
    return out + "\n";
  }

  /// The smallest cap with which no pair is worse off.
  [[nodiscard]] const Row* least_cap() const {
    for (const Row* row : all_) {
      if (row->axis == "cap" && row->failed == 0 && row->undecided <= all_.front()->undecided &&
          row->error <= all_.front()->error && row->error_scale <= all_.front()->error_scale) {
        return row;
      }
    }
    return nullptr;
  }

  [[nodiscard]] std::string vertices() const {
    if (sizes_.empty()) return "";
    std::string out =
        "## Larger polygons\n\nThe time of a query, by the number of vertices of each of the two "
        "polygons.\n\n| vertices | pairs |";
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
