#pragma once
// A window of SDL2 and OpenGL 3 around an App: events in, frames out. It waits for events and draws
// nothing while nothing changes.

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "app.hpp"
#include "paint/image.hpp"

namespace gjkscope {

/// There is no display, or no OpenGL.
class NoWindow : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Window {
 public:
  /// Without a width or a height: a size that suits the screen. `scale`: how many times larger than
  /// on an ordinary screen everything is; without it, what the screen says of itself. Throws
  /// NoWindow saying what was tried.
  Window(App& app, const Fonts& fonts, int width, int height,
         std::optional<double> scale = std::nullopt);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Until the user quits.
  void run();
  /// Called after each frame, when it is drawn to the end, with the seconds that it took. Waiting
  /// for the end costs time, so nothing waits while nobody asks.
  std::function<void(double)> after_frame;

  // For scripts: the same way as the user's events. Places are in pixels.

  void push_key(const KeyPress& key);
  void push_text(const std::string& text);
  void push_move(double x, double y);
  void push_button(bool down, int clicks = 1);
  void push_wheel(double by);
  void resize(int width, int height);
  /// Takes in all events and draws until nothing changes any more.
  void settle();
  /// Lets `time` (seconds) pass, as if the user waited.
  void wait(double time);
  /// The pixels of the window.
  [[nodiscard]] Image screenshot();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gjkscope
