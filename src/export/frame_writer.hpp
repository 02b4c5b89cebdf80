#pragma once
// Paints, encodes and writes frames on threads of their own, while the next are built.

#include <condition_variable>
#include <deque>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "paint/canvas.hpp"
#include "paint/png.hpp"

namespace gjkscope {

class FrameWriter {
 public:
  using MakeCanvas = std::function<std::unique_ptr<Canvas>()>;
  /// Each thread that has a frame to paint makes itself a canvas.
  FrameWriter(int thread_count, MakeCanvas make_canvas);
  /// Waits for the threads; what they failed at is lost unless `finish` asked for it.
  ~FrameWriter();
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;

  /// Waits while enough frames are waiting. Throws what a thread failed at.
  void submit(Picture picture, std::filesystem::path path, PngWords words);
  /// Waits until all is written. Throws what a thread failed at.
  void finish();

 private:
  struct Job {
    Picture picture;
    std::filesystem::path path;
    PngWords words;
  };
  void work();
  void close();

  MakeCanvas make_canvas_;
  std::size_t most_waiting_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Job> jobs_;
  std::exception_ptr failure_;
  bool closed_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace gjkscope
