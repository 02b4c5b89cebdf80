#include "subjects/hill_climbing/climb.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gjk/gjk.hpp"

namespace climbing {

int Walk::products() const {
  int count = 1;
  for (const Look& look : looks) count += static_cast<int>(look.new_neighbours.size());
  return count;
}

int farther(const Vector3d& d, const Vector3d& a, const Vector3d& b) {
  const double farther = d.dot(b - a);
  // A rounded difference, a rounded product and two rounded sums; what underflows is left to the
  // exact sum.
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  const double size = d.cwiseAbs().dot(a.cwiseAbs() + b.cwiseAbs());
  if (std::abs(farther) > kRounding * size + std::numeric_limits<double>::min())
    return farther > 0.0 ? 1 : -1;
  gjk::Expansion sum;
  for (int i = 0; i < 3; ++i)
    sum = sum + gjk::Expansion(d[i]) * (gjk::Expansion(b[i]) - gjk::Expansion(a[i]));
  return sum.sign();
}

Walk walk(std::span<const Vector3d> points, const Neighbours& neighbours, const Vector3d& d,
          int from) {
  const auto at = [&](int i) -> const Vector3d& { return points[i]; };
  Walk out{d, {}};
  std::vector<bool> met(points.size(), false);
  met[from] = true;
  for (int now = from; now >= 0; now = out.looks.back().next) {
    Look look{now, {}, -1};
    int best = now;
    for (const int next : neighbours[now]) {
      if (met[next]) continue;
      met[next] = true;
      look.new_neighbours.push_back(next);
      if (farther(d, at(best), at(next)) > 0) best = next;
    }
    if (best != now) look.next = best;
    out.looks.push_back(std::move(look));
  }
  return out;
}

int start_at(const Neighbours& neighbours, int wanted) {
  const auto is_vertex = [](const std::vector<int>& ends) { return !ends.empty(); };
  if (is_vertex(neighbours[wanted])) return wanted;
  const auto first = std::find_if(neighbours.begin(), neighbours.end(), is_vertex);
  return first == neighbours.end() ? wanted : static_cast<int>(first - neighbours.begin());
}

}  // namespace climbing
