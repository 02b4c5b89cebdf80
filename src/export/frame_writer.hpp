#pragma once
// Draws and writes frames on threads of their own, while the next are built.

#include <condition_variable>
#include <deque>
#include <exception>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "picture/picture.hpp"

namespace gjkscope {

/// A frame and its file, with what the file says of itself.
struct FrameJob {
  Picture picture;
  std::filesystem::path path;
  std::string title;
  std::string description;
  std::string record;
};

class FrameWriter {
 public:
  using Write = std::function<void(const FrameJob&)>;
  /// Each thread that has a frame to write calls `make_write` once.
  FrameWriter(int thread_count, std::function<Write()> make_write);
  /// Waits for the threads; what they failed at is lost unless `finish` asked for it.
  ~FrameWriter();
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;

  /// Waits while enough frames are waiting. Throws what a thread failed at.
  void submit(FrameJob job);
  /// Waits until all is written. Throws what a thread failed at.
  void finish();

 private:
  void work();
  void close();

  std::function<Write()> make_write_;
  std::size_t most_waiting_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<FrameJob> jobs_;
  std::exception_ptr failure_;
  bool closed_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace gjkscope
