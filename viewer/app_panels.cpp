// The panels around the picture, and the dialogs.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "app.hpp"
#include "effects/registry.hpp"
#include "imgui_vec.hpp"
#include "lesson/names.hpp"

namespace gjkscope {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector2d;

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus;

/// A panel that fills `rect`. End it with ImGui::End.
void begin_panel(const char* name, const Rect& rect, ImGuiWindowFlags more = 0) {
  ImGui::SetNextWindowPos(vec(rect.min));
  ImGui::SetNextWindowSize(vec(rect.size()));
  ImGui::Begin(name, nullptr, kFixed | more);
}

/// Dear ImGui edits a buffer of fixed size.
bool input_text(const char* label, std::string& text, ImGuiInputTextFlags flags = 0) {
  std::array<char, 1024> buffer = {};
  text.copy(buffer.data(), buffer.size() - 1);
  const bool done = ImGui::InputText(label, buffer.data(), buffer.size(), flags);
  text = buffer.data();
  return done;
}

std::string number(double value, bool hex) {
  return hex ? fmt::format("{:a}", value) : fmt::format("{}", value);
}

/// A whole text as a number, decimal or hex float ("0x1.8p-1").
std::optional<double> read_number(const std::string& text) {
  if (text.empty()) return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (*end != '\0' || !std::isfinite(value)) return std::nullopt;
  return value;
}

template <class E>
bool choose_value(const char* label, E& value) {
  bool changed = false;
  if (ImGui::BeginCombo(label, std::string(name_of(value)).c_str())) {
    for (const auto& [name, candidate] : Named<E>::kTable) {
      if (ImGui::Selectable(std::string(name).c_str(), candidate == value) && candidate != value) {
        value = candidate;
        changed = true;
      }
    }
    ImGui::EndCombo();
  }
  return changed;
}

void wrapped(const std::string& text) {
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
  ImGui::PopTextWrapPos();
}

/// A row of a table with a name and texts.
void row(const std::string& name, const std::vector<std::string>& cells) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(name.c_str());
  for (const std::string& cell : cells) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(cell.c_str());
  }
}

constexpr ImGuiTableFlags kRuled =
    ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingStretchProp;

/// The first step at which two runs differ, and how; nothing when they do not. Step -1: they start
/// from other vertices.
std::optional<std::pair<int, std::string>> first_difference(const LessonRun& run,
                                                            const WideTrace& a,
                                                            const WideTrace& b) {
  const auto start_of = [&](const WideTrace& trace) {
    std::string names;
    for (int i = 0; i < trace.initial.simplex.count; ++i)
      names += fmt::format("{}{}", i > 0 ? " " : "",
                           run.pair_name(trace.initial.simplex.vertices[i].pair));
    return names;
  };
  if (start_of(a) != start_of(b))
    return std::pair(-1, fmt::format("start {} here, {} there", start_of(a), start_of(b)));
  for (std::size_t i = 0; i < std::min(a.steps.size(), b.steps.size()); ++i) {
    const gjk::Step<double, 2>& one = a.steps[i];
    const gjk::Step<double, 2>& other = b.steps[i];
    const auto at = [&](const std::string& what) {
      return std::pair(static_cast<int>(i), fmt::format("iteration {}, {}: {}", one.iteration,
                                                        name_of(one.phase), what));
    };
    if (one.phase != other.phase)
      return at(fmt::format("here {}, there {}", name_of(one.phase), name_of(other.phase)));
    if (one.after.region != other.after.region) return at("another region");
    if (one.phase == gjk::Phase::support && one.after.support.pair != other.after.support.pair)
      return at(fmt::format("support {} here, {} there", run.pair_name(one.after.support.pair),
                            run.pair_name(other.after.support.pair)));
    if (one.after.stop != other.after.stop)
      return at(
          fmt::format("{} here, {} there", name_of(one.after.stop), name_of(other.after.stop)));
    if ((one.after.d - other.after.d).norm() > 0.0)
      return at(fmt::format("d = ({}, {}) here, ({}, {}) there", one.after.d.x(), one.after.d.y(),
                            other.after.d.x(), other.after.d.y()));
    if ((one.after.p - other.after.p).norm() > 0.0)
      return at(fmt::format("P = ({}, {}) here, ({}, {}) there", one.after.p.x(), one.after.p.y(),
                            other.after.p.x(), other.after.p.y()));
  }
  if (a.steps.size() == b.steps.size()) return std::nullopt;
  return std::pair(static_cast<int>(std::min(a.steps.size(), b.steps.size())),
                   std::string("one run goes on"));
}

ImVec4 color_of(const Color& c) {
  return {static_cast<float>(c.r) / 255.0f, static_cast<float>(c.g) / 255.0f,
          static_cast<float>(c.b) / 255.0f, 1.0f};
}
ImVec4 between(const ImVec4& a, const ImVec4& b, float share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z), 1.0f};
}

}  // namespace

void App::set_colors() const {
  if (is_dark()) {
    ImGui::StyleColorsDark();
  } else {
    ImGui::StyleColorsLight();
  }
  const ImVec4 paper = color_of(theme_.background());
  const ImVec4 ink = color_of(*theme_.style("title").fill);
  const ImVec4 card = color_of(theme_.style("card").fill.value_or(theme_.background()));
  const ImVec4 strong = color_of(*theme_.style("timeline.current").fill);
  ImVec4* colors = ImGui::GetStyle().Colors;
  colors[ImGuiCol_Text] = ink;
  colors[ImGuiCol_TextDisabled] = between(paper, ink, 0.6f);
  colors[ImGuiCol_WindowBg] = colors[ImGuiCol_PopupBg] = between(paper, ink, 0.05f);
  colors[ImGuiCol_Border] = between(paper, ink, 0.25f);
  colors[ImGuiCol_FrameBg] = card;
  colors[ImGuiCol_FrameBgHovered] = between(card, ink, 0.08f);
  colors[ImGuiCol_FrameBgActive] = between(card, ink, 0.14f);
  colors[ImGuiCol_Button] = card;
  colors[ImGuiCol_ButtonHovered] = between(card, ink, 0.1f);
  colors[ImGuiCol_ButtonActive] = between(card, strong, 0.35f);
  colors[ImGuiCol_Header] = between(card, strong, 0.25f);
  colors[ImGuiCol_HeaderHovered] = between(card, ink, 0.1f);
  colors[ImGuiCol_HeaderActive] = between(card, strong, 0.35f);
  colors[ImGuiCol_CheckMark] = colors[ImGuiCol_SliderGrab] = colors[ImGuiCol_SliderGrabActive] =
      strong;
  colors[ImGuiCol_TitleBgActive] = colors[ImGuiCol_TitleBg] = between(paper, ink, 0.12f);
  colors[ImGuiCol_TableRowBg] = colors[ImGuiCol_WindowBg];
  colors[ImGuiCol_TableRowBgAlt] = between(paper, ink, 0.09f);
  colors[ImGuiCol_Separator] = between(paper, ink, 0.15f);
}

void App::draw_toolbar() {
  begin_panel("##toolbar", {{0.0, 0.0}, {window_width_, area_.min.y()}},
              ImGuiWindowFlags_NoScrollbar);
  const ImGuiStyle& style = ImGui::GetStyle();
  const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  // Beside what came before, or in a new row where the window is too narrow.
  bool is_first = true;
  const auto place = [&](float width) {
    if (!is_first && ImGui::GetItemRectMax().x + style.ItemSpacing.x + width <= end)
      ImGui::SameLine();
    is_first = false;
  };
  const auto width_of = [&](const char* text) {
    return ImGui::CalcTextSize(text).x + 2.0f * style.FramePadding.x;
  };
  const auto button = [&](const char* text, const char* command, const char* help) {
    place(width_of(text));
    if (ImGui::Button(text)) run_command(command);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
  };
  button("|<", "First frame", "First frame (Home)");
  button("<<", "Iteration before", "Iteration before (Shift+Left)");
  button("<", "Step before", "Step before (Left)");
  button(playing_ ? "Pause" : "Play", "Play or pause", "Play or pause (Space)");
  button(">", "Next step", "Next step (Right)");
  button(">>", "Next iteration", "Next iteration (Shift+Right)");
  button(">|", "Last frame", "Last frame (End)");
  const auto speed_width = static_cast<float>(86.0 * ui_scale_);
  place(speed_width);
  ImGui::SetNextItemWidth(speed_width);
  auto speed = static_cast<float>(frames_per_second_);
  if (ImGui::SliderFloat("##speed", &speed, 0.25f, 16.0f, "%.2g / s", ImGuiSliderFlags_Logarithmic))
    frames_per_second_ = std::clamp(static_cast<double>(speed), 0.25, 32.0);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Frames a second ([ and ])");
  button("Undo", "Undo", "Undo (Ctrl+Z)");
  button("Redo", "Redo", "Redo (Ctrl+Y)");
  button("Fit", "Fit", "Show all of it (F)");
  bool snaps = snap_ > 0.0;
  place(ImGui::GetFrameHeight() + style.ItemInnerSpacing.x + ImGui::CalcTextSize("Snap").x);
  if (ImGui::Checkbox("Snap", &snaps)) run_command("Snap to a grid");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Snap to a grid of 0.25 (G)");
  const auto drawer = [&](const char* text, const char* command, Drawer which) {
    const bool on = drawer_ == which;
    place(width_of(text));
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    if (ImGui::Button(text)) run_command(command);
    if (on) ImGui::PopStyleColor();
  };
  drawer("Shapes", "Shapes", Drawer::shapes);
  drawer("Values", "Values", Drawer::values);
  drawer("Numerics", "Numerics", Drawer::numerics);
  drawer("Effects", "Effects", Drawer::effects);
  drawer("Study", "Study", Drawer::study);
  drawer("Predict", "Predict mode", Drawer::predict);
  button("Present", "Presenter mode", "Presenter mode (F5)");
  button("Open", "Open", "Open a lesson or a case (Ctrl+O)");
  button("Save", "Save", "Save (Ctrl+S)");
  button("Export", "Export frames", "Export frames (Ctrl+E)");
  button("?", "Keys", "All keys (?)");
  toolbar_height_ = ImGui::GetItemRectMax().y - ImGui::GetWindowPos().y + style.WindowPadding.y;
  toolbar_end_ = Point(ImGui::GetItemRectMax().x + style.ItemSpacing.x, ImGui::GetItemRectMin().y);
  ImGui::End();
}

void App::draw_lessons() {
  begin_panel("##lessons", {{0.0, area_.min.y()}, {area_.min.x(), window_height_}});
  static constexpr std::array<const char*, 7> kChapters = {"",
                                                           "1  Point to segment",
                                                           "2  Point to triangle",
                                                           "3  Point to polygon",
                                                           "4  Polygon to polygon",
                                                           "5  Minkowski sums",
                                                           "6  Numerics"};
  int chapter = -1;
  for (const ListedLesson& lesson : lessons_) {
    if (lesson.chapter != chapter) {
      chapter = lesson.chapter;
      const bool named = chapter > 0 && chapter < static_cast<int>(kChapters.size());
      ImGui::Spacing();
      ImGui::TextDisabled("%s", named ? kChapters[static_cast<std::size_t>(chapter)] : "Other");
    }
    const bool open = session_.lesson().path == lesson.file.string();
    ImGui::PushID(lesson.file.c_str());
    if (!lesson.problem.empty()) {
      ImGui::TextDisabled("! %s", lesson.id.c_str());
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", lesson.problem.c_str());
    } else {
      if (ImGui::Selectable(lesson.id.c_str(), open)) open_path(lesson.file);
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", lesson.title.c_str());
    }
    ImGui::PopID();
  }
  ImGui::End();
}

void App::draw_drawer() {
  if (drawer_ == Drawer::none) return;
  begin_panel("##drawer", {{area_.max.x(), area_.min.y()}, {window_width_, window_height_}});
  switch (drawer_) {
    case Drawer::shapes:
      draw_shapes();
      break;
    case Drawer::values:
      draw_values();
      break;
    case Drawer::numerics:
      draw_numerics();
      break;
    case Drawer::effects:
      draw_effects();
      break;
    case Drawer::predict:
      draw_predict();
      break;
    case Drawer::study:
      draw_study();
      break;
    case Drawer::none:
      break;
  }
  ImGui::End();
}

void App::draw_shapes() {
  using Kind = Subject::Kind;
  ImGui::Text("Shapes");
  wrapped(
      "Drag vertices, shapes and the handle of a selected shape on the stage. Double click an edge "
      "to add a vertex. Or type: decimal, or hex like 0x1.8p-1.");
  ImGui::Checkbox("Hexadecimal", &hex_);
  for (const edit::Which which : {edit::Which::x, edit::Which::y}) {
    const LessonShape& shape = edit::shape_of(session_.lesson(), which);
    const bool is_x = which == edit::Which::x;
    ImGui::PushID(is_x ? 0 : 1);
    ImGui::Separator();
    ImGui::Text("%s: %d %s", shape.name.c_str(), static_cast<int>(shape.vertices.size()),
                shape.vertices.size() == 1 ? "point" : "vertices");
    if (shape.vertices.size() > edit::kMostEditable) {
      ImGui::TextDisabled("too many to list");
      ImGui::PopID();
      continue;
    }
    std::optional<std::pair<int, Vector2d>> typed;
    for (int i = 0; i < static_cast<int>(shape.vertices.size()); ++i) {
      const auto at = static_cast<std::size_t>(i);
      ImGui::PushID(i);
      const Subject subject =
          is_x ? Subject{Kind::vertex_of_x, i} : Subject{Kind::vertex_of_y, -1, i};
      const auto name_width = static_cast<float>(36.0 * ui_scale_);
      if (ImGui::Selectable(shape.vertex_names[at].c_str(), selected_ == subject, 0,
                            ImVec2(name_width, 0.0f)))
        selected_ = subject;
      Vector2d value = shape.vertices[at];
      for (int axis = 0; axis < 2; ++axis) {
        ImGui::SameLine();
        ImGui::PushID(axis);
        ImGui::SetNextItemWidth(static_cast<float>(122.0 * ui_scale_));
        std::string text = number(value[axis], hex_);
        if (input_text("##value", text, ImGuiInputTextFlags_EnterReturnsTrue)) {
          if (const std::optional<double> read = read_number(text)) {
            value[axis] = *read;
            typed = {i, value};
          } else {
            say(fmt::format("'{}' is not a number: expected one like 0.25, 1e-6 or 0x1.8p-1", text),
                true);
          }
        }
        ImGui::PopID();
      }
      ImGui::PopID();
    }
    if (typed) {
      Lesson tried = session_.lesson();
      edit::shape_of(tried, which).vertices[static_cast<std::size_t>(typed->first)] = typed->second;
      if (is_sound(tried) &&
          !session_.change("type a value", [&](Lesson& lesson) { lesson = tried; }))
        say(session_.problem(), true);
    }
    ImGui::PopID();
  }
  ImGui::Separator();
  if (ImGui::Button("Delete the selected vertex")) run_command("Delete the selected vertex");
}

void App::draw_values() {
  ImGui::Text("Values of this frame");
  ImGui::Checkbox("Hexadecimal", &hex_);
  const LessonRun& run = session_.run();
  const Frame& frame = session_.frame();
  const gjk::State<double, 2>& state = run.state(frame);
  if (!ImGui::BeginTable("##values", 2, kRuled)) return;
  const auto value = [&](const std::string& name, double v) { row(name, {number(v, hex_)}); };
  const auto point = [&](const std::string& name, const Vector2d& v) {
    value(name + ".x", v.x());
    value(name + ".y", v.y());
  };
  for (int i = 0; i < state.simplex.count; ++i) {
    const std::string name = run.pair_name(state.simplex.vertices[i].pair);
    point(name, state.simplex.vertices[i].w);
    if (frame.step >= 0) value("weight of " + name, state.simplex.weights[i]);
  }
  if (frame.step >= 0) {
    point("P", state.p);
    point("d", state.d);
    value("lower bound", run.bounds(frame).lower);
    value("upper bound", run.bounds(frame).upper);
  }
  const gjk::Result<double, 2>& result = run.run(frame).trace.result;
  value("distance in the end", result.distance);
  row("stop in the end", {std::string(name_of(result.stop))});
  row("verdict in the end", {std::string(name_of(result.verdict))});
  row("iterations", {std::to_string(result.iterations)});
  ImGui::EndTable();
}

bool App::choose_options(ScalarKind& scalar, gjk::Options& options) {
  bool changed = choose_value("scalar", scalar);
  changed |= choose_value("direction", options.direction_rule);
  changed |= choose_value("regions", options.region_order);
  changed |=
      ImGui::Checkbox("stop when a support point repeats", &options.stop_on_repeated_support);
  changed |= ImGui::Checkbox("stop without progress", &options.stop_on_no_progress);
  double tolerance = options.tolerance;
  ImGui::InputDouble("tolerance", &tolerance, 0.0, 0.0, "%.3g");
  if (ImGui::IsItemDeactivatedAfterEdit() && tolerance != options.tolerance) {
    options.tolerance = tolerance;
    changed = true;
  }
  int cap = options.iteration_cap;
  ImGui::InputInt("cap", &cap);
  if (cap != options.iteration_cap) {
    options.iteration_cap = cap;
    changed = true;
  }
  bool centres = options.start.count == 0;
  if (ImGui::Checkbox("start between the centres", &centres)) {
    options.start = {};
    options.start.count = centres ? 0 : 1;
    changed = true;
  }
  return changed;
}

gjk::Options App::options_beside() const {
  const gjk::Options& here = session_.run().lesson.options;
  if (!beside_options_) return here;
  gjk::Options there = *beside_options_;
  if (there.start.count == 0) return there;
  there.start = here.start;  // the vertices of other shapes may not be there
  there.start.count = std::max(here.start.count, 1);
  return there;
}

const PositionedRun& App::run_beside() {
  const LessonRun& run = session_.run();
  const Beside wanted{session_.version(), session_.frame().run, beside_scalar_, options_beside()};
  if (!beside_run_ || beside_ != wanted) {
    beside_run_ = run_again(run.run(session_.frame()), wanted.options, wanted.scalar);
    beside_ = wanted;
  }
  return *beside_run_;
}

void App::draw_numerics() {
  ImGui::Text("How the run computes");
  Lesson wanted = session_.lesson();
  if (choose_options(wanted.scalar, wanted.options) && is_sound(wanted) &&
      !session_.change("numerics", [&](Lesson& lesson) { lesson = wanted; }))
    say(session_.problem(), true);

  ImGui::Separator();
  ImGui::PushID("beside");
  const LessonRun& run = session_.run();
  ImGui::Text("Beside it, on the same shapes");
  // Through a lesson, so that what a lesson could not say is refused with the same words.
  Lesson other = run.lesson;
  other.options = options_beside();
  if (choose_options(beside_scalar_, other.options) && is_sound(other) &&
      other.options != options_beside())
    beside_options_ = other.options;
  if (ImGui::Button("The same options, exact")) {
    beside_scalar_ = ScalarKind::exact;
    beside_options_.reset();
  }
  ImGui::PopID();
  ImGui::Checkbox("Hexadecimal", &hex_);
  const PositionedRun& here = run.run(session_.frame());
  const PositionedRun& there = run_beside();
  const gjk::Result<double, 2>& a = here.trace.result;
  const gjk::Result<double, 2>& b = there.trace.result;
  if (ImGui::BeginTable("##beside", 3, kRuled)) {
    row("", {"this run", "beside it"});
    row("scalar", {std::string(name_of(run.lesson.scalar)), std::string(name_of(beside_scalar_))});
    row("distance", {number(a.distance, hex_), number(b.distance, hex_)});
    row("lower", {number(a.lower, hex_), number(b.lower, hex_)});
    row("upper", {number(a.upper, hex_), number(b.upper, hex_)});
    row("verdict", {std::string(name_of(a.verdict)), std::string(name_of(b.verdict))});
    row("stop", {std::string(name_of(a.stop)), std::string(name_of(b.stop))});
    row("iterations", {std::to_string(a.iterations), std::to_string(b.iterations)});
    ImGui::EndTable();
  }
  const auto difference = first_difference(run, here.trace, there.trace);
  if (!difference)
    return wrapped("The two runs take the same decisions and have the same numbers.");
  wrapped("First difference: " + difference->second);
  if (!ImGui::Button("Go there")) return;
  const auto& frames = run.frames;
  const auto shows = std::find_if(frames.begin(), frames.end(), [&](const Frame& frame) {
    return frame.run == session_.frame().run && frame.step >= difference->first;
  });
  if (shows != frames.end()) session_.go_to(static_cast<int>(shows - frames.begin()));
}

void App::draw_effects() {
  ImGui::Text("Effects");
  wrapped("What a view calls for is computed when a mark needs it, and not otherwise.");
  EffectGraph& effects = session_.effects();
  Lesson wanted = session_.lesson();
  bool changed = false;
  for (std::size_t i = 0; i < wanted.views.size(); ++i) {
    if (!shows_shapes(wanted.views[i].kind)) continue;
    ImGui::PushID(static_cast<int>(i));
    ImGui::Separator();
    ImGui::Text("In %s", wanted.views[i].kind == ViewKind::world ? "the world" : "the difference");
    std::vector<std::string>& called = wanted.views[i].effects;
    for (const EffectInfo& info : registered_effects()) {
      if (info.used_by != "view") continue;
      const std::string name(info.name);
      bool on = std::find(called.begin(), called.end(), name) != called.end();
      if (ImGui::Checkbox(name.c_str(), &on)) {
        if (on) {
          called.push_back(name);
        } else {
          std::erase(called, name);
        }
        changed = true;
      }
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(info.summary).c_str());
      const EffectCount count = effects.count(info.name);
      ImGui::SameLine(static_cast<float>(210.0 * ui_scale_));
      if (count.runs > 0) {
        ImGui::Text("%ld x  %.3f ms", count.runs, 1e3 * count.seconds);
      } else {
        ImGui::TextDisabled("not run");
      }
    }
    ImGui::PopID();
  }
  if (changed && is_sound(wanted) &&
      !session_.change("effects", [&](Lesson& lesson) { lesson = wanted; }))
    say(session_.problem(), true);
}

void App::draw_predict() {
  ImGui::Text("Predict");
  wrapped(
      "Before a step is shown, say what it will do: click it on the stage, click here, or press "
      "its "
      "number. The answer is the run's, on any shapes.");
  const int asked = static_cast<int>(session_.answers().size());
  ImGui::Separator();
  ImGui::Text("Score: %d of %d", session_.right_answers(), asked);
  if (last_answer_) {
    const Answer& given = session_.answers().back();
    ImGui::TextColored(
        *last_answer_ ? ImVec4(0.0f, 0.62f, 0.45f, 1.0f) : ImVec4(0.84f, 0.37f, 0.0f, 1.0f), "%s",
        *last_answer_ ? "Right." : "Not so.");
    if (!*last_answer_) {
      ImGui::SameLine();
      ImGui::Text("It was %s.", given.right.c_str());
    }
  }
  ImGui::Separator();
  if (const FrameQuestion* question = session_.question()) {
    wrapped(session_.text().caption);
    const std::vector<std::string> choices = question->choices;
    for (std::size_t i = 0; i < choices.size(); ++i) {
      if (ImGui::Button(fmt::format("{}  {}", i + 1, choices[i]).c_str(), ImVec2(-1.0f, 0.0f)))
        return answer(choices[i]);
    }
  } else {
    wrapped("Go on with Right.");
    if (ImGui::Button("Next", ImVec2(-1.0f, 0.0f))) run_command("Next step");
  }
  ImGui::Separator();
  if (asked > 0 && ImGui::Button("Save the answers as JSON")) {
    dialog_ = Dialog::save_answers;
    field_ = "answers.json";
  }
  if (asked > 0 && ImGui::Button("Forget the answers")) {
    session_.forget_answers();
    last_answer_.reset();
  }
}

void App::draw_message() {
  const std::string& text = message_.empty() ? session_.problem() : message_;
  if (text.empty()) return;
  const bool error = message_.empty() || message_is_error_;
  // Behind the buttons, where there is nothing to cover; else on the line of the title.
  const ImVec2 padding = ImGui::GetStyle().FramePadding;
  const double width = ImGui::CalcTextSize(text.c_str()).x + 2.0f * padding.x;
  if (!presenting_ && toolbar_end_.x() + width < window_width_) {
    ImGui::SetNextWindowPos(vec(toolbar_end_));
  } else {
    ImGui::SetNextWindowPos(vec({area_.max.x(), area_.min.y() + 2.0 * ui_scale_}), ImGuiCond_Always,
                            ImVec2(1.0f, 0.0f));
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::SetNextWindowBgAlpha(0.95f);
  ImGui::Begin("##message", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoMove);
  if (error) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.84f, 0.25f, 0.0f, 1.0f));
  ImGui::PushTextWrapPos(static_cast<float>(std::max(area_.size().x() - 40.0, 80.0)));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  if (error) ImGui::PopStyleColor();
  ImGui::End();
  ImGui::PopStyleVar();
}

void App::draw_dialogs() {
  if (dialog_ == Dialog::none) {
    dialog_shown_ = Dialog::none;
    return;
  }
  const bool fresh = dialog_ != dialog_shown_;
  dialog_shown_ = dialog_;
  const auto width = static_cast<float>(std::min(620.0 * ui_scale_, 0.95 * window_width_));
  const auto height = static_cast<float>(std::min(520.0 * ui_scale_, 0.9 * window_height_));
  ImGui::SetNextWindowPos(
      ImVec2(static_cast<float>(0.5 * window_width_), static_cast<float>(0.5 * window_height_)),
      ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(ImVec2(width, height));
  bool open = true;
  constexpr std::array<const char*, 7> kTitles = {"",
                                                  "Open a lesson, a case or a folder",
                                                  "Save as a lesson (.toml) or a case (.json)",
                                                  "Export frames into a folder",
                                                  "Keys",
                                                  "Any command",
                                                  "Save the answers"};
  ImGui::Begin(kTitles[static_cast<std::size_t>(dialog_)], &open,
               ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
  if (fresh) ImGui::SetWindowFocus();
  const auto field = [&](const char* label, std::string& text) {
    if (fresh) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0f);
    return input_text(label, text, ImGuiInputTextFlags_EnterReturnsTrue);
  };
  switch (dialog_) {
    case Dialog::open:
      draw_open_dialog(field("##path", field_));
      break;
    case Dialog::save: {
      const bool entered = field("##path", field_);
      if ((ImGui::Button("Save") || entered) && !field_.empty()) {
        dialog_ = Dialog::none;
        save_to(field_);
      }
      break;
    }
    case Dialog::save_answers: {
      const bool entered = field("##path", field_);
      if ((ImGui::Button("Save") || entered) && !field_.empty()) {
        dialog_ = Dialog::none;
        save_answers_to(field_);
      }
      break;
    }
    case Dialog::export_frames: {
      field("##path", field_);
      if (ImGui::Button("This frame") && !field_.empty()) {
        dialog_ = Dialog::none;
        export_to(field_, false);
      }
      ImGui::SameLine();
      if (ImGui::Button("All frames, with an index") && !field_.empty()) {
        dialog_ = Dialog::none;
        export_to(field_, true);
      }
      break;
    }
    case Dialog::help: {
      std::string group;
      for (const Command& command : commands_) {
        if (command.keys.empty() || command.name.starts_with("Answer ")) continue;
        if (command.group != group) {
          group = command.group;
          ImGui::Spacing();
          ImGui::TextDisabled("%s", group.c_str());
        }
        ImGui::Text("%s", fmt::format("{}", fmt::join(command.keys, ", ")).c_str());
        ImGui::SameLine(static_cast<float>(190.0 * ui_scale_));
        ImGui::TextUnformatted(command.name.c_str());
      }
      ImGui::Spacing();
      ImGui::TextDisabled("Mouse");
      wrapped(
          "Drag a vertex, a shape, the handle of a selected shape, the timeline, or the empty "
          "stage. "
          "Wheel: zoom. Double click an edge: add a vertex; elsewhere: show all. Click a line of "
          "the "
          "pseudocode: go to its next run.");
      break;
    }
    case Dialog::palette:
      draw_palette(field("##filter", filter_));
      break;
    case Dialog::none:
      break;
  }
  ImGui::End();
  if (!open) dialog_ = Dialog::none;
}

void App::draw_open_dialog(bool entered) {
  const fs::path typed(field_);
  std::error_code none;
  if (entered && fs::is_regular_file(typed, none)) {
    dialog_ = Dialog::none;
    return open_path(typed);
  }
  if (entered && !fs::is_directory(typed, none))
    say(fmt::format("there is no file '{}'", field_), true);
  ImGui::TextDisabled("Recent");
  for (const std::string& path : recent_) {
    if (ImGui::Selectable(path.c_str())) {
      dialog_ = Dialog::none;
      return open_path(path);
    }
  }
  ImGui::Separator();
  const fs::path folder = fs::is_directory(typed, none)
                              ? typed
                              : (typed.has_parent_path() ? typed.parent_path() : fs::path("."));
  ImGui::TextDisabled("%s", folder.c_str());
  std::vector<fs::path> entries;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
    const fs::path& path = entry.path();
    const bool wanted = path.extension() == ".toml" || path.extension() == ".json";
    if (entry.is_directory(none) || wanted) entries.push_back(path);
  }
  std::sort(entries.begin(), entries.end());
  if (ImGui::Selectable("..")) field_ = fs::absolute(folder).parent_path().string();
  for (const fs::path& path : entries) {
    const bool is_folder = fs::is_directory(path, none);
    if (!ImGui::Selectable((path.filename().string() + (is_folder ? "/" : "")).c_str())) continue;
    if (is_folder) {
      field_ = path.string();
    } else {
      dialog_ = Dialog::none;
      return open_path(path);
    }
  }
}

/// Commands and lessons whose names hold all of the words typed.
void App::draw_palette(bool entered) {
  const auto lower = [](std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
  };
  const std::string wanted = lower(filter_);
  std::function<void()> chosen;
  bool first = true;
  const auto offer = [&](const std::string& name, const std::string& keys,
                         const std::function<void()>& run) {
    if (lower(name).find(wanted) == std::string::npos) return;
    const bool clicked = ImGui::Selectable(name.c_str(), first);
    if (!keys.empty()) {
      ImGui::SameLine(static_cast<float>(400.0 * ui_scale_));
      ImGui::TextDisabled("%s", keys.c_str());
    }
    if (clicked || (entered && first)) chosen = run;
    first = false;
  };
  for (const Command& command : commands_)
    offer(command.name, command.keys.empty() ? "" : command.keys.front(), command.run);
  for (const ListedLesson& lesson : lessons_) {
    if (lesson.problem.empty())
      offer("Lesson " + lesson.id, "", [this, lesson] { open_path(lesson.file); });
  }
  for (const EffectInfo& info : registered_effects()) {
    if (info.used_by != "view") continue;
    offer(fmt::format("Effect {}", info.name), "", [this, name = std::string(info.name)] {
      Lesson tried = session_.lesson();
      std::vector<std::string>& called = tried.views.back().effects;
      if (std::erase(called, name) == 0) called.push_back(name);
      if (is_sound(tried)) session_.change("effects", [&](Lesson& lesson) { lesson = tried; });
    });
  }
  for (const auto& [name, scalar] : Named<ScalarKind>::kTable) {
    offer(fmt::format("Scalar {}", name), "", [this, scalar = scalar] {
      session_.change("numerics", [&](Lesson& lesson) { lesson.scalar = scalar; });
    });
  }
  if (!chosen) return;
  dialog_ = Dialog::none;
  chosen();
}

}  // namespace gjkscope
