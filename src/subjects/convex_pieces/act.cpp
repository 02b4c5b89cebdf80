#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "subjects/convex_pieces/shown.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::parts {

int Shown::over(PiecesPhase phase, bool of_x) const {
  if (step == nullptr) return 0;
  return static_cast<int>(std::count_if(told.told.data(), step + 1, [&](const PiecesStep& each) {
    return each.phase == phase && each.of_x == of_x;
  }));
}

const models::PieceRun* Shown::least(int pairs) const {
  const models::PieceRun* found = nullptr;
  for (int i = 0; i < pairs; ++i) {
    const models::PieceRun& run = told.result.runs[static_cast<std::size_t>(i)];
    if (!run.skipped && (found == nullptr || run.distance < found->distance)) found = &run;
  }
  return found;
}

std::string Shown::piece(bool of_x, int index) const {
  const models::Pieces& pieces = told.of(of_x);
  if (pieces.pieces.size() == 1) return shape(of_x).name;
  return fmt::format("piece {} of {}",
                     corners_name(shape(of_x), pieces.pieces[static_cast<std::size_t>(index)]),
                     shape(of_x).name);
}

namespace {

constexpr std::array kAsks = {kAskDiagonal, kAskPair};

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const Shown shown(run, frame);
  const PiecesPhase phase = question.ask == kAskPair.name ? PiecesPhase::pair : PiecesPhase::merge;
  if (!shown.is(phase)) return -1;
  if (question.at && *question.at != shown.over(phase)) return -1;
  return frame.step;
}

const Act kAct{
    .name = "convex-pieces",
    .meaning = "triangle cut off, then diagonal, then pair of convex pieces; then the distance",
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
    .acts = {&parts::kAct},
    .blocks = {&parts::kPieces},
    .listings = {&parts::kListing},
    .legend = {{"piece.diagonal", "diagonal that stays"},
               {"piece.gone", "diagonal taken away"},
               {"piece.box", "box around a piece"}},
};

}  // namespace gjkscope
