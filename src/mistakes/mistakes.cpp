#include "mistakes/mistakes.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "mistakes/all.hpp"

namespace gjkscope {
namespace {

using Polygon = std::vector<Eigen::Vector2d>;

/// Takes down what a loop notes.
class Notes {
 public:
  Notes(const Polygon& x, const Polygon& y) {
    log_.x = in_space(x);
    log_.y = in_space(y);
  }

  void simplex(const auto& simplex) {
    judging::Iteration next;
    next.line = static_cast<int>(log_.iterations.size()) + 1;
    for (const auto& v : simplex) {
      next.simplex.push_back({v.index_x, v.index_y});
      next.points.emplace_back(v.w.x(), v.w.y(), 0);
    }
    log_.iterations.push_back(std::move(next));
  }
  void kept(const auto& simplex) {
    judging::Iteration& now = log_.iterations.back();
    for (const auto& v : simplex) {
      now.kept.push_back({v.index_x, v.index_y});
      now.weights.push_back(v.weight);
    }
    now.closest = closest(simplex);
  }
  void step(const Eigen::Vector2d& d, int far_x, int far_y) {
    judging::Iteration& now = log_.iterations.back();
    now.direction.emplace(d.x(), d.y(), 0);
    now.support = {far_x, far_y};
  }

  /// The log whose run ended with this simplex.
  judging::Log ended(const auto& simplex) {
    log_.answer.emplace();
    log_.answer->distance = closest(simplex).norm();
    log_.answer->overlap = simplex.size() == 3;
    return std::move(log_);
  }

 private:
  static std::vector<judging::Point> in_space(const Polygon& polygon) {
    std::vector<judging::Point> out;
    for (const Eigen::Vector2d& p : polygon) out.emplace_back(p.x(), p.y(), 0);
    return out;
  }
  /// O where the loop takes it for inside.
  static judging::Point closest(const auto& simplex) {
    judging::Point p(0, 0, 0);
    if (simplex.size() == 3) return p;
    for (const auto& v : simplex) p += v.weight * judging::Point(v.w.x(), v.w.y(), 0);
    return p;
  }

  judging::Log log_;
};

// NOLINTBEGIN(bugprone-macro-parentheses): a namespace takes none.
#define MISTAKE(space, name, meaning, line, by)                                       \
  Mistake{name, meaning, line, by, [](const Polygon& x, const Polygon& y) {           \
            Notes notes(x, y);                                                        \
            return notes.ended(::space::gjk({x, y}, kMostIterations, notes).simplex); \
          }},
// NOLINTEND(bugprone-macro-parentheses)
constexpr std::array kMistakes = {
#include "mistakes/mistakes.def"
};
#undef MISTAKE

}  // namespace

std::span<const Mistake> mistakes() { return kMistakes; }

const Mistake& mistake_called(std::string_view name) {
  return *std::find_if(kMistakes.begin(), kMistakes.end(),
                       [&](const Mistake& each) { return each.name == name; });
}

}  // namespace gjkscope
