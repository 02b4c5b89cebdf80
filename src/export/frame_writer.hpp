#pragma once
// Shrinks, encodes and writes painted frames on threads of their own, while the next is painted.

#include <condition_variable>
#include <deque>
#include <exception>
#include <filesystem>
#include <mutex>
#include <thread>
#include <vector>

#include "paint/png.hpp"

namespace gjkscope {

class FrameWriter {
 public:
  /// `supersampling` is that of the images handed in.
  FrameWriter(int thread_count, int supersampling);
  /// Waits for the threads; what they failed at is lost unless `finish` asked for it.
  ~FrameWriter();
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;

  /// An image to paint into, as soon as one is free: memory is bounded. Throws what a thread failed
  /// at.
  [[nodiscard]] Image acquire();
  void submit(Image image, std::filesystem::path path, PngWords words);
  /// Waits until all is written. Throws what a thread failed at.
  void finish();

 private:
  struct Job {
    Image image;
    std::filesystem::path path;
    PngWords words;
  };
  void work();
  void close();

  int supersampling_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Job> jobs_;
  std::vector<Image> free_;
  std::exception_ptr failure_;
  bool closed_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace gjkscope
