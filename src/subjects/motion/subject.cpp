#include "subjects/motion/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::motion{
    .layers = {&layers::kLastPosition, &layers::kGrownObstacle, &layers::kPath},
    .effects = {&effect_infos::kLastPosition, &effect_infos::kGrownObstacle},
};

}  // namespace gjkscope
