#include "subjects/grid/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::grid{
    .layers = {&layers::kGrid},
    .effects = {&effect_infos::kGrid},
};

}  // namespace gjkscope
