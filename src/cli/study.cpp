// `gjkscope study`.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ostream>
#include <stdexcept>

#include "base/file.hpp"
#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "export/signal_watch.hpp"
#include "lesson/case.hpp"
#include "paint/canvas.hpp"
#include "paint/png.hpp"
#include "paint/svg.hpp"
#include "study/accuracy_figures.hpp"
#include "study/model_times.hpp"
#include "study/report.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace {

namespace fs = std::filesystem;

/// The cases of tests/hard-cases, in the order of their names.
std::vector<Case> reported_cases(const Environment& env) {
  std::vector<fs::path> files;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(env.share / "tests" / "hard-cases", none)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<Case> out;
  for (const fs::path& file : files) {
    const std::optional<std::string> text = read_text(env, file.string());
    if (!text) continue;
    for (ReadCase& read : parse_cases(*text, file.string())) {
      if (read.value) out.push_back(std::move(*read.value));
    }
  }
  if (out.empty()) env.err << "gjkscope: there are no reported cases; their family is left out\n";
  return out;
}

/// Reports progress and the time that is left: one line for each family or lesson, or on a terminal
/// one line that changes.
class Progress {
 public:
  explicit Progress(std::ostream& err) : err_(err), terminal_(::isatty(STDERR_FILENO) == 1) {}
  ~Progress() {
    if (terminal_) err_ << "\r\033[K" << std::flush;
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void tell(double share, const std::string& what) {
    const Clock::time_point now = Clock::now();
    const bool is_new = what != what_;
    if (!is_new && (!terminal_ || now - last_ < std::chrono::milliseconds(100))) return;
    last_ = now;
    what_ = what;
    const double passed = std::chrono::duration<double>(now - begin_).count();
    const std::string left =
        share > 0.02 ? fmt::format(", about {:.0f} s left", passed * (1 - share) / share) : "";
    if (!terminal_) {
      err_ << fmt::format("{:3.0f} % {}{}\n", 100 * share, what, left) << std::flush;
      return;
    }
    constexpr std::size_t kCells = 30;
    const auto full = static_cast<std::size_t>(share * kCells);
    err_ << fmt::format("\r\033[K[{}{}] {:3.0f} % {}{}", std::string(full, '#'),
                        std::string(kCells - full, '.'), 100 * share, what, left)
         << std::flush;
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::ostream& err_;
  bool terminal_;
  std::string what_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_ = begin_;
};

/// Made before anything is measured, so that minutes are not lost to a folder that cannot be.
void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) {
    throw std::runtime_error(fmt::format("cannot make the folder {}: {}", folder.string(),
                                         error ? error.message() : "there is a file"));
  }
}

/// Writes figures as PNG and SVG. Made before anything is measured, for the same reason.
class FigureWriter {
 public:
  explicit FigureWriter(const Environment& env)
      : fonts_(env.share / "assets" / "fonts.toml"),
        theme_(Theme::load(env.share / "assets" / "themes", "light")) {}

  void write(const study::Study& study, const fs::path& folder) const {
    make_folder(folder);
    const std::vector<Figure> figures = accuracy_figures(study, fonts_);
    if (figures.empty()) return;
    const Picture& first = figures.front().picture;
    CanvasOptions size;
    size.width = static_cast<int>(first.width);
    size.height = static_cast<int>(first.height);
    Canvas canvas(fonts_, theme_, size);
    for (const Figure& figure : figures) {
      const std::vector<std::uint8_t> png = encode_png(canvas.paint(figure.picture));
      write_whole(folder / (figure.name + ".png"), png);
      write_whole(folder / (figure.name + ".svg"),
                  to_svg(figure.picture, fonts_, theme_, figure.title));
    }
  }

 private:
  Fonts fonts_;
  Theme theme_;
};

}  // namespace

int study_accuracy_command(const Environment& env, const StudyOptions& options) {
  std::string page;
  std::optional<FigureWriter> figures;
  if (!options.out_dir.empty()) {
    make_folder(options.out_dir);
    figures.emplace(env);
    const std::optional<std::string> read =
        read_text(env, (env.share / "assets" / "accuracy.html").string());
    if (!read) return kCannot;
    page = *read;
  }
  if (options.advice.has_parent_path()) make_folder(options.advice.parent_path());
  if (options.advice.extension() == ".csv") {
    env.err
        << "gjkscope study: --advice is the name of the text; its numbers go beside it, as .csv\n";
    return kUsage;
  }

  study::Plan plan = study::plan(options.quick);
  plan.seed = options.seed;
  plan.reported = reported_cases(env);
  plan.families = options.families;
  const SignalWatch watch;
  const study::Study found = [&] {
    Progress progress(env.err);
    return study::study_accuracy(
        plan, {[] { return SignalWatch::signal() == 0; },
               [&](double share, const std::string& what) { progress.tell(share, what); }});
  }();

  if (!options.out_dir.empty()) {
    write_whole(options.out_dir / "accuracy.csv", study::to_csv(found));
    write_whole(options.out_dir / "accuracy.json", study::to_json(found));
    write_whole(options.out_dir / "accuracy.html", study::page(found, page));
    figures->write(found, options.out_dir / "figures");
  }
  if (!options.advice.empty()) {
    const study::Study summary = study::summary(found);
    write_whole(options.advice, study::advice(summary));
    write_whole(fs::path(options.advice).replace_extension(".csv"), study::to_csv(summary));
  }
  env.out << study::table(found)
          << fmt::format("\n{} rows in {:.1f} s, seed {}{}\n", found.rows.size(), found.seconds,
                         found.seed,
                         options.out_dir.empty() ? "" : ", in " + options.out_dir.string());
  const bool written = flushed(env);
  if (!found.complete) {
    env.err << fmt::format("gjkscope: interrupted; {} of {} families are in the results\n",
                           study::by_family(found.rows).size(), found.families_planned);
    return kSignalBase + SignalWatch::signal();
  }
  return written ? kDone : kCannot;
}

int study_models_command(const Environment& env, LessonChoice choice, const StudyOptions& options) {
  choice.all = choice.names.empty();
  const FoundLessons found = find_lessons(env, choice);
  if (found.exit_code != kDone) return found.exit_code;
  if (!options.out_dir.empty()) make_folder(options.out_dir);

  const int turns = options.quick ? 3 : 15;
  const SignalWatch watch;
  const auto go_on = [] { return SignalWatch::signal() == 0; };
  std::vector<ModelTimes> rows;
  {
    Progress progress(env.err);
    for (std::size_t i = 0; i < found.lessons.size() && go_on(); ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(found.lessons.size());
      progress.tell(share, found.lessons[i].id);
      const std::vector<ModelTimes> more = model_times(found.lessons[i], turns, go_on);
      rows.insert(rows.end(), more.begin(), more.end());
    }
  }
  if (!options.out_dir.empty())
    write_whole(options.out_dir / "models.toml", model_times_toml(rows));
  env.out << model_times_table(rows);
  const bool written = flushed(env);
  if (!go_on()) {
    env.err << "gjkscope: interrupted; this is what there was\n";
    return kSignalBase + SignalWatch::signal();
  }
  return written ? kDone : kCannot;
}

}  // namespace gjkscope
