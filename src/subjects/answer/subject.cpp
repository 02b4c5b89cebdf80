#include "subjects/answer/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::answer{
    .tours = {&tours::kWitness, &tours::kAnswer},
    .blocks = {&blocks::kWitness, &blocks::kCounters, &blocks::kStarts, &blocks::kBoundSteps},
    .effects = {&effect_infos::kColdStart},
};

}  // namespace gjkscope
