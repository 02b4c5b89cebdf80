#pragma once
// The plane through three points, with all digits however thin their triangle is, and which side of
// it a fourth lies on, exactly. Each is computed in numbers that round, with a bound of the error,
// and anew in exact ones where the bound is too large (Shewchuk 1997, "Adaptive precision
// floating-point arithmetic and fast robust geometric predicates").

#include "gjk/proof/careful.hpp"

namespace depth::space {

using gjk::Expansion;
using gjk::Vec;

/// Normal n = (b - a) x (c - a), and side = dot(n, a), both times the same power of two.
template <class N>
struct Plane {
  Vec<N, 3> n = Vec<N, 3>::Zero();
  N side = N(0);
};

/// The number that stands for an R in planes: it has one exponent and one sign. That of Expansion
/// rounds.
template <class R>
using Plain = std::conditional_t<std::is_same_v<R, Expansion>, long double, R>;
/// Planes in R round, and are exact otherwise.
template <class R>
inline constexpr bool kPlaneRounds = !gjk::ScalarTraits<Plain<R>>::kExact;

namespace detail {

/// For R that rounds, or is an Expansion.
template <class R>
[[nodiscard]] Vec<Expansion, 3> exact(const Vec<R, 3>& a) {
  return a.template cast<Expansion>();
}

template <class R>
using Word = gjk::DoubleWord<Plain<R>>;

/// With about twice the digits; for numbers that round it is exact.
template <class R>
[[nodiscard]] Vec<Word<R>, 3> in_words(const Vec<R, 3>& a) {
  Vec<Word<R>, 3> out;
  for (int i = 0; i < 3; ++i) {
    const auto most = gjk::ScalarTraits<Plain<R>>::from(a[i]);
    out[i] = {most, gjk::ScalarTraits<Plain<R>>::from(R(a[i] - R(most)))};
  }
  return out;
}
template <class R>
[[nodiscard]] Vec<Word<R>, 3> way_in_words(const Vec<R, 3>& a, const Vec<R, 3>& b) {
  if constexpr (gjk::ScalarTraits<R>::kExact) {
    return in_words<R>(b - a);
  } else {
    return in_words(b) - in_words(a);
  }
}

template <class N>
[[nodiscard]] Plane<N> plane_in(const Vec<N, 3>& a, const Vec<N, 3>& ab, const Vec<N, 3>& ac) {
  const Vec<N, 3> n = gjk::cross(ab, ac);
  return {n, gjk::dot(n, a)};
}

template <class To, class From>
[[nodiscard]] Plane<To> converted(const Plane<From>& plane) {
  return {gjk::converted<To, From, 3>(plane.n), gjk::ScalarTraits<To>::from(plane.side)};
}

/// Brought to a normal whose largest coordinate lies between 1 and 2.
template <class To, class From>
[[nodiscard]] Plane<To> in_good_unit(const Plane<From>& plane) {
  const From size = gjk::norm_max(plane.n);
  if (size == From(0)) return {};
  const int exponent = -gjk::ScalarTraits<From>::exponent(size);
  return converted<To>(Plane<From>{gjk::scaled(plane.n, exponent),
                                   gjk::ScalarTraits<From>::scaled(plane.side, exponent)});
}

template <class R>
[[nodiscard, gnu::noinline]] Plane<Plain<R>> plane_from_exact(const Vec<R, 3>& a,
                                                              const Vec<R, 3>& b,
                                                              const Vec<R, 3>& c) {
  const Vec<Expansion, 3> from = exact(a);
  // Wide: products of three lengths may leave the range of R.
  return in_good_unit<Plain<R>>(
      converted<gjk::Wider<Plain<R>>>(plane_in<Expansion>(from, exact(b) - from, exact(c) - from)));
}

}  // namespace detail

/// The plane through abc. Where R rounds, and for Expansion, the largest coordinate of n lies
/// between 1 and 2, each errs by less than 2 u times the length of n, and side by less than 2 u of
/// itself, or is exactly 0. (u is that of long double for Expansion.) Where abc has no area n = 0.
template <class R>
[[nodiscard]] Plane<Plain<R>> plane_through(const Vec<R, 3>& a, const Vec<R, 3>& b,
                                            const Vec<R, 3>& c) {
  if constexpr (!kPlaneRounds<R>) {
    return detail::plane_in<R>(a, b - a, c - a);
  } else {
    using N = Plain<R>;
    using Word = detail::Word<R>;
    const auto size_of = [](const Vec<Word, 3>& v) {
      return gjk::norm_max(Vec<N, 3>(gjk::converted<N, Word, 3>(v)));
    };
    const Vec<Word, 3> from = detail::in_words(a);
    const Vec<Word, 3> ab = detail::way_in_words(a, b);
    const Vec<Word, 3> ac = detail::way_in_words(a, c);
    const auto plane = detail::converted<N>(detail::plane_in<Word>(from, ab, ac));
    // Words err by about 24 u^2 of the products of their lengths in n, 40 u^2 in side.
    const N enough = N(512) * gjk::ScalarTraits<N>::unit_roundoff();
    const N least = std::numeric_limits<N>::min() / enough;
    const N area = enough * N(size_of(ab) * size_of(ac));
    const bool is_good = gjk::larger(area, least) < gjk::norm_max(plane.n) &&
                         gjk::larger(N(area * size_of(from)), least) < gjk::magnitude(plane.side);
    return is_good ? detail::in_good_unit<N>(plane) : detail::plane_from_exact<R>(a, b, c);
  }
}

/// Squared distance of O from a plane, side^2 / |n|^2: negative where O lies on the outer side, 0
/// where n = 0. It errs by less than 12 u of itself where planes round.
template <class N>
[[nodiscard]] N distance_sq(const Plane<N>& plane) {
  if (gjk::is_zero(plane.n)) return N(0);
  return plane.side * N(gjk::magnitude(plane.side) / gjk::dot(plane.n, plane.n));
}

/// True when abc lie on one line. Exact.
template <class R>
[[nodiscard]] bool has_no_area(const Vec<R, 3>& a, const Vec<R, 3>& b, const Vec<R, 3>& c) {
  return gjk::is_zero(plane_through(a, b, c).n);
}

/// The side of the plane through abc on which p lies: 1 where abc turns counter-clockwise seen from
/// p, -1 where clockwise, 0 in the plane. Exact. `n`: the normal that `plane_through` gives.
template <class R>
[[nodiscard]] int side_of(const Vec<R, 3>& a, const Vec<R, 3>& b, const Vec<R, 3>& c,
                          const Vec<Plain<R>, 3>& n, const Vec<R, 3>& p) {
  using N = Plain<R>;
  const Vec<N, 3> way = gjk::converted<N, R, 3>(Vec<R, 3>(p - a));
  const N side = gjk::dot(n, way);
  if constexpr (kPlaneRounds<R>) {
    // With m the largest coordinate of n and l the sum of those of the way, n errs by less than 2
    // sqrt(3) u m, the way by 2 u of itself, products by u, and sums by 2 u: 8.5 u m l in all. 16
    // leaves room for the bound's own rounding.
    const N rounding =
        N(16) * gjk::ScalarTraits<N>::unit_roundoff() * gjk::norm_max(n) * gjk::norm_1(way);
    if (!(rounding + std::numeric_limits<N>::min() < gjk::magnitude(side))) {
      const Vec<Expansion, 3> from = detail::exact(a);
      return gjk::determinant<Expansion, 3>(
                 {detail::exact(b) - from, detail::exact(c) - from, detail::exact(p) - from})
          .sign();
    }
  }
  return int{N(0) < side} - int{side < N(0)};
}

/// A direction perpendicular to the edge; any if it has no length.
template <class R>
[[nodiscard]] Vec<R, 3> any_perpendicular(const Vec<R, 3>& edge) {
  int along = 0;
  while (along < 2 && edge[along] == R(0)) ++along;
  const Vec<R, 3> axis = Vec<R, 3>::Unit((along + 1) % 3);
  return gjk::is_zero(edge) ? axis : gjk::cross(edge, axis);
}

}  // namespace depth::space
