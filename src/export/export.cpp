#include "export/export.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <thread>

#include "base/file.hpp"
#include "export/contact_sheet.hpp"
#include "export/film.hpp"
#include "export/frame_writer.hpp"
#include "export/record.hpp"
#include "export/signal_watch.hpp"
#include "frames/frame.hpp"
#include "lesson/names.hpp"
#include "lesson/save.hpp"
#include "paint/canvas.hpp"
#include "paint/pdf.hpp"
#include "paint/png.hpp"
#include "paint/svg.hpp"
#include "picture/tween.hpp"
#include "run/graph.hpp"
#include "run/run.hpp"
#include "subjects/course_map/tiles.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace {

// A thumbnail; type below that has no pixels to stand on.
constexpr int kSmallestWidth = 160;
constexpr int kSmallestHeight = 90;
constexpr int kMostThreads = 64;
constexpr int kFilmRate = 25;  // images a second of a film in which nothing moves

/// Reports progress on stderr: one line for each lesson, or on a terminal one line that changes.
class Progress {
 public:
  Progress(const ExportOptions& options, std::size_t lesson_count)
      : wanted_(options.progress),
        on_progress_(options.on_progress),
        terminal_(::isatty(STDERR_FILENO) == 1),
        lesson_count_(lesson_count) {}

  void frame(std::size_t lesson, const std::string& id, int done, int count) {
    if (on_progress_) on_progress_(done, count);
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
  std::function<void(int done, int count)> on_progress_;
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
  if (options.handout < 0 || options.handout > kMostOnHandout) {
    throw std::runtime_error(fmt::format("a page of a handout has 1 to {} frames; asked for {}",
                                         kMostOnHandout, options.handout));
  }
  if (options.caption == CaptionPlace::file && !has_file_per_frame(options.format)) {
    throw std::runtime_error(fmt::format(
        "captions go into files beside those of png and svg, not of {}", name_of(options.format)));
  }
  if (options.transparent && is_film(options.format)) {
    throw std::runtime_error(fmt::format("{} cannot be transparent; png, svg, pdf and tex can",
                                         name_of(options.format)));
  }
  if (options.fps > 0 && !is_film(options.format) && !has_file_per_frame(options.format)) {
    throw std::runtime_error(
        fmt::format("png, svg and films can move; {} cannot", name_of(options.format)));
  }
  if (options.turn != 0.0 && !is_film(options.format))
    throw std::runtime_error(fmt::format("films can turn; {} cannot", name_of(options.format)));
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

/// `between`: which image on the way to the step, from 1; 0 is the step itself, which comes after.
std::string frame_name(const std::string& id, int step, Format format, int between) {
  const std::string_view ending = name_of(format);
  return between > 0 ? fmt::format("{}-{:04}-{:02}.{}", id, step, between, ending)
                     : fmt::format("{}-{:04}.{}", id, step, ending);
}

/// The PDF of pages for the slides in `tex`. LaTeX names its own PDF after the document.
std::filesystem::path pages_of(const std::filesystem::path& tex) {
  return tex.parent_path() / (tex.stem().string() + "-pages.pdf");
}

std::filesystem::path caption_file(std::filesystem::path frame) {
  return frame.replace_extension(".txt");
}

/// Images that are not among the `kept` are of an earlier export that had more.
void remove_stale_frames(const std::filesystem::path& folder, const std::string& id, Format format,
                         const std::set<std::filesystem::path>& kept) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(id + "-")) continue;
    int step = 0;
    int between = 0;
    const char* const end = name.data() + name.size();
    const char* const rest = std::from_chars(name.data() + id.size() + 1, end, step).ptr;
    if (rest != end && *rest == '-') std::from_chars(rest + 1, end, between);
    if (name == frame_name(id, step, format, between) && !kept.contains(entry.path()) &&
        is_exported(entry.path())) {
      std::filesystem::remove(entry.path(), ignored);
      if (is_exported(caption_file(entry.path()))) {
        std::filesystem::remove(caption_file(entry.path()), ignored);
      }
    }
  }
}

/// A sum over everything except the lesson that a file is made from.
Fingerprint fingerprint_of(const ExportOptions& options, const Fonts& fonts) {
  Fingerprint sum;
  // The program itself: a version number does not change with each change of a drawing.
  std::error_code none;
  const std::filesystem::path program = "/proc/self/exe";
  sum.add(std::filesystem::exists(program, none) ? read_whole(program) : signature());
  for (const FaceBytes& face : faces_of(fonts)) {
    for (const auto& file : {face.main, face.fallback}) {
      sum.add({reinterpret_cast<const char*>(file.data()), file.size()});
    }
  }
  for (const std::string& name : Theme::names(options.assets_dir / "themes")) {
    sum.add(read_whole(options.assets_dir / "themes" / (name + ".toml")));
  }
  sum.add(fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {}", name_of(options.format),
                      options.theme, options.width, options.height, options.scale, options.dpi,
                      options.transparent, options.stage_only, options.handout, options.seconds,
                      options.fps, options.turn, static_cast<int>(options.caption),
                      static_cast<int>(options.renderer)));
  return sum;
}

/// A document that shows the pages of the PDF beside it, one after the other.
std::string beamer(const std::string& pdf, const std::string& title,
                   const std::vector<RecordedFrame>& frames) {
  std::string overlays;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    std::string note;
    for (const char c : frames[i].caption) {
      if (std::string_view("\\{}").find(c) != std::string_view::npos) continue;
      if (std::string_view("#$%&_").find(c) != std::string_view::npos) note += '\\';
      note += c == '^' || c == '~' ? fmt::format("\\{}{{}}", c) : std::string(1, c);
    }
    overlays += fmt::format(
        "  \\only<{0}>{{\\includegraphics[page={0},width=\\paperwidth,height=\\paperheight,"
        "keepaspectratio]{{{1}}}}}%\n  \\note<{0}>{{{2}}}%\n",
        i + 1, pdf, note);
  }
  return fmt::format(
      "% {}. {}\n% Compile with lualatex or xelatex: notes have mathematical characters.\n"
      "\\documentclass[aspectratio=169]{{beamer}}\n"
      "\\usepackage{{fontspec}}\n\\setsansfont{{DejaVu Sans}}\n"
      "\\setbeamertemplate{{navigation symbols}}{{}}\n"
      "\\setbeamersize{{text margin left=0pt,text margin right=0pt}}\n"
      "\\begin{{document}}\n\\begin{{frame}}[plain]\n{}\\end{{frame}}\n\\end{{document}}\n",
      signature(), title, overlays);
}

/// A lesson on its way into files.
struct LessonJob {
  LessonRun run;
  std::vector<FrameText> texts;
  std::vector<Picture> pictures;  ///< None where all files are up to date.
  StepRange steps;
  std::string toml;
  Fingerprint made_from;

  [[nodiscard]] bool is_up_to_date() const { return pictures.empty(); }
  [[nodiscard]] RecordedFrame recorded(int step) const {
    const auto index = static_cast<std::size_t>(step - 1);
    RecordedFrame out{step, texts[index].caption, {}};
    with_case(run.run(run.frames[index]), [&](auto shapes) { out.shapes = std::move(shapes); });
    return out;
  }
  [[nodiscard]] Record record(std::string key, int first, int last) const {
    Record out{run.lesson.id, toml, std::move(key), {}};
    for (int step = first; step <= last; ++step) out.frames.push_back(recorded(step));
    return out;
  }
  /// `between`: which picture on the way to the step `last`, from 1.
  [[nodiscard]] std::string key(int first, int last, int between = 0) const {
    Fingerprint sum = made_from;
    sum.add(fmt::format("{}..{}, {}", first, last, between));
    return sum.hex();
  }
};

/// A lesson in space, seen from all around.
class Turntable {
 public:
  Turntable(const LessonRun& run, const Fonts& fonts, const Page& page)
      : page_(page), effects_(run), pictures_(run, effects_, fonts, page) {
    for (const LessonPictures::ShownView& view : pictures_.views())
      cameras_.push_back(CameraOverride{view.camera, view.card.size().x() / view.card.size().y()});
  }
  /// The lesson's own eye has walked around by so many degrees.
  void turn_to(double degrees) {
    CameraOverrides turned = cameras_;
    for (std::optional<CameraOverride>& seen : turned) seen->camera.eye->azimuth += degrees;
    pictures_.lay_out(page_, turned, LabelScope::frame, pictures_.is_stacked());
  }
  [[nodiscard]] Picture picture(int index) { return pictures_.picture(index); }

 private:
  Page page_;
  EffectGraph effects_;
  LessonPictures pictures_;
  CameraOverrides cameras_;
};

class Exporter {
 public:
  explicit Exporter(const ExportOptions& options)
      : options_(options),
        fonts_(options.assets_dir / "fonts.toml"),
        theme_(Theme::load(options.assets_dir / "themes", options.theme)),
        page_(page_of(options.width, options.height)),
        writer_(thread_count(options), [this] { return write_frame(); }),
        made_from_(fingerprint_of(options, fonts_)) {
    page_.bare = options.stage_only;
    page_.captions = options.caption == CaptionPlace::below;
    if (options.index) may_write(index_file());
  }

  /// Makes the lesson's files, or hands its frames to the writer. False when a signal came before
  /// the last one.
  bool add(const Lesson& lesson, std::size_t lesson_index, Progress& progress) {
    LessonJob job = run(lesson);
    const auto [first, last] = job.steps;
    const int count = last - first + 1;
    lesson_index_ = lesson_index;
    progress_ = &progress;
    const bool complete = has_file_per_frame(options_.format) ? add_frames(job) : add_document(job);
    if (!complete) return false;
    progress.lesson(lesson_index, lesson.id, count);
    describe(job);
    return true;
  }

  /// Writes the files that describe the frames, after the frames.
  void finish(ExportResult& result, bool complete) {
    writer_.finish();
    const std::set<std::filesystem::path> kept(files_.begin(), files_.end());
    for (const ExportedLesson& lesson : lessons_) {
      if (options_.file_name.empty()) write(sidecar_file(lesson.id), sidecar(lesson));
      if (!options_.first_step && !options_.last_step && options_.file_name.empty()) {
        remove_stale_frames(options_.out_dir, lesson.id, options_.format, kept);
      }
    }
    if (options_.index && complete) {
      write(index_file(),
            contact_sheet(lessons_, read_whole(options_.assets_dir / "contact-sheet.html")));
    }
    result.files = std::move(files_);
    result.frames = frame_count_;
    result.kept = kept_count_;
  }

 private:
  LessonJob run(const Lesson& lesson) {
    Lesson asked_for = lesson;
    if (!options_.questions) asked_for.questions.clear();
    LessonJob job{run_lesson(std::move(asked_for)), {}, {}, {}, {}, made_from_};
    for (const PositionedRun& positioned : job.run.runs) {
      if (const std::string why = why_not_drawn(positioned); !why.empty()) {
        throw std::runtime_error(
            fmt::format("{}: {}; `gjkscope check` says where", lesson.id, why));
      }
    }
    if (options_.turn != 0.0 && lesson.dimension == 2) {
      throw std::runtime_error(
          fmt::format("{}: its shapes are in the plane, which does not turn", lesson.id));
    }
    job.steps = step_range(options_, lesson.id, static_cast<int>(job.run.frames.size()));
    job.toml = lesson_toml(job.run.lesson);
    job.made_from.add(lesson.id);
    job.made_from.add(job.toml);
    if (const auto& file = lesson.settings.file) job.made_from.add(*file->text);
    EffectGraph effects(job.run);
    job.texts = lesson_texts(job.run, effects);
    // The files between two frames are known only once pictures are made.
    const bool has_more_files = options_.fps > 0 && has_file_per_frame(options_.format);
    if (is_up_to_date(job) && !has_more_files) return job;
    for (FramePicture& each : lesson_pictures(job.run, effects, fonts_, page_)) {
      leave_out_captions(each.picture);
      job.pictures.push_back(std::move(each.picture));
    }
    return job;
  }

  void leave_out_captions(Picture& picture) const {
    if (options_.caption == CaptionPlace::below) return;
    std::erase_if(picture.marks, [](const Mark& mark) {
      return mark.role.starts_with("caption") || mark.role == "detail";
    });
  }

  [[nodiscard]] std::filesystem::path file_of(const LessonJob& job, int step,
                                              int between = 0) const {
    const std::string& id = job.run.lesson.id;
    if (!options_.file_name.empty()) return options_.out_dir / options_.file_name;
    if (has_file_per_frame(options_.format)) {
      return options_.out_dir / frame_name(id, step, options_.format, between);
    }
    return options_.out_dir / fmt::format("{}.{}", id, name_of(options_.format));
  }
  [[nodiscard]] bool has(const std::filesystem::path& file, const std::string& key) const {
    return !options_.force && mentions(file, key);
  }
  /// Also refuses, before anything is drawn, to replace what was not exported.
  [[nodiscard]] bool is_up_to_date(const LessonJob& job) const {
    const auto [first, last] = job.steps;
    if (options_.file_name.empty()) may_write(sidecar_file(job.run.lesson.id));
    if (!has_file_per_frame(options_.format)) {
      may_write(file_of(job, first));
      if (options_.format == Format::tex) may_write(pages_of(file_of(job, first)));
      return has(file_of(job, first), job.key(first, last));
    }
    bool all = true;
    for (int step = first; step <= last; ++step) {
      may_write(file_of(job, step));
      if (options_.caption == CaptionPlace::file) may_write(caption_file(file_of(job, step)));
      all = all && has(file_of(job, step), job.key(step, step));
    }
    return all;
  }
  void may_write(const std::filesystem::path& file) const {
    if (!options_.force) refuse_foreign(file);
  }

  /// The files that describe frames.
  [[nodiscard]] std::filesystem::path sidecar_file(const std::string& id) const {
    return options_.out_dir / (id + ".json");
  }
  [[nodiscard]] std::filesystem::path index_file() const { return options_.out_dir / "index.html"; }

  bool add_frames(LessonJob& job) {
    const auto [first, last] = job.steps;
    for (int step = first; step <= last; ++step) {
      if (is_stopped()) return false;
      const auto at = static_cast<std::size_t>(step - 1);
      const std::filesystem::path file = file_of(job, step);
      if (job.is_up_to_date()) {
        files_.push_back(file);
        ++frame_count_;
        ++kept_count_;
      } else {
        int between = 0;
        for (const Picture& picture : on_the_way(job, step))
          add_image(job, step, picture, ++between);
        add_image(job, step, job.pictures[at]);
      }
      write_caption(file, job.texts[step - 1]);
      progress_->frame(lesson_index_, job.run.lesson.id, step - first + 1, last - first + 1);
    }
    return true;
  }

  [[nodiscard]] bool is_stopped() const {
    return options_.stop.stop_possible() ? options_.stop.stop_requested()
                                         : SignalWatch::signal() != 0;
  }

  void add_image(const LessonJob& job, int step, const Picture& picture, int between = 0) {
    const std::filesystem::path file = file_of(job, step, between);
    files_.push_back(file);
    ++frame_count_;
    const std::string key = job.key(step, step, between);
    if (has(file, key)) {
      ++kept_count_;
      return;
    }
    may_write(file);
    const FrameText& text = job.texts[step - 1];
    writer_.submit({picture, file, job.run.lesson.title, alternative_text(text),
                    record_text(job.record(key, step, step))});
  }
  /// For one thread.
  [[nodiscard]] FrameWriter::Write write_frame() const {
    if (options_.format == Format::svg) {
      return [this](const FrameJob& job) {
        write_bytes(job.path, to_svg(job.picture, fonts_, theme_, job.description, job.record,
                                     options_.transparent, page_.zoom));
      };
    }
    return [this, own = std::shared_ptr<Canvas>(canvas())](const FrameJob& job) {
      const PngWords words{{{"Software", signature()},
                            {"Title", job.title},
                            {"Description", job.description},
                            {kRecordKeyword, job.record}},
                           options_.dpi * options_.scale,
                           options_.transparent};
      write_whole(job.path, encode_png(own->paint(job.picture), words));
    };
  }

  /// The pictures between a step and the one before it; none where nothing moves.
  [[nodiscard]] std::vector<Picture> on_the_way(const LessonJob& job, int step) const {
    std::vector<Picture> out;
    if (step == job.steps.first) return out;
    const Picture& from = job.pictures[step - 2];
    const Picture& to = job.pictures[step - 1];
    const auto count = std::lround(kTweenSeconds * options_.fps);
    for (long i = 1; i < count; ++i) {
      out.push_back(tween(from, to, static_cast<double>(i) / static_cast<double>(count)));
      if (out.back() == to) return {};
    }
    return out;
  }

  bool add_document(LessonJob& job) {
    const auto [first, last] = job.steps;
    const std::filesystem::path file = file_of(job, first);
    const std::string key = job.key(first, last);
    const Record record = job.record(key, first, last);
    if (job.is_up_to_date()) {
      kept_count_ += last - first + 1;
    } else if (is_film(options_.format)) {
      if (!add_film(job, file, record_text(record))) return false;
    } else {
      write_document(job, file, record);
    }
    files_.push_back(file);
    frame_count_ += last - first + 1;
    return true;
  }

  void write_document(LessonJob& job, const std::filesystem::path& file, const Record& record) {
    std::vector<PdfFigure> figures;
    for (const RecordedFrame& frame : record.frames) {
      const auto index = static_cast<std::size_t>(frame.step - 1);
      const FrameText& text = job.texts[index];
      figures.push_back({std::move(job.pictures[index]),
                         fmt::format("{} {}", job.run.lesson.id, frame.step),
                         fmt::format("{}. {}", frame.step, text.position),
                         fmt::format("{}. {}", frame.step, alternative_text(text))});
    }
    const double points = options_.dpi > 0.0 ? 72.0 / options_.dpi : 1.0;
    const std::string pdf =
        to_pdf(figures, fonts_, theme_,
               {job.run.lesson.title, fmt::format("{} from {}", signature(), record.key),
                record_text(record)},
               {points * options_.scale, options_.handout, options_.transparent});
    if (options_.format == Format::pdf) return write_bytes(file, pdf);
    const std::filesystem::path pages = pages_of(file);
    write_bytes(pages, pdf);
    files_.push_back(pages);
    // The key is in both: without its pages the document is out of date.
    write_bytes(file, beamer(pages.filename().string(), job.run.lesson.title, record.frames) +
                          fmt::format("% {}\n", record.key));
  }

  bool add_film(const LessonJob& job, const std::filesystem::path& file,
                const std::string& record) {
    const auto [first, last] = job.steps;
    if (!canvas_) canvas_ = canvas();
    Image image;
    std::unique_ptr<Film> film;
    const auto show = [&](const Picture& picture, double seconds) {
      canvas_->paint(picture, image);
      if (!film) film = film_of(file, image, {record, job.run.lesson.title});
      film->add(image, seconds);
    };
    std::optional<Turntable> turntable;
    if (options_.turn != 0.0) turntable.emplace(job.run, fonts_, page_);
    for (int step = first; step <= last; ++step) {
      if (is_stopped()) return false;
      const double seconds = step == last ? 2.0 * options_.seconds : options_.seconds;
      if (turntable) {
        if (!add_turning(*turntable, job.steps, step, seconds, show)) return false;
      } else {
        for (const Picture& picture : on_the_way(job, step)) show(picture, 1.0 / options_.fps);
        show(job.pictures[step - 1], seconds);
      }
      progress_->frame(lesson_index_, job.run.lesson.id, step - first + 1, last - first + 1);
    }
    if (is_stopped()) return false;
    film->finish();
    return true;
  }

  /// One step of a film in which the eye walks at constant speed from the first image to the last.
  template <class Show>
  bool add_turning(Turntable& turntable, const StepRange& steps, int step, double seconds,
                   const Show& show) {
    const double rate = film_rate();
    const long between = step == steps.first ? 0 : std::lround(kTweenSeconds * rate);
    const long images = between + std::lround(seconds * rate);
    const double whole = options_.seconds * (steps.last - steps.first + 2) +
                         kTweenSeconds * (steps.last - steps.first);
    const double begin = (options_.seconds + kTweenSeconds) * (step - steps.first) -
                         (step == steps.first ? 0.0 : kTweenSeconds);
    for (long i = 0; i < images; ++i) {
      if (is_stopped()) return false;
      turntable.turn_to(options_.turn * (begin + static_cast<double>(i) / rate) / whole);
      Picture picture = turntable.picture(step - 1);
      if (i < between) {
        picture = tween(turntable.picture(step - 2), picture,
                        static_cast<double>(i + 1) / static_cast<double>(between + 1));
      }
      leave_out_captions(picture);
      show(picture, 1.0 / rate);
    }
    return true;
  }
  [[nodiscard]] int film_rate() const { return options_.fps > 0 ? options_.fps : kFilmRate; }

  [[nodiscard]] std::unique_ptr<Film> film_of(const std::filesystem::path& file, const Image& image,
                                              const FilmWords& words) const {
    if (options_.format == Format::gif)
      return gif_film(file, image.width, image.height, theme_, words);
    if (options_.format == Format::apng) return apng_film(file, words);
    return ffmpeg_film(file, std::string(name_of(options_.format)), image.width, image.height,
                       film_rate(), words, options_.stop);
  }

  [[nodiscard]] std::unique_ptr<Canvas> canvas() const {
    const auto pixels = [&](int length) {
      return std::max(1, static_cast<int>(std::lround(length * options_.scale)));
    };
    CanvasOptions more;
    more.width = pixels(options_.width);
    more.height = pixels(options_.height);
    more.zoom = page_.zoom * options_.scale;
    more.transparent = options_.transparent;
    more.renderer = options_.renderer;
    return std::make_unique<Canvas>(fonts_, theme_, more);
  }

  void describe(LessonJob& job) {
    const Lesson& lesson = job.run.lesson;
    ExportedLesson exported{lesson.id,
                            lesson.title,
                            lesson.chapter,
                            lesson.source,
                            options_.theme,
                            options_.width,
                            options_.height,
                            static_cast<int>(job.texts.size()),
                            {},
                            {}};
    for (int step = job.steps.first; step <= job.steps.last; ++step) {
      exported.frames.push_back(
          {step, file_of(job, step).filename().string(), std::move(job.texts[step - 1])});
    }
    if (options_.index && lesson.tour == "course-map") {
      EffectGraph effects(job.run);
      LessonPictures pictures(job.run, effects, fonts_, page_);
      exported.tiles = tiles_of_map(pictures.picture(job.steps.last - 1));
      for (Rect& tile : exported.tiles) {
        tile.min *= page_.zoom;
        tile.max *= page_.zoom;
      }
    }
    lessons_.push_back(std::move(exported));
  }

  void write_caption(const std::filesystem::path& frame, const FrameText& text) {
    if (options_.caption != CaptionPlace::file) return;
    const std::filesystem::path file = caption_file(frame);
    write_bytes(file, fmt::format("{}\n\n{}\n", alternative_text(text), signature()));
    files_.push_back(file);
  }
  static void write_bytes(const std::filesystem::path& file, std::string_view bytes) {
    write_whole(file, std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
  }
  void write(const std::filesystem::path& file, const std::string& text) {
    write_whole(file, text);
    files_.push_back(file);
  }

  const ExportOptions& options_;
  Fonts fonts_;
  Theme theme_;
  Page page_;
  std::unique_ptr<Canvas> canvas_;  ///< For films; made when the first frame is painted.
  FrameWriter writer_;
  Fingerprint made_from_;
  Progress* progress_ = nullptr;
  std::size_t lesson_index_ = 0;
  std::vector<ExportedLesson> lessons_;
  std::vector<std::filesystem::path> files_;
  int frame_count_ = 0;
  int kept_count_ = 0;
};

}  // namespace

ExportResult export_lessons(const std::vector<Lesson>& lessons, const ExportOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  check(options);
  remove_leftovers(options.out_dir);

  std::optional<SignalWatch> watch;
  if (!options.stop.stop_possible()) watch.emplace();
  Exporter exporter(options);
  Progress progress(options, lessons.size());
  bool complete = true;
  for (std::size_t i = 0; i < lessons.size() && complete; ++i) {
    complete = exporter.add(lessons[i], i, progress);
  }
  ExportResult result;
  exporter.finish(result, complete);
  result.is_complete = complete;
  result.signal = complete || !watch ? 0 : SignalWatch::signal();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

std::string to_json(const ExportResult& result) {
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (const auto& file : result.files) files.push_back(file.string());
  const nlohmann::ordered_json json = {{"frames", result.frames},
                                       {"kept", result.kept},
                                       {"seconds", result.seconds},
                                       {"frames_per_second", result.frames_per_second()},
                                       {"files", std::move(files)}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace gjkscope
