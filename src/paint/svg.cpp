#include "paint/svg.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "base/html.hpp"
#include "paint/arrow.hpp"
#include "picture/text_box.hpp"

namespace gjkscope {
namespace {

/// To a hundredth of a pixel, without zeros that say nothing.
std::string number(double value) {
  const double hundredths = std::abs(100.0 * value);
  const double down = std::floor(hundredths);
  // Halfway between two the value itself decides, which 100.0 * value may have rounded away.
  constexpr double kExact = 1e9;
  if (!(hundredths < kExact) || std::abs(hundredths - down - 0.5) < 1e-6) {
    std::string out = fmt::format("{:.2f}", value);
    out.erase(out.find_last_not_of('0') + 1);
    if (out.back() == '.') out.pop_back();
    return out == "-0" ? "0" : out;
  }
  const auto near = static_cast<int>(hundredths - down < 0.5 ? down : down + 1.0);
  std::string out = value < 0.0 && near > 0 ? "-" : "";
  out += std::to_string(near / 100);
  if (near % 100 == 0) return out;
  out += '.';
  out += static_cast<char>('0' + near / 10 % 10);
  if (near % 10 > 0) out += static_cast<char>('0' + near % 10);
  return out;
}

std::string path(const std::vector<Point>& points, bool closed) {
  std::string out;
  for (const Point& p : points) {
    out += out.empty() ? 'M' : 'L';
    out += number(p.x());
    out += ' ';
    out += number(p.y());
  }
  return closed ? out + "Z" : out;
}

std::string paint(std::string_view what, const std::optional<Color>& color) {
  if (!color) return fmt::format(R"( {}="none")", what);
  std::string out = fmt::format(R"( {}="#{:02x}{:02x}{:02x}")", what, color->r, color->g, color->b);
  if (color->a < 255) out += fmt::format(R"( {}-opacity="{}")", what, number(color->a / 255.0));
  return out;
}

std::string_view family(Face face) {
  return is_monospaced(face) ? "'JetBrains Mono','DejaVu Sans Mono',monospace"
                             : "Inter,'DejaVu Sans',sans-serif";
}

int weight(Face face) {
  switch (face) {
    case Face::medium:
      return 500;
    case Face::semibold:
      return 600;
    case Face::bold:
    case Face::mono_bold:
      return 700;
    case Face::regular:
    case Face::mono:
      break;
  }
  return 400;
}

/// One mark as an element, without its clip.
class MarkWriter {
 public:
  /// `more`: attributes of each element.
  MarkWriter(const Theme& theme, const Style& style, const Fonts& fonts, const std::string& more)
      : theme_(theme), style_(style), fonts_(fonts), more_(more) {}

  std::string operator()(const Polygon& polygon) const {
    return outline(polygon.points, style_.fill, style_.stroke, true);
  }
  std::string operator()(const Polyline& line) const {
    return line.closed ? outline(line.points, {}, style_.stroke, true)
                       : outline(line.points, {}, line_color(), false);
  }
  std::string operator()(const Arrow& arrow) const {
    const std::optional<ArrowParts> parts = arrow_parts(arrow, style_.width);
    if (!parts) return "";
    std::string out;
    if (parts->shaft_end) out += outline({arrow.from, *parts->shaft_end}, {}, line_color(), false);
    return out + outline({parts->head.begin(), parts->head.end()}, line_color(), {}, true);
  }
  std::string operator()(const Disk& disk) const {
    return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}{}{}/>\n", number(disk.center.x()),
                       number(disk.center.y()), number(disk.radius), paint("fill", style_.fill),
                       stroke(style_.stroke), more_);
  }
  std::string operator()(const Cross& cross) const {
    const Point x(cross.radius, 0.0);
    const Point y(0.0, cross.radius);
    return outline({cross.center - x, cross.center + x}, {}, line_color(), false) +
           outline({cross.center - y, cross.center + y}, {}, line_color(), false);
  }
  /// The outline lies inside.
  std::string operator()(const Box& box) const {
    const double inset = style_.stroke ? 0.5 * style_.width : 0.0;
    const Point size = box.rect.size() - Point::Constant(2.0 * inset);
    if ((size.array() <= 0.0).any()) return "";
    return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"{}\"{}{}{}/>\n",
                       number(box.rect.min.x() + inset), number(box.rect.min.y() + inset),
                       number(size.x()), number(size.y()),
                       number(std::max(0.0, box.corner - inset)), paint("fill", style_.fill),
                       stroke(style_.stroke), more_);
  }
  std::string operator()(const Text& text) const {
    if (!style_.fill) return "";
    const Rect box = box_of(fonts_, text);
    return fmt::format(
        "<text x=\"{}\" y=\"{}\" textLength=\"{}\" font-family=\"{}\" font-size=\"{}\" "
        "font-weight=\"{}\"{}{}>{}</text>\n",
        number(box.min.x()), number(text.at.y()), number(box.size().x()), family(text.style.face),
        number(text.style.size), weight(text.style.face), paint("fill", style_.fill), more_,
        text.tones.empty() ? escape_html(text.text) : toned(text.tones));
  }

 private:
  [[nodiscard]] std::string toned(const std::vector<Tone>& tones) const {
    std::string out;
    for (const Tone& tone : tones) {
      out += fmt::format("<tspan{}>{}</tspan>", paint("fill", theme_.style(tone.role).fill),
                         escape_html(tone.text));
    }
    return out;
  }

  /// The colour of a line, which a style may name as stroke or as fill.
  [[nodiscard]] std::optional<Color> line_color() const {
    return style_.stroke ? style_.stroke : style_.fill;
  }

  [[nodiscard]] std::string stroke(const std::optional<Color>& color) const {
    if (!color || style_.width <= 0.0) return "";
    std::string out =
        paint("stroke", color) + fmt::format(R"( stroke-width="{}")", number(style_.width));
    std::string dashes;
    for (const double length : style_.dash) {
      dashes += fmt::format("{}{}", dashes.empty() ? "" : " ", number(length));
    }
    if (!dashes.empty()) out += fmt::format(R"( stroke-dasharray="{}")", dashes);
    return out;
  }

  [[nodiscard]] std::string outline(const std::vector<Point>& points,
                                    const std::optional<Color>& fill,
                                    const std::optional<Color>& line, bool closed) const {
    if (points.empty()) return "";
    return fmt::format("<path d=\"{}\"{}{}{}/>\n", path(points, closed), paint("fill", fill),
                       stroke(line), more_);
  }

  const Theme& theme_;
  const Style& style_;
  const Fonts& fonts_;
  const std::string& more_;
};

}  // namespace

std::string subject_name(const Subject& subject) {
  using Kind = Subject::Kind;
  switch (subject.kind) {
    case Kind::none:
      return "";
    case Kind::vertex_of_x:
      return fmt::format("x {}", subject.x);
    case Kind::vertex_of_y:
      return fmt::format("y {}", subject.y);
    case Kind::shape_x:
      return "X";
    case Kind::shape_y:
      return "Y";
    case Kind::difference_vertex:
      return fmt::format("z {} {}", subject.x, subject.y);
    case Kind::difference:
      return "Z";
    case Kind::region:
      return fmt::format("region {}", subject.x);
    case Kind::frame:
      return fmt::format("frame {}", subject.x);
    case Kind::phase:
      return fmt::format("phase {}", subject.x);
    case Kind::study_dot:
      return fmt::format("dot {}", subject.x);
    case Kind::tree_node:
      if (subject.x >= 0 && subject.y >= 0) return fmt::format("pair {} {}", subject.x, subject.y);
      return subject.x >= 0 ? fmt::format("node x {}", subject.x)
                            : fmt::format("node y {}", subject.y);
  }
  return "";
}

std::string to_svg(const Picture& picture, const Fonts& fonts, const Theme& theme,
                   const std::string& title, const std::string& record, bool transparent,
                   double zoom) {
  const std::string width = number(picture.width);
  const std::string height = number(picture.height);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{3}\" height=\"{4}\" viewBox=\"0 0 {0} "
      "{1}\" role=\"img\" stroke-linejoin=\"round\" stroke-linecap=\"round\" "
      "style=\"white-space:pre;font-variant-numeric:tabular-nums;font-kerning:none\">\n"
      "<title>{2}</title>\n",
      width, height, escape_html(title), number(zoom * picture.width),
      number(zoom * picture.height));
  if (!record.empty()) out += fmt::format("<metadata>{}</metadata>\n", escape_html(record));
  for (std::size_t i = 0; i < picture.clips.size(); ++i) {
    const Rect& rect = picture.clips[i];
    out += fmt::format(
        "<clipPath id=\"clip{}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"{}\"/>"
        "</clipPath>\n",
        i, number(rect.min.x()), number(rect.min.y()), number(rect.size().x()),
        number(rect.size().y()), number(picture.clip_corner));
  }
  if (!transparent) {
    out += fmt::format("<rect width=\"{}\" height=\"{}\"{}/>\n", width, height,
                       paint("fill", theme.background()));
  }
  for (const Mark& mark : picture.marks) {
    std::string more = mark.clip < 0 ? "" : fmt::format(" clip-path=\"url(#clip{})\"", mark.clip);
    more += fmt::format(" data-mark=\"{}\"", mark.role);
    if (const std::string name = subject_name(mark.subject); !name.empty())
      more += fmt::format(" data-of=\"{}\"", name);
    out += std::visit(MarkWriter(theme, theme.style(mark), fonts, more), mark.shape);
  }
  return out + "</svg>\n";
}

}  // namespace gjkscope
