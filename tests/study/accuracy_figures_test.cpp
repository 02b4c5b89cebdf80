#include "study/accuracy_figures.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <random>

#include "picture/text_box.hpp"
#include "study/small_study.hpp"

namespace gjkscope {
namespace accuracy_figures_test {

using study::Row;
using study::Study;
using study::test::small_study;

const Fonts& fonts() {
  static const Fonts loaded(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  return loaded;
}

const std::map<std::string, Figure>& figures() {
  static const std::map<std::string, Figure> all = [] {
    std::map<std::string, Figure> out;
    for (Figure& figure : accuracy_figures(small_study(), fonts())) {
      std::string name = figure.name;
      EXPECT_TRUE(out.emplace(std::move(name), std::move(figure)).second) << "names are unique";
    }
    return out;
  }();
  return all;
}

struct Written {
  std::string text;
  Rect box;
};
std::vector<Written> texts(const Picture& picture) {
  std::vector<Written> out;
  for (const Mark& mark : picture.marks) {
    const Text* text = std::get_if<Text>(&mark.shape);
    if (text == nullptr) continue;
    out.push_back({text->text, box_of(fonts(), *text)});
  }
  return out;
}

std::vector<Point> disks(const Picture& picture, const std::string& role) {
  std::vector<Point> out;
  for (const Mark& mark : picture.marks) {
    const Disk* disk = std::get_if<Disk>(&mark.shape);
    if (disk != nullptr && mark.role == role) out.push_back(disk->center);
  }
  return out;
}

bool says(const Picture& picture, const std::string& text) {
  const std::vector<Written> all = texts(picture);
  return std::any_of(all.begin(), all.end(),
                     [&](const Written& each) { return each.text == text; });
}

TEST(AccuracyFigures, ThereIsOneOfEachKind) {
  int families = 0;
  for (const auto& group : study::by_family(small_study().rows)) {
    if (group.front()->vertices > 0) continue;
    ++families;
    std::string name = group.front()->family;
    std::replace(name.begin(), name.end(), ' ', '-');
    EXPECT_TRUE(figures().contains("front-" + name)) << name;
    EXPECT_TRUE(figures().contains("iterations-" + name)) << name;
  }
  EXPECT_EQ(families, 11);
  for (const char* name :
       {"tolerance-time", "tolerance-error", "vertices", "vertices-more-digits"}) {
    EXPECT_TRUE(figures().contains(name)) << name;
  }
  EXPECT_EQ(figures().size(), 2u * 11u + 4u);
}

void expect_texts_apart(const Figure& figure, const std::string& name) {
  const std::vector<Written> all = texts(figure.picture);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Rect& a = all[i].box;
    EXPECT_GE(a.min.x(), 0.0) << name << ": " << all[i].text;
    EXPECT_GE(a.min.y(), 0.0) << name << ": " << all[i].text;
    EXPECT_LE(a.max.x(), figure.picture.width) << name << ": " << all[i].text;
    EXPECT_LE(a.max.y(), figure.picture.height) << name << ": " << all[i].text;
    for (std::size_t k = 0; k < i; ++k) {
      const Rect& b = all[k].box;
      const bool apart = a.max.x() <= b.min.x() || b.max.x() <= a.min.x() ||
                         a.max.y() <= b.min.y() || b.max.y() <= a.min.y();
      EXPECT_TRUE(apart) << name << ": " << all[i].text << " on " << all[k].text;
    }
  }
}

/// The same study on a machine that takes other times: most of them close together.
Study with_other_times(std::uint64_t seed) {
  Study out = small_study();
  std::mt19937_64 bits(seed);
  for (Row& row : out.rows) {
    const auto share = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
    const double decades = share() < 0.8 ? 0.5 * share() : 3.0 * share();
    row.ns.median = row.ns.low = row.ns.high = 100.0 * std::pow(10.0, decades);
  }
  study::mark_front(out.rows);
  return out;
}

TEST(AccuracyFigures, TextsKeepOffEachOtherAndOnThePage) {
  for (const auto& [name, figure] : figures()) expect_texts_apart(figure, name);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    for (const Figure& figure : accuracy_figures(with_other_times(seed), fonts())) {
      expect_texts_apart(figure, fmt::format("{} of times {}", figure.name, seed));
    }
  }
}

TEST(AccuracyFigures, TheFrontIsThatOfTheStudy) {
  for (const auto& group : study::by_family(small_study().rows)) {
    if (group.front()->family != "needles") continue;
    const Picture& picture = figures().at("front-needles").picture;
    std::size_t on_front = 0;
    for (const Row* row : group) {
      if (!row->on_front) continue;
      ++on_front;
      EXPECT_TRUE(says(picture, row->configuration)) << row->configuration;
    }
    EXPECT_GT(on_front, 2u);
    EXPECT_TRUE(says(picture, std::to_string(on_front))) << "they are numbered";
    EXPECT_FALSE(says(picture, std::to_string(on_front + 1)));
  }
}

TEST(AccuracyFigures, MoreIterationsNeverWidenTheBounds) {
  const Picture& picture = figures().at("iterations-random").picture;
  std::vector<Point> errors = disks(picture, "plot.first");
  ASSERT_GT(errors.size(), 4u);
  errors.pop_back();  // of the name
  for (std::size_t i = 1; i < errors.size(); ++i) {
    EXPECT_GT(errors[i].x(), errors[i - 1].x());
    EXPECT_GE(errors[i].y(), errors[i - 1].y() - 1e-9) << "down is smaller";
  }
}

TEST(AccuracyFigures, NothingMeasuredNothingDrawn) {
  EXPECT_TRUE(accuracy_figures(Study{}, fonts()).empty());
  Study untimed = small_study();
  for (Row& row : untimed.rows) row.repetitions = 0;
  EXPECT_TRUE(accuracy_figures(untimed, fonts()).empty());
}

}  // namespace accuracy_figures_test
}  // namespace gjkscope
