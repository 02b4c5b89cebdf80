#include "subjects/scalars/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::scalars{
    .blocks = {&blocks::kScalars},
    .effects = {&effect_infos::kEveryScalar},
};

}  // namespace gjkscope
