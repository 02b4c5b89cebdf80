#pragma once
// Frames one after the other, in one file that moves.

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>

#include "paint/image.hpp"
#include "picture/theme.hpp"

namespace gjkscope {

struct FilmWords {
  std::string comment;  ///< A comment in the file for programs, in ASCII.
  std::string title;
};

class Film {
 public:
  virtual ~Film() = default;
  /// All images have the film's size. One that is as the one before is shown longer.
  virtual void add(const Image& image, double seconds) = 0;
  /// The file appears. A film that is not finished leaves none.
  virtual void finish() = 0;
};

/// GIF89a by giflib: of each image the theme's own colours, exactly, and then those that most of
/// its pixels have; no dither; of an image that follows only what changed.
[[nodiscard]] std::unique_ptr<Film> gif_film(const std::filesystem::path& file, int width,
                                             int height, const Theme& theme,
                                             const FilmWords& words);
/// An animated PNG; who does not know it sees the first image.
[[nodiscard]] std::unique_ptr<Film> apng_film(const std::filesystem::path& file,
                                              const FilmWords& words);
/// `format` "mp4" (H.264) or "webm" (VP9), by the program ffmpeg. Throws std::runtime_error saying
/// what to install where it is not. After `stop` it takes no more images, and is not to be
/// finished.
[[nodiscard]] std::unique_ptr<Film> ffmpeg_film(const std::filesystem::path& file,
                                                const std::string& format, int width, int height,
                                                int fps, const FilmWords& words,
                                                std::stop_token stop = {});

}  // namespace gjkscope
