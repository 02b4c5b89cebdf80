#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "cli/commands.hpp"
#include "command_line.hpp"
#include "lessons.hpp"

namespace gjkscope {
namespace trace_test {

using nlohmann::json;

struct Traced {
  int exit_code = 0;
  std::string out;
  std::string err;
};

Traced trace(const std::string& input, bool as_json, ScalarKind scalar = ScalarKind::double_,
             ModelMethod method = ModelMethod::boxes) {
  std::istringstream in(input);
  std::ostringstream out;
  std::ostringstream err;
  const Environment env{GJKSCOPE_SOURCE_DIR, in, out, err};
  const int exit_code = trace_command(env, "-", {scalar, method}, as_json);
  return {exit_code, out.str(), err.str()};
}

const std::string kPentagon = R"({"a":[[-3,4]],"b":[[6,2],[5,6],[1,5],[0,1],[3,-1]]})";
const std::string kOverlap = R"({"a":[[-1,-1],[1,-1],[1,1]],"b":[[0.1,-0.6],[3,2],[2,-3]]})";
const std::string kInSpace =
    R"({"dimension":3,"a":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],"b":[[2,2,2],[3,2,2],[2,3,2]]})";

/// A square with a square hole, and a triangle in the hole.
const std::string kOutlines =
    R"({"outlines_a":[[[0,0],[10,0],[10,10],[0,10]],[[2,2],[2,8],[8,8],[8,2]]],)"
    R"("outlines_b":[[[4,4],[5,4],[5,5]]]})";
const std::string kConvexOutlines =
    R"({"outlines_a":[[[0,0],[4,0],[4,4],[0,4]]],"outlines_b":[[[6,1],[9,1],[8,3]]]})";

void collect_keys(const json& value, std::set<std::string>& keys) {
  if (value.is_object()) {
    for (const auto& [key, member] : value.items()) {
      keys.insert(key);
      collect_keys(member, keys);
    }
  } else if (value.is_array()) {
    for (const json& member : value) collect_keys(member, keys);
  }
}

/// The trace of the first shipped lesson with a tour.
std::string trace_of_lesson_with(std::string_view tour) {
  for (const Lesson& lesson : testing::shipped_lessons()) {
    if (lesson.tour != tour) continue;
    std::istringstream in;
    std::ostringstream out;
    std::ostringstream err;
    EXPECT_EQ(0, trace_command({GJKSCOPE_SOURCE_DIR, in, out, err}, lesson.id, {}, true))
        << err.str();
    return out.str();
  }
  ADD_FAILURE() << "no lesson has the tour " << tour;
  return "{}";
}

TEST(TraceJson, EveryKeyIsDocumented) {
  std::set<std::string> keys;
  for (const std::string& text : {kPentagon, kOverlap, kInSpace, kOutlines}) {
    collect_keys(json::parse(trace(text, true).out), keys);
  }
  for (const Tour* staged : registered_tours()) {
    if (staged->algorithm == &kGjkAlgorithm) continue;
    collect_keys(json::parse(trace_of_lesson_with(staged->name)), keys);
  }
  EXPECT_GT(keys.size(), 50u);
  const std::string page = test::read_file(GJKSCOPE_SOURCE_DIR "/docs/trace-format.md");
  ASSERT_FALSE(page.empty());
  for (const std::string& key : keys) {
    EXPECT_NE(std::string::npos, page.find("`" + key + "`"))
        << "not in docs/trace-format.md: " << key;
  }
}

void check_numbers(const json& value, int& count) {
  if (value.is_object() && value.contains("hex")) {
    ++count;
    ASSERT_EQ(2u, value.size());
    const double from_hex = std::strtod(value["hex"].get<std::string>().c_str(), nullptr);
    if (value["value"].is_null()) {
      ASSERT_FALSE(std::isfinite(from_hex));
    } else {
      ASSERT_EQ(value["value"].get<double>(), from_hex);
    }
    return;
  }
  if (value.is_structured()) {
    for (const json& member : value) check_numbers(member, count);
  }
}

TEST(TraceJson, DecimalAndHexadecimalAreTheSameNumber) {
  for (const ScalarKind scalar :
       {ScalarKind::half, ScalarKind::single, ScalarKind::double_, ScalarKind::exact}) {
    int count = 0;
    check_numbers(json::parse(trace(kPentagon, true, scalar).out), count);
    EXPECT_GT(count, 100);
    check_numbers(json::parse(trace(kInSpace, true, scalar).out), count);
    EXPECT_GT(count, 400);
  }
}

TEST(TraceJson, IsCompleteFromStartToStop) {
  for (const std::string& text : {kPentagon, kOverlap, kInSpace}) {
    const json document = json::parse(trace(text, true).out);
    EXPECT_EQ("gjkscope-trace", document["format"]);
    EXPECT_EQ(3, document["version"]);
    const int dimension = text == kInSpace ? 3 : 2;
    EXPECT_EQ(dimension, document["dimension"]);
    EXPECT_EQ(dimension, document["runs"][0]["result"]["witness_x"].size());
    EXPECT_EQ(dimension, document["x"]["vertices"][0].size());
    ASSERT_EQ(1u, document["runs"].size());
    const json& run = document["runs"][0];
    EXPECT_EQ("closest", run["steps"].front()["phase"]);
    EXPECT_EQ("stop", run["steps"].back()["phase"]);
    EXPECT_TRUE(run["steps"].back()["after"]["next_phase"].is_null());
    EXPECT_EQ(run["result"]["stop"], run["steps"].back()["after"]["stop"]);
  }
}

TEST(TraceJson, OutlinesAreTracedByEachMethod) {
  const std::pair<ModelMethod, const char*> methods[] = {
      {ModelMethod::boxes, "hierarchy-distance"},
      {ModelMethod::circles, "hierarchy-distance"},
      {ModelMethod::pieces, "convex-pieces"},
      {ModelMethod::lin_canny, "lin-canny"}};
  for (const auto& [method, key] : methods) {
    SCOPED_TRACE(name_of(method));
    const Traced traced = trace(kConvexOutlines, true, ScalarKind::double_, method);
    ASSERT_EQ(kDone, traced.exit_code) << traced.err;
    const json run = json::parse(traced.out)["runs"][0];
    EXPECT_EQ(2.0, run[key]["distance"]["value"]);
    EXPECT_FALSE(run[key]["steps"].empty());
    if (method == ModelMethod::circles) {
      EXPECT_EQ("circles", run[key]["volumes"]);
    }
  }
  const json document = json::parse(trace(kOutlines, true).out);
  EXPECT_EQ(json({4, 4}), document["x"]["outlines"]);
  EXPECT_EQ(2.0, document["runs"][0]["hierarchy-distance"]["distance"]["value"]);
  EXPECT_NE(std::string::npos, trace(kOutlines, false).out.find("\n  distance   2\n"));
}

TEST(TraceJson, OutlinesThatAreNotTracedAreSaidWithTheirPlace) {
  const std::string chain =
      R"({"outlines_a":[{"open":[[0,0],[1,0]]}],"outlines_b":[[[6,1],[9,1],[8,3]]]})";
  const Traced open = trace(chain, true);
  EXPECT_EQ(kProblem, open.exit_code);
  EXPECT_TRUE(open.out.empty());
  EXPECT_EQ(0u, open.err.find("<stdin>:1:24: /outlines_a/0/open: open chain")) << open.err;
  const Traced hole = trace(kOutlines, true, ScalarKind::double_, ModelMethod::lin_canny);
  EXPECT_EQ(kProblem, hole.exit_code);
  EXPECT_NE(std::string::npos, hole.err.find("more than one outline")) << hole.err;
  const Traced far = trace(
      R"({"outlines_a":[[[-1.7e308,0],[-1.6e308,0]]],"outlines_b":[[[1.7e308,0],[1.6e308,0]]]})",
      true);
  EXPECT_EQ(kProblem, far.exit_code);
  EXPECT_NE(std::string::npos, far.err.find("refused: overflow")) << far.err;
}

TEST(TraceJson, ARefusedQueryIsSaid) {
  const Traced refused = trace(R"({"a":[[0,0]],"b":[[1e-7,0]]})", true, ScalarKind::half);
  EXPECT_EQ(kProblem, refused.exit_code);
  const json document = json::parse(refused.out);
  EXPECT_EQ("underflow", document["runs"][0]["result"]["error"]);
  EXPECT_TRUE(document["runs"][0]["result"]["distance"]["value"].is_null());
  EXPECT_TRUE(document["runs"][0]["steps"].empty());
}

TEST(TraceJson, ExtremeCoordinatesHaveAUnit) {
  for (const std::string& text : {kPentagon, kOverlap}) {
    EXPECT_EQ(0, json::parse(trace(text, true).out)["runs"][0]["exponent"]);
  }
  const Traced small = trace(R"({"a":[[0,0]],"b":[[3e-200,4e-200]]})", true);
  EXPECT_EQ(kDone, small.exit_code);
  const json run = json::parse(small.out)["runs"][0];
  const int exponent = run["exponent"].get<int>();
  const json& step = run["steps"].back();
  const double p = std::sqrt(step["after"]["p_sq"]["value"].get<double>());
  EXPECT_DOUBLE_EQ(5e-200, std::ldexp(p, exponent));
  EXPECT_NEAR(5e-200, step["lower"]["value"].get<double>(), 1e-214);
  EXPECT_DOUBLE_EQ(5e-200, run["result"]["distance"]["value"].get<double>());
}

TEST(TraceJson, InSpaceLengthsOfStatesAreInTheUnitOfTheRun) {
  const Traced large =
      trace(R"({"dimension":3,"a":[[0,0,0]],"b":[[2e25,3e25,6e25]]})", true, ScalarKind::single);
  EXPECT_EQ(kDone, large.exit_code);
  const json run = json::parse(large.out)["runs"][0];
  const int exponent = run["exponent"].get<int>();
  EXPECT_NE(0, exponent);
  const double p = std::sqrt(run["steps"].back()["after"]["p_sq"]["value"].get<double>());
  EXPECT_NEAR(1.0, std::ldexp(p, exponent) / 7e25, 1e-6);
  EXPECT_NEAR(1.0, run["result"]["distance"]["value"].get<double>() / 7e25, 1e-6);
}

TEST(TraceJson, BoundsCloseInOnTheResult) {
  for (const ScalarKind scalar :
       {ScalarKind::half, ScalarKind::single, ScalarKind::double_, ScalarKind::exact}) {
    for (const std::string& text : {kPentagon, kInSpace}) {
      const json run = json::parse(trace(text, true, scalar).out)["runs"][0];
      const auto value = [](const json& of, const char* key) {
        return of[key]["value"].get<double>();
      };
      const json& first = run["steps"].front();
      const json& last = run["steps"].back();
      EXPECT_LT(value(first, "lower"), value(last, "lower"));
      EXPECT_GT(value(first, "upper"), value(last, "upper"));
      EXPECT_EQ(run["result"]["lower"], last["lower"]);
      EXPECT_EQ(run["result"]["upper"], last["upper"]);
    }
  }
}

TEST(TraceText, TellsEveryPhase) {
  const Traced traced = trace(kPentagon, false);
  EXPECT_EQ(kDone, traced.exit_code);
  for (const char* word :
       {"iteration 1", "iteration 2", "test ", "closest ", "drop ", "direction ", "scan ",
        "support ", "stop? ", "add ", "result", "bounds ", "repeated-support: yes"}) {
    EXPECT_NE(std::string::npos, traced.out.find(word)) << word;
  }
  EXPECT_EQ(std::string::npos, traced.out.find("nan"));
}

TEST(TraceText, TellsHowDirectionsComeAboutInSpace) {
  const std::string text = trace(kInSpace, false).out;
  for (const char* words : {"d = O - P = [-1, -2, -2]", "d = e x (e x y1−x2) = [-3, -3, -4]",
                            ", normal of y1−x2 y1−x3 y1−x4", "distance   2.88675134"}) {
    EXPECT_NE(std::string::npos, text.find(words)) << words << " not in\n" << text;
  }
}

TEST(TraceText, SinglePrecisionPrintsAsFewDigitsAsItNeeds) {
  const std::string slides =
      R"({"a":[[0,0]],"b":[[0.021119118,79.584320],[0.020964622,-31.515678]]})";
  const std::string text = trace(slides, false, ScalarKind::single).out;
  EXPECT_NE(std::string::npos, text.find("0.28366947")) << text;
  EXPECT_NE(std::string::npos, text.find("0.71633047")) << text;
}

}  // namespace trace_test
}  // namespace gjkscope
