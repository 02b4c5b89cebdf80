// Properties of a scalar type that the core relies on.

#include "gjk/proof/scalar.hpp"

#include "check.hpp"

namespace scalar_test {

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
  CHECK(Traits::is_finite(std::numeric_limits<S>::max()));
  CHECK(!Traits::is_finite(std::numeric_limits<S>::infinity()));
  CHECK(!Traits::is_finite(S(-std::numeric_limits<S>::infinity())));
  CHECK(!Traits::is_finite(std::numeric_limits<S>::quiet_NaN()));
  CHECK(Traits::no_length() != Traits::no_length());
}

TEST(traits, "u, finiteness and no_length are what they say") {
  check_traits<float>();
  check_traits<double>();
  check_traits<long double>();
  check_traits<Eigen::half>();
}

template <class S>
void check_powers() {
  using Traits = gjk::ScalarTraits<S>;
  using Limits = std::numeric_limits<S>;
  for (int e = Limits::min_exponent - Limits::digits; e < Limits::max_exponent; ++e) {
    const check::Context context("exponent", e);
    const S power = Traits::scaled(S(1), e);
    CHECK(S(0) < power);
    CHECK_EQ(e, Traits::exponent(power));
    CHECK_EQ(S(1), Traits::scaled(power, -e));
    if (e >= Limits::min_exponent) {
      CHECK_EQ(e, Traits::exponent(S(power * S(1.75))));
      CHECK_EQ(S(1.75), Traits::scaled(S(power * S(1.75)), -e));
    }
  }
}

TEST(powers, "exponent and scaled take numbers apart and put them together, denormals included") {
  check_powers<float>();
  check_powers<double>();
  check_powers<long double>();
  check_powers<Eigen::half>();
}

/// The last digit of the product of two numbers of all digits, as small as u^kSmallest times the
/// size.
template <class S>
bool keeps_products(int exponent) {
  using Traits = gjk::ScalarTraits<S>;
  const S least =
      Traits::scaled(S(1), exponent - Traits::kSmallest * std::numeric_limits<S>::digits);
  const S last_digit = Traits::scaled(S(1), 1 - std::numeric_limits<S>::digits);
  return S(0) < S(S(least * last_digit) * S(least * last_digit));
}

template <class S>
void check_good_sizes(bool smallest_keeps) {
  using Traits = gjk::ScalarTraits<S>;
  CHECK_EQ(smallest_keeps, keeps_products<S>(Traits::least_exponent()));
  const bool has_more_room = std::is_same_v<S, long double>;
  CHECK_EQ(has_more_room, keeps_products<S>(Traits::least_exponent() - 2));
  const auto squares_are_finite = [](int exponent) {
    const S size = Traits::scaled(S(1.75), exponent);
    return Traits::is_finite(S(S(4) * S(size * size)));
  };
  CHECK(squares_are_finite(Traits::largest_exponent()));
  CHECK_EQ(has_more_room, squares_are_finite(Traits::largest_exponent() + 3));

  const auto is_good = [](int exponent) {
    return Traits::is_in_range(Traits::scaled(S(1), exponent));
  };
  CHECK(!is_good(Traits::least_exponent() - 1) && is_good(Traits::least_exponent()));
  CHECK(is_good(Traits::largest_exponent()) && !is_good(Traits::largest_exponent() + 1));
  CHECK(is_good(-1) && is_good(0));  // as where the size is the unit of length
}

TEST(good_sizes, "sizes between 2^least_exponent and 2^largest_exponent square without loss") {
  check_good_sizes<float>(true);
  check_good_sizes<double>(true);
  check_good_sizes<long double>(true);
  check_good_sizes<Eigen::half>(false);  // it has 5 bits of exponent: there is no such size
}

TEST(default_scalar, "float and half run in double unless told otherwise") {
  CHECK(std::is_same_v<double, gjk::RunScalar<gjk::Default, Eigen::half>>);
  CHECK(std::is_same_v<double, gjk::RunScalar<gjk::Default, float>>);
  CHECK(std::is_same_v<double, gjk::RunScalar<gjk::Default, double>>);
  CHECK(std::is_same_v<long double, gjk::RunScalar<gjk::Default, long double>>);
  CHECK(std::is_same_v<float, gjk::RunScalar<float, double>>);
}

}  // namespace scalar_test
