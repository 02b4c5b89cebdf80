#pragma once
// The blocks of the panel: one family a file. Each writes from the current row downwards.

#include "picture/panel_builder.hpp"

namespace gjkscope::blocks {

// pseudocode.cpp
void pseudocode(PanelBuilder& panel);

// regions.cpp
enum class TestMark { untried, fails, holds };
/// At the left of the current row.
void test_mark(PanelBuilder& panel, TestMark mark);
/// One row of a chain of tests: mark, region, condition and numbers.
void test_row(PanelBuilder& panel, TestMark mark, bool current, const std::string& region,
              const std::string& condition, const std::string& values);
void tests(PanelBuilder& panel);
void regions(PanelBuilder& panel);

// weights.cpp
void weights(PanelBuilder& panel);
void linear_system(PanelBuilder& panel);
void unit_vector(PanelBuilder& panel);
void areas(PanelBuilder& panel);

// balance.cpp
void balance(PanelBuilder& panel);

// maps.cpp
void signs(PanelBuilder& panel);
void orders(PanelBuilder& panel);

// run.cpp
void simplex(PanelBuilder& panel);
void scan(PanelBuilder& panel);
void bounds(PanelBuilder& panel);
void direction_rules(PanelBuilder& panel);

// stop_tests.cpp
void stop_tests(PanelBuilder& panel);

// two_runs.cpp
void two_runs(PanelBuilder& panel);

// difference.cpp
void pairs(PanelBuilder& panel);

// answer.cpp
void witness(PanelBuilder& panel);
void counters(PanelBuilder& panel);
void starts(PanelBuilder& panel);
void bound_steps(PanelBuilder& panel);

// growth.cpp
void growth(PanelBuilder& panel);
/// In place of `counters` where a frame is about many runs.
void growth_counters(PanelBuilder& panel);

// study.cpp
/// What a frame of the study knows: the answers to one pair, the marks, the front, what to take.
void study(PanelBuilder& panel);

}  // namespace gjkscope::blocks
