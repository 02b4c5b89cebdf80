#include "headless_app.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "fonts.hpp"
#include "imgui_keys.hpp"

namespace gjkscope::test {

using testing::fonts;
namespace {

/// The index of a key here is its index in Dear ImGui's KeysDown.
struct KeyOfPanels {
  std::string_view name;
  int key;
};
constexpr KeyOfPanels kKeysOfPanels[] = {
    {"Enter", ImGuiKey_Enter},      {"Tab", ImGuiKey_Tab},
    {"Space", ImGuiKey_Space},      {"Delete", ImGuiKey_Delete},
    {"Right", ImGuiKey_RightArrow}, {"Down", ImGuiKey_DownArrow},
    {"Escape", ImGuiKey_Escape},    {"A", ImGuiKey_A}};

}  // namespace

HeadlessApp::HeadlessApp(const std::string& name, const std::filesystem::path& state)
    : context_(ImGui::CreateContext()) {
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  take_keys_by_index(io);
  for (int i = 0; i < static_cast<int>(std::size(kKeysOfPanels)); ++i)
    io.KeyMap[kKeysOfPanels[i].key] = i;
  io.MousePos = ImVec2(-1e9f, -1e9f);
  try {
    app_ = std::make_unique<App>(App::Paths{GJKSCOPE_SOURCE_DIR, state}, fonts(), name);
  } catch (...) {
    ImGui::DestroyContext(context_);
    throw;
  }
  app_->has_thumbnails = false;
  settle();
}

HeadlessApp::~HeadlessApp() { ImGui::DestroyContext(context_); }

void HeadlessApp::frame(double seconds) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = ImVec2(static_cast<float>(width_), static_cast<float>(height_));
  io.DeltaTime = static_cast<float>(seconds);
  now_ += seconds;
  app_->tick(now_);
  const double scale = app_->layout(width_, height_, density_);
  if (!atlas_fonts_ || atlas_fonts_->scale() != scale) {
    io.Fonts->Clear();
    io.Fonts->AddFontDefault();
    atlas_fonts_ = std::make_unique<AtlasFonts>(*io.Fonts, fonts(), scale);
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  }
  app_->set_colors();
  ImGui::NewFrame();
  app_->draw(*atlas_fonts_);
  ImGui::Render();
  io.MouseWheel = 0.0f;
}

void HeadlessApp::make_thumbnails() {
  app_->has_thumbnails = true;
  do {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    frame();
  } while (app_->makes_thumbnails());
}

void HeadlessApp::settle() {
  for (int i = 0; i < 3; ++i) frame();
}

void HeadlessApp::resize(double width, double height, double density) {
  width_ = width;
  height_ = height;
  density_ = density;
  settle();
}

void HeadlessApp::move(const Point& to) {
  ImGui::GetIO().MousePos = ImVec2(static_cast<float>(to.x()), static_cast<float>(to.y()));
  settle();
}

void HeadlessApp::button(bool down, int clicks) {
  ImGui::GetIO().MouseDown[0] = down;
  if (down) app_->picture().clicked(clicks);
  settle();
}

void HeadlessApp::click(const Point& at, int clicks) {
  move(at);
  for (int i = 1; i <= clicks; ++i) {
    button(true, i);
    button(false, i);
  }
}

void HeadlessApp::drag(const Point& from, const Point& to) {
  move(from);
  button(true);
  constexpr int kMoves = 5;
  for (int i = 1; i <= kMoves; ++i) move(from + (to - from) * i / kMoves);
  button(false);
}

void HeadlessApp::wheel(double by) {
  ImGui::GetIO().MouseWheel = static_cast<float>(by);
  settle();
}

void HeadlessApp::key(const std::string& key, bool ctrl, bool shift) {
  ImGuiIO& io = ImGui::GetIO();
  const auto of_panels = std::ranges::find(kKeysOfPanels, key, &KeyOfPanels::name);
  const bool goes_to_panels = app_->panels_have_keys() && of_panels != std::end(kKeysOfPanels);
  const auto index = of_panels - std::begin(kKeysOfPanels);
  if (goes_to_panels) {
    io.KeysDown[index] = true;
    io.KeyCtrl = ctrl;
  }
  app_->press({key, ctrl, shift});
  settle();
  if (!goes_to_panels) return;
  io.KeysDown[index] = false;
  io.KeyCtrl = false;
  settle();
}

void HeadlessApp::type(const std::string& text) {
  ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
  settle();
}

Point HeadlessApp::at(const Subject& subject) {
  const std::optional<Point> place = app_->picture().pixel_of(subject);
  EXPECT_TRUE(place) << "no mark of subject " << static_cast<int>(subject.kind) << " " << subject.x
                     << " " << subject.y;
  return place.value_or(Point::Zero());
}

}  // namespace gjkscope::test
