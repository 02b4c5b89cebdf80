#include "subjects/scalars/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::scalars{
    .blocks = {&blocks::kScalars, &blocks::kTwoRuns},
    .effects = {&effect_infos::kEveryScalar, &effect_infos::kSecondRun},
    .adds = captions::second_run,
};

}  // namespace gjkscope
