#pragma once
// The plane through three points, and which side of it a fourth lies on, exactly. Both are computed
// in numbers that round, with a bound of the error, anew with about twice the digits where it is
// too large, and then in exact ones (Shewchuk 1997, "Adaptive precision floating-point arithmetic
// and fast robust geometric predicates").

#include <utility>

#include "gjk/proof/careful.hpp"

namespace depth::space {

using gjk::Expansion;
using gjk::Vec;

/// The number that stands for an R in planes: it has one exponent and one sign. That of Expansion
/// rounds.
template <class R>
using Plain = std::conditional_t<std::is_same_v<R, Expansion>, long double, R>;
/// Planes in R round, and are exact otherwise.
template <class R>
inline constexpr bool kPlaneRounds = !gjk::ScalarTraits<Plain<R>>::kExact;

/// Triangles that are thinner, by the product of two sides as a share of twice the area, have
/// planes with all digits.
inline constexpr int kThin = 32;
/// For any plane: dot(n, p - a) errs by less than so many u norm_max(n) norm_1(p - a), and the
/// distance of O by less than so many u |a|. See `face_plane`.
inline constexpr int kPlaneRoundings = 512;

template <class R>
struct Triangle {
  const Vec<R, 3>& a;
  const Vec<R, 3>& b;
  const Vec<R, 3>& c;
};

/// The plane of a triangle abc.
template <class R>
struct Plane {
  Vec<Plain<R>, 3> n = Vec<Plain<R>, 3>::Zero();  ///< (b - a) x (c - a) times a power of two.
  /// O from it, squared; negative where O lies on the outer side.
  Plain<R> distance_sq = Plain<R>(0);
};

namespace detail {

template <class R>
using Word = gjk::DoubleWord<Plain<R>>;

/// From a to b with about twice the digits; for numbers that round it is exact.
template <class R>
[[nodiscard]] Vec<Word<R>, 3> difference(const Vec<R, 3>& a, const Vec<R, 3>& b) {
  using Traits = gjk::ScalarTraits<Plain<R>>;
  Vec<Word<R>, 3> out;
  for (int i = 0; i < 3; ++i) {
    if constexpr (gjk::ScalarTraits<R>::kExact) {
      const R difference = b[i] - a[i];
      const Plain<R> most = Traits::from(difference);
      out[i] = {most, Traits::from(R(difference - R(most)))};
    } else {
      out[i] = gjk::exact_sum(b[i], R(-a[i]));
    }
  }
  return out;
}
/// The product of the largest coordinates of b - a and c - a.
template <class R>
[[nodiscard]] Plain<R> area_of(const Triangle<R>& t) {
  const auto size = [](const Vec<R, 3>& edge) {
    return gjk::norm_max(Vec<Plain<R>, 3>(gjk::converted<Plain<R>, R, 3>(edge)));
  };
  return size(t.b - t.a) * size(t.c - t.a);
}

/// ab x ac, and its product with a.
template <class N>
[[nodiscard]] std::pair<Vec<N, 3>, N> products(const Vec<N, 3>& a, const Vec<N, 3>& ab,
                                               const Vec<N, 3>& ac) {
  const Vec<N, 3> n = gjk::cross(ab, ac);
  return {n, gjk::dot(n, a)};
}
/// With all calls inlined, so that compilers split each number into halves once.
template <class R>
[[nodiscard, gnu::flatten]] std::pair<Vec<Word<R>, 3>, Word<R>> products_in_words(
    const Triangle<R>& t, const Vec<R, 3>& from, const Vec<R, 3>& to) {
  return products(difference(from, to), difference(t.a, t.b), difference(t.a, t.c));
}
/// For R that rounds, or is an Expansion.
template <class R>
[[nodiscard, gnu::noinline]] std::pair<Vec<Expansion, 3>, Expansion> exact_products(
    const Triangle<R>& t, const Vec<R, 3>& from, const Vec<R, 3>& to) {
  const auto exact_difference = [](const Vec<R, 3>& a, const Vec<R, 3>& b) {
    return Vec<Expansion, 3>(b.template cast<Expansion>() - a.template cast<Expansion>());
  };
  return products(exact_difference(from, to), exact_difference(t.a, t.b),
                  exact_difference(t.a, t.c));
}

template <class R, class N>
[[nodiscard]] Plane<R> in_good_unit(const Vec<N, 3>& n, const N& side) {
  Plane<R> out;
  const N size = gjk::norm_max(n);
  if (size == N(0)) return out;
  const N unit = gjk::ScalarTraits<N>::scaled(N(1), -gjk::ScalarTraits<N>::exponent(size));
  out.n = gjk::converted<Plain<R>, N, 3>(Vec<N, 3>(n * unit));
  const Plain<R> in_unit = gjk::ScalarTraits<Plain<R>>::from(N(side * unit));
  out.distance_sq = in_unit * Plain<R>(gjk::magnitude(in_unit) / gjk::dot(out.n, out.n));
  return out;
}

}  // namespace detail

/// The plane with all digits. Where R rounds, and for Expansion, the largest coordinate of n lies
/// between 1 and 2, each errs by less than 2 u times the length of n, and distance_sq by less than
/// 12 u of itself, or is exactly 0. (u is that of long double for Expansion.) Where abc has no area
/// n = 0.
template <class R>
[[nodiscard]] Plane<R> careful_plane(const Triangle<R>& t) {
  if constexpr (!kPlaneRounds<R>) {
    const auto [n, side] = detail::products<R>(t.a, t.b - t.a, t.c - t.a);
    if (gjk::is_zero(n)) return {};
    return {n, side * R(gjk::magnitude(side) / gjk::dot(n, n))};
  } else {
    using N = Plain<R>;
    const Vec<R, 3> origin = Vec<R, 3>::Zero();
    const auto words = detail::products_in_words<R>(t, origin, t.a);
    const Vec<N, 3> n = gjk::converted<N, detail::Word<R>, 3>(words.first);
    const N& side = words.second.hi;
    // Words err by about 24 u^2 of the products of their lengths in n, 40 u^2 in side.
    const N enough = N(512) * gjk::ScalarTraits<N>::unit_roundoff();
    const N least = std::numeric_limits<N>::min() / enough;
    const N area = enough * detail::area_of(t);
    const N volume = area * N(gjk::norm_max(gjk::converted<N, R, 3>(t.a)));
    if (gjk::larger(area, least) < gjk::norm_max(n) &&
        gjk::larger(volume, least) < gjk::magnitude(side))
      return detail::in_good_unit<R>(n, side);
    using Wide = gjk::Wider<N>;  // products of three lengths may leave the range of R
    const auto exact = detail::exact_products<R>(t, origin, t.a);
    return detail::in_good_unit<R, Wide>(gjk::converted<Wide, Expansion, 3>(exact.first),
                                         gjk::ScalarTraits<Wide>::from(exact.second));
  }
}

/// A rough plane of a triangle that is not thin, else the careful one. With s = |b - a||c - a|, at
/// most kThin |n|, edges err by u of themselves and n by 4.4 u s, thus by 141 u |n|; products with
/// another vector by 3 u more, which is 250 u norm_max(n) norm_1(p - a); the distance errs by 141 u
/// |a| once more, and by 6 u of itself.
template <class R>
[[nodiscard]] Plane<R> face_plane(const Triangle<R>& t) {
  if constexpr (std::is_floating_point_v<R>) {
    const Vec<R, 3> ab = t.b - t.a;
    const Vec<R, 3> ac = t.c - t.a;
    const Vec<R, 3> n = gjk::cross(ab, ac);
    const R n_sq = gjk::dot(n, n);
    const R least = std::numeric_limits<R>::min() / gjk::ScalarTraits<R>::unit_roundoff();
    if (gjk::dot(ab, ab) * gjk::dot(ac, ac) + least < R(kThin * kThin) * n_sq) {
      const R side = gjk::dot(n, t.a);
      return {n, side * (std::abs(side) / n_sq)};
    }
  }
  return careful_plane(t);
}

namespace detail {

/// `side_of` where the error of a plane leaves it open. Faces of Z that an edge of X and one of Y
/// make are parallelograms, often exactly. Words err by less than 24 u^2 of the products of their
/// lengths in n, and by 40 u^2 with it; 64 leaves room for the bound's rounding, and min() for
/// underflow.
template <class R>
[[nodiscard, gnu::noinline]] int careful_side(const Triangle<R>& t, const Vec<R, 3>& p) {
  using N = Plain<R>;
  if constexpr (!gjk::ScalarTraits<R>::kExact) {
    const Vec<Word<R>, 3> ap = difference(t.a, p);
    if (ap == difference(t.b, t.c) || ap == difference(t.c, t.b) ||
        difference(t.b, p) == difference(t.a, t.c))
      return 0;
  }
  const N side = products_in_words(t, t.a, p).second.hi;
  const N u = gjk::ScalarTraits<N>::unit_roundoff();
  const N least = std::numeric_limits<N>::min();
  const N length = gjk::norm_1(Vec<N, 3>(gjk::converted<N, R, 3>(Vec<R, 3>(p - t.a))));
  const N rounding = length * N(N(64) * u * u * area_of(t) + least) + least;
  if (rounding < gjk::magnitude(side)) return side < N(0) ? -1 : 1;
  return exact_products(t, t.a, p).second.sign();
}

}  // namespace detail

/// The side of the plane of a triangle on which p lies: 1 where it turns counter-clockwise seen
/// from p, -1 where clockwise, 0 in the plane. Exact.
template <class R>
[[nodiscard]] int side_of(const Triangle<R>& t, const Plane<R>& plane, const Vec<R, 3>& p) {
  using N = Plain<R>;
  const Vec<N, 3> difference = gjk::converted<N, R, 3>(Vec<R, 3>(p - t.a));
  const N side = gjk::dot(plane.n, difference);
  if constexpr (kPlaneRounds<R>) {
    const N u = gjk::ScalarTraits<N>::unit_roundoff();
    const N rounding = N(kPlaneRoundings) * u * gjk::norm_max(plane.n) * gjk::norm_1(difference) +
                       std::numeric_limits<N>::min();
    if (!(rounding < gjk::magnitude(side))) return detail::careful_side(t, p);
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
