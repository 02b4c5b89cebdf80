#pragma once
// Unsaved work on disk, for a window that starts after this one ended, however it ended.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lesson/lesson.hpp"
#include "session/session.hpp"

namespace gjkscope {

/// Each window keeps its work in files named after one that it has locked: the system takes the
/// lock away when the process ends. So work whose lock can be had is nobody's.
class UnsavedWork {
 public:
  /// `folder` is made when it is not there; empty: nothing is kept.
  explicit UnsavedWork(std::filesystem::path folder);
  ~UnsavedWork();
  UnsavedWork(const UnsavedWork&) = delete;
  UnsavedWork& operator=(const UnsavedWork&) = delete;

  [[nodiscard]] bool keeps() const { return lock_ >= 0; }
  /// Why it does not, though it has a folder; empty when all is well.
  [[nodiscard]] const std::string& problem() const { return problem_; }
  /// All that is not saved now. Throws std::runtime_error when it cannot be written.
  void keep(const std::vector<Session::Unsaved>& all);

  struct Left {
    std::string text;                      ///< A lesson file.
    std::filesystem::path file;            ///< The lesson's; empty when it had none.
    std::filesystem::path kept_in;         ///< The file of the text.
    std::filesystem::file_time_type time;  ///< When it was kept.
  };
  /// The work that windows left that are gone, the newest first. Until this window ends, no other
  /// one is offered it.
  [[nodiscard]] std::vector<Left> left();
  /// Removes one that left() gave.
  void forget(const Left& left);

 private:
  struct Orphan {
    int lock = -1;
    std::filesystem::path path;  ///< The lock's; the work stands beside it.
  };
  /// Removes the lock of one whose work is gone.
  static void release(Orphan& orphan);

  std::filesystem::path folder_;
  std::filesystem::path path_;
  int lock_ = -1;
  std::string problem_;
  std::vector<Orphan> orphans_;
};

}  // namespace gjkscope
