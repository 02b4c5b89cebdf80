#include "base/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <ios>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

namespace gjkscope {
namespace {

constexpr std::string_view kPrefix = ".gjkscope-";
constexpr std::string_view kSuffix = ".part";
constexpr std::string_view kSignatureBegin = "Made by gjkscope ";

/// The file itself where `path` is a symbolic link to it.
std::filesystem::path followed(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_symlink(path, error)) return path;
  const std::filesystem::path target = std::filesystem::canonical(path, error);
  return error ? path : target;
}

class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& path)
      : final_(followed(path)),
        name_(temporary_name(final_)),
        descriptor_(::open(name_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) fail();
    // Keeps the permissions of the file that it replaces, on systems that have permissions.
    struct stat old = {};
    if (::stat(final_.c_str(), &old) == 0) (void)::fchmod(descriptor_, old.st_mode & 0777);
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!kept_) ::unlink(name_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
      const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail();
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
  }

  void flush() const {
    // Not every file system can.
    if (::fsync(descriptor_) != 0 && errno != EINVAL) fail();
  }

  void keep() {
    // Network file systems report a full disk only here.
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0 || ::rename(name_.c_str(), final_.c_str()) != 0) fail();
    kept_ = true;
  }

 private:
  [[noreturn]] void fail() const {
    throw std::runtime_error(
        fmt::format("cannot write {}: {}", final_.string(), std::strerror(errno)));
  }

  std::filesystem::path final_;
  std::filesystem::path name_;
  int descriptor_;
  bool kept_ = false;
};

bool is_alive(int process) { return ::kill(process, 0) == 0 || errno != ESRCH; }

}  // namespace

// The writer's process id is in the name: another one's files are its own business while it lives.
std::filesystem::path temporary_name(const std::filesystem::path& path) {
  return path.parent_path() /
         fmt::format("{}{}-{}{}", kPrefix, ::getpid(), path.filename().string(), kSuffix);
}

void write_whole(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  TemporaryFile file(path);
  file.write(bytes);
  file.keep();
}

void write_whole(const std::filesystem::path& path, std::string_view text) {
  TemporaryFile file(path);
  file.write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  file.flush();
  file.keep();
}

std::string read_whole(const std::filesystem::path& path) {
  std::error_code none;
  std::ifstream stream(path, std::ios::binary);
  const bool is_folder = std::filesystem::is_directory(path, none);
  if (!stream || is_folder) {
    throw std::runtime_error(fmt::format("cannot read {}: {}", path.string(),
                                         std::strerror(is_folder ? EISDIR : errno)));
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

FileText read_file(const std::filesystem::path& file, std::size_t most_bytes) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) return {std::nullopt, "there is no such file"};
  if (!std::filesystem::is_regular_file(status)) return {std::nullopt, "this is not a file"};
  std::ifstream in(file, std::ios::binary);
  if (!in) return {std::nullopt, "the file cannot be opened"};
  // One byte more than allowed tells that there is more, however large the file.
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) return {std::nullopt, "the file cannot be read"};
  std::string text(std::min<std::uintmax_t>(size, most_bytes) + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad()) return {std::nullopt, "the file cannot be read"};
  text.resize(static_cast<std::size_t>(in.gcount()));
  return {std::move(text), {}};
}

void remove_leftovers(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(kPrefix) || !name.ends_with(kSuffix)) continue;
    int process = 0;
    const char* const digits = name.data() + kPrefix.size();
    const auto [end, error] = std::from_chars(digits, name.data() + name.size(), process);
    if (error != std::errc{} || *end != '-' || process <= 0) continue;
    if (process != ::getpid() && is_alive(process)) continue;
    std::filesystem::remove(entry.path(), ignored);
  }
}

const std::string& signature() {
  static const std::string text = std::string(kSignatureBegin) + GJKSCOPE_VERSION;
  return text;
}

bool mentions(const std::filesystem::path& file, std::string_view text) {
  // It stands near the start, or, in films and documents, near the end.
  constexpr std::streamoff kNear = 1 << 16;
  constexpr std::streamoff kFar = 1 << 20;
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) return false;
  const std::streamoff size = stream.tellg();
  const auto has = [&](std::streamoff begin, std::streamoff end) {
    std::string bytes(static_cast<std::size_t>(end - begin), '\0');
    stream.seekg(begin);
    stream.read(bytes.data(), end - begin);
    return bytes.find(text) != std::string::npos;
  };
  return has(0, std::min(size, kNear)) || (size > kNear && has(size - std::min(size, kFar), size));
}

bool is_exported(const std::filesystem::path& file) {
  std::error_code none;
  return !std::filesystem::exists(file, none) || mentions(file, kSignatureBegin);
}

void refuse_foreign(const std::filesystem::path& file) {
  if (is_exported(file)) return;
  throw std::runtime_error(fmt::format(
      "{} is there and was not exported by gjkscope; --force replaces it", file.string()));
}

std::filesystem::path share_folder() {
  if (const char* given = std::getenv("GJKSCOPE_SHARE"); given != nullptr && *given != '\0') {
    return given;
  }
  std::error_code failed;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failed);
  if (!failed) {
    std::filesystem::path installed = program.parent_path().parent_path() / "share" / "gjkscope";
    if (std::filesystem::is_directory(installed / "lessons", failed)) return installed;
  }
  return GJKSCOPE_SOURCE_DIR;
}

}  // namespace gjkscope
