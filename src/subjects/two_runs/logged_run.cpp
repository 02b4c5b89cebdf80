#include "subjects/two_runs/logged_run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gjk/regions.hpp"

namespace gjkscope {
namespace {

using gjk::Phase;

/// Numbers of a log may be anything: these can be drawn, and their squares be computed.
bool is_drawn(const Eigen::Vector3d& v) {
  constexpr double kMost = 1e150;
  return v.allFinite() && v.cwiseAbs().maxCoeff() < kMost;
}

/// Writes the steps of a log, one iteration after the other.
class LoggedRun {
 public:
  LoggedRun(const judging::Log& log, const judging::Judgement& judgement, gjk::StopReason stop)
      : log_(log), steps_(judgement.steps), stop_(stop) {}

  WideTrace trace() {
    const std::size_t count = log_.iterations.size();
    for (std::size_t i = 0; i < count && begin(i); ++i) {
      closest(log_.iterations[i]);
      drop();
      search(i);
      state_.stop = i + 1 == count ? stop_ : gjk::StopReason::running;
      add(Phase::stop);
    }
    end();
    return std::move(out_);
  }

 private:
  using Pairs = std::vector<gjk::VertexPair>;

  [[nodiscard]] WideVertex vertex(gjk::VertexPair pair) const {
    return {log_.y[pair.y] - log_.x[pair.x], pair};
  }

  void add(Phase phase) {
    state_.previous = phase;
    out_.steps.push_back({phase, state_.iteration, state_, std::exchange(record_, {}), {}});
  }

  /// The simplex of an iteration; false where it is not known.
  bool begin(std::size_t i) {
    const judging::Iteration& it = log_.iterations[i];
    Pairs pairs = it.simplex;
    if (pairs.empty() && i < steps_.size()) pairs = steps_[i].simplex;
    if (pairs.empty() || pairs.size() > 3) return false;
    state_.iteration = static_cast<int>(i) + 1;
    state_.simplex.count = static_cast<int>(pairs.size());
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      state_.simplex.vertices[k] = vertex(pairs[k]);
      if (it.points.size() == pairs.size() && is_drawn(it.points[k]))
        state_.simplex.vertices[k].w = it.points[k];
      state_.simplex.weights[k] = 0.0;
    }
    state_.simplex.weights[0] = 1.0;
    if (i == 0) {
      out_.initial = state_;
    } else {
      add(Phase::add);
      out_.steps.back().iteration = static_cast<int>(i);
    }
    return true;
  }

  void closest(const judging::Iteration& it) {
    WideSimplex& simplex = state_.simplex;
    gjk::State<double, 3> nearest;
    nearest.simplex = simplex;
    gjk::NoRecord none;
    gjk::find_closest_point(nearest, gjk::Options{}, none);
    const auto size = static_cast<std::size_t>(simplex.count);
    const bool has_kept = !it.kept.empty() && it.kept.size() <= size;
    state_.region = has_kept ? 0 : nearest.region;
    for (int i = 0; i < simplex.count && has_kept; ++i) {
      if (std::find(it.kept.begin(), it.kept.end(), simplex.vertices[i].pair) != it.kept.end())
        state_.region |= gjk::Face(1U << static_cast<unsigned>(i));
    }
    const bool are_numbers = std::all_of(it.weights.begin(), it.weights.end(),
                                         [](double weight) { return std::isfinite(weight); });
    const bool of_kept = are_numbers && has_kept && it.weights.size() == it.kept.size();
    const bool of_all = are_numbers && !of_kept && it.weights.size() == size;
    state_.p.setZero();
    for (int i = 0; i < simplex.count; ++i) {
      const auto kept = std::find(it.kept.begin(), it.kept.end(), simplex.vertices[i].pair);
      const auto at = static_cast<std::size_t>(kept - it.kept.begin());
      simplex.weights[i] = of_all    ? it.weights[i]
                           : of_kept ? (at < it.kept.size() ? it.weights[at] : 0.0)
                                     : nearest.simplex.weights[i];
      state_.p += simplex.weights[i] * simplex.vertices[i].w;
    }
    if (it.closest) state_.p = *it.closest;
    if (!is_drawn(state_.p)) state_.p = nearest.p;
    state_.p_sq = state_.p.squaredNorm();
    add(Phase::closest);
  }

  void drop() {
    WideSimplex kept;
    for (int i = 0; i < state_.simplex.count; ++i) {
      if (!gjk::contains(state_.region, i)) {
        record_.dropped.push_back(state_.simplex.vertices[i]);
        continue;
      }
      kept.vertices[kept.count] = state_.simplex.vertices[i];
      kept.weights[kept.count++] = state_.simplex.weights[i];
    }
    state_.simplex = kept;
    state_.region = kept.all();
    add(Phase::drop);
  }

  void search(std::size_t i) {
    const judging::Iteration& it = log_.iterations[i];
    state_.d.setZero();
    if (!it.direction || !is_drawn(*it.direction)) return;
    state_.d = *it.direction;
    add(Phase::direction);
    if (!(state_.d.norm() > 0.0)) return;
    std::optional<gjk::VertexPair> support = it.support;
    if (!support && i < steps_.size()) support = steps_[i].support;
    if (!support) return;
    state_.support = vertex(*support);
    if (it.support_point && is_drawn(*it.support_point)) state_.support.w = *it.support_point;
    state_.support_value = state_.d.dot(state_.support.w);
    add(Phase::support);
  }

  void end() {
    WideResult& result = out_.result;
    result.iterations = state_.iteration;
    result.simplex = state_.simplex;
    result.stop = stop_;
    const std::optional<judging::Answer>& answer = log_.answer;
    result.distance = answer && answer->distance ? *answer->distance : std::sqrt(state_.p_sq);
    result.distance_sq = result.distance * result.distance;
    for (int i = 0; i < state_.simplex.count; ++i) {
      const gjk::VertexPair pair = state_.simplex.vertices[i].pair;
      result.x += state_.simplex.weights[i] * log_.x[pair.x];
      result.y += state_.simplex.weights[i] * log_.y[pair.y];
    }
  }

  const judging::Log& log_;
  const std::vector<judging::Step>& steps_;
  gjk::StopReason stop_;
  WideTrace out_;
  WideState state_;
  WideRecord record_;
};

}  // namespace

PositionedRun logged_run(const judging::Log& log, const judging::Judgement& judgement,
                         const PositionedRun& like, gjk::StopReason stop) {
  PositionedRun run{like.bodies, like.time, 0, LoggedRun(log, judgement, stop).trace(), {}};
  for (const WideStep& step : run.trace.steps)
    run.bounds.push_back({0.0, std::sqrt(step.after.p_sq)});
  return run;
}

}  // namespace gjkscope
