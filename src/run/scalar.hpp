#pragma once
// From a scalar's name to its type.

#include <type_traits>

#include "exact/rational.hpp"
#include "lesson/lesson.hpp"

namespace gjkscope {

/// Calls `function(std::type_identity<S>{})` with the type that `kind` names.
template <class Function>
decltype(auto) with_scalar(ScalarKind kind, Function&& function) {
  switch (kind) {
    case ScalarKind::half:
      return function(std::type_identity<Eigen::half>{});
    case ScalarKind::single:
      return function(std::type_identity<float>{});
    case ScalarKind::exact:
      return function(std::type_identity<Rational>{});
    case ScalarKind::double_:
      break;
  }
  return function(std::type_identity<double>{});
}

}  // namespace gjkscope
