#include "run/trace_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lesson/names.hpp"
#include "lesson/vocabulary.hpp"
#include "run/fields.hpp"

namespace gjkscope {
namespace {

using fields::Json;
using gjk::Phase;

using fields::number;

class TraceWriter {
 public:
  explicit TraceWriter(const Traced& traced) : traced_(traced) {}

  Json write() {
    Json out;
    out["format"] = "gjkscope-trace";
    out["version"] = kTraceFormatVersion;
    out["lesson"] = traced_.id;
    out["title"] = traced_.title;
    out["scalar"] = name_of(traced_.scalar);
    out["dimension"] = traced_.dimension();
    out["options"] = options(traced_.options);
    out["x"] = shape(traced_.x);
    out["y"] = shape(traced_.y);
    out["runs"] = Json::array();
    for (std::size_t i = 0; i < traced_.runs.size(); ++i) {
      Json run = one_run(traced_.runs[i]);
      add_algorithm(run, i);
      out["runs"].push_back(std::move(run));
    }
    return out;
  }

 private:
  [[nodiscard]] Json point(const Eigen::Vector3d& value) const {
    return fields::point(value.head(traced_.dimension()));
  }
  [[nodiscard]] Json points(const std::vector<Eigen::Vector3d>& values) const {
    Json out = Json::array();
    for (const Eigen::Vector3d& value : values) out.push_back(point(value));
    return out;
  }
  static Json pair(gjk::VertexPair value) { return Json::array({value.x, value.y}); }

  static Json options(const gjk::Options& value) {
    Json out;
    out["direction_rule"] = name_of(value.direction_rule);
    out["region_order"] = name_of(value.region_order);
    out["stop_on_repeated_support"] = value.stop_on_repeated_support;
    out["stop_on_no_progress"] = value.stop_on_no_progress;
    out["tolerance"] = number(value.tolerance);
    out["iteration_cap"] = value.iteration_cap;
    out["start_rule"] = value.start.count == 0 ? "center-to-center" : "given";
    out["start"] = Json::array();
    const int count = std::clamp(value.start.count, 0, static_cast<int>(value.start.pairs.size()));
    for (int i = 0; i < count; ++i) out["start"].push_back(pair(value.start.pairs[i]));
    return out;
  }

  [[nodiscard]] Json shape(const TracedShape& value) const {
    Json out;
    out["name"] = value.name;
    out["vertex_names"] = value.vertex_names;
    out["vertices"] = points(value.vertices);
    if (!value.outlines.empty()) out["outlines"] = value.outlines;
    out["translate"] = point(value.placement.translate);
    out["rotate_degrees"] = number(value.placement.rotate_degrees);
    if (value.placement.axis != Placement().axis) out["axis"] = point(value.placement.axis);
    if (value.radius > 0.0) out["radius"] = number(value.radius);
    return out;
  }

  Json one_run(const PositionedRun& value) {
    positioned_ = &value;
    Json out;
    out["time"] = number(value.time);
    out["position"] = point(value.x().placement.translate);
    out["turn"] = number(value.x().placement.rotate_degrees);
    out["y_position"] = point(value.y().placement.translate);
    out["y_turn"] = number(value.y().placement.rotate_degrees);
    out["x_world"] = points(value.x().world);
    out["y_world"] = points(value.y().world);
    if (value.trace.is_empty()) return out;
    out["exponent"] = value.trace.exponent;
    out["initial"] = state(value.trace.initial);
    out["steps"] = Json::array();
    for (std::size_t i = 0; i < value.trace.steps.size(); ++i)
      out["steps"].push_back(one_step(value, i));
    out["result"] = result(value);
    return out;
  }

  Json vertex(const WideVertex& value) const {
    return fields::vertex(
        value, pair_name(traced_.x.vertex_names, traced_.y.vertex_names, value.pair), *positioned_);
  }

  Json simplex(const WideSimplex& value) const {
    Json out = Json::array();
    for (int i = 0; i < value.count; ++i) {
      Json one = vertex(value.vertices[i]);
      one["weight"] = number(value.weights[i]);
      out.push_back(std::move(one));
    }
    return out;
  }

  static Json face(gjk::Face value) {
    Json out = Json::array();
    for (int i = 0; i < 8; ++i) {
      if (gjk::contains(value, i)) out.push_back(i);
    }
    return out;
  }

  Json state(const WideState& value) const {
    Json out;
    out["next_phase"] =
        value.stop == gjk::StopReason::running ? Json(name_of(value.phase)) : Json();
    out["iteration"] = value.iteration;
    out["simplex"] = simplex(value.simplex);
    out["region"] = face(value.region);
    out["p"] = point(value.p);
    out["p_sq"] = number(value.p_sq);
    out["d"] = point(value.d);
    out["support_value"] = number(value.support_value);
    out["best"] = simplex(value.evidence.best);
    out["best_sq"] = number(value.evidence.best_sq);
    out["plane_distance_sq"] = number(value.evidence.plane_distance_sq);
    out["plane_reach_sq"] = number(value.evidence.plane_reach_sq);
    out["touches_plane"] = value.evidence.touches_plane;
    out["stop"] = name_of(value.stop);
    out["error"] = name_of(value.error);
    return out;
  }

  /// Only the members that the phase fills in.
  Json one_step(const PositionedRun& run, std::size_t index) const {
    const WideStep& step = run.trace.steps[index];
    const DistanceBounds& bounds = run.bounds[index];
    Json out;
    out["phase"] = name_of(step.phase);
    out["iteration"] = step.iteration;
    const WideRecord& record = step.record;
    switch (step.phase) {
      case Phase::closest:
        out["region_tests"] = Json::array();
        for (const auto& test : record.region_tests)
          out["region_tests"].push_back(region_test(test));
        out["no_region_held"] = record.no_region_held;
        break;
      case Phase::drop:
        out["dropped"] = Json::array();
        for (const auto& dropped : record.dropped) out["dropped"].push_back(vertex(dropped));
        break;
      case Phase::direction:
        out["direction"] = direction(record.direction);
        break;
      case Phase::support:
        out["scan_x"] = fields::scan(record.scan_x, traced_.x.vertex_names);
        out["scan_y"] = fields::scan(record.scan_y, traced_.y.vertex_names);
        out["support"] = vertex(step.after.support);
        break;
      case Phase::stop:
        out["stop_tests"] = Json::array();
        for (const auto& test : record.stop_tests) out["stop_tests"].push_back(stop_test(test));
        break;
      case Phase::add:
        break;
    }
    out["after"] = state(step.after);
    out["lower"] = number(bounds.lower);
    out["upper"] = number(bounds.upper);
    return out;
  }

  static Json region_test(const gjk::RegionTest<double>& test) {
    Json out;
    out["region"] = face(test.region);
    out["holds"] = test.holds;
    out["terms"] = Json::array();
    for (const gjk::RegionTerm<double>& term : test.terms) {
      Json one;
      one["face"] = face(term.face);
      one["vertex"] = term.vertex;
      one["wants_positive"] = term.wants_positive;
      one["numerator"] = number(term.numerator);
      one["denominator"] = number(term.denominator);
      one["holds"] = term.holds;
      out["terms"].push_back(std::move(one));
    }
    return out;
  }

  [[nodiscard]] Json direction(const WideDirection& note) const {
    Json out;
    out["from_normal"] = note.from_normal;
    out["normal"] = point(note.normal);
    out["side"] = number(note.side);
    out["flipped"] = note.flipped;
    out["sign_is_arbitrary"] = note.sign_is_arbitrary;
    return out;
  }

  static Json stop_test(const gjk::StopTest<double>& test) {
    Json out;
    out["test"] = name_of(test.reason);
    out["enabled"] = test.enabled;
    out["tried"] = test.tried;
    out["holds"] = test.holds;
    out["left"] = number(test.left);
    out["right"] = number(test.right);
    return out;
  }

  Json result(const PositionedRun& run) const {
    const WideResult& value = run.trace.result;
    Json out;
    out["error"] = name_of(value.error);
    out["stop"] = name_of(value.stop);
    out["verdict"] = name_of(value.verdict);
    out["settled"] = value.settled;
    out["distance"] = number(value.distance);
    out["lower"] = number(value.lower);
    out["upper"] = number(value.upper);
    out["distance_sq"] = number(value.distance_sq);
    out["witness_x"] = point(value.x);
    out["witness_y"] = point(value.y);
    out["iterations"] = value.iterations;
    out["simplex"] = simplex(value.simplex);
    return out;
  }

  void add_algorithm(Json& out, std::size_t index) const {
    const LessonRun* lesson = traced_.lesson_run;
    if (lesson == nullptr) return;
    Json own = lesson->algorithm_traces[index]->json(lesson->lesson, lesson->runs[index]);
    if (!own.is_null()) out[std::string(lesson->tour->algorithm->name)] = std::move(own);
  }

  const Traced& traced_;
  const PositionedRun* positioned_ = nullptr;  ///< The run being written.
};

}  // namespace

Json trace_document(const Traced& traced) { return TraceWriter(traced).write(); }

std::string trace_json(const Traced& traced) {
  return trace_document(traced).dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace gjkscope
