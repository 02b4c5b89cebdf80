#pragma once
// The plane through three points: which side of it a fourth lies on, exactly, and its normal and
// distance from O, with all digits however thin the triangle is. Each is computed in numbers that
// round, with a bound of the error, and anew in exact ones where the bound is too large (Shewchuk
// 1997, "Adaptive precision floating-point arithmetic and fast robust geometric predicates").

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

namespace detail {

/// Numbers R that are not exact, but for Expansion, are exact sums of these.
template <class R>
inline constexpr bool kIsExpansion = std::is_same_v<R, Expansion>;
/// Every number that rounds, and Expansion. Others decide exactly at once.
template <class R>
inline constexpr bool kHasFilter = kIsExpansion<R> || !gjk::ScalarTraits<R>::kExact;
/// The number with a plain exponent and sign that stands for an R.
template <class R>
using Plain = std::conditional_t<kIsExpansion<R>, long double, R>;

template <class R>
[[nodiscard]] Vec<Expansion, 3> exact(const Vec<R, 3>& a) {
  if constexpr (kIsExpansion<R>) {
    return a;
  } else {
    Vec<Expansion, 3> out;
    for (int i = 0; i < 3; ++i) out[i] = Expansion(static_cast<gjk::Wider<R>>(a[i]));
    return out;
  }
}

/// The way from a to b, rounded once.
template <class R>
[[nodiscard]] Vec<Plain<R>, 3> rounded_way(const Vec<R, 3>& a, const Vec<R, 3>& b) {
  return gjk::converted<Plain<R>, R, 3>(Vec<R, 3>(b - a));
}

template <class R>
using Word = gjk::DoubleWord<Plain<R>>;
/// The same with about twice the digits; for numbers that round it is exact.
template <class R>
[[nodiscard]] Vec<Word<R>, 3> in_words(const Vec<R, 3>& a) {
  if constexpr (kIsExpansion<R>) {
    Vec<Word<R>, 3> out;
    for (int i = 0; i < 3; ++i) {
      const auto most = gjk::ScalarTraits<Plain<R>>::from(a[i]);
      out[i] = {most, gjk::ScalarTraits<Plain<R>>::from(a[i] - Expansion(most))};
    }
    return out;
  } else {
    return gjk::converted<Word<R>, R, 3>(a);
  }
}
template <class R>
[[nodiscard]] Vec<Word<R>, 3> way_in_words(const Vec<R, 3>& a, const Vec<R, 3>& b) {
  if constexpr (kIsExpansion<R>) {
    return in_words<R>(Vec<R, 3>(b - a));
  } else {
    return in_words(b) - in_words(a);
  }
}

/// (u x w) . v, and the same with all magnitudes added: a bound of what its roundings multiply.
template <class N>
[[nodiscard]] std::array<N, 2> volume(const Vec<N, 3>& u, const Vec<N, 3>& w, const Vec<N, 3>& v) {
  N sum(0);
  N size(0);
  for (int i = 0; i < 3; ++i) {
    const N left = u[(i + 1) % 3] * w[(i + 2) % 3];
    const N right = u[(i + 2) % 3] * w[(i + 1) % 3];
    sum = sum + N(N(left - right) * v[i]);
    size = size + N(N(gjk::magnitude(left) + gjk::magnitude(right)) * gjk::magnitude(N(v[i])));
  }
  return {sum, size};
}

}  // namespace detail

/// The side of the plane through abc on which p lies: 1 where abc turns counter-clockwise seen from
/// p, -1 where clockwise, 0 in the plane. Exact, for any a, b, c and p.
template <class R>
[[nodiscard]] int side_of(const Vec<R, 3>& a, const Vec<R, 3>& b, const Vec<R, 3>& c,
                          const Vec<R, 3>& p) {
  using N = detail::Plain<R>;
  if constexpr (detail::kHasFilter<R>) {
    const auto [volume, size] = detail::volume<N>(
        detail::rounded_way(a, b), detail::rounded_way(a, c), detail::rounded_way(a, p));
    // Each product of three rounds three times in its factors, twice in itself, and at most three
    // times in sums; 32 leaves room for the bound's own rounding.
    const N rounding = N(32) * gjk::ScalarTraits<N>::unit_roundoff() * size;
    if (rounding + std::numeric_limits<N>::min() < gjk::magnitude(volume))
      return volume < N(0) ? -1 : 1;
    const Vec<Expansion, 3> from = detail::exact(a);
    const Vec<Expansion, 3> n = gjk::cross(Vec<Expansion, 3>(detail::exact(b) - from),
                                           Vec<Expansion, 3>(detail::exact(c) - from));
    return gjk::dot(n, Vec<Expansion, 3>(detail::exact(p) - from)).sign();
  } else {
    const R volume = detail::volume<R>(Vec<R, 3>(b - a), Vec<R, 3>(c - a), Vec<R, 3>(p - a))[0];
    return int{R(0) < volume} - int{volume < R(0)};
  }
}

namespace detail {

/// The plane in numbers N, to which `in_n` brings points and ways.
template <class N>
[[nodiscard]] Plane<N> plane_in(const Vec<N, 3>& a, const Vec<N, 3>& ab, const Vec<N, 3>& ac) {
  const Vec<N, 3> n = gjk::cross(ab, ac);
  return {n, gjk::dot(n, a)};
}

/// Brought to a normal whose largest coordinate lies between 1 and 2.
template <class To, class From>
[[nodiscard]] Plane<To> in_good_unit(const Plane<From>& plane) {
  Plane<To> out;
  const From size = gjk::norm_max(plane.n);
  if (size == From(0)) return out;
  const int exponent = gjk::ScalarTraits<From>::exponent(size);
  const auto scaled = [&](const From& a) {
    return static_cast<To>(gjk::ScalarTraits<From>::scaled(a, -exponent));
  };
  for (int i = 0; i < 3; ++i) out.n[i] = scaled(plane.n[i]);
  out.side = scaled(plane.side);
  return out;
}

template <class R>
[[nodiscard, gnu::noinline]] Plane<Plain<R>> plane_from_exact(const Vec<R, 3>& a,
                                                              const Vec<R, 3>& b,
                                                              const Vec<R, 3>& c) {
  const Vec<Expansion, 3> from = exact(a);
  const Plane<Expansion> plane = plane_in<Expansion>(from, Vec<Expansion, 3>(exact(b) - from),
                                                     Vec<Expansion, 3>(exact(c) - from));
  using Wide = gjk::Wider<Plain<R>>;  // products of three lengths may leave the range of R
  return in_good_unit<Plain<R>>(Plane<Wide>{gjk::converted<Wide, Expansion, 3>(plane.n),
                                            gjk::ScalarTraits<Wide>::from(plane.side)});
}

}  // namespace detail

/// The plane through abc, for numbers that round and for Expansion: each coordinate of n errs by
/// less than 2 u times the length of n, and side by less than 2 u of itself, or is exactly 0. Where
/// abc has no area n = 0. (u is that of long double for Expansion.)
template <class R>
[[nodiscard]] Plane<detail::Plain<R>> careful_plane(const Vec<R, 3>& a, const Vec<R, 3>& b,
                                                    const Vec<R, 3>& c) {
  using N = detail::Plain<R>;
  using Word = detail::Word<R>;
  const auto rounded = [](const Vec<Word, 3>& v) { return gjk::converted<N, Word, 3>(v); };
  const Vec<Word, 3> ab = detail::way_in_words(a, b);
  const Vec<Word, 3> ac = detail::way_in_words(a, c);
  const Vec<Word, 3> from = detail::in_words(a);
  const Plane<Word> words = detail::plane_in<Word>(from, ab, ac);
  const Plane<N> plane{rounded(words.n), gjk::ScalarTraits<N>::from(words.side)};
  // Words err by about 24 u^2 of the products of their lengths in n, 40 u^2 in side.
  const N enough = N(512) * gjk::ScalarTraits<N>::unit_roundoff();
  const N least = std::numeric_limits<N>::min() / enough;
  const N area = enough * N(gjk::norm_max(rounded(ab)) * gjk::norm_max(rounded(ac)));
  const N volume = area * gjk::norm_max(rounded(from));
  const bool is_good = gjk::larger(area, least) < gjk::norm_max(plane.n) &&
                       gjk::larger(volume, least) < gjk::magnitude(plane.side);
  return is_good ? detail::in_good_unit<N>(plane) : detail::plane_from_exact<R>(a, b, c);
}

/// True when abc lie on one line. Exact.
template <class R>
[[nodiscard]] bool has_no_area(const Vec<R, 3>& a, const Vec<R, 3>& b, const Vec<R, 3>& c) {
  if constexpr (gjk::ScalarTraits<R>::kExact) {
    return gjk::is_zero(gjk::cross(Vec<R, 3>(b - a), Vec<R, 3>(c - a)));
  } else {
    return gjk::is_zero(careful_plane(a, b, c).n);
  }
}

/// The normal of abc on the side from which it is counter-clockwise. A triangle without an area has
/// none: any direction perpendicular to its edges will do.
template <class R>
[[nodiscard]] Vec<R, 3> outward_normal(const Vec<R, 3>& a, const Vec<R, 3>& b, const Vec<R, 3>& c) {
  Vec<R, 3> n;
  if constexpr (gjk::ScalarTraits<R>::kExact) {
    n = gjk::cross(Vec<R, 3>(b - a), Vec<R, 3>(c - a));
  } else {
    n = careful_plane(a, b, c).n;
  }
  if (!gjk::is_zero(n)) return n;
  const Vec<R, 3> edge = gjk::is_zero(Vec<R, 3>(b - a)) ? Vec<R, 3>(c - a) : Vec<R, 3>(b - a);
  int along = 0;
  while (along < 2 && edge[along] == R(0)) ++along;
  const Vec<R, 3> axis = Vec<R, 3>::Unit((along + 1) % 3);
  return gjk::is_zero(edge) ? axis : gjk::cross(edge, axis);
}

/// Squared distance of O from the plane through abc, side^2 / |n|^2: negative where O lies outside
/// of it, 0 where abc has no area. It errs by less than 12 u of itself (for Expansion with the u of
/// long double), and not for exact numbers.
template <class R>
[[nodiscard]] R plane_distance_sq(const Vec<R, 3>& a, const Vec<R, 3>& b, const Vec<R, 3>& c) {
  const auto of = [](const auto& plane) {
    using N = std::decay_t<decltype(plane.side)>;
    if (gjk::is_zero(plane.n)) return N(0);
    return N(plane.side * N(gjk::magnitude(plane.side) / gjk::dot(plane.n, plane.n)));
  };
  if constexpr (detail::kHasFilter<R>) {
    return R(of(careful_plane(a, b, c)));
  } else {
    return of(detail::plane_in<R>(a, Vec<R, 3>(b - a), Vec<R, 3>(c - a)));
  }
}

}  // namespace depth::space
