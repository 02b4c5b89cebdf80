// Distance from a point to a segment, by the installed core: 0 when the answer is right.

#include <array>
#include <gjk/gjk.hpp>

int main() {
  using Vec = gjk::Vec<double, 2>;
  const std::array<Vec, 1> point = {Vec(0, 3)};
  const std::array<Vec, 2> segment = {Vec(-1, 1), Vec(1, 1)};
  gjk::Query<double, 2> query;
  query.x.vertices = point;
  query.y.vertices = segment;
  const gjk::Result<double, 2> result = gjk::distance(query);
  return result.verdict == gjk::Verdict::separated && result.distance == 2.0 ? 0 : 1;
}
