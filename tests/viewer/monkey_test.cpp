// Random input: no crash, no hang, no assertion, and a session that stays sound.

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <random>

#include "command.hpp"
#include "command_line.hpp"
#include "headless_app.hpp"
#include "lesson/save.hpp"
#include "lessons.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace monkey_test {

using test::HeadlessApp;

class Monkey {
 public:
  Monkey(HeadlessApp& window, std::uint64_t seed) : window_(window), bits_(seed) {}

  void tour() {
    static const std::array<const char*, 34> kKeys = {
        "Right", "Left", "Home", "End", "PageUp", "PageDown", "Space", "Tab", "Delete",
        "A",     "C",    "E",    "F",   "G",      "L",        "N",     "O",   "P",
        "S",     "T",    "V",    "Y",   "Z",      "1",        "2",     "3",   "/",
        "?",     "F5",   "[",    "]",   "Escape", "Up",       "Down"};
    ImGuiIO& io = ImGui::GetIO();
    switch (below(9)) {
      case 0:
      case 1:
        io.MousePos = ImVec2(static_cast<float>(below(1500)), static_cast<float>(below(950)));
        break;
      case 2:
        io.MouseDown[0] = !io.MouseDown[0];
        if (io.MouseDown[0]) window_.app().picture().clicked(1 + below(2));
        break;
      case 3:
        io.MouseWheel = static_cast<float>(below(5) - 2);
        break;
      case 4:
        io.AddInputCharactersUTF8(std::array<const char*, 6>{
            "1", "-", "0x1p3", ".", "é", "/"}[static_cast<std::size_t>(below(6))]);
        break;
      case 5:
        if (below(40) == 0) window_.resize(1 + below(1600), 1 + below(1000));
        break;
      case 6: {
        const std::vector<Command>& all = window_.app().commands();
        const Command& command = all[static_cast<std::size_t>(below(all.size()))];
        // Files are written where the test does not look.
        if (command.group != "File" && !window_.app().has_dialog())
          window_.app().run_command(std::string(command.name));
        break;
      }
      default: {
        const std::string key = kKeys[static_cast<std::size_t>(below(kKeys.size()))];
        const bool ctrl = below(4) == 0;
        if (ctrl && (key == "S" || key == "E")) break;
        if (!io.WantTextInput || key == "Escape") window_.app().press({key, ctrl, below(4) == 0});
      }
    }
    if (below(4) == 0) window_.frame(0.05 * (1 + below(10)));
  }

 private:
  int below(std::size_t count) { return static_cast<int>(bits_() % count); }

  HeadlessApp& window_;
  std::mt19937_64 bits_;
};

/// GJKSCOPE_MONKEY asks for another number of events.
int event_count() {
  const char* asked = std::getenv("GJKSCOPE_MONKEY");
  return asked ? std::atoi(asked) : 4000;
}

TEST(Monkey, RandomEventsBreakNothing) {
  const std::vector<Lesson> lessons = testing::shipped_lessons();
  const int rounds = 8;
  for (int round = 0; round < rounds; ++round) {
    SCOPED_TRACE(round);
    const test::TemporaryFolder state;
    const Lesson& lesson = lessons[static_cast<std::size_t>(round * 5) % lessons.size()];
    HeadlessApp window(lesson.id, state.path());
    std::string clipboard;
    window.app().copy = [&](const std::string& text) { clipboard = text; };
    window.app().paste = [&] { return clipboard; };
    Monkey monkey(window, static_cast<std::uint64_t>(round) + 1);
    for (int i = 0; i < event_count() / rounds; ++i) monkey.tour();
    ImGui::GetIO().MouseDown[0] = false;
    window.settle();
    // The lesson can be written and read again.
    const LoadedLesson read =
        parse_lesson(lesson_toml(window.session().lesson()), lesson.path, vocabulary());
    for (const Problem& problem : read.problems) ADD_FAILURE() << to_string(problem);
    EXPECT_LT(window.session().index(), window.session().frame_count());
  }
}

}  // namespace monkey_test
}  // namespace gjkscope
