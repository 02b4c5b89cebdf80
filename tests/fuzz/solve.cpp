// Bytes as cases for `gjkscope solve`, in every scalar. What it answers is held to the exact truth.

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "claims.hpp"
#include "cli/commands.hpp"
#include "exact/rational.hpp"
#include "lesson/case.hpp"
#include "lesson/names.hpp"
#include "run/scalar.hpp"
#include "truth/bars.hpp"

namespace gjkscope::fuzz {
namespace {

using nlohmann::json;

// More than that only takes longer.
constexpr std::size_t kMostBytes = 4096;
constexpr std::size_t kMostVertices = 64;  // of all cases of a text

struct Solved {
  int exit_code = 0;
  std::vector<json> answers;
};

Solved solve(const std::string& text, ScalarKind scalar) {
  std::istringstream in(text);
  std::ostringstream out;
  std::ostringstream err;
  Solved solved;
  solved.exit_code = solve_command({GJKSCOPE_SOURCE_DIR, in, out, err}, {"-"}, {.scalar = scalar});
  std::istringstream lines(out.str());
  for (std::string line; std::getline(lines, line);) {
    solved.answers.push_back(json::parse(line, nullptr, false));
    claim(solved.answers.back().is_object(), "an answer is a JSON object: " + line);
  }
  return solved;
}

std::vector<ReadCase> read(std::string_view text) {
  std::vector<ReadCase> cases =
      parse_cases(text, "<stdin>", gjk::kMaxDimension, needs_of(ModelMethod::boxes));
  claim(!cases.empty(), "there is a case or a problem");
  for (const ReadCase& one : cases) {
    claim((one.value || one.in_space || one.outlines) == one.problems.empty(),
          "a case is read, or has problems");
    for (const Problem& problem : one.problems) claim_located(problem, text);
  }
  return cases;
}

/// Coordinates as numbers, or as hexadecimal texts.
template <int D>
std::string written(const CaseIn<D>& value, bool hexadecimal) {
  const auto coordinate = [&](double number) {
    return hexadecimal ? json(fmt::format("{:a}", number)) : json(number);
  };
  const auto list = [&](const std::vector<gjk::Vec<double, D>>& points) {
    json out = json::array();
    for (const gjk::Vec<double, D>& p : points) {
      json& point = out.emplace_back(json::array());
      for (const double number : p) point.push_back(coordinate(number));
    }
    return out;
  };
  return json{{"dimension", D}, {"a", list(value.a)}, {"b", list(value.b)}}.dump();
}

/// The case that a run in S sees, or nothing where a coordinate exceeds S.
template <class S, int D>
std::optional<CaseIn<D>> rounded(CaseIn<D> value) {
  for (auto* points : {&value.a, &value.b}) {
    for (gjk::Vec<double, D>& point : *points) {
      for (double& number : point) {
        if constexpr (!gjk::ScalarTraits<S>::kExact) number = static_cast<double>(S(number));
        if (!std::isfinite(number)) return std::nullopt;
      }
    }
  }
  return value;
}

template <int D>
std::array<Quad, D> point_of(const json& list) {
  std::array<Quad, D> out;
  for (std::size_t i = 0; i < D; ++i) out[i] = Quad(list[i].get<double>());
  return out;
}

void claim_answer_or_error(const json& answer) {
  const std::string text = answer.dump();
  claim(answer.at("case").is_string() && answer.at("scalar").is_string(),
        "an answer names its case and scalar: " + text);
  const bool error = answer.contains("error");
  for (const char* key : {"distance", "lower", "upper", "a", "b", "verdict", "overlap", "stop"}) {
    claim(answer.contains(key) != error,
          "an answer has either an error or all of its keys: " + text);
  }
  if (error) return;
  for (const char* key : {"distance", "lower", "upper"}) {
    claim(answer[key].is_number(), "numbers are finite: " + text);
  }
  for (const char* key : {"a", "b"}) {
    for (const json& number : answer[key]) claim(number.is_number(), "points are finite: " + text);
  }
  const double distance = answer["distance"].get<double>();
  claim(0.0 <= answer["lower"].get<double>() && answer["lower"].get<double>() <= distance &&
            distance <= answer["upper"].get<double>(),
        "0 <= lower <= distance <= upper: " + text);
  const std::string verdict = answer["verdict"].get<std::string>();
  const bool overlap = answer["overlap"].get<bool>();
  claim(verdict == "undecided" || overlap == (verdict != "separated"),
        "overlap and verdict agree: " + text);
}

/// `seen`: the case as the run in S saw it.
template <class S, int D>
void claim_true(const json& answer, const CaseIn<D>& seen) {
  const std::string text = answer.dump() + " for " + written<D>(seen, false);
  const study::Truth<D> exact = study::truth_of<D>({seen.a, seen.b});
  using Real = typename gjk::ScalarTraits<S>::Real;
  if (answer.contains("error")) {
    const std::string error = answer["error"].get<std::string>();
    const bool far = exact.distance > 0.9 * static_cast<double>(std::numeric_limits<Real>::max());
    constexpr bool kIsNarrow =
        std::is_same_v<S, Eigen::half> || (D == 3 && std::is_same_v<S, float>);
    const bool tiny = kIsNarrow && error.starts_with("underflow");
    claim(far ? error.starts_with("overflow") : tiny, "there is a reason to refuse: " + text);
    return;
  }
  claim(answer["overlap"].get<bool>() == exact.overlap, "overlap is true: " + text);
  claim(answer["stop"] != name_of(gjk::StopReason::iteration_cap), "no cap is reached: " + text);
  study::Claim<D> claimed;
  claimed.verdict = value_of<gjk::Verdict>(answer["verdict"].get<std::string>()).value();
  claimed.has_bounds = true;
  claimed.distance = Quad(answer["distance"].get<double>());
  claimed.lower = Quad(answer["lower"].get<double>());
  claimed.upper = Quad(answer["upper"].get<double>());
  claimed.x = point_of<D>(answer["a"]);
  claimed.y = point_of<D>(answer["b"]);
  claimed.unit_roundoff = static_cast<double>(gjk::ScalarTraits<Real>::unit_roundoff());
  const study::Judgement found = study::judge(claimed, {exact, exact});
  const std::string_view broken =
      study::broken_bar(found, study::errors_of(found, exact, study::unit_of<Real>(exact)),
                        std::is_same_v<Real, double> ? study::kBars : study::kFloatBars);
  claim(broken.empty(),
        "the answer is within bars, it breaks that of: " + std::string(broken) + ", " + text);
}

template <class S, int D>
void claim_answer(const json& answer, const CaseIn<D>& value, ScalarKind scalar) {
  const std::optional<CaseIn<D>> seen = rounded<S, D>(value);
  if (!seen) {
    claim(answer.contains("error"), "a coordinate that the scalar cannot hold is refused");
    return;
  }
  claim_true<S, D>(answer, *seen);
  json again = solve(written<D>(*seen, scalar == ScalarKind::double_), scalar).answers.at(0);
  again["case"] = answer["case"];
  if (answer.contains("understood")) again["understood"] = answer["understood"];
  claim(again == answer, "a case written and read back has the same answer: " + answer.dump() +
                             " and " + again.dump());
}

template <class S>
void feed(const std::string& text, const std::vector<ReadCase>& cases, ScalarKind scalar) {
  const Solved solved = solve(text, scalar);
  claim(solved.answers.size() == cases.size(), "each case has an answer");
  bool refused = false;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const json& answer = solved.answers[i];
    refused = refused || answer.contains("error");
    if (cases[i].outlines) {
      claim(answer.contains("error") != answer.contains("distance"), "outlines have an answer");
      continue;
    }
    claim_answer_or_error(answer);
    if (cases[i].value) {
      claim_answer<S, 2>(answer, *cases[i].value, scalar);
    } else if (cases[i].in_space) {
      claim_answer<S, 3>(answer, *cases[i].in_space, scalar);
    } else {
      claim(answer.contains("error"), "a case that cannot be read has no answer");
    }
  }
  claim(solved.exit_code == (refused ? kProblem : kDone), "the exit code tells of errors");
}

}  // namespace
}  // namespace gjkscope::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gjkscope;
  if (size > fuzz::kMostBytes) return 0;
  const std::string text(data, data + size);
  const std::vector<ReadCase> cases = fuzz::read(text);
  std::size_t vertices = 0;
  for (const ReadCase& read : cases) {
    if (read.value) vertices += read.value->a.size() + read.value->b.size();
    if (read.in_space) vertices += read.in_space->a.size() + read.in_space->b.size();
  }
  if (vertices > fuzz::kMostVertices) return 0;
  for (const ScalarKind kind :
       {ScalarKind::half, ScalarKind::single, ScalarKind::double_, ScalarKind::exact}) {
    with_scalar(kind, [&]<class S>(std::type_identity<S>) { fuzz::feed<S>(text, cases, kind); });
  }
  return 0;
}
