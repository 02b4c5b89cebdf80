#include "run/trace_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lesson/names.hpp"
#include "run/fields.hpp"

namespace gjkscope {
namespace {

using gjk::Phase;

class TraceText {
 public:
  explicit TraceText(const Traced& traced) : traced_(traced) {}

  std::string write() {
    const gjk::Options& options = traced_.options;
    out_ = fmt::format("{}: {}\n", traced_.id, traced_.title.empty() ? traced_.id : traced_.title);
    line("scalar", std::string(name_of(traced_.scalar)));
    line("rules",
         fmt::format("direction {}, regions {}, cap {}{}", name_of(options.direction_rule),
                     name_of(options.region_order), options.iteration_cap,
                     options.tolerance > 0.0 ? fmt::format(", tolerance {}", options.tolerance)
                                             : std::string()));
    const TracedShape& x = traced_.x;
    const TracedShape& y = traced_.y;
    if (x.radius > 0.0 || y.radius > 0.0) {
      line("radii", fmt::format("{} of {}, {} of {}; all lengths below are without them", x.radius,
                                x.name, y.radius, y.name));
    }
    for (std::size_t i = 0; i < traced_.runs.size(); ++i) {
      if (!traced_.headings.empty()) out_ += fmt::format("\n{}\n", traced_.headings[i]);
      if (traced_.has_gjk()) one_run(traced_.runs[i]);
      const LessonRun* lesson = traced_.lesson_run;
      if (lesson != nullptr && !lesson->algorithm_traces.empty())
        out_ += lesson->algorithm_traces[i]->text(lesson->lesson, lesson->runs[i]);
    }
    return std::move(out_);
  }

 private:
  void line(std::string_view label, const std::string& text) { out_ += fields::line(label, text); }

  [[nodiscard]] std::string number(double value) const {
    return fields::number_text(traced_.scalar, value);
  }
  [[nodiscard]] std::string point(const Eigen::Vector3d& value) const {
    return fields::point_text(traced_.scalar, value.head(traced_.dimension()));
  }

  [[nodiscard]] std::string name(const WideVertex& vertex) const {
    return pair_name(traced_.x.vertex_names, traced_.y.vertex_names, vertex.pair);
  }
  [[nodiscard]] std::string face(const WideSimplex& simplex, gjk::Face of) const {
    std::vector<std::string> names;
    for (int i = 0; i < simplex.count; ++i) {
      if (gjk::contains(of, i)) names.push_back(name(simplex.vertices[i]));
    }
    return fmt::format("{}", fmt::join(names, " "));
  }

  void one_run(const PositionedRun& positioned) {
    const WideTrace& trace = positioned.trace;
    if (const int exponent = trace.exponent; exponent != 0) {
      line("unit", fmt::format("2^{}, of lengths other than bounds and result", exponent));
    }
    if (trace.initial.stop != gjk::StopReason::failed) {
      out_ += "\nstart\n";
      const WideSimplex& simplex = trace.initial.simplex;
      for (int i = 0; i < simplex.count; ++i) {
        line(i == 0 ? "simplex" : "",
             fmt::format("{} = {}", name(simplex.vertices[i]), point(simplex.vertices[i].w)));
      }
    }
    const WideState* before = &trace.initial;
    int iteration = 0;
    for (std::size_t i = 0; i < trace.steps.size(); ++i) {
      const WideStep& step = trace.steps[i];
      if (step.iteration != iteration) {
        iteration = step.iteration;
        out_ += fmt::format("\niteration {}\n", iteration);
      }
      one_step(*before, step, positioned.bounds[i]);
      before = &step.after;
    }
    result(trace.result);
  }

  void one_step(const WideState& before, const WideStep& step, const DistanceBounds& bounds) {
    const WideState& after = step.after;
    const WideRecord& record = step.record;
    switch (step.phase) {
      case Phase::closest:
        for (const auto& test : record.region_tests) region_test(before.simplex, test);
        if (record.no_region_held)
          line("", "rounding: no test to believe, the nearest face is taken");
        line("closest", fmt::format("P = {} on {}, |P|^2 = {}", point(after.p),
                                    face(after.simplex, after.region), number(after.p_sq)));
        line("", "weights " + weights(after.simplex));
        break;
      case Phase::drop:
        drop(after, record);
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

  [[nodiscard]] std::string weights(const WideSimplex& simplex) const {
    std::vector<std::string> parts;
    for (int i = 0; i < simplex.count; ++i) {
      parts.push_back(fmt::format("{} {}", name(simplex.vertices[i]), number(simplex.weights[i])));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
  }

  void region_test(const WideSimplex& simplex, const gjk::RegionTest<double>& test) {
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

  void drop(const WideState& after, const WideRecord& record) {
    std::vector<std::string> names;
    for (const auto& vertex : record.dropped) names.push_back(name(vertex));
    line("drop", fmt::format("keeps {}{}", face(after.simplex, after.simplex.all()),
                             names.empty() ? std::string()
                                           : fmt::format(", drops {}", fmt::join(names, " "))));
  }

  void direction(const WideState& after, const WideDirection& note) {
    const bool is_from_p = after.d == Eigen::Vector3d(-after.p);
    if (traced_.dimension() == 3 && after.simplex.count == 2 && !is_from_p) {
      const std::string a = name(after.simplex.vertices[0]);
      line("direction", fmt::format("d = e x (e x {0}) = {1}, with e = {2} - {0}", a,
                                    point(after.d), name(after.simplex.vertices[1])));
      return;
    }
    if (!note.from_normal) {
      line("direction", fmt::format("d = O - P = {}", point(after.d)));
      return;
    }
    line("direction",
         fmt::format("d = {}, normal of {}{}{}", point(after.d),
                     face(after.simplex, after.simplex.all()), note.flipped ? ", flipped" : "",
                     !note.sign_is_arbitrary    ? ""
                     : traced_.dimension() == 2 ? " (O on its line: sign arbitrary)"
                                                : " (O on its plane: sign arbitrary)"));
    line("", fmt::format("dot(normal, O - {}) = {}", name(after.simplex.vertices[0]),
                         number(note.side)));
  }

  void scan(std::string_view label, const TracedShape& shape,
            const std::vector<gjk::ScanEntry<double>>& entries, int best) {
    line(label, fields::scan_text(traced_.scalar, shape.name, shape.vertex_names, entries, best));
  }

  void support(const WideState& after, const WideRecord& record) {
    scan("scan", traced_.y, record.scan_y, after.support.pair.y);
    scan("", traced_.x, record.scan_x, after.support.pair.x);
    line("support",
         fmt::format("{} = {}, dot(d, {}) = {}", name(after.support), point(after.support.w),
                     name(after.support), number(after.support_value)));
  }

  void stop_test(const gjk::StopTest<double>& test) {
    const std::string_view name = name_of(test.reason);
    const std::string_view verdict = !test.enabled ? "off"
                                     : !test.tried ? "not tried"
                                     : test.holds  ? "yes"
                                                   : "no";
    if (test.enabled && test.tried) {
      line("stop?", fmt::format("{}: {} (left {}, right {})", name, verdict, number(test.left),
                                number(test.right)));
    } else {
      line("stop?", fmt::format("{}: {}", name, verdict));
    }
  }

  void result(const WideResult& value) {
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
    line("on " + traced_.x.name, point(value.x));
    line("on " + traced_.y.name, point(value.y));
    line("simplex", weights(value.simplex));
    line("iterations", fmt::format("{}", value.iterations));
  }

  const Traced& traced_;
  std::string out_;
};

}  // namespace

std::string trace_text(const Traced& traced) { return TraceText(traced).write(); }

}  // namespace gjkscope
