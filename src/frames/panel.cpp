#include "frames/panel.hpp"

#include <algorithm>

#include "subjects/run/code.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {

std::vector<Mark> panel_marks(const LessonRun& run, EffectGraph& effects, const Frame& frame,
                              const Fonts& fonts, const Rect& card) {
  PanelBuilder panel(run, effects, frame, fonts, card);
  // A question at a new place would be answered by the numbers there.
  if (frame.question >= 0 && run.tour->asking != nullptr) {
    panel.heading("The numbers come with the answer.");
    return std::move(panel.marks);
  }
  if (code::language_of(run.lesson.listing) != Language::pseudocode) {
    code::write(panel);  // with the values of its variables it needs the room of all blocks
    return std::move(panel.marks);
  }
  for (const std::string& name : run.lesson.panel) {
    const std::size_t before = panel.marks.size();
    if (&name != &run.lesson.panel.front()) panel.rule();
    const std::size_t empty = panel.marks.size();
    const auto block = std::find_if(registered_blocks().begin(), registered_blocks().end(),
                                    [&](const Block* each) { return each->name == name; });
    (*block)->write(panel);
    // A rule above nothing would promise something.
    if (panel.marks.size() == empty)
      panel.marks.erase(panel.marks.begin() + static_cast<std::ptrdiff_t>(before),
                        panel.marks.end());
  }
  return std::move(panel.marks);
}

}  // namespace gjkscope
