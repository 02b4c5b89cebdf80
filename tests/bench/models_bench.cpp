// General models: what a distance, a tree and a step of a motion cost, beside brute force and,
// where it is installed, FCL. Every time is processor time, the
// median of repetitions that take turns.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <numbers>

#include "outlines/brute.hpp"
#include "outlines/lin_canny.hpp"
#include "subjects/general_growth/measure.hpp"
#ifdef GJKSCOPE_FCL
#include "fcl_models.hpp"
#endif

namespace {

using models::Box;
using models::Circle;
using models::Model;
using models::Point;

/// Seconds of processor time.
double seconds(const std::function<void()>& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

struct Timed {
  std::string name;
  std::function<void()> work;
  std::vector<double> times = {};
  [[nodiscard]] double median() {
    std::nth_element(times.begin(), times.begin() + static_cast<long>(times.size() / 2),
                     times.end());
    return times[times.size() / 2];
  }
};

void take_turns(std::vector<Timed>& all, int turns) {
  for (int turn = 0; turn < turns; ++turn) {
    for (Timed& each : all) each.times.push_back(seconds(each.work));
  }
}

Model outline(std::mt19937_64& bits, int segments, const Point& center) {
  return models::model_of({general_growth::detail::star(bits, segments, center)});
}

void check(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "models-bench: %s\n", what);
  std::exit(1);
}

void distances(int segments) {
  std::mt19937_64 bits(1998);
  const Model x = outline(bits, segments, Point(0.0, 0.0));
  const Model y = outline(bits, segments, Point(1.4, 1.4));
  const auto x_boxes = general_growth::detail::tree<Box>(x);
  const auto y_boxes = general_growth::detail::tree<Box>(y);
  const auto x_circles = general_growth::detail::tree<Circle>(x);
  const auto y_circles = general_growth::detail::tree<Circle>(y);
  models::Answer by_boxes;
  models::Answer by_circles;
  std::vector<Timed> all = {
      {"trees of boxes",
       [&] {
         by_boxes = models::search<Box>({x, y, x_boxes, y_boxes}, {}).answer;
       }},
      {"trees of circles", [&] {
         by_circles = models::search<Circle>({x, y, x_circles, y_circles}, {}).answer;
       }}};
#ifdef GJKSCOPE_FCL
  const bench::FclModels fcl(x, y);
  double by_fcl = 0.0;
  all.push_back(
      {"FCL " PEER_VERSION ", trees of swept rectangles", [&] { by_fcl = fcl.distance(); }});
#endif
  take_turns(all, 21);
  // Brute force looks at a share of the segments of X when there are many.
  const int share = segments > 10000 ? 1000 : 1;
  models::Outline part{x.outlines[0].points, share == 1};
  if (share > 1) part.points.resize(static_cast<std::size_t>(segments / share) + 1);
  const Model some = models::model_of({part});
  models::Answer by_brute;
  const double brute = share * seconds([&] { by_brute = models::brute(some, y).answer; });
  check(by_boxes.distance == by_circles.distance, "boxes and circles differ");
  check(share > 1 || by_boxes.distance == by_brute.distance,
        "the distance is not that of brute force");
  fmt::print("\nDistance of two outlines with {} segments each; brute force: {:.3g} s{}\n",
             segments, brute,
             share > 1
                 ? fmt::format(", {} times what 1 in {} of the segments of X take", share, share)
                 : "");
  for (Timed& each : all)
    fmt::print("  {:<48} {:>9.3f} ms, brute force takes {:.3g} times that\n", each.name,
               1e3 * each.median(), brute / each.median());
#ifdef GJKSCOPE_FCL
  check(std::abs(by_fcl - by_boxes.distance) < 1e-6 * by_boxes.distance, "FCL's distance differs");
#endif
}

void building(int segments) {
  std::mt19937_64 bits(7);
  const Model model = outline(bits, segments, Point(0.0, 0.0));
  std::size_t nodes = 0;
  std::vector<Timed> all = {
      {"boxes", [&] { nodes += general_growth::detail::tree<Box>(model).nodes.size(); }},
      {"circles", [&] { nodes += general_growth::detail::tree<Circle>(model).nodes.size(); }}};
  take_turns(all, 5);
  check(nodes == 10 * (2 * static_cast<std::size_t>(segments) - 1), "a tree lacks nodes");
  fmt::print("\nTree over {} segments\n", segments);
  for (Timed& each : all) fmt::print("  {:<48} {:>9.3f} s\n", each.name, each.median());
}

models::Model regular(int corners, const Point& center, double turned) {
  models::Outline out;
  for (int i = 0; i < corners; ++i) {
    const double angle = turned + 2.0 * std::numbers::pi * i / corners;
    out.points.push_back(center + Point(std::cos(angle), std::sin(angle)));
  }
  return models::model_of({out});
}

/// Y passes X in 200 positions, the same way for all n.
void coherence() {
  fmt::print("\nLin-Canny along a motion of 200 positions: pairs of features a position\n");
  for (const int n : {4, 10, 100, 1000, 10000}) {
    models::RingFeature a;
    models::RingFeature b;
    long warm = 0;
    long most = 0;
    long cold = 0;
    constexpr int kPositions = 200;
    const Model x = regular(n, Point(0.0, 0.0), 0.1);
    for (int i = 0; i < kPositions; ++i) {
      // The turn is so small that the closest point moves by about one edge, whatever n is.
      const double angle = 2.0 * std::numbers::pi * i / n;
      const Model y = regular(n, 2.5 * Point(std::cos(angle), std::sin(angle)), 0.3);
      const models::WalkQuery query = models::walk_query(x, y);
      const models::WalkResult from_last = models::lin_canny(query, a, b);
      cold += models::lin_canny(query, {}, {}).steps;
      if (i > 0) {
        warm += from_last.steps;
        most = std::max<long>(most, from_last.steps);
      }
      a = from_last.a;
      b = from_last.b;
    }
    fmt::print(
        "  n = {:>6}: from the last position {:.2f} (at most {}), from the first vertices {:.1f}\n",
        n, static_cast<double>(warm) / (kPositions - 1), most,
        static_cast<double>(cold) / kPositions);
  }
}

}  // namespace

int main(int argc, char**) {
  if (argc > 1) {
    fmt::print(stderr, "models-bench: takes no arguments; prints times and counts\n");
    return 2;
  }
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  distances(1000);
  distances(10000);
  distances(100000);
  building(1000000);
  coherence();
}
