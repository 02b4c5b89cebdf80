// The compiler rounds a product before it adds to it, in the forms that the core is made of. It is
// built for a processor that could do both in one rounding: for others there is nothing to
// contract.

#include <Eigen/Core>
#include <cstdio>
#include <limits>

namespace {

/// The rest of a * b - c in some form.
template <class R>
struct Form {
  const char* name;
  R (*rest)(R a, R b, R c);
};

template <class R>
using Vec = Eigen::Matrix<R, 2, 1>;

template <class R>
constexpr Form<R> kForms[] = {
    {"a * b - c", [](R a, R b, R c) { return a * b - c; }},
    {"c - a * b", [](R a, R b, R c) { return c - a * b; }},
    {"R(a * b) - c", [](R a, R b, R c) { return R(a * b) - c; }},
    {"p = a * b; p - c",
     [](R a, R b, R c) {
       const R product = a * b;
       return product - c;
     }},
    {"s += a * b",
     [](R a, R b, R c) {
       R sum = -c;
       sum += a * b;
       return sum;
     }},
    {"a * b - 1 * c", [](R a, R b, R c) { return a * b - (a / b) * c; }},
    {"dot", [](R a, R b, R c) { return Vec<R>(a, R(1)).dot(Vec<R>(b, -c)); }},
    {"cwiseProduct",
     [](R a, R b, R c) { return (Vec<R>(a, a).cwiseProduct(Vec<R>(b, b)) - Vec<R>(c, c))[0]; }},
};

/// How many forms are 0 no more, although a * b is rounded to c.
template <class R>
int contracted(const char* scalar) {
  // a * b needs more digits than R has. The compiler shall not compute with what it knows.
  R small(1);
  for (int i = 0; i < std::numeric_limits<R>::digits / 2 + 2; ++i) small /= R(2);
  volatile R a = R(1) + small;
  volatile R b = a;
  volatile R c = a * b;
  int count = 0;
  for (const Form<R>& form : kForms<R>) {
    const R rest = form.rest(a, b, c);
    if (rest == R(0)) continue;
    std::fprintf(stderr, "%s: %s is contracted: expected 0, got %g\n", scalar, form.name,
                 static_cast<double>(rest));
    ++count;
  }
  return count;
}

}  // namespace

int main() {
  const int count = contracted<float>("float") + contracted<double>("double");
  return count == 0 ? 0 : 1;
}
