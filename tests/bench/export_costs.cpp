// The cost of exports, as ratios within one run: PNG sequences of all lessons against drawing and
// encoding one plain frame on one core, the same frame by matplotlib, SVG, memory at 3840 x 2160,
// and twice and four times as many frames. Each is measured in a process of its own, in turns.

#include <fmt/format.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "document.hpp"
#include "export/export.hpp"
#include "paint/canvas.hpp"
#include "paint/png.hpp"
#include "paint/svg.hpp"
#include "run/run.hpp"
#include "sample_picture.hpp"
#include "shipped_lessons.hpp"
#include "study/interleave.hpp"
#include "subjects/subjects.hpp"

namespace {

using namespace gjkscope;
namespace fs = std::filesystem;

const fs::path kSource = GJKSCOPE_SOURCE_DIR;
constexpr int kPlainFrames = 20;
constexpr int kMatplotlibFrames = 3;

double seconds_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

struct Measured {
  double seconds = 0.0;
  double processor = 0.0;  ///< Seconds of processors that the process took.
  double megabytes = 0.0;  ///< The most memory that it had.
};

/// The result of `work` in a process of its own: a renderer's threads and memory are then those
/// that it needs itself.
Measured in_process(const std::function<double()>& work) {
  std::array<int, 2> ends = {};
  if (::pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    const double seconds = work();
    ::_exit(::write(ends[1], &seconds, sizeof seconds) == sizeof seconds ? 0 : 1);
  }
  ::close(ends[1]);
  Measured out;
  const bool was_read = ::read(ends[0], &out.seconds, sizeof out.seconds) == sizeof out.seconds;
  ::close(ends[0]);
  rusage usage = {};
  int status = 0;
  ::wait4(child, &status, 0, &usage);
  if (!was_read || status != 0) throw std::runtime_error("a measured process failed");
  for (const timeval& time : {usage.ru_utime, usage.ru_stime}) {
    out.processor += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }
  out.megabytes = static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e6;
  return out;
}

void stay_on_one_core() {
  cpu_set_t set;
  ::sched_getaffinity(0, sizeof set, &set);
  int first = 0;
  while (!CPU_ISSET(first, &set)) ++first;
  CPU_ZERO(&set);
  CPU_SET(first, &set);
  ::sched_setaffinity(0, sizeof set, &set);
}

class Bench {
 public:
  explicit Bench(const fs::path& folder)
      : folder_(folder),
        lessons_(bench::shipped_lessons()),
        fonts_(kSource / "assets" / "fonts.toml"),
        theme_(Theme::load(kSource / "assets" / "themes", "light")) {
    write_whole(folder_ / "plain.svg",
                std::string_view(to_svg(sample::picture(), fonts_, theme_, "")));
  }

  /// Seconds to draw and encode the plain frame on one core.
  [[nodiscard]] double plain() const {
    return in_process([&] {
             stay_on_one_core();
             Canvas canvas(fonts_, theme_, {});
             const Picture picture = sample::picture();
             Image image;
             std::size_t bytes = 0;
             const auto draw = [&] {
               canvas.paint(picture, image);
               bytes += encode_png(image).size();
             };
             draw();
             // Processor time: on one core, the time that it takes when nobody else is there.
             const std::clock_t begin = std::clock();
             for (int i = 0; i < kPlainFrames; ++i) draw();
             const auto ticks = static_cast<double>(std::clock() - begin);
             return bytes > 0 ? ticks / CLOCKS_PER_SEC / kPlainFrames : 0.0;
           })
        .seconds;
  }

  /// The same by matplotlib; nothing where there is none.
  [[nodiscard]] std::optional<double> matplotlib() const {
    const std::string command = fmt::format(
        "taskset -c 0 /usr/bin/python3 '{}' '{}' '{}' {} 2>&1",
        (kSource / "tests" / "bench" / "matplotlib_figure.py").string(),
        (folder_ / "plain.svg").string(), (folder_ / "plain.png").string(), kMatplotlibFrames);
    std::FILE* const pipe = ::popen(command.c_str(), "r");
    double seconds = 0.0;
    const bool was_read = pipe && std::fscanf(pipe, "%lf", &seconds) == 1;
    if (!pipe || ::pclose(pipe) != 0 || !was_read) return std::nullopt;
    return seconds;
  }

  /// Seconds a frame of all lessons, from lesson to file, on all processors.
  [[nodiscard]] Measured all(Format format) const { return exported(lessons_, format, 1280, 720); }
  /// Megabytes of the program itself, which is beside this one.
  [[nodiscard]] double at_4k() const {
    const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "gjkscope";
    const std::string command = fmt::format(
        "'{}' export polygons-gjk --size 3840x2160 --steps 1..8 --force --json --out "
        "'{}' >/dev/null",
        program.string(), (folder_ / "4k").string());
    const auto run = [&] { return static_cast<double>(std::system(command.c_str())); };
    const Measured found = in_process(run);
    fs::remove_all(folder_ / "4k");
    if (found.seconds != 0.0) throw std::runtime_error("failed: " + command);
    return found.megabytes;
  }
  /// The seconds for a lesson that is exported `times` times.
  [[nodiscard]] double repeated(int times) const {
    return exported(std::vector<Lesson>(static_cast<std::size_t>(times), named("polygons-gjk")),
                    Format::png, 1280, 720)
        .seconds;
  }

 private:
  [[nodiscard]] const Lesson& named(const std::string& id) const {
    for (const Lesson& lesson : lessons_) {
      if (lesson.id == id) return lesson;
    }
    throw std::runtime_error("there is no lesson " + id);
  }
  [[nodiscard]] Measured exported(const std::vector<Lesson>& lessons, Format format, int width,
                                  int height) const {
    ExportOptions options;
    options.out_dir = folder_ / "out";
    options.assets_dir = kSource / "assets";
    options.format = format;
    options.width = width;
    options.height = height;
    options.force = true;
    Measured out = in_process(
        [&] { return seconds_of([&] { static_cast<void>(export_lessons(lessons, options)); }); });
    fs::remove_all(options.out_dir);
    int frames = 0;
    for (const Lesson& lesson : lessons) {
      frames += static_cast<int>(run_lesson(lesson).frames.size());
    }
    out.seconds /= frames;
    out.processor /= frames;
    return out;
  }

  fs::path folder_;
  std::vector<Lesson> lessons_;
  Fonts fonts_;
  Theme theme_;
};

struct Turns {
  std::vector<double> plain, png, sequence, processor, svg, matplotlib, speedup, megabytes, once,
      twice, four;
};

std::string row(const std::string& what, const std::vector<double>& values, double unit,
                const std::string& wanted) {
  if (values.empty()) return fmt::format("| {} | not measured | | {} |\n", what, wanted);
  const study::Quartiles q = study::quartiles(values);
  return fmt::format("| {} | {:.3g} | {:.3g} to {:.3g} | {} |\n", what, q.median * unit,
                     q.low * unit, q.high * unit, wanted);
}

std::string table(const Turns& turns) {
  return "| | median | quartiles | wanted |\n|---|--:|--:|--:|\n" +
         row("plain frame, drawn and encoded on one core, ms", turns.plain, 1e3, "") +
         row("PNG of all lessons on all processors, ms a frame", turns.png, 1e3, "") +
         row("... as a share of the plain frame", turns.sequence, 1.0, "≤ 0.8") +
         row("... of the processors, all together", turns.processor, 1.0, "") +
         row("plain frame by matplotlib on one core, ms", turns.matplotlib, 1e3, "") +
         row("... in plain frames", turns.speedup, 1.0, "≥ 10") +
         row("SVG of all lessons, frames a second", turns.svg, 1.0, "≥ 500") +
         row("most memory at 3840 x 2160, MB", turns.megabytes, 1.0, "< 300") +
         row("a frame, where there are twice as many, against once", turns.twice, 1.0, "≈ 1") +
         row("a frame, where there are four times as many", turns.four, 1.0, "≈ 1");
}

Turns measure(const Bench& bench, int repetitions) {
  Turns turns;
  for (int i = 0; i < repetitions; ++i) {
    turns.plain.push_back(bench.plain());
    const Measured png = bench.all(Format::png);
    turns.png.push_back(png.seconds);
    turns.sequence.push_back(png.seconds / turns.plain.back());
    turns.processor.push_back(png.processor / turns.plain.back());
    if (const std::optional<double> seconds = bench.matplotlib()) {
      turns.matplotlib.push_back(*seconds);
      turns.speedup.push_back(*seconds / turns.plain.back());
    }
    turns.svg.push_back(1.0 / bench.all(Format::svg).seconds);
    turns.megabytes.push_back(bench.at_4k());
    turns.once.push_back(bench.repeated(1));
    turns.twice.push_back(bench.repeated(2) / turns.once.back());
    turns.four.push_back(bench.repeated(4) / turns.once.back());
  }
  return turns;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("What `gjkscope export` costs", "export-costs");
  int repetitions = 5;
  std::string document;
  app.add_option("--repetitions", repetitions, "Turns")->capture_default_str();
  app.add_option("--write", document, "Put the table into this document");
  CLI11_PARSE(app, argc, argv);
  const fs::path folder =
      fs::temp_directory_path() / fmt::format("gjkscope-export-costs-{}", ::getpid());
  try {
    double load = 0.0;
    ::getloadavg(&load, 1);
    fs::create_directories(folder);
    const std::string found = table(measure(Bench(folder), repetitions));
    std::fputs(found.c_str(), stdout);
    if (!document.empty()) {
      bench::write_section(
          document, "export-costs",
          fmt::format(
              "Made by `export-costs --repetitions {} --write {}`, {} processors, for which "
              "{:.1f} others waited when it began.\n\n{}",
              repetitions, document, ::sysconf(_SC_NPROCESSORS_ONLN), load, found));
    }
    fs::remove_all(folder);
    return 0;
  } catch (const std::exception& error) {
    fs::remove_all(folder);
    fmt::print(stderr, "export-costs: {}\n", error.what());
    return 1;
  }
}
