// Asks every method about random pairs of models of every family and holds the answers against all
// pairs of segments in GMP's rationals; of pairs too large for that, against brute force. Exit code
// 1 when a claim is broken.

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "outlines/brute.hpp"
#include "outlines/lin_canny.hpp"
#include "outlines/pieces.hpp"
#include "outlines/sphere_tree.hpp"
#include "scenes.hpp"
#include "truth.hpp"

namespace test {
namespace {

using namespace models;

/// The outcome of the scenes of one family.
struct Row {
  long scenes = 0;
  long overlaps = 0;
  long nested = 0;  ///< Overlaps where no boundaries meet,
  long corner = 0;  ///< and where they do so in a corner of one.
  long exact = 0;   ///< Held against rationals.
  long pieces = 0;  ///< Scenes that the methods take.
  long walks = 0;
  long broken = 0;
  double error = 0.0;  ///< The error of distances, in roundings (2^-53) of the scene's size.
  std::size_t most = 0;
  std::vector<std::string> failures;  ///< The first ones.

  void claim(bool holds, std::string_view what) {
    constexpr std::size_t kKept = 3;
    if (holds) return;
    ++broken;
    if (failures.size() < kKept) failures.push_back(fmt::format("scene {}: {}", scenes, what));
  }
  /// For a family in which boxes say little: pairs apart, crossing, nested and touching.
  void claim_of_all_kinds() {
    const long few = scenes / 10;
    claim(scenes - overlaps > few, "too few pairs are apart");
    claim(overlaps - nested - corner > few / 2, "too few cross");
    claim(nested > few, "too few lie one in the other");
    claim(corner > few, "too few touch");
  }
};

/// In roundings; beyond this a claim is broken.
constexpr double kMostError = 4.0;

class Checker {
 public:
  Checker(const Scene& scene, Row& row, Scenes& random)
      : a_(model_of(scene.a)), b_(model_of(scene.b)), row_(row) {
    ++row_.scenes;
    row_.most = std::max({row_.most, a_.segments.size(), b_.segments.size()});
    truth_ = brute(a_, b_).answer;
    row_.overlaps += truth_.overlap;
    row_.nested += truth_.overlap && (truth_.on_a.index < 0 || truth_.on_b.index < 0);
    row_.corner += truth_.overlap && (truth_.on_a.is_vertex || truth_.on_b.is_vertex) &&
                   truth_.on_a.index >= 0 && truth_.on_b.index >= 0;
    check_brute();
    check_trees<Box>();
    check_trees<Circle>();
    check_spheres(random);
    check_pieces(scene);
    check_walk(scene, random);
  }

 private:
  void claim(bool holds, std::string_view what) { row_.claim(holds, what); }
  void claim_same(const Answer& answer) {
    claim(answer.overlap == truth_.overlap && answer.distance == truth_.distance,
          "answer of a tree");
    if (truth_.overlap) return;
    claim(answer.on_a == truth_.on_a && answer.on_b == truth_.on_b, "features of a tree");
  }

  void check_brute() {
    constexpr std::size_t kMostPairs = 1500;  // all of them take a hundredth of a second
    if (a_.segments.size() * b_.segments.size() > kMostPairs) return;
    ++row_.exact;
    const Truth exact = truth_of(a_, b_);
    claim(exact.overlap == truth_.overlap, "overlap by brute force");
    const double error = std::abs(truth_.distance - std::sqrt(exact.distance_sq.get_d()));
    row_.error = std::max(row_.error, error / (0x1p-53 * exact.scale));
    claim(error <= kMostError * 0x1p-53 * exact.scale, "distance by brute force");
  }

  template <class Volume>
  void check_trees() {
    const auto tree_a = build_hierarchy<Volume>(items_of(a_));
    const auto tree_b = build_hierarchy<Volume>(items_of(b_));
    SearchOptions options;
    for (const bool nearer : {false, true}) {
      options.nearer_first = nearer;
      claim_same(search<Volume>({a_, b_, tree_a, tree_b}, options).answer);
    }
    options.goal = Goal::collide;
    claim(search<Volume>({a_, b_, tree_a, tree_b}, options).answer.overlap == truth_.overlap,
          "collision of trees");
  }

  void check_spheres(Scenes& random) {
    constexpr std::size_t kMostSegments = 200;
    if (std::max(a_.segments.size(), b_.segments.size()) > kMostSegments) return;
    const double radius = random.real(0.1, 2.0);
    const auto tree_a = sphere_tree(a_, radius);
    const auto tree_b = sphere_tree(b_, radius);
    const double e = random.real(0.0, 1.0);
    const Answer answer =
        search<Circle>({a_, b_, tree_a, tree_b}, {.relative_error = e, .table = true}).answer;
    claim(answer.overlap == truth_.overlap, "overlap of sphere trees");
    claim(answer.distance <= (1.0 + e) * truth_.distance * (1.0 + 0x1p-50),
          "distance of sphere trees");
  }

  void check_pieces(const Scene& scene) {
    constexpr std::size_t kMostSegments = 300;  // ears are looked for among all corners
    if (std::max(a_.segments.size(), b_.segments.size()) > kMostSegments) return;
    for (const auto* outlines : {&scene.a, &scene.b}) {
      if (check(*outlines, Needs::simple).fault != Fault::none) return;
    }
    ++row_.pieces;
    const Answer answer = pieces_distance(a_, b_, pieces_of(a_), pieces_of(b_)).answer;
    claim(answer.overlap == truth_.overlap && answer.distance == truth_.distance,
          "answer of pieces");
  }

  void check_walk(const Scene& scene, Scenes& random) {
    for (const auto* outlines : {&scene.a, &scene.b}) {
      if (check(*outlines, Needs::convex).fault != Fault::none) return;
    }
    ++row_.walks;
    const WalkQuery query = walk_query(a_, b_);
    const RingFeature from_a{random.chance(0.5), random.among(0, query.a.size() - 1)};
    const RingFeature from_b{random.chance(0.5), random.among(0, query.b.size() - 1)};
    const WalkResult walked = lin_canny(query, from_a, from_b);
    claim(walked.stop == (truth_.overlap ? WalkStop::overlap : WalkStop::closest),
          "stop of the walk");
    claim(walked.answer.distance == truth_.distance, "distance of the walk");
    claim(walked.steps <= query.pairs(), "length of the walk");
    std::optional<Nearest> last;
    for (const WalkStep& step : trace_walk(query, from_a, from_b).steps) {
      if (step.phase != WalkPhase::closest) continue;
      if (last) claim(compare_distances(step.after.pair, *last) < 0, "fall of the walk");
      last = step.after.pair;
    }
  }

  Model a_;
  Model b_;
  Row& row_;
  Answer truth_;
};

int main_of(int argc, char** argv) {
  long count = 20'000;
  int most = 10'000;
  std::uint64_t seed = 1;
  CLI::App app("Holds distances of random models against the exact truth");
  app.add_option("--scenes", count, "Scenes over all families")->check(CLI::PositiveNumber);
  app.add_option("--most", most, "Segments of the largest models")->check(CLI::Range(24, 100'000));
  app.add_option("--seed", seed, "Seed");
  CLI11_PARSE(app, argc, argv);

  fmt::print("{:<12}{:>9}{:>10}{:>8}{:>8}{:>9}{:>9}{:>9}{:>8}{:>8}{:>8}\n", "family", "scenes",
             "overlaps", "nested", "corner", "exact", "pieces", "walks", "most", "error", "broken");
  long broken = 0;
  const auto families = static_cast<long>(kSceneFamilies.size());
  for (long family = 0; family < families; ++family) {
    Scenes scenes(seed + static_cast<std::uint64_t>(family));
    Row row;
    const long share = count / families + (family < count % families ? 1 : 0);
    for (long i = 0; i < share; ++i) {
      // One in a thousand is large: brute force looks at all pairs of segments.
      const int size = scenes.chance(0.001) ? most : 60;
      Checker(scenes.scene(kSceneFamilies[static_cast<std::size_t>(family)], size), row, scenes);
    }
    const std::string_view name = kSceneFamilies[static_cast<std::size_t>(family)];
    if (name == "needles") row.claim_of_all_kinds();
    fmt::print("{:<12}{:>9}{:>10}{:>8}{:>8}{:>9}{:>9}{:>9}{:>8}{:>8.2f}{:>8}\n", name, row.scenes,
               row.overlaps, row.nested, row.corner, row.exact, row.pieces, row.walks, row.most,
               row.error, row.broken);
    for (const std::string& failure : row.failures) fmt::print("  {}\n", failure);
    broken += row.broken;
  }
  fmt::print("{} scenes, {} claims broken\n", count, broken);
  return broken == 0 ? 0 : 1;
}

}  // namespace
}  // namespace test

int main(int argc, char** argv) { return test::main_of(argc, argv); }
