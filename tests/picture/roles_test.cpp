// Marks that a reader must tell apart differ in shape, or in brightness by a factor of two,
// whatever the reader's eyes: as they are, without red or green receptors, in grey.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

#include "frames/frame.hpp"
#include "lessons.hpp"
#include "picture/theme.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace roles_test {

const std::filesystem::path kAssets = std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets";

/// Roles of marks for points: a frame is about these.
const std::set<std::string, std::less<>> kPoints = {
    "simplex.vertex",  "support.vertex", "closest",        "query",          "origin",
    "dropped",         "shape.vertex",   "shape.x.vertex", "shape.y.vertex", "polygon.vertex",
    "polytope.vertex", "cloud.touched",  "tree.current",   "tree.waiting",   "tree.visited",
    "tree.ahead",      "tree.cut",       "tree.off",       "tree.better"};

using Rgb = Eigen::Vector3d;

Rgb linear(const Color& color) {
  const auto channel = [](std::uint8_t value) {
    const double v = value / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return {channel(color.r), channel(color.g), channel(color.b)};
}

/// Eyes, as matrices over linear red, green, blue: all receptors, none for red, none for green
/// (Viénot, Brettel, Mollon 1999), and grey.
std::array<Eigen::Matrix3d, 4> eyes() {
  Eigen::Matrix3d protan;
  protan << 0.11238, 0.88762, 0.0, 0.11238, 0.88762, 0.0, 0.00401, -0.00401, 1.0;
  Eigen::Matrix3d deutan;
  deutan << 0.29275, 0.70725, 0.0, 0.29275, 0.70725, 0.0, -0.02234, 0.02234, 1.0;
  Eigen::Matrix3d grey;
  grey << 0.2126, 0.7152, 0.0722, 0.2126, 0.7152, 0.0722, 0.2126, 0.7152, 0.0722;
  return {Eigen::Matrix3d::Identity(), protan, deutan, grey};
}

double contrast(const Rgb& a, const Rgb& b) {
  const auto brightness = [](const Rgb& rgb) {
    return 0.2126 * rgb.x() + 0.7152 * rgb.y() + 0.0722 * rgb.z() + 0.05;
  };
  return std::max(brightness(a), brightness(b)) / std::min(brightness(a), brightness(b));
}

bool is_same(const Color& a, const Color& b) { return a.r == b.r && a.g == b.g && a.b == b.b; }

/// A mark as an eye without colours sees it.
struct Look {
  std::size_t shape = 0;  ///< Disk, diamond, cross.
  bool hollow = false;
  double radius = 0.0;
  Color color;
};

Look look_of(const Mark& mark, const Theme& theme) {
  const Style& style = theme.style(mark.role);
  const Color card = *theme.style("card").fill;
  Look look{mark.shape.index(), !style.fill || is_same(*style.fill, card), 0.0, {}};
  if (const Disk* disk = std::get_if<Disk>(&mark.shape)) look.radius = disk->radius;
  look.color = look.hollow && style.stroke ? *style.stroke : style.fill.value_or(card);
  return look;
}

/// Sizes are told apart from this ratio on.
constexpr double kRatio = 1.4;

bool are_distinct(const Look& a, const Look& b) {
  if (a.shape != b.shape || a.hollow != b.hollow) return true;
  if (std::max(a.radius, b.radius) >= kRatio * std::min(a.radius, b.radius)) return true;
  for (const Eigen::Matrix3d& eye : eyes()) {
    const Rgb seen_a = (eye * linear(a.color)).cwiseMax(0.0);
    const Rgb seen_b = (eye * linear(b.color)).cwiseMax(0.0);
    if (contrast(seen_a, seen_b) < 2.0) return false;
  }
  return true;
}

/// The roles of the theme of reference.
std::set<std::string> roles_of_theme() {
  const std::regex role(R"re(^"?([\w.-]+)"? = \{.*)re");
  std::set<std::string> roles;
  std::ifstream file(kAssets / "themes" / "light.toml");
  std::smatch found;
  for (std::string line; std::getline(file, line);) {
    if (std::regex_match(line, found, role)) roles.insert(found[1]);
  }
  return roles;
}

/// The text of the program's sources.
std::string sources() {
  std::string all;
  for (const char* folder : {"src", "viewer"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(
             std::filesystem::path(GJKSCOPE_SOURCE_DIR) / folder)) {
      const auto ending = entry.path().extension();
      if (ending != ".cpp" && ending != ".hpp") continue;
      std::ifstream file(entry.path());
      all.append(std::istreambuf_iterator<char>(file), {});
    }
  }
  return all;
}

/// A role is drawn as it is, or with more parts.
bool is_drawn(const std::set<std::string>& drawn, const std::string& role) {
  const auto next = drawn.lower_bound(role);
  if (next != drawn.end() && *next == role) return true;
  return std::any_of(next, drawn.end(),
                     [&](const std::string& other) { return other.starts_with(role + "."); });
}

TEST(Roles, AreDrawnAndTheLegendSpeaksOfNoOther) {
  const Fonts fonts(kAssets / "fonts.toml");
  std::set<std::string> drawn;
  std::map<std::string, bool> explained;
  for (const Lesson& lesson : testing::shipped_lessons()) {
    const LessonRun run = run_lesson(lesson);
    EffectGraph effects(run);
    std::set<std::string> here;
    for (const FramePicture& frame : lesson_pictures(run, effects, fonts)) {
      for (const Mark& mark : frame.picture.marks) here.insert(mark.role);
    }
    for (const LegendEntry& entry : legend_entries(run)) {
      bool& is_seen = explained[std::string(entry.role)];
      is_seen = is_seen || here.contains(std::string(entry.role));
    }
    drawn.merge(here);
  }
  for (const auto& [role, is_seen] : explained)
    EXPECT_TRUE(is_seen) << "the legend explains " << role << ", and nothing draws it";
  const std::string text = sources();
  const auto has_literal = [&](const std::string& literal) {
    return text.find('"' + literal + '"') != std::string::npos;
  };
  // "weight.bar" and ".hatch"
  const auto is_written = [&](const std::string& role) {
    const std::size_t last = std::min(role.rfind('.'), role.size());
    return has_literal(role) ||
           (has_literal(role.substr(0, last)) && has_literal(role.substr(last)));
  };
  const std::set<std::string> roles = roles_of_theme();
  EXPECT_GT(roles.size(), 200u);
  for (const std::string& role : roles) {
    EXPECT_TRUE(is_drawn(drawn, role) || is_written(role))
        << "light.toml has " << role << ", and nothing draws it";
  }
}

TEST(Roles, AreToldApartByEveryEye) {
  const Fonts fonts(kAssets / "fonts.toml");
  std::vector<std::pair<std::string, Theme>> themes;
  for (const std::string& name : Theme::names(kAssets / "themes"))
    themes.emplace_back(name, Theme::load(kAssets / "themes", name));
  std::size_t compared = 0;
  for (const Lesson& lesson : testing::lessons_for_long_tests()) {
    const LessonRun run = run_lesson(lesson);
    EffectGraph effects(run);
    int index = 0;
    for (const FramePicture& frame : lesson_pictures(run, effects, fonts)) {
      ++index;
      std::map<int, std::map<std::string, const Mark*>> views;
      for (const Mark& mark : frame.picture.marks) {
        if (mark.clip >= 0 && kPoints.contains(mark.role)) views[mark.clip][mark.role] = &mark;
      }
      for (const auto& [view, marks] : views) {
        for (auto a = marks.begin(); a != marks.end(); ++a) {
          for (auto b = std::next(a); b != marks.end(); ++b) {
            for (const auto& [name, theme] : themes) {
              ++compared;
              EXPECT_TRUE(are_distinct(look_of(*a->second, theme), look_of(*b->second, theme)))
                  << lesson.id << ", frame " << index << ", theme " << name << ": " << a->first
                  << " and " << b->first;
            }
          }
        }
      }
    }
  }
  EXPECT_GT(compared, 1000u);
}

}  // namespace roles_test
}  // namespace gjkscope
