#include "judge/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>

#include "base/file.hpp"
#include "cli/input.hpp"
#include "lesson/case.hpp"
#include "lesson/save.hpp"
#include "run/run.hpp"
#include "trial/trial.hpp"

namespace gjkscope {
namespace {

using Json = nlohmann::ordered_json;
using judging::Finding;
using judging::Judgement;

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
       fmt::format("right: {} {}, distance {:.10g}{}{}", judgement.iterations,
                   judgement.iterations == 1 ? "iteration" : "iterations", judgement.distance,
                   judgement.depth ? fmt::format(", depth {:.10g}", *judgement.depth) : "",
                   judgement.rounded ? fmt::format("; rounding up to {:.2g} u L, in {}",
                                                   judgement.rounding, place_of(*judgement.rounded))
                                     : ""));
  return out;
}

Json json_of(const judging::FamilyTrial& trial) {
  Json out;
  out["dimension"] = trial.dimension;
  out["family"] = trial.family;
  out["asked"] = trial.asked;
  out["faults"] = Json::object();
  for (const auto& [name, fault] : Named<judging::Fault>::kTable)
    out["faults"][std::string(name)] = trial.faults[static_cast<std::size_t>(fault)];
  out["worst"] = trial.worst;
  if (!trial.smallest) return out;
  out["smallest"] = {{"fault", name_of(trial.smallest->fault)},
                     {"case", Json::parse(trial.smallest->text)},
                     {"answer", trial.smallest->answer},
                     {"distance", trial.smallest->distance}};
  if (trial.smallest->fault == judging::Fault::depth)
    out["smallest"]["depth"] = trial.smallest->depth;
  return out;
}

/// "distance is 0.5", or "depth is 0.25" where that is what is wrong.
std::string truth_of(const judging::FailingCase& smallest) {
  return smallest.fault == judging::Fault::depth
             ? fmt::format("depth is {:.10g}", smallest.depth)
             : fmt::format("distance is {:.10g}", smallest.distance);
}

/// The case beside its lesson.
void write_case(const std::filesystem::path& dir, const judging::FamilyTrial& trial,
                const std::string& command) {
  const judging::FailingCase& smallest = *trial.smallest;
  const std::string name = fmt::format("{}-{}d", trial.family, trial.dimension);
  Json text = Json::parse(smallest.text);
  text["name"] = name;
  text["why"] = fmt::format("{}: {} answers {}", name_of(smallest.fault), command, smallest.answer);
  text["expected_distance"] = smallest.distance;
  write_whole(dir / (name + ".json"),
              text.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n');
  if (trial.dimension == 3) return;
  const std::vector<ReadCase> read = parse_cases(smallest.text, name);
  Lesson lesson = lesson_of(*read.front().value, name, ScalarKind::double_);
  lesson.title = fmt::format("A case of the family {}", trial.family);
  lesson.prose = fmt::format("The {}.", truth_of(smallest));
  lesson.views = {{ViewKind::world, "X and Y", {}, {}},
                  {ViewKind::difference, "The difference Z = Y − X", {}, {}}};
  lesson.expect.stop =
      name_of(run_case(*read.front().value, ScalarKind::double_).trace.result.stop);
  write_whole(dir / (name + ".toml"), lesson_toml(lesson));
}

/// Programs side by side.
class Table {
 public:
  void add(const judging::FamilyTrial& trial, std::size_t program, std::string failures,
           std::string worst) {
    const auto same = [&](const Row& row) {
      return row.family == trial.family && row.dimension == trial.dimension;
    };
    auto row = std::find_if(rows_.begin(), rows_.end(), same);
    if (row == rows_.end())
      row = rows_.insert(rows_.end(), {trial.family, trial.dimension, trial.asked, {}, {}});
    row->failures[program] = std::move(failures);
    row->worst[program] = std::move(worst);
  }

  [[nodiscard]] std::string text(const std::vector<std::string>& programs) const {
    return part("failures", programs, &Row::failures) + '\n' +
           part("largest relative error", programs, &Row::worst);
  }

 private:
  /// The cells of a program by its index.
  using Cells = std::map<std::size_t, std::string>;
  struct Row {
    std::string family;
    int dimension;
    int pairs;
    Cells failures;
    Cells worst;
  };

  /// A program is called as its command is, less the folder.
  static std::string name(const std::string& program) {
    const std::size_t slash = program.substr(0, program.find(' ')).rfind('/');
    return slash == std::string::npos ? program : program.substr(slash + 1);
  }

  [[nodiscard]] std::string part(std::string_view what, const std::vector<std::string>& programs,
                                 Cells Row::*cells) const {
    std::string out = fmt::format("{}:\n\n| family | dimension | pairs |", what);
    std::string rule = "| --- | --- | --- |";
    for (const std::string& program : programs) {
      out += fmt::format(" {} |", name(program));
      rule += " --- |";
    }
    out += '\n' + rule + '\n';
    for (const Row& row : rows_) {
      out += fmt::format("| {} | {} | {} |", row.family, row.dimension, row.pairs);
      for (std::size_t k = 0; k < programs.size(); ++k) {
        const auto cell = (row.*cells).find(k);
        out += fmt::format(" {} |", cell == (row.*cells).end() ? "-" : cell->second);
      }
      out += '\n';
    }
    return out;
  }

  std::vector<Row> rows_;
};

}  // namespace

int judge_programs_command(const Environment& env, const std::vector<std::string>& programs,
                           judging::TrialOptions options, const std::filesystem::path& out_dir,
                           bool json) {
  if (!out_dir.empty()) std::filesystem::create_directories(out_dir);
  const bool alone = programs.size() == 1;
  options.reduces = alone;
  bool failed = false;
  bool unanswered = false;
  std::string cases;
  Table table;
  if (alone && !json)
    env.out << "| family | dimension | pairs | failures | largest relative error |\n"
               "| --- | --- | --- | --- | --- |\n";
  for (std::size_t k = 0; k < programs.size(); ++k) {
    options.command = programs[k];
    const std::string gave_up =
        judging::try_program(options, [&](const judging::FamilyTrial& trial) {
          failed = failed || judging::faults_text(trial) != ".";
          if (trial.smallest && !out_dir.empty()) write_case(out_dir, trial, options.command);
          if (json) {
            Json out = json_of(trial);
            if (!alone) out["program"] = options.command;
            env.out << out.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
            return;
          }
          const std::string worst = trial.worst > 0 ? fmt::format("{:.0e}", trial.worst) : ".";
          if (!alone) return table.add(trial, k, judging::faults_text(trial), worst);
          env.out << fmt::format("| {} | {} | {} | {} | {} |\n", trial.family, trial.dimension,
                                 trial.asked, judging::faults_text(trial), worst)
                  << std::flush;
          if (trial.smallest)
            cases +=
                fmt::format("{}: {}\n  the {}, the program says: {:.200}\n  {}\n", trial.family,
                            name_of(trial.smallest->fault), truth_of(*trial.smallest),
                            trial.smallest->answer, trial.smallest->text);
        });
    if (gave_up.empty()) continue;
    unanswered = true;
    env.err << (alone ? fmt::format("gjkscope: {}\n", gave_up)
                      : fmt::format("gjkscope: {}: {}\n", options.command, gave_up));
  }
  if (!alone && !json) env.out << table.text(programs);
  if (!cases.empty()) env.out << "\nThe smallest failing case of each family:\n\n" << cases;
  if (!flushed(env) || unanswered) return kCannot;
  return failed ? kProblem : kDone;
}

int judge_command(const Environment& env, const std::vector<std::string>& files, bool json) {
  int exit_code = kDone;
  for (const std::string& file : files) {
    const std::optional<std::string> text = read_text(env, file);
    const std::string name = name_of_input(file);
    const judging::ReadLog read = text ? judging::read_log(*text, name) : judging::ReadLog{};
    for (const Problem& problem : read.problems) env.err << to_string(problem) << '\n';
    if (!read.log) {
      exit_code = kCannot;
      continue;
    }
    const Judgement judgement = judging::judge(*read.log);
    if (!judgement.right() && exit_code == kDone) exit_code = kProblem;
    env.out << (json ? judgement_json(name, judgement) : text_of(name, judgement));
  }
  return flushed(env) ? exit_code : kCannot;
}

}  // namespace gjkscope
