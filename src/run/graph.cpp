#include "run/graph.hpp"

namespace gjkscope {

EffectCount& EffectGraph::asked_for(std::string_view name) {
  if (!computing_.empty()) pulls_.emplace(computing_.back(), name);
  EffectCount& count = counts_[name];
  ++count.pulls;
  return count;
}

EffectGraph::Time EffectGraph::begin_computing(std::string_view name) {
  computing_.push_back(name);
  return std::chrono::steady_clock::now();
}

void EffectGraph::end_computing(EffectCount& count, Time begin) {
  computing_.pop_back();
  count.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  ++count.runs;
}

}  // namespace gjkscope
