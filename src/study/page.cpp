// The page: for each family a chart of error against time, as inline SVG.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "base/html.hpp"
#include "study/less_work.hpp"
#include "study/report.hpp"
#include "subjects/study/results.hpp"

namespace gjkscope::study {
namespace {

constexpr double kWidth = 720;
constexpr double kHeight = 420;
constexpr double kLeft = 64;
constexpr double kRight = 16;
constexpr double kTop = 46;        ///< The room above the axes, for pairs without an answer.
constexpr double kBottom = 62;     ///< The room below the axis, for its numbers and name.
constexpr double kNoneBand = 26;   ///< Between the largest error and these.
constexpr double kExactBand = 26;  ///< Between the least error and the axis: answers without error.

/// Decades that hold all values.
struct Decades {
  int low = 0;
  int high = 1;

  [[nodiscard]] double share(double value) const {
    return (std::log10(value) - low) / (high - low);
  }
};

struct Axes {
  Decades ns{100, -100};
  Decades error{100, -100};

  explicit Axes(const std::vector<Row>& rows) {
    const auto widen = [](Decades& decades, double value) {
      if (!(value > 0.0) || !std::isfinite(value)) return;
      decades.low = std::min(decades.low, static_cast<int>(std::floor(std::log10(value))));
      decades.high = std::max(decades.high, static_cast<int>(std::ceil(std::log10(value))));
    };
    for (const Row& row : rows) {
      widen(ns, row.ns.median);
      widen(error, row.error);
    }
    for (Decades* decades : {&ns, &error}) {
      if (decades->high <= decades->low) decades->high = decades->low + 1;
    }
  }

  [[nodiscard]] double x(double value) const {
    return kLeft + ns.share(value) * (kWidth - kLeft - kRight);
  }
  [[nodiscard]] double y(double value) const {
    if (std::isinf(value)) return kTop - kNoneBand;
    if (value == 0.0) return kHeight - kBottom - 8;
    return kTop + (1 - error.share(value)) * (kHeight - kTop - kBottom - kExactBand);
  }
};

/// "float in double" of "float in double, loop only".
std::string arithmetic_of(const Row& row) {
  std::string out = row.configuration.substr(0, row.configuration.find(','));
  std::replace(out.begin(), out.end(), ' ', '-');
  return out;
}

/// Square: the loop only; triangle: bounds only; circle: proved.
std::string mark(const Row& row, double x, double y) {
  if (row.proof == "none") {
    return fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="9" height="9"/>)", x - 4.5, y - 4.5);
  }
  if (row.proof == "bounds") {
    return fmt::format(R"(<path d="M{:.1f} {:.1f}l5.5 9.5h-11z"/>)", x, y - 6);
  }
  return fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="5"/>)", x, y);
}

std::string power(int exponent) {
  return fmt::format(R"(10<tspan class="power" dy="-5">{}</tspan>)", exponent);
}

std::string frame(const Axes& axes) {
  std::string out;
  const double floor = kHeight - kBottom;
  for (int decade = axes.ns.low; decade <= axes.ns.high; ++decade) {
    const double x = axes.x(std::pow(10.0, decade));
    out += fmt::format(R"(<path class="grid" d="M{:.1f} {}V{}"/>)", x, kTop, floor);
    out += fmt::format(R"(<text class="tick" x="{:.1f}" y="{}" text-anchor="middle">{}</text>)", x,
                       floor + 20, time_text(std::pow(10.0, decade)));
  }
  const int span = axes.error.high - axes.error.low;
  const int every = span > 20 ? 5 : span > 8 ? 2 : 1;
  for (int decade = axes.error.low; decade <= axes.error.high; ++decade) {
    if (decade % every != 0) continue;
    const double y = axes.y(std::pow(10.0, decade));
    out += fmt::format(R"(<path class="grid" d="M{} {:.1f}H{}"/>)", kLeft, y, kWidth - kRight);
    out += fmt::format(R"(<text class="tick" x="{}" y="{:.1f}" text-anchor="end">{}</text>)",
                       kLeft - 8, y + 4, power(decade));
  }
  out += fmt::format(R"(<text class="tick" x="{}" y="{}" text-anchor="end">0</text>)", kLeft - 8,
                     axes.y(0.0) + 4);
  out += fmt::format(R"(<text class="tick" x="{}" y="{}" text-anchor="end">none</text>)", kLeft - 8,
                     kTop - kNoneBand + 4);
  out +=
      fmt::format(R"(<path class="axis" d="M{} {}V{}H{}"/>)", kLeft, kTop, floor, kWidth - kRight);
  out +=
      fmt::format(R"(<text class="name" x="{}" y="{}" text-anchor="end">time of a query →</text>)",
                  kWidth - kRight, floor + 44);
  out += fmt::format(
      R"svg(<text class="name" transform="translate(14 {}) rotate(-90)" text-anchor="end">largest error seen →</text>)svg",
      kTop);
  return out;
}

/// The front as stairs: what can be had at most for the time.
std::string stairs(const Axes& axes, const std::vector<const Row*>& front) {
  std::string path;
  for (const Row* row : front) {
    const double x = axes.x(row->ns.median);
    const double y = axes.y(row->error_scale);
    path +=
        path.empty() ? fmt::format("M{:.1f} {:.1f}", x, y) : fmt::format("H{:.1f}V{:.1f}", x, y);
  }
  return fmt::format(R"(<path class="front" d="{}H{}"/>)", path, kWidth - kRight);
}

std::string values_of(const Row& row) {
  return fmt::format(
             "{} ({} to {}), {:.2f} × the time of double\nlargest error: {}; {} of the scale\n"
             "{:.1f} iterations; overlap or not wrong for {}, open for {}, settled for {}, no "
             "answer for {} of {} pairs; {} repetitions",
             time_text(row.ns.median), time_text(row.ns.low), time_text(row.ns.high),
             row.ratio.median, error_text(row.error), error_text(row.error_scale), row.iterations,
             row.wrong, row.undecided, row.settled, row.failed, row.pairs, row.repetitions) +
         (std::isnan(row.instructions) ? ""
                                       : fmt::format("; {:.0f} instructions", row.instructions));
}

std::string dot(const Axes& axes, const Row& row) {
  const std::string values = values_of(row);
  const std::string answer =
      std::isfinite(row.worst.answer) ? fmt::format("{:.9g}", row.worst.answer) : "nothing";
  const std::string worst =
      fmt::format("worst: answered {}, exact {:.9g}", answer, row.worst.distance);
  return fmt::format(
      R"(<g class="dot {}{}" tabindex="0" role="button" aria-label="{}" data-name="{}" data-values="{}" data-worst="{}" data-case="{}">{}</g>)"
      "\n",
      arithmetic_of(row), row.on_front ? " on-front" : "",
      escape_html(row.configuration + ": " + values + "; " + worst), escape_html(row.configuration),
      escape_html(values), escape_html(worst), escape_html(row.worst.json),
      mark(row, axes.x(row.ns.median), axes.y(row.error)));
}

/// The places of rows in the list of the front, below left of their marks: "3", or "3–5" where
/// these are too close to be told apart.
std::string numbers(const Axes& axes, const std::vector<const Row*>& front) {
  constexpr double kWide = 28;
  constexpr double kHigh = 17;
  const auto x = [&](std::size_t i) { return axes.x(front[i]->ns.median); };
  const auto y = [&](std::size_t i) { return axes.y(front[i]->error_scale); };
  std::string out;
  for (std::size_t first = 0, next = 1; first < front.size(); first = next++) {
    while (next < front.size() && x(next) - x(next - 1) < kWide &&
           std::abs(y(next) - y(next - 1)) < kHigh) {
      ++next;
    }
    const std::string text =
        next - first == 1 ? std::to_string(next) : fmt::format("{}–{}", first + 1, next);
    out += fmt::format(R"(<text class="number" x="{:.1f}" y="{:.1f}">{}</text>)", x(first) - 7,
                       y(next - 1) + 16, text);
  }
  return out;
}

std::string front_list(const std::vector<const Row*>& front) {
  std::string out = "<ol>";
  for (const Row* row : front) {
    out += fmt::format("<li>{} <span>{}, error {}</span></li>", escape_html(row->configuration),
                       time_text(row->ns.median), error_text(row->error_scale));
  }
  return out + "</ol>";
}

std::string chart(const Axes& axes, const std::vector<const Row*>& rows) {
  const Row& first = *rows.front();
  std::vector<const Row*> front;
  std::string dots;
  for (const Row* row : rows) {
    if (row->repetitions == 0) continue;
    if (row->on_front) front.push_back(row);
    if (!row->on_front) dots += dot(axes, *row);
  }
  std::sort(front.begin(), front.end(),
            [](const Row* a, const Row* b) { return a->ns.median < b->ns.median; });
  for (const Row* row : front) dots += dot(axes, *row);  // above the others
  return fmt::format(
      R"(<section><h2>{name}</h2><p>{pairs} pairs, {rows} configurations, {repetitions} repetitions.</p>)"
      R"(<svg viewBox="0 0 {width} {height}" role="group" aria-label="Error against time: {name}">{frame}{stairs}
{dots}{numbers}</svg><p>On the front:</p>{list}</section>)"
      "\n",
      fmt::arg("name", escape_html(first.family)), fmt::arg("pairs", first.pairs),
      fmt::arg("rows", rows.size()), fmt::arg("repetitions", first.repetitions),
      fmt::arg("width", kWidth), fmt::arg("height", kHeight), fmt::arg("frame", frame(axes)),
      fmt::arg("stairs", front.empty() ? "" : stairs(axes, front)), fmt::arg("dots", dots),
      fmt::arg("numbers", numbers(axes, front)), fmt::arg("list", front_list(front)));
}

/// The section on configurations that do less and cost more.
std::string costlier(const Study& study) {
  std::string out = "<p>" + escape_html(costlier_about(study)) + "</p>";
  const std::vector<CostlierPair> pairs = costlier_pairs(study);
  if (pairs.empty()) return out;
  out += "<ul>";
  for (const CostlierPair& pair : pairs) {
    out += fmt::format("<li>{} takes {} times as long as {} ({}): {}.</li>", escape_html(pair.less),
                       ratios_text(pair), escape_html(pair.more),
                       escape_html(fmt::format("{}", fmt::join(pair.families, ", "))),
                       escape_html(pair.reason));
  }
  return out + "</ul>";
}

}  // namespace

std::string page(const Study& study, std::string html) {
  const Axes axes(study.rows);
  const Machine& machine = study.machine;
  std::string charts;
  int families = 0;
  for (const auto& rows : by_family(study.rows)) {
    charts += chart(axes, rows);
    ++families;
  }
  const std::string about = fmt::format(
      "{}{} of {} families, in {:.0f} s on {}, one thread; {}, <code>{}</code>, commit {}, seed "
      "{}.",
      study.complete ? "" : "<strong>Interrupted: this is what there was.</strong> ", families,
      study.families_planned, study.seconds, escape_html(machine.processor),
      escape_html(machine.compiler), escape_html(machine.flags), escape_html(machine.commit),
      study.seed);
  html = with_content(std::move(html), "<!-- about -->", about);
  html = with_content(std::move(html), "<!-- charts -->", charts);
  return with_content(std::move(html), "<!-- costlier -->", costlier(study));
}

}  // namespace gjkscope::study
