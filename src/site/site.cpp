#include "site/site.hpp"

#include <fmt/format.h>
#include <libdeflate.h>

#include <algorithm>
#include <map>
#include <memory>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <tuple>

#include "base/file.hpp"
#include "base/html.hpp"
#include "base/sha256.hpp"
#include "frames/frame.hpp"
#include "lesson/chapters.hpp"
#include "lesson/load.hpp"
#include "lesson/save.hpp"
#include "paint/svg.hpp"
#include "practice/practice.hpp"
#include "run/trail.hpp"
#include "site/still.hpp"
#include "subjects/course_map/tiles.hpp"
#include "subjects/subjects.hpp"
#include "web/player.hpp"

namespace gjkscope {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      out += k <= count ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

/// Deflated, in base64: what `inflated` of a page's script reads.
std::string packed(const std::string& text) {
  constexpr int kLevel = 12;
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(kLevel), &libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  std::string out(libdeflate_deflate_compress_bound(compressor.get(), text.size()), '\0');
  out.resize(libdeflate_deflate_compress(compressor.get(), text.data(), text.size(), out.data(),
                                         out.size()));
  return base64(out);
}

std::string hex_digest(std::string_view text) {
  std::string out;
  for (const std::uint8_t byte : sha256(text)) out += fmt::format("{:02x}", byte);
  return out;
}

/// The source of a content policy that lets this inline script run.
std::string hash_source(const std::string& script) {
  const auto digest = sha256(script);
  return fmt::format(" 'sha256-{}'",
                     base64({reinterpret_cast<const char*>(digest.data()), digest.size()}));
}

/// A script that puts a text into an element of the page.
std::string filling(const std::string& id, const std::string& text) {
  return fmt::format("document.getElementById(\"{}\").textContent = {};\n", id, Json(text).dump());
}

/// `page` with each {{name}} replaced; what is put in is not looked through again.
std::string filled(std::string_view page, const std::map<std::string, std::string>& parts) {
  std::string out;
  for (;;) {
    const std::size_t begin = page.find("{{");
    const std::size_t end = page.find("}}", begin);
    if (end == std::string_view::npos) return out += page;
    const auto part = parts.find(std::string(page.substr(begin + 2, end - begin - 2)));
    out += page.substr(0, begin);
    if (part != parts.end()) out += part->second;
    page.remove_prefix(end + 2);
  }
}

/// In a script element nothing may look like the end of it.
std::string script_text(const Json& json) {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  return text;
}

std::string css(const std::optional<Color>& color) {
  const Color c = color.value_or(Color{});
  return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b);
}

/// The colours of the page around the pictures, from the themes of these.
std::string theme_css(const std::string& name, const Theme& theme) {
  return fmt::format(
      "html[data-theme=\"{}\"] {{ --paper: {}; --card: {}; --rule: {}; --ink: {}; --muted: {}; "
      "--accent: {}; --pass: {}; --highlight: {}; --glow: {}; }}\n",
      name, css(theme.background()), css(theme.style("card").fill), css(theme.style("card").stroke),
      css(theme.style("title").fill), css(theme.style("prose").fill), css(theme.style("fail").fill),
      css(theme.style("pass").fill), css(theme.style("highlight").fill),
      css(theme.style("shape.y").stroke));
}

std::string link(const std::string& href, const std::string& text, std::string_view more = "") {
  return fmt::format("<a{} href=\"{}\">{}</a>\n", more, escape_html(href), escape_html(text));
}

/// The steps of a lesson as items of a list, and the most characters that one says.
std::pair<std::string, std::string> transcript(const Lesson& lesson) {
  Lesson unasked = lesson;
  unasked.questions.clear();
  const LessonRun run = run_lesson(std::move(unasked));
  EffectGraph effects(run);
  std::string items;
  int longest = 0;
  int step = 0;
  for (const FrameText& text : lesson_texts(run, effects)) {
    const std::string words = alternative_text(text);
    longest = std::max(longest, character_count(text.position + words));
    items += fmt::format("<li><a href=\"#step={}\">{}</a>{}</li>\n", ++step,
                         escape_html(text.position), escape_html(words));
  }
  return {items, std::to_string(longest)};
}

bool has_practice(int chapter) { return !practice::kinds_of(chapter).empty(); }

std::string practice_link(int chapter) {
  return link(fmt::format("practice.html#chapter={}", chapter),
              fmt::format("Practise chapter {}", chapter));
}

fs::path file_of(const SiteOptions& options, const std::string& name) {
  return options.out_dir / (options.file_name.empty() ? name + ".html" : options.file_name);
}

class SiteWriter {
 public:
  explicit SiteWriter(const SiteOptions& options)
      : options_(options),
        share_(options.share),
        assets_(options.share / "assets"),
        fonts_(assets_ / "fonts.toml"),
        theme_(Theme::load(assets_ / "themes", "light")),
        dark_(Theme::load(assets_ / "themes", "dark")) {
    for (const std::string& name : Theme::names(assets_ / "themes")) {
      themes_[name] = read_whole(assets_ / "themes" / (name + ".toml"));
      common_.style += theme_css(name, Theme::load(assets_ / "themes", name));
    }
    const fs::path web = program_folder();
    module_ = read_whole(web / kModule);
    common_.wasm = base64(module_);
    common_.fonts = read_whole(web / "fonts.css");
    common_.style += assets({"style.css"});
    common_.head = assets({"theme.js", "room.js", "memory.js"});
    common_.worker = assets({"bytes.js", "player.js", "worker.js"});
    common_.script =
        assets({"bytes.js", "program.js", "motion.js", "terms.js", "page.js", "tools.js", "hand.js",
                "links.js", "kit.js", "practice.js", "host.js", "start.js"});
    const std::string room = "\n" + assets({"place.js"});
    shared_["generator"] = signature();
    shared_["room"] = fmt::format("<script>{}</script>", room);
    shared_["icon"] = "<link rel=\"icon\" href=\"data:,\">\n";
    if (options.package) {
      put_common_into_package(room);
    } else if (options.index && !options.single) {
      put_common_beside_pages(room);
    } else {
      put_common_into_pages(room);
    }
  }

  /// Before anything is written.
  void refuse_foreign_files(const std::vector<Lesson>& lessons) const {
    for (const Lesson& lesson : lessons) refuse_foreign(file_of(options_, lesson.id));
    if (options_.package) refuse_foreign_package();
    if (!options_.index) return;
    for (const char* name : {"playground", "practice", "index", "about"})
      refuse_foreign(file_of(options_, name));
    if (!shares()) return;
    refuse_foreign(options_.out_dir / kServiceWorker);
    for (const auto& [name, text] : beside_) refuse_foreign(options_.out_dir / name);
    for (const Lesson& lesson : lessons) {
      for (const bool dark : {false, true})
        refuse_foreign(options_.out_dir / card_file(lesson.id, dark));
    }
    for (const bool dark : {false, true}) refuse_foreign(options_.out_dir / card_file("map", dark));
  }

  /// `next` and `in_space`: lessons to link to; null where there is none.
  void write_lesson(const Lesson& lesson, const Lesson* next, const Lesson* in_space) {
    std::map<std::string, std::string> parts = shared_;
    parts["meta"] = escape_html(fmt::format("Chapter {}{}", lesson.chapter,
                                            lesson.source.empty() ? "" : " · " + lesson.source));
    parts["kind"] = "lesson";
    write_page(lesson, std::move(parts), next, in_space);
  }

  void write_playground() {
    const fs::path file = assets_ / "web" / "playground.toml";
    const LoadedLesson loaded = load_lesson(file, vocabulary());
    if (!loaded.lesson) throw std::runtime_error(to_string(loaded.problems.front()));
    std::map<std::string, std::string> parts = shared_;
    parts["kind"] = "playground";
    parts["meta"] = "Their distance, and the run that finds it";
    parts["kit"] = read_whole(assets_ / "web" / "kit.html");
    write_page(*loaded.lesson, std::move(parts), nullptr, nullptr);
  }

  /// A task is made in the page; the one that the page holds is shown until then.
  void write_practice() {
    const int chapter = practice::chapters_with_practice().front();
    const practice::Task task = practice::Practice(chapter, 0).task();
    std::map<std::string, std::string> parts = shared_;
    parts["kind"] = "practice";
    parts["kit"] = read_whole(assets_ / "web" / "practice.html");
    parts["untold"] = " hidden";
    write_page(task.lesson, std::move(parts), nullptr, nullptr);
  }

  void write_index(const std::vector<Lesson>& lessons) {
    const std::map<int, std::string> chapters =
        parse_chapters(read_whole(assets_ / "chapters.toml"), "assets/chapters.toml");
    const auto map = std::find_if(lessons.begin(), lessons.end(),
                                  [](const Lesson& lesson) { return lesson.tour == "course-map"; });
    std::string list;
    int chapter = -1;  // of the lesson before; none
    for (const Lesson& lesson : lessons) {
      if (lesson.chapter != chapter) {
        if (chapter >= 0) list += "</ul></section>\n";
        chapter = lesson.chapter;
        const auto title = chapters.find(chapter);
        list += fmt::format(
            "<section class=\"chapter\" id=\"chapter-{}\"><h2>{}{}</h2>\n{}<ul class=\"cards\">\n",
            chapter, chapter, title == chapters.end() ? "" : ". " + escape_html(title->second),
            has_practice(chapter) ? fmt::format("<p>{}</p>\n", practice_link(chapter)) : "");
      }
      list += card(lesson);
    }
    if (chapter >= 0) list += "</ul></section>\n";
    write_plain("index", "GJK, step by step",
                "The GJK distance algorithm, one decision at a time: lessons to step through, to "
                "drag and to ask.",
                {{"lessons", list},
                 {"map", map == lessons.end() ? "" : map_of_chapters(*map, chapters)},
                 {"first", lessons.empty() ? "playground" : escape_html(lessons.front().id)}});
  }

  void write_about() {
    write_plain(
        "about", "About · gjkscope", "Where these pages come from, and how to use them.",
        {{"log", escape_html(read_whole(share_ / "src" / "judge" / "gjkscope_log.h"))},
         {"along", shares() ? "These pages share what they need, and ask nobody else for "
                              "anything. The folder works from a disk or a USB stick; from a "
                              "server your browser keeps all of it for where there is no "
                              "network. <code>gjkscope export NAME --format html --out .</code> "
                              "makes one file of a lesson that needs no other."
                            : "Each page is one file. Save it, and it opens from a disk or a "
                              "USB stick, without a network; it asks nobody for anything."}});
  }

  /// The files that pages share, and the one that keeps all of it in a browser.
  void write_files_beside_pages() {
    if (!shares()) return;
    for (const auto& [name, text] : beside_) {
      fs::create_directories((options_.out_dir / name).parent_path());
      write_file(options_.out_dir / name, text);
    }
    if (options_.package) return;
    write_file(
        options_.out_dir / kServiceWorker,
        fmt::format("// {}\n\"use strict\";\n\nconst VERSION = \"{}\";\nconst FILES = {};\n{}",
                    signature(), hex_digest(digests_).substr(0, 16), Json(kept_).dump(),
                    assets({"service-worker.js"})));
  }

  /// The files of a package above its pages.
  void write_package(const std::vector<Lesson>& lessons) {
    const std::string comment = fmt::format("// {}\n", signature());
    Json titles = Json::object();
    std::string list;
    for (const Lesson& lesson : lessons) {
      titles[lesson.id] = lesson.title;
      list += fmt::format("- `{}`: {}\n", lesson.id, lesson.title);
    }
    titles["playground"] = "Playground";
    const auto write = [&](const char* name, const std::string& text) {
      write_file(package_folder() / name, text);
    };
    write("gjk-lesson.js", comment + assets({"npm/gjk-lesson.js"}));
    write("gjk-lesson.d.ts", comment + assets({"npm/gjk-lesson.d.ts"}));
    write("lessons.js", fmt::format("{}export const lessons = {};\n", comment, titles.dump(2)));
    write("index.js", comment + assets({"bytes.js", "player.js"}) +
                          filled(assets({"npm/index.js"}), {{"module", module_address()}}));
    write("index.d.ts", comment + assets({"npm/index.d.ts"}));
    write(kModule, module_);
    write("README.md", filled(assets({"npm/README.md"}), {{"lessons", list}}));
    write("LICENSE", read_whole(share_ / "LICENSE"));
    Json packed = Json::array();
    for (const fs::path& file : files_)
      packed.push_back(file.lexically_relative(package_folder()).generic_string());
    const auto entry = [](const std::string& name) {
      return Json{{"types", name + ".d.ts"}, {"default", name + ".js"}};
    };
    const Json package = {
        {"name", "gjkscope"},
        {"version", GJKSCOPE_VERSION},
        {"description",
         "The GJK distance algorithm, one decision at a time: lessons as an element, and solve, "
         "trace and judge as functions"},
        {"license", "MIT"},
        {"type", "module"},
        {"types", "./index.d.ts"},
        {"exports",
         {{".", entry("./index")},
          {"./gjk-lesson.js", entry("./gjk-lesson")},
          {"./pages/*", "./pages/*"},
          {"./package.json", "./package.json"}}},
        {"sideEffects", Json::array({"./gjk-lesson.js"})},
        {"generator", signature()},
        {"files", std::move(packed)}};
    write(kPackage, package.dump(2) + "\n");
  }

  std::vector<fs::path> files() && { return std::move(files_); }

 private:
  static constexpr const char* kServiceWorker = "service-worker.js";
  static constexpr const char* kModule = "gjkscope.wasm.gz";
  static constexpr const char* kPackage = "package.json";

  /// Texts that all pages need.
  struct Common {
    std::string fonts, style, head, worker, wasm, script;
  };

  /// Files of assets/web, one after the other.
  [[nodiscard]] std::string assets(std::initializer_list<const char*> names) const {
    std::string text;
    for (const char* name : names) text += read_whole(assets_ / "web" / name);
    return text;
  }

  /// Whether what pages have in common stands once beside them.
  [[nodiscard]] bool shares() const { return !beside_.empty(); }

  void put_common_into_pages(const std::string& room) {
    const std::string head = "\n" + common_.head;
    const std::string script = "\n" + common_.script;
    shared_["head"] =
        fmt::format("<style id=\"fonts\">\n{}</style>\n<style>\n{}</style>\n<script>{}</script>\n",
                    common_.fonts, common_.style, head);
    shared_["program"] = fmt::format(
        "<script type=\"application/json\" id=\"assets\">{}</script>\n"
        "<script type=\"text/plain\" id=\"worker\">\n{}</script>\n"
        "<script type=\"text/plain\" id=\"wasm\">{}</script>\n<script>{}</script>\n",
        script_text(assets_of_player()), common_.worker, common_.wasm, script);
    plain_scripts_ = hash_source(head);
    shared_["scripts"] = plain_scripts_ + hash_source(room) + hash_source(script);
  }

  /// Scripts, as a page of a disk can load nothing else. The program comes last, when the page
  /// shows its first frame and asks for it.
  void put_common_beside_pages(const std::string& room) {
    const std::string comment = fmt::format("/* {} */\n", signature());
    beside_["shared/fonts.css"] = comment + common_.fonts;  // for pages without a script
    const std::string style = put_beside("shared/style.css", comment + common_.style);
    const std::string head =
        put_beside("shared/head.js", comment + common_.head + assets({"offline.js"}) +
                                         filling("fonts", common_.fonts));
    const std::string script =
        put_beside("shared/page.js", comment + "\"use strict\";\n" +
                                         filling("assets", assets_of_player().dump()) +
                                         filling("worker", common_.worker) + common_.script);
    const std::string program =
        put_beside("shared/program.js", comment + filling("wasm", common_.wasm));
    shared_["head"] = fmt::format(
        "<link rel=\"stylesheet\" href=\"{}\">\n"
        "<noscript><link rel=\"stylesheet\" href=\"shared/fonts.css\"></noscript>\n"
        "<style id=\"fonts\"></style>\n<script src=\"{}\"></script>\n",
        style, head);
    shared_["program"] = fmt::format(
        "<script type=\"application/json\" id=\"assets\"></script>\n"
        "<script type=\"text/plain\" id=\"worker\"></script>\n"
        "<script type=\"text/plain\" id=\"wasm\" data-file=\"{}\"></script>\n"
        "<script src=\"{}\"></script>\n",
        program, script);
    shared_["self"] = plain_scripts_ = " 'self'";
    shared_["scripts"] = plain_scripts_ + hash_source(room);
  }

  /// A package has a server: what pages share are files, and nothing stands inside a page that a
  /// strict policy would refuse.
  void put_common_into_package(const std::string& room) {
    const std::string comment = fmt::format("/* {} */\n", signature());
    const auto put = [&](const std::string& name, const std::string& text) {
      return put_beside("shared/" + name, comment + text);
    };
    shared_["head"] = fmt::format(
        "<link rel=\"stylesheet\" href=\"{}\">\n"
        "<link rel=\"stylesheet\" id=\"fonts\" href=\"{}\">\n<script src=\"{}\"></script>\n",
        put("style.css", common_.style), put("fonts.css", common_.fonts),
        put("head.js", common_.head));
    shared_["room"] = fmt::format("<script src=\"{}\"></script>", put("place.js", room));
    shared_["program"] = fmt::format(
        "<script type=\"application/json\" id=\"assets\"></script>\n"
        "<script type=\"text/plain\" id=\"worker\" data-address=\"{}\"></script>\n"
        "<script type=\"text/plain\" id=\"wasm\" data-address=\"../{}\"></script>\n"
        "<script src=\"{}\"></script>\n",
        put("worker.js", common_.worker), module_address(),
        put("page.js",
            "\"use strict\";\n" + filling("assets", assets_of_player().dump()) + common_.script));
    shared_["self"] = shared_["scripts"] = " 'self'";
    shared_["connect"] = " connect-src 'self';";
    shared_["images"] = " 'self'";
    shared_["icon"] = {};
  }

  [[nodiscard]] fs::path package_folder() const { return options_.out_dir.parent_path(); }

  [[nodiscard]] std::string module_address() const {
    return fmt::format("{}?{}", kModule, hex_digest(module_).substr(0, 8));
  }

  /// A licence and compressed bytes do not say who wrote them; package.json does.
  void refuse_foreign_package() const {
    refuse_foreign(package_folder() / kPackage);
    if (fs::exists(package_folder() / kPackage)) return;
    for (const char* name : {"LICENSE", "README.md", "index.js", "gjk-lesson.js", kModule})
      refuse_foreign(package_folder() / name);
  }

  /// A file beside the pages. Returns its address, which changes with its content: what a browser
  /// has kept of another version is not taken for it.
  std::string put_beside(const std::string& name, const std::string& text) {
    beside_[name] = text;
    kept_.push_back(fmt::format("{}?{}", name, hex_digest(text).substr(0, 8)));
    return kept_.back();
  }

  [[nodiscard]] static std::string card_file(const std::string& name, bool dark) {
    return fmt::format("cards/{}{}.svg", name, dark ? "-dark" : "");
  }

  /// The texts that the player reads besides fonts.
  [[nodiscard]] Json assets_of_player() const { return {{"themes", themes_}, {"terms", terms_}}; }

  /// The outcome of the run, as the page's script writes it.
  [[nodiscard]] static std::string answer_table(const Json& outcome) {
    std::string rows;
    for (const Json& line : outcome)
      rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>",
                          escape_html(line[0].get<std::string>()),
                          escape_html(line[1].get<std::string>()));
    return fmt::format(
        "<div id=\"answer\" class=\"answer live\"><table><caption>Answer</caption>"
        "<tbody>{}</tbody></table></div>",
        rows);
  }

  /// The folder that `cmake --preset wasm` has filled.
  [[nodiscard]] fs::path program_folder() const {
    const fs::path installed = options_.share / "web";
    const fs::path built = options_.share / "build" / "wasm" / "web";
    for (const fs::path& folder : {installed, built}) {
      if (fs::is_regular_file(folder / "gjkscope.wasm.gz") &&
          fs::is_regular_file(folder / "fonts.css"))
        return folder;
    }
    throw std::runtime_error(
        fmt::format("there is no program for browsers in {} or {}; build it with `scripts/setup "
                    "web`, `cmake --preset wasm` and `cmake --build --preset wasm`",
                    installed.string(), built.string()));
  }

  [[nodiscard]] std::string nav(const std::string& here, const Lesson* next) const {
    if (!options_.index) return "";
    std::string out = "<nav class=\"site\" aria-label=\"Pages\">\n";
    const auto page = [&](const std::string& file, const std::string& text,
                          const std::string& more) {
      out += link(file, text, more + (file == here ? " aria-current=\"page\"" : ""));
    };
    page("index.html", "GJK, step by step", " class=\"brand\"");
    page("playground.html", "Playground", "");
    page("practice.html", "Practice", "");
    page("about.html", "About", "");
    if (next) page(next->id + ".html", "Next: " + next->title, " class=\"next\"");
    return out + "</nav>\n";
  }

  [[nodiscard]] Json page_data(const Lesson& lesson, const std::string& kind) const {
    Json files = Json::object();
    if (const auto& file = lesson.settings.file)
      files[fs::path(file->path).filename().string()] = packed(*file->text);
    return {{"kind", kind},
            {"id", lesson.id},
            {"name", lesson.id + ".toml"},
            {"views", lesson.views.size()},
            {"asks", kind != "practice" && asks(lesson)},
            {"lesson", lesson_toml(lesson)},
            {"files", std::move(files)}};
  }

  /// Whether the run of the lesson has a step that a question can ask for.
  [[nodiscard]] static bool asks(Lesson lesson) {
    lesson.questions.clear();
    for (const AskInfo& ask : vocabulary().tour(lesson.tour)->asks)
      lesson.questions.push_back({std::string(ask.name), {}});
    const LessonRun run = run_lesson(std::move(lesson));
    return std::any_of(run.frames.begin(), run.frames.end(),
                       [](const Frame& frame) { return frame.question >= 0; });
  }

  /// The first frame is in the page itself, for who has no script and until it has started; of the
  /// playground the last one, which is what it shows first.
  void write_page(const Lesson& lesson, std::map<std::string, std::string> parts,
                  const Lesson* next, const Lesson* in_space) {
    const Json data = page_data(lesson, parts["kind"]);
    Player player(faces_of(fonts_), themes_, terms_);
    const auto ask = [&](const Json& request) {
      Json answer = Json::parse(player.answer(request.dump()));
      if (answer.contains("problem")) {
        throw std::runtime_error(
            fmt::format("{}: {}", lesson.id, answer["problem"].get<std::string>()));
      }
      return answer;
    };
    Json open = {{"do", "open"}, {"lesson", data["lesson"]}, {"name", data["name"]}};
    if (const auto& file = lesson.settings.file)
      open["files"][fs::path(file->path).filename().string()] = *file->text;
    const bool is_playground = data["kind"] == "playground";
    const bool is_practice = data["kind"] == "practice";
    if (is_playground) open["depth"] = true;
    const Json opened = ask(is_practice ? Json{{"do", "practise"},
                                               {"chapter", lesson.chapter},
                                               {"seed", 0},
                                               {"answers", Json::array()}}
                                        : open);
    if (is_playground) {
      const Json last = ask({{"do", "go"}, {"to", opened["count"].get<int>() - 1}});
      parts["answer"] = answer_table(last["outcome"]);
    }
    const bool two = lesson.views.size() > 1;
    std::map<std::string, std::map<std::string, std::string>> pictures;  // by kind and size
    // In two sizes: those of the narrowest page with one column and with two, so that type never
    // shrinks.
    for (const auto& [name, width, height, panel] :
         {std::tuple("narrow", 360, two ? 620 : 325, 360),
          {"wide", 640, two ? 320 : 400, two ? 400 : 440}}) {
      const Json first = ask({{"do", "layout"},
                              {"width", width},
                              {"height", height},
                              {"panel", panel},
                              {"timeline", width},
                              {"theme", "light"}});
      for (const char* key : {"prose", "position", "caption", "detail"})
        parts[key] = escape_html(first[key].get<std::string>());
      parts["count"] =
          fmt::format("{} / {}", first["index"].get<int>() + 1, first["count"].get<int>());
      for (const char* key : {"stage", "panel"}) pictures[key][name] = still(first.value(key, ""));
    }
    for (auto& [key, sizes] : pictures) {
      // A page stays small: a figure of that many marks is there in the size that fits anywhere.
      constexpr std::size_t kMost = 1 << 16;
      if (sizes["narrow"].size() + sizes["wide"].size() > kMost) sizes = {{"any", sizes["narrow"]}};
      for (const auto& [name, svg] : sizes)
        parts[key] += fmt::format("<div class=\"{}\">\n{}</div>\n", name, svg);
    }
    parts["title"] = escape_html(lesson.title);
    parts["views"] = two ? "two" : "one";
    parts["nav"] = nav(lesson.id + ".html", next);
    std::string links;
    if (next) links += link(next->id + ".html", "Next lesson: " + next->title);
    if (next && in_space) links += "<br>\n";
    if (in_space) links += link(in_space->id + ".html", "In space: " + in_space->title);
    if (!is_practice && options_.index && has_practice(lesson.chapter) &&
        (!next || next->chapter != lesson.chapter))
      links = practice_link(lesson.chapter) + "<br>\n" + links;
    if (!links.empty()) parts["next"] = fmt::format("<p id=\"next\" hidden>{}</p>\n", links);
    parts["asks"] = data["asks"].get<bool>() ? "" : " hidden";
    std::tie(parts["transcript"], parts["longest"]) = transcript(lesson);
    if (is_practice) parts["transcript"].clear();  // it would answer
    parts["data"] = script_text(data);
    write(lesson.id, filled(page_, parts));
  }

  /// A page around the lessons: no figure of its own, and no program.
  void write_plain(const std::string& name, const std::string& title, const std::string& about,
                   const std::map<std::string, std::string>& in_body) {
    std::map<std::string, std::string> parts = shared_;
    parts["scripts"] = plain_scripts_;
    parts["name"] = name;
    parts["title"] = title;
    parts["about"] = about;
    parts["nav"] = nav(name + ".html", nullptr);
    parts["main"] = filled(read_whole(assets_ / "web" / (name + ".html")), in_body);
    write(name, filled(read_whole(assets_ / "web" / "plain.html"), parts));
  }

  /// The last frame without its words, which are too small to read there, and what it is about.
  [[nodiscard]] std::string card(const Lesson& lesson) {
    Lesson unasked = lesson;
    unasked.questions.clear();
    const LessonRun run = run_lesson(std::move(unasked));
    EffectGraph effects(run);
    LessonPictures pictures(run, effects, fonts_, {640.0, 360.0, 1.0, true});
    Picture picture = pictures.picture(answering_index(run));
    std::erase_if(picture.marks, [](const Mark& mark) {
      return std::holds_alternative<Text>(mark.shape) || mark.role == "view-title.box";
    });
    return fmt::format("<li><a href=\"{}.html\">{}<strong>{}</strong><span>{}</span></a></li>\n",
                       escape_html(lesson.id), images_of(picture, lesson.id),
                       escape_html(lesson.title), escape_html(pictures.texts().front().prose));
  }

  /// A picture in a light and a dark theme, of which a page shows one.
  [[nodiscard]] std::string images_of(const Picture& picture, const std::string& name) {
    std::string images;
    for (const bool dark : {false, true}) {
      const std::string svg =
          to_svg(picture, fonts_, dark ? dark_ : theme_, "", shares() ? signature() : "");
      images += fmt::format(
          "<img class=\"{}\" src=\"{}\" width=\"{:g}\" height=\"{:g}\" alt=\"\" loading=\"lazy\">",
          dark ? "dim" : "bright",
          shares() ? escape_html(put_beside(card_file(name, dark), svg))
                   : "data:image/svg+xml;base64," + base64(svg),
          picture.width, picture.height);
    }
    return images;
  }

  /// The map of the course, whose tiles lead to the chapters of the index.
  [[nodiscard]] std::string map_of_chapters(const Lesson& map,
                                            const std::map<int, std::string>& chapters) {
    const LessonRun run = run_lesson(map);
    EffectGraph effects(run);
    LessonPictures pictures(run, effects, fonts_, {1100.0, 350.0, 1.0, true});
    Picture picture = pictures.picture(static_cast<int>(run.frames.size()) - 1);
    std::string links;
    int chapter = 0;
    std::erase_if(picture.marks,
                  [](const Mark& mark) { return mark.role.starts_with("view-title"); });
    for (Mark& mark : picture.marks) {
      if (mark.role == "map.title") std::get<Text>(mark.shape).style = type::kText;
      if (mark.role.starts_with("map.tile")) mark.role = "map.tile";  // none is the current one
    }
    for (const Rect& tile : tiles_of_map(picture)) {
      ++chapter;
      const auto title = chapters.find(chapter);
      links +=
          fmt::format("<a href=\"#chapter-{}\" aria-label=\"Chapter {}: {}\" style=\"{}\"></a>\n",
                      chapter, chapter, title == chapters.end() ? "" : escape_html(title->second),
                      style_of_tile(tile, Point(picture.width, picture.height)));
    }
    return fmt::format("<nav class=\"map\" aria-label=\"Chapters\">{}\n{}</nav>\n",
                       images_of(picture, "map"), links);
  }

  void write(const std::string& name, const std::string& text) {
    const fs::path file = file_of(options_, name);
    kept_.push_back(file.filename().string());
    write_file(file, text);
  }

  void write_file(const fs::path& file, const std::string& text) {
    write_whole(file, text);
    files_.push_back(file);
    digests_ += hex_digest(text);
  }

  const SiteOptions& options_;
  fs::path share_;
  fs::path assets_;
  Fonts fonts_;
  Theme theme_;
  Theme dark_;
  std::map<std::string, std::string> themes_;
  std::string terms_ = read_whole(assets_ / "terms.toml");
  std::string module_;  ///< The program for browsers, compressed.
  Common common_;
  std::map<std::string, std::string> shared_;  ///< Parts that all pages have.
  std::string plain_scripts_;                  ///< Sources of scripts, of pages without a program.
  std::map<std::string, std::string> beside_;  ///< Files beside the pages, by name.
  std::vector<std::string> kept_;              ///< Addresses that a browser keeps.
  std::string digests_;                        ///< The digests of all files.
  std::string page_ = read_whole(assets_ / "web" / "page.html");
  std::vector<fs::path> files_;
};

}  // namespace

std::vector<fs::path> export_site(const std::vector<Lesson>& lessons, const SiteOptions& wanted) {
  SiteOptions options = wanted;
  if (options.package) options.out_dir /= "pages";
  SiteWriter writer(options);
  std::error_code error;
  fs::create_directories(options.out_dir, error);
  if (!fs::is_directory(options.out_dir)) {
    throw std::runtime_error(fmt::format("cannot make the folder {}: {}", options.out_dir.string(),
                                         error ? error.message() : "there is a file"));
  }
  for (const char* folder : {"", "shared", "cards"}) remove_leftovers(options.out_dir / folder);
  if (!options.force) writer.refuse_foreign_files(lessons);
  for (std::size_t i = 0; i < lessons.size(); ++i) {
    const Lesson* next = options.index && i + 1 < lessons.size() ? &lessons[i + 1] : nullptr;
    const auto in_space = std::find_if(lessons.begin(), lessons.end(), [&](const Lesson& other) {
      return other.id == lessons[i].in_space;
    });
    writer.write_lesson(lessons[i], next, in_space == lessons.end() ? nullptr : &*in_space);
  }
  if (options.index || options.package) writer.write_playground();
  if (options.index) {
    writer.write_practice();
    writer.write_index(lessons);
    writer.write_about();
  }
  writer.write_files_beside_pages();
  if (options.package) writer.write_package(lessons);
  return std::move(writer).files();
}

}  // namespace gjkscope
