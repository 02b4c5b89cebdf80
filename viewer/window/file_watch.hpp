#pragma once
#include <filesystem>
#include <functional>
#include <memory>

namespace gjkscope {

/// Waits for a file to be written, replaced or removed, without asking again and again (inotify).
class FileWatch {
 public:
  /// `changed` is called on a thread of the watch. Where the system has no such thing, never.
  explicit FileWatch(std::function<void()> changed);
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  /// The one file to watch from now on; empty: none.
  void watch(const std::filesystem::path& file);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace gjkscope
