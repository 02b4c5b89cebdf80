// Unsaved work: kept while the window lives, offered by the next one.

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <stdexcept>

#include "app.hpp"
#include "lesson/load.hpp"
#include "subjects/subjects.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

namespace fs = std::filesystem;

constexpr double kSaveEvery = 1.0;  // seconds; what a crash may cost

}  // namespace

void App::keep_unsaved() {
  end_keeping();
  kept_version_ = session_.version();
  next_save_ = now_ + kSaveEvery;
  try {
    unsaved_.keep(session_.all_unsaved());
    not_kept_.clear();
  } catch (const std::runtime_error& error) {
    not_kept_ = error.what();
  }
}

void App::keep_unsaved_beside() {
  kept_version_ = session_.version();
  next_save_ = now_ + kSaveEvery;
  struct Work {
    Lesson lesson;
    fs::path file;
  };
  std::vector<Work> work;
  for (const Session::Unsaved& each : session_.all_unsaved())
    work.push_back({each.lesson, each.file});
  keeping_ = std::async(std::launch::async, [this, work = std::move(work)] {
    std::vector<Session::Unsaved> all;
    for (const Work& each : work) all.push_back({each.lesson, each.file});
    unsaved_.keep(all);
  });
}

void App::end_keeping() {
  if (!keeping_.valid()) return;
  try {
    keeping_.get();
    not_kept_.clear();
  } catch (const std::runtime_error& error) {
    not_kept_ = error.what();
  }
}

// Before work goes -------------------------------------------------------------------------------

bool App::would_lose_work() const {
  return (!unsaved_.keeps() || !not_kept_.empty()) && !session_.all_unsaved().empty();
}

void App::ask_to_quit() {
  if (is_exporting() && !std::exchange(gives_export_up_, true))
    return say("an export is going on: quit again to give it up", true);
  if (unsaved_.keeps()) keep_unsaved();  // now, and with a disk that may have room again
  const bool is_asked = dialog_ && dialog_->title == kQuitTitle;
  if (is_asked || !would_lose_work()) {
    quit_ = true;
  } else {
    show_dialog(quit_dialog(*this, [this] { quit_ = true; }));
  }
}

// Work that other windows left -------------------------------------------------------------------

void App::offer_left_work() {
  try {
    for (UnsavedWork::Left& each : unsaved_.left()) {
      will_show(each.file.string());
      left_.push_back({std::move(each)});
    }
  } catch (const std::runtime_error& error) {
    say(fmt::format("unsaved work cannot be read: {}", error.what()), true);
  }
}

void App::show_left_work() {
  if (left_.size() > 1 || left_.front().is_discarded) return show_dialog(left_work_dialog(*this));
  (void)open_left(0);
}

bool App::open_left(std::size_t index) {
  const UnsavedWork::Left left = left_[index].work;
  LoadedLesson loaded =
      parse_lesson(left.text, left.file.empty() ? "unsaved.toml" : left.file, vocabulary());
  if (!loaded.lesson) {
    say(loaded.problems);
    return false;
  }
  std::string text;
  ReadLesson saved;
  std::error_code none;
  if (fs::exists(left.file, none)) {
    text = read_whole(left.file);
    saved = read_lesson(text, left.file);
    note(std::move(saved.noted));
  }
  const std::string name = left.file.empty() ? loaded.lesson->title : left.file.string();
  // On top of what its file holds, so that undo and revert lead there.
  const bool shown = saved.lesson ? show(*std::move(saved.lesson), left.file, name) &&
                                        edit("what was not saved", *std::move(loaded.lesson))
                                  : show(*std::move(loaded.lesson), left.file, name, true);
  if (!shown) return false;
  files_.note_read(left.file, std::move(text));
  looked_at_ = left.file;
  keep_unsaved();
  if (not_kept_.empty()) unsaved_.forget(left);
  left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(index));
  say(fmt::format("opened what was not saved of {}",
                  left.file.empty() ? name : left.file.filename().string()));
  return true;
}

void App::discard_left_work(bool is_discarded) {
  for (LeftWork& each : left_) each.is_discarded = is_discarded;
  say(is_discarded ? "discarded; until this window ends, 'Put back discarded work' brings it back"
                   : "unsaved work is offered again");
}

}  // namespace gjkscope
