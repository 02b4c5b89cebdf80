#pragma once
// An App without a window: input goes to Dear ImGui directly, and what is drawn stays a draw list.

#include <imgui.h>

#include <memory>
#include <string>

#include "app.hpp"

namespace gjkscope::test {

class HeadlessApp {
 public:
  /// `state`: where unsaved work is kept; empty: nowhere.
  explicit HeadlessApp(const std::string& name = "", const std::filesystem::path& state = {});
  ~HeadlessApp();
  HeadlessApp(const HeadlessApp&) = delete;
  HeadlessApp& operator=(const HeadlessApp&) = delete;

  [[nodiscard]] App& app() { return *app_; }
  [[nodiscard]] Session& session() { return app_->session(); }
  /// Draws until Dear ImGui has seen all input.
  void settle();
  /// Draws until the small pictures of lessons are there. Without this call none are made: they
  /// take long.
  void make_thumbnails();
  /// One frame; `seconds` have passed.
  void frame(double seconds = 0.02);
  /// In pixels; see App::layout.
  void resize(double width, double height, double density = 1.0);
  void move(const Point& to);
  void button(bool down, int clicks = 1);
  void click(const Point& at, int clicks = 1);
  void drag(const Point& from, const Point& to);
  void wheel(double by);
  void key(const std::string& key, bool ctrl = false, bool shift = false);
  void type(const std::string& text);
  /// The place of a subject's mark; fails the test when there is none.
  [[nodiscard]] Point at(const Subject& subject);

 private:
  ImGuiContext* context_;
  std::unique_ptr<App> app_;
  std::unique_ptr<AtlasFonts> atlas_fonts_;
  double width_ = 1440.0;
  double height_ = 900.0;
  double density_ = 1.0;
  double now_ = 0.0;
};

}  // namespace gjkscope::test
