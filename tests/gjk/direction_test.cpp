// Phase "direction", and the slides' example of what its round-off does (Catto 2010, "A real
// example in single precision").

#include "gjk/direction.hpp"

#include "check.hpp"
#include "gjk/gjk.hpp"

namespace direction_test {

using gjk::DirectionRule;
using gjk::Phase;
using gjk::Vec;

struct SlidesExample {
  std::vector<Vec<float, 2>> q = {{0.0f, 0.0f}};
  std::vector<Vec<float, 2>> segment = {{0.021119118f, 79.584320f}, {0.020964622f, -31.515678f}};
  gjk::Options options;
  SlidesExample() {
    options.start.count = 2;
    options.start.pairs[1] = {0, 1};
  }
  [[nodiscard]] gjk::Query<float, 2> query() const { return {{q}, {segment}}; }
};

std::string printed(float value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.8g", static_cast<double>(value));
  return text;
}

const gjk::Step<float, 2>* first(const gjk::Trace<float, 2>& trace, Phase phase) {
  for (const gjk::Step<float, 2>& step : trace.steps) {
    if (step.phase == phase) return &step;
  }
  return nullptr;
}

TEST(slides_weights, "the slides' segment has u = 0.28366947, v = 0.71633047, to the last digit") {
  const SlidesExample example;
  const auto trace = gjk::trace<float>(example.query(), example.options);
  const gjk::Step<float, 2>* closest = first(trace, Phase::closest);
  CHECK(closest != nullptr);
  CHECK_EQ(std::string("0.28366947"), printed(closest->after.simplex.weights[0]));
  CHECK_EQ(std::string("0.71633047"), printed(closest->after.simplex.weights[1]));
}

TEST(slides_bad, "d = O - P is [-0.021008447, 0] and not orthogonal: dot(d, B-A) = 3.2457051e-06") {
  SlidesExample example;
  example.options.direction_rule = DirectionRule::towards_origin;
  const auto trace = gjk::trace<float>(example.query(), example.options);
  const gjk::Step<float, 2>* direction = first(trace, Phase::direction);
  CHECK(direction != nullptr);
  const Vec<float, 2> d = direction->after.d;
  CHECK_EQ(std::string("-0.021008447"), printed(d[0]));
  CHECK_EQ(0.0f, d[1]);
  const Vec<float, 2> edge = example.segment[1] - example.segment[0];
  CHECK_EQ(std::string("3.2457051e-06"), printed(gjk::dot(d, edge)));
  CHECK(!direction->record.direction.from_normal);
}

TEST(slides_good, "the perpendicular direction of the same segment is orthogonal exactly") {
  const SlidesExample example;
  const auto trace = gjk::trace<float>(example.query(), example.options);
  const gjk::Step<float, 2>* direction = first(trace, Phase::direction);
  CHECK(direction != nullptr);
  const Vec<float, 2> edge = example.segment[1] - example.segment[0];
  CHECK_EQ(0.0f, gjk::dot(direction->after.d, edge));
  CHECK(direction->after.d[0] < 0);
  CHECK(direction->record.direction.from_normal);
  CHECK(!direction->record.direction.sign_is_arbitrary);
}

gjk::State<double, 2> at(const std::vector<Vec<double, 2>>& points, const Vec<double, 2>& p) {
  gjk::State<double, 2> state;
  for (const Vec<double, 2>& point : points)
    state.simplex.vertices[state.simplex.count++].w = point;
  state.p = p;
  state.phase = Phase::direction;
  return state;
}

TEST(sign, "the normal of an edge points to the side of O, whichever way the edge runs") {
  for (const bool swapped : {false, true}) {
    for (const double height : {2.0, -2.0}) {
      const check::Context context("swapped", swapped, "height", height);
      const Vec<double, 2> left(-1, height);
      const Vec<double, 2> right(3, height);
      auto state = swapped ? at({right, left}, {0, height}) : at({left, right}, {0, height});
      gjk::Record<double, 2> record;
      gjk::build_direction(state, {}, record);
      CHECK_EQ(0.0, state.d[0]);
      CHECK_EQ(height > 0 ? -4.0 : 4.0, state.d[1]);
      CHECK_EQ(record.direction.flipped, record.direction.side < 0);
      CHECK_EQ(Phase::support, state.phase);
    }
  }
}

TEST(vertex, "at a vertex d = O - P under both rules") {
  for (const DirectionRule rule : {DirectionRule::perpendicular, DirectionRule::towards_origin}) {
    auto state = at({{3, 4}}, {3, 4});
    gjk::Options options;
    options.direction_rule = rule;
    gjk::Record<double, 2> record;
    gjk::build_direction(state, options, record);
    CHECK_EQ(-3.0, state.d[0]);
    CHECK_EQ(-4.0, state.d[1]);
    CHECK(!record.direction.from_normal);
  }
}

TEST(on_edge, "with O on the edge the normal's sign is arbitrary, and that is noted") {
  auto state = at({{-1, 0}, {1, 0}}, {0, 0});
  gjk::Record<double, 2> record;
  gjk::build_direction(state, {}, record);
  CHECK(record.direction.sign_is_arbitrary);
  CHECK(!record.direction.flipped);
  CHECK(state.d == record.direction.normal);
  CHECK(!gjk::is_zero(state.d));
  CHECK_EQ(Phase::support, state.phase);
}

TEST(none, "O on a vertex gives no direction: the stop phase is next") {
  auto state = at({{0, 0}}, {0, 0});
  gjk::NoRecord none_recorded;
  gjk::build_direction(state, {}, none_recorded);
  CHECK(gjk::is_zero(state.d));
  CHECK_EQ(Phase::stop, state.phase);
}

TEST(no_normal, "an edge whose ends coincide falls back to O - P") {
  auto state = at({{3, 4}, {3, 4}}, {3, 4});
  gjk::Record<double, 2> record;
  gjk::build_direction(state, {}, record);
  CHECK_EQ(-3.0, state.d[0]);
  CHECK(!record.direction.from_normal);
}

}  // namespace direction_test
