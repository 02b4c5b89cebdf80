#include <array>

#include "subjects/slab_proof/shown.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::slabs {
namespace {

constexpr std::array kAsks = {kAskVertex, kAskAngle};

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const Shown shown(run, frame);
  const bool is_angle = question.ask == kAskAngle.name;
  if (!shown.is(is_angle ? slab_proof::Phase::closer : slab_proof::Phase::slab)) return -1;
  if (question.at && *question.at != run.info(frame).iteration) return -1;
  return frame.step;
}

const Tour kTour{
    .name = "slab-proof",
    .meaning = "slab between two points, and for each closer point, until a slab is empty",
    .needs = {.why_no_until = "frames show how the slab becomes empty"},
    .add_frames = add_algorithm_frames,
    .follows_run = true,
    .asks = kAsks,
    .answering_step = answering_step,
    .algorithm = &kSlabProofAlgorithm,
    .position = position_in_algorithm,
    .tick = tick_of_algorithm,
    .words = words,
    .stage = stage,
    .question = question,
    .values = values,
};

}  // namespace
}  // namespace gjkscope::slabs

namespace gjkscope {

const SubjectParts subjects::slab_proof{
    .tours = {&slabs::kTour},
    .blocks = {&slabs::kSlabBlock},
    .listings = {&slabs::kListing},
    .legend = {{"slab.side", "side of the slab"},
               {"slab.vertex", "vertex in the slab"},
               {"slab.was", "where it was"}},
};

}  // namespace gjkscope
