#pragma once
// Sweeps over many pairs, on several threads.

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

namespace test {

/// How much of a job to do at once.
struct Piece {
  std::uint64_t seed = 0;
  long first = 0;  ///< Index of its first pair in the job.
  long pairs = 0;
};

/// Shares `pairs` among the jobs and adds what `work(job, piece)` finds to `job.rows`. Each piece
/// has a seed of its own, so that the number of threads changes nothing.
template <class Job, class Work>
void in_pieces(std::vector<Job>& jobs, long pairs, unsigned threads, std::uint64_t seed,
               const Work& work) {
  constexpr long kPiece = 2000;
  const long job_count = static_cast<long>(jobs.size());
  const long each = (pairs + job_count - 1) / job_count;
  const long pieces = (each + kPiece - 1) / kPiece;
  std::atomic<long> next = 0;
  std::mutex merging;
  const auto take_pieces = [&] {
    for (long i = next++; i < pieces * job_count; i = next++) {
      Job& job = jobs[static_cast<std::size_t>(i % job_count)];
      const long first = i / job_count * kPiece;
      const auto rows = work(job, Piece{seed * 1000003 + static_cast<std::uint64_t>(i), first,
                                        std::min(kPiece, each - first)});
      const std::scoped_lock lock(merging);
      for (std::size_t mode = 0; mode < rows.size(); ++mode) job.rows[mode].add(rows[mode]);
    }
  };
  std::vector<std::thread> others;
  for (unsigned i = 1; i < threads; ++i) others.emplace_back(take_pieces);
  take_pieces();
  for (std::thread& other : others) other.join();
}

}  // namespace test
