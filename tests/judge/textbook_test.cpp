// The textbook's pages in C++ and in Python give the same answers, bit for bit.

#include "gjk/textbook.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/file.hpp"
#include "study/families.hpp"
#include "temporary_folder.hpp"

namespace gjkscope {
namespace textbook_pages_test {

using Json = nlohmann::json;

textbook::Polygon world(const std::vector<gjk::Vec<double, 2>>& shape,
                        const gjk::Pose<double, 2>& pose) {
  textbook::Polygon out;
  for (const auto& vertex : shape) out.push_back(pose.rotated(vertex) + pose.translation);
  return out;
}

Json points(const textbook::Polygon& polygon) {
  Json out = Json::array();
  for (const textbook::Point& p : polygon) out.push_back({p.x(), p.y()});
  return out;
}

TEST(TextbookPages, GiveTheSameAnswers) {
  constexpr int kPairs = 12 * families::kFamilyCount;
  families::Source random(20100311);
  std::string cases;
  std::vector<textbook::Output> expected;
  for (int i = 0; i < kPairs; ++i) {
    const auto pair =
        random.pair<double>(static_cast<families::Family>(i % families::kFamilyCount));
    const textbook::Input input{world(pair.x, pair.x_pose), world(pair.y, pair.y_pose)};
    expected.push_back(textbook::gjk(input));
    cases += Json{{"a", points(input.x)}, {"b", points(input.y)}}.dump() + "\n";
  }
  const test::TemporaryFolder folder;
  const std::string in = folder.file("cases", cases);
  const std::string out = (folder.path() / "answers").string();
  const std::string page = std::string(GJKSCOPE_SOURCE_DIR) + "/tests/gjk/textbook.py";
  ASSERT_EQ(0, std::system(fmt::format("python3 '{}' <'{}' >'{}'", page, in, out).c_str()));
  std::istringstream answers(read_whole(out));
  int overlaps = 0;
  std::string line;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_TRUE(std::getline(answers, line)) << "answer " << i;
    const Json answer = Json::parse(line);
    SCOPED_TRACE(fmt::format("pair {}: {}", i, line));
    const textbook::Output& it = expected[i];
    EXPECT_EQ(it.distance, answer["distance"].get<double>());
    EXPECT_EQ(it.simplex.size() == 3, answer["overlap"].get<bool>());
    EXPECT_EQ(it.iterations, answer["iterations"].get<int>());
    EXPECT_EQ(points({it.x}), Json::array({answer["a"]}));
    EXPECT_EQ(points({it.y}), Json::array({answer["b"]}));
    overlaps += it.simplex.size() == 3 ? 1 : 0;
  }
  EXPECT_GE(overlaps, kPairs / 20);
  EXPECT_LE(overlaps, kPairs * 19 / 20);
}

TEST(TextbookPages, HaveTheSameLength) {
  for (const char* name : {"textbook.hpp", "textbook.py"}) {
    const std::string page =
        read_whole(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "tests" / "gjk" / name);
    EXPECT_EQ(80, std::count(page.begin(), page.end(), '\n')) << name;
  }
}

}  // namespace textbook_pages_test
}  // namespace gjkscope
