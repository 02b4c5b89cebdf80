#include "subjects/space/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::space{
    .blocks = {&blocks::kFaces},
    .layers = {&layers::kFloor, &layers::kTriad, &layers::kDropLine, &layers::kRegionSolid,
               &layers::kFacesBefore},
    .effects = {&effect_infos::kShapeSolids, &effect_infos::kDifferenceSolid,
                &effect_infos::kRegionSolid, &effect_infos::kFacesBefore},
    .legend = {{"support.plane", "support plane, normal to d"},
               {"support.best", "best support plane so far"},
               {"second.closest", "P of the second run"},
               {"second.direction", "d of the second run"},
               {"second.support", "support point of the second run"},
               {"second.plane", "its support plane"},
               {"slab.plane", "side of the empty slab"},
               {"simplex.face", "the face that holds P"},
               {"region.solid", "the region of this feature, cut off"},
               {"face.before", "a face that Q lies beyond"},
               {"shape.hidden", "an edge behind the body"},
               {"shape.x.hidden", "an edge behind the body"},
               {"floor.shadow", "shadow, from straight above"},
               {"floor.drop", "straight down to the floor"}},
};

}  // namespace gjkscope
