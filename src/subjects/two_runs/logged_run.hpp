#pragma once
// A log of another GJK as a run that is drawn like one of this GJK.

#include "judge/judge.hpp"
#include "run/run.hpp"

namespace gjkscope {

/// The run of a log in the plane, about the shapes of `like`. A step that the log leaves out is
/// left out here, but for P, which is then the simplex's closest point; so is all that follows a
/// simplex that is not known. `judgement` is that of the log, and `stop` why its run ended.
[[nodiscard]] PositionedRun logged_run(const judging::Log& log, const judging::Judgement& judgement,
                                       const PositionedRun& like, gjk::StopReason stop);

}  // namespace gjkscope
