// How the run computes, and a second run beside it.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <memory>
#include <stop_token>

#include "app.hpp"
#include "lesson/names.hpp"
#include "session/edit.hpp"
#include "subjects/second_run/table.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

/// The first step at which two runs differ, and how.
struct Difference {
  int step = -1;  ///< They start from other vertices.
  std::string words;
  /// A point or a direction in each, by name, where these differ.
  struct Pair {
    std::string name;
    Eigen::Vector3d here;
    Eigen::Vector3d there;
  };
  std::optional<Pair> pair = {};
};

/// Nothing when they do not differ. `origin`: where P is measured from, as on the stage.
std::optional<Difference> first_difference(const LessonRun& run, const WideTrace& a,
                                           const WideTrace& b, const Eigen::Vector3d& origin) {
  const auto start_of = [&](const WideTrace& trace) {
    std::string names;
    for (int i = 0; i < trace.initial.simplex.count; ++i)
      names += fmt::format("{}{}", i > 0 ? " " : "",
                           run.pair_name(trace.initial.simplex.vertices[i].pair));
    return names;
  };
  if (start_of(a) != start_of(b))
    return Difference{
        -1, fmt::format("started elsewhere, from {} here and {} there", start_of(a), start_of(b))};
  for (std::size_t i = 0; i < std::min(a.steps.size(), b.steps.size()); ++i) {
    const WideStep& one = a.steps[i];
    const WideStep& other = b.steps[i];
    const auto at = [&](const std::string& what, std::optional<Difference::Pair> pair = {}) {
      return Difference{
          static_cast<int>(i),
          fmt::format("iteration {}, {}: {}", one.iteration, name_of(one.phase), what),
          std::move(pair)};
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
    if (one.after.d != other.after.d)
      return at("another d", Difference::Pair{"d", one.after.d, other.after.d});
    if (one.after.p != other.after.p)
      return at("another P", Difference::Pair{"P", one.after.p + origin, other.after.p + origin});
  }
  if (a.steps.size() == b.steps.size()) return std::nullopt;
  return Difference{static_cast<int>(std::min(a.steps.size(), b.steps.size())), "one run goes on"};
}

/// Rows that choose how a run computes; true when one was changed.
bool choose_options(ScalarKind& scalar, gjk::Options& options) {
  field_label("scalar");
  bool changed = choose_value("##scalar", scalar);
  field_label("direction");
  changed |= choose_value("##direction", options.direction_rule);
  field_label("regions");
  changed |= choose_value("##regions", options.region_order);
  changed |=
      ImGui::Checkbox("stop when a support point repeats", &options.stop_on_repeated_support);
  changed |= ImGui::Checkbox("stop without progress", &options.stop_on_no_progress);
  double tolerance = options.tolerance;
  field_label("tolerance");
  ImGui::InputDouble("##tolerance", &tolerance, 0.0, 0.0, "%.3g");
  if (ImGui::IsItemDeactivatedAfterEdit() && tolerance != options.tolerance) {
    options.tolerance = tolerance;
    changed = true;
  }
  int cap = options.iteration_cap;
  field_label("cap");
  ImGui::InputInt("##cap", &cap);
  if (cap != options.iteration_cap) {
    options.iteration_cap = cap;
    changed = true;
  }
  bool centers = options.start.count == 0;
  if (ImGui::Checkbox("start between the centers", &centers)) {
    options.start = {};
    options.start.count = centers ? 0 : 1;
    changed = true;
  }
  return changed;
}

/// A number under another: alike up to where they differ, which is strong and has a line below it.
void draw_pair(App& app, const char* name, double here, double there) {
  const std::string one = number_text(here, app.hexadecimal);
  const std::string other = number_text(there, app.hexadecimal);
  const auto same = static_cast<std::size_t>(
      std::mismatch(one.begin(), one.end(), other.begin(), other.end()).first - one.begin());
  ImGui::TextDisabled("%s", name);
  ImGui::PushFont(app.panel_fonts().mono);
  for (const std::string& text : {one, other}) {
    ImGui::TextUnformatted(text.c_str(), text.c_str() + same);
    ImGui::SameLine(0.0f, 0.0f);
    ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", text.c_str() + same);
    if (same == text.size()) continue;
    const ImVec2 min = ImGui::GetItemRectMin();
    const ImVec2 max = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddLine({min.x, max.y}, max,
                                        ImGui::GetColorU32(ImGuiCol_CheckMark));
  }
  ImGui::PopFont();
}

/// Thrown by a run that nobody waits for any longer.
struct Stopped {};

struct Beside {
  /// The lesson's options where it has none of its own.
  ScalarKind scalar = ScalarKind::exact;
  std::optional<gjk::Options> options;
  /// The input that `run` was computed from.
  struct From {
    long version = 0;
    int run = 0;
    ScalarKind scalar = ScalarKind::exact;
    gjk::Options options;
    bool as_here = true;  ///< Both runs are asked to start in the same way.
    friend bool operator==(const From&, const From&) = default;
  };
  From from;
  std::optional<PositionedRun> run;
  /// Exact runs of large shapes take seconds: they are computed beside the window.
  std::future<PositionedRun> pending;
  From pending_from;
  std::stop_source stop;
  /// The one that the user has stopped.
  std::optional<From> given_up;

  ~Beside() { stop.request_stop(); }

  /// Whether `run` is the one that is wanted; where it is not, it will be, unless the user has
  /// stopped it.
  bool has(const PositionedRun& here, const From& wanted) {
    constexpr std::chrono::milliseconds kAtOnce(5);
    take(std::chrono::milliseconds(0));
    if (pending.valid() && (pending_from != wanted || given_up == wanted)) stop.request_stop();
    if (!pending.valid() && !(run && from == wanted) && given_up != wanted) {
      pending_from = wanted;
      stop = std::stop_source();
      pending = std::async(std::launch::async, [here, wanted, stopped = stop.get_token()] {
        return run_again(here, wanted.as_here ? started_as(here, wanted.options) : wanted.options,
                         wanted.scalar, [&] {
                           if (stopped.stop_requested()) throw Stopped();
                         });
      });
      take(kAtOnce);
    }
    return run && from == wanted;
  }

  void take(std::chrono::milliseconds patience) {
    if (!pending.valid() || pending.wait_for(patience) != std::future_status::ready) return;
    try {
      run = pending.get();
      from = pending_from;
    } catch (const Stopped&) {
    }
  }

  [[nodiscard]] gjk::Options options_for(const gjk::Options& here) const {
    if (!options) return here;
    gjk::Options there = *options;
    if (there.start.count == 0) return there;
    there.start = here.start;  // the vertices of other shapes may not be there
    there.start.count = std::max(here.start.count, 1);
    return there;
  }
};

/// The scalar beside, which is another one than the lesson's.
ScalarKind scalar_beside(const Lesson& lesson, ScalarKind wanted) {
  if (wanted != lesson.scalar) return wanted;
  return lesson.scalar == ScalarKind::exact ? ScalarKind::double_ : ScalarKind::exact;
}

/// Whether frames show steps of GJK, beside which those of another run can stand.
bool can_tell_twice(const Session& session) {
  const Tour& tour = *session.run().tour;
  return tour.follows_run && tour.needs.settings == &LessonSecond::kKind;
}

void tell_twice(App& app, ScalarKind wanted) {
  const Lesson& lesson = app.session().lesson();
  const std::optional<ScalarKind> scalar =
      second_of(lesson) ? std::nullopt : std::optional(scalar_beside(lesson, wanted));
  app.edit("second run", edit::with_second_run(lesson, scalar));
}

void draw_numerics(App& app, Beside& beside) {
  Session& session = app.session();
  heading(app, "How the run computes");
  ScalarKind scalar = session.lesson().scalar;
  gjk::Options options = session.lesson().options;
  bool warm_start = session.lesson().warm_start;
  bool changed = choose_options(scalar, options);
  if (session.lesson().path_of_shapes)
    changed |= ImGui::Checkbox("start from the simplex of the position before", &warm_start);
  if (changed) {
    Lesson wanted = session.lesson();
    wanted.scalar = scalar;
    wanted.options = options;
    wanted.warm_start = warm_start;
    app.edit("numerics", std::move(wanted));
  }

  ImGui::Separator();
  ImGui::PushID("beside");
  const LessonRun& run = session.run();
  heading(app, "Beside it, on the same shapes");
  options = beside.options_for(run.lesson.options);
  if (choose_options(beside.scalar, options)) {
    // Through a lesson, so that what a lesson could not say is refused with the same words.
    Lesson other = session.lesson();
    other.options = options;
    if (const std::vector<Problem> why = why_not_said(other); why.empty()) {
      beside.options = options;
    } else {
      app.say(to_string(why), true);
    }
  }
  if (ImGui::Button("The same options, exact")) {
    beside.scalar = ScalarKind::exact;
    beside.options.reset();
  }
  ImGui::PopID();
  if (can_tell_twice(session)) {
    const LessonSecond* second = second_of(run.lesson);
    bool on = second != nullptr;
    const std::string label = fmt::format("both runs on the stage{}###stage",
                                          on ? fmt::format(" ({})", name_of(*second->scalar)) : "");
    if (ImGui::Checkbox(label.c_str(), &on)) return tell_twice(app, beside.scalar);
    if (ImGui::IsItemHovered())
      ImGui::SetTooltip("A second run in the scalar beside, with the options of this one");
  }
  ImGui::Checkbox("Hexadecimal", &app.hexadecimal);

  const PositionedRun& here = run.run(session.frame());
  if (here.trace.is_empty()) return wrapped_text("This lesson runs another algorithm than GJK.");
  const gjk::Options there = beside.options_for(run.lesson.options);
  const Beside::From from{session.version(), session.frame().run, beside.scalar, there,
                          there.start == run.lesson.options.start};
  if (!beside.has(here, from)) {
    const bool stopped = beside.given_up == from;
    ImGui::TextDisabled(
        "%s", stopped ? "The run beside it was stopped." : "The run beside it is being computed.");
    if (ImGui::Button(stopped ? "Compute" : "Stop"))
      beside.given_up = stopped ? std::nullopt : std::optional(from);
    return;
  }
  const WideResult& a = here.trace.result;
  const WideResult& b = beside.run->trace.result;
  draw_pair(app, "distance: this run, and the one beside it", a.distance, b.distance);
  draw_pair(app, "lower bound", a.lower, b.lower);
  draw_pair(app, "upper bound", a.upper, b.upper);
  if (ImGui::BeginTable("##beside", 3, kRuled)) {
    const auto decided = [](const auto& result) {
      return result.settled ? "exact arithmetic" : "the run itself";
    };
    table_row("", {"this run", "beside it"});
    table_row("scalar",
              {std::string(name_of(run.lesson.scalar)), std::string(name_of(beside.scalar))});
    table_row("verdict", {std::string(name_of(a.verdict)), std::string(name_of(b.verdict))});
    table_row("decided by", {decided(a), decided(b)});
    table_row("stop", {std::string(name_of(a.stop)), std::string(name_of(b.stop))});
    table_row("iterations", {std::to_string(a.iterations), std::to_string(b.iterations)});
    ImGui::EndTable();
  }
  const Eigen::Vector3d origin =
      run.point_query() ? here.x().world[0] : Eigen::Vector3d(0.0, 0.0, 0.0);
  const std::optional<Difference> difference =
      first_difference(run, here.trace, beside.run->trace, origin);
  if (!difference)
    return wrapped_text("The two runs take the same decisions and have the same numbers.");
  wrapped_text("First difference: " + difference->words);
  if (const std::optional<Difference::Pair>& pair = difference->pair) {
    draw_pair(app, (pair->name + ".x: this run, and the one beside it").c_str(), pair->here.x(),
              pair->there.x());
    draw_pair(app, (pair->name + ".y").c_str(), pair->here.y(), pair->there.y());
    if (run.lesson.dimension == 3)
      draw_pair(app, (pair->name + ".z").c_str(), pair->here.z(), pair->there.z());
  }
  if (!ImGui::Button("Go there")) return;
  const auto& frames = run.frames;
  const auto shows = std::find_if(frames.begin(), frames.end(), [&](const Frame& frame) {
    return frame.run == session.frame().run && run.gjk_step(frame) >= difference->step;
  });
  if (shows != frames.end()) session.go_to(static_cast<int>(shows - frames.begin()));
}

}  // namespace

Drawer numerics_drawer(App& app) {
  const auto beside = std::make_shared<Beside>();
  Drawer drawer{"Numerics", "N", "Scalar, rules and stops, and another run beside this one",
                [&app, beside] { draw_numerics(app, *beside); }};
  drawer.waits = [beside] { return beside->pending.valid(); };
  drawer.commands = {{"Second run on the stage, or none",
                      "Edit",
                      {},
                      [&app, beside] { tell_twice(app, beside->scalar); },
                      [&app] { return can_tell_twice(app.session()); }},
                     {"Warm start along the path, or none",
                      "Edit",
                      {},
                      [&app] {
                        Lesson lesson = app.session().lesson();
                        lesson.warm_start = !lesson.warm_start;
                        app.edit("warm start", std::move(lesson));
                      },
                      [&app] { return app.session().lesson().path_of_shapes.has_value(); }}};
  return drawer;
}

}  // namespace gjkscope
