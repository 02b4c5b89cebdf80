#include "export/export.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "effects/graph.hpp"
#include "export/contact_sheet.hpp"
#include "export/frame_writer.hpp"
#include "export/signal_watch.hpp"
#include "lesson/file.hpp"
#include "lesson/names.hpp"
#include "lesson/run.hpp"
#include "paint/canvas.hpp"
#include "picture/frame.hpp"
#include "picture/registry.hpp"

namespace gjkscope {
namespace {

constexpr int kSupersampling = 2;
// A thumbnail; type below that has no pixels to stand on.
constexpr int kSmallestWidth = 160;
constexpr int kSmallestHeight = 90;
constexpr int kMostThreads = 64;

/// Says on stderr how far the export is: a line a lesson, or on a terminal one line that changes.
class Progress {
 public:
  Progress(bool wanted, std::size_t lesson_count)
      : wanted_(wanted), terminal_(::isatty(STDERR_FILENO) == 1), lesson_count_(lesson_count) {}

  void frame(std::size_t lesson, const std::string& id, int done, int count) {
    if (!wanted_ || !terminal_) return;
    const auto now = std::chrono::steady_clock::now();
    if (done != count && now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    fmt::print(stderr, "\r\033[K[{}/{}] {}: frame {} of {}", lesson + 1, lesson_count_, id, done,
               count);
    std::fflush(stderr);
  }
  void lesson(std::size_t lesson, const std::string& id, int count) const {
    if (!wanted_) return;
    fmt::print(stderr, "{}[{}/{}] {}: {} {}\n", terminal_ ? "\r\033[K" : "", lesson + 1,
               lesson_count_, id, count, count == 1 ? "frame" : "frames");
  }

 private:
  bool wanted_;
  bool terminal_;
  std::size_t lesson_count_;
  std::chrono::steady_clock::time_point last_;
};

struct StepRange {
  int first = 1;
  int last = 0;
};

StepRange step_range(const ExportOptions& options, const std::string& id, int count) {
  const StepRange range{options.first_step.value_or(1),
                        std::min(options.last_step.value_or(count), count)};
  if (range.first < 1 || range.first > range.last) {
    throw std::runtime_error(fmt::format("{} has steps 1..{}; asked for {}..{}", id, count,
                                         range.first, options.last_step.value_or(count)));
  }
  return range;
}

void check(const ExportOptions& options) {
  if (options.format != "png") {
    throw std::runtime_error(fmt::format(R"(no format "{}"; there is png)", options.format));
  }
  if (options.width < kSmallestWidth || options.height < kSmallestHeight) {
    throw std::runtime_error(fmt::format("a frame of {}x{} is too small; the least is {}x{}",
                                         options.width, options.height, kSmallestWidth,
                                         kSmallestHeight));
  }
  std::error_code error;
  std::filesystem::create_directories(options.out_dir, error);
  if (!std::filesystem::is_directory(options.out_dir)) {
    throw std::runtime_error(fmt::format("cannot make the folder {}: {}", options.out_dir.string(),
                                         error ? error.message() : "there is a file"));
  }
}

int thread_count(const ExportOptions& options) {
  const int asked =
      options.jobs > 0 ? options.jobs : static_cast<int>(std::thread::hardware_concurrency());
  return std::clamp(asked, 1, kMostThreads);
}

std::string frame_name(const std::string& id, int step) {
  return fmt::format("{}-{:04}.png", id, step);
}

/// Frames beyond `count` are of an earlier, longer lesson.
void remove_stale_frames(const std::filesystem::path& folder, const std::string& id, int count) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(id + "-")) continue;
    int step = 0;
    std::from_chars(name.data() + id.size() + 1, name.data() + name.size(), step);
    if (step > count && name == frame_name(id, step)) {
      std::filesystem::remove(entry.path(), ignored);
    }
  }
}

class Exporter {
 public:
  explicit Exporter(const ExportOptions& options)
      : options_(options),
        fonts_(options.assets_dir / "fonts.toml"),
        canvas_(fonts_, Theme::load(options.assets_dir / "themes", options.theme), options.width,
                options.height, kSupersampling, page_of(options.width, options.height).zoom),
        writer_(thread_count(options), kSupersampling) {}

  /// Hands the lesson's frames to the writer. False when a signal came before the last one.
  bool add(const Lesson& lesson, std::size_t lesson_index, Progress& progress) {
    Lesson asked_for = lesson;
    if (!options_.questions) asked_for.questions.clear();
    const LessonRun run = run_lesson(std::move(asked_for));
    for (const PositionedRun& positioned : run.runs) {
      if (const std::string why = why_not_drawn(positioned); !why.empty()) {
        throw std::runtime_error(
            fmt::format("{}: {}; `gjkscope check` says where", lesson.id, why));
      }
    }
    EffectGraph effects(run);
    std::vector<FramePicture> pictures =
        lesson_pictures(run, effects, fonts_, page_of(options_.width, options_.height));
    const int count = static_cast<int>(pictures.size());
    const StepRange range = step_range(options_, lesson.id, count);

    ExportedLesson exported{lesson.id,       lesson.title,   lesson.chapter,
                            lesson.source,   options_.theme, options_.width,
                            options_.height, count,          {}};
    for (int step = range.first; step <= range.last; ++step) {
      if (SignalWatch::signal() != 0) return false;
      FramePicture& picture = pictures[static_cast<std::size_t>(step - 1)];
      ExportedFrame frame{step, frame_name(lesson.id, step), std::move(picture.text)};
      Image image = writer_.acquire();
      canvas_.paint(picture.picture, image);
      files_.push_back(options_.out_dir / frame.file);
      writer_.submit(std::move(image), files_.back());
      exported.frames.push_back(std::move(frame));
      ++frame_count_;
      progress.frame(lesson_index, lesson.id, step - range.first + 1, range.last - range.first + 1);
    }
    progress.lesson(lesson_index, lesson.id, range.last - range.first + 1);
    lessons_.push_back(std::move(exported));
    return true;
  }

  /// What describes the frames comes after them.
  void finish(ExportResult& result, bool complete) {
    writer_.finish();
    for (const ExportedLesson& lesson : lessons_) {
      write(options_.out_dir / (lesson.id + ".json"), sidecar(lesson));
      if (!options_.first_step && !options_.last_step) {
        remove_stale_frames(options_.out_dir, lesson.id, lesson.steps);
      }
    }
    if (options_.index && complete) {
      write(options_.out_dir / "index.html",
            contact_sheet(lessons_, read_whole(options_.assets_dir / "contact-sheet.html")));
    }
    result.files = std::move(files_);
    result.frames = frame_count_;
  }

 private:
  void write(const std::filesystem::path& path, const std::string& text) {
    write_whole(path, text);
    files_.push_back(path);
  }

  const ExportOptions& options_;
  Fonts fonts_;
  Canvas canvas_;
  FrameWriter writer_;
  std::vector<ExportedLesson> lessons_;
  std::vector<std::filesystem::path> files_;
  int frame_count_ = 0;
};

}  // namespace

ExportResult export_lessons(const std::vector<Lesson>& lessons, const ExportOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  check(options);
  remove_leftovers(options.out_dir);

  const SignalWatch watch;
  Exporter exporter(options);
  Progress progress(options.progress, lessons.size());
  bool complete = true;
  for (std::size_t i = 0; i < lessons.size() && complete; ++i) {
    complete = exporter.add(lessons[i], i, progress);
  }
  ExportResult result;
  exporter.finish(result, complete);
  result.signal = complete ? 0 : SignalWatch::signal();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

std::string to_json(const ExportResult& result) {
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (const auto& file : result.files) files.push_back(file.string());
  const nlohmann::ordered_json json = {{"frames", result.frames},
                                       {"seconds", result.seconds},
                                       {"frames_per_second", result.frames_per_second()},
                                       {"files", std::move(files)}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace gjkscope
