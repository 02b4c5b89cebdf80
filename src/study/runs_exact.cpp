#include "study/exact.hpp"
#include "study/runs.hpp"

namespace gjkscope::study {
namespace {

/// The answer of an exact run, rounded.
struct Rounded {
  gjk::Error error = gjk::Error::none;
  gjk::Verdict verdict = gjk::Verdict::none;
  double distance = 0.0;
  double lower = 0.0;
  double upper = 0.0;
  Eigen::Vector2d x = Eigen::Vector2d::Zero();
  Eigen::Vector2d y = Eigen::Vector2d::Zero();
  int iterations = 0;
  gjk::Simplex<Rational, 2> simplex;
};

}  // namespace

Asked ask_exact(const Configuration& configuration, const Family& family) {
  return detail::asked<double>(
      configuration, family, [](const gjk::Query<double, 2>& query, const gjk::Options& options) {
        const gjk::Result<Rational, 2> exact = exact_distance(query, options);
        return Rounded{exact.error,
                       exact.verdict,
                       exact.distance,
                       exact.lower,
                       exact.upper,
                       {to_double(exact.x[0]), to_double(exact.x[1])},
                       {to_double(exact.y[0]), to_double(exact.y[1])},
                       exact.iterations,
                       exact.simplex};
      });
}

}  // namespace gjkscope::study
