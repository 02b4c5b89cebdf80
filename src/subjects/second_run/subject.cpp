#include "subjects/second_run/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::second_run{
    .blocks = {&blocks::kTwoRuns},
    .effects = {&effect_infos::kSecondRun},
    .adds = captions::second_run,
};

}  // namespace gjkscope
