#include "export/frame_writer.hpp"

#include <utility>

#include "lesson/file.hpp"

namespace gjkscope {

FrameWriter::FrameWriter(int thread_count, int supersampling)
    // One image in the hands of each thread, one being painted, one ready to be taken up.
    : supersampling_(supersampling), free_(static_cast<std::size_t>(thread_count) + 2) {
  for (int i = 0; i < thread_count; ++i) threads_.emplace_back([this] { work(); });
}

FrameWriter::~FrameWriter() { close(); }

Image FrameWriter::acquire() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !free_.empty() || failure_; });
  if (failure_) std::rethrow_exception(failure_);
  Image image = std::move(free_.back());
  free_.pop_back();
  return image;
}

void FrameWriter::submit(Image image, std::filesystem::path path, PngWords words) {
  const std::lock_guard lock(mutex_);
  jobs_.push_back({std::move(image), std::move(path), std::move(words)});
  changed_.notify_all();
}

void FrameWriter::finish() {
  close();
  if (failure_) std::rethrow_exception(failure_);
}

void FrameWriter::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

void FrameWriter::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return !jobs_.empty() || closed_; });
    if (jobs_.empty()) return;
    Job job = std::move(jobs_.front());
    jobs_.pop_front();
    // After a failure the rest is only taken off the queue.
    if (!failure_) {
      lock.unlock();
      std::exception_ptr failure;
      try {
        write_whole(job.path, encode_png(shrink(job.image, supersampling_), job.words));
      } catch (...) {
        failure = std::current_exception();
      }
      lock.lock();
      if (failure && !failure_) failure_ = failure;
    }
    free_.push_back(std::move(job.image));
    changed_.notify_all();
  }
}

}  // namespace gjkscope
