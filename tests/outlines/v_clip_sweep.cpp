// Walks on the features of random pairs of bodies in space, of every family, from random features,
// held to GJK's exact verdict and to rational numbers. Exit code 1 when a claim is broken.

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "in_pieces.hpp"
#include "v_clip_truth.hpp"

namespace test {
namespace {

struct Job {
  int family = 0;
  std::array<v_clip_truth::Row, 1> rows = {};
};

int main_of(int argc, char** argv) {
  long pairs = 20'000;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  std::uint64_t seed = 1;
  CLI::App app("Holds walks on features in space against the exact truth");
  app.add_option("--pairs", pairs, "Pairs over all families")->check(CLI::PositiveNumber);
  app.add_option("--threads", threads, "Threads; they do not change the answer")
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", seed, "Seed");
  CLI11_PARSE(app, argc, argv);

  std::vector<Job> jobs;
  for (int i = 0; i < v_clip_truth::kFamilies; ++i) jobs.push_back({i});
  in_pieces(jobs, pairs, threads, seed, [](const Job& job, const Piece& piece) {
    return std::array{v_clip_truth::check_family(job.family, piece.seed, piece.pairs)};
  });

  fmt::print("{:<15}{:>9}{:>10}{:>9}{:>9}{:>9}{:>9}{:>8}{:>8}{:>8}\n", "family", "pairs",
             "overlaps", "v-v", "v-e", "v-f", "e-e", "longest", "error", "broken");
  v_clip_truth::Row all;
  const auto print = [](const std::string& name, const v_clip_truth::Row& row) {
    fmt::print("{:<15}{:>9}{:>10}{:>9}{:>9}{:>9}{:>9}{:>8}{:>8.2f}{:>8}\n", name, row.pairs,
               row.overlaps, row.kinds[0], row.kinds[1], row.kinds[2], row.kinds[3], row.most_pairs,
               row.error, row.broken);
    for (const std::string& failure : row.failures) fmt::print("  {}\n", failure);
  };
  for (const Job& job : jobs) {
    print(v_clip_truth::family_name(job.family), job.rows[0]);
    all.add(job.rows[0]);
  }
  all.failures.clear();
  print("all", all);
  return all.broken == 0 ? 0 : 1;
}

}  // namespace
}  // namespace test

int main(int argc, char** argv) { return test::main_of(argc, argv); }
