// Practice: tasks are solved anew from what is printed, without the core; sheets; the order of
// kinds.

#include "practice/practice.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "export/work_sheet.hpp"
#include "frames/frame.hpp"
#include "lesson/load.hpp"
#include "lesson/save.hpp"
#include "picture/text_box.hpp"
#include "practice/schedule.hpp"
#include "practice/task.hpp"
#include "run/graph.hpp"
#include "subjects/subjects.hpp"
#include "temporary_folder.hpp"

namespace gjkscope {
namespace practice_test {

using Eigen::Vector3d;
using practice::Kind;
using practice::Task;

constexpr double kZero = 1e-9;

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at))
    text.replace(at, what.size(), by);
  return text;
}

std::vector<std::string> split(const std::string& text, const std::string& by) {
  std::vector<std::string> out;
  std::size_t from = 0;
  for (std::size_t at = text.find(by); at != std::string::npos; at = text.find(by, from)) {
    out.push_back(text.substr(from, at - from));
    from = at + by.size();
  }
  out.push_back(text.substr(from));
  return out;
}

/// "(−3, 2)"
Vector3d point_of(const std::string& text) {
  std::istringstream numbers(replaced(replaced(text.substr(1), "−", "-"), ",", " "));
  Vector3d out = Vector3d::Zero();
  numbers >> out.x() >> out.y() >> out.z();
  return out;
}

/// A task as somebody reads it: words and numbers of the sheet alone.
struct Read {
  std::map<std::string, Vector3d> points;  ///< By name.
  std::vector<std::string> simplex;
  std::optional<Vector3d> d;
  std::string question;
  std::vector<std::string> choices;
};

Read read(const Task& task) {
  Read out;
  out.question = task.question;
  out.choices = task.choices;
  for (const std::string& given : task.given) {
    if (given.starts_with("S = {")) {
      out.simplex = split(given.substr(5, given.size() - 6), ", ");
    } else if (given.starts_with("d = ")) {
      out.d = point_of(given.substr(4));
    } else {
      out.points[given.substr(0, given.find(' '))] = point_of(given.substr(given.find(' ') + 1));
    }
  }
  return out;
}

/// Solves a task by trying all that could be the answer.
class Solver {
 public:
  explicit Solver(const Read& task) : task_(task) {}

  std::string answer() const {
    const std::string& asked = task_.question;
    if (asked.starts_with("Which Voronoi region")) return region();
    if (asked.find("Which weights") != std::string::npos) return weights();
    if (asked.find("lies farthest along d") != std::string::npos) return farthest(d());
    if (asked.find("has no weight in P") != std::string::npos) return dropped();
    if (asked.starts_with("Will GJK stop")) return stop();
    if (asked.starts_with("Go through GJK")) return run();
    if (asked.starts_with("Which point of ")) return closest(asked.substr(15, 1) == "X");
    if (asked.ends_with("Which edge comes next?")) return next_edge();
    if (asked.starts_with("Which edge of the polygon")) return nearest_edge();
    return "no question: " + asked;
  }

  /// The direction from the closest point of S to the query.
  Vector3d d() const {
    const Simplex simplex = named(task_.simplex);
    return -foot(simplex, face(simplex));
  }

 private:
  using Simplex = std::vector<std::pair<std::string, Vector3d>>;

  bool is_query() const { return task_.points.contains("Q"); }
  const Vector3d& at(const std::string& name) const { return task_.points.at(name); }
  /// As seen from the query point: of a pair "K−C" the difference.
  Vector3d seen(const std::string& name) const {
    const std::vector<std::string> pair = split(name, "−");
    return pair.size() == 2 ? Vector3d(at(pair[0]) - at(pair[1])) : Vector3d(at(name) - at("Q"));
  }
  Simplex named(const std::vector<std::string>& names) const {
    Simplex out;
    for (const std::string& name : names) out.emplace_back(name, seen(name));
    return out;
  }
  /// Names in a text such as "ABC", or "K−C, L−D".
  static std::vector<std::string> names_in(const std::string& text) {
    if (text.find("−") != std::string::npos) return split(text, ", ");
    std::vector<std::string> out;
    for (const char letter : text) out.emplace_back(1, letter);
    return out;
  }
  std::vector<std::string> vertices(bool of_x) const {
    std::vector<std::string> out;
    for (const auto& each : task_.points) {
      if ((is_query() ? each.first == "Q" : each.first < "K") == of_x) out.push_back(each.first);
    }
    return out;
  }
  std::vector<std::string> of_difference() const {
    if (is_query()) return vertices(false);
    std::vector<std::string> out;
    for (const std::string& y : vertices(false))
      for (const std::string& x : vertices(true)) out.push_back(y + "−" + x);
    return out;
  }

  /// Weights of the projection of the origin on the affine hull of some of the points; none where
  /// they are not affinely independent.
  static std::optional<std::vector<double>> projected(const Simplex& simplex, unsigned face) {
    std::vector<Vector3d> points;
    for (std::size_t i = 0; i < simplex.size(); ++i)
      if ((face >> i & 1U) != 0) points.push_back(simplex[i].second);
    const Vector3d first = points[0];
    points.erase(points.begin());
    // A row of the identity for each point that is not there.
    Eigen::Matrix3d gram = Eigen::Matrix3d::Identity();
    Vector3d along = Vector3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      along[row] = -first.dot(points[i] - first);
      for (std::size_t j = 0; j < points.size(); ++j)
        gram(row, static_cast<Eigen::Index>(j)) = (points[i] - first).dot(points[j] - first);
    }
    if (std::abs(gram.determinant()) < kZero) return std::nullopt;
    const Vector3d solved = gram.inverse() * along;
    std::vector<double> out = {1.0 - solved.sum()};
    for (std::size_t i = 0; i < points.size(); ++i)
      out.push_back(solved[static_cast<Eigen::Index>(i)]);
    return out;
  }
  static Vector3d foot(const Simplex& simplex, unsigned face) {
    const std::vector<double> weights = *projected(simplex, face);
    Vector3d out = Vector3d::Zero();
    std::size_t next = 0;
    for (std::size_t i = 0; i < simplex.size(); ++i)
      if ((face >> i & 1U) != 0) out += weights[next++] * simplex[i].second;
    return out;
  }
  /// The smallest face that holds the closest point.
  static unsigned face(const Simplex& simplex) {
    unsigned found = 0;
    double nearest = HUGE_VAL;
    for (unsigned face = 1; face < 1U << simplex.size(); ++face) {
      const auto weights = projected(simplex, face);
      if (!weights || *std::min_element(weights->begin(), weights->end()) < kZero) continue;
      const double distance = foot(simplex, face).norm();
      if (distance > nearest - kZero) continue;
      nearest = distance;
      found = face;
    }
    return found;
  }

  std::string region() const {
    const std::string of = split(task_.question, " ")[4];
    const Simplex simplex = named(of == "the" ? task_.simplex : names_in(of));
    std::set<std::string> found;
    const unsigned face = Solver::face(simplex);
    for (std::size_t i = 0; i < simplex.size(); ++i)
      if ((face >> i & 1U) != 0) found.insert(simplex[i].first);
    for (const std::string& choice : task_.choices) {
      const std::vector<std::string> names = names_in(choice);
      if (std::set(names.begin(), names.end()) == found) return choice;
    }
    return "none of the choices";
  }

  /// In lowest terms: of all denominators up to those that small coordinates give.
  static std::string fraction(double value) {
    for (int denominator = 1;; ++denominator) {
      const double numerator = value * denominator;
      if (std::abs(numerator - std::round(numerator)) > 1e-7) continue;
      const std::string whole = std::to_string(std::lround(numerator));
      return denominator == 1 ? whole : whole + "/" + std::to_string(denominator);
    }
  }
  std::string weights() const {
    const Simplex simplex = named(vertices(false));
    const unsigned face = Solver::face(simplex);
    const std::vector<double> found = *projected(simplex, face);
    std::string out;
    std::size_t next = 0;
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      out += (i > 0 ? ", " : "") + simplex[i].first + " " +
             fraction((face >> i & 1U) != 0 ? found[next++] : 0.0);
    }
    return out;
  }

  std::string farthest(const Vector3d& along) const {
    const std::vector<std::string> all = of_difference();
    return *std::max_element(all.begin(), all.end(), [&](const auto& a, const auto& b) {
      return seen(a).dot(along) < seen(b).dot(along);
    });
  }

  std::string dropped() const {
    const Simplex simplex = named(task_.simplex);
    const unsigned face = Solver::face(simplex);
    std::vector<std::string> out;
    for (std::size_t i = 0; i < simplex.size(); ++i)
      if ((face >> i & 1U) == 0) out.push_back(simplex[i].first);
    return out.empty() ? "none" : out.size() == 1 ? out[0] : "two of them";
  }

  /// Why GJK stops with this simplex, or "no".
  std::string stops(const Simplex& simplex) const {
    const unsigned face = Solver::face(simplex);
    const Vector3d foot = Solver::foot(simplex, face);
    if (face == 7U) return is_query() ? "Q inside S" : "O inside S";
    if (foot.norm() < kZero) return "d = 0";
    const double gained = (seen(farthest(-foot)) - foot).dot(-foot);
    return gained < kZero ? "V in S" : "no";
  }
  std::string stop() const { return stops(named(task_.simplex)); }

  std::string run() const {
    Simplex simplex = named(task_.simplex);
    std::vector<std::string> found;
    while (stops(simplex) == "no" && found.size() < 20) {
      const unsigned face = Solver::face(simplex);
      const Vector3d foot = Solver::foot(simplex, face);
      for (std::size_t i = simplex.size(); i-- > 0;)
        if ((face >> i & 1U) == 0) simplex.erase(simplex.begin() + static_cast<long>(i));
      found.push_back(farthest(-foot));
      simplex.emplace_back(found.back(), seen(found.back()));
    }
    std::string out;
    for (const std::string& each : found) out += (out.empty() ? "" : ", ") + each;
    return (out.empty() ? "none" : out) + "; then " + stops(simplex);
  }

  /// The closest pair of a vertex and a side.
  std::string closest(bool of_x) const {
    std::string found;
    double nearest = HUGE_VAL;
    for (const bool vertex_of_x : {true, false}) {
      const std::vector<std::string> others = vertices(!vertex_of_x);
      for (const std::string& vertex : vertices(vertex_of_x)) {
        for (std::size_t i = 0; i < others.size(); ++i) {
          const std::string& a = others[i];
          const std::string& b = others[(i + 1) % others.size()];
          const Simplex side = {{a, at(a) - at(vertex)}, {b, at(b) - at(vertex)}};
          const unsigned face = Solver::face(side);
          const double distance = foot(side, face).norm();
          if (distance > nearest - kZero) continue;
          nearest = distance;
          const std::string on_side = face == 1U   ? a
                                      : face == 2U ? b
                                                   : std::min(a, b) + std::max(a, b);
          found = of_x == vertex_of_x ? vertex : on_side;
        }
      }
    }
    return found;
  }

  /// The edge of the first two choices that turns less from the direction to the right: "edge LM of
  /// Y", "edge DA of −X".
  std::string next_edge() const {
    std::array<double, 2> angle{};
    for (std::size_t i = 0; i < 2; ++i) {
      const std::string& choice = task_.choices[i];
      const Vector3d difference = at(choice.substr(6, 1)) - at(choice.substr(5, 1));
      const double sign = choice.ends_with(" of −X") ? -1.0 : 1.0;
      angle[i] = std::atan2(sign * difference.y(), sign * difference.x());
      if (angle[i] < -kZero) angle[i] += 2.0 * std::numbers::pi;
    }
    if (std::abs(angle[0] - angle[1]) < kZero) return task_.choices[2];
    return task_.choices[angle[0] < angle[1] ? 0 : 1];
  }

  /// For choices such as "K−A to L−C".
  std::string nearest_edge() const {
    return *std::min_element(task_.choices.begin(), task_.choices.end(),
                             [&](const auto& a, const auto& b) {
                               const Simplex of_a = named(split(a, " to "));
                               const Simplex of_b = named(split(b, " to "));
                               return foot(of_a, face(of_a)).norm() < foot(of_b, face(of_b)).norm();
                             });
  }

  const Read& task_;
};

double size_of(const Read& task) {
  double size = 0.0;
  for (const auto& a : task.points) {
    for (const auto& b : task.points) {
      const bool is_same_shape = (a.first < "K") == (b.first < "K");
      if (a.first != "Q" && b.first != "Q" && is_same_shape)
        size = std::max(size, (a.second - b.second).norm());
    }
  }
  return size;
}

/// The point that can be moved so little that the answer changes, or nothing.
std::string near_tie(Read task, const std::string& answer, double margin, int dimension) {
  const double reach = margin * size_of(task);
  for (auto& [name, point] : task.points) {
    const Vector3d before = point;
    for (int i = 0; i < 8; ++i) {
      const double angle = i * std::numbers::pi / 4.0;
      Vector3d by(std::cos(angle), std::sin(angle), 0.0);
      if (dimension == 3 && i % 2 == 1)
        by = Vector3d(0.6 * by.x(), 0.6 * by.x(), by.y()).normalized();
      point = before + reach * by;
      if (Solver(task).answer() != answer) return name;
    }
    point = before;
  }
  return {};
}

class TenThousandTasks : public ::testing::TestWithParam<int> {};

TEST_P(TenThousandTasks, AreSolvedFromWhatIsPrinted) {
#ifdef NDEBUG
  constexpr int kTasks = 10'000;
#else
  constexpr int kTasks = 1'000;
#endif
  int kinds = 0;
  for (const int each : practice::chapters_with_practice())
    kinds += static_cast<int>(practice::kinds_of(each).size());
  const int of_kind = (kTasks + kinds - 1) / kinds;
  const int chapter = GetParam();
  for (const Kind& kind : practice::kinds_of(chapter)) {
    std::set<std::string> answers;
    for (int seed = 0; seed < of_kind; ++seed) {
      const Task task = practice::make_task(kind, static_cast<std::uint64_t>(seed));
      const Read printed = read(task);
      const Solver solver(printed);
      std::ostringstream where;
      where << "chapter " << chapter << ", " << kind.name << ", seed " << seed << ": "
            << task.question;
      for (const std::string& given : task.given) where << "  " << given;
      ASSERT_EQ(solver.answer(), task.answer) << where.str();
      if (printed.d) {
        EXPECT_LT((printed.d->normalized() - solver.d().normalized()).norm(), 1e-9) << where.str();
      }
      if (!task.choices.empty()) {
        EXPECT_EQ(std::count(task.choices.begin(), task.choices.end(), task.answer), 1);
      }
      if (!kind.is_tie && kind.on_paper != practice::OnPaper::weights) {
        const int dimension = task.lesson.dimension;
        EXPECT_EQ(near_tie(printed, task.answer, practice::margin_of(kind, dimension), dimension),
                  "")
            << where.str();
      }
      answers.insert(task.answer);
    }
    // A kind whose every task had one answer would be one to remember. These have but one.
    const std::set<std::string> kOfOneAnswer = {
        "region of the edge",           "inside",         "two vertices dropped", "the run goes on",
        "stop: support point repeated", "stop: Q inside", "stop: Q at a vertex",  "parallel edges"};
    EXPECT_EQ(answers.size() == 1, kOfOneAnswer.contains(std::string(kind.name))) << kind.name;
  }
}

INSTANTIATE_TEST_SUITE_P(OfChapter, TenThousandTasks,
                         ::testing::ValuesIn(practice::chapters_with_practice()),
                         ::testing::PrintToStringParamName());

TEST(Tasks, FollowFromTheSeed) {
  for (const int chapter : practice::chapters_with_practice()) {
    const std::vector<Task> first = practice::make_tasks(chapter, 4, 7);
    const std::vector<Task> again = practice::make_tasks(chapter, 4, 7);
    const std::vector<Task> other = practice::make_tasks(chapter, 4, 8);
    bool differs = false;
    for (std::size_t i = 0; i < first.size(); ++i) {
      EXPECT_TRUE(first[i].lesson == again[i].lesson);
      EXPECT_EQ(first[i].answer, again[i].answer);
      differs = differs || first[i].given != other[i].given;
    }
    EXPECT_TRUE(differs) << chapter;
  }
  EXPECT_TRUE(practice::kinds_of(6).empty());
}

TEST(Tasks, AreLessonsThatAFileCouldHold) {
  for (const int chapter : practice::chapters_with_practice()) {
    for (const Kind& kind : practice::kinds_of(chapter)) {
      const Task task = practice::make_task(kind, 1);
      const LoadedLesson loaded =
          parse_lesson(lesson_toml(task.lesson), "practice.toml", vocabulary());
      EXPECT_EQ(to_string(loaded.problems), "") << chapter << ", " << kind.name;
      ASSERT_TRUE(loaded.lesson);
      const LessonRun run = run_lesson(*loaded.lesson);
      EXPECT_EQ(to_string(check_expectation(run)), "") << chapter << ", " << kind.name;
      EXPECT_GE(run.frames[static_cast<std::size_t>(task.telling)].step, 0);
    }
  }
}

TEST(Tasks, HaveEveryKindOnceBeforeAnyComesAgain) {
  const std::size_t kinds = practice::kinds_of(1).size();
  std::multiset<std::string_view> names;
  for (const Task& task : practice::make_tasks(1, static_cast<int>(2 * kinds), 3)) {
    names.insert(task.kind->name);
    if (names.size() <= kinds) {
      EXPECT_EQ(names.count(task.kind->name), 1U);
    }
  }
  for (const Kind& kind : practice::kinds_of(1)) EXPECT_EQ(names.count(kind.name), 2U);
}

const std::filesystem::path kAssets = std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets";

TEST(WorkSheet, HasAllThatIsGivenAndNoTextIsCutOrCovered) {
  const Fonts fonts(kAssets / "fonts.toml");
  for (const int chapter : practice::chapters_with_practice()) {
    for (const Paper paper : {Paper::a4, Paper::letter}) {
      const int count = static_cast<int>(practice::kinds_of(chapter).size());
      const WorkSheet sheet{chapter, "Title", 5, practice::make_tasks(chapter, count, 5)};
      const std::vector<Picture> pages = work_sheet_pages(sheet, fonts, paper);
      ASSERT_EQ(pages.size(), static_cast<std::size_t>(2 * ((count + 5) / 6)));
      std::size_t next = 0;
      for (std::size_t page = 0; page < pages.size(); ++page) {
        std::vector<Rect> words;
        std::multiset<std::string> texts;
        for (const Mark& mark : pages[page].marks) {
          const Text* text = std::get_if<Text>(&mark.shape);
          if (text == nullptr) continue;
          texts.insert(text->text);
          const Rect box = box_of(fonts, *text);
          EXPECT_GE(box.min.x(), 0.0) << text->text;
          EXPECT_LE(box.max.x(), pages[page].width - 74.0) << text->text;
          EXPECT_LE(box.max.y(), pages[page].height - 74.0) << text->text;
          if (mark.role != "body" && mark.role != "strong" && mark.role != "body.muted") continue;
          for (const Rect& other : words) EXPECT_FALSE(overlap(box, other)) << text->text;
          words.push_back(box);
        }
        for (const Rect& view : pages[page].clips)
          for (const Rect& box : words) EXPECT_FALSE(overlap(box, view)) << chapter;
        if (page >= pages.size() / 2) continue;
        for (std::size_t i = 0; i < 6 && next < sheet.tasks.size(); ++i, ++next) {
          for (const std::string& given : sheet.tasks[next].given)
            EXPECT_TRUE(texts.contains(given)) << given;
          for (const std::string& choice : sheet.tasks[next].choices)
            EXPECT_TRUE(texts.contains(choice)) << choice;
          EXPECT_FALSE(texts.contains(sheet.tasks[next].reason));
        }
      }
    }
  }
}

TEST(WorkSheet, IsTheSameFileForTheSameSeed) {
  const test::TemporaryFolder folder;
  const auto written = [&](std::uint64_t seed) {
    const std::filesystem::path file = folder.path() / "sheet.pdf";
    write_work_sheet(3, 2, seed, {.file = file, .assets_dir = kAssets, .force = true});
    return read_whole(file);
  };
  const std::string first = written(7);
  EXPECT_EQ(first.substr(0, 5), "%PDF-");
  EXPECT_TRUE(first == written(7));
  EXPECT_FALSE(first == written(8));
}

/// The kinds of the next tasks, whose answers are wrong at `wrong`.
std::string order(int kinds, int tasks, const std::set<int>& wrong) {
  practice::Schedule schedule(kinds);
  std::string out;
  for (int i = 0; i < tasks; ++i) {
    out += static_cast<char>('a' + schedule.kind());
    schedule.answer(!wrong.contains(i));
  }
  return out;
}

TEST(Practice, GoesOnWhereItWasLeft) {
  for (const int chapter : practice::chapters_with_practice()) {
    const std::vector<bool> answers = {true, false, true, false, false};
    practice::Practice practice(chapter, 7);
    for (const bool is_right : answers) practice.answer(is_right);
    const practice::Practice again(chapter, 7, answers);
    EXPECT_TRUE(practice.task().lesson == again.task().lesson) << chapter;
    EXPECT_EQ(practice.task().answer, again.task().answer);
    EXPECT_EQ(again.answers(), answers);
    EXPECT_EQ(2, again.right());
    EXPECT_EQ(practice.repeating(), again.repeating());
  }
}

TEST(Practice, ChoicesHaveTheirPlacesInAViewThatTheTaskShows) {
  for (const int chapter : practice::chapters_with_practice()) {
    for (const Kind& kind : practice::kinds_of(chapter)) {
      const LessonRun run = run_lesson(practice::make_task(kind, 1).lesson);
      EffectGraph effects(run);
      for (const FrameText& text : lesson_texts(run, effects)) {
        // A pair is pointed at by its vertices.
        if (!text.question || !text.question->pair.empty()) continue;
        for (const std::optional<Spot>& spot : text.question->spots)
          EXPECT_TRUE(!spot || spot->view == kind.view) << chapter << ' ' << kind.name;
      }
    }
  }
}

TEST(Schedule, GoesThroughAllKindsAgainAndAgain) { EXPECT_EQ(order(4, 9, {}), "abcdabcda"); }

TEST(Schedule, AWrongKindComesAgainAfterOneThreeAndSevenOthers) {
  const std::string kinds = order(6, 30, {1});
  // b, one other, b, three others, b, seven others, b.
  EXPECT_EQ(kinds.substr(0, 16), "abcbdefbacdefacb");
  practice::Schedule schedule(6);
  for (int i = 0; i < 16; ++i) {
    EXPECT_EQ(schedule.repeating(), i > 1 ? 1 : 0) << i;
    schedule.answer(i != 1);
  }
  EXPECT_EQ(schedule.repeating(), 0);
}

TEST(Schedule, AKindThatIsWrongAgainBeginsAnew) {
  EXPECT_EQ(order(6, 9, {1, 3}).substr(0, 6), "abcbdb");
}

TEST(Schedule, AsksSomethingElseInBetweenWhateverIsWrong) {
  for (int kinds = 2; kinds <= 8; ++kinds) {
    std::set<int> all;
    for (int i = 0; i < 60; ++i) all.insert(i);
    const std::string asked = order(kinds, 60, all);
    for (std::size_t i = 1; i < asked.size(); ++i) EXPECT_NE(asked[i], asked[i - 1]) << asked;
  }
}

}  // namespace practice_test
}  // namespace gjkscope
