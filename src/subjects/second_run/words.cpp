#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "picture/story.hpp"
#include "subjects/second_run/second_run.hpp"
#include "subjects/second_run/subject.hpp"

namespace gjkscope::captions {
namespace {

using Eigen::Vector3d;

std::string arithmetic(ScalarKind scalar) {
  switch (scalar) {
    case ScalarKind::half:
      return "half precision";
    case ScalarKind::single:
      return "single precision";
    case ScalarKind::double_:
      return "double precision";
    case ScalarKind::exact:
      return "exact arithmetic";
  }
  return {};
}

std::string at_the_start(std::string words) {
  words[0] = static_cast<char>(std::toupper(words[0]));
  return words;
}

/// dot(d, V) of the vertex that a scan of Y found farthest.
double farthest(const WideStep& step) {
  double value = 0.0;
  for (const auto& entry : step.record.scan_y) {
    if (entry.index == step.after.support.pair.y) value = entry.value;
  }
  return value;
}

/// True if a run's d is perpendicular to a segment of which it found one end, and another run the
/// other.
bool is_tie(const WideState& state, gjk::VertexPair other) {
  const auto holds = [&](gjk::VertexPair pair) {
    return std::any_of(state.simplex.vertices.begin(),
                       state.simplex.vertices.begin() + state.simplex.count,
                       [&](const auto& vertex) { return vertex.pair == pair; });
  };
  return state.simplex.count == 2 && holds(state.support.pair) && holds(other);
}

double degrees_between(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / std::numbers::pi;
}

/// How the other run finds the query point inside, and whether the first one does with the other
/// way to build d.
std::string inside(const Story& story, const SecondRun::Value& second,
                   const std::string& in_first) {
  const auto triangle = [&](const PositionedRun& run) {
    const WideSimplex& simplex = run.trace.result.simplex;
    return SimplexWords(story.run, simplex).face(simplex.all());
  };
  const std::string found = triangle(second.run);
  std::string out = fmt::format("It ends with {} inside {}, at distance 0.", story.q, found);
  const std::optional<PositionedRun>& mended = second.mended;
  if (mended && mended->trace.result.stop == gjk::StopReason::origin_inside &&
      triangle(*mended) == found) {
    const std::string edge = fmt::format("{} − {}", story.words.vertex(1), story.words.vertex(0));
    const std::string d = story.run.lesson.dimension == 3
                              ? fmt::format("cross(e, cross(e, {} − {})), where e = {}",
                                            story.words.vertex(0), story.q, edge)
                              : fmt::format("cross({}, z)", edge);
    out += fmt::format(" So does {} with d = {}.", in_first, d);
  }
  return out;
}

}  // namespace

void second_run(const Story& story, FrameText& text) {
  if (!story.shows(SecondRun::kName)) return;
  const SecondRun::Value& second = story.effects.get<SecondRun>(story.frame);
  const WideStep* step = step_beside(second, story.run, story.frame);
  if (!step) return;
  const std::string in_first = arithmetic(story.run.lesson.scalar);
  const std::string first = at_the_start(in_first);
  const ScalarKind scalar = *second_of(story.run.lesson)->scalar;
  const std::string other = arithmetic(scalar);
  const WideState& mine = story.state;
  const WideState& beside = step->after;
  Lesson in_other = story.run.lesson;
  in_other.scalar = scalar;
  const Numbers numbers(in_other);
  const auto point = [&](const Vector3d& v) {
    std::vector<std::string> coordinates;
    for (int i = 0; i < in_other.dimension; ++i) coordinates.push_back(numbers(v[i]));
    return fmt::format("({})", fmt::join(coordinates, ", "));
  };
  const double degrees = degrees_between(mine.d, beside.d);
  const std::string name = story.run.pair_name(mine.support.pair);
  const std::string name_beside = story.run.pair_name(beside.support.pair);
  switch (step->phase) {
    case gjk::Phase::closest: {
      const double away = (mine.p - beside.p).norm();
      if (away == 0.0) {
        if (mine.p_sq != beside.p_sq) {
          text.detail = fmt::format(
              "Thus {}. Its squared distance from {}, rounded to {}, is {}, so the distance is {}; "
              "{} has {}.",
              story.p_is(), story.q, in_first, story.numbers(mine.p_sq), story.distance(), other,
              numbers(std::sqrt(beside.p_sq)));
        }
        return;
      }
      // A point query's P stands where it is in the world, as in the panel; between polygons it is
      // a difference.
      const Vector3d p =
          story.run.point_query() ? Vector3d(beside.p + story.positioned.x().world[0]) : beside.p;
      text.detail = fmt::format("Thus {}, rounded. In {} P = {}, which is {} away.", story.p_is(),
                                other, point(p), numbers(away));
      return;
    }
    case gjk::Phase::direction:
      if (degrees < 0.05) return;
      text.caption = fmt::format("d = {} − P inherits the error of P: it is {}° off.", story.q,
                                 fixed(degrees, 1));
      text.detail = fmt::format("Here d = {}; in {} d = {}.", story.numbers.point(mine.d), other,
                                point(beside.d));
      return;
    case gjk::Phase::support:
      if (mine.support.pair == beside.support.pair) {
        const double along = farthest(story.run.step(story.frame));
        const double along_beside = farthest(*step);
        if (!story.run.point_query() || along == along_beside) return;
        text.caption = fmt::format(
            "{0} lies farthest along d: dot(d, {0}) = {1}, rounded to {2}; {3} has {4}.", name,
            story.numbers(along), in_first, other, numbers(along_beside));
        return;
      }
      if (is_tie(beside, mine.support.pair)) {
        text.detail = fmt::format("In {} {} and {} lie equally far along d: either is right.",
                                  other, name_beside, name);
        return;
      }
      text.caption = fmt::format("{} finds {}, the farthest vertex along its d. {} finds {}.",
                                 first, name, at_the_start(other), name_beside);
      text.detail = fmt::format("{} is the wrong support point, because round-off turned d by {}°.",
                                name, fixed(degrees, 1));
      return;
    case gjk::Phase::stop:
      if (!story.knows.has_ended) {
        if (beside.stop == gjk::StopReason::running && mine.p_sq != beside.p_sq) {
          text.detail = fmt::format("P is {} away, the root of the rounded square; {} has {}.",
                                    story.distance(), other, numbers(std::sqrt(beside.p_sq)));
        }
        return;
      }
      if (beside.stop != gjk::StopReason::running) return;
      text.caption =
          fmt::format("{} stops at distance {}: {} is already in the simplex. {} adds {}.", first,
                      story.distance(), name, at_the_start(other), name_beside);
      text.detail =
          second.run.trace.result.distance > 0.0
              ? fmt::format("It ends at distance {}.", numbers(second.run.trace.result.distance))
              : inside(story, second, in_first);
      return;
    default:
      return;
  }
}

}  // namespace gjkscope::captions
