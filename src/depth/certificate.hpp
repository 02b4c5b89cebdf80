#pragma once
// Proved bounds of the depth, which include what rounding can do.
//
// From below: corners are points of Z, up to rounding, so what they enclose lies in Z: no point of
// the boundary of Z is nearer to O than the nearest face. From above: by how far Z reaches along
// one direction X can leave Y. If this proves too little the same loop runs in exact arithmetic,
// from GJK's simplex. tests/depth holds all of it against exact answers.

#include "depth/plane/certificate.hpp"
#include "depth/space/certificate.hpp"
#include "gjk/proof/settle.hpp"

namespace depth::detail {

/// In space GJK's own witness points are the contact where the shapes touch: its simplex holds O.
template <int D>
[[nodiscard]] constexpr bool has_own_contact(gjk::Verdict verdict) {
  return D == 2 || verdict != gjk::Verdict::touching;
}

/// How often the bounds of `settle` round to R at worst: the length, with what is left of the
/// roundings in Wide, and the bound three times.
inline constexpr int kSettledRoundings = 6;

/// The same run in exact arithmetic, from GJK's simplex. False, with `out` as it was, when there is
/// no room for exact products.
template <class R, class S, int D>
[[nodiscard, gnu::noinline]] bool settle(const gjk::Result<R, D>& found,
                                         const gjk::Query<S, D>& query,
                                         const gjk::Prepared<R, D>& prepared, Proof<R, D>& out) {
  using gjk::Expansion;
  using Wide = gjk::Wider<R>;
  const auto exact = gjk::prepared_exactly(query, prepared);
  if (!gjk::has_exact_products(query, prepared.same_frame, exact.exponent)) return false;
  State<Expansion, D> end = start(query, exact, found);
  run(end, query, exact);
  const int exponent = exact.exponent - prepared.exponent;

  const Vec<Wide, D> n = gjk::converted<Wide, Expansion, D>(end.n);
  const Wide n_length = gjk::careful_length(n);
  for (int i = 0; i < D; ++i) out.direction[i] = static_cast<R>(n[i] / n_length);
  out.depth = out.lower = out.upper = R(0);
  if (found.verdict != gjk::Verdict::touching) {
    const Vec<Expansion, D> along_it = gjk::converted<Expansion, R, D>(out.direction);
    const auto farthest =
        gjk::support_point(query, exact, gjk::farthest_pair(query, exact, along_it));
    const Wide reach = gjk::ScalarTraits<Wide>::from(gjk::dot(along_it, farthest.w)) /
                       gjk::length(gjk::converted<Wide, Expansion, D>(along_it));
    const R few = R(kSettledRoundings) * gjk::ScalarTraits<R>::unit_roundoff();
    const R least = std::numeric_limits<R>::denorm_min();
    const auto in_unit = [&](const Wide& length) {  // R may not hold it in that of the exact run
      return static_cast<R>(gjk::ScalarTraits<Wide>::scaled(length, exponent));
    };
    const R lower = in_unit(exact_distance<Wide>(end));
    const R upper = in_unit(reach);
    out.lower = std::max(R(lower - few * lower - least), R(0));
    out.upper = upper + few * upper + least;
    out.depth = std::clamp(D == 2 ? lower : upper, out.lower, out.upper);
  }
  if (has_own_contact<D>(found.verdict)) {
    const Vec<R, D> t = out.direction * out.depth;
    out.face = contact_face(end, t, query, prepared, exponent);
  }
  return true;
}

}  // namespace depth::detail
