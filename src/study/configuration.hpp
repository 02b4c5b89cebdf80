#pragma once
// What buys accuracy, as values: in which arithmetic a query is answered, how far its answer is
// checked, by which rules the run decides, when it stops and where it starts.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gjk/query.hpp"

namespace gjkscope::study {

/// How coordinates are kept, and what the run computes in. Pairs come in full doubles; keeping them
/// in less rounds them, which is a part of the error.
enum class Arithmetic : std::uint8_t {
  half,
  single,
  single_in_double,  ///< Coordinates are floats, the run computes in double.
  double_,
  long_double,  ///< This and the next compute in more digits than coordinates have.
  quad,
  exact,  ///< Rationals; the answer is rounded once, to double.
};

/// What is made of the simplex that a run ended with.
enum class Effort : std::uint8_t {
  loop,    ///< The distance is |P| as the loop left it: GJK as it stands in a textbook.
  bounds,  ///< With bounds of what rounding can do; close distances are computed anew.
  proof,   ///< Exact arithmetic runs on where the bounds are wide or leave the verdict open.
};

enum class Start : std::uint8_t {
  centres,         ///< The support point along the line between the centres.
  first_vertices,  ///< Vertex 0 of each shape.
  warm,            ///< The simplex that the pair before ended with.
};

struct Configuration {
  Arithmetic arithmetic = Arithmetic::double_;
  Effort effort = Effort::proof;
  Start start = Start::centres;
  gjk::Options options = {};  ///< `proof` and the start follow from the members above.
};

/// What the configuration does otherwise than the first one of `configurations()`: "float, loop
/// only". Names are unique.
[[nodiscard]] std::string name_of(const Configuration& configuration);

/// The configuration of that name; nothing when none has it.
[[nodiscard]] std::optional<Configuration> configuration_named(std::string_view name);

/// The axis along which a configuration differs from the default: "arithmetic", "effort",
/// "direction and regions", "stop rule", "bound gap", "cap", "start".
[[nodiscard]] std::string_view axis_of(const Configuration& configuration);

/// u, the largest relative error of a rounding to the type of the answer.
[[nodiscard]] double unit_roundoff(Arithmetic arithmetic);

/// The default first; then each axis by itself, and the combinations in which rounding has a say:
/// every effort in every arithmetic, direction rule and region order in short arithmetic and
/// without proof. `quick`: fewer gaps and caps.
[[nodiscard]] std::vector<Configuration> configurations(bool quick);

/// Those that are compared over the number of vertices.
[[nodiscard]] std::vector<Configuration> configurations_by_size();

}  // namespace gjkscope::study
