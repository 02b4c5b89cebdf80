#include "judge/judge.hpp"

#include <nlohmann/json.hpp>

#include "answers/answers.hpp"

namespace gjkscope {
namespace {

using Json = nlohmann::ordered_json;
using judging::Finding;

Json json_of(const std::optional<Finding>& finding) {
  if (!finding) return nullptr;
  Json out;
  if (finding->iteration > 0) out["iteration"] = finding->iteration;
  out["line"] = finding->line;
  out["part"] = name_of(finding->part);
  if (!finding->what.empty()) out["what"] = finding->what;
  return out;
}

}  // namespace

std::string judgement_json(const std::string& name, const judging::Judgement& judgement) {
  Json out;
  out["log"] = name;
  out["right"] = judgement.right();
  out["iterations"] = judgement.iterations;
  out["distance"] = judgement.distance;
  out["overlap"] = judgement.overlap;
  if (judgement.depth) out["depth"] = *judgement.depth;
  out["wrong"] = json_of(judgement.wrong);
  out["wrong_answer"] = json_of(judgement.answer);
  out["waste"] = json_of(judgement.waste);
  out["rounding"] = judgement.rounding;
  out["rounded"] = json_of(judgement.rounded);
  out["cut_off"] = judgement.cut_off;
  // Names may hold bytes that are not UTF-8.
  return out.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace gjkscope
