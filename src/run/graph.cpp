#include "run/graph.hpp"

namespace gjkscope {

EffectCount& EffectGraph::asked_for(std::string_view name) {
  EffectGraph& in = counts_in_;
  if (!in.computing_.empty()) in.pulls_.emplace(in.computing_.back(), name);
  EffectCount& count = in.counts_[name];
  ++count.pulls;
  return count;
}

EffectGraph::Time EffectGraph::begin_computing(std::string_view name) {
  counts_in_.computing_.push_back(name);
  return std::chrono::steady_clock::now();
}

void EffectGraph::end_computing(EffectCount& count, Time begin) {
  counts_in_.computing_.pop_back();
  count.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  ++count.runs;
}

}  // namespace gjkscope
