#include "paint/imgui_painter.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <stdexcept>

#include "paint/arrow.hpp"
#include "paint/cut.hpp"
#include "picture/text_box.hpp"

namespace gjkscope {
namespace {

using std::numbers::pi;

// Indices of a draw list have 16 bits. The margin holds the largest single mark: a dashed line
// across a frame has some hundred dashes of about 60 vertices.
constexpr int kVertexLimit = 65535;
constexpr int kVerticesPerList = 40000;

// Ends of lines are round beyond this half width, in pixels of the list.
constexpr double kSquareEnds = 1.0;

constexpr double kCoincident = 1e-3;

using Points = std::vector<Point>;

Points without_repeats(const Points& points, bool closed) {
  Points kept;
  for (const Point& p : points) {
    if (kept.empty() || (p - kept.back()).norm() > kCoincident) kept.push_back(p);
  }
  while (closed && kept.size() > 1 && (kept.front() - kept.back()).norm() <= kCoincident) {
    kept.pop_back();
  }
  return kept;
}

/// The area that a round pen covers on its way from `from` to `to`.
Points capsule(const Point& from, const Point& to, double radius, double pixels_per_unit) {
  const double angle = std::atan2(to.y() - from.y(), to.x() - from.x());
  Points points = arc(to, radius, angle - 0.5 * pi, angle + 0.5 * pi, pixels_per_unit);
  const Points back = arc(from, radius, angle + 0.5 * pi, angle + 1.5 * pi, pixels_per_unit);
  points.insert(points.end(), back.begin(), back.end());
  return points;
}

Points rounded_box(const Rect& rect, double corner, double pixels_per_unit) {
  const double radius = std::clamp(corner, 0.0, std::max(0.0, 0.5 * rect.size().minCoeff()));
  const Point& a = rect.min;
  const Point& b = rect.max;
  if (radius < kCoincident) return {a, {b.x(), a.y()}, b, {a.x(), b.y()}};
  Points points;
  const Point centers[] = {{b.x() - radius, b.y() - radius},
                           {a.x() + radius, b.y() - radius},
                           {a.x() + radius, a.y() + radius},
                           {b.x() - radius, a.y() + radius}};
  for (int i = 0; i < 4; ++i) {
    const Points quarter =
        arc(centers[i], radius, 0.5 * pi * i, 0.5 * pi * (i + 1), pixels_per_unit);
    points.insert(points.end(), quarter.begin(), quarter.end());
  }
  return points;
}

/// More dashes than this do not fit a draw list. Straight lines are cut to what shows before they
/// are dashed; a longer bent one runs far out of the frame, and what is seen of it may be solid.
constexpr double kMostDashes = 400.0;

[[nodiscard]] double period_of(std::span<const double> pattern) {
  return std::accumulate(pattern.begin(), pattern.end(), 0.0);
}

[[nodiscard]] bool has_too_many_dashes(const Points& points, bool closed,
                                       std::span<const double> pattern) {
  double length = closed ? (points.front() - points.back()).norm() : 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return !(length <= kMostDashes * period_of(pattern));
}

/// The pieces of a line that its dash pattern leaves, from its first point on.
std::vector<Points> dashes(const Points& points, bool closed, std::span<const double> pattern) {
  std::vector<Points> pieces;
  std::size_t phase = 0;
  double left = pattern[0];
  bool on = true;
  const std::size_t count = points.size();
  Points piece = {points[0]};
  for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
    const Point from = points[i];
    const Point to = points[(i + 1) % count];
    const double length = (to - from).norm();
    double at = 0.0;
    while (length - at > left) {
      at += left;
      const Point corner = from + (to - from) * (at / length);
      if (on) {
        piece.push_back(corner);
        pieces.push_back(std::move(piece));
      }
      piece = {corner};
      on = !on;
      phase = (phase + 1) % pattern.size();
      left = pattern[phase];
    }
    left -= length - at;
    if (on) piece.push_back(to);
  }
  if (on && piece.size() > 1) pieces.push_back(std::move(piece));
  return pieces;
}

class MarkPainter {
 public:
  MarkPainter(ImDrawList& list, const Theme& theme, const AtlasFonts& fonts,
              const DrawPlacement& placement)
      : list_(list), theme_(theme), fonts_(fonts), placement_(placement) {}

  void operator()(const Polygon& polygon) const {
    const Points points = without_repeats(polygon.points, true);
    fill(clip_outline_.empty() ? points : without_repeats(intersect(points, clip_outline_), true));
    stroke(points, true);
  }

  void operator()(const Polyline& polyline) const {
    Points points = without_repeats(polyline.points, polyline.closed);
    // Aligned to pixels of the frame: then the samples of one pixel agree.
    if (points.size() == 2) align_to_pixels(points[0], points[1], *style_, 1.0);
    stroke(points, polyline.closed && points.size() > 2);
  }

  void operator()(const Arrow& arrow) const {
    const std::optional<ArrowParts> parts = arrow_parts(arrow, style_->width);
    if (!parts) return;
    if (parts->shaft_end) stroke({arrow.from, *parts->shaft_end}, false);
    fill_convex({parts->head.begin(), parts->head.end()}, line_color());
  }

  void operator()(const Disk& disk) const {
    const Points points = circle(disk.center, disk.radius, placement_.scale);
    fill(points);
    stroke(points, true);
  }

  void operator()(const Cross& mark) const {
    const Point x(mark.radius, 0.0);
    const Point y(0.0, mark.radius);
    stroke({mark.center - x, mark.center + x}, false);
    stroke({mark.center - y, mark.center + y}, false);
  }

  void operator()(const Box& box) const {
    // The outline lies inside, so that a box on whole pixels has a crisp one.
    Rect rect = box.rect;
    double corner = box.corner;
    if (style_->stroke) {
      const Point inset = Point::Constant(0.5 * style_->width);
      rect = {rect.min + inset, rect.max - inset};
      corner -= inset.x();
    }
    if ((rect.size().array() <= 0.0).any()) return;
    const Points points = rounded_box(rect, corner, placement_.scale);
    fill(points);
    stroke(points, true);
  }

  void operator()(const Text& text) const {
    if (!style_->fill) return;
    const AtlasFonts::Sized& sized = fonts_.font(text.style);
    const ImFont& font = *sized.font;
    const double density = sized.density;
    const std::u32string characters = code_points(text.text);
    double width = 0.0;
    for (const char32_t c : characters) width += density * glyph(font, c).AdvanceX;

    const double share = share_before(text.align);
    // Whole frame pixels in height: base lines of a row agree and strokes stay sharp. Whole list
    // pixels across: the same word looks the same wherever it stands.
    const double scale = placement_.scale;
    const double x = std::round(placement_.origin.x() + text.at.x() * scale - share * width);
    const double y = std::round(placement_.origin.y() + std::round(text.at.y()) * scale) -
                     std::round(density * font.Ascent);

    list_.PushTextureID(font.ContainerAtlas->TexID);
    double pen = x;
    const auto write = [&](const std::u32string& part, ImU32 ink) {
      for (const char32_t c : part) {
        const ImFontGlyph& g = glyph(font, c);
        if (g.Visible) {
          list_.PrimReserve(6, 4);
          list_.PrimRectUV(at(pen + density * g.X0, y + density * g.Y0),
                           at(pen + density * g.X1, y + density * g.Y1), ImVec2(g.U0, g.V0),
                           ImVec2(g.U1, g.V1), ink);
        }
        pen += density * g.AdvanceX;
      }
    };
    if (text.tones.empty()) write(characters, color(*style_->fill));
    for (const Tone& tone : text.tones)
      write(code_points(tone.text), color(theme_.style(tone.role).fill.value_or(*style_->fill)));
    list_.PopTextureID();
  }

  void set_style(const Style& style) { style_ = &style; }

  /// Polygons are cut to this; a draw list itself cuts to upright rectangles only.
  void set_rounded_clip(const Rect& clip, double corner) {
    clip_outline_ = rounded_box(clip, corner, placement_.scale);
  }
  void no_rounded_clip() { clip_outline_.clear(); }

 private:
  static ImVec2 at(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }
  static ImU32 color(const Color& c) { return IM_COL32(c.r, c.g, c.b, c.a); }

  static const ImFontGlyph& glyph(const ImFont& font, char32_t c) {
    constexpr ImWchar kReplacement = 0xFFFD;
    const ImFontGlyph* found =
        c <= 0xFFFF ? font.FindGlyphNoFallback(static_cast<ImWchar>(c)) : nullptr;
    return *(found ? found : font.FindGlyph(kReplacement));
  }

  [[nodiscard]] std::optional<Color> line_color() const {
    return style_->stroke ? style_->stroke : style_->fill;
  }

  [[nodiscard]] std::vector<ImVec2> to_list(const Points& points) const {
    std::vector<ImVec2> result;
    result.reserve(points.size());
    for (const Point& p : points) {
      const Point q = placement_.origin + placement_.scale * p;
      result.push_back(at(q.x(), q.y()));
    }
    return result;
  }

  void fill(const Points& points) const {
    if (style_->fill) fill_convex(points, style_->fill);
  }

  void fill_convex(Points points, const std::optional<Color>& paint) const {
    if (!paint || paint->a == 0 || points.size() < 3) return;
    double area = 0.0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      area += cross(points[i] - points[0], points[i + 1] - points[0]);
    }
    // A draw list smooths the outer side of an outline that turns this way.
    if (area < 0.0) std::reverse(points.begin(), points.end());
    const std::vector<ImVec2> outline = to_list(points);
    list_.AddConvexPolyFilled(outline.data(), static_cast<int>(outline.size()), color(*paint));
  }

  void stroke(const Points& points, bool closed) const {
    // Outlines need a stroke of their own; what is only a line may name its colour either way.
    const std::optional<Color> paint = closed ? style_->stroke : line_color();
    if (!paint || paint->a == 0 || style_->width <= 0.0 || points.empty()) return;
    if (points.size() == 1) {
      dot(points[0], *paint);
    } else if (style_->dash.empty()) {
      solid(points, closed, *paint);
    } else if (points.size() == 2 && (points[1] - points[0]).norm() > period_of(style_->dash)) {
      const auto part = visible_part(points[0], points[1], visible(), period_of(style_->dash));
      if (part) dashed({part->first, part->second}, false, *paint);
    } else {
      dashed(points, closed, *paint);
    }
  }

  /// The visible part of the list, in frame pixels.
  [[nodiscard]] Rect visible() const {
    const auto to_frame = [&](const ImVec2& v) {
      return Point((Point(v.x, v.y) - placement_.origin) / placement_.scale);
    };
    return {to_frame(list_.GetClipRectMin()), to_frame(list_.GetClipRectMax())};
  }

  void dashed(const Points& points, bool closed, const Color& paint) const {
    if (has_too_many_dashes(points, closed, style_->dash)) {
      solid(points, closed, paint);
    } else {
      for (const Points& piece : dashes(points, closed, style_->dash)) {
        solid(without_repeats(piece, false), false, paint);
      }
    }
  }

  void dot(const Point& center, const Color& paint) const {
    fill_convex(circle(center, 0.5 * style_->width, placement_.scale), paint);
  }

  /// A line with round ends; a thin line has square ends of the same area, which look the same.
  void straight(const Point& from, const Point& to, const Color& paint) const {
    const double radius = 0.5 * style_->width;
    if (radius * placement_.scale > kSquareEnds) {
      return fill_convex(capsule(from, to, radius, placement_.scale), paint);
    }
    const Point end = 0.25 * pi * radius * (to - from).normalized();
    const std::vector<ImVec2> line = to_list({from - end, to + end});
    list_.AddPolyline(line.data(), 2, color(paint), ImDrawFlags_None,
                      static_cast<float>(style_->width * placement_.scale));
  }

  /// Round joins and ends, as in `stroke-linejoin="round"`.
  void solid(const Points& points, bool closed, const Color& paint) const {
    if (points.size() == 1) return dot(points[0], paint);
    if (points.size() == 2) return straight(points[0], points[1], paint);
    if (turns_gently(points, closed) || paint.a < 255) {
      const std::vector<ImVec2> line = to_list(points);
      list_.AddPolyline(line.data(), static_cast<int>(line.size()), color(paint),
                        closed ? ImDrawFlags_Closed : ImDrawFlags_None,
                        static_cast<float>(style_->width * placement_.scale));
      if (closed || paint.a < 255) return;
      dot(points.front(), paint);
      dot(points.back(), paint);
      return;
    }
    for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i) {
      const Point& from = points[i];
      const Point& to = points[(i + 1) % points.size()];
      const Point unit = (to - from).normalized();
      const Point half = 0.5 * style_->width * Point(-unit.y(), unit.x());
      fill_convex({from + half, from - half, to - half, to + half}, paint);
    }
    for (const Point& joint : points) dot(joint, paint);
  }

  /// Whether the mitred joins of a draw list can stand for round ones: no turn beyond 30 degrees.
  [[nodiscard]] static bool turns_gently(const Points& points, bool closed) {
    constexpr double kCosine = 0.866;
    const std::size_t count = points.size();
    for (std::size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < count; ++i) {
      const Point in = (points[i] - points[(i + count - 1) % count]).normalized();
      const Point out = (points[(i + 1) % count] - points[i]).normalized();
      if (in.dot(out) < kCosine) return false;
    }
    return true;
  }

  ImDrawList& list_;
  const Theme& theme_;
  const AtlasFonts& fonts_;
  DrawPlacement placement_;
  const Style* style_ = nullptr;
  Points clip_outline_;
};

std::vector<unsigned short> glyph_ranges(bool (*chosen)(char32_t)) {
  std::vector<unsigned short> ranges;
  for (const char32_t c : Fonts::characters()) {
    if (!chosen(c)) continue;
    if (!ranges.empty() && ranges.back() + 1u == c) {
      ranges.back() = static_cast<unsigned short>(c);
    } else {
      ranges.insert(ranges.end(), 2, static_cast<unsigned short>(c));
    }
  }
  ranges.push_back(0);
  return ranges;
}

/// Dear ImGui makes fonts in whole pixels since 1.90, each with as many texels per pixel as asked
/// for.
double density_of([[maybe_unused]] double pixels) {
#if IMGUI_VERSION_NUM >= 19000
  return pixels / std::floor(pixels);
#else
  return 1.0;
#endif
}

void set_size(ImFontConfig& config, double pixels, [[maybe_unused]] double density) {
#if IMGUI_VERSION_NUM >= 19000
  config.SizePixels = static_cast<float>(std::round(pixels / density));
  config.RasterizerDensity = static_cast<float>(density);
#else
  config.SizePixels = static_cast<float>(pixels);
#endif
}

bool is_digit(char32_t c) { return c >= '0' && c <= '9'; }

}  // namespace

AtlasFonts::AtlasFonts(ImFontAtlas& atlas, const Fonts& fonts, double scale) : scale_(scale) {
  ranges_.push_back(
      {glyph_ranges(is_digit), glyph_ranges([](char32_t c) { return !is_digit(c); })});
  const auto& [digits, others] = ranges_.front();

  for (const TextStyle& style : type::all_styles()) {
    const auto known = std::find_if(fonts_.begin(), fonts_.end(),
                                    [&](const auto& entry) { return entry.first == style; });
    if (known != fonts_.end()) continue;

    const double em = style.size * scale;
    const double height = fonts.height_in_em(style.face);
    const double density = density_of(height * em);
    const auto digit = static_cast<float>(fonts.digit_width_in_em(style.face) * em / density);
    const auto add = [&](const std::vector<unsigned char>& file, double height_in_em,
                         const GlyphRanges& ranges, bool tabular, bool merge) {
      ImFontConfig config;
      // The atlas reads the file and does not write to it.
      config.FontData = const_cast<unsigned char*>(file.data());
      config.FontDataSize = static_cast<int>(file.size());
      config.FontDataOwnedByAtlas = false;
      set_size(config, height_in_em * em, density);
      config.OversampleH = 2;
      config.OversampleV = 1;
      config.GlyphRanges = ranges.data();
      config.MergeMode = merge;
      if (tabular) config.GlyphMinAdvanceX = config.GlyphMaxAdvanceX = digit;
      return atlas.AddFont(&config);
    };
    const bool fixed = is_monospaced(style.face);
    ImFont* font = add(fonts.file(style.face), height, others, fixed, false);
    add(fonts.file(style.face), height, digits, true, true);
    add(fonts.fallback_file(style.face), fonts.fallback_height_in_em(style.face), others, fixed,
        true);
    fonts_.push_back({style, {font, density}});
  }
}

const AtlasFonts::Sized& AtlasFonts::font(const TextStyle& style) const {
  for (const auto& [known, font] : fonts_) {
    if (known == style) return font;
  }
  throw std::out_of_range(
      fmt::format("a text style of size {} is not in type::all_styles()", style.size));
}

std::size_t paint_marks(ImDrawList& list, const Picture& picture, std::size_t first,
                        const Theme& theme, const AtlasFonts& fonts,
                        const DrawPlacement& placement) {
  MarkPainter painter(list, theme, fonts, placement);
  const auto corner = [&](const Point& p) {
    const Point q = placement.origin + placement.scale * p;
    return ImVec2(static_cast<float>(std::round(q.x())), static_cast<float>(std::round(q.y())));
  };
  list.PushTextureID(placement.shape_texture);
  std::size_t i = first;
  for (; i < picture.marks.size() && list.VtxBuffer.Size < kVerticesPerList; ++i) {
    const Mark& mark = picture.marks[i];
    const Style style = theme.style(mark);
    painter.set_style(style);
    const bool clipped = mark.clip >= 0;
    if (clipped) {
      const Rect& rect = picture.clips.at(static_cast<std::size_t>(mark.clip));
      list.PushClipRect(corner(rect.min), corner(rect.max), true);
      if (picture.clip_corner > 0.0) painter.set_rounded_clip(rect, picture.clip_corner);
    }
    std::visit(painter, mark.shape);
    if (clipped) list.PopClipRect();
    painter.no_rounded_clip();
  }
  list.PopTextureID();
  if (list.VtxBuffer.Size > kVertexLimit) {
    throw std::length_error(
        fmt::format(R"(a mark "{}" is too large for a draw list)", picture.marks[i - 1].role));
  }
  return i;
}

}  // namespace gjkscope
