#include "run/gjk_algorithm.hpp"

#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "lesson/names.hpp"
#include "run/run.hpp"

namespace gjkscope {
namespace {

class GjkTrace : public AlgorithmTrace {
 public:
  explicit GjkTrace(const WideTrace& trace) : stop_(name_of(trace.result.stop)) {
    for (const WideStep& step : trace.steps) {
      const bool ends = step.after.stop != gjk::StopReason::running;
      steps_.push_back({step.iteration, name_of(step.phase), ends || !step.record.dropped.empty()});
    }
  }

  [[nodiscard]] int steps() const override { return static_cast<int>(steps_.size()); }
  [[nodiscard]] StepInfo info(int step) const override { return steps_[step]; }
  [[nodiscard]] double answer(std::string_view) const override {
    return std::numeric_limits<double>::quiet_NaN();
  }
  [[nodiscard]] std::string_view stop() const override { return stop_; }
  [[nodiscard]] nlohmann::ordered_json json(const Lesson&, const PositionedRun&) const override {
    return nullptr;
  }

 private:
  std::vector<StepInfo> steps_;
  std::string_view stop_;
};

std::shared_ptr<const AlgorithmTrace> run_gjk(const Lesson&, const PositionedRun& run,
                                              const AlgorithmTrace*) {
  return std::make_shared<const GjkTrace>(run.trace);
}

constexpr std::array<std::string_view, gjk::kPhaseCount> kPhases = {
    name_of(gjk::Phase::closest), name_of(gjk::Phase::drop), name_of(gjk::Phase::direction),
    name_of(gjk::Phase::support), name_of(gjk::Phase::stop), name_of(gjk::Phase::add)};

}  // namespace

const Algorithm kGjkAlgorithm{
    .name = "gjk", .phases = kPhases, .answers = {}, .values = {}, .run = run_gjk};

}  // namespace gjkscope
