#pragma once
// Prose of a lesson: text with placeholders that each frame fills with its step's values. Braces
// that are meant as such are doubled: "{{" gives "{".

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gjkscope {

struct PlaceholderInfo {
  std::string_view name;
  std::string_view meaning;
};

/// All placeholders there are of any run; an algorithm that follows GJK has more.
inline constexpr std::array<PlaceholderInfo, 18> kPlaceholders = {{
    {"distance", "distance between the shapes, as far as this step knows it"},
    {"lower", "certified lower bound of the distance"},
    {"upper", "certified upper bound of the distance"},
    {"u", "barycentric coordinate of the query point for the simplex's first vertex, signed"},
    {"v", "the same for the second vertex"},
    {"w", "the same for the third vertex"},
    {"weights", "weights of P, each with its vertex"},
    {"P", "closest point of the simplex to the origin, or to Q"},
    {"Q", "query point"},
    {"d", "search direction"},
    {"region", "Voronoi region that holds the query point"},
    {"simplex", "vertices of the simplex"},
    {"support", "support point last found"},
    {"iteration", "iteration of this step"},
    {"iterations", "iterations of the whole run"},
    {"stop", "why the run ended"},
    {"x", "name of shape X"},
    {"y", "name of shape Y"},
}};

/// Stands for a placeholder that has no value at a step.
inline constexpr std::string_view kNoValue = "–";

/// A piece of prose: text to show as it stands (`{{` already undoubled), the name of a placeholder,
/// or a brace without its partner.
struct ProsePart {
  enum class Kind { text, placeholder, stray_brace };
  Kind kind = Kind::text;
  std::string text;
};
[[nodiscard]] std::vector<ProsePart> prose_parts(std::string_view prose);

/// The text with its placeholders filled in; one without a value becomes kNoValue. Stray braces,
/// which loading refuses, stay as they are.
[[nodiscard]] std::string expand(std::string_view prose,
                                 const std::map<std::string, std::string>& values);

}  // namespace gjkscope
