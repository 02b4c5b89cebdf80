#pragma once
// The names of phases and stop reasons of penetration depth.

#include "depth/state.hpp"
#include "lesson/names.hpp"

namespace gjkscope {

template <>
struct Named<depth::Phase> {
  static constexpr std::array<std::pair<std::string_view, depth::Phase>, 4> kTable = {
      {{"nearest", depth::Phase::nearest},
       {"support", depth::Phase::support},
       {"stop", depth::Phase::stop},
       {"expand", depth::Phase::expand}}};
};
template <>
struct Named<depth::StopReason> {
  static constexpr std::array<std::pair<std::string_view, depth::StopReason>, 7> kTable = {
      {{"running", depth::StopReason::running},
       {"repeated-support", depth::StopReason::repeated_support},
       {"no-progress", depth::StopReason::no_progress},
       {"iteration-cap", depth::StopReason::iteration_cap},
       {"separated", depth::StopReason::separated},
       {"undecided", depth::StopReason::undecided},
       {"failed", depth::StopReason::failed}}};
};

}  // namespace gjkscope
