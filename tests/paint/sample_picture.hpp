#pragma once
// A frame by hand, as rich as a real one: two views, a panel, a caption and a timeline. For tests
// and benchmarks of what stands below src/picture.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "picture/picture.hpp"

namespace gjkscope::sample {

inline void add(Picture& picture, std::string role, decltype(Mark::shape) shape, int clip = -1) {
  picture.marks.push_back({std::move(role), std::move(shape), clip});
}

inline void write(Picture& picture, std::string role, double x, double y, std::string text,
                  TextStyle style, Align align = Align::left) {
  add(picture, std::move(role), Text{{x, y}, std::move(text), style, align});
}

inline void header(Picture& picture) {
  write(picture, "title", 32, 44, "Polygon to polygon: GJK walks the Minkowski difference",
        type::kTitle);
  write(picture, "position", 1248, 44, "iteration 2 of 3 · support", type::kPosition, Align::right);
  const Rect cards[] = {{{32, 66}, {444, 522}}, {{456, 66}, {868, 522}}, {{880, 66}, {1248, 522}}};
  for (const Rect& card : cards) {
    add(picture, "card", Box{card, 10});
    picture.clips.push_back({card.min + Point(1, 1), card.max - Point(1, 1)});
  }
  write(picture, "view-title", 46, 92, "World: X and Y", type::kViewTitle);
  write(picture, "view-title", 470, 92, "Minkowski difference Z = Y − X", type::kViewTitle);
}

inline void world(Picture& picture) {
  const std::vector<Point> x = {
      {65.5, 335.4}, {143.7, 390.6}, {208.1, 363.0}, {189.7, 225.0}, {106.9, 215.8}};
  const std::vector<Point> y = {{281.7, 275.6}, {336.9, 353.8}, {405.9, 289.4}, {355.3, 206.6}};
  add(picture, "shape.x", Polygon{x}, 0);
  add(picture, "shape.y", Polygon{y}, 0);
  add(picture, "closest.line", Polyline{{{198, 287.3}, {345.2, 287.3}}, false}, 0);
  for (const Point& p : x) add(picture, "shape.x.vertex", Disk{p, 4}, 0);
  for (const Point& p : y) add(picture, "shape.y.vertex", Disk{p, 4}, 0);
  add(picture, "closest", Disk{{198, 287.3}, 5}, 0);
  add(picture, "closest", Disk{{345.2, 287.3}, 5}, 0);
  add(picture, "simplex.vertex", Disk{x[3], 6}, 0);
  add(picture, "support", Disk{y[0], 6}, 0);
  add(picture, "dropped", Disk{x[2], 9}, 0);
  add(picture, "direction", Arrow{{281.7, 275.6}, {229.7, 275.6}}, 0);
  add(picture, "direction", Arrow{{208.1, 363}, {261, 363}}, 0);
  write(picture, "direction.label", 217, 281, "d", type::kVertex, Align::center);
  write(picture, "direction.label", 278, 368, "−d", type::kVertex, Align::center);
  const std::pair<const char*, Point> names_x[] = {{"A", {48.7, 346.8}},
                                                   {"B", {143.9, 413.6}},
                                                   {"C", {223, 381}},
                                                   {"D", {198.7, 214.4}},
                                                   {"E", {100.2, 204.1}}};
  for (const auto& [name, at] : names_x) {
    write(picture, "shape.x.label", at.x(), at.y(), name, type::kVertex, Align::center);
  }
  const std::pair<const char*, Point> names_y[] = {
      {"K", {263.5, 269}}, {"L", {334.7, 378.7}}, {"M", {425.7, 297}}, {"N", {358, 191.8}}};
  for (const auto& [name, at] : names_y) {
    write(picture, "shape.y.label", at.x(), at.y(), name, type::kVertex, Align::center);
  }
}

inline void difference(Picture& picture) {
  const std::vector<Point> hull = {{591.7, 244.6}, {606.9, 358.6}, {652.5, 423.2},
                                   {720.9, 430.8}, {777.9, 377.6}, {812.1, 278.8},
                                   {770.3, 210.4}, {705.7, 164.8}, {652.5, 187.6}};
  add(picture, "region.edge", Polygon{{{456, 380}, {652, 423}, {620, 530}, {456, 530}}}, 1);
  add(picture, "region.active", Polygon{{{456, 380}, {652, 423}, {456, 530}}}, 1);
  add(picture, "region.border", Polyline{{{456, 380}, {652, 423}, {620, 530}}, false}, 1);
  add(picture, "hull", Polygon{hull}, 1);
  const Point cloud[] = {{709.5, 267.4}, {644.9, 221.8}, {675.3, 366.2}, {755.1, 332.0},
                         {690.5, 286.4}, {637.3, 309.2}, {747.5, 233.2}, {694.3, 256.0}};
  for (const Point& p : cloud) add(picture, "cloud.point", Disk{p, 2.6}, 1);
  add(picture, "support.plane", Polyline{{{591.7, 124}, {591.7, 366}}, false}, 1);
  add(picture, "closest.line", Polyline{{{531, 316.8}, {652.5, 316.8}}, false}, 1);
  add(picture, "simplex.edge", Polyline{{{652.5, 187.6}, {652.5, 423.2}}, false}, 1);
  add(picture, "direction", Arrow{{652.5, 316.8}, {574, 316.8}}, 1);
  add(picture, "simplex.vertex", Disk{{652.5, 187.6}, 7}, 1);
  add(picture, "simplex.vertex", Disk{{652.5, 423.2}, 7}, 1);
  add(picture, "support", Disk{{591.7, 244.6}, 7}, 1);
  add(picture, "closest", Disk{{652.5, 316.8}, 6}, 1);
  add(picture, "origin", Cross{{531, 316.8}, 9}, 1);
  write(picture, "simplex.label", 642, 169, "N−C", type::kSmallVertex, Align::center);
  write(picture, "simplex.label", 643, 452, "L−D", type::kSmallVertex, Align::center);
  write(picture, "support.label", 568, 238, "K−C", type::kSmallVertex, Align::center);
  write(picture, "direction.label", 576, 306, "d", type::kVertex, Align::center);
  write(picture, "closest.label", 668, 339, "P", type::kVertex, Align::center);
  write(picture, "origin.label", 517, 341, "O", type::kVertex, Align::center);
}

inline void panel(Picture& picture) {
  const char* code[] = {"S ← any vertex",
                        "loop",
                        "  P ← closest point to O on S",
                        "  drop vertices without weight",
                        "  d ← from P towards O",
                        "  w ← support(Y, d) − support(X, −d)",
                        "  if w ∈ S: stop, ‖P‖ ≤ 10⁻⁶",
                        "  add w to S"};
  add(picture, "highlight", Box{{{888, 195}, {1240, 217}}, 4});
  for (int i = 0; i < 8; ++i) {
    write(picture, i == 5 ? "code.current" : "code", 896, 96 + 23 * i, code[i],
          i == 5 ? type::kCodeBold : type::kCode);
  }
  add(picture, "card.rule", Polyline{{{892, 286}, {1236, 286}}, false});
  write(picture, "heading", 892, 308, "Simplex", type::kHeading);
  write(picture, "heading", 1068, 308, "weight", type::kHeading);
  const std::pair<const char*, double> rows[] = {{"N − C", 0.452}, {"L − D", 0.548}};
  for (int i = 0; i < 2; ++i) {
    const double y = 329 + 26 * i;
    add(picture, "simplex.vertex", Disk{{900, y}, 6});
    write(picture, "strong", 916, y + 5, rows[i].first, type::kStrong);
    add(picture, "weight.track", Box{{{1068, y - 7}, {1178, y + 7}}, 3});
    add(picture, "weight.bar", Box{{{1068, y - 7}, {1068 + 110 * rows[i].second, y + 7}}, 3});
    write(picture, "code.value", 1236, y + 5, i == 0 ? "0.452" : "0.548", type::kCode,
          Align::right);
  }
  write(picture, "pass", 892, 396, "✓ AB: u > 0, v > 0", type::kBody);
  write(picture, "fail", 1068, 396, "✗ −0.331 ≥ 0", type::kCode);
  add(picture, "card.rule", Polyline{{{892, 404}, {1236, 404}}, false});
  write(picture, "heading", 892, 428, "Distance lies in", type::kHeading);
  write(picture, "code.value", 1236, 428, "[1.6000, 3.2000]", type::kCode, Align::right);
  add(picture, "bounds.track", Box{{{892, 442}, {1236, 450}}, 4});
  add(picture, "bounds.bar", Box{{{1042, 442}, {1191, 450}}, 4});
  write(picture, "body.muted", 1076, 468, "support line", type::kTick, Align::right);
  write(picture, "body.muted", 1191, 468, "P", type::kTick, Align::center);
  write(picture, "body.muted", 892, 490, "P and the support line are certificates: the true",
        type::kBody);
  write(picture, "body.muted", 892, 508, "distance cannot lie outside the black bar.", type::kBody);
}

inline void footer(Picture& picture) {
  write(picture, "caption", 32, 566,
        "K − C lies farthest towards O: K is the support of Y along d, C that of X along −d.",
        type::kCaption);
  write(picture, "detail", 32, 594,
        "It is not in the simplex yet, and it gets us closer to O by up to 1.6000: it will be "
        "added.",
        type::kDetail);
  const char* phases[] = {"closest", "drop", "direction", "support", "stop", "add"};
  for (int group = 0; group < 3; ++group) {
    const double left = 32 + 404 * group;
    write(picture, group == 1 ? "timeline.label" : "timeline.label", left, 636,
          "iteration " + std::to_string(group + 1), type::kTickBold);
    for (int i = 0; i < 6; ++i) {
      const double x = left + 64 * i;
      const int at = 6 * group + i;
      const bool current = at == 9;
      add(picture,
          at < 9    ? "timeline.done"
          : current ? "timeline.current"
                    : "timeline.ahead",
          Box{{{x, 650}, {x + 58, current ? 666.0 : 660.0}}, 4});
      if (group == 1) {
        write(picture, current ? "timeline.label.current" : "timeline.label", x + 29, 682,
              phases[i], current ? type::kTickBold : type::kTick, Align::center);
      }
    }
  }
}

/// 1280 x 720, about 150 marks.
inline Picture picture() {
  Picture picture;
  picture.width = 1280;
  picture.height = 720;
  picture.clip_corner = 9;
  header(picture);
  world(picture);
  difference(picture);
  panel(picture);
  footer(picture);
  return picture;
}

}  // namespace gjkscope::sample
