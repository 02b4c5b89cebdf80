#include "libraries.hpp"

#include <memory>

namespace bench {
namespace {

template <class S>
Contestant prepare_all(std::span<const Pair> pairs) {
  const auto prepared = std::make_shared<std::vector<families::Pair<S>>>();
  for (const Pair& pair : pairs) prepared->push_back(families::converted<S>(pair));
  return contestant(
      pairs.size(), [prepared](std::size_t i) { return gjk::distance((*prepared)[i].query()); },
      [](const auto& result) {
        const bool decided =
            result.verdict != gjk::Verdict::undecided && result.verdict != gjk::Verdict::none;
        return decided ? static_cast<double>(result.distance) : kGaveUp;
      });
}

}  // namespace

Library core_double() {
  return {.name = "gjkscope double",
          .how = "gjk::distance",
          .in_double = true,
          .prepare = prepare_all<double>};
}

Library core_float() {
  return {.name = "gjkscope float", .how = "gjk::distance in float", .prepare = prepare_all<float>};
}

std::vector<Library> libraries() {
  return {
      core_double(), core_float(),
#ifdef GJKSCOPE_BOX2D_2
      box2d_2(),
#endif
#ifdef GJKSCOPE_BOX2D_3
      box2d_3(),
#endif
#ifdef GJKSCOPE_CCD
      libccd(),
#endif
#ifdef GJKSCOPE_FCL
      fcl_own(),     fcl_libccd(),
#endif
#ifdef GJKSCOPE_BULLET
      bullet(),
#endif
  };
}

}  // namespace bench
