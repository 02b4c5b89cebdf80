#include "export/work_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/file.hpp"
#include "frames/frame.hpp"
#include "lesson/chapters.hpp"
#include "paint/pdf.hpp"
#include "picture/part.hpp"
#include "picture/text_box.hpp"
#include "run/graph.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace work_sheets {

constexpr TextStyle kTitle{Face::bold, 30};
constexpr TextStyle kBody{Face::regular, 19};
constexpr TextStyle kStrong{Face::semibold, 19};
constexpr TextStyle kSmall{Face::regular, 17};
constexpr double kMargin = 75.0;  // half an inch
constexpr double kHead = 70.0;    // the title of a page
constexpr double kLine = 24.0;
constexpr double kSmallLine = 21.0;
constexpr double kGap = 36.0;          // between columns
constexpr double kIndent = 42.0;       // of words behind a number
constexpr double kPictureShare = 0.5;  // height over width
constexpr double kTick = 15.0;         // side of a box to tick
constexpr std::size_t kColumns = 2;
constexpr std::size_t kRows = 3;
constexpr std::size_t kOnPage = kColumns * kRows;

/// Writes tasks, or answers, page by page.
class Writer {
 public:
  Writer(const WorkSheet& sheet, const Fonts& fonts, Paper paper)
      : sheet_(sheet), fonts_(fonts), size_(sheet_size(paper)) {}

  std::vector<Picture> pages() {
    for (const bool answers : {false, true}) {
      for (std::size_t i = 0; i < sheet_.tasks.size(); ++i) {
        if (i % kOnPage == 0) begin_page(answers, i);
        begin_slot(i % kOnPage);
        draw(sheet_.tasks[i], answers);
        answers ? answer(i) : task(i);
      }
    }
    return std::move(pages_);
  }

 private:
  void begin_page(bool answers, std::size_t first) {
    Picture& page = pages_.emplace_back();
    page.width = size_[0];
    page.height = size_[1];
    page.clip_corner = 6.0;
    x_ = kMargin;
    y_ = kMargin + 24.0;
    write("title",
          fmt::format("{}: chapter {}. {}", answers ? "Answers" : "Practice", sheet_.chapter,
                      sheet_.title),
          kTitle);
    const std::size_t last = std::min(first + kOnPage, sheet_.tasks.size());
    Text where{
        {page.width - kMargin, y_},
        fmt::format("{} to {} of {} · seed {}", first + 1, last, sheet_.tasks.size(), sheet_.seed),
        kSmall};
    where.align = Align::right;
    page.marks.push_back({"body.muted", std::move(where)});
  }

  void begin_slot(std::size_t cell) {
    const Picture& page = pages_.back();
    width_ = (page.width - 2.0 * kMargin - kGap * (kColumns - 1)) / kColumns;
    const double high = (page.height - 2.0 * kMargin - kHead) / kRows;
    x_ = kMargin + static_cast<double>(cell % kColumns) * (width_ + kGap);
    const std::size_t row = cell / kColumns;
    y_ = kMargin + kHead + static_cast<double>(row) * high;
  }

  /// The frame that asks, or the one that tells.
  void draw(const practice::Task& task, bool answers) {
    const LessonRun run = run_lesson(task.lesson);
    EffectGraph effects(run);
    const Page page{.width = width_, .height = kPictureShare * width_, .bare = true};
    LessonPictures pictures(run, effects, fonts_, page, LabelScope::frame);
    add_part(pages_.back(), pictures.picture(answers ? task.telling : task.asking), {x_, y_});
    y_ += page.height + 4.0;
  }

  void write(const std::string& role, const std::string& text, const TextStyle& style,
             double indent = 0.0) {
    pages_.back().marks.push_back({role, Text{{x_ + indent, y_}, text, style}});
  }
  void lines(const std::string& role, const std::string& text, const TextStyle& style,
             double line) {
    for (const std::string& each : wrapped(fonts_, style, text, width_ - kIndent)) {
      y_ += line;
      write(role, each, style, kIndent);
    }
  }
  void number(std::size_t task) {
    y_ += kLine;
    write("strong", fmt::format("{}.", task + 1), kStrong);
    y_ -= kLine;
  }

  void task(std::size_t i) {
    const practice::Task& task = sheet_.tasks[i];
    number(i);
    lines("body", task.question, kBody, kLine);
    y_ += 3.0;
    given(task.given);
    y_ += 3.0;
    if (task.choices.empty()) {
      answer_line();
    } else {
      choices(task.choices);
    }
  }

  /// Words in rows, none of them broken; `mark` is called for each before it is written.
  template <class Mark>
  void in_rows(const std::vector<std::string>& words, double before, double line, const Mark& mark,
               const TextStyle& style) {
    constexpr double kApart = 22.0;
    double at = kIndent;
    y_ += line;
    for (const std::string& word : words) {
      const double wide = before + fonts_.width(style, word);
      if (at > kIndent && at + wide > width_) {
        at = kIndent;
        y_ += line;
      }
      mark(at);
      write("body", word, style, at + before);
      at += wide + kApart;
    }
  }
  void given(const std::vector<std::string>& given) {
    in_rows(
        given, 0.0, kSmallLine, [](double) {}, kSmall);
  }
  void choices(const std::vector<std::string>& choices) {
    const auto box = [&](double at) {
      const Point low(x_ + at, y_ - kTick + 2.0);
      pages_.back().marks.push_back(
          {"grid.axis", Polyline{{low, low + Point(kTick, 0.0), low + Point(kTick, kTick),
                                  low + Point(0.0, kTick)},
                                 true}});
    };
    in_rows(choices, kTick + 7.0, kLine + 2.0, box, kBody);
  }
  void answer_line() {
    y_ += kLine + 8.0;
    write("body.muted", "Answer", kSmall, kIndent);
    const double from = x_ + kIndent + fonts_.width(kSmall, "Answer") + 10.0;
    pages_.back().marks.push_back(
        {"grid.axis", Polyline{{{from, y_ + 2.0}, {x_ + width_, y_ + 2.0}}}});
  }

  void answer(std::size_t i) {
    const practice::Task& task = sheet_.tasks[i];
    number(i);
    lines("strong", task.answer, kStrong, kLine);
    lines("body", task.reason, kSmall, kSmallLine);
    lines("body.muted", fmt::format("Kind: {}", task.kind->name), kSmall, kSmallLine);
  }

  const WorkSheet& sheet_;
  const Fonts& fonts_;
  std::array<int, 2> size_;
  std::vector<Picture> pages_;
  double x_ = 0.0;
  double y_ = 0.0;
  double width_ = 0.0;
};

}  // namespace work_sheets

std::vector<Picture> work_sheet_pages(const WorkSheet& sheet, const Fonts& fonts, Paper paper) {
  return work_sheets::Writer(sheet, fonts, paper).pages();
}

void write_work_sheet(int chapter, int count, std::uint64_t seed, const WorkSheetFile& options) {
  if (!options.force) refuse_foreign(options.file);
  const auto titles =
      parse_chapters(read_whole(options.assets_dir / "chapters.toml"), "assets/chapters.toml");
  const WorkSheet sheet{chapter, titles.at(chapter), seed,
                        practice::make_tasks(chapter, count, seed)};
  const Fonts fonts(options.assets_dir / "fonts.toml");
  const Theme theme = Theme::load(options.assets_dir / "themes", options.theme);
  const std::string title = fmt::format("Practice: chapter {}. {}", chapter, sheet.title);
  std::vector<Picture> pages = work_sheet_pages(sheet, fonts, options.paper);
  const std::size_t of_tasks = pages.size() / 2;
  std::vector<PdfFigure> figures;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    figures.push_back(
        {std::move(pages[i]),
         fmt::format("{}", i + 1),
         fmt::format("{}, page {}", i < of_tasks ? "Tasks" : "Answers", i % of_tasks + 1),
         {}});
  }
  write_whole(options.file,
              to_pdf(figures, fonts, theme, {title, signature(), {}}, {.scale = 72.0 / kSheetDpi}));
}

}  // namespace gjkscope
