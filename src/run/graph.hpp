#pragma once
// Effects: what is computed beyond the query because a visible mark asks for it.
//
// An effect is a type E with
//   static constexpr std::string_view kName;     "minkowski-hull"
//   static constexpr std::string_view kNeeds;    "minkowski-cloud": what it pulls itself
//   using Value = ...;
//   static EffectKey key(const LessonRun&, const Frame&);    equal keys share one value
//   static Value compute(EffectGraph&, const LessonRun&, const Frame&);
//
// The graph is pulled: `get<E>(frame)` computes the value when it is first asked for, and never
// otherwise.

#include <array>
#include <chrono>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "run/run.hpp"

namespace gjkscope {

/// The key of a value: nothing (-1), or the run, the step, a part of the step that it depends on.
using EffectKey = std::array<int, 3>;

struct EffectCount {
  long pulls = 0;        ///< How often a mark or another effect asked.
  long runs = 0;         ///< How often it was computed.
  double seconds = 0.0;  ///< Spent computing, what it pulled itself included.
};

class EffectGraph {
 public:
  explicit EffectGraph(const LessonRun& run) : run_(run) {}
  /// The effects of a run within another one, whose graph counts for both.
  EffectGraph(const LessonRun& run, EffectGraph& counts) : run_(run), counts_in_(counts) {}
  EffectGraph(const EffectGraph&) = delete;
  EffectGraph& operator=(const EffectGraph&) = delete;

  template <class E>
  const typename E::Value& get(const Frame& frame) {
    EffectCount& count = asked_for(E::kName);
    std::unique_ptr<Values>& kept = values_[E::kName];
    if (!kept) kept = std::make_unique<ValuesOf<E>>();
    auto& values = dynamic_cast<ValuesOf<E>&>(*kept).by_key;
    const EffectKey key = E::key(run_, frame);
    const auto found = values.find(key);
    if (found != values.end()) return found->second;
    const Time begin = begin_computing(E::kName);
    typename E::Value value = E::compute(*this, run_, frame);
    end_computing(count, begin);
    return values.emplace(key, std::move(value)).first->second;
  }

  /// Values of E that stand for this run as well: E::is_same(that run, this run).
  template <class E>
  void take_over(const EffectGraph& from) {
    const auto values = from.values_.find(E::kName);
    if (values != from.values_.end() && E::is_same(from.run_, run_))
      values_[E::kName] =
          std::make_unique<ValuesOf<E>>(dynamic_cast<ValuesOf<E>&>(*values->second));
  }

  [[nodiscard]] EffectCount count(std::string_view name) const {
    const auto found = counts_.find(name);
    return found == counts_.end() ? EffectCount{} : found->second;
  }

  /// Names of two effects: the first has pulled the second.
  [[nodiscard]] const std::set<std::pair<std::string_view, std::string_view>>& pulls() const {
    return pulls_;
  }

 private:
  struct Values {
    virtual ~Values() = default;
  };
  template <class E>
  struct ValuesOf final : Values {
    std::map<EffectKey, typename E::Value> by_key;
  };

  using Time = std::chrono::steady_clock::time_point;
  EffectCount& asked_for(std::string_view name);
  Time begin_computing(std::string_view name);
  void end_computing(EffectCount& count, Time begin);

  const LessonRun& run_;
  EffectGraph& counts_in_ = *this;
  std::map<std::string_view, std::unique_ptr<Values>> values_;
  std::map<std::string_view, EffectCount> counts_;
  std::vector<std::string_view> computing_;  ///< The one being computed last.
  std::set<std::pair<std::string_view, std::string_view>> pulls_;
};

}  // namespace gjkscope
