#include "window/window.hpp"

#include <SDL.h>
#include <SDL_opengl.h>
#include <backends/imgui_impl_opengl3.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <set>
#include <thread>
#include <tuple>

#include "base/file.hpp"
#include "density.hpp"
#include "imgui_keys.hpp"
#include "lesson/problem.hpp"
#include "picture/tween.hpp"
#include "system_fonts.hpp"
#include "window/file_watch.hpp"

namespace gjkscope {
namespace {

constexpr double kUiType = 15.0;  // pixels at scale 1
constexpr int kWidth = 1440;
constexpr int kHeight = 900;
/// Frames after the last event: Dear ImGui needs one to see where things are, and one to act.
constexpr int kFramesAfterEvent = 3;

/// OpenGL functions that the window itself calls; all else is Dear ImGui's back end.
struct WindowGl {
  decltype(&glViewport) viewport = nullptr;
  decltype(&glClearColor) clear_color = nullptr;
  decltype(&glClear) clear = nullptr;
  decltype(&glReadPixels) read_pixels = nullptr;
  decltype(&glFinish) finish = nullptr;

  WindowGl() {
    const auto load = [](auto& function, const char* name) {
      void* address = SDL_GL_GetProcAddress(name);
      if (!address) throw NoWindow(fmt::format("OpenGL has no {}", name));
      std::memcpy(&function, &address, sizeof function);
    };
    load(viewport, "glViewport");
    load(clear_color, "glClearColor");
    load(clear, "glClear");
    load(read_pixels, "glReadPixels");
    load(finish, "glFinish");
  }
};

double seconds() {
  return static_cast<double>(SDL_GetPerformanceCounter()) /
         static_cast<double>(SDL_GetPerformanceFrequency());
}

/// Neither a letter nor a digit nor a named key: where it is, and with which other keys it is
/// typed, differs from keyboard to keyboard.
bool is_sign(std::string_view text) {
  return text.size() == 1 && std::ispunct(static_cast<unsigned char>(text[0])) != 0;
}

/// The displays that the environment names, none of which can be opened.
std::string named_displays() {
  std::string out;
  for (const char* const name : {"DISPLAY", "WAYLAND_DISPLAY"}) {
    const char* const value = std::getenv(name);
    const bool is_set = value != nullptr && *value != '\0';
    out += fmt::format("{}{}", out.empty() ? "" : ", and ",
                       is_set ? fmt::format("{} is '{}', which does not answer", name, value)
                              : fmt::format("{} is not set", name));
  }
  return out;
}

struct Sdl {
  Sdl() {
    SDL_SetHint(SDL_HINT_VIDEO_HIGHDPI_DISABLED, "0");
    if (SDL_Init(SDL_INIT_VIDEO) != 0)
      throw NoWindow(fmt::format("there is no display to open a window on ({})", SDL_GetError()));
    // These draw where nobody looks.
    const std::string_view driver = SDL_GetCurrentVideoDriver();
    if (driver == "offscreen" || driver == "dummy" || driver == "evdev") {
      SDL_Quit();
      throw NoWindow("there is no display to open a window on: " + named_displays());
    }
  }
  ~Sdl() { SDL_Quit(); }
  Sdl(const Sdl&) = delete;
  Sdl& operator=(const Sdl&) = delete;
};

/// The usual size at this scale, or what of it the screen has room for beside bars and frames.
std::pair<int, int> size_on_screen(double scale) {
  SDL_Rect room = {};
  if (SDL_GetDisplayUsableBounds(0, &room) != 0)
    return {static_cast<int>(kWidth * scale), static_cast<int>(kHeight * scale)};
  return {std::min(static_cast<int>(kWidth * scale), room.w * 19 / 20),
          std::min(static_cast<int>(kHeight * scale), room.h * 9 / 10)};
}

/// X ends a program with an error that nobody takes; while one of these lives, it takes all. SDL
/// loads X itself, so it is looked up and not linked.
class XErrors {
 public:
  XErrors() {
    if (void* library = ::dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD)) {
      if (void* address = ::dlsym(library, "XSetErrorHandler"))
        std::memcpy(&set_handler_, &address, sizeof set_handler_);
    }
    seen() = false;
    if (set_handler_) before_ = set_handler_(note);
  }
  ~XErrors() {
    if (set_handler_) set_handler_(before_);
  }
  XErrors(const XErrors&) = delete;
  XErrors& operator=(const XErrors&) = delete;

  [[nodiscard]] bool any() const { return seen(); }

 private:
  using Handler = int (*)(void* display, void* error);
  static bool& seen() {
    static bool any = false;
    return any;
  }
  static int note(void*, void*) {
    seen() = true;
    return 0;
  }
  Handler (*set_handler_)(Handler) = nullptr;
  Handler before_ = nullptr;
};

/// The resources and dots per inch of the X screen, if SDL has loaded X.
struct XScreen {
  std::string resources;
  double dpi = 0.0;
};

XScreen x_screen() {
  void* library = ::dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
  if (!library) return {};
  const auto find = [&](auto& function, const char* name) {
    void* address = ::dlsym(library, name);
    if (address) std::memcpy(&function, &address, sizeof function);
    return address != nullptr;
  };
  void* (*open)(const char*) = nullptr;
  char* (*resources)(void*) = nullptr;
  int (*pixels)(void*, int) = nullptr;
  int (*millimetres)(void*, int) = nullptr;
  int (*close)(void*) = nullptr;
  if (!find(open, "XOpenDisplay") || !find(resources, "XResourceManagerString") ||
      !find(pixels, "XDisplayWidth") || !find(millimetres, "XDisplayWidthMM") ||
      !find(close, "XCloseDisplay"))
    return {};
  void* display = open(nullptr);
  if (!display) return {};
  constexpr double kInch = 25.4;  // mm
  XScreen screen;
  if (const char* text = resources(display)) screen.resources = text;
  if (const int wide = millimetres(display, 0); wide > 0)
    screen.dpi = kInch * pixels(display, 0) / wide;
  close(display);
  return screen;
}

/// The density of a screen whose pixels are the window's units: the one that is set for type, else
/// the one that follows from its size in inches.
double scale_of_screen() {
  const XScreen x = x_screen();
  if (const std::optional<double> dpi = dpi_of_resources(x.resources)) return scale_of_dpi(*dpi);
  float diagonal = 0.0f;
  if (SDL_GetDisplayDPI(0, &diagonal, nullptr, nullptr) != 0) diagonal = 0.0f;
  // Many screens of laptops are a little denser than usual, and nobody wants them otherwise.
  constexpr double kDense = 144.0;
  const double dpi = std::max<double>(diagonal, x.dpi);
  return dpi >= kDense ? scale_of_dpi(dpi) : 1.0;
}

struct DeleteWindow {
  void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
};
struct DeleteContext {
  void operator()(void* context) const { SDL_GL_DeleteContext(context); }
};
struct DeleteCursor {
  void operator()(SDL_Cursor* cursor) const { SDL_FreeCursor(cursor); }
};

/// The characters that headings and numbers need, of those that the type faces have. Each character
/// takes time before the first frame.
const ImWchar* few_characters() {
  static const std::vector<ImWchar> ranges = {0x20, 0xFF, 0x2010, 0x2044, 0x2212, 0x2212, 0};
  return ranges.data();
}

/// Those that panels need, names of lessons and files with them: Latin, Greek and Cyrillic.
const ImWchar* panel_characters() {
  static const std::vector<ImWchar> ranges = {0x20,   0x17F,  0x370,  0x45F,  0x2010,
                                              0x2044, 0x2070, 0x209C, 0x2190, 0x21FF,
                                              0x2200, 0x22FF, 0x2713, 0x2717, 0};
  return ranges.data();
}

bool is_among(const ImWchar* ranges, char32_t character) {
  for (; ranges[0] != 0; ranges += 2) {
    if (character >= ranges[0] && character <= ranges[1]) return true;
  }
  return false;
}

/// A font of the system for characters that the panels' own has not.
struct MoreType {
  int index = 0;  ///< The face in its file.
  std::string file;
  std::vector<ImWchar> ranges;
};

}  // namespace

struct Window::Impl {
  Impl(App& the_app, const Fonts& the_fonts, int width, int height, std::optional<double> the_scale)
      : app(the_app), fonts(the_fonts), scale(the_scale ? *the_scale : scale_of_screen()) {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
    if (width <= 0 || height <= 0) {
      std::tie(width, height) = size_on_screen(scale);
    }
    const XErrors errors;
    window.reset(
        SDL_CreateWindow("gjkscope", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width, height,
                         SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI));
    if (!window) throw NoWindow(fmt::format("no window can be opened ({})", SDL_GetError()));
    context.reset(SDL_GL_CreateContext(window.get()));
    if (!context || errors.any())
      throw NoWindow(
          fmt::format("there is no OpenGL 3 ({})", errors.any() ? "X refuses it" : SDL_GetError()));
    SDL_GL_SetSwapInterval(0);
    gl = std::make_unique<WindowGl>();
    SDL_SetWindowMinimumSize(window.get(), static_cast<int>(kLeastWidth * scale),
                             static_cast<int>(kLeastHeight * scale));
    hand.reset(SDL_CreateSystemCursor(SDL_SYSTEM_CURSOR_HAND));
    sideways.reset(SDL_CreateSystemCursor(SDL_SYSTEM_CURSOR_SIZEWE));
    arrow.reset(SDL_CreateSystemCursor(SDL_SYSTEM_CURSOR_ARROW));

    imgui = ImGui::CreateContext();
    ImGui::SetCurrentContext(imgui);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.ConfigInputTextCursorBlink = false;  // a caret is no reason to draw twice a second
    take_keys_by_index(io);
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
    for (const auto& [key, scancode] : {std::pair(ImGuiKey_Tab, SDL_SCANCODE_TAB),
                                        {ImGuiKey_LeftArrow, SDL_SCANCODE_LEFT},
                                        {ImGuiKey_RightArrow, SDL_SCANCODE_RIGHT},
                                        {ImGuiKey_UpArrow, SDL_SCANCODE_UP},
                                        {ImGuiKey_DownArrow, SDL_SCANCODE_DOWN},
                                        {ImGuiKey_PageUp, SDL_SCANCODE_PAGEUP},
                                        {ImGuiKey_PageDown, SDL_SCANCODE_PAGEDOWN},
                                        {ImGuiKey_Home, SDL_SCANCODE_HOME},
                                        {ImGuiKey_End, SDL_SCANCODE_END},
                                        {ImGuiKey_Insert, SDL_SCANCODE_INSERT},
                                        {ImGuiKey_Delete, SDL_SCANCODE_DELETE},
                                        {ImGuiKey_Backspace, SDL_SCANCODE_BACKSPACE},
                                        {ImGuiKey_Space, SDL_SCANCODE_SPACE},
                                        {ImGuiKey_Enter, SDL_SCANCODE_RETURN},
                                        {ImGuiKey_Escape, SDL_SCANCODE_ESCAPE},
                                        {kKeypadEnter, SDL_SCANCODE_KP_ENTER},
                                        {ImGuiKey_A, SDL_SCANCODE_A},
                                        {ImGuiKey_C, SDL_SCANCODE_C},
                                        {ImGuiKey_V, SDL_SCANCODE_V},
                                        {ImGuiKey_X, SDL_SCANCODE_X},
                                        {ImGuiKey_Y, SDL_SCANCODE_Y},
                                        {ImGuiKey_Z, SDL_SCANCODE_Z}})
      io.KeyMap[key] = scancode;
    io.SetClipboardTextFn = [](void*, const char* text) { SDL_SetClipboardText(text); };
    io.GetClipboardTextFn = [](void*) -> const char* {
      static std::string held;
      held = clipboard();
      return held.c_str();
    };
    if (!ImGui_ImplOpenGL3_Init("#version 130"))
      throw NoWindow("Dear ImGui has no OpenGL 3 back end here");
    app.paste = clipboard;
    app.copy = [](const std::string& text) { SDL_SetClipboardText(text.c_str()); };
    file_event = SDL_RegisterEvents(1);
    watch = std::make_unique<FileWatch>([this] {
      SDL_Event event = {};
      event.type = file_event;
      SDL_PushEvent(&event);
    });
  }

  ~Impl() {
    watch.reset();
    if (imgui) {
      ImGui::SetCurrentContext(imgui);
      ImGui_ImplOpenGL3_Shutdown();
      ImGui::DestroyContext(imgui);
    }
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  static std::string clipboard() {
    char* text = SDL_GetClipboardText();
    std::string copy = text ? text : "";
    SDL_free(text);
    return copy;
  }

  /// Finds fonts for names in other scripts. True where there are any that were not there before.
  bool find_more_type() {
    std::u32string wanted;
    for (const char32_t c : app.characters()) {
      const bool is_new = !is_among(panel_characters(), c) && looked_for.insert(c).second;
      if (is_new && c <= IM_UNICODE_CODEPOINT_MAX) wanted += c;
    }
    const std::vector<SystemFont> found = system_fonts_for(wanted);
    for (const SystemFont& font : found) {
      MoreType& more = more_type.emplace_back();
      more.index = font.index;
      more.file = read_whole(font.file);
      for (const char32_t c : font.characters)
        more.ranges.insert(more.ranges.end(), 2, static_cast<ImWchar>(c));
      more.ranges.push_back(0);
    }
    return !found.empty();
  }

  /// Fonts for the picture at `zoom` and for the panels; nothing where they are there.
  void prepare_fonts(double zoom) {
    const bool has_more = find_more_type();
    if (atlas_fonts && zoom == atlas_fonts->scale() && ui_scale == app.ui_scale() && !has_more)
      return;
    ui_scale = app.ui_scale();
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    io.Fonts->Flags |= ImFontAtlasFlags_NoMouseCursors | ImFontAtlasFlags_NoBakedLines;
    io.Fonts->TexDesiredWidth = 2048;
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    const auto add = [&](Face face, const ImWchar* characters) {
      config.GlyphRanges = characters;
      const std::vector<unsigned char>& file = fonts.file(face);
      config.FontData = const_cast<unsigned char*>(file.data());  // read, not written
      config.FontDataSize = static_cast<int>(file.size());
      config.SizePixels = static_cast<float>(kUiType * ui_scale * fonts.height_in_em(face));
      return io.Fonts->AddFont(&config);
    };
    add(Face::regular, panel_characters());
    const auto merge = [&](const void* file, std::size_t size, int index, const ImWchar* ranges) {
      ImFontConfig merged;
      merged.MergeMode = true;
      merged.FontDataOwnedByAtlas = false;
      merged.FontData = const_cast<void*>(file);  // read, not written
      merged.FontDataSize = static_cast<int>(size);
      merged.FontNo = index;
      merged.GlyphRanges = ranges;
      merged.SizePixels =
          static_cast<float>(kUiType * ui_scale * fonts.height_in_em(Face::regular));
      io.Fonts->AddFont(&merged);
    };
    static constexpr ImWchar kReplacement[] = {0xFFFD, 0xFFFD, 0};  // of what no font has
    const std::vector<unsigned char>& fallback = fonts.fallback_file(Face::regular);
    merge(fallback.data(), fallback.size(), 0, kReplacement);
    for (const MoreType& more : more_type)
      merge(more.file.data(), more.file.size(), more.index, more.ranges.data());
    panel_fonts = {add(Face::mono, few_characters()), add(Face::semibold, few_characters())};
    atlas_fonts = std::make_unique<AtlasFonts>(*io.Fonts, fonts, zoom);
    if (!io.Fonts->Build()) throw std::runtime_error("the font atlas cannot be built");
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    style.AntiAliasedLinesUseTex = false;
    style.WindowRounding = 0.0f;
    style.WindowBorderSize = 0.0f;
    style.WindowPadding = ImVec2(10.0f, 8.0f);
    style.FrameRounding = 4.0f;
    style.FrameBorderSize = 1.0f;
    style.GrabRounding = 4.0f;
    style.PopupRounding = 8.0f;
    style.PopupBorderSize = 1.0f;
    style.ScaleAllSizes(static_cast<float>(ui_scale));
  }

  void set_title() {
    const std::string wanted = app.title();
    if (wanted != title) SDL_SetWindowTitle(window.get(), wanted.c_str());
    title = wanted;
    if (app.watched() != watched) {
      watched = app.watched();
      watch->watch(watched);
    }
    const bool full = app.wants_full_screen();
    if (full != is_full)
      SDL_SetWindowFullscreen(window.get(), full ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
    is_full = full;
  }

  /// Pixels per unit in which SDL gives sizes and places: more than one on some dense screens.
  [[nodiscard]] double pixels_per_unit() const {
    int width = 0;
    int pixels = 0;
    SDL_GetWindowSize(window.get(), &width, nullptr);
    SDL_GL_GetDrawableSize(window.get(), &pixels, nullptr);
    return width > 0 && pixels > 0 ? static_cast<double>(pixels) / width : 1.0;
  }
  [[nodiscard]] ImVec2 in_pixels(int x, int y) const {
    const double ratio = pixels_per_unit();
    return {static_cast<float>(ratio * x), static_cast<float>(ratio * y)};
  }

  void draw(const std::function<void(double)>& tell) {
    const double begin = seconds();
    int pixels_wide = 0;
    int pixels_high = 0;
    SDL_GL_GetDrawableSize(window.get(), &pixels_wide, &pixels_high);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(pixels_wide), static_cast<float>(pixels_high));
    const double now = begin + skipped;
    io.DeltaTime = static_cast<float>(std::clamp(now - last_frame, 1e-4, 1.0));
    last_frame = now;
    app.tick(now);
    prepare_fonts(app.layout(pixels_wide, pixels_high, pixels_per_unit() * scale));
    app.set_colors();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    app.draw(*atlas_fonts, panel_fonts);
    const ImGuiMouseCursor cursor = ImGui::GetMouseCursor();
    ImGui::Render();
    SDL_SetCursor(cursor == ImGuiMouseCursor_Hand       ? hand.get()
                  : cursor == ImGuiMouseCursor_ResizeEW ? sideways.get()
                                                        : arrow.get());
    SDL_ShowCursor(app.shows_pointer() ? SDL_ENABLE : SDL_DISABLE);
    const Color paper = app.theme().background();
    gl->viewport(0, 0, pixels_wide, pixels_high);
    gl->clear_color(static_cast<float>(paper.r) / 255.0f, static_cast<float>(paper.g) / 255.0f,
                    static_cast<float>(paper.b) / 255.0f, 1.0f);
    gl->clear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    if (shot) {
      gl->finish();
      shot->width = pixels_wide;
      shot->height = pixels_high;
      const std::size_t row = static_cast<std::size_t>(pixels_wide) * 4;
      std::vector<std::uint8_t> upside_down(row * static_cast<std::size_t>(pixels_high));
      gl->read_pixels(0, 0, pixels_wide, pixels_high, GL_RGBA, GL_UNSIGNED_BYTE,
                      upside_down.data());
      shot->pixels.resize(upside_down.size());
      for (int y = 0; y < pixels_high; ++y) {
        std::memcpy(shot->pixels.data() + row * static_cast<std::size_t>(y),
                    upside_down.data() + row * static_cast<std::size_t>(pixels_high - 1 - y), row);
      }
    }
    SDL_GL_SwapWindow(window.get());
    if (tell) {
      gl->finish();
      tell(seconds() - begin);
    }
    set_title();
    io.MouseWheel = 0.0f;
  }

  /// True when the next event should wait for a frame: Dear ImGui looks at buttons once a frame.
  bool take(const SDL_Event& event) {
    ImGuiIO& io = ImGui::GetIO();
    frames_left = kFramesAfterEvent;
    switch (event.type) {
      case SDL_QUIT:
        app.ask_to_quit();
        return true;
      case SDL_MOUSEMOTION:
        io.MousePos = in_pixels(event.motion.x, event.motion.y);
        return false;
      case SDL_MOUSEBUTTONDOWN:
      case SDL_MOUSEBUTTONUP: {
        io.MousePos = in_pixels(event.button.x, event.button.y);
        const int button = event.button.button == SDL_BUTTON_LEFT    ? 0
                           : event.button.button == SDL_BUTTON_RIGHT ? 1
                                                                     : 2;
        io.MouseDown[button] = event.type == SDL_MOUSEBUTTONDOWN;
        if (io.MouseDown[0]) app.picture().clicked(event.button.clicks);
        SDL_CaptureMouse(io.MouseDown[0] ? SDL_TRUE : SDL_FALSE);
        return true;
      }
      case SDL_MOUSEWHEEL:
        io.MouseWheel += event.wheel.preciseY;
        return true;
      case SDL_TEXTINPUT:
        if (io.WantTextInput) {
          io.AddInputCharactersUTF8(event.text.text);
        } else if (is_sign(event.text.text)) {
          app.press({event.text.text});
        }
        return false;
      case SDL_KEYDOWN:
      case SDL_KEYUP: {
        const bool down = event.type == SDL_KEYDOWN;
        // A key has one meaning: to a panel, or as a command.
        io.KeysDown[event.key.keysym.scancode] = down && app.panels_have_keys();
        const Uint16 mod = event.key.keysym.mod;
        io.KeyCtrl = (mod & (KMOD_CTRL | KMOD_GUI)) != 0;
        io.KeyShift = (mod & KMOD_SHIFT) != 0;
        io.KeyAlt = (mod & KMOD_ALT) != 0;
        if (!down) return false;
        const bool is_letter = event.key.keysym.sym >= SDLK_SPACE && event.key.keysym.sym < 0x100 &&
                               event.key.keysym.sym != SDLK_DELETE;
        std::string name = SDL_GetKeyName(event.key.keysym.sym);
        if (name == "Return" || name == "Keypad Enter") name = "Enter";
        if (is_sign(name) && !io.KeyCtrl) return false;  // comes as text, too
        app.press({name, io.KeyCtrl, io.KeyShift});
        // Pressed and let go between two frames, a key would not have been seen. Those of letters
        // come as text.
        return app.panels_have_keys() && (!is_letter || io.KeyCtrl);
      }
      case SDL_DROPFILE:
        app.open_path(event.drop.file);
        SDL_free(event.drop.file);
        return false;
      case SDL_WINDOWEVENT:
        // In a window of another size the pointer is elsewhere, though nobody moved it.
        if (event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED &&
            SDL_GetMouseFocus() == window.get()) {
          int x = 0;
          int y = 0;
          SDL_GetMouseState(&x, &y);
          io.MousePos = in_pixels(x, y);
        }
        if (event.window.event == SDL_WINDOWEVENT_LEAVE && !io.MouseDown[0])
          io.MousePos = ImVec2(-HUGE_VALF, -HUGE_VALF);
        if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) {
          std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
          io.KeyCtrl = io.KeyShift = io.KeyAlt = false;
        }
        return false;
      default:
        if (event.type == file_event) app.file_changed(watched);
        return false;
    }
  }

  /// Takes events that are there, up to one that wants a frame first.
  void take_all() {
    SDL_Event event;
    while (SDL_PollEvent(&event) != 0) {
      if (take(event)) return;
    }
  }

  App& app;
  const Fonts& fonts;
  Sdl sdl;  // before what asks it
  double scale;
  std::unique_ptr<SDL_Window, DeleteWindow> window;
  std::unique_ptr<void, DeleteContext> context;
  std::unique_ptr<SDL_Cursor, DeleteCursor> hand;
  std::unique_ptr<SDL_Cursor, DeleteCursor> arrow;
  std::unique_ptr<SDL_Cursor, DeleteCursor> sideways;
  std::unique_ptr<WindowGl> gl;
  ImGuiContext* imgui = nullptr;
  std::unique_ptr<AtlasFonts> atlas_fonts;
  double ui_scale = 0.0;
  std::set<char32_t> looked_for;
  std::vector<MoreType> more_type;
  std::unique_ptr<FileWatch> watch;
  Uint32 file_event = 0;
  std::filesystem::path watched;
  std::string title;
  bool is_full = false;
  int frames_left = kFramesAfterEvent;
  double last_frame = 0.0;
  double skipped = 0.0;  ///< Seconds that a script has let pass.
  Image* shot = nullptr;
  PanelFonts panel_fonts;
};

Window::Window(App& app, const Fonts& fonts, int width, int height, std::optional<double> scale)
    : impl_(std::make_unique<Impl>(app, fonts, width, height, scale)) {}
Window::~Window() = default;

void Window::run() {
  while (!impl_->app.wants_to_quit()) {
    if (impl_->frames_left == 0) {
      SDL_Event event;
      const std::optional<double> wakes = impl_->app.wakes_at();
      bool came = false;
      if (wakes) {
        const double left = std::max(*wakes - seconds() - impl_->skipped, 0.0);
        came = SDL_WaitEventTimeout(&event, static_cast<int>(std::ceil(1e3 * left))) != 0;
        if (!came) impl_->frames_left = 1;
      } else {
        came = SDL_WaitEvent(&event) != 0;
      }
      if (!came || !impl_->take(event)) impl_->take_all();
    } else {
      impl_->take_all();
    }
    if (impl_->frames_left > 0) {
      impl_->draw(after_frame);
      --impl_->frames_left;
    }
  }
}

void Window::settle() {
  // As many as a burst of events takes; a window that never comes to rest would be a fault.
  constexpr int kMost = 1000;
  for (int i = 0; i < kMost && !impl_->app.wants_to_quit(); ++i) {
    impl_->take_all();
    if (impl_->frames_left == 0) return;
    impl_->draw(after_frame);
    --impl_->frames_left;
  }
}

void Window::wait(double time) {
  const double end = seconds() + impl_->skipped + time;
  while (true) {
    const double now = seconds() + impl_->skipped;
    const std::optional<double> wakes = impl_->app.wakes_at();
    const double next = std::min(wakes.value_or(end), end);
    if (next > now) impl_->skipped += next - now;
    impl_->frames_left = 1;
    settle();
    if (next >= end) return;
  }
}

void Window::push_key(const KeyPress& key) {
  SDL_Event event = {};
  event.type = SDL_KEYDOWN;
  event.key.keysym.sym = SDL_GetKeyFromName(key.key == "Enter" ? "Return" : key.key.c_str());
  if (event.key.keysym.sym == SDLK_UNKNOWN && !is_sign(key.key))
    throw std::runtime_error(fmt::format("there is no key '{}'", key.key));
  event.key.keysym.scancode = SDL_GetScancodeFromKey(event.key.keysym.sym);
  event.key.keysym.mod =
      static_cast<Uint16>((key.ctrl ? KMOD_LCTRL : 0) | (key.shift ? KMOD_LSHIFT : 0));
  if (is_sign(key.key) && !key.ctrl) return push_text(key.key);
  SDL_PushEvent(&event);
  settle();
  event.type = SDL_KEYUP;
  event.key.keysym.mod = 0;
  SDL_PushEvent(&event);
  settle();
}

void Window::push_text(const std::string& text) {
  // An event holds 31 bytes of text; characters are not cut.
  for (std::size_t begin = 0; begin < text.size();) {
    SDL_Event event = {};
    event.type = SDL_TEXTINPUT;
    std::size_t end = std::min(begin + sizeof event.text.text - 1, text.size());
    while (end < text.size() && !starts_character(text[end])) --end;
    text.copy(event.text.text, end - begin, begin);
    SDL_PushEvent(&event);
    settle();
    begin = end;
  }
}

void Window::push_move(double x, double y) {
  SDL_Event event = {};
  event.type = SDL_MOUSEMOTION;
  const double ratio = impl_->pixels_per_unit();
  event.motion.x = static_cast<int>(std::lround(x / ratio));
  event.motion.y = static_cast<int>(std::lround(y / ratio));
  SDL_PushEvent(&event);
  settle();
}

void Window::push_button(bool down, int clicks) {
  const ImVec2 at = ImGui::GetIO().MousePos;
  SDL_Event event = {};
  event.type = down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP;
  event.button.button = SDL_BUTTON_LEFT;
  event.button.clicks = static_cast<Uint8>(clicks);
  const double ratio = impl_->pixels_per_unit();
  event.button.x = static_cast<int>(std::lround(at.x / ratio));
  event.button.y = static_cast<int>(std::lround(at.y / ratio));
  SDL_PushEvent(&event);
  settle();
}

void Window::push_wheel(double by) {
  SDL_Event event = {};
  event.type = SDL_MOUSEWHEEL;
  event.wheel.preciseY = static_cast<float>(by);
  SDL_PushEvent(&event);
  settle();
}

void Window::resize(int width, int height) {
  SDL_SetWindowSize(impl_->window.get(), width, height);
  impl_->frames_left = kFramesAfterEvent;
  settle();
}

Image Window::screenshot() {
  Image image;
  settle();
  if (impl_->app.picture().is_moving()) wait(kTweenSeconds);
  while (impl_->app.makes_thumbnails()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    impl_->frames_left = 1;
    settle();
  }
  impl_->shot = &image;
  impl_->draw(after_frame);
  impl_->shot = nullptr;
  return image;
}

}  // namespace gjkscope
