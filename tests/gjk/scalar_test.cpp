// What the core relies on in a scalar type.

#include "gjk/scalar.hpp"

#include "check.hpp"

namespace {

template <class S>
void check_roots() {
  using Traits = gjk::ScalarTraits<S>;
  for (const double value : {0.0, 0.25, 1.0, 2.0, 3.0, 0.001, 1000.0, 7.5e-4}) {
    const check::Context context("value", value);
    const S square(value);
    const S below = Traits::root_below(square);
    const S above = Traits::root_above(square);
    CHECK(!(Traits::root(square) < below));
    CHECK(!(above < Traits::root(square)));
    // 64-bit mantissas multiply the bounds without noticeable error of their own.
    const auto wide = static_cast<long double>(square);
    CHECK(static_cast<long double>(below) * static_cast<long double>(below) <= wide);
    CHECK(static_cast<long double>(above) * static_cast<long double>(above) >= wide);
    CHECK_NEAR(
        static_cast<long double>(below), static_cast<long double>(above),
        static_cast<long double>(above) * 32 * static_cast<long double>(Traits::unit_roundoff()));
  }
}

TEST(roots, "root_below and root_above bound the root, closely") {
  check_roots<float>();
  check_roots<double>();
  check_roots<long double>();
  check_roots<Eigen::half>();
}

template <class S>
void check_traits() {
  using Traits = gjk::ScalarTraits<S>;
  const S u = Traits::unit_roundoff();
  CHECK_EQ(S(1), S(S(1) + u));
  CHECK(S(1) < S(S(1) + S(3) * u));
  CHECK(S(0) < Traits::smallest());
  CHECK_EQ(S(0), S(Traits::smallest() * S(0.25)));
  CHECK(Traits::is_finite(std::numeric_limits<S>::max()));
  CHECK(!Traits::is_finite(std::numeric_limits<S>::infinity()));
  CHECK(!Traits::is_finite(S(-std::numeric_limits<S>::infinity())));
  CHECK(!Traits::is_finite(std::numeric_limits<S>::quiet_NaN()));
  CHECK(Traits::no_length() != Traits::no_length());
}

TEST(traits, "u, the smallest number, finiteness and no_length are what they say") {
  check_traits<float>();
  check_traits<double>();
  check_traits<long double>();
  check_traits<Eigen::half>();
}

TEST(lost_products, "scales whose squared rounding error vanishes are told apart") {
  CHECK(!gjk::ScalarTraits<float>::loses_products(1e-6f));
  CHECK(gjk::ScalarTraits<float>::loses_products(1e-20f));
  CHECK(!gjk::ScalarTraits<double>::loses_products(1e-100));
  CHECK(gjk::ScalarTraits<double>::loses_products(1e-150));
  CHECK(!gjk::ScalarTraits<Eigen::half>::loses_products(Eigen::half(1.0f)));
  CHECK(gjk::ScalarTraits<Eigen::half>::loses_products(Eigen::half(0.01f)));
}

}  // namespace
