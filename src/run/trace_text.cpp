#include "run/trace_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "lesson/vocabulary.hpp"
#include "run/fields.hpp"
#include "run/trace_json.hpp"

namespace gjkscope {
namespace {

using fields::Json;
using fields::line;

std::string words(const Json& name) { return name.get<std::string>(); }

/// A run of GJK.
class RunText {
 public:
  RunText(const Json& document, const Json& run)
      : run_(run), is_in_space_(document["dimension"] == 3), values_(document) {}

  std::string write() {
    if (const int exponent = run_["exponent"]; exponent != 0)
      add("unit", fmt::format("2^{}, of lengths other than bounds and result", exponent));
    const Json& initial = run_["initial"];
    if (initial["stop"] != "failed") {
      out_ += "\nstart\n";
      std::string_view label = "simplex";
      for (const Json& vertex : initial["simplex"]) {
        add(label, fmt::format("{} = {}", words(vertex["name"]), values_.point(vertex["w"])));
        label = "";
      }
    }
    const Json* before = &initial;
    int iteration = 0;
    for (const Json& step : run_["steps"]) {
      if (step["iteration"] != iteration) {
        iteration = step["iteration"];
        out_ += fmt::format("\niteration {}\n", iteration);
      }
      add_step((*before)["simplex"], step);
      before = &step["after"];
    }
    add_result(run_["result"]);
    return std::move(out_);
  }

 private:
  void add(std::string_view label, const std::string& text) { out_ += line(label, text); }

  static std::string names(const Json& vertices) {
    std::vector<std::string> list;
    for (const Json& vertex : vertices) list.push_back(words(vertex["name"]));
    return fmt::format("{}", fmt::join(list, " "));
  }
  static std::string face(const Json& simplex, const Json& indices) {
    std::vector<std::string> list;
    for (const std::size_t index : indices) list.push_back(words(simplex[index]["name"]));
    return fmt::format("{}", fmt::join(list, " "));
  }

  [[nodiscard]] std::string weights(const Json& simplex) const {
    std::vector<std::string> parts;
    for (const Json& vertex : simplex)
      parts.push_back(words(vertex["name"]) + " " + values_.number(vertex["weight"]));
    return fmt::format("{}", fmt::join(parts, ", "));
  }

  void add_step(const Json& simplex_before, const Json& step) {
    const Json& after = step["after"];
    const Json& simplex = after["simplex"];
    const std::string phase = words(step["phase"]);
    if (phase == "closest") {
      for (const Json& test : step["region_tests"]) add_region_test(simplex_before, test);
      if (step["no_region_held"])
        add("", "rounding: no test to believe, the nearest face is taken");
      add("closest", fmt::format("P = {} on {}, |P|^2 = {}", values_.point(after["p"]),
                                 face(simplex, after["region"]), values_.number(after["p_sq"])));
      add("", "weights " + weights(simplex));
    } else if (phase == "drop") {
      const Json& dropped = step["dropped"];
      add("drop", fmt::format("keeps {}{}", names(simplex),
                              dropped.empty() ? "" : ", drops " + names(dropped)));
    } else if (phase == "direction") {
      add_direction(after, step["direction"]);
    } else if (phase == "support") {
      const Json& support = step["support"];
      const std::string name = words(support["name"]);
      add("scan", values_.scan(values_.y, step["scan_y"], support["pair"][1]));
      add("", values_.scan(values_.x, step["scan_x"], support["pair"][0]));
      add("support", fmt::format("{0} = {1}, dot(d, {0}) = {2}", name, values_.point(support["w"]),
                                 values_.number(after["support_value"])));
    } else if (phase == "stop") {
      for (const Json& test : step["stop_tests"]) add("stop?", values_.stop_test(test));
      add("bounds", values_.bounds(step));
    } else {
      add("add", "simplex " + names(simplex));
    }
  }

  void add_region_test(const Json& simplex, const Json& test) {
    add("test", fmt::format("region {}: {}", face(simplex, test["region"]),
                            test["holds"] ? "holds" : "does not hold"));
    if (test["terms"].empty()) add("", "  a single vertex");
    for (const Json& term : test["terms"]) {
      const Json& vertex = simplex[term["vertex"].get<std::size_t>()];
      add("", fmt::format("  {} of {} = {}/{} {} 0: {}", words(vertex["name"]),
                          face(simplex, term["face"]), values_.number(term["numerator"]),
                          values_.number(term["denominator"]),
                          term["wants_positive"] ? ">" : "<=", term["holds"] ? "yes" : "no"));
    }
  }

  void add_direction(const Json& after, const Json& note) {
    const Json& simplex = after["simplex"];
    const std::string d = values_.point(after["d"]);
    const std::string a = words(simplex[0]["name"]);
    bool is_from_p = true;
    for (std::size_t i = 0; i < after["d"].size(); ++i)
      is_from_p &= fields::double_of(after["d"][i]) == -fields::double_of(after["p"][i]);
    if (is_in_space_ && simplex.size() == 2 && !is_from_p) {
      return add("direction", fmt::format("d = e x (e x {0}) = {1}, with e = {2} - {0}", a, d,
                                          words(simplex[1]["name"])));
    }
    if (!note["from_normal"]) return add("direction", "d = O - P = " + d);
    add("direction", fmt::format("d = {}, normal of {}{}{}", d, names(simplex),
                                 note["flipped"] ? ", flipped" : "",
                                 !note["sign_is_arbitrary"] ? ""
                                 : is_in_space_             ? " (O on its plane: sign arbitrary)"
                                                            : " (O on its line: sign arbitrary)"));
    add("", fmt::format("dot(normal, O - {}) = {}", a, values_.number(note["side"])));
  }

  void add_result(const Json& value) {
    out_ += "\nresult\n";
    if (value["error"] != "none") return add("error", words(value["error"]));
    add("stop", words(value["stop"]));
    add("verdict", values_.verdict(value));
    add("distance", values_.number(value["distance"]));
    add("bounds", values_.bounds(value));
    add("on " + values_.x, values_.point(value["witness_x"]));
    add("on " + values_.y, values_.point(value["witness_y"]));
    add("simplex", weights(value["simplex"]));
    add("iterations", value["iterations"].dump());
  }

  const Json& run_;
  bool is_in_space_;
  fields::Values values_;
  std::string out_;
};

std::string head(const Json& document) {
  const Json& options = document["options"];
  const fields::Values values(document);
  const std::string id = words(document["lesson"]);
  const std::string title = words(document["title"]);
  const double tolerance = fields::double_of(options["tolerance"]);
  std::string out = fmt::format("{}: {}\n", id, title.empty() ? id : title);
  out += line("scalar", words(document["scalar"]));
  out += line("rules",
              fmt::format("direction {}, regions {}, cap {}{}", words(options["direction_rule"]),
                          words(options["region_order"]), options["iteration_cap"].get<int>(),
                          tolerance > 0.0 ? fmt::format(", tolerance {}", tolerance) : ""));
  const auto radius = [&](const char* shape) {
    const Json& of = document[shape];
    return of.contains("radius") ? fields::double_of(of["radius"]) : 0.0;
  };
  if (radius("x") > 0.0 || radius("y") > 0.0) {
    out += line("radii", fmt::format("{} of {}, {} of {}; all lengths below are without them",
                                     radius("x"), values.x, radius("y"), values.y));
  }
  return out;
}

}  // namespace

std::string trace_text(const Traced& traced) {
  const Json document = trace_document(traced);
  const Algorithm* algorithm =
      traced.lesson_run == nullptr ? nullptr : traced.lesson_run->tour->algorithm;
  std::string out = head(document);
  for (std::size_t i = 0; i < traced.runs.size(); ++i) {
    const Json& run = document["runs"][i];
    if (!traced.headings.empty()) out += fmt::format("\n{}\n", traced.headings[i]);
    if (run.contains("result")) out += RunText(document, run).write();
    if (algorithm == nullptr || !run.contains(algorithm->name)) continue;
    const Json& trace = run[std::string(algorithm->name)];
    out += algorithm->text != nullptr ? algorithm->text(document, trace)
                                      : fields::text(document, algorithm->name, trace);
  }
  return out;
}

}  // namespace gjkscope
