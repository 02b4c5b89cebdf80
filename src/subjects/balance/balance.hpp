#pragma once
#include <array>
#include <optional>
#include <vector>

#include "run/graph.hpp"
#include "subjects/balance/table.hpp"

namespace gjkscope {

/// The place of a beam at one moment. Lengths are fractions of the beam's, from its end A.
struct Beam {
  double seconds = 0.0;
  double support = 0.5;    ///< The place of the axle, along the beam.
  double angle = 0.0;      ///< Radians; positive lifts B.
  double rate = 0.0;       ///< Radians a second.
  bool on_ground = false;  ///< The ground keeps an end from going lower.
};

/// Part of a step that a beam is shown at several moments of: an index into those of its position.
[[nodiscard]] std::optional<int> beam_moment(const LessonRun& run, const Frame& frame);
/// The time of a frame with such a part.
[[nodiscard]] double seconds_of(const LessonRun& run, const Frame& frame);

/// How far the beam is drawn below its segment, as a fraction of the segment's length.
inline constexpr double kBeamDrop = 0.6;
/// How high a level beam is over the ground, as a fraction of the beam's length.
inline constexpr double kBeamHeight = 0.19;
/// How high the axle that the beam hangs from is over it, in the same unit. A beam that hangs has a
/// level to come to rest at: with 0.15 m its period is about three seconds.
inline constexpr double kAxleHeight = 0.15;
/// The radius of a mass, in the same unit: the area of its disk is as the mass.
[[nodiscard]] double radius_of_mass(double mass);
/// The shares of the time that the support stands in the middle, and at which it has arrived.
inline constexpr double kSupportStarts = 1.0 / 3.0;
inline constexpr double kSupportArrives = 0.5;

/// How far A is to the left of the axle, and B to the right of it, as the beam hangs: the arms by
/// which weights turn it. Negative where an end is on the other one's side.
[[nodiscard]] std::array<double, 2> arms_of(const Beam& beam);

/// The step of a simulation, in seconds, that lessons show.
inline constexpr double kBeamStep = 1.0 / 1024.0;

/// A beam of length 1 m with the middles of `masses` (kg, none negative, not both 0) at its ends A
/// and B, let go level. It hangs from an axle on a support that stands in its middle, then slides
/// to `balance_point` and stays. The axle is damped, and the ground stops the masses and the ends.
/// One state for each moment of `time` at `position`; the same for the same arguments, bit for bit,
/// whatever other moments there are. `step`: of the simulation, in seconds; a power of two, so that
/// steps add up exactly.
[[nodiscard]] std::vector<Beam> swing(const std::array<double, 2>& masses, double balance_point,
                                      const LessonTime& time, int position = 0,
                                      double step = kBeamStep);

/// The weights of a segment as masses on a beam, and G as its balance point (Catto 2010, slides
/// "mass A = mass B" to "massA>0 massB>0"). A negative weight puts no mass on the beam. A simplex
/// that is no segment has no moments.
struct Balance {
  static constexpr std::string_view kName = "balance";
  static constexpr std::string_view kNeeds = "barycentric-weights";
  struct Value {
    std::array<double, 2> weights = {};  ///< u and v, as they are.
    std::array<double, 2> masses = {};   ///< The same, none below 0.
    std::vector<Beam> moments;           ///< One for each of the lesson.
  };
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
