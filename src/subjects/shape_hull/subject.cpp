#include "subjects/shape_hull/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::shape_hull{
    .layers = {&layers::kShapeHull},
    .effects = {&effect_infos::kShapeHull},
    .adds = captions::shape_hull,
};

}  // namespace gjkscope
