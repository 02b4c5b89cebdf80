#pragma once
// A lesson on a web page: what the page asks for, and what it gets to show. All of it is text, so
// that a browser needs one call, and a test can ask a native player the same.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "picture/picture.hpp"
#include "picture/theme.hpp"
#include "session/session.hpp"

namespace gjkscope {

class Player {
 public:
  /// `themes` by name: the texts of their files, "light" among them.
  Player(std::array<FaceBytes, kFaceCount> fonts, std::map<std::string, std::string> themes);
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  /// Does what `request` says, a JSON object such as {"do": "go", "to": 3}, and says what there is
  /// to be shown then: docs/web.md lists both. Never throws: a request that cannot be met, whatever
  /// it holds, leaves all as it was and gives {"problem": "..."}; of bad lessons and cases the
  /// problem is what the command prints.
  [[nodiscard]] std::string answer(std::string_view request);

 private:
  struct Drag;
  struct Asked;
  [[nodiscard]] std::string shown();
  void open(const Asked& asked);
  void open_case(const Asked& asked);
  void open_sound(Lesson lesson);
  void set_layout(const Asked& asked);
  void press(const Point& at);
  void move(const Point& at);
  void put_vertex(const Asked& asked);
  void set_numerics(const Asked& asked);
  [[nodiscard]] std::string linked(const Point& at, double slack);
  [[nodiscard]] Picture panel();
  [[nodiscard]] double panel_height();
  [[nodiscard]] Picture timeline() const;

  Fonts fonts_;
  std::map<std::string, std::string> theme_texts_;
  Theme theme_;
  Session session_;
  std::optional<Lesson> opened_;                ///< What "reset" goes back to.
  std::map<std::string, std::string> results_;  ///< Files that the lesson names.
  double panel_width_ = 368.0;
  double timeline_width_ = 960.0;
  double panel_height_ = 0.0;
  std::shared_ptr<Drag> drag_;
};

}  // namespace gjkscope
