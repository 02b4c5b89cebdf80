#include "export/film.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gif_lib.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "base/file.hpp"
#include "export/record.hpp"
#include "paint/png.hpp"

namespace gjkscope {
namespace {

/// 0xRRGGBB
using Rgb = std::uint32_t;

std::vector<Rgb> colors_of(const Image& image) {
  std::vector<Rgb> out(image.pixels.size() / 4);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::uint8_t* p = image.pixels.data() + 4 * i;
    out[i] = static_cast<Rgb>(p[0]) << 16 | static_cast<Rgb>(p[1]) << 8 | p[2];
  }
  return out;
}

Rgb rgb(const Color& color) {
  return static_cast<Rgb>(color.r) << 16 | static_cast<Rgb>(color.g) << 8 | color.b;
}

int distance_sq(Rgb a, Rgb b) {
  int sum = 0;
  for (const int shift : {16, 8, 0}) {
    const int d = static_cast<int>(a >> shift & 0xFF) - static_cast<int>(b >> shift & 0xFF);
    sum += d * d;
  }
  return sum;
}

/// At most 256 colours for an image: the theme's that it has, then the most frequent.
class Palette {
 public:
  Palette(const std::vector<Rgb>& pixels, const std::vector<Color>& theme) {
    std::unordered_map<Rgb, int> counts;
    for (const Rgb pixel : pixels) ++counts[pixel];
    std::vector<std::pair<int, Rgb>> by_count;
    for (const Color& color : theme) {
      const auto found = counts.find(rgb(color));
      if (found != counts.end()) found->second = std::numeric_limits<int>::max();
    }
    by_count.reserve(counts.size());
    for (const auto& [color, count] : counts) by_count.emplace_back(-count, color);
    std::sort(by_count.begin(), by_count.end());
    for (const auto& [count, color] : by_count) {
      if (colors_.size() < 256) {
        index_[color] = static_cast<std::uint8_t>(colors_.size());
        colors_.push_back(color);
      } else {
        index_[color] = nearest(color);
      }
    }
  }
  [[nodiscard]] std::uint8_t index(Rgb color) const { return index_.at(color); }
  [[nodiscard]] const std::vector<Rgb>& colors() const { return colors_; }

 private:
  [[nodiscard]] std::uint8_t nearest(Rgb color) const {
    const auto found = std::min_element(colors_.begin(), colors_.end(), [&](Rgb a, Rgb b) {
      return distance_sq(a, color) < distance_sq(b, color);
    });
    return static_cast<std::uint8_t>(found - colors_.begin());
  }
  std::vector<Rgb> colors_;
  std::unordered_map<Rgb, std::uint8_t> index_;
};

struct MapDeleter {
  void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};

class GifFilm : public Film {
 public:
  GifFilm(const std::filesystem::path& file, int width, int height, const Theme& theme,
          const FilmWords& words)
      : file_(file), width_(width), height_(height), theme_(theme.colors()) {
    int error = 0;
    gif_ = EGifOpen(&bytes_, append, &error);
    if (!gif_) throw cannot_make(error);
    EGifSetGifVersion(gif_, true);
    require(EGifPutScreenDesc(gif_, width, height, 8, 0, nullptr));
    // Again and again.
    constexpr std::array<GifByteType, 3> kLoop = {1, 0, 0};
    require(EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE));
    require(EGifPutExtensionBlock(gif_, 11, "NETSCAPE2.0"));
    require(EGifPutExtensionBlock(gif_, static_cast<int>(kLoop.size()), kLoop.data()));
    require(EGifPutExtensionTrailer(gif_));
    require(EGifPutComment(gif_, words.comment.c_str()));
  }
  ~GifFilm() override {
    if (gif_) EGifCloseFile(gif_, nullptr);
  }
  GifFilm(const GifFilm&) = delete;
  GifFilm& operator=(const GifFilm&) = delete;

  void add(const Image& image, double seconds) override {
    std::vector<Rgb> pixels = colors_of(image);
    if (pixels == last_) {
      seconds_ += seconds;
      return;
    }
    write_last();
    before_ = std::move(last_);
    last_ = std::move(pixels);
    seconds_ = seconds;
  }

  void finish() override {
    write_last();
    int error = 0;
    GifFileType* const gif = std::exchange(gif_, nullptr);
    if (EGifCloseFile(gif, &error) != GIF_OK) throw cannot_make(error);
    write_whole(file_, std::span<const std::uint8_t>(bytes_));
  }

 private:
  static int append(GifFileType* gif, const GifByteType* bytes, int count) {
    auto& out = *static_cast<std::vector<std::uint8_t>*>(gif->UserData);
    out.insert(out.end(), bytes, bytes + count);
    return count;
  }
  [[nodiscard]] std::runtime_error cannot_make(int error) const {
    return std::runtime_error(
        fmt::format("cannot write {}: {}", file_.string(), GifErrorString(error)));
  }
  void require(int status) const {
    if (status != GIF_OK) throw cannot_make(gif_->Error);
  }

  /// The least rectangle outside of which the image is as the one before.
  struct Area {
    int left, top, right, bottom;
  };
  [[nodiscard]] Area changed() const {
    if (before_.empty()) return {0, 0, width_, height_};
    Area area{width_, height_, 0, 0};
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        const auto i = static_cast<std::size_t>(y) * width_ + x;
        if (before_[i] == last_[i]) continue;
        area = {std::min(area.left, x), std::min(area.top, y), std::max(area.right, x + 1),
                std::max(area.bottom, y + 1)};
      }
    }
    return area;
  }

  void write_last() {
    if (last_.empty()) return;
    const Area area = changed();
    const int width = area.right - area.left;
    std::vector<Rgb> pixels;
    for (int y = area.top; y < area.bottom; ++y) {
      const auto row = last_.begin() + static_cast<std::ptrdiff_t>(y) * width_;
      pixels.insert(pixels.end(), row + area.left, row + area.right);
    }
    const Palette palette(pixels, theme_);
    std::vector<GifColorType> colors(256, GifColorType{});
    for (std::size_t i = 0; i < palette.colors().size(); ++i) {
      const Rgb c = palette.colors()[i];
      colors[i] = {static_cast<GifByteType>(c >> 16), static_cast<GifByteType>(c >> 8),
                   static_cast<GifByteType>(c)};
    }
    const std::unique_ptr<ColorMapObject, MapDeleter> map(GifMakeMapObject(256, colors.data()));
    GraphicsControlBlock control = {};
    control.DisposalMode = DISPOSE_DO_NOT;
    control.DelayTime = static_cast<int>(std::lround(100.0 * seconds_));
    control.TransparentColor = NO_TRANSPARENT_COLOR;
    std::array<GifByteType, 4> packed = {};
    EGifGCBToExtension(&control, packed.data());
    require(EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, 4, packed.data()));
    require(EGifPutImageDesc(gif_, area.left, area.top, width, area.bottom - area.top, false,
                             map.get()));
    std::vector<GifPixelType> indices(pixels.size());
    std::transform(pixels.begin(), pixels.end(), indices.begin(),
                   [&](Rgb color) { return palette.index(color); });
    for (int y = 0; y < area.bottom - area.top; ++y) {
      require(EGifPutLine(gif_, indices.data() + static_cast<std::ptrdiff_t>(y) * width, width));
    }
  }

  std::filesystem::path file_;
  int width_;
  int height_;
  std::vector<Color> theme_;
  std::vector<std::uint8_t> bytes_;
  GifFileType* gif_ = nullptr;
  std::vector<Rgb> before_;  ///< Nothing before the second image.
  std::vector<Rgb> last_;    ///< Not written yet: the next may be the same.
  double seconds_ = 0.0;
};

class ApngFilm : public Film {
 public:
  ApngFilm(std::filesystem::path file, FilmWords words)
      : file_(std::move(file)), words_(std::move(words)) {}

  void add(const Image& image, double seconds) override {
    if (image.pixels == last_) {
      frames_.back().seconds += seconds;
      return;
    }
    last_ = image.pixels;
    Frame frame{seconds, {}};
    for (PngChunk& chunk : png_chunks(encode_png(image))) {
      if (chunk.type == "IHDR") header_ = chunk;
      if (chunk.type == "IDAT") frame.data.push_back(std::move(chunk.data));
    }
    frames_.push_back(std::move(frame));
  }

  void finish() override {
    std::vector<PngChunk> chunks = {header_, {"acTL", {}}};
    append_number(chunks.back().data, static_cast<std::uint32_t>(frames_.size()));
    append_number(chunks.back().data, 0);  // Again and again
    chunks.push_back(png_text("Software", signature()));
    chunks.push_back(png_text("Title", words_.title));
    chunks.push_back(png_text(kRecordKeyword, words_.comment));
    std::uint32_t number = 0;
    for (const Frame& frame : frames_) {
      chunks.push_back(control(number++, frame.seconds));
      for (const std::vector<std::uint8_t>& data : frame.data) {
        if (&frame == &frames_.front()) {
          chunks.push_back({"IDAT", data});
          continue;
        }
        PngChunk chunk{"fdAT", {}};
        append_number(chunk.data, number++);
        chunk.data.insert(chunk.data.end(), data.begin(), data.end());
        chunks.push_back(std::move(chunk));
      }
    }
    chunks.push_back({"IEND", {}});
    write_whole(file_, std::span<const std::uint8_t>(png_file(chunks)));
  }

 private:
  struct Frame {
    double seconds = 0.0;
    std::vector<std::vector<std::uint8_t>> data;
  };
  [[nodiscard]] PngChunk control(std::uint32_t number, double seconds) const {
    PngChunk chunk{"fcTL", {}};
    append_number(chunk.data, number);
    chunk.data.insert(chunk.data.end(), header_.data.begin(), header_.data.begin() + 8);
    chunk.data.insert(chunk.data.end(), 8, 0);  // At the left, at the top
    // Hundredths of a second; neither disposed of nor blended.
    const auto hundredths = static_cast<unsigned>(std::lround(100.0 * seconds));
    for (const unsigned value : {hundredths >> 8 & 0xFF, hundredths & 0xFF, 0u, 100u, 0u, 0u}) {
      chunk.data.push_back(static_cast<std::uint8_t>(value));
    }
    return chunk;
  }

  std::filesystem::path file_;
  FilmWords words_;
  PngChunk header_;
  std::vector<Frame> frames_;
  std::vector<std::uint8_t> last_;
};

/// ffmpeg, fed with raw images.
class FfmpegFilm : public Film {
 public:
  FfmpegFilm(std::filesystem::path file, const std::string& format, int width, int height, int fps,
             const FilmWords& words, std::stop_token stop)
      : file_(std::move(file)), fps_(fps), part_(temporary_name(file_)), stop_(std::move(stop)) {
    std::vector<std::string> arguments = {
        "ffmpeg", "-hide_banner", "-loglevel", "error", "-nostdin", "-y", "-f", "rawvideo",
        "-pix_fmt", "rgba", "-s", fmt::format("{}x{}", width, height), "-r",
        fmt::format("{}", fps_), "-i", "pipe:0",
        // Both codecs want an even size.
        "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-pix_fmt", "yuv420p"};
    const std::vector<std::string> codec =
        format == "mp4"
            ? std::vector<std::string>{"-c:v", "libx264", "-preset",   "veryfast",
                                       "-crf", "18",      "-movflags", "+faststart"}
            : std::vector<std::string>{"-c:v", "libvpx-vp9", "-crf", "24",        "-b:v",
                                       "0",    "-deadline",  "good", "-cpu-used", "5"};
    arguments.insert(arguments.end(), codec.begin(), codec.end());
    // The same bytes each time, however many processors there are.
    for (const std::string& more :
         {std::string("-threads"), std::string("2"), std::string("-fflags"),
          std::string("+bitexact"), std::string("-flags:v"), std::string("+bitexact"),
          std::string("-metadata"), "title=" + words.title, std::string("-metadata"),
          "comment=" + words.comment, std::string("-f"), format, part_.string()}) {
      arguments.push_back(more);
    }
    start(arguments);
  }
  ~FfmpegFilm() override {
    if (pipe_ >= 0) ::close(pipe_);
    if (words_ >= 0) ::close(words_);
    if (process_ > 0) {
      ::kill(process_, SIGKILL);  // nobody wants what it has
      ::waitpid(process_, nullptr, 0);
    }
    std::error_code ignored;
    if (!kept_) std::filesystem::remove(part_, ignored);
  }
  FfmpegFilm(const FfmpegFilm&) = delete;
  FfmpegFilm& operator=(const FfmpegFilm&) = delete;

  void add(const Image& image, double seconds) override {
    const int count = std::max(1, static_cast<int>(std::lround(fps_ * seconds)));
    for (int i = 0; i < count && !stop_.stop_requested(); ++i) write(image.pixels);
  }

  void finish() override {
    ::close(std::exchange(pipe_, -1));
    int status = 0;
    ::waitpid(std::exchange(process_, 0), &status, 0);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || !said().empty()) fail();
    std::filesystem::rename(part_, file_);
    kept_ = true;
  }

 private:
  /// The errors that ffmpeg printed. It ends well in spite of some, such as a disk that is full at
  /// the end.
  [[nodiscard]] std::string said() const {
    std::string text(static_cast<std::size_t>(std::max<off_t>(0, ::lseek(words_, 0, SEEK_END))),
                     '\0');
    const ssize_t count = ::pread(words_, text.data(), text.size(), 0);
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, count)));
    return text;
  }
  [[noreturn]] void fail() const {
    throw std::runtime_error(
        fmt::format("cannot write {}: ffmpeg failed: {}", file_.string(), said()));
  }

  void start(std::vector<std::string>& arguments) {
    std::array<int, 2> ends = {};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
      throw std::runtime_error(fmt::format("cannot start ffmpeg: {}", std::strerror(errno)));
    }
    posix_spawn_file_actions_t actions = {};
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    words_ = ::memfd_create("ffmpeg", MFD_CLOEXEC);
    if (words_ >= 0) posix_spawn_file_actions_adddup2(&actions, words_, STDERR_FILENO);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const int error = ::posix_spawnp(&process_, "ffmpeg", &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[0]);
    pipe_ = ends[1];
    if (error == 0) return;
    process_ = 0;
    ::close(std::exchange(pipe_, -1));
    throw std::runtime_error(fmt::format(
        "mp4 and webm need the program ffmpeg, which cannot be started ({}); Debian has "
        "it: apt-get install ffmpeg. gif and apng need nothing",
        std::strerror(error)));
  }

  void write(std::span<const std::uint8_t> bytes) const {
    // When ffmpeg has ended, writing fails and does not end this process.
    const auto before = std::signal(SIGPIPE, SIG_IGN);
    bool failed = false;
    while (!bytes.empty() && !failed) {
      const ssize_t count = ::write(pipe_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      failed = count < 0;
      if (!failed) bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    static_cast<void>(std::signal(SIGPIPE, before));
    if (failed) fail();
  }

  std::filesystem::path file_;
  int fps_;
  std::filesystem::path part_;
  std::stop_token stop_;
  pid_t process_ = 0;
  int pipe_ = -1;
  int words_ = -1;  ///< The file that ffmpeg writes its errors to.
  bool kept_ = false;
};

}  // namespace

std::unique_ptr<Film> gif_film(const std::filesystem::path& file, int width, int height,
                               const Theme& theme, const FilmWords& words) {
  return std::make_unique<GifFilm>(file, width, height, theme, words);
}

std::unique_ptr<Film> apng_film(const std::filesystem::path& file, const FilmWords& words) {
  return std::make_unique<ApngFilm>(file, words);
}

std::unique_ptr<Film> ffmpeg_film(const std::filesystem::path& file, const std::string& format,
                                  int width, int height, int fps, const FilmWords& words,
                                  std::stop_token stop) {
  return std::make_unique<FfmpegFilm>(file, format, width, height, fps, words, std::move(stop));
}

}  // namespace gjkscope
