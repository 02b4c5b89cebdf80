#include "outlines/pieces.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "exact/instances.hpp"
#include "outlines/hierarchy.hpp"

namespace models {
namespace {

using Corners = std::vector<int>;

/// A border of the inside: its corners in order, with the inside to their left.
struct Border {
  Corners corners;
  bool is_hole = false;
  int outline = 0;
};

class Cutter {
 public:
  explicit Cutter(const Model& model) : model_(model) {
    for (const Outline& outline : model.outlines) {
      out_.points.insert(out_.points.end(), outline.points.begin(), outline.points.end());
    }
  }

  Pieces cut() {
    std::vector<Border> borders = borders_of_matter();
    for (std::size_t i = 0; i < borders.size(); ++i) {
      if (borders[i].is_hole) continue;
      std::vector<const Border*> holes;
      for (const Border& hole : borders) {
        if (hole.is_hole && holder_of(hole, borders) == static_cast<int>(i)) holes.push_back(&hole);
      }
      cut_ears(joined(borders[i].corners, holes));
    }
    merge();
    return std::move(out_);
  }

 private:
  [[nodiscard]] const Point& at(int corner) const { return out_.points[corner]; }
  [[nodiscard]] int turn_at(int a, int b, int c) const { return turn(at(a), at(b), at(c)); }

  [[nodiscard]] int winding_within(const Outline& outline, const Point& p) const {
    return winding(p, model_of({outline}));
  }

  /// The outlines with matter on one side only.
  [[nodiscard]] std::vector<Border> borders_of_matter() const {
    std::vector<Border> borders;
    int first = 0;
    for (std::size_t i = 0; i < model_.outlines.size(); ++i) {
      const Outline& outline = model_.outlines[i];
      int around = 0;
      for (std::size_t k = 0; k < model_.outlines.size(); ++k) {
        if (k != i) around += winding_within(model_.outlines[k], outline.points.front());
      }
      const Ring ring = ring_of(outline);
      const int inside = around + (ring.reversed ? -1 : 1);
      if ((around == 0) != (inside == 0)) {
        Border border{{}, inside == 0, static_cast<int>(i)};
        for (const int index : ring.index) border.corners.push_back(first + index);
        if (border.is_hole) std::reverse(border.corners.begin(), border.corners.end());
        borders.push_back(std::move(border));
      }
      first += static_cast<int>(outline.points.size());
    }
    return borders;
  }

  /// The innermost border around a hole that is not a hole.
  [[nodiscard]] int holder_of(const Border& hole, const std::vector<Border>& borders) const {
    const Point& p = at(hole.corners.front());
    int holder = -1;
    for (std::size_t i = 0; i < borders.size(); ++i) {
      if (borders[i].is_hole || winding_within(model_.outlines[borders[i].outline], p) == 0)
        continue;
      const bool inner = holder < 0 || winding_within(model_.outlines[borders[holder].outline],
                                                      at(borders[i].corners.front())) != 0;
      if (inner) holder = static_cast<int>(i);
    }
    return holder;
  }

  /// One ring: each hole, from left to right, is joined by a bridge from its leftmost corner to the
  /// nearest corner of the ring that it sees.
  [[nodiscard]] Corners joined(Corners ring, std::vector<const Border*> holes) {
    const auto leftmost = [&](const Border* hole) {
      return std::min_element(hole->corners.begin(), hole->corners.end(),
                              [&](int a, int b) { return before(at(a), at(b)); }) -
             hole->corners.begin();
    };
    std::sort(holes.begin(), holes.end(), [&](const Border* a, const Border* b) {
      return before(at(a->corners[leftmost(a)]), at(b->corners[leftmost(b)]));
    });
    for (const Border* hole : holes) {
      Corners corners = hole->corners;
      std::rotate(corners.begin(), corners.begin() + leftmost(hole), corners.end());
      const std::size_t to = seen_corner(ring, corners);
      out_.bridges.push_back({corners.front(), ring[to]});
      corners.push_back(corners.front());
      corners.push_back(ring[to]);
      ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(to) + 1, corners.begin(),
                  corners.end());
    }
    return ring;
  }

  [[nodiscard]] std::size_t seen_corner(const Corners& ring, const Corners& hole) const {
    const Point& from = at(hole.front());
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (before(at(ring[i]), from)) order.push_back(i);
    }
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      const double to_i = (at(ring[i]) - from).squaredNorm();
      const double to_j = (at(ring[j]) - from).squaredNorm();
      return to_i != to_j ? to_i < to_j : i < j;
    });
    const auto blocks = [&](const Corners& border, const Segment& sight) {
      for (std::size_t i = 0; i < border.size(); ++i) {
        const Segment edge{at(border[i]), at(border[(i + 1) % border.size()])};
        const bool shared =
            edge.a == sight.a || edge.b == sight.a || edge.a == sight.b || edge.b == sight.b;
        if (!shared && meet(edge, sight)) return true;
        // An edge from an end of the sight blocks it where it runs along it.
        if (shared && runs_along(edge, sight)) return true;
      }
      return false;
    };
    for (const std::size_t i : order) {
      const int previous = ring[(i + ring.size() - 1) % ring.size()];
      const int next = ring[(i + 1) % ring.size()];
      if (!opens_to(previous, ring[i], next, from)) continue;
      const Segment sight{from, at(ring[i])};
      if (!blocks(ring, sight) && !blocks(hole, sight)) return i;
    }
    return 0;  // Not reached: a ring around a hole has a corner that the hole sees.
  }
  [[nodiscard]] static bool runs_along(const Segment& edge, const Segment& sight) {
    const bool from_a = edge.a == sight.a || edge.a == sight.b;
    const Point& common = from_a ? edge.a : edge.b;
    const Point& other = from_a ? edge.b : edge.a;
    const Point& far = common == sight.a ? sight.b : sight.a;
    return turn(common, far, other) == 0 && along(common, far, other) > 0;
  }
  /// Whether p lies in the directions between the two edges at `corner` where matter is.
  [[nodiscard]] bool opens_to(int previous, int corner, int next, const Point& p) const {
    const bool left_of_in = turn(at(previous), at(corner), p) > 0;
    const bool left_of_out = turn(at(corner), at(next), p) > 0;
    return turn_at(previous, corner, next) > 0 ? left_of_in && left_of_out
                                               : left_of_in || left_of_out;
  }

  void cut_ears(Corners ring) {
    std::size_t i = 0;
    std::size_t tried = 0;
    while (ring.size() > 3 && tried <= ring.size()) {
      const std::size_t n = ring.size();
      i %= n;
      const std::array ear = {ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]};
      if (!is_ear(out_.points, ear, ring)) {
        ++i;
        ++tried;
        continue;
      }
      out_.triangles.push_back(ear);
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
      tried = 0;
    }
    if (ring.size() == 3) out_.triangles.push_back({ring[0], ring[1], ring[2]});
  }
  /// Half-edges of the triangles: 3 t + k runs from corner k of triangle t to the next.
  void merge() {
    const std::size_t count = 3 * out_.triangles.size();
    std::vector<int> origin(count);
    std::vector<std::size_t> next(count);
    std::vector<std::size_t> previous(count);
    std::map<std::pair<int, int>, std::size_t> edges;
    for (std::size_t h = 0; h < count; ++h) {
      const std::array<int, 3>& triangle = out_.triangles[h / 3];
      origin[h] = triangle[h % 3];
      next[h] = h / 3 * 3 + (h + 1) % 3;
      previous[h] = h / 3 * 3 + (h + 2) % 3;
      edges[{triangle[h % 3], triangle[(h + 1) % 3]}] = h;
    }
    std::vector<bool> gone(count, false);
    for (std::size_t h = 0; h < count; ++h) {
      const int from = origin[h];
      const int to = out_.triangles[h / 3][(h + 1) % 3];
      const auto twin = edges.find({to, from});
      if (from > to || twin == edges.end()) continue;
      const std::size_t t = twin->second;
      const auto stays_convex = [&](std::size_t in, int corner, std::size_t out) {
        const std::size_t after = next[out];
        return turn_at(origin[in], corner, origin[after]) >= 0;
      };
      const bool merged =
          stays_convex(previous[h], from, next[t]) && stays_convex(previous[t], to, next[h]);
      out_.merges.push_back({from, to, merged});
      if (!merged) continue;
      const auto link = [&](std::size_t a, std::size_t b) {
        next[a] = b;
        previous[b] = a;
      };
      const std::size_t after_h = next[h];
      const std::size_t after_t = next[t];
      link(previous[h], after_t);
      link(previous[t], after_h);
      gone[h] = gone[t] = true;
    }
    for (std::size_t h = 0; h < count; ++h) {
      if (gone[h]) continue;
      Corners piece;
      for (std::size_t i = h; !gone[i]; i = next[i]) {
        piece.push_back(origin[i]);
        gone[i] = true;
      }
      out_.pieces.push_back(std::move(piece));
    }
  }

  const Model& model_;
  Pieces out_;
};

/// A piece with what pairs of pieces need of it.
struct Shape {
  std::vector<Point> points;
  std::vector<Segment> borders;  ///< Those of its edges that are segments of the model.
  Box box;
};

std::vector<Shape> shapes_of(const Model& model, const Pieces& pieces) {
  std::vector<int> outline;
  std::vector<int> first;
  for (std::size_t i = 0; i < model.outlines.size(); ++i) {
    first.push_back(static_cast<int>(outline.size()));
    outline.insert(outline.end(), model.outlines[i].points.size(), static_cast<int>(i));
  }
  const auto segment_from = [&](int corner) {
    return model.segments[corner];  // closed: one for each point
  };
  std::vector<Shape> shapes;
  for (const Corners& piece : pieces.pieces) {
    Shape shape;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const int from = piece[i];
      const int to = piece[(i + 1) % piece.size()];
      const Point& p = pieces.points[from];
      const Point& q = pieces.points[to];
      shape.points.push_back(p);
      const Box edge = box_around(Item{p, q});
      shape.box = i == 0 ? edge : box_around(shape.box, edge);
      if (outline[from] != outline[to]) {
        shape.borders.push_back({p, p, outline[from], from - first[outline[from]]});
        continue;
      }
      const Segment forward = segment_from(from);
      const Segment back = segment_from(to);
      if (forward.b == q) {
        shape.borders.push_back(forward);
      } else if (back.b == p) {
        shape.borders.push_back(back);
      } else {
        shape.borders.push_back({p, p, outline[from], from - first[outline[from]]});
      }
    }
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

/// The fewest pieces of the part of a ring from corner i to corner j, which its diagonal cuts off,
/// and the corners of the piece beside the diagonal.
struct Part {
  int fewest = kNever;
  Corners beside;
  static constexpr int kNever = std::numeric_limits<int>::max() / 4;
};

class Fewest {
 public:
  explicit Fewest(Ring ring) : ring_(std::move(ring)), count_(ring_.size()) {
    parts_.resize(static_cast<std::size_t>(count_) * static_cast<std::size_t>(count_));
    for (int length = 1; length < count_; ++length) {
      for (int i = 0; i + length < count_; ++i) part(i, i + length) = best(i, i + length);
    }
    collect(0, count_ - 1);
  }
  [[nodiscard]] std::vector<Corners> pieces() { return std::move(pieces_); }

 private:
  [[nodiscard]] const Point& at(int i) const { return ring_.points[i]; }
  [[nodiscard]] Part& part(int i, int j) { return parts_[i * count_ + j]; }
  [[nodiscard]] bool turns_out(int a, int b, int c) const { return turn(at(a), at(b), at(c)) >= 0; }

  /// An edge, or a diagonal inside of the ring that touches no other edge.
  [[nodiscard]] bool sees(int i, int j) const {
    if (ring_.next(i) == j || ring_.next(j) == i) return true;
    for (int k = 0; k < count_; ++k) {
      const int next = ring_.next(k);
      const bool is_shared = k == i || k == j || next == i || next == j;
      if (!is_shared && meet({at(k), at(next)}, {at(i), at(j)})) return false;
    }
    const bool left_of_in = turn(at(ring_.previous(i)), at(i), at(j)) > 0;
    const bool left_of_out = turn(at(i), at(ring_.next(i)), at(j)) > 0;
    return turn(at(ring_.previous(i)), at(i), at(ring_.next(i))) > 0 ? left_of_in && left_of_out
                                                                     : left_of_in || left_of_out;
  }

  /// Tries all convex pieces beside the diagonal, each as a chain of corners from i to j: `cost` of
  /// a chain whose last two corners are a and b, and the corner before them.
  [[nodiscard]] Part best(int i, int j) {
    if (i + 1 == j) return {0, {}};
    if (!sees(i, j)) return {};
    std::map<std::pair<int, int>, std::pair<int, int>> chains;
    const auto offer = [&](int a, int b, int cost, int before) {
      const auto [chain, is_new] = chains.try_emplace({a, b}, cost, before);
      if (!is_new && cost < chain->second.first) chain->second = {cost, before};
    };
    for (int b = i + 1; b < j; ++b) {
      if (turns_out(j, i, b) && sees(i, b)) offer(i, b, part(i, b).fewest, -1);
      for (int a = i; a < b; ++a) {
        const auto chain = chains.find({a, b});
        if (chain == chains.end()) continue;
        const int cost = chain->second.first;
        for (int c = b + 1; c <= j; ++c) {
          if (turns_out(a, b, c) && (c < j || turns_out(b, j, i)) && sees(b, c))
            offer(b, c, cost + part(b, c).fewest, a);
        }
      }
    }
    Part out;
    for (int last = i + 1; last < j; ++last) {
      const auto chain = chains.find({last, j});
      if (chain == chains.end() || chain->second.first + 1 >= out.fewest) continue;
      out = {chain->second.first + 1, {j}};
      for (int a = last, b = j; a >= 0;) {
        out.beside.push_back(a);
        const int before = chains.at({a, b}).second;
        b = a;
        a = before;
      }
      std::reverse(out.beside.begin(), out.beside.end());
    }
    return out;
  }

  void collect(int i, int j) {
    if (i + 1 == j) return;
    const Corners& beside = part(i, j).beside;
    Corners piece;
    for (const int corner : beside) piece.push_back(ring_.index[corner]);
    pieces_.push_back(std::move(piece));
    for (std::size_t k = 1; k < beside.size(); ++k) collect(beside[k - 1], beside[k]);
  }

  Ring ring_;
  int count_;
  std::vector<Part> parts_;
  std::vector<Corners> pieces_;
};

}  // namespace

bool is_ear(const std::vector<Point>& points, const std::array<int, 3>& ear,
            const std::vector<int>& ring) {
  const Point& a = points[ear[0]];
  const Point& b = points[ear[1]];
  const Point& c = points[ear[2]];
  if (turn(a, b, c) <= 0) return false;
  const Point low = a.cwiseMin(b).cwiseMin(c);
  const Point high = a.cwiseMax(b).cwiseMax(c);
  return std::none_of(ring.begin(), ring.end(), [&](int corner) {
    const Point& p = points[corner];
    if ((p.array() < low.array()).any() || (p.array() > high.array()).any()) return false;
    if (p == a || p == b || p == c) return false;
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
  });
}

Pieces pieces_of(const Model& model) { return Cutter(model).cut(); }

std::vector<std::vector<int>> fewest_pieces(const Outline& outline) {
  return Fewest(ring_of(outline)).pieces();
}

std::vector<int> corners_turning_in(const Outline& outline) {
  const Ring ring = ring_of(outline);
  std::vector<int> out;
  for (int i = 0; i < ring.size(); ++i) {
    if (turn(ring.points[ring.previous(i)], ring.points[i], ring.points[ring.next(i)]) < 0)
      out.push_back(ring.index[i]);
  }
  return out;
}

PiecesAnswer pieces_distance(const Model& a, const Model& b, const Pieces& pieces_a,
                             const Pieces& pieces_b) {
  const std::vector<Shape> shapes_a = shapes_of(a, pieces_a);
  const std::vector<Shape> shapes_b = shapes_of(b, pieces_b);
  PiecesAnswer out;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < shapes_a.size(); ++i) {
    for (std::size_t j = 0; j < shapes_b.size(); ++j) {
      PieceRun run{static_cast<int>(i), static_cast<int>(j),
                   distance_below(shapes_a[i].box, shapes_b[j].box), least};
      run.skipped = run.bound > least;
      if (!run.skipped) {
        const auto found = gjk::distance<double>(
            gjk::Query<double, 2>{{shapes_a[i].points}, {shapes_b[j].points}});
        run.distance = found.distance;
        run.lower = found.lower;
        run.upper = found.upper;
        run.iterations = found.iterations;
        run.x = found.x;
        run.y = found.y;
        least = std::min(least, found.upper);
        ++out.visits;
        if (found.verdict == gjk::Verdict::touching || found.verdict == gjk::Verdict::overlapping) {
          out.answer.overlap = true;
          out.answer.a = out.answer.b = found.x;
        }
      }
      out.runs.push_back(run);
      if (out.answer.overlap) return out;
    }
  }
  std::optional<Nearest> best;
  for (const PieceRun& run : out.runs) {
    if (run.skipped || run.lower > least) continue;
    for (const Segment& s : shapes_a[run.a].borders) {
      for (const Segment& t : shapes_b[run.b].borders) {
        const Nearest pair = nearest(s, t);
        if (!best || pair < *best) best = pair;
      }
    }
  }
  out.answer = answer_of(*best, a, b);
  return out;
}

}  // namespace models
