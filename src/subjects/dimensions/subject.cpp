#include "subjects/dimensions/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::dimensions{
    .tours = {&gjkscope::dimensions::kTour, &fractions::kTour},
    .blocks = {&gjkscope::dimensions::kBlock, &fractions::kBlock},
    .effects = {&gjkscope::dimensions::kEffect, &fractions::kEffect},
    .legend = {{"fraction", "the part opposite to the marked vertex"},
               {"fraction.negative", "the same, of negative sign"},
               {"fraction.foot", "Q to its foot G"},
               {"fraction.vertex", "the vertex whose weight it is"}},
};

}  // namespace gjkscope
