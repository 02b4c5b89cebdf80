#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "subjects/convex_pieces/shown.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::parts {

int Shown::over(PiecesPhase phase, bool of_x) const {
  if (step == nullptr) return 0;
  return static_cast<int>(std::count_if(trace.all.data(), step + 1, [&](const PiecesStep& each) {
    return each.phase == phase && each.of_x == of_x;
  }));
}

const models::PieceRun* Shown::least(int pairs) const {
  const models::PieceRun* found = nullptr;
  for (int i = 0; i < pairs; ++i) {
    const models::PieceRun& run = trace.result.runs[i];
    if (!run.skipped && (found == nullptr || run.distance < found->distance)) found = &run;
  }
  return found;
}

std::vector<int> Shown::tip_and_no_ears(const PiecesStep& at) const {
  const models::Pieces& pieces = trace.of(at.of_x);
  std::vector<int> left;
  for (int i = 0; i < static_cast<int>(pieces.points.size()); ++i) left.push_back(i);
  const auto tip = [&](int triangle) { return pieces.triangles[triangle][1]; };
  for (int i = 0; i < at.index; ++i) std::erase(left, tip(i));
  std::vector<int> out;
  const std::size_t count = left.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::array ear = {left[(i + count - 1) % count], left[i], left[(i + 1) % count]};
    if (left[i] == tip(at.index) || !models::is_ear(pieces.points, ear, left))
      out.push_back(left[i]);
  }
  return out;
}

std::string Shown::piece(bool of_x, int index) const {
  const models::Pieces& pieces = trace.of(of_x);
  if (pieces.pieces.size() == 1) return shape(of_x).name;
  return fmt::format("piece {} of {}", corners_name(shape(of_x), pieces.pieces[index]),
                     shape(of_x).name);
}

namespace {

constexpr std::array kAsks = {kAskDiagonal, kAskPair, kAskEar, kAskFewest};

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const Shown shown(run, frame);
  const PiecesPhase phase = question.ask == kAskPair.name     ? PiecesPhase::pair
                            : question.ask == kAskEar.name    ? PiecesPhase::triangle
                            : question.ask == kAskFewest.name ? PiecesPhase::fewest
                                                              : PiecesPhase::merge;
  if (!shown.is(phase)) return -1;
  // With holes outlines are cut along bridges, too: there corners do not say what is cut off.
  if (phase == PiecesPhase::triangle && (!shown.trace.of(shown.step->of_x).bridges.empty() ||
                                         shown.tip_and_no_ears(*shown.step).size() < 2))
    return -1;
  if (question.at && *question.at != shown.over(phase)) return -1;
  return frame.step;
}

const Tour kTour{
    .name = "convex-pieces",
    .meaning =
        "triangle cut off, then diagonal, then the fewest pieces where they are fewer, then pair "
        "of "
        "convex pieces; then the distance",
    .needs = {.most_vertices = 24, .why_no_until = "frames show all pairs"},
    .add_frames = add_algorithm_frames,
    .follows_run = true,
    .asks = kAsks,
    .answering_step = answering_step,
    .algorithm = &kConvexPiecesAlgorithm,
    .position = position_in_algorithm,
    .tick = tick_of_algorithm,
    .words = words,
    .stage = stage,
    .question = question,
    .values = values,
};

}  // namespace
}  // namespace gjkscope::parts

namespace gjkscope {

const SubjectParts subjects::convex_pieces{
    .tours = {&parts::kTour},
    .blocks = {&parts::kPieces},
    .listings = {&parts::kListing},
    .legend = {{"piece.diagonal", "diagonal that stays"},
               {"piece.fewest", "cut into the fewest pieces"},
               {"piece.turning-in", "corner that turns in"},
               {"piece.gone", "diagonal taken away"},
               {"piece.box", "box around a piece"}},
};

}  // namespace gjkscope
