#include "subjects/run/subject.hpp"

#include "subjects/run/code.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::run{
    .tours = {&tours::kIteration, &tours::kPath, &tours::kPhase, &tours::kTest, &tours::kSupport},
    .blocks = {&blocks::kSimplex, &blocks::kScan, &blocks::kBounds, &blocks::kDirectionRules,
               &blocks::kPseudocode, &blocks::kStopTests, &blocks::kTests, &blocks::kRegions},
    .listings = {&listings::kSegment, &listings::kTriangle, &listings::kStructures,
                 &listings::kSupport, &listings::kGjkPoint, &listings::kGjk, &listings::kSegmentCpp,
                 &listings::kSegmentPython, &listings::kTriangleCpp, &listings::kTrianglePython,
                 &listings::kStructuresCpp, &listings::kStructuresPython, &listings::kSupportCpp,
                 &listings::kSupportPython, &listings::kGjkPointCpp, &listings::kGjkPointPython,
                 &listings::kGjkCpp, &listings::kGjkPython},
    .layers = {&layers::kOtherNormal, &layers::kShapes, &layers::kQueryPoint, &layers::kTurn,
               &layers::kStarts},
    .effects = {&effect_infos::kDirectionRules, &effect_infos::kHistory,
                &effect_infos::kOtherNormal, &effect_infos::kVoronoiRegions},
    .legend = {{"simplex.vertex", "vertex of the simplex S"},
               {"support.vertex", "support point"},
               {"closest", "closest point"},
               {"dropped", "dropped vertex"},
               {"support.plane", "support line, normal to d"},
               {"query.earlier", "an earlier place of Q"},
               {"support.best", "best support line so far"},
               {"support.axis.foot", "foot: how far along"},
               {"projection.point", "foot of the perpendicular from Q"},
               {"closest.circle", "as far away as P"},
               {"condition", "a condition holds on the side of the ticks"},
               {"region.rejected", "ruled out"},
               {"hull.ghost", "outline of Z, not known to GJK"},
               {"cloud.point", "a difference y − x"},
               {"cloud.touched", "a difference that was computed"},
               {"pair.link", "joins the two vertices of a difference"},
               {"second.right-angle", "a right angle, stretched as the view is"},
               {"history.closest", "P of an earlier iteration"},
               {"skin.origin", "at the sum of both radii from O"},
               {"skin.gap", "from one round shape to the other"},
               {"path.now", "middle of a shape, on its way"}},
    .adds = captions::direction_rules,
};

}  // namespace gjkscope
