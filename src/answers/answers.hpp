#pragma once
// Cases and logs, answered as `gjkscope solve`, `trace` and `judge` print it: for the command, and
// for who has no command.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "judge/judge.hpp"
#include "lesson/case.hpp"
#include "lesson/names.hpp"
#include "outlines/outline.hpp"
#include "run/traced.hpp"

namespace gjkscope {

/// How the distance of general models is found.
enum class ModelMethod : std::uint8_t { brute, pieces, boxes, circles, lin_canny };
template <>
struct Named<ModelMethod> {
  static constexpr std::array<std::pair<std::string_view, ModelMethod>, 5> kTable = {
      {{"brute", ModelMethod::brute},
       {"pieces", ModelMethod::pieces},
       {"boxes", ModelMethod::boxes},
       {"circles", ModelMethod::circles},
       {"lin-canny", ModelMethod::lin_canny}}};
};

/// How cases are answered.
struct CaseOptions {
  ScalarKind scalar = ScalarKind::double_;  ///< For point sets.
  ModelMethod method = ModelMethod::boxes;  ///< For outlines.
};
/// The requirements of a method on outlines.
[[nodiscard]] models::Needs needs_of(ModelMethod method);
/// Those of its trace.
[[nodiscard]] models::Needs needs_of_trace(ModelMethod method);

struct Printed {
  std::vector<std::string> out;  ///< An answer each.
  std::string err;               ///< Problems, one a line; empty where all is answered.
};

/// One JSON object for each case.
[[nodiscard]] Printed print_answers(const std::vector<ReadCase>& cases, const CaseOptions& options);

/// A trace, as JSON or as text.
[[nodiscard]] Printed print_trace(const Traced& traced, bool json);
/// One for each case that could be read. Brute force has none.
[[nodiscard]] Printed print_traces(const std::vector<ReadCase>& cases, const CaseOptions& options,
                                   bool json);

/// The judgement of the log `name` as a JSON object.
[[nodiscard]] std::string judgement_json(const std::string& name,
                                         const judging::Judgement& judgement);

}  // namespace gjkscope
