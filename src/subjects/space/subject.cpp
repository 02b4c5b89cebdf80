#include "subjects/space/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::space{
    .blocks = {&blocks::kFaces},
    .layers = {&layers::kFloor, &layers::kTriad, &layers::kRegionSolid, &layers::kFacesBefore},
    .effects = {&effect_infos::kShapeSolids, &effect_infos::kDifferenceSolid,
                &effect_infos::kRegionSolid, &effect_infos::kFacesBefore},
};

}  // namespace gjkscope
