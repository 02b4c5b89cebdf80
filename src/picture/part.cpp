#include "picture/part.hpp"

#include <type_traits>
#include <utility>
#include <variant>

namespace gjkscope {
namespace {

/// The mark, that far from where it was.
Mark moved_mark(Mark mark, const Point& by) {
  const auto move = [&](auto&... points) { ((points += by), ...); };
  std::visit(
      [&](auto& shape) {
        using Marked = std::decay_t<decltype(shape)>;
        if constexpr (std::is_same_v<Marked, Polygon> || std::is_same_v<Marked, Polyline>) {
          for (Point& p : shape.points) move(p);
        } else if constexpr (std::is_same_v<Marked, Arrow>) {
          move(shape.from, shape.to);
        } else if constexpr (std::is_same_v<Marked, Box>) {
          move(shape.rect.min, shape.rect.max);
        } else if constexpr (std::is_same_v<Marked, Text>) {
          move(shape.at);
        } else {
          move(shape.center);
        }
      },
      mark.shape);
  return mark;
}

}  // namespace

void add_part(Picture& page, const Picture& part, const Point& corner) {
  const int clips = static_cast<int>(page.clips.size());
  for (const Rect& clip : part.clips) page.clips.push_back({clip.min + corner, clip.max + corner});
  for (const Mark& each : part.marks) {
    Mark mark = moved_mark(each, corner);
    if (mark.clip >= 0) mark.clip += clips;
    mark.subject = {};
    page.marks.push_back(std::move(mark));
  }
}

}  // namespace gjkscope
