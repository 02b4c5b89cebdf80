// The command line of gjkscope: its arguments, and the command that runs them.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "base/file.hpp"
#include "cli/commands.hpp"
#include "lesson/names.hpp"
#include "lesson/problem.hpp"
#include "lesson/schema.hpp"
#include "paint/pdf.hpp"

namespace {

using namespace gjkscope;

constexpr const char* kFooter = R"(Exit codes:
  0  done
  1  a lesson or case has a problem, or GJK refuses its query, or a run is wrong
  2  the command line: an unknown command, option, lesson or value
  3  a file or log cannot be read or written, or a frame cannot be drawn
  128+n  signal n ended an export or a study, which keeps what it has done

gjkscope reads lessons and assets from $GJKSCOPE_SHARE, or from where they were installed.

Examples:
  gjkscope export --all --out out --index
  gjkscope trace polygons-gjk
  echo '{"a":[[0,0]],"b":[[3,4]]}' | gjkscope solve -
)";

/// Reads a value with `parse`; CLI11 prints `expected` when there is none.
template <class T, class Parse>
CLI::Option* parsed(CLI::App* command, const std::string& name, T& target, Parse parse,
                    const std::string& expected, const std::string& help) {
  return command
      ->add_option_function<std::string>(
          name,
          [&target, parse, expected, name](const std::string& text) {
            const auto value = parse(text);
            if (!value) {
              throw CLI::ValidationError(name, "'" + text + "' is not " + expected);
            }
            target = *value;
          },
          help)
      ->type_name("TEXT");
}

struct Arguments {
  LessonChoice lessons;
  std::string name;
  std::vector<std::string> files;
  bool json = false;
  bool single = false;
  bool markdown = false;
  ScalarKind scalar = ScalarKind::double_;
  ModelMethod method = ModelMethod::boxes;
  ExportOptions export_options;
  std::filesystem::path out;
  std::string format;
  std::string caption;
  std::string crop;
  std::pair<int, int> size = {1280, 720};
  StepRange steps;
  StudyOptions study;
  std::optional<int> sheet;
  Paper paper = Paper::a4;
  int chapter = 0;
  int tasks = 12;
  std::uint64_t seed = 1;
  std::vector<std::string> programs;
  judging::TrialOptions trial;
};

void add_export_look(CLI::App* command, Arguments& args) {
  ExportOptions& options = args.export_options;
  parsed(command, "--size", args.size, parse_size, "a size such as 1280x720",
         "Size of the page of a frame, in pixels")
      ->type_name("WxH")
      ->default_str("1280x720");
  command->add_option("--scale", options.scale, "Image pixels for each pixel of the page")
      ->check(CLI::Range(0.1, 16.0))
      ->capture_default_str();
  command->add_option("--dpi", options.dpi, "Pixels per inch: the printed size of a png or pdf")
      ->check(CLI::Range(1.0, 10000.0));
  command->add_option("--theme", options.theme, "Colours: light, dark, print or high-contrast")
      ->capture_default_str();
  command->add_flag("--transparent", options.transparent, "No background: png, svg, pdf, tex");
  parsed(command, "--listing", args.lessons.language, value_of<Language>,
         "one of pseudocode, cpp, python",
         "How listings are written: pseudocode; or a page of C++ or Python, the line of each step "
         "and its variables, for the algorithms that the page has. If not given, as lessons say")
      ->type_name("pseudocode|cpp|python");
  command->add_option("--crop", args.crop, "stage: the views alone, for slides")
      ->check(CLI::IsMember({"stage"}));
  command
      ->add_option("--caption", args.caption,
                   "below: in the frame; none: left out; file: in a text file beside each frame. "
                   "If not given, below, with --crop none")
      ->check(CLI::IsMember({"below", "none", "file"}));
  command->add_option("--handout", options.handout, "pdf: N frames on each page, with captions")
      ->check(CLI::Range(1, kMostOnHandout))
      ->type_name("N");
  command
      ->add_option("--seconds", options.seconds,
                   "gif, apng, mp4, webm: how long a frame is shown; the last twice as long")
      ->check(CLI::Range(0.04, 600.0))
      ->capture_default_str();
  command
      ->add_option("--fps", options.fps,
                   "gif, apng, mp4, webm, png, svg: what changes moves from frame to frame, in so "
                   "many images a second")
      ->check(CLI::Range(1, 60))
      ->type_name("N");
  command
      ->add_option("--turn", options.turn,
                   "gif, apng, mp4, webm, of lessons in space: degrees that the eye walks around "
                   "while the film runs; 360 is once around")
      ->check(CLI::Range(-3600.0, 3600.0))
      ->type_name("N");
}

void add_export(CLI::App& app, Arguments& args) {
  CLI::App* command =
      app.add_subcommand("export", "Draw the frames of lessons into files, without a window");
  ExportOptions& options = args.export_options;
  command->add_option(
      "lesson", args.lessons.names,
      "Ids or files of lessons, files of cases (.json, .wkt, .obj, .txt, ...), or -");
  command->add_flag("--all", args.lessons.all, "All shipped lessons");
  CLI::Option* sheet =
      command
          ->add_option("--sheet", args.sheet,
                       "Instead of lessons: chapter N on one page, as pdf, svg or png")
          ->check(CLI::Range(0, limits::kLastChapter))
          ->type_name("N");
  parsed(command, "--paper", args.paper, paper_of, "one of a4, letter",
         "The paper of a sheet: a4, if not given, or letter")
      ->type_name("a4|letter")
      ->needs(sheet);
  command
      ->add_option("--out", args.out,
                   "Folder for the files; or one file, whose ending names the format")
      ->required()
      ->type_name("DIR|FILE");
  command
      ->add_option("--format", args.format,
                   "png, svg: a file for each frame; pdf, tex (slides of beamer, and their pdf), "
                   "gif, apng, mp4, webm (these two by ffmpeg): one for each lesson; html: pages "
                   "to step through in a browser; npm: the folder of a package with an element for "
                   "any page. Without it, what --out ends with, or png")
      ->check(
          CLI::IsMember({"png", "svg", "pdf", "tex", "gif", "apng", "mp4", "webm", "html", "npm"}));
  add_export_look(command, args);
  parsed(command, "--steps", args.steps, parse_steps, "a range such as 3..7",
         "Only these frames, counted from 1")
      ->type_name("A..B");
  command->add_option("--jobs", options.jobs, "Threads; 0: one for each processor")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  parsed(command, "--renderer", options.renderer, renderer_of, "one of cairo, osmesa, egl",
         "What draws pixels: cairo, if not given; or, as the window does, OpenGL by one of two "
         "libraries that may be installed")
      ->type_name("cairo|osmesa|egl");
  command->add_flag("--no-questions{false}", options.questions,
                    "Leave out the frames that ask a question");
  command->add_flag("--index", options.index,
                    "Also write index.html: of png a contact sheet, of pages their index, a "
                    "playground, and what they share, once, in shared/ and cards/");
  command->add_flag("--single", args.single,
                    "html: also with --index each page is one file that needs no other");
  command->add_flag(
      "--force", options.force,
      "Replace files that gjkscope did not export, and export again what is up to date");
  command->add_flag("--json", args.json, "Print JSON");
  command->footer(
      "A file that was made from the same lesson, theme, fonts, options and program is up to date "
      "and\nstays. Each file holds the lesson and the step that it shows: `gjkscope open FILE` "
      "goes there.\n\n"
      "Examples:\n  gjkscope export --all --out out --index\n"
      "  gjkscope export polygons-gjk --out out --size 1920x1080 --steps 2..5 --theme dark\n"
      "  gjkscope export polygons-gjk --out out --listing python\n"
      "  gjkscope export polygons-gjk --out polygons.pdf --theme print --handout 4\n"
      "  gjkscope export polygons-gjk --out polygons.gif --size 960x540 --fps 20\n"
      "  gjkscope export polygons-gjk --steps 3 --out figure.svg --crop stage --transparent\n"
      "  gjkscope export --sheet 3 --out chapter-3.pdf --paper letter\n"
      "  gjkscope export --all --out site --format html --index\n"
      "  gjkscope export polygons-gjk --out polygons.html\n"
      "  gjkscope export --all --out package --format npm\n");
}

void add_commands(CLI::App& app, Arguments& args) {
  const auto add_json = [&](CLI::App* command) {
    command->add_flag("--json", args.json, "Print JSON");
  };
  const auto add_scalar = [&](CLI::App* command, const char* help) {
    parsed(command, "--scalar", args.scalar, value_of<ScalarKind>,
           "one of half, float, double, exact", help)
        ->type_name("half|float|double|exact");
  };

  const auto add_no_questions = [&](CLI::App* command) {
    command->add_flag("--no-questions{false}", args.export_options.questions,
                      "Leave out the frames that ask a question");
  };

  CLI::App* lessons = app.add_subcommand("lessons", "List the lessons: id, chapter, steps, title");
  add_json(lessons);
  lessons->footer("Examples:\n  gjkscope lessons\n  gjkscope lessons --json\n");

  add_export(app, args);

  CLI::App* practice =
      app.add_subcommand("practice", "Make a work sheet of tasks, and the pages with its answers");
  practice->add_option("--chapter", args.chapter, "Chapter to practise: 1 to 5, or 9, in space")
      ->required()
      ->type_name("N");
  practice->add_option("--tasks", args.tasks, "How many")
      ->check(CLI::Range(1, kMostTasks))
      ->type_name("N")
      ->capture_default_str();
  practice->add_option("--seed", args.seed, "The same seed gives the same sheet, byte for byte")
      ->type_name("N")
      ->capture_default_str();
  practice->add_option("--out", args.out, "The sheet, a pdf")->required()->type_name("FILE");
  parsed(practice, "--paper", args.paper, paper_of, "one of a4, letter",
         "a4, if not given, or letter")
      ->type_name("a4|letter");
  practice->add_option("--theme", args.export_options.theme, "Colours; print, if not given");
  practice->add_flag("--force", args.export_options.force,
                     "Replace a file that gjkscope did not export");
  practice->footer(
      "Coordinates are small whole numbers, and no decision is near a tie, unless it is one "
      "exactly:\nall can be worked out by hand. Answers are those of the core.\n\n"
      "Examples:\n  gjkscope practice --chapter 3 --out sheet.pdf\n"
      "  gjkscope practice --chapter 9 --tasks 6 --seed 7 --out space.pdf --paper letter\n");

  CLI::App* open =
      app.add_subcommand("open", "Open the window at the step that an exported file shows");
  open->add_option("file", args.name, "png, apng, svg, pdf or gif from `gjkscope export`")
      ->required();
  open->add_flag("--json", args.json, "Print what the file says of itself instead");
  open->footer(
      "Examples:\n  gjkscope open out/polygons-gjk-0015.png\n"
      "  gjkscope open figure.svg --json\n");

  CLI::App* trace = app.add_subcommand("trace", "Print a run, phase by phase");
  trace
      ->add_option("lesson|case", args.name,
                   "Id or file of a lesson, a case.json, or - for a case from standard input")
      ->required();
  add_scalar(trace, "Arithmetic for a case; a lesson names its own");
  parsed(
      trace, "--method", args.method,
      [](std::string_view text) {
        const auto method = value_of<ModelMethod>(text);
        return method == ModelMethod::brute ? std::nullopt : method;
      },
      "one of pieces, boxes, circles, lin-canny",
      "What is traced of a case with outlines; boxes if not given")
      ->type_name("pieces|boxes|circles|lin-canny");
  add_json(trace);
  trace->footer(
      "A case is what `gjkscope solve` reads. Of outlines, which must be closed, the trace is that "
      "of\na lesson that shows the method: the search over two trees, pieces, or the walk on "
      "features.\n\n"
      "Examples:\n  gjkscope trace polygon-evolution\n  gjkscope trace case.json --scalar exact\n"
      "  gjkscope trace polygons-gjk --json    (format: docs/trace-format.md)\n");

  CLI::App* solve =
      app.add_subcommand("solve", "Compute the distance of each case, as one JSON object each");
  solve->add_option("case", args.files, "Files of cases; - is standard input")->required();
  add_scalar(solve, "Arithmetic");
  parsed(solve, "--method", args.method, value_of<ModelMethod>,
         "one of brute, pieces, boxes, circles, lin-canny",
         "How closest segments of outlines are found; boxes if not given")
      ->type_name("brute|pieces|boxes|circles|lin-canny");
  add_json(solve);
  solve->footer(
      "A case is JSON, or shapes as people have them (below):\n"
      "{\"dimension\":2, \"a\":[[x,y],...], \"b\":[[x,y],...]}: two sets of points, "
      "of which\n"
      "gjkscope takes the convex hulls. With \"dimension\":3 points are [x,y,z]; 2 may be left "
      "out. "
      "A file\n"
      "holds any number of cases, one after the other or in an array.\n\n"
      "Answers are JSON, with or without --json: distance, and the bounds that are proved for it,\n"
      "lower and upper. Shapes that overlap also have depth, depth_lower and depth_upper:\n"
      "how far 'a' must move along direction, a vector of length 1, until the shapes just touch;\n"
      "translation is depth times direction.\n\n"
      "Outlines, which need not be convex, are\n"
      "{\"outlines_a\":[[[x,y],...],...], \"outlines_b\":...}. An outline is closed; one that "
      "turns\n"
      "clockwise within another is a hole; {\"open\":[...]} is an open chain. Beside outlines,\n"
      "points are their hull. Answers: distance and\n"
      "overlap, which are exact, the closest points a and b, the features they lie on (vertex or\n"
      "segment, with outline and index), and visits: pairs that the method looked at. pieces "
      "needs\n"
      "closed outlines that do not meet, lin-canny one convex outline of each shape.\n\n"
      "In other forms a text holds one case, X and then Y; so do two files with one "
      "shape each:\n"
      "  WKT, GeoJSON        POLYGON ((0 0, 4 0, 4 4, 0 0)) POINT (5 5); concave "
      "rings, holes\n                      and lines are outlines\n"
      "  OBJ, OFF, STL       vertices of polyhedra, faces are not read; STL as text\n"
      "  lists in code       {{1,2},{3,4}}, np.array([[1,2]]), in most languages\n"
      "  points in code      b2Vec2(1, 2), new Vector3(1f, 2f, 3f), a[0].Set(1, 2)\n"
      "  columns of numbers  two or three a line; an empty line or a heading before Y\n"
      "Answers say what was understood: \"X has 4 vertices, Y 5, in the plane\".\n\n"
      "Examples:\n  gjkscope solve case.json --scalar exact\n  gjkscope solve x.obj y.obj\n"
      "  echo '{\"a\":[[0,0]],\"b\":[[3,4]]}' | gjkscope solve -\n");

  CLI::App* check = app.add_subcommand("check", "Check lessons, and what they expect; and cases");
  check
      ->add_option("file", args.files,
                   "Ids or files of lessons, files of cases (.json, .wkt, .obj, .txt, ...), or -")
      ->required();
  check->footer(
      "Cases are what `gjkscope solve` reads, outlines included: check says what cannot be read, "
      "and\nwhere, and what has no answer in double precision.\n\n"
      "Examples:\n  gjkscope check lessons/*.toml\n  gjkscope check case.json\n");

  CLI::App* judge = app.add_subcommand("judge", "Find the first wrong step in a log of any GJK");
  judge->add_option("log", args.files, "Logs; - is standard input");
  judging::TrialOptions& trial = args.trial;
  CLI::Option* program =
      judge
          ->add_option("--program", args.programs,
                       "Ask a program, by a shell's command, about families of pairs instead; "
                       "repeat the option to set programs side by side")
          ->allow_extra_args(false)
          ->type_name("CMD");
  judge->add_option("--family", trial.families, "Family of pairs; repeat the option for more")
      ->check(CLI::IsMember(judging::family_names()))
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->needs(program);
  judge->add_option("--dimension", trial.dimension, "2: the plane; 3: space; both if not given")
      ->check(CLI::IsMember({2, 3}))
      ->needs(program);
  judge->add_option("--pairs", trial.pairs, "Pairs of each family")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str()
      ->needs(program);
  judge->add_option("--seed", trial.seed, "Seed of the pairs")
      ->capture_default_str()
      ->needs(program);
  judge->add_flag("--float", trial.in_float, "Coordinates are floats; so the program may compute")
      ->needs(program);
  judge->add_option("--patience", trial.patience.seconds, "Seconds without an answer")
      ->check(CLI::Range(0.01, 3600.0))
      ->capture_default_str()
      ->needs(program);
  judge->add_option("--out", args.out, "Folder for the smallest failing case of each family")
      ->type_name("DIR")
      ->needs(program);
  add_json(judge);
  judge->footer(
      "A log holds one run: a line with the shapes, a line for each iteration with what the loop\n"
      "knows (simplex, weights, closest point, direction, support point), and a line with the\n"
      "answer. gjkscope_log.h writes it in C and C++; docs/log-format.md describes it, and has "
      "the\n"
      "same for Python and JavaScript. Each step is checked in exact arithmetic.\n"
      "  wrong     more than rounding explains\n"
      "  rounding  the largest error that is explained, in units u L: the unit roundoff times the\n"
      "            largest length of the step\n"
      "  waste     costs time, and leaves the answer alone\n\n"
      "A program reads cases, as `gjkscope solve` does, one a line, and prints an answer a line:\n"
      "{\"distance\":...}, and, if it has them, \"overlap\":true or false, \"a\" and \"b\". "
      "Failures are\n"
      "  m missed overlap   i invented overlap   r relative error   p closest points   n NaN\n"
      "  g gave up ({\"error\":...})   x nonsense   s silence   c crash\n\n"
      "Exit code 0: all is right; 1: a run or an answer is wrong; 3: a log cannot be read, or a\n"
      "program answers nothing.\n\n"
      "Examples:\n  gjkscope judge run.jsonl\n  my-program | gjkscope judge - --json\n"
      "  gjkscope judge --program ./my-distance --dimension 2 --out failing\n"
      "  gjkscope judge --program 'gjkscope solve -' --family needle --pairs 100\n"
      "  gjkscope judge --program ./mine --program ./theirs --float\n");

  CLI::App* transcript =
      app.add_subcommand("transcript", "Print the words of lessons, frame by frame");
  transcript->add_option(
      "lesson", args.lessons.names,
      "Ids or files of lessons, files of cases (.json, .wkt, .obj, .txt, ...), or -");
  transcript->add_flag("--all", args.lessons.all, "All shipped lessons");
  transcript->add_flag("--markdown", args.markdown, "Print headings and lists in Markdown");
  add_no_questions(transcript);
  transcript->footer(
      "A frame's words are also the alternative text of its figure.\n\n"
      "Examples:\n  gjkscope transcript polygon-evolution\n"
      "  gjkscope transcript --all --markdown > lessons.md\n");

  CLI::App* explain =
      app.add_subcommand("explain", "List the effects that a lesson computes, and their cost");
  explain->add_option("lesson", args.name, "Id or file of a lesson")->required();
  add_json(explain);
  explain->footer("Examples:\n  gjkscope explain polygons-gjk\n");

  CLI::App* study = app.add_subcommand("study", "Measure how accurate and how fast GJK is");
  study->require_subcommand(1);
  CLI::App* accuracy = study->add_subcommand("accuracy", "What accuracy costs in time");
  accuracy->add_flag("--quick", args.study.quick, "Fewer pairs and choices: seconds, not minutes");
  accuracy
      ->add_option("--out", args.study.out_dir,
                   "Folder for accuracy.csv, .json and .html, and for figures")
      ->type_name("DIR");
  accuracy
      ->add_option("--family", args.study.families,
                   "Family of pairs; repeat the option for more; all families if not given")
      ->type_name("NAME")
      ->allow_extra_args(false);
  accuracy->add_option("--seed", args.study.seed, "Seed of the pairs")->capture_default_str();
  accuracy
      ->add_option("--advice", args.study.advice,
                   "Write the conclusions as Markdown, and their numbers beside it as .csv")
      ->type_name("FILE");
  accuracy->footer(
      "Answers families of easy and hard pairs in many ways, judges each by exact runs, and times\n"
      "them in turns. Everything but the times depends on the seed alone. It takes up to three\n"
      "minutes; interrupted (Ctrl-C), it writes and prints what it has, says so, and ends with "
      "130.\n\n"
      "Examples:\n  gjkscope study accuracy --quick\n  gjkscope study accuracy --out study\n"
      "  gjkscope study accuracy --family needles --family \"nearly parallel\"\n");

  CLI::App* models =
      study->add_subcommand("models", "How long methods for outlines that are not convex take");
  models->add_option("lesson", args.lessons.names,
                     "Ids or files of lessons; all lessons if not given");
  models->add_flag("--quick", args.study.quick, "Fewer repetitions");
  models->add_option("--out", args.study.out_dir, "Folder for models.toml")->type_name("DIR");
  models->footer(
      "Lessons of the tour general-growth: all pairs of segments, convex pieces, and\n"
      "trees of boxes and circles, at each size. models.toml has the table [growth.times], which\n"
      "the lesson's file takes. Other lessons are left out.\n\n"
      "Examples:\n  gjkscope study models --out study\n"
      "  gjkscope study models general-growth --quick\n");
}

constexpr std::string_view kDrawn = "png, svg, pdf, tex, gif, apng, mp4, webm";
/// Options that only some formats take, each with these formats.
constexpr std::array<std::pair<const char*, std::string_view>, 16> kTakenBy = {{
    {"--size", kDrawn},
    {"--theme", kDrawn},
    {"--steps", kDrawn},
    {"--crop", kDrawn},
    {"--caption", kDrawn},
    {"--no-questions", kDrawn},
    {"--scale", "png, pdf, tex, gif, apng, mp4, webm"},
    {"--dpi", "png, pdf, tex"},
    {"--transparent", "png, svg, pdf, tex"},
    {"--handout", "pdf"},
    {"--single", "html"},
    {"--index", "png, svg, pdf, tex, gif, apng, mp4, webm, html"},
    {"--seconds", "gif, apng, mp4, webm"},
    {"--fps", "png, svg, gif, apng, mp4, webm"},
    {"--turn", "gif, apng, mp4, webm"},
    {"--renderer", "png, gif, apng, mp4, webm"},
}};

/// The first option given that `format` does not take, as a message; empty where there is none.
std::string untaken_option(const CLI::App& command, const std::string& format) {
  for (const auto& [option, formats] : kTakenBy) {
    if (command.count(option) == 0) continue;
    if (fmt::format(", {},", formats).find(fmt::format(" {},", format)) == std::string::npos)
      return fmt::format("{} goes with {}, not with {}", option, formats, format);
  }
  return {};
}

/// The sheet of a chapter: options that it does not take are refused.
int run_sheet(const Environment& env, const CLI::App& command, Arguments& args) {
  constexpr std::array kTaken = {"--sheet", "--paper", "--out", "--format", "--theme", "--force"};
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->count() > 0 && std::find(kTaken.begin(), kTaken.end(), name) == kTaken.end()) {
      env.err << fmt::format("gjkscope export: {} does not go with --sheet\n", name);
      return kUsage;
    }
  }
  if (args.format.empty()) args.format = "pdf";
  if (args.format != "pdf" && args.format != "svg" && args.format != "png") {
    env.err << fmt::format("gjkscope export: a sheet is pdf, svg or png, not {}\n", args.format);
    return kUsage;
  }
  ExportOptions& options = args.export_options;
  const std::string name = options.file_name.empty()
                               ? fmt::format("chapter-{}.{}", *args.sheet, args.format)
                               : options.file_name;
  SheetFile sheet{.file = options.out_dir / name,
                  .format = *format_of(args.format),
                  .assets_dir = {},
                  .paper = args.paper,
                  .force = options.force};
  if (command.count("--theme") > 0) sheet.theme = options.theme;
  return sheet_command(env, *args.sheet, std::move(sheet));
}

int run_export(const Environment& env, const CLI::App& command, Arguments& args) {
  ExportOptions& options = args.export_options;
  std::tie(options.width, options.height) = args.size;
  options.first_step = args.steps.first;
  options.last_step = args.steps.last;
  options.progress = !args.json;
  options.stage_only = args.crop == "stage";
  if (args.caption.empty()) args.caption = options.stage_only ? "none" : "below";
  options.caption = args.caption == "none"   ? CaptionPlace::none
                    : args.caption == "file" ? CaptionPlace::file
                                             : CaptionPlace::below;
  options.out_dir = args.out;
  const std::string ending =
      args.out.has_extension() ? args.out.extension().string().substr(1) : "";
  if ((ending == "html" || format_of(ending)) && !std::filesystem::is_directory(args.out)) {
    options.out_dir = args.out.has_parent_path() ? args.out.parent_path() : ".";
    options.file_name = args.out.filename().string();
    if (args.format.empty()) args.format = ending;
  }
  if (args.sheet) return run_sheet(env, command, args);
  if (args.format.empty()) args.format = name_of(options.format);
  if (const std::string untaken = untaken_option(command, args.format); !untaken.empty()) {
    env.err << "gjkscope export: " << untaken << "\n";
    return kUsage;
  }
  const bool package = args.format == "npm";
  if (args.format == "html" || package) {
    return export_pages_command(env, args.lessons,
                                {options.out_dir, env.share, options.index, args.single,
                                 options.force, options.file_name, package},
                                args.json);
  }
  options.format = *format_of(args.format);
  return export_command(env, args.lessons, options, args.json);
}

int run(const CLI::App& app, Arguments& args) {
  const Environment env{share_folder(), std::cin, std::cout, std::cerr};
  if (app.got_subcommand("lessons")) return list_lessons(env, args.json);
  if (app.got_subcommand("practice")) {
    WorkSheetFile sheet{.file = args.out,
                        .assets_dir = {},
                        .paper = args.paper,
                        .force = args.export_options.force};
    if (app.get_subcommand("practice")->count("--theme") > 0)
      sheet.theme = args.export_options.theme;
    return practice_command(env, args.chapter, args.tasks, args.seed, std::move(sheet));
  }
  if (app.got_subcommand("open")) return open_command(env, args.name, args.json);
  if (app.got_subcommand("trace"))
    return trace_command(env, args.name, {args.scalar, args.method}, args.json);
  if (app.got_subcommand("solve"))
    return solve_command(env, args.files, {args.scalar, args.method});
  if (app.got_subcommand("judge")) {
    if (args.files.empty() == args.programs.empty()) {
      env.err << "gjkscope judge: name logs, or give --program\n";
      return kUsage;
    }
    if (args.programs.size() > 1 && !args.out.empty()) {
      env.err << "gjkscope judge: --out takes the cases of one program; expected one --program\n";
      return kUsage;
    }
    if (args.files.empty())
      return judge_programs_command(env, args.programs, args.trial, args.out, args.json);
    return judge_command(env, args.files, args.json);
  }
  if (app.got_subcommand("check")) return check_command(env, args.files);
  if (app.got_subcommand("explain")) return explain_command(env, args.name, args.json);
  if (app.got_subcommand("study")) {
    const CLI::App* study = app.get_subcommand("study");
    if (study->got_subcommand("models")) {
      return study_models_command(env, args.lessons, args.study);
    }
    return study_accuracy_command(env, args.study);
  }
  ExportOptions& options = args.export_options;
  const bool tells = app.got_subcommand("transcript");
  if (!args.sheet && args.lessons.all == !args.lessons.names.empty()) {
    std::cerr << "gjkscope " << (tells ? "transcript" : "export")
              << ": name lessons, or give --all\n";
    return kUsage;
  }
  if (tells) return transcript_command(env, args.lessons, args.markdown, options.questions);
  return run_export(env, *app.get_subcommand("export"), args);
}

/// The command that an unknown word was meant to be.
std::string nearest_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return {};
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return {};
  return nearest_name(argv[1], names);
}

int parse_and_run(int argc, char** argv) {
  CLI::App app("gjkscope: the GJK distance algorithm, one decision at a time", "gjkscope");
  app.set_version_flag("--version",
                       "gjkscope " GJKSCOPE_VERSION "\nbuilt with " GJKSCOPE_BUILT_WITH);
  app.require_subcommand(1);
  app.footer(kFooter);
  app.failure_message([](const CLI::App* failed, const CLI::Error& error) {
    return "gjkscope: " + std::string(error.what()) + "\nRun `" + failed->get_display_name() +
           " --help` for its arguments.\n";
  });
  Arguments args;
  add_commands(app, args);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error, std::cout, std::cerr);
    if (code == 0) return kDone;
    if (const std::string nearest = nearest_command(app, argc, argv); !nearest.empty()) {
      std::cerr << "Did you mean `gjkscope " << nearest << "`?\n";
    }
    return kUsage;
  }
  return run(app, args);
}

}  // namespace

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  try {
    return parse_and_run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gjkscope: %s\n", error.what());
    return kCannot;
  }
}
