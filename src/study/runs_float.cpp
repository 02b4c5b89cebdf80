#include "gjk/batch.hpp"
#include "study/runs.hpp"

namespace gjkscope::study {
namespace {

Asked ask_batch(const Family& family) {
  struct Packed {
    gjk::Batch batch;
    std::vector<gjk::BatchResult> results;
  };
  const detail::Kept<float> kept(family.pairs);
  const auto packed = std::make_shared<Packed>();
  Asked out;
  for (const gjk::Query<float, 2>& query : kept.queries) packed->batch.add(query);
  packed->results.resize(kept.pairs.size());
  packed->batch.distance(packed->results);
  for (std::size_t i = 0; i < kept.pairs.size(); ++i) {
    out.kept.push_back(families::converted<double>(kept.pairs[i]));
    out.answers.push_back(detail::answer_of(packed->results[i]));
    out.answers.back().iterations = -1;
  }
  out.contestant.sweep = [packed] {
    packed->batch.distance(packed->results);
    double sum = 0.0;
    for (const gjk::BatchResult& result : packed->results) {
      keep(result);
      sum += static_cast<double>(result.distance);
    }
    return sum;
  };
  return out;
}

}  // namespace

Asked ask_float(const Configuration& configuration, const Family& family) {
  switch (configuration.arithmetic) {
    case Arithmetic::batch:
      return ask_batch(family);
    case Arithmetic::single_in_double:
      return detail::ask_in<double, float>(configuration, family);
    default:
      return detail::ask_in<float, float>(configuration, family);
  }
}

}  // namespace gjkscope::study
