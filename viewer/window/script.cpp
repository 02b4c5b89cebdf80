#include "window/script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <stdexcept>

#include "base/file.hpp"
#include "paint/png.hpp"

namespace gjkscope {
namespace {

using Kind = Subject::Kind;

class Player {
 public:
  Player(App& app, Window& window) : app_(app), window_(window) {}

  void play(const std::string& line) {
    std::istringstream words(line);
    std::string verb;
    words >> verb;
    std::string rest;
    std::getline(words >> std::ws, rest);
    if (verb.empty() || verb[0] == '#') return;
    if (verb == "key") return window_.push_key(key(rest));
    if (verb == "type") return window_.push_text(rest);
    if (verb == "move") return move(place(rest));
    if (verb == "press") return window_.push_button(true);
    if (verb == "release") return window_.push_button(false);
    if (verb == "click" || verb == "doubleclick") {
      move(place(rest));
      for (int clicks = 1; clicks <= (verb == "click" ? 1 : 2); ++clicks) {
        window_.push_button(true, clicks);
        window_.push_button(false, clicks);
      }
      return;
    }
    if (verb == "drag") return drag(rest);
    if (verb == "wheel") return window_.push_wheel(number(rest));
    if (verb == "resize") {
      int width = 0;
      int height = 0;
      if (std::sscanf(rest.c_str(), "%d %d", &width, &height) != 2 || width < 1 || height < 1)
        throw std::runtime_error(
            fmt::format("expected a width and a height in pixels, like 1280 720, not '{}'", rest));
      return window_.resize(width, height);
    }
    if (verb == "wait") return window_.wait(number(rest));
    if (verb == "command") {
      if (!app_.run_command(rest))
        throw std::runtime_error(fmt::format("there is no command '{}'", rest));
      return window_.wait(0.0);
    }
    if (verb == "screenshot") {
      const std::vector<std::uint8_t> png = encode_png(window_.screenshot());
      return write_whole(rest, std::span<const std::uint8_t>(png));
    }
    if (verb == "state") return write_whole(rest, app_.state_json());
    throw std::runtime_error(fmt::format("a script cannot do '{}'", verb));
  }

 private:
  static double number(const std::string& text) {
    double value = 0.0;
    if (std::sscanf(text.c_str(), "%lf", &value) != 1)
      throw std::runtime_error(fmt::format("expected a number, not '{}'", text));
    return value;
  }

  static KeyPress key(std::string text) {
    KeyPress press;
    if (text.starts_with("Ctrl+")) {
      press.ctrl = true;
      text.erase(0, 5);
    }
    if (text.starts_with("Shift+")) {
      press.shift = true;
      text.erase(0, 6);
    }
    press.key = text;
    return press;
  }

  Point place(const std::string& text) {
    double x = 0.0;
    double y = 0.0;
    if (std::sscanf(text.c_str(), "%lf %lf", &x, &y) == 2) return {x, y};
    std::string what = text;
    Point offset = Point::Zero();
    if (const std::size_t plus = text.find('+'); plus != std::string::npos) {
      if (std::sscanf(text.c_str() + plus + 1, "%lf,%lf", &x, &y) != 2)
        throw std::runtime_error(fmt::format("expected an offset like +30,-10 in '{}'", text));
      offset = {x, y};
      what = text.substr(0, plus);
    }
    const std::optional<Point> found = app_.picture().pixel_of(subject(what));
    if (!found) throw std::runtime_error(fmt::format("the frame shows no mark of '{}'", what));
    return *found + offset;
  }

  Subject subject(const std::string& text) {
    Subject out;
    if (std::sscanf(text.c_str(), "x:%d", &out.x) == 1) return {Kind::vertex_of_x, out.x};
    if (std::sscanf(text.c_str(), "y:%d", &out.y) == 1) return {Kind::vertex_of_y, -1, out.y};
    if (std::sscanf(text.c_str(), "z:%d,%d", &out.x, &out.y) == 2)
      return {Kind::difference_vertex, out.x, out.y};
    if (std::sscanf(text.c_str(), "frame:%d", &out.x) == 1) return {Kind::frame, out.x};
    if (std::sscanf(text.c_str(), "dot:%d", &out.x) == 1) return {Kind::study_dot, out.x};
    if (text.starts_with("phase:")) {
      const std::span<const std::string_view> phases = app_.session().run().tour->algorithm->phases;
      const auto phase = std::find(phases.begin(), phases.end(), text.substr(6));
      if (phase != phases.end()) return {Kind::phase, static_cast<int>(phase - phases.begin())};
    }
    if (text == "shape-x") return {Kind::shape_x};
    if (text == "shape-y") return {Kind::shape_y};
    if (text == "difference") return {Kind::difference};
    throw std::runtime_error(
        fmt::format("'{}' is no place; expected pixels like 30 40, or a mark like x:0, z:0,1, "
                    "frame:2, dot:3, phase:support, shape-x or difference",
                    text));
  }

  void move(const Point& to) { window_.push_move(to.x(), to.y()); }

  void drag(const std::string& text) {
    // Two places: two words, or four numbers.
    std::istringstream words(text);
    std::vector<std::string> parts;
    for (std::string word; words >> word;) parts.push_back(word);
    if (parts.size() != 2 && parts.size() != 4)
      throw std::runtime_error(
          fmt::format("expected two places, each a mark or two pixels, not '{}'", text));
    const bool pixels = parts.size() == 4;
    const Point from = place(pixels ? parts[0] + " " + parts[1] : parts[0]);
    const Point to = place(pixels ? parts[2] + " " + parts[3] : parts[1]);
    move(from);
    window_.push_button(true);
    constexpr int kMoves = 10;
    for (int i = 1; i <= kMoves; ++i) move(from + (to - from) * i / kMoves);
    window_.push_button(false);
  }

  App& app_;
  Window& window_;
};

}  // namespace

void play_script(std::string_view script, std::string_view name, App& app, Window& window) {
  std::istringstream lines{std::string(script)};
  Player player(app, window);
  window.settle();
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    try {
      player.play(line);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("{}:{}: {}", name, number, error.what()));
    }
  }
}

}  // namespace gjkscope
