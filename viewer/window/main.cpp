// The command line of gjkscope-viewer.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <iostream>

#include "base/file.hpp"
#include "paint/png.hpp"
#include "window/script.hpp"

namespace {

using namespace gjkscope;
namespace fs = std::filesystem;

constexpr int kProblem = 1;
constexpr int kUsage = 2;
constexpr int kCannot = 3;
constexpr const char* kFooter = R"(Exit codes:
  0  done
  1  a lesson or case cannot be shown
  2  the command line, or there is no display or no OpenGL
  3  something cannot be read or written

Work that is not saved is kept in $XDG_STATE_HOME/gjkscope (~/.local/state/gjkscope); the next start offers it.
Without a display, `gjkscope export` draws the same frames into files.

Examples:
  gjkscope-viewer
  gjkscope-viewer stop-vertex
  gjkscope-viewer case.json
)";

fs::path state_folder() {
  if (const char* folder = std::getenv("XDG_STATE_HOME"); folder && *folder)
    return fs::path(folder) / "gjkscope";
  if (const char* home = std::getenv("HOME"); home && *home)
    return fs::path(home) / ".local" / "state" / "gjkscope";
  return {};
}

int run(int argc, char** argv) {
  CLI::App arguments("Step through GJK in a window, and change anything with the mouse",
                     "gjkscope-viewer");
  arguments.footer(kFooter);
  arguments.set_version_flag("--version", GJKSCOPE_VERSION);
  std::string name;
  std::string script;
  std::string screenshot;
  std::pair<int, int> size = {0, 0};
  std::string size_text;
  std::optional<double> scale;
  bool keeps = true;
  bool log_frames = false;
  arguments.add_option("LESSON", name, "a lesson by id or path, a case (.json), or a folder");
  arguments.add_option("--script", script, "play recorded input from this file, then end");
  arguments.add_option("--screenshot", screenshot, "then write what the window shows, as PNG");
  arguments
      .add_option("--size", size_text,
                  "of the window, as 1440x900; without it, what suits the screen")
      ->check([&size](const std::string& text) -> std::string {
        char rest = 0;
        constexpr int kMost = 16384;
        const int read = std::sscanf(text.c_str(), "%dx%d%c", &size.first, &size.second, &rest);
        const auto fits = [](int length) { return length >= 1 && length <= kMost; };
        if (read == 2 && fits(size.first) && fits(size.second)) return {};
        return fmt::format("expected a width and a height like 1440x900, not '{}'", text);
      });
  arguments
      .add_option("--scale", scale,
                  "how large everything is, 2 for twice; without it, as the screen says of itself")
      ->check(CLI::Range(0.5, 8.0));
  arguments.add_flag("--log-frames", log_frames,
                     "write to standard error how many milliseconds each frame took");
  arguments.add_flag("!--no-state", keeps, "keep nothing: no unsaved work, no recent files");
  try {
    arguments.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return arguments.exit(error) == 0 ? 0 : kUsage;
  }

  try {
    const App::Paths paths{share_folder(), keeps ? state_folder() : fs::path()};
    const Fonts fonts(paths.share / "assets" / "fonts.toml");
    std::unique_ptr<App> app;
    try {
      app = std::make_unique<App>(paths, fonts, name);
    } catch (const std::runtime_error& error) {
      std::cerr << "gjkscope-viewer: " << error.what() << '\n';
      return kProblem;
    }
    Window window(*app, fonts, size.first, size.second, scale);
    if (log_frames) {
      window.after_frame = [](double seconds) { fmt::print(stderr, "{:.2f}\n", 1e3 * seconds); };
    }
    if (script.empty() && screenshot.empty()) {
      window.run();
      return 0;
    }
    if (!script.empty()) {
      play_script(read_whole(script), script, *app, window);
    }
    if (!screenshot.empty()) {
      const std::vector<std::uint8_t> png = encode_png(window.screenshot());
      write_whole(screenshot, std::span<const std::uint8_t>(png));
    }
    return 0;
  } catch (const NoWindow& error) {
    std::cerr << "gjkscope-viewer: " << error.what()
              << "\nWithout a window, `gjkscope export LESSON --out DIR` draws the same frames "
                 "into files.\n";
    return kUsage;
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gjkscope-viewer: %s\n", error.what());
    return kCannot;
  }
}
