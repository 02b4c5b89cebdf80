#include "subjects/regions/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::regions{
    .acts = {&acts::kTest},
    .blocks = {&blocks::kTests, &blocks::kRegions},
    .layers = {&layers::kRegions},
    .effects = {&effect_infos::kVoronoiRegions},
};

}  // namespace gjkscope
