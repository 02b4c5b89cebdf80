#include "window/file_watch.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

namespace gjkscope {

struct FileWatch::State {
  explicit State(std::function<void()> call) : changed(std::move(call)) {
    if (events < 0 || stop < 0) return;
    thread = std::thread([this] { listen(); });
  }
  ~State() {
    if (thread.joinable()) {
      const std::uint64_t one = 1;
      (void)!::write(stop, &one, sizeof one);
      thread.join();
    }
    if (events >= 0) ::close(events);
    if (stop >= 0) ::close(stop);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void listen() {
    std::array<pollfd, 2> from = {{{events, POLLIN, 0}, {stop, POLLIN, 0}}};
    alignas(inotify_event) std::array<char, 4096> buffer = {};
    while (true) {
      if (::poll(from.data(), from.size(), -1) < 0) continue;
      if (from[1].revents != 0) return;
      const ssize_t size = ::read(events, buffer.data(), buffer.size());
      bool hit = false;
      for (ssize_t at = 0; at + static_cast<ssize_t>(sizeof(inotify_event)) <= size;) {
        inotify_event event = {};
        std::memcpy(&event, buffer.data() + at, sizeof event);
        const char* name = buffer.data() + at + sizeof event;
        const std::scoped_lock lock(mutex);
        hit = hit || (event.len > 0 && file_name == name);
        at += static_cast<ssize_t>(sizeof event + event.len);
      }
      if (hit) changed();
    }
  }

  std::function<void()> changed;
  int events = ::inotify_init1(IN_CLOEXEC);
  int stop = ::eventfd(0, EFD_CLOEXEC);
  std::mutex mutex;
  std::string file_name;
  int folder = -1;
  std::thread thread;
};

FileWatch::FileWatch(std::function<void()> changed)
    : state_(std::make_unique<State>(std::move(changed))) {}
FileWatch::~FileWatch() = default;

void FileWatch::watch(const std::filesystem::path& file) {
  if (state_->events < 0) return;
  if (state_->folder >= 0) inotify_rm_watch(state_->events, state_->folder);
  const std::scoped_lock lock(state_->mutex);
  state_->file_name = file.filename().string();
  // The folder, because editors put a new file in the place of the old one.
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  state_->folder =
      file.empty() ? -1
                   : inotify_add_watch(state_->events, folder.c_str(),
                                       IN_CLOSE_WRITE | IN_MOVED_TO | IN_DELETE | IN_MOVED_FROM);
}

}  // namespace gjkscope
