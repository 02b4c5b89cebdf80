#pragma once
// A lesson on a web page: what the page asks for, and what it gets to show. All of it is text, so
// that a browser needs one call, and a test can ask a native player the same.

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "lesson/terms.hpp"
#include "picture/picture.hpp"
#include "picture/theme.hpp"
#include "session/hand.hpp"
#include "session/pointing.hpp"
#include "session/practising.hpp"

namespace gjkscope {

class Player {
 public:
  /// `themes` by name: the texts of their files, "light" among them; `terms`: that of
  /// assets/terms.toml. Throws std::runtime_error where they are damaged.
  Player(std::array<FaceBytes, kFaceCount> fonts, std::map<std::string, std::string> themes,
         std::string_view terms);
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  /// Does what `request` says, a JSON object such as {"do": "go", "to": 3}, and says what there is
  /// to be shown then: docs/web.md lists both. Never throws: a request that cannot be met, whatever
  /// it holds, leaves all as it was and gives {"problem": "..."}; of bad lessons and cases the
  /// problem is what the command prints.
  [[nodiscard]] std::string answer(std::string_view request);

  /// The same for a request with "command", which needs no player: what `gjkscope solve`, `trace`
  /// and `judge --json` print of a text.
  [[nodiscard]] static std::string command(std::string_view request);

 private:
  struct Asked;
  using Files = std::map<std::string, std::string>;  ///< Texts by name.

  // Requests
  void open(const Asked& asked);
  void replace(const Asked& asked);
  [[nodiscard]] std::string open_case(const Asked& asked);
  void set_layout(const Asked& asked);
  void go_to_phase(int phase);
  void step(int by);
  void reset();
  void restore(const Asked& asked);
  void press(const Asked& asked);
  void let_go(bool as_it_was);
  void put_vertex(const Asked& asked);
  void add_vertex(const Asked& asked);
  void nudge(const Asked& asked);
  void set_eye(const Asked& asked);
  void set_numerics(const Asked& asked);
  void set_language(const Asked& asked);
  [[nodiscard]] std::string linked(const Point& at);
  [[nodiscard]] std::optional<PointedChoice> pointed(const Asked& asked);
  [[nodiscard]] std::string choice_at(const Asked& asked);
  void take_answer(const Asked& asked);
  void practise(const Asked& asked);
  void next_task();
  void show_task();
  [[nodiscard]] std::string lesson_file() const;
  [[nodiscard]] std::string all_vertices() const;
  [[nodiscard]] std::string code_page() const;
  [[nodiscard]] std::string trace() const;
  [[nodiscard]] std::string whole_frame() const;
  [[nodiscard]] std::string for_paper();
  [[nodiscard]] std::string on_the_way(const Asked& asked) const;
  [[nodiscard]] static std::string printed(const Asked& asked);

  [[nodiscard]] static FileText held(const Files& files, const std::filesystem::path& file);
  [[nodiscard]] static Lesson parsed(const std::string& text, const std::string& name,
                                     const Files& files);
  void change(const std::string& name, const Lesson& lesson);

  // The frame that is shown
  [[nodiscard]] std::string shown(const std::string& understood = {});
  [[nodiscard]] std::string stage_svg(Picture stage) const;
  [[nodiscard]] Picture panel(const Frame& frame, double width);
  [[nodiscard]] std::string panel_svg(const Theme& theme);
  void measure_panel();
  [[nodiscard]] Picture timeline() const;
  void draw_depth(Picture& picture);
  [[nodiscard]] Theme theme(std::string_view wanted) const;

  Fonts fonts_;
  Files theme_texts_;
  Theme theme_;
  std::vector<CourseTerm> terms_;
  Session session_;
  Hand hand_;
  std::optional<Lesson> opened_;  ///< The lesson that "reset" goes back to.
  std::optional<Practising> practising_;
  Files files_;               ///< Files that the lesson names.
  Picture stage_;             ///< As it is shown,
  Picture stage_before_;      ///< and as it was before that.
  bool shows_depth_ = false;  ///< In the last frame of shapes that overlap.
  double panel_room_ = 368.0;
  double panel_width_ = 368.0;
  double timeline_width_ = 960.0;
  double panel_height_ = 0.0;
  long measured_ = -1;  ///< The version of the lesson whose panel was measured.
};

}  // namespace gjkscope
