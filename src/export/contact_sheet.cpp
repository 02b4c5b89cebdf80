#include "export/contact_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/html.hpp"
#include "subjects/course_map/tiles.hpp"

namespace gjkscope {
namespace {

constexpr int kSidecarVersion = 2;

std::string figure(const ExportedLesson& lesson, const ExportedFrame& frame) {
  return fmt::format(
      R"(<figure id="{id}-{step}"{kind}><a href="{file}"><img src="{file}" width="{width}" height="{height}" loading="lazy" alt="{alt}"></a>)"
      R"(<figcaption><span class="step">{step}</span> {caption}<span class="detail">{detail}</span></figcaption></figure>)"
      "\n",
      fmt::arg("id", escape_html(lesson.id)), fmt::arg("step", frame.step),
      fmt::arg("kind", frame.text.question ? R"( class="question")" : ""),
      fmt::arg("file", escape_html(frame.file)), fmt::arg("width", lesson.width),
      fmt::arg("height", lesson.height), fmt::arg("alt", escape_html(alternative_text(frame.text))),
      fmt::arg("caption", escape_html(frame.text.caption)),
      fmt::arg("detail", escape_html(frame.text.detail)));
}

std::string section(const ExportedLesson& lesson) {
  const std::string prose = lesson.frames.empty() ? "" : lesson.frames.front().text.prose;
  std::string html = fmt::format(
      R"(<section id="{id}"><h2><a href="#{id}">{title}</a></h2>)"
      R"(<p class="meta">chapter {chapter}{source} · {count} frames · <code>{id}</code></p>)"
      R"(<p class="prose">{prose}</p><div class="frames">)"
      "\n",
      fmt::arg("id", escape_html(lesson.id)), fmt::arg("title", escape_html(lesson.title)),
      fmt::arg("chapter", lesson.chapter),
      fmt::arg("source", lesson.source.empty() ? "" : " · " + escape_html(lesson.source)),
      fmt::arg("count", lesson.frames.size()), fmt::arg("prose", escape_html(prose)));
  for (const ExportedFrame& frame : lesson.frames) html += figure(lesson, frame);
  return html + "</div></section>\n";
}

std::string contents(const std::vector<ExportedLesson>& lessons) {
  std::string html;
  int chapter = 0;
  for (const ExportedLesson& lesson : lessons) {
    if (lesson.chapter != chapter) {
      if (chapter != 0) html += "</ul>\n";
      chapter = lesson.chapter;
      html += fmt::format("<h2>Chapter {}</h2>\n<ul>\n", chapter);
    }
    html += fmt::format(R"(<li><a href="#{}">{}</a> <span>{}</span></li>)"
                        "\n",
                        escape_html(lesson.id), escape_html(lesson.title), lesson.frames.size());
  }
  return chapter == 0 ? html : html + "</ul>\n";
}

/// The map of the course, where it is among the lessons: its tiles lead to the first lesson of each
/// chapter.
std::string map_of_chapters(const std::vector<ExportedLesson>& lessons) {
  const auto map = std::find_if(lessons.begin(), lessons.end(),
                                [](const ExportedLesson& each) { return !each.tiles.empty(); });
  if (map == lessons.end()) return "";
  std::string html = fmt::format(R"(<div class="map"><img src="{}" width="{}" height="{}" alt="">)",
                                 escape_html(map->frames.back().file), map->width, map->height);
  for (std::size_t i = 0; i < map->tiles.size(); ++i) {
    const int chapter = static_cast<int>(i) + 1;
    const auto first =
        std::find_if(lessons.begin(), lessons.end(),
                     [&](const ExportedLesson& each) { return each.chapter == chapter; });
    if (first == lessons.end()) continue;
    html += fmt::format(R"(<a href="#{}" aria-label="Chapter {}" style="{}"></a>)",
                        escape_html(first->id), chapter,
                        style_of_tile(map->tiles[i], Point(map->width, map->height)));
  }
  return html + "</div>\n";
}

}  // namespace

std::string sidecar(const ExportedLesson& lesson) {
  using Json = nlohmann::ordered_json;
  Json frames = Json::array();
  for (const ExportedFrame& frame : lesson.frames) {
    Json values = Json::object();
    for (const auto& [name, value] : frame.text.values) values[name] = value;
    Json one = {{"step", frame.step},
                {"file", frame.file},
                {"position", frame.text.position},
                {"phase", frame.text.phase},
                {"iteration", frame.text.iteration},
                {"caption", frame.text.caption},
                {"detail", frame.text.detail},
                {"alt", alternative_text(frame.text)},
                {"prose", frame.text.prose},
                {"values", std::move(values)}};
    if (const std::optional<FrameQuestion>& question = frame.text.question) {
      one["question"] = {
          {"ask", question->ask}, {"choices", question->choices}, {"answer", question->answer}};
    }
    frames.push_back(std::move(one));
  }
  const Json json = {
      {"version", kSidecarVersion}, {"program", signature()},     {"lesson", lesson.id},
      {"title", lesson.title},      {"chapter", lesson.chapter},  {"source", lesson.source},
      {"theme", lesson.theme},      {"width", lesson.width},      {"height", lesson.height},
      {"steps", lesson.steps},      {"frames", std::move(frames)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string contact_sheet(const std::vector<ExportedLesson>& lessons, const std::string& page) {
  std::size_t frame_count = 0;
  std::string sections;
  for (const ExportedLesson& lesson : lessons) {
    frame_count += lesson.frames.size();
    sections += section(lesson);
  }
  const std::string summary = fmt::format("{} {}, {} frames", lessons.size(),
                                          lessons.size() == 1 ? "lesson" : "lessons", frame_count);
  // The lessons last: their words may hold anything, a mark of the template too.
  std::string html = with_content(page, "<!-- program -->", signature());
  html = with_content(std::move(html), "<!-- summary -->", summary);
  html = with_content(std::move(html), "<!-- contents -->",
                      map_of_chapters(lessons) + contents(lessons));
  return with_content(std::move(html), "<!-- lessons -->", sections);
}

}  // namespace gjkscope
