#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "paint/image.hpp"

namespace gjkscope {

/// The content of a PNG file beside the pixels.
struct PngWords {
  std::vector<std::pair<std::string, std::string>> texts;  ///< Keyword, and text in UTF-8.
  double dpi = 0.0;                                        ///< Pixels an inch; 0: not said.
  bool transparent = false;  ///< The image has an alpha channel, its colours multiplied by it.
};

/// The image as a PNG file (compressed by libdeflate). Same image, same bytes.
[[nodiscard]] std::vector<std::uint8_t> encode_png(Image image, const PngWords& words = {});

/// A chunk of a PNG file.
struct PngChunk {
  std::string type;  ///< "IDAT"
  std::vector<std::uint8_t> data;
};
/// The chunks of a PNG file, up to the first that is cut short; none if the file is not a PNG.
[[nodiscard]] std::vector<PngChunk> png_chunks(std::span<const std::uint8_t> file);
/// A file of chunks.
[[nodiscard]] std::vector<std::uint8_t> png_file(const std::vector<PngChunk>& chunks);
[[nodiscard]] PngChunk png_text(const std::string& keyword, const std::string& text);
/// The text with this keyword in a file; empty when there is none.
[[nodiscard]] std::string text_in_png(std::span<const std::uint8_t> file,
                                      const std::string& keyword);
/// Appends a number as PNG writes it, the high byte first.
void append_number(std::vector<std::uint8_t>& out, std::uint32_t value);

}  // namespace gjkscope
