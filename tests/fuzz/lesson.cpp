// Bytes as a lesson file. A lesson that loads is run, checked, written as text and JSON, and drawn.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "claims.hpp"
#include "frames/frame.hpp"
#include "lesson/load.hpp"
#include "run/graph.hpp"
#include "run/run.hpp"
#include "run/trace_json.hpp"
#include "run/trace_text.hpp"
#include "subjects/growth/table.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::fuzz {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector2d;

// More than that only takes longer.
constexpr std::size_t kMostBytes = 4096;
constexpr std::size_t kMostScanned = 5000;  ///< Vertices, in all iterations of all runs.
constexpr std::size_t kMostGrown = 2000;    ///< Vertices of random polygons.
constexpr std::size_t kMostSteps = 200;     ///< Steps.
constexpr std::size_t kMostDrawn = 4;       ///< Frames.

/// A file of this process: checking looks into it for places.
class LessonFile {
 public:
  ~LessonFile() {
    std::error_code none;
    fs::remove(path_, none);
  }
  const fs::path& write(std::string_view text) const {
    std::ofstream(path_, std::ios::binary) << text;
    return path_;
  }

 private:
  fs::path path_ = fs::temp_directory_path() / fmt::format("fuzz-lesson-{}.toml", ::getpid());
};

bool is_cheap(const Lesson& lesson) {
  if (const LessonGrowth* growth = lesson.settings.as<LessonGrowth>()) {
    const std::vector<int>& sizes = growth->vertices;
    const auto grown = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
    if (kMostGrown < grown * static_cast<std::size_t>(growth->runs)) return false;
  }
  const gjk::Options& options = lesson.options;
  const bool all_stops = options.stop_on_repeated_support && options.stop_on_no_progress;
  const auto iterations = static_cast<std::size_t>(all_stops ? std::min(options.iteration_cap, 10)
                                                             : options.iteration_cap);
  const std::size_t positions = lesson.path_of_shapes ? lesson.path_of_shapes->positions() : 1;
  const std::size_t vertices = lesson.x().vertices.size() + lesson.y().vertices.size();
  return positions * iterations * vertices <= kMostScanned;
}

void claim_sound(const PositionedRun& run) {
  const WideResult& result = run.trace.result;
  claim(result.stop != gjk::StopReason::running, "a run ends");
  claim(run.bounds.size() == run.trace.steps.size(), "each step has bounds");
  if (result.error != gjk::Error::none) return;
  claim(std::isfinite(result.distance), "a distance is finite");
  claim((result.x.allFinite() && result.y.allFinite()) || !why_not_drawn(run).empty(),
        "witness points are finite");
  claim(0.0 <= result.lower && result.lower <= result.distance && result.distance <= result.upper,
        "0 <= lower <= distance <= upper");
  double lower = 0.0;
  double upper = std::numeric_limits<double>::infinity();
  for (const DistanceBounds& bounds : run.bounds) {
    claim(!std::isnan(bounds.lower) && !std::isnan(bounds.upper), "bounds are numbers");
    lower = std::max(lower, bounds.lower);
    upper = std::min(upper, bounds.upper);
  }
  claim(lower <= upper,
        fmt::format("the bounds of all steps hold one distance: {} <= {}", lower, upper));
}

void claim_sound(const LessonRun& run) {
  claim(!run.runs.empty(), "there is a run");
  for (const PositionedRun& positioned : run.runs) {
    if (!positioned.trace.is_empty()) claim_sound(positioned);
  }
  for (const Frame& frame : run.frames) {
    claim(0 <= frame.run && frame.run < static_cast<int>(run.runs.size()) && -1 <= frame.step &&
              frame.step <= run.algorithm_trace(frame).steps() &&
              run.gjk_step(frame) < static_cast<int>(run.run(frame).trace.steps.size()),
          "a frame shows a step");
  }
}

/// Checks the output of `gjkscope check`.
void claim_checked(const LessonRun& run, std::string_view text) {
  for (const Problem& problem : check_expectation(run)) claim_located(problem, text);
  for (const LessonText& shown : texts_of(run.lesson)) {
    if (Fonts::first_missing(shown.text) == 0) continue;
    const Place place = place_of_key(run.lesson.path, shown.key);
    claim_located({run.lesson.path, place.line, place.column, "missing character", "", ""}, text);
  }
}

/// Checks the output of `gjkscope trace`.
void claim_trace_text(const LessonRun& run) {
  std::size_t steps = 0;
  for (const PositionedRun& positioned : run.runs) steps += positioned.trace.steps.size();
  if (steps > kMostSteps) return;
  claim(!trace_text(traced(run)).empty(), "a trace can be told");
  claim(nlohmann::json::accept(trace_json(traced(run))), "a trace is JSON");
}

bool is_finite(const Rect& rect) { return rect.min.allFinite() && rect.max.allFinite(); }
bool is_finite(const std::vector<Vector2d>& points) {
  return std::all_of(points.begin(), points.end(), [](const Vector2d& p) { return p.allFinite(); });
}
bool is_finite(const Polygon& shape) { return is_finite(shape.points); }
bool is_finite(const Polyline& shape) { return is_finite(shape.points); }
bool is_finite(const Arrow& shape) { return shape.from.allFinite() && shape.to.allFinite(); }
bool is_finite(const Disk& shape) {
  return shape.center.allFinite() && std::isfinite(shape.radius);
}
bool is_finite(const Cross& shape) {
  return shape.center.allFinite() && std::isfinite(shape.radius);
}
bool is_finite(const Box& shape) { return is_finite(shape.rect) && std::isfinite(shape.corner); }
bool is_finite(const Text& shape) { return shape.at.allFinite(); }

/// Checks the pictures that `gjkscope export` would draw, for some frames.
void claim_drawn(LessonRun run) {
  for (const PositionedRun& positioned : run.runs) {
    if (!why_not_drawn(positioned).empty()) return;
  }
  const std::vector<Frame> frames = std::move(run.frames);
  run.frames.clear();
  const std::size_t count = std::min(frames.size(), kMostDrawn);
  for (std::size_t i = 0; i < count; ++i)
    run.frames.push_back(frames[i * (frames.size() - 1) / std::max<std::size_t>(count - 1, 1)]);

  static const Fonts fonts(fs::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  EffectGraph effects(run);
  const std::vector<FramePicture> drawn = lesson_pictures(run, effects, fonts);
  claim(drawn.size() == count, "each frame is drawn");
  for (const FramePicture& frame : drawn) {
    claim(!frame.text.caption.empty() && !frame.text.detail.empty() && !frame.text.prose.empty(),
          "a frame says what happened");
    for (const Rect& clip : frame.picture.clips) claim(is_finite(clip), "clips are finite");
    for (const Mark& mark : frame.picture.marks) {
      claim(std::visit([](const auto& shape) { return is_finite(shape); }, mark.shape),
            "marks are finite: " + mark.role);
    }
  }
}

void feed(std::string_view text) {
  static const LessonFile file;
  const LoadedLesson loaded = load_lesson(file.write(text), vocabulary());
  claim(loaded.lesson.has_value() == loaded.problems.empty(), "a lesson loads, or has problems");
  for (const Problem& problem : loaded.problems) claim_located(problem, text);
  if (!loaded.lesson || !is_cheap(*loaded.lesson)) return;
  const LessonRun run = run_lesson(*loaded.lesson);
  claim_sound(run);
  claim_checked(run, text);
  claim_trace_text(run);
  claim_drawn(run);
}

}  // namespace
}  // namespace gjkscope::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gjkscope;
  if (size > fuzz::kMostBytes) return 0;
  fuzz::feed({reinterpret_cast<const char*>(data), size});
  return 0;
}
