#pragma once
// The settings that buy accuracy, as values: the arithmetic of a query, how far its answer is
// proved, the rules by which the run decides, when it stops and where it starts.

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

enum class Start : std::uint8_t {
  centers,         ///< The support point along the line between the centers.
  first_vertices,  ///< Vertex 0 of each shape.
  warm,            ///< The simplex that the pair before ended with.
};

struct Configuration {
  Arithmetic arithmetic = Arithmetic::double_;
  Start start = Start::centers;
  gjk::Options options = {};  ///< Its own start is not read: `start` says where a run begins.
};
[[nodiscard]] Configuration configuration(Arithmetic arithmetic,
                                          gjk::Proof proof = gjk::Proof::exact);

/// How the configuration differs from the default, "double": "float, loop only". Names are unique.
/// `advice` explains the words.
[[nodiscard]] std::string name_of(const Configuration& configuration);

/// The configuration of that name; nothing when none has it.
[[nodiscard]] std::optional<Configuration> configuration_named(std::string_view name);

/// The axis along which a configuration differs from the default: "arithmetic", "proof", "direction
/// and regions", "stop rule", "tolerance", "cap", "start".
[[nodiscard]] std::string_view axis_of(const Configuration& configuration);

/// "none", "bounds" or "exact".
[[nodiscard]] std::string_view proof_name(gjk::Proof proof);

/// u, the largest relative error of a rounding to the type of the answer.
[[nodiscard]] double unit_roundoff(Arithmetic arithmetic);

/// The default first; then each axis by itself, and the combinations in which rounding has a say:
/// every proof level in every arithmetic, direction rule and region order in short arithmetic and
/// without proof. `quick`: fewer tolerances and caps.
[[nodiscard]] std::vector<Configuration> configurations(bool quick);

/// Those that are compared over the number of vertices.
[[nodiscard]] std::vector<Configuration> configurations_by_size();

}  // namespace gjkscope::study
