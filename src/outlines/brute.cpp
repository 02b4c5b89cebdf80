#include "outlines/brute.hpp"

namespace models {

BruteAnswer brute(const Model& a, const Model& b) {
  BruteAnswer out;
  std::optional<Nearest> best;
  for (const Segment& s : a.segments) {
    for (const Segment& t : b.segments) {
      const Nearest pair = nearest(s, t);
      ++out.visits;
      if (!best || pair < *best) best = pair;
      if (pair.meet) {
        out.answer = answer_of(pair, a, b);
        return out;
      }
    }
  }
  const std::optional<Answer> inside = contained(
      a, b, [&](const Point& p) { return winding(p, a); },
      [&](const Point& p) { return winding(p, b); });
  out.answer = inside ? *inside : answer_of(*best, a, b);
  return out;
}

}  // namespace models
