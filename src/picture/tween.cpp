#include "picture/tween.hpp"

#include <map>
#include <string_view>
#include <tuple>
#include <vector>

namespace gjkscope {
namespace {

using Shape = decltype(Mark::shape);

/// The view that shows a mark, or -1. Labels are not clipped: they stand in one, the topmost there.
int view_of(const Picture& picture, const Mark& mark) {
  const Text* const text = std::get_if<Text>(&mark.shape);
  if (!text) return mark.clip;
  int view = static_cast<int>(picture.clips.size()) - 1;
  while (view >= 0 && !overlap(picture.clips[view], {text->at, text->at})) --view;
  return view;
}

/// Tells marks apart: view, shape, role, words, subject, and a number among marks that are alike.
using Identity =
    std::tuple<int, std::size_t, std::string_view, std::string_view, int, int, int, int>;

/// The marks of the views, as they are painted.
std::vector<std::pair<Identity, std::size_t>> identified(const Picture& picture) {
  std::vector<std::pair<Identity, std::size_t>> out;
  std::map<Identity, int> counts;
  for (std::size_t i = 0; i < picture.marks.size(); ++i) {
    const Mark& mark = picture.marks[i];
    const int view = view_of(picture, mark);
    if (view < 0) continue;
    const Text* const text = std::get_if<Text>(&mark.shape);
    const std::string_view words = text ? std::string_view(text->text) : std::string_view();
    Identity identity(view, mark.shape.index(), mark.role, words,
                      static_cast<int>(mark.subject.kind), mark.subject.x, mark.subject.y, 0);
    std::get<7>(identity) = counts[identity]++;
    out.emplace_back(identity, i);
  }
  return out;
}

/// The coordinates and lengths of a shape.
std::vector<double*> numbers_of(Shape& shape) {
  std::vector<double*> out;
  const auto add = [&](auto&... values) { (out.push_back(&values), ...); };
  const auto add_points = [&](auto&... points) { (add(points.x(), points.y()), ...); };
  std::visit(
      [&](auto& s) {
        if constexpr (requires { s.points; }) {
          for (Point& p : s.points) add_points(p);
        } else if constexpr (requires { s.from; }) {
          add_points(s.from, s.to);
        } else if constexpr (requires { s.center; }) {
          add_points(s.center);
          add(s.radius);
        } else if constexpr (requires { s.rect; }) {
          add_points(s.rect.min, s.rect.max);
          add(s.corner);
        } else {
          add_points(s.at);
        }
      },
      shape);
  return out;
}

/// Moves `shape`, which is where it goes to, back to the share `t` of its way. False when there is
/// no such way: a line with more corners.
bool move_back(Shape& shape, Shape from, double t) {
  const std::vector<double*> before = numbers_of(from);
  const std::vector<double*> after = numbers_of(shape);
  if (before.size() != after.size()) return false;
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (*before[i] != *after[i]) *after[i] = *before[i] + (*after[i] - *before[i]) * t;
  }
  return true;
}

}  // namespace

Picture tween(const Picture& from, const Picture& to, double t) {
  if (t <= 0.0) return from;
  if (t >= 1.0 || from.clips != to.clips) return to;
  const auto after = identified(to);
  std::map<Identity, std::size_t> stays;
  std::vector<double> opacity(to.marks.size(), 1.0);
  for (const auto& [identity, index] : after) {
    stays[identity] = index;
    opacity[index] = t;
  }
  Picture between = to;
  std::multimap<std::size_t, Mark> gone;  // by the mark that they are painted before
  std::size_t next = 0;
  for (const auto& [identity, index] : identified(from)) {
    const Mark& was = from.marks[index];
    const auto found = stays.find(identity);
    const std::size_t before = found == stays.end() ? next : found->second;
    if (found != stays.end()) {
      next = found->second + 1;
      if (move_back(between.marks[found->second].shape, was.shape, t)) {
        opacity[found->second] = 1.0;
        continue;
      }
    }
    if (std::holds_alternative<Text>(was.shape)) continue;
    Mark& going = gone.emplace(before, was)->second;
    going.opacity *= 1.0 - t;
    going.subject = {};  // nothing to point at any more
  }
  std::vector<Mark> marks;
  for (std::size_t i = 0; i <= between.marks.size(); ++i) {
    const auto [first, last] = gone.equal_range(i);
    for (auto each = first; each != last; ++each) marks.push_back(std::move(each->second));
    if (i == between.marks.size()) break;
    between.marks[i].opacity *= opacity[i];
    marks.push_back(std::move(between.marks[i]));
  }
  between.marks = std::move(marks);
  return between;
}

}  // namespace gjkscope
