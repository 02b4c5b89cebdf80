#include "export/frame_writer.hpp"

#include <utility>

namespace gjkscope {

FrameWriter::FrameWriter(int thread_count, std::function<Write()> make_write)
    : make_write_(std::move(make_write)),
      most_waiting_(2 * static_cast<std::size_t>(thread_count)) {
  for (int i = 0; i < thread_count; ++i) threads_.emplace_back([this] { work(); });
}

FrameWriter::~FrameWriter() { close(); }

void FrameWriter::submit(FrameJob job) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return jobs_.size() < most_waiting_ || failure_; });
  if (failure_) std::rethrow_exception(failure_);
  jobs_.push_back(std::move(job));
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
  Write write;
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return !jobs_.empty() || closed_; });
    if (jobs_.empty()) return;
    const FrameJob job = std::move(jobs_.front());
    jobs_.pop_front();
    changed_.notify_all();
    // After a failure the rest is only taken off the queue.
    if (failure_) continue;
    lock.unlock();
    std::exception_ptr failure;
    try {
      if (!write) write = make_write_();
      write(job);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    if (failure && !failure_) failure_ = failure;
    changed_.notify_all();
  }
}

}  // namespace gjkscope
