#include "cli/trace_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "lesson/names.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector2d;
using gjk::Phase;

/// Left column: iteration headings and phase names.
constexpr int kColumn = 11;

class TraceText {
 public:
  explicit TraceText(const LessonRun& run) : run_(run) {}

  std::string write() {
    const Lesson& lesson = run_.lesson;
    out_ = fmt::format("{}: {}\n", lesson.id, lesson.title.empty() ? lesson.id : lesson.title);
    line("scalar", std::string(name_of(lesson.scalar)));
    line("rules",
         fmt::format("direction {}, regions {}, cap {}{}", name_of(lesson.options.direction_rule),
                     name_of(lesson.options.region_order), lesson.options.iteration_cap,
                     lesson.options.tolerance > 0.0
                         ? fmt::format(", tolerance {}", lesson.options.tolerance)
                         : std::string()));
    for (std::size_t i = 0; i < run_.runs.size(); ++i) {
      const PositionedRun& positioned = run_.runs[i];
      if (run_.runs.size() > 1) {
        out_ += fmt::format("\nrun {} of {}", i + 1, run_.runs.size());
        if (lesson.path_of_shapes->seconds) out_ += fmt::format(", t = {} s", positioned.time);
        out_ += moved(lesson.x, lesson.path_of_shapes->x, positioned.x) +
                moved(lesson.y, lesson.path_of_shapes->y, positioned.y) + "\n";
      }
      one_run(positioned);
    }
    return std::move(out_);
  }

 private:
  void line(std::string_view label, const std::string& text) {
    out_ += fmt::format("  {:<{}}{}\n", label, kColumn, text);
  }

  /// As few digits as name the scalar's value.
  [[nodiscard]] std::string number(double value) const {
    switch (run_.lesson.scalar) {
      case ScalarKind::half:
        return fmt::format("{:.5g}", value);
      case ScalarKind::single:
        return fmt::format("{}", static_cast<float>(value));
      default:
        return fmt::format("{}", value);
    }
  }
  [[nodiscard]] std::string point(const Vector2d& value) const {
    return fmt::format("[{}, {}]", number(value[0]), number(value[1]));
  }

  [[nodiscard]] std::string moved(const LessonShape& shape, const LessonMotion& motion,
                                  const Placement& placement) const {
    if (motion.points.empty()) return {};
    std::string out = fmt::format(", {} moved by {}", shape.name, point(placement.translate));
    if (!motion.turns.empty())
      out += fmt::format(" and turned by {} degrees", number(placement.rotate_degrees));
    return out;
  }

  [[nodiscard]] std::string name(const gjk::SupportPoint<double, 2>& vertex) const {
    return run_.pair_name(vertex.pair);
  }
  [[nodiscard]] std::string face(const gjk::Simplex<double, 2>& simplex, gjk::Face of) const {
    std::vector<std::string> names;
    for (int i = 0; i < simplex.count; ++i) {
      if (gjk::contains(of, i)) names.push_back(name(simplex.vertices[i]));
    }
    return fmt::format("{}", fmt::join(names, " "));
  }

  void one_run(const PositionedRun& positioned) {
    const WideTrace& trace = positioned.trace;
    if (const int exponent = trace.prepared.exponent; exponent != 0) {
      line("unit", fmt::format("2^{}, of lengths other than bounds and result", exponent));
    }
    if (trace.initial.stop != gjk::StopReason::failed) {
      out_ += "\nstart\n";
      const gjk::Simplex<double, 2>& simplex = trace.initial.simplex;
      for (int i = 0; i < simplex.count; ++i) {
        line(i == 0 ? "simplex" : "",
             fmt::format("{} = {}", name(simplex.vertices[i]), point(simplex.vertices[i].w)));
      }
    }
    const gjk::State<double, 2>* before = &trace.initial;
    int iteration = 0;
    for (std::size_t i = 0; i < trace.steps.size(); ++i) {
      const gjk::Step<double, 2>& step = trace.steps[i];
      if (step.iteration != iteration) {
        iteration = step.iteration;
        out_ += fmt::format("\niteration {}\n", iteration);
      }
      one_step(*before, step, positioned.bounds[i]);
      before = &step.after;
    }
    result(trace.result);
  }

  void one_step(const gjk::State<double, 2>& before, const gjk::Step<double, 2>& step,
                const DistanceBounds& bounds) {
    const gjk::State<double, 2>& after = step.after;
    const gjk::Record<double, 2>& record = step.record;
    switch (step.phase) {
      case Phase::closest:
        for (const auto& test : record.region_tests) region_test(before.simplex, test);
        if (record.no_region_held)
          line("", "rounding: no test to believe, the nearest face is taken");
        line("closest", fmt::format("P = {} on {}, |P|^2 = {}", point(after.p),
                                    face(after.simplex, after.region), number(after.p_sq)));
        line("", "weights " + weights(after.simplex));
        break;
      case Phase::cull:
        cull(after, record);
        break;
      case Phase::direction:
        direction(after, record.direction);
        break;
      case Phase::support:
        support(after, record);
        break;
      case Phase::stop:
        for (const auto& test : record.stop_tests) stop_test(test);
        line("bounds", fmt::format("{} to {}", number(bounds.lower), number(bounds.upper)));
        break;
      case Phase::add:
        line("add", "simplex " + face(after.simplex, after.simplex.all()));
        break;
    }
  }

  [[nodiscard]] std::string weights(const gjk::Simplex<double, 2>& simplex) const {
    std::vector<std::string> parts;
    for (int i = 0; i < simplex.count; ++i) {
      parts.push_back(fmt::format("{} {}", name(simplex.vertices[i]), number(simplex.weights[i])));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
  }

  void region_test(const gjk::Simplex<double, 2>& simplex, const gjk::RegionTest<double>& test) {
    std::vector<std::string> terms;
    for (const gjk::RegionTerm<double>& term : test.terms) {
      terms.push_back(fmt::format("{} of {} = {}/{} {} 0: {}", name(simplex.vertices[term.vertex]),
                                  face(simplex, term.face), number(term.numerator),
                                  number(term.denominator),
                                  term.wants_positive ? ">" : "<=", term.holds ? "yes" : "no"));
    }
    if (terms.empty()) terms.emplace_back("a single vertex");
    line("test", fmt::format("region {}: {}", face(simplex, test.region),
                             test.holds ? "holds" : "does not hold"));
    for (const std::string& term : terms) line("", "  " + term);
  }

  void cull(const gjk::State<double, 2>& after, const gjk::Record<double, 2>& record) {
    std::vector<std::string> names;
    for (const auto& vertex : record.dropped) names.push_back(name(vertex));
    line("cull", fmt::format("keeps {}{}", face(after.simplex, after.simplex.all()),
                             names.empty() ? std::string()
                                           : fmt::format(", drops {}", fmt::join(names, " "))));
  }

  void direction(const gjk::State<double, 2>& after, const gjk::DirectionNote<double, 2>& note) {
    if (!note.from_normal) {
      line("direction", fmt::format("d = O - P = {}", point(after.d)));
      return;
    }
    line("direction",
         fmt::format("d = {}, normal of {}{}{}", point(after.d),
                     face(after.simplex, after.simplex.all()), note.flipped ? ", flipped" : "",
                     note.sign_is_arbitrary ? " (O on its line: sign arbitrary)" : ""));
    line("", fmt::format("dot(normal, O - {}) = {}", name(after.simplex.vertices[0]),
                         number(note.side)));
  }

  void scan(std::string_view label, const LessonShape& shape,
            const std::vector<gjk::ScanEntry<double>>& entries, int best) {
    std::vector<std::string> parts;
    for (const gjk::ScanEntry<double>& entry : entries) {
      parts.push_back(fmt::format("{} {}{}",
                                  shape.vertex_names[static_cast<std::size_t>(entry.index)],
                                  number(entry.value), entry.index == best ? " (largest)" : ""));
    }
    line(label, fmt::format("{}: {}", shape.name, fmt::join(parts, ", ")));
  }

  void support(const gjk::State<double, 2>& after, const gjk::Record<double, 2>& record) {
    scan("scan", run_.lesson.y, record.scan_y, after.support.pair.y);
    scan("", run_.lesson.x, record.scan_x, after.support.pair.x);
    line("support",
         fmt::format("{} = {}, dot(d, {}) = {}", name(after.support), point(after.support.w),
                     name(after.support), number(after.support_value)));
  }

  void stop_test(const gjk::StopTest<double>& test) {
    const std::string_view verdict = !test.enabled ? "off"
                                     : !test.tried ? "not tried"
                                     : test.holds  ? "yes"
                                                   : "no";
    if (test.enabled && test.tried) {
      line("stop?", fmt::format("{}: {} (left {}, right {})", name_of(test.reason), verdict,
                                number(test.left), number(test.right)));
    } else {
      line("stop?", fmt::format("{}: {}", name_of(test.reason), verdict));
    }
  }

  void result(const gjk::Result<double, 2>& value) {
    out_ += "\nresult\n";
    if (value.error != gjk::Error::none) {
      line("error", std::string(name_of(value.error)));
      return;
    }
    line("stop", std::string(name_of(value.stop)));
    line("verdict", fmt::format("{}{}", name_of(value.verdict),
                                value.settled ? ", settled in exact arithmetic" : ""));
    line("distance", number(value.distance));
    line("bounds", fmt::format("{} to {}", number(value.lower), number(value.upper)));
    line("on " + run_.lesson.x.name, point(value.x));
    line("on " + run_.lesson.y.name, point(value.y));
    line("simplex", weights(value.simplex));
    line("iterations", fmt::format("{}", value.iterations));
  }

  const LessonRun& run_;
  std::string out_;
};

}  // namespace

std::string trace_text(const LessonRun& run) { return TraceText(run).write(); }

}  // namespace gjkscope
