#include "icon.hpp"

#include <array>
#include <numbers>

namespace gjkscope {
namespace {

/// Places in a unit square around the origin, to pixels.
struct Pen {
  ImDrawList& list;
  ImVec2 center;
  float size = 0.0f;
  ImU32 color = 0;

  [[nodiscard]] ImVec2 at(float x, float y) const {
    return {center.x + x * size, center.y + y * size};
  }
  /// From its flat side at `x` to its tip at `x + width`; a width below 0 points to the left.
  void triangle(float x, float width) const {
    // Dear ImGui smooths the edges of triangles whose corners come clockwise, and of no others.
    const float up = width > 0.0f ? -0.38f : 0.38f;
    list.AddTriangleFilled(at(x, up), at(x + width, 0.0f), at(x, -up), color);
  }
  /// An arrow head of two strokes, with its tip at `x`; `to`: -1 left, 1 right.
  void chevron(float x, float to) const {
    const std::array<ImVec2, 3> bend = {at(x - 0.32f * to, -0.34f), at(x, 0.0f),
                                        at(x - 0.32f * to, 0.34f)};
    list.AddPolyline(bend.data(), 3, color, 0, 0.13f * size);
  }
  /// Draws a disk, and returns a pen that draws on it.
  [[nodiscard]] Pen on_disk(ImU32 paper) const {
    list.AddCircleFilled(center, 0.72f * size, color, 32);
    return {list, center, 0.86f * size, paper};
  }
  void bar(float x) const {
    list.AddRectFilled(at(x - 0.06f, -0.38f), at(x + 0.06f, 0.38f), color);
  }
  /// An arc over the top that ends in an arrow on the side of `to`: -1 left, 1 right.
  void turn(float to) const {
    constexpr float kPi = std::numbers::pi_v<float>;
    list.PathArcTo(at(0.0f, 0.12f), 0.32f * size, -kPi, 0.0f, 16);
    list.PathStroke(color, 0, 0.11f * size);
    const float x = 0.32f * to;
    list.AddTriangleFilled(at(x - 0.2f, 0.1f), at(x + 0.2f, 0.1f), at(x, 0.4f), color);
  }
  void corners() const {
    for (const auto& [x, y] : std::array<ImVec2, 4>{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}) {
      const std::array<ImVec2, 3> bend = {at(0.4f * x, 0.14f * y), at(0.4f * x, 0.4f * y),
                                          at(0.14f * x, 0.4f * y)};
      list.AddPolyline(bend.data(), 3, color, 0, 0.1f * size);
    }
  }
};

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, const ImVec2& center, float size, ImU32 color,
               ImU32 paper) {
  const Pen pen{list, center, size, color};
  switch (icon) {
    case Icon::first:
      pen.bar(-0.36f);
      return pen.triangle(0.36f, -0.6f);
    case Icon::back_far:
      pen.triangle(0.0f, -0.42f);
      return pen.triangle(0.42f, -0.42f);
    case Icon::back:
      return pen.chevron(-0.16f, -1.0f);
    case Icon::play:
      return pen.on_disk(paper).triangle(-0.24f, 0.66f);
    case Icon::pause: {
      const Pen on = pen.on_disk(paper);
      for (const float x : {-0.28f, 0.08f})
        list.AddRectFilled(on.at(x, -0.36f), on.at(x + 0.2f, 0.36f), paper);
      return;
    }
    case Icon::forth:
      return pen.chevron(0.16f, 1.0f);
    case Icon::forth_far:
      pen.triangle(-0.42f, 0.42f);
      return pen.triangle(0.0f, 0.42f);
    case Icon::last:
      pen.triangle(-0.36f, 0.6f);
      return pen.bar(0.36f);
    case Icon::undo:
      return pen.turn(-1.0f);
    case Icon::redo:
      return pen.turn(1.0f);
    case Icon::close:
      for (const float y : {-0.26f, 0.26f})
        list.AddLine(pen.at(-0.26f, -y), pen.at(0.26f, y), color, 0.1f * size);
      return;
    case Icon::fit:
      return pen.corners();
  }
}

}  // namespace gjkscope
