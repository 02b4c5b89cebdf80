#include "subjects/answer/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::answer{
    .acts = {&acts::kWitness, &acts::kAnswer},
    .blocks = {&blocks::kWitness, &blocks::kCounters, &blocks::kStarts, &blocks::kBoundSteps},
    .effects = {&effect_infos::kColdStart},
};

}  // namespace gjkscope
