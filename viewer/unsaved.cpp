#include "unsaved.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <random>
#include <span>
#include <system_error>
#include <utility>

#include "base/file.hpp"
#include "lesson/save.hpp"

namespace gjkscope {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = "unsaved-";
constexpr std::string_view kLock = ".lock";
constexpr std::string_view kFrom = "# unsaved work on ";

/// The open and locked file; -1 when another process has it, or it is gone.
int lock_of(const fs::path& path, int flags) {
  const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC | flags, 0666);
  if (file < 0) return -1;
  struct stat there = {};
  // The lock's owner may remove it: its name may be gone by the time that the lock is ours.
  if (::flock(file, LOCK_EX | LOCK_NB) == 0 && ::fstat(file, &there) == 0 && there.st_nlink > 0)
    return file;
  ::close(file);
  return -1;
}

fs::path work_of(const fs::path& lock, int number) {
  return lock.parent_path() / fmt::format("{}-{}.toml", lock.stem().string(), number);
}

/// All that stands beside a lock, in order.
std::vector<fs::path> works_of(const fs::path& lock) {
  std::error_code none;
  std::vector<std::pair<int, fs::path>> numbered;
  const std::string prefix = lock.stem().string() + "-";
  for (const fs::directory_entry& entry : fs::directory_iterator(lock.parent_path(), none)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(prefix) && name.ends_with(".toml"))
      numbered.emplace_back(std::atoi(name.c_str() + prefix.size()), entry.path());
  }
  std::sort(numbered.begin(), numbered.end());
  std::vector<fs::path> works;
  for (auto& [number, path] : numbered) works.push_back(std::move(path));
  return works;
}

void remove_work(const fs::path& lock, int after) {
  std::error_code none;
  while (fs::remove(work_of(lock, ++after), none)) continue;
}

}  // namespace

UnsavedWork::UnsavedWork(fs::path folder) : folder_(std::move(folder)) {
  if (folder_.empty()) return;
  std::error_code why;
  fs::create_directories(folder_, why);
  std::random_device random;
  constexpr int kTries = 16;  // a name that is taken is one in four thousand million
  for (int i = 0; i < kTries && lock_ < 0; ++i) {
    path_ = folder_ / fmt::format("{}{:08x}{}", kPrefix, random(), kLock);
    lock_ = lock_of(path_, O_CREAT | O_EXCL);
    if (lock_ < 0 && !why) why.assign(errno, std::generic_category());
  }
  if (lock_ < 0) problem_ = fmt::format("{}: {}", folder_.string(), why.message());
}

UnsavedWork::~UnsavedWork() {
  std::error_code none;
  for (const Orphan& orphan : orphans_) ::close(orphan.lock);
  if (lock_ < 0) return;
  if (!fs::exists(work_of(path_, 1), none)) fs::remove(path_, none);
  ::close(lock_);
}

void UnsavedWork::release(Orphan& orphan) {
  std::error_code none;
  fs::remove(orphan.path, none);
  ::close(std::exchange(orphan.lock, -1));
}

void UnsavedWork::keep(const std::vector<Session::Unsaved>& all) {
  if (!keeps()) return;
  int kept = 0;
  for (const Session::Unsaved& each : all) {
    const std::string text = fmt::format("{}{}\n{}", kFrom, each.file.string(),
                                         lesson_toml(with_absolute_file(each.lesson)));
    // Bytes: not pushed to the disk, which would hold up a drag; a killed process loses none.
    write_whole(work_of(path_, ++kept),
                std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
  }
  remove_work(path_, kept);
}

std::vector<UnsavedWork::Left> UnsavedWork::left() {
  std::vector<Left> left;
  if (!keeps()) return left;
  std::error_code none;
  std::vector<fs::path> locks;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, none)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(kPrefix) && name.ends_with(kLock) && entry.path() != path_)
      locks.push_back(entry.path());
  }
  std::sort(locks.begin(), locks.end());
  for (const fs::path& path : locks) {
    const int lock = lock_of(path, 0);
    if (lock < 0) continue;
    orphans_.push_back({lock, path});
    const std::vector<fs::path> works = works_of(path);
    for (const fs::path& work : works) {
      std::string text = read_whole(work);
      const std::size_t end = text.find('\n');
      std::string from;
      if (text.starts_with(kFrom) && end != std::string::npos)
        from = text.substr(kFrom.size(), end - kFrom.size());
      left.push_back({std::move(text), from, work, fs::last_write_time(work, none)});
    }
    if (works.empty()) release(orphans_.back());
  }
  std::erase_if(orphans_, [](const Orphan& orphan) { return orphan.lock < 0; });
  std::stable_sort(left.begin(), left.end(),
                   [](const Left& a, const Left& b) { return a.time > b.time; });
  return left;
}

void UnsavedWork::forget(const Left& left) {
  std::error_code none;
  fs::remove(left.kept_in, none);
  for (Orphan& orphan : orphans_) {
    if (works_of(orphan.path).empty()) release(orphan);
  }
  std::erase_if(orphans_, [](const Orphan& orphan) { return orphan.lock < 0; });
}

}  // namespace gjkscope
