#pragma once
// Lesson files that the tests of this folder read.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace gjkscope::testing {

inline std::string file_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline std::filesystem::path lessons_folder() {
  return std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "lessons";
}

inline std::string readme() { return file_text(lessons_folder() / "README.md"); }

/// The first block marked as TOML.
inline std::string readme_example() {
  const std::string text = readme();
  const std::string fence = "```toml\n";
  const std::size_t begin = text.find(fence) + fence.size();
  return text.substr(begin, text.find("```", begin) - begin);
}

inline std::vector<std::filesystem::path> shipped_lesson_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(lessons_folder())) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// A lesson with no key that it could do without.
inline const std::string kShortestLesson = R"(title = "Shortest"
chapter = 1
order = 1
prose = "Nothing."
shapes.X.vertices = [[0, 0]]
shapes.Y.vertices = [[1, 0], [2, 0]]
views = [{ show = "world" }]
expect.stop = "repeated-support"
)";

/// A lesson with every key there is, but for those of a motion (motion_test.cpp).
inline const std::string kFullLesson = R"(title = "Two triangles"
chapter = 4
order = 3
source = "Own example"
prose = "The distance is {distance}; {{braces}} stay."

[shapes.X]
name = "Left"
names = ["A", "B", "C"]
vertices = [[0.0, 1.0], [1, 1], [1, "0x1.8p-3"]]
rotate = 15.0

[shapes.Y]
name = "Right"
names = ["K", "L", "M"]
vertices = [[4, 0], [6, 0], [5, 2]]
translate = [0.5, 0.0]
rotate = -30

[query]
scalar = "float"
direction = "towards-origin"
regions = "edges-first"
stop = ["no-progress"]
tolerance = 0.125
cap = 20
start = ["M-C", "K-A"]

[steps]
tour = "iteration"
until = "stop"

[path]
points = [[0, 0], [1, 1]]
frames = 13

[[views]]
show = "world"
title = "World: X and Y"
camera = { center = [2, 1], height = 6.0 }
effects = ["voronoi-regions", "history"]
close-up = { center = [0, -1], height = 1e-9, corner = "top left" }

[[views]]
show = "difference"

[panel]
blocks = ["pseudocode", "weights"]
listing = "gjk"

[expect]
stop = "no-progress"
supports = ["K-B"]
distance = 2.5
)";

}  // namespace gjkscope::testing
