// The folders of src, and those of src/subjects, include each other one way.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace gjkscope {
namespace {

namespace fs = std::filesystem;

/// For each folder of `root` the folders whose headers its files include, as "prefix/folder/...".
std::map<std::string, std::set<std::string>> arrows(const fs::path& root,
                                                    const std::string& prefix) {
  const std::regex include("#include \"" + prefix + "(\\w+)/");
  std::map<std::string, std::set<std::string>> out;
  for (const fs::directory_entry& file : fs::recursive_directory_iterator(root)) {
    const fs::path inside = file.path().lexically_relative(root);
    if (!file.is_regular_file() || std::distance(inside.begin(), inside.end()) < 2) continue;
    const std::string from = inside.begin()->string();
    std::ifstream lines(file.path());
    std::smatch found;
    for (std::string line; std::getline(lines, line);) {
      if (std::regex_search(line, found, include) && found[1] != from) out[from].insert(found[1]);
    }
  }
  return out;
}

/// "run > support > run", or nothing.
std::string circle(const std::map<std::string, std::set<std::string>>& arrows) {
  std::set<std::string> done;
  std::vector<std::string> difference;
  std::string found;
  const std::function<void(const std::string&)> visit = [&](const std::string& folder) {
    if (!found.empty() || done.contains(folder)) return;
    const auto before = std::find(difference.begin(), difference.end(), folder);
    if (before != difference.end()) {
      for (auto each = before; each != difference.end(); ++each) found += *each + " > ";
      found += folder;
      return;
    }
    difference.push_back(folder);
    if (const auto out = arrows.find(folder); out != arrows.end())
      for (const std::string& next : out->second) visit(next);
    difference.pop_back();
    done.insert(folder);
  };
  for (const auto& [folder, next] : arrows) visit(folder);
  return found;
}

TEST(Arrows, OfFoldersGoOneWay) {
  const fs::path src = fs::path(GJKSCOPE_SOURCE_DIR) / "src";
  EXPECT_EQ(circle(arrows(src, "")), "");
  const auto of_subjects = arrows(src / "subjects", "subjects/");
  EXPECT_GT(of_subjects.size(), 10u);
  EXPECT_EQ(circle(of_subjects), "");
}

TEST(Arrows, ACircleIsNamed) {
  EXPECT_EQ(circle({{"run", {"support"}}, {"support", {"weights", "run"}}}), "run > support > run");
}

}  // namespace
}  // namespace gjkscope
