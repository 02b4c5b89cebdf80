#include "subjects/convex_pieces/lesson_trace.hpp"

#include <array>
#include <limits>
#include <nlohmann/json.hpp>

namespace gjkscope {
namespace {

using fields::Json;

constexpr std::array<std::string_view, 4> kPhases = {"triangle", "merge", "fewest", "pair"};
constexpr std::array<std::string_view, 3> kAnswers = {"distance", "pieces", "runs"};
constexpr std::array<PlaceholderInfo, 3> kValues = {
    {{"triangles", "triangles that both shapes are cut into by now"},
     {"runs", "runs of GJK by now"},
     {"least", "least distance of a pair of pieces by now"}}};

std::shared_ptr<const AlgorithmTrace> run_pieces(const Lesson& lesson, const PositionedRun& run,
                                                 const AlgorithmTrace*) {
  const OutlinesOfRun outlines = outlines_of(lesson, run);
  return std::make_shared<const PiecesTrace>(refusal_of(outlines, models::Needs::simple), outlines);
}

}  // namespace

PiecesTrace::PiecesTrace(std::optional<Refusal> refused, const OutlinesOfRun& outlines)
    : OutlineTrace(refused) {
  if (refusal) return;
  x = models::pieces_of(outlines.x);
  y = models::pieces_of(outlines.y);
  result = models::pieces_distance(outlines.x, outlines.y, x, y);
  const auto add = [&](PiecesPhase phase, bool of_x, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) all.push_back({phase, of_x, static_cast<int>(i)});
  };
  for (const bool of_x : {true, false}) {
    // A shape that is a triangle is cut into nothing.
    if (of(of_x).triangles.size() > 1) add(PiecesPhase::triangle, of_x, of(of_x).triangles.size());
  }
  for (const bool of_x : {true, false}) add(PiecesPhase::merge, of_x, of(of_x).merges.size());
  for (const bool of_x : {true, false}) {
    const models::Model& model = of_x ? outlines.x : outlines.y;
    if (model.outlines.size() != 1) continue;
    fewest[of_x ? 0 : 1] = models::fewest_pieces(model.outlines.front());
    turning_in[of_x ? 0 : 1] = models::corners_turning_in(model.outlines.front());
    if (fewest_of(of_x).size() < of(of_x).pieces.size()) add(PiecesPhase::fewest, of_x, 1);
  }
  add(PiecesPhase::pair, false, result.runs.size());
}

StepInfo PiecesTrace::info(int index) const {
  const PiecesStep& step = all[index];
  const bool is_event = step.phase == PiecesPhase::pair && result.runs[step.index].skipped;
  return {index + 1, kPhases[static_cast<std::size_t>(step.phase)], is_event};
}

double PiecesTrace::answer(std::string_view name) const {
  if (refusal) return std::numeric_limits<double>::quiet_NaN();
  if (name == "pieces") return static_cast<double>(x.pieces.size() + y.pieces.size());
  return name == "runs" ? static_cast<double>(result.visits) : result.answer.distance;
}

Json PiecesTrace::step_json(const Lesson& lesson, int index) const {
  const PiecesStep& step = all[index];
  const auto at = static_cast<std::size_t>(step.index);
  const LessonShape& shape = step.of_x ? lesson.x() : lesson.y();
  const models::Pieces& pieces = of(step.of_x);
  if (step.phase == PiecesPhase::triangle)
    return {{"of", shape.name}, {"corners", corners_name(shape, pieces.triangles[at])}};
  if (step.phase == PiecesPhase::merge) {
    const models::Merge& merge = pieces.merges[at];
    return {{"of", shape.name},
            {"diagonal", corners_name(shape, std::array{merge.from, merge.to})},
            {"taken_away", merge.merged}};
  }
  if (step.phase == PiecesPhase::fewest)
    return {{"of", shape.name},
            {"found", pieces.pieces.size()},
            {"fewest", fewest_of(step.of_x).size()},
            {"corners_turning_in", turning_in[step.of_x ? 0 : 1].size()}};
  const models::PieceRun& run = result.runs[at];
  Json out = {{"x", corners_name(lesson.x(), x.pieces[run.a])},
              {"y", corners_name(lesson.y(), y.pieces[run.b])},
              {"bound", fields::number(run.bound)},
              {"least_before", fields::number(run.least)},
              {"skipped", run.skipped}};
  if (run.skipped) return out;
  out["distance"] = fields::number(run.distance);
  out["iterations"] = run.iterations;
  return out;
}

Json PiecesTrace::result_json(const Lesson&) const {
  return {{"distance", fields::number(result.answer.distance)},
          {"overlap", result.answer.overlap},
          {"closest_x", fields::point(result.answer.a)},
          {"closest_y", fields::point(result.answer.b)},
          {"pieces_x", x.pieces.size()},
          {"pieces_y", y.pieces.size()},
          {"runs", result.visits}};
}

const Algorithm kConvexPiecesAlgorithm{.name = "convex-pieces",
                                       .phases = kPhases,
                                       .answers = kAnswers,
                                       .values = kValues,
                                       .run = run_pieces,
                                       .takes_outlines = true};

}  // namespace gjkscope
