// The few products that GJK is made of.

#include <cmath>

#include "check.hpp"
#include "gjk/proof/measures.hpp"

namespace vector_test {

using gjk::Vec;

TEST(dot_order, "dot sums in index order, each product rounded: no fused multiply-add") {
  // (1 + u)^2 - (1 + 2u) is u^2 with a fused multiply-add, and 0 when the product rounds first.
  const float a = 1.0f + 0x1p-23f;
  const float square = a * a;
  volatile float x = a;
  const Vec<float, 2> p(x, square);
  const Vec<float, 2> q(x, -1.0f);
  CHECK_EQ(0.0f, gjk::dot(p, q));
  CHECK_EQ(0.0f, gjk::dot(Vec<float, 2>(square, x), Vec<float, 2>(-1.0f, x)));
  // Left to right: (1e8 + 1) - 1e8 loses the 1 in single precision.
  CHECK_EQ(0.0f, gjk::dot(Vec<float, 3>(1e8f, 1.0f, -1e8f), Vec<float, 3>(1, 1, 1)));
  CHECK_EQ(1.0f, gjk::dot(Vec<float, 3>(1e8f, -1e8f, 1.0f), Vec<float, 3>(1, 1, 1)));
}

TEST(conversions, "a vector in another scalar has the same coordinates") {
  CHECK((gjk::converted<double, float, 3>(Vec<float, 3>(1, 2, 3)) == Vec<double, 3>(1, 2, 3)));
  CHECK((gjk::converted<float, double, 2>(Vec<double, 2>(1, 2)) == Vec<float, 2>(1, 2)));
}

TEST(magnitudes, "a number without its sign; the larger and the smaller of two, in any scalar") {
  for (const int a : {-3, 0, 3}) {
    CHECK_EQ(a * a, gjk::magnitude(a) * gjk::magnitude(a));
    CHECK(0 <= gjk::magnitude(a));
  }
  const auto in = [](auto low, auto high) {
    CHECK_EQ(high, gjk::larger(low, high));
    CHECK_EQ(high, gjk::larger(high, low));
    CHECK_EQ(low, gjk::smaller(low, high));
    CHECK_EQ(low, gjk::smaller(high, low));
  };
  in(-2, 1);
  in(-2.0f, 1.0f);
  in(-2.0, 1.0);
}

TEST(lengths, "no square of a coordinate overflows or underflows on the way to a length") {
  for (const int k : {-1070, -600, 0, 600, 1020}) {
    const check::Context context("k", k);
    CHECK_EQ(std::ldexp(5.0, k),
             gjk::careful_length(Vec<double, 2>(std::ldexp(-3.0, k), std::ldexp(4.0, k))));
    CHECK_EQ(std::ldexp(3.0, k), gjk::careful_length(Vec<double, 3>(
                                     std::ldexp(1.0, k), std::ldexp(2.0, k), std::ldexp(-2.0, k))));
  }
  CHECK_EQ(0.0, gjk::careful_length(Vec<double, 2>(0, 0)));
}

TEST(norms, "norm_1 sums magnitudes, norm_max takes the largest") {
  CHECK_EQ(7.0, gjk::norm_1(Vec<double, 2>(3, -4)));
  CHECK_EQ(4.0, gjk::norm_max(Vec<double, 2>(3, -4)));
  CHECK_EQ(6.0, gjk::norm_1(Vec<double, 3>(-1, 2, -3)));
  CHECK_EQ(3.0, gjk::norm_max(Vec<double, 3>(-1, 2, -3)));
}

TEST(zero, "a vector is zero when every coordinate is, whatever the sign of the zeros") {
  CHECK(gjk::is_zero(Vec<double, 2>(0.0, -0.0)));
  CHECK(!gjk::is_zero(Vec<double, 2>(0.0, 5e-324)));
  CHECK(gjk::is_zero(Vec<float, 3>(0.0f, -0.0f, 0.0f)));
  CHECK(gjk::is_zero(Vec<double, 3>(0.0, -0.0, 0.0)));
  for (int i = 0; i < 3; ++i) CHECK(!gjk::is_zero(Vec<float, 3>(Vec<float, 3>::Unit(i))));
}

TEST(finite, "one coordinate that is not finite makes the vector so") {
  CHECK(gjk::is_finite(Vec<float, 2>(1, 2)));
  CHECK(!gjk::is_finite(Vec<float, 2>(1, std::numeric_limits<float>::infinity())));
  CHECK(!gjk::is_finite(Vec<float, 2>(std::numeric_limits<float>::quiet_NaN(), 2)));
}

TEST(volumes, "the determinant is positive for counter-clockwise vectors") {
  const Vec<double, 2> a(2, 0);
  const Vec<double, 2> b(1, 3);
  CHECK_EQ(6.0, (gjk::determinant<double, 2>({a, b})));
  CHECK_EQ(-6.0, (gjk::determinant<double, 2>({b, a})));
  const Vec<double, 3> p(2, 0, 0);
  const Vec<double, 3> q(1, 3, 0);
  const Vec<double, 3> r(1, 1, 4);
  CHECK_EQ(24.0, (gjk::determinant<double, 3>({p, q, r})));
}

TEST(perpendiculars,
     "perpendicular is orthogonal to every edge, exactly, and as long as they are") {
  const Vec<float, 2> edge(-0.00015449524f, -111.1f);
  const Vec<float, 2> normal = gjk::perpendicular<float, 2>({edge});
  CHECK_EQ(0.0f, gjk::dot(normal, edge));
  CHECK_EQ(gjk::dot(edge, edge), gjk::dot(normal, normal));
  const Vec<double, 3> a(1, 2, 3);
  const Vec<double, 3> b(-2, 0, 5);
  const Vec<double, 3> n = gjk::perpendicular<double, 3>({a, b});
  CHECK((n == Vec<double, 3>(10, -11, 4)));
  CHECK_EQ(0.0, gjk::dot(n, a));
  CHECK_EQ(0.0, gjk::dot(n, b));
  const Vec<double, 3> c(7, -4, 6);
  CHECK((gjk::perpendicular<double, 3>({a, c}) == Vec<double, 3>(24, 15, -18)));
}

}  // namespace vector_test
