#include <fmt/format.h>

#include <array>

#include "subjects/issues/numerical_issue.hpp"
#include "subjects/issues/subject.hpp"
#include "subjects/shape_hull/shape_hull.hpp"

namespace gjkscope::blocks {
namespace {

using namespace rows;

struct Issue {
  std::string_view topic;  ///< As the slides order them.
  std::string_view where;
  std::string_view lessons;  ///< Lessons that show it from near by.
};

/// In the order of NumericalIssue::Kind.
constexpr std::array<Issue, 8> kIssues = {{
    {"Search direction", "beyond an edge", "direction-roundoff, direction-half"},
    {"Termination", "beyond a vertex", "stop-repeated"},
    {"Termination", "inside", "stop-contained"},
    {"Termination", "on a vertex", "stop-vertex"},
    {"Termination", "on an edge", "stop-edge-left, stop-edge-right"},
    {"Termination", "on a segment inside", "stop-interior-edge"},
    {"Poorly formed polygons", "in a notch", "nonconvex-vertex"},
    {"Poorly formed polygons", "beyond a line of vertices", "collinear"},
}};

/// The behaviour of GJK there, in a few words.
std::string outcome(PanelBuilder& panel, const NumericalIssue::Value& issue, const Frame& frame) {
  if (issue.kind == NumericalIssue::Kind::direction) return "d ← cross";
  if (issue.kind == NumericalIssue::Kind::notch) return "hull only";
  return stop_test(panel.run, frame);
}

void issues(PanelBuilder& panel) {
  std::string_view topic;
  for (int i = 0; i < static_cast<int>(panel.run.runs.size()); ++i) {
    const Frame end{.run = i, .step = last_step(panel.run.lesson, panel.run.runs[i].trace)};
    const NumericalIssue::Value& value = panel.effects.get<NumericalIssue>(end);
    const Issue& issue = kIssues[static_cast<std::size_t>(value.kind)];
    if (issue.topic != topic) panel.heading(std::string(issue.topic));
    topic = issue.topic;
    const bool current = i == panel.frame.run;
    const bool over = i < panel.frame.run || (current && panel.frame.step >= 0);
    if (current) panel.highlight("highlight", kTightRow);
    const std::string role = current ? "strong" : over ? "body" : "untried";
    panel.write(role, panel.left, fmt::format("{}  {}", i + 1, issue.where),
                current ? type::kStrong : type::kBody);
    if (over)
      panel.write(current ? "code.current" : "code", panel.right, outcome(panel, value, end),
                  current ? type::kCodeBold : type::kCode, Align::right);
    panel.y += kTightRow;
    panel.write("body.muted", panel.left + 18.0, "lesson " + std::string(issue.lessons),
                type::kText);
    panel.y += kRow;
  }
}

}  // namespace

const Block kIssuesOfPlaces{
    .name = "issues",
    .meaning =
        "the numerical issues, by where Q lies: how GJK ends there, and the lessons that "
        "go into it",
    .write = issues,
    .tour = "issues"};

}  // namespace gjkscope::blocks
