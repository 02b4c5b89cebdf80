// Bytes as logs for `gjkscope judge`: they are read and judged, or there is a problem with a place.

#include <cmath>
#include <cstdint>

#include "claims.hpp"
#include "judge/judge.hpp"

namespace {

// More than that only takes longer.
constexpr std::size_t kMostBytes = 4096;
constexpr std::size_t kMostVertices = 64;

void claim_finding(const std::optional<gjkscope::judging::Finding>& finding, int lines) {
  using gjkscope::fuzz::claim;
  if (!finding) return;
  claim(finding->line >= 1 && finding->line <= lines, "a finding has a line of the log");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gjkscope;
  if (size > kMostBytes) return 0;
  const std::string text(data, data + size);
  const judging::ReadLog read = judging::read_log(text, "log");
  fuzz::claim(read.log.has_value() == read.problems.empty(), "there is a log or a problem");
  for (const Problem& problem : read.problems) fuzz::claim_located(problem, text);
  if (!read.log || read.log->x.size() + read.log->y.size() > kMostVertices) return 0;
  const judging::Judgement judgement = judging::judge(*read.log);
  fuzz::claim(!std::isnan(judgement.distance), "there is a distance");
  fuzz::claim(judgement.overlap == (judgement.distance == 0) || judgement.distance == 0,
              "overlap has distance 0");
  fuzz::claim(!judgement.depth || judgement.depth >= 0, "a depth is not negative");
  const int lines = 1 + static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  claim_finding(judgement.wrong, lines);
  claim_finding(judgement.answer, lines);
  claim_finding(judgement.waste, lines);
  claim_finding(judgement.rounded, lines);
  return 0;
}
