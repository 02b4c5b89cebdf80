#include "export/sheet.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <stdexcept>

#include "base/file.hpp"
#include "frames/frame.hpp"
#include "lesson/chapters.hpp"
#include "paint/canvas.hpp"
#include "paint/pdf.hpp"
#include "paint/png.hpp"
#include "paint/svg.hpp"
#include "picture/part.hpp"
#include "picture/text_box.hpp"
#include "run/graph.hpp"
#include "run/trail.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace {

constexpr TextStyle kSheetTitle{Face::bold, 40};
constexpr TextStyle kSheetHeading{Face::semibold, 24};
constexpr TextStyle kSheetBody{Face::regular, 20};
constexpr TextStyle kSheetStrong{Face::semibold, 20};
constexpr TextStyle kSheetSmall{Face::regular, 17};
constexpr double kMargin = 75.0;  // half an inch
constexpr double kLine = 27.0;
constexpr double kSmallLine = 23.0;
constexpr double kCaptionLines = 2.0;  // of a picture
constexpr double kGap = 24.0;
constexpr std::size_t kColumns = 3;    // of pictures
constexpr double kPictureShare = 0.7;  // height over width

/// Writes a page from top to bottom.
class SheetWriter {
 public:
  SheetWriter(const SheetContent& content, const Fonts& fonts, Paper paper)
      : content_(content), fonts_(fonts) {
    const auto [width, height] = sheet_size(paper);
    picture_.width = width;
    picture_.height = height;
    picture_.clip_corner = 6.0;
  }

  Picture picture() {
    y_ = kMargin + 30.0;
    write("title", kMargin, fmt::format("Chapter {}. {}", content_.chapter, content_.title),
          kSheetTitle);
    y_ += 20.0;
    heading("The rule");
    for (std::size_t i = 0; i < content_.words.rule.size(); ++i)
      item(fmt::format("{}", i + 1), content_.words.rule[i]);
    terms();
    pictures();
    heading("Pitfalls");
    for (const std::string& each : content_.words.pitfalls) item("–", each);
    lessons();
    if (y_ > picture_.height - kMargin) {
      throw std::runtime_error(fmt::format("the sheet of chapter {} is {:.0f} pixels too long",
                                           content_.chapter, y_ - picture_.height + kMargin));
    }
    return std::move(picture_);
  }

 private:
  [[nodiscard]] double width() const { return picture_.width - 2.0 * kMargin; }

  void write(const std::string& role, double x, const std::string& text, const TextStyle& style) {
    picture_.marks.push_back({role, Text{{x, y_}, text, style}});
  }
  void heading(const std::string& text) {
    y_ += kLine + 18.0;
    write("heading", kMargin, text, kSheetHeading);
    y_ += 8.0;
  }
  /// A sentence behind what is in front of all its lines.
  void item(const std::string& before, const std::string& text) {
    constexpr double kIndent = 32.0;
    y_ += 4.0;
    bool is_first = true;
    for (const std::string& line : wrapped(fonts_, kSheetBody, text, width() - kIndent)) {
      y_ += kLine;
      if (std::exchange(is_first, false)) write("strong", kMargin, before, kSheetStrong);
      write("body", kMargin + kIndent, line, kSheetBody);
    }
  }

  [[nodiscard]] const Lesson& lesson(const std::string& id) const {
    const auto found = std::find_if(content_.lessons.begin(), content_.lessons.end(),
                                    [&](const Lesson& each) { return each.id == id; });
    if (found == content_.lessons.end())
      throw std::runtime_error(fmt::format("there is no lesson '{}' for a sheet", id));
    return *found;
  }

  /// The terms that the chapter's lessons say first, in two columns.
  void terms() {
    std::vector<const CourseTerm*> own;
    for (const CourseTerm& term : content_.terms) {
      if (lesson(term.lesson).chapter == content_.chapter) own.push_back(&term);
    }
    if (own.empty()) return;
    heading("Terms");
    const double column = 0.5 * (width() - kGap);
    const double top = y_;
    std::array<double, 2> ends = {top, top};
    for (const CourseTerm* term : own) {
      const std::size_t at = ends[1] < ends[0] ? 1 : 0;
      const double x = kMargin + static_cast<double>(at) * (column + kGap);
      y_ = ends[at] + 4.0 + kLine;
      write("strong", x, term->name, kSheetStrong);
      for (const std::string& line : wrapped(fonts_, kSheetBody, term->sentence, column)) {
        y_ += kLine;
        write("body", x, line, kSheetBody);
      }
      ends[at] = y_;
    }
    y_ = *std::max_element(ends.begin(), ends.end());
  }

  void pictures() {
    if (!content_.words.trail.empty()) trail(lesson(content_.words.trail));
    if (content_.words.figures.empty()) return;
    heading("In pictures");
    std::size_t cell = 0;
    for (const auto& [id, step] : content_.words.figures) {
      Lesson shown = lesson(id);
      shown.questions.clear();
      // The second of two runs, and the first view of other lessons.
      const bool is_last = vocabulary().tour(shown.tour)->in_view != nullptr;
      shown.views = {is_last ? shown.views.back() : shown.views.front()};
      const LessonRun run = run_lesson(std::move(shown));
      if (step < 1 || step > static_cast<int>(run.frames.size()))
        throw std::runtime_error(fmt::format("'{}' has no frame {} for a sheet", id, step));
      EffectGraph effects(run);
      LessonPictures pictures(run, effects, fonts_, page(), LabelScope::frame);
      add(pictures.picture(step - 1), cell++, run.lesson.title);
    }
    end_row(cell);
  }

  /// A picture for each iteration of GJK, and its bounds.
  void trail(Lesson shown) {
    heading(fmt::format("A run at a glance: {}", shown.title));
    shown.tour = "phase";
    shown.questions.clear();
    shown.until.reset();
    shown.phases.clear();
    shown.settings = {};
    shown.views = {shown.views.back()};
    std::erase_if(shown.views.front().effects, [](const std::string& name) {
      return !find_term(vocabulary().effects, name)->table.empty();
    });
    const LessonRun run = run_lesson(std::move(shown));
    EffectGraph effects(run);
    const std::size_t cells = frames_of_trail(run).size() + 1;
    const Page page{.width = width(), .height = slot(cells - 1).max.y() - y_, .bare = true};
    LessonPictures pictures(run, effects, fonts_, page, LabelScope::frame);
    add_part(picture_, pictures.picture(static_cast<int>(run.frames.size()) - 1), {kMargin, y_});
    y_ += page.height;
  }

  /// The page of a picture, which holds the stage alone.
  [[nodiscard]] Page page() const {
    const Point size = slot(0).size();
    return {.width = size.x(), .height = size.y(), .bare = true};
  }

  [[nodiscard]] Rect slot(std::size_t cell) const {
    const double wide = (width() - kGap * (kColumns - 1)) / kColumns;
    const double high = kPictureShare * wide;
    const std::size_t row = cell / kColumns;
    const double x = kMargin + static_cast<double>(cell % kColumns) * (wide + kGap);
    const double y =
        y_ + 14.0 + static_cast<double>(row) * (high + kCaptionLines * kSmallLine + 20.0);
    return {{x, y}, {x + wide, y + high}};
  }

  void add(const Picture& part, std::size_t cell, const std::string& caption) {
    const Rect to = slot(cell);
    add_part(picture_, part, to.min);
    const double y = std::exchange(y_, to.max.y());
    for (const std::string& line : wrapped(fonts_, kSheetSmall, caption, to.size().x())) {
      y_ += kSmallLine;
      write("body.muted", to.min.x(), line, kSheetSmall);
    }
    y_ = y;
  }
  void end_row(std::size_t cells) {
    if (cells > 0) y_ = slot(cells - 1).max.y() + kCaptionLines * kSmallLine;
  }

  void lessons() {
    heading("Lessons");
    y_ += 4.0;
    std::string all;
    for (const Lesson& each : content_.lessons) {
      if (each.chapter == content_.chapter) all += (all.empty() ? "" : " · ") + each.title;
    }
    for (const std::string& line : wrapped(fonts_, kSheetSmall, all, width())) {
      y_ += kSmallLine;
      write("body.muted", kMargin, line, kSheetSmall);
    }
  }

  const SheetContent& content_;
  const Fonts& fonts_;
  Picture picture_;
  double y_ = 0.0;
};

}  // namespace

std::map<int, SheetWords> parse_sheets(std::string_view text, std::string_view name) {
  const auto fail = [&](const toml::source_region& at, std::string_view what) {
    throw std::runtime_error(
        fmt::format("{}:{}:{}: {}; expected [number of a chapter] with "
                    "'rule', 'pitfalls' and 'trail' or 'figures'",
                    name, at.begin.line, at.begin.column, what));
  };
  const auto text_in = [&](const toml::node& node) {
    const toml::value<std::string>* value = node.as_string();
    if (value == nullptr) fail(node.source(), "this is no text");
    return value->get();
  };
  std::map<int, SheetWords> sheets;
  try {
    for (const auto& [key, node] : toml::parse(text)) {
      const std::optional<int> number = chapter_number(key.str());
      if (!number || !node.is_table())
        fail(key.source(), fmt::format("'{}' is no chapter", key.str()));
      SheetWords& words = sheets[*number];
      for (const auto& [what, value] : *node.as_table()) {
        const toml::array* list = value.as_array();
        if (what == "trail") {
          words.trail = text_in(value);
        } else if (list == nullptr) {
          fail(what.source(), fmt::format("'{}' is not known here, or is no list", what.str()));
        } else if (what == "rule" || what == "pitfalls") {
          for (const toml::node& each : *list)
            (what == "rule" ? words.rule : words.pitfalls).push_back(text_in(each));
        } else if (what == "figures") {
          for (const toml::node& each : *list) {
            const toml::array* pair = each.as_array();
            if (pair == nullptr || pair->size() != 2 || !(*pair)[1].is_integer())
              fail(each.source(), "a figure is a lesson and the number of a frame");
            words.figures.emplace_back(text_in((*pair)[0]),
                                       static_cast<int>((*pair)[1].as_integer()->get()));
          }
        } else {
          fail(what.source(), fmt::format("'{}' is not known here", what.str()));
        }
      }
      if (words.rule.size() != 3 || words.pitfalls.empty())
        fail(node.source(), "a sheet has a rule of three sentences, and pitfalls");
    }
  } catch (const toml::parse_error& error) {
    fail(error.source(), error.description());
  }
  return sheets;
}

std::optional<Paper> paper_of(std::string_view name) {
  if (name == "a4") return Paper::a4;
  return name == "letter" ? std::optional(Paper::letter) : std::nullopt;
}

std::array<int, 2> sheet_size(Paper paper) {
  return paper == Paper::a4 ? std::array{1240, 1754} : std::array{1275, 1650};
}

Picture sheet_picture(const SheetContent& content, const Fonts& fonts, Paper paper) {
  return SheetWriter(content, fonts, paper).picture();
}

void write_sheet(int chapter, std::vector<Lesson> lessons, const SheetFile& options) {
  const auto asset = [&](const char* name) { return read_whole(options.assets_dir / name); };
  const auto sheets = parse_sheets(asset("sheets.toml"), "assets/sheets.toml");
  const auto titles = parse_chapters(asset("chapters.toml"), "assets/chapters.toml");
  const auto words = sheets.find(chapter);
  if (words == sheets.end() || !titles.contains(chapter)) {
    throw std::runtime_error(fmt::format("there is no sheet of chapter {}; there are {} to {}",
                                         chapter, sheets.begin()->first, sheets.rbegin()->first));
  }
  if (!options.force) refuse_foreign(options.file);
  const SheetContent content{chapter, titles.at(chapter), words->second,
                             parse_terms(asset("terms.toml"), "assets/terms.toml"),
                             std::move(lessons)};
  const Fonts fonts(options.assets_dir / "fonts.toml");
  const Theme theme = Theme::load(options.assets_dir / "themes", options.theme);
  const Picture picture = sheet_picture(content, fonts, options.paper);
  const std::string title = fmt::format("Chapter {}. {}", chapter, content.title);
  if (options.format == Format::svg) {
    write_whole(options.file, to_svg(picture, fonts, theme, title, signature()));
  } else if (options.format == Format::png) {
    const auto [width, height] = sheet_size(options.paper);
    Canvas canvas(fonts, theme, {.width = width, .height = height});
    write_whole(options.file,
                encode_png(canvas.paint(picture),
                           {{{"Software", signature()}, {"Title", title}}, kSheetDpi, false}));
  } else {
    write_whole(options.file, to_pdf({{picture, title, title, {}}}, fonts, theme,
                                     {title, signature(), {}}, {.scale = 72.0 / kSheetDpi}));
  }
}

}  // namespace gjkscope
