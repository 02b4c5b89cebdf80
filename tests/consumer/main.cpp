#include <cstdio>
#include <gjk/gjk.hpp>
#include <vector>

int main() {
  const std::vector<gjk::Vec<double, 2>> x = {{0, 0}, {1, 0}, {0, 1}};
  const std::vector<gjk::Vec<double, 2>> y = {{3, 3}, {4, 3}};
  const auto result = gjk::distance(x, y);
  std::printf("distance %.17g, proved to be from %.17g to %.17g\n", result.distance, result.lower,
              result.upper);
  // Also result.verdict, result.stop, and the closest points result.x and result.y.

  const gjk::Query<double, 2> query{{x}, {y}};
  const auto trace = gjk::trace(query);  // the same run, every phase kept
  std::printf("after %d iterations, %zu phases\n", result.iterations, trace.steps.size());
}
