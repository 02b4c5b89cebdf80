#pragma once
// The question of the frame that is shown: what a click, a digit, a key or a button answers.

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "picture/frame_text.hpp"
#include "picture/picture.hpp"

namespace gjkscope {

class App;
class AtlasFonts;

class Asking {
 public:
  explicit Asking(App& app) : app_(app) {}

  [[nodiscard]] bool is_open() const;
  /// The choices now: for a pair, the vertices of its first shape, then those of its second.
  [[nodiscard]] std::vector<std::string> choices();
  /// A choice, or the next half of one.
  void choose(const std::string& choice);
  /// A digit of the number of a choice. Among more than nine choices it may be the first of two:
  /// Enter, another digit, or a short while makes it a number.
  void type(int digit);
  /// Up and Down, then Enter.
  void move(int by);
  void enter();
  /// A click on the stage: a vertex, an edge or a region that is one of the choices. False when it
  /// is none.
  bool click(const Subject& subject, const Point& page);
  /// No half of a pair and no digit stands any more.
  void forget();
  /// True when half of a pair or a digit has been given.
  [[nodiscard]] bool has_begun();
  void tick(double now);
  [[nodiscard]] std::optional<double> wakes_at() const;

  /// The subject that a reader points at where a choice is shown.
  [[nodiscard]] std::optional<Subject> subject_of(const std::string& choice) const;
  /// The choices as numbered buttons, side by side as far as there is room: for each shape of a
  /// pair a row.
  void draw();
  /// The same on the stage, where the frame lists its choices.
  void draw_on_stage(const AtlasFonts& fonts);

 private:
  /// Another frame than when something was chosen last has nothing chosen yet.
  void follow();
  void answer(const std::string& choice, const std::optional<Eigen::Vector2d>& pointed = {});
  /// A half of a pair; both make an answer.
  void choose_half(std::size_t half, const std::string& name);
  [[nodiscard]] std::size_t next_half() const { return halves_[0].empty() ? 0 : 1; }

  App& app_;
  std::pair<long, int> at_ = {-1, -1};  ///< Version and index of the frame.
  std::array<std::string, 2> halves_;   ///< Halves of a pair that were chosen.
  int highlighted_ = 0;                 ///< By keyboard.
  int typed_ = 0;
  double typed_at_ = 0.0;
};

}  // namespace gjkscope
