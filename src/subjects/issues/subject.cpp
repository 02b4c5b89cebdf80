#include "subjects/issues/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::issues{
    .tours = {&tours::kIssues},
    .blocks = {&blocks::kIssuesOfPlaces},
    .layers = {&layers::kEarlierPlaces},
    .effects = {&effect_infos::kNumericalIssue},
};

}  // namespace gjkscope
