#include "subjects/difference/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::difference{
    .tours = {&tours::kPairs},
    .blocks = {&blocks::kPairs},
    .listings = {&listings::kMinkowski},
    .layers = {&layers::kDifference, &layers::kCornerNames},
    .effects = {&effect_infos::kMinkowskiCloud, &effect_infos::kMinkowskiHull},
};

}  // namespace gjkscope
