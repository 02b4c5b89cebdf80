#include "judge/judge.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "cli/input.hpp"

namespace gjkscope {
namespace {

using Json = nlohmann::ordered_json;
using judging::Finding;
using judging::Judgement;

Json json_of(const std::optional<Finding>& finding) {
  if (!finding) return nullptr;
  Json out;
  if (finding->iteration > 0) out["iteration"] = finding->iteration;
  out["line"] = finding->line;
  out["part"] = name_of(finding->part);
  if (!finding->what.empty()) out["what"] = finding->what;
  return out;
}

Json json_of(const std::string& name, const Judgement& judgement) {
  Json out;
  out["log"] = name;
  out["right"] = judgement.right();
  out["iterations"] = judgement.iterations;
  out["distance"] = judgement.distance;
  out["overlap"] = judgement.overlap;
  out["wrong"] = json_of(judgement.wrong);
  out["wrong_answer"] = json_of(judgement.answer);
  out["waste"] = json_of(judgement.waste);
  out["rounding"] = judgement.rounding;
  out["rounded"] = json_of(judgement.rounded);
  out["cut_off"] = judgement.cut_off;
  return out;
}

std::string place_of(const Finding& finding) {
  return fmt::format("{} of iteration {}", name_of(finding.part), finding.iteration);
}

std::string text_of(const std::string& name, const Judgement& judgement) {
  std::string out;
  const auto line = [&](int at, const std::string& text) {
    out += fmt::format("{}{}: {}\n", name, at > 0 ? fmt::format(":{}", at) : "", text);
  };
  if (judgement.cut_off) line(0, "the last line is cut off, and left out");
  if (judgement.wrong)
    line(judgement.wrong->line,
         fmt::format("wrong: {}: {}", place_of(*judgement.wrong), judgement.wrong->what));
  if (judgement.answer)
    line(judgement.answer->line, fmt::format("wrong: answer: {}", judgement.answer->what));
  if (judgement.waste)
    line(judgement.waste->line,
         fmt::format("waste: {}: {}", place_of(*judgement.waste), judgement.waste->what));
  if (!judgement.right()) return out;
  line(0,
       fmt::format("right: {} {}, distance {:.10g}{}", judgement.iterations,
                   judgement.iterations == 1 ? "iteration" : "iterations", judgement.distance,
                   judgement.rounded ? fmt::format("; rounding up to {:.2g} u L, in {}",
                                                   judgement.rounding, place_of(*judgement.rounded))
                                     : ""));
  return out;
}

}  // namespace

int judge_command(const Environment& env, const std::vector<std::string>& files, bool json) {
  int exit_code = kDone;
  for (const std::string& file : files) {
    const std::optional<std::string> text = read_text(env, file);
    const std::string name = file == "-" ? "<stdin>" : file;
    const judging::ReadLog read = text ? judging::read_log(*text, name) : judging::ReadLog{};
    for (const Problem& problem : read.problems) env.err << to_string(problem) << '\n';
    if (!read.log) {
      exit_code = kCannot;
      continue;
    }
    const Judgement judgement = judging::judge(*read.log);
    if (!judgement.right() && exit_code == kDone) exit_code = kProblem;
    // Names may hold bytes that are not UTF-8.
    if (json)
      env.out << json_of(name, judgement).dump(-1, ' ', false, Json::error_handler_t::replace)
              << '\n';
    else
      env.out << text_of(name, judgement);
  }
  return flushed(env) ? exit_code : kCannot;
}

}  // namespace gjkscope
