#pragma once
// The plane through three points, and which side of it a fourth lies on, exactly. Both are computed
// in numbers that round, with a bound of the error, anew with about twice the digits where it is
// too large, and then in exact ones (Shewchuk 1997, "Adaptive precision floating-point arithmetic
// and fast robust geometric predicates").

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
  /// O from it, squared, or somewhat less; negative where O lies on the outer side.
  Plain<R> distance_sq = Plain<R>(0);
  Plain<R> error = Plain<R>(0);  ///< dot(n, p - a) errs by less than error * norm_1(p - a).
};

/// The power of two by which the largest coordinate of a comes to lie between 1 and 2; 0 for 0.
template <class N>
[[nodiscard]] N good_unit(const Vec<N, 3>& a) {
  const N size = gjk::norm_max(a);
  return size == N(0) ? size
                      : gjk::ScalarTraits<N>::scaled(N(1), -gjk::ScalarTraits<N>::exponent(size));
}

namespace detail {

/// For R that rounds, or is an Expansion.
template <class R>
[[nodiscard]] Vec<Expansion, 3> exact(const Vec<R, 3>& a) {
  return a.template cast<Expansion>();
}

template <class R>
using Word = gjk::DoubleWord<Plain<R>>;

/// From a to b with about twice the digits; for numbers that round it is exact.
template <class R>
[[nodiscard]] Vec<Word<R>, 3> way(const Vec<R, 3>& a, const Vec<R, 3>& b) {
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

/// n = ab x ac, and side = dot(n, a).
template <class N>
struct Products {
  Vec<N, 3> n;
  N side;
};
template <class N>
[[nodiscard]] Products<N> products(const Vec<N, 3>& a, const Vec<N, 3>& ab, const Vec<N, 3>& ac) {
  const Vec<N, 3> n = gjk::cross(ab, ac);
  return {n, gjk::dot(n, a)};
}
/// With all calls inlined, so that compilers split each number into halves once.
template <class R>
[[nodiscard, gnu::flatten]] Products<Word<R>> products_in_words(const Triangle<R>& t,
                                                                const Vec<R, 3>& from,
                                                                const Vec<R, 3>& to) {
  return products(way(from, to), way(t.a, t.b), way(t.a, t.c));
}
/// Wide: products of three lengths may leave the range of R.
template <class R, class Wide = gjk::Wider<Plain<R>>>
[[nodiscard, gnu::noinline]] Products<Wide> exact_products(const Triangle<R>& t) {
  const Vec<Expansion, 3> a = exact(t.a);
  const auto [n, side] = products<Expansion>(a, exact(t.b) - a, exact(t.c) - a);
  return {gjk::converted<Wide, Expansion, 3>(n), gjk::ScalarTraits<Wide>::from(side)};
}

/// With l the sum of the coordinates of p - a and m the largest of n, n errs by less than 2 sqrt(3)
/// u m, p - a by 2 u of itself, products by u, and sums by 2 u: 8.5 u m l in all. 16 leaves room
/// for the bound's own rounding.
template <class R, class N>
[[nodiscard]] Plane<R> in_good_unit(const Products<N>& made) {
  using Traits = gjk::ScalarTraits<Plain<R>>;
  Plane<R> out;
  const N unit = good_unit(made.n);
  if (unit == N(0)) return out;
  out.n = gjk::converted<Plain<R>, N, 3>(Vec<N, 3>(made.n * unit));
  const Plain<R> side = Traits::from(N(made.side * unit));
  out.distance_sq = side * Plain<R>(gjk::magnitude(side) / gjk::dot(out.n, out.n));
  out.error = Plain<R>(16) * Traits::unit_roundoff() * gjk::norm_max(out.n);
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
    const auto words = detail::products_in_words<R>(t, Vec<R, 3>::Zero(), t.a);
    const detail::Products<N> made = {gjk::converted<N, detail::Word<R>, 3>(words.n),
                                      words.side.hi};
    // Words err by about 24 u^2 of the products of their lengths in n, 40 u^2 in side.
    const N enough = N(512) * gjk::ScalarTraits<N>::unit_roundoff();
    const N least = std::numeric_limits<N>::min() / enough;
    const N area = enough * detail::area_of(t);
    const N volume = area * N(gjk::norm_max(gjk::converted<N, R, 3>(t.a)));
    if (gjk::larger(area, least) < gjk::norm_max(made.n) &&
        gjk::larger(volume, least) < gjk::magnitude(made.side))
      return detail::in_good_unit<R>(made);
    return detail::in_good_unit<R>(detail::exact_products(t));
  }
}

/// A rough plane of a triangle that is not thin, whose `distance_sq` is less than that of
/// `careful_plane`; else that one. With s the product of the largest coordinates of b - a and c - a
/// those of n are up to 2 s and err by 8 u s, and products with p - a by 5 u 2 s more: 18 u s; in
/// length n is up to 3 s, errs by 14 u s, and its square rounds by 3 u. Difference, quotient and
/// product round by 4 u, `careful_plane` by 12: the distance errs by 64 u s |a| / |n| at most.
template <class R>
[[nodiscard]] Plane<R> face_plane(const Triangle<R>& t) {
  if constexpr (std::is_floating_point_v<R>) {
    const R u = gjk::ScalarTraits<R>::unit_roundoff();
    const R area = detail::area_of(t);
    Plane<R> out;
    out.n = gjk::cross(Vec<R, 3>(t.b - t.a), Vec<R, 3>(t.c - t.a));
    out.error = R(32) * u * area;
    const R n_sq = gjk::dot(out.n, out.n);
    const R side = gjk::dot(out.n, t.a) - R(3) * out.error * gjk::norm_1(t.a);
    out.distance_sq = side * (std::abs(side) / n_sq);
    const R least = std::numeric_limits<R>::min() / u;
    const bool is_thin = !(area * area < R(kThin * kThin) * n_sq);
    if (!is_thin && least < gjk::smaller(n_sq, std::abs(out.distance_sq))) return out;
  }
  return careful_plane(t);
}

/// True when abc lie on one line. Exact: where it is thin no plane is rough.
template <class R>
[[nodiscard]] bool has_no_area(const Vec<R, 3>& a, const Vec<R, 3>& b, const Vec<R, 3>& c) {
  return gjk::is_zero(face_plane<R>({a, b, c}).n);
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
    const Vec<Word<R>, 3> ap = way(t.a, p);
    if (ap == way(t.b, t.c) || ap == way(t.c, t.b) || way(t.b, p) == way(t.a, t.c)) return 0;
  }
  const N side = products_in_words(t, t.a, p).side.hi;
  const N u = gjk::ScalarTraits<N>::unit_roundoff();
  const N least = std::numeric_limits<N>::min();
  const N length = gjk::norm_1(Vec<N, 3>(gjk::converted<N, R, 3>(Vec<R, 3>(p - t.a))));
  const N rounding = length * N(N(64) * u * u * area_of(t) + least) + least;
  if (rounding < gjk::magnitude(side)) return side < N(0) ? -1 : 1;
  const Vec<Expansion, 3> a = exact(t.a);
  return products<Expansion>(exact(p) - a, exact(t.b) - a, exact(t.c) - a).side.sign();
}

}  // namespace detail

/// The side of the plane of a triangle on which p lies: 1 where it turns counter-clockwise seen
/// from p, -1 where clockwise, 0 in the plane. Exact.
template <class R>
[[nodiscard]] int side_of(const Triangle<R>& t, const Plane<R>& plane, const Vec<R, 3>& p) {
  using N = Plain<R>;
  const Vec<N, 3> way = gjk::converted<N, R, 3>(Vec<R, 3>(p - t.a));
  const N side = gjk::dot(plane.n, way);
  if constexpr (kPlaneRounds<R>) {
    const N rounding = plane.error * gjk::norm_1(way) + std::numeric_limits<N>::min();
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
