#include "paint/png.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <stdexcept>

namespace {

// Level 1 without row filters: a 1280x720 frame takes about 9 ms against 150 ms with the compressor
// of stb_image_write, and the flat fills of a frame come out smaller, too.
constexpr int kLevel = 1;

unsigned char* compress_with_libdeflate(unsigned char* data, int size, int* compressed_size,
                                        int /*quality*/) {
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(kLevel), &libdeflate_free_compressor);
  if (!compressor) return nullptr;
  const auto length = static_cast<std::size_t>(size);
  const std::size_t bound = libdeflate_zlib_compress_bound(compressor.get(), length);
  // stb_image_write frees it.
  auto* out = static_cast<unsigned char*>(std::malloc(bound));
  if (!out) return nullptr;
  *compressed_size =
      static_cast<int>(libdeflate_zlib_compress(compressor.get(), data, length, out, bound));
  return out;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS compress_with_libdeflate
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace gjkscope {
namespace {

constexpr std::array<std::uint8_t, 8> kSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

std::uint32_t number_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::uint32_t>(bytes[at]) << 24 |
         static_cast<std::uint32_t>(bytes[at + 1]) << 16 |
         static_cast<std::uint32_t>(bytes[at + 2]) << 8 | bytes[at + 3];
}

PngChunk resolution(double dpi) {
  constexpr double kInch = 0.0254;  // Metres
  PngChunk chunk{"pHYs", {}};
  const auto per_metre = static_cast<std::uint32_t>(std::lround(dpi / kInch));
  append_number(chunk.data, per_metre);
  append_number(chunk.data, per_metre);
  chunk.data.push_back(1);  // The unit is the metre
  return chunk;
}

/// Colours as they are before alpha multiplies them.
std::vector<std::uint8_t> straight(const Image& image) {
  std::vector<std::uint8_t> out = image.pixels;
  for (std::size_t i = 0; i < out.size(); i += 4) {
    const unsigned alpha = out[i + 3];
    for (std::size_t c = 0; c < 3 && alpha != 0 && alpha != 255; ++c) {
      out[i + c] =
          static_cast<std::uint8_t>(std::min(255u, (out[i + c] * 255u + alpha / 2) / alpha));
    }
  }
  return out;
}

std::vector<std::uint8_t> without_alpha(const Image& image) {
  const std::size_t count = static_cast<std::size_t>(image.width) * image.height;
  std::vector<std::uint8_t> rgb(count * 3);
  for (std::size_t i = 0; i < count; ++i) {
    rgb[3 * i] = image.pixels[4 * i];
    rgb[3 * i + 1] = image.pixels[4 * i + 1];
    rgb[3 * i + 2] = image.pixels[4 * i + 2];
  }
  return rgb;
}

}  // namespace

void append_number(std::vector<std::uint8_t>& out, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

std::vector<PngChunk> png_chunks(std::span<const std::uint8_t> file) {
  std::vector<PngChunk> chunks;
  if (file.size() < kSignature.size() ||
      !std::equal(kSignature.begin(), kSignature.end(), file.begin())) {
    return chunks;
  }
  constexpr std::size_t kAround = 12;  // Length, type and checksum
  for (std::size_t at = kSignature.size(); at + kAround <= file.size();) {
    const std::size_t length = number_at(file, at);
    if (length > file.size() - at - kAround) break;
    const std::span<const std::uint8_t> body = file.subspan(at + 4, 4 + length);
    chunks.push_back({std::string(body.begin(), body.begin() + 4), {body.begin() + 4, body.end()}});
    at += length + kAround;
  }
  return chunks;
}

std::vector<std::uint8_t> png_file(const std::vector<PngChunk>& chunks) {
  std::vector<std::uint8_t> out(kSignature.begin(), kSignature.end());
  for (const PngChunk& chunk : chunks) {
    append_number(out, static_cast<std::uint32_t>(chunk.data.size()));
    const std::size_t begin = out.size();
    out.insert(out.end(), chunk.type.begin(), chunk.type.end());
    out.insert(out.end(), chunk.data.begin(), chunk.data.end());
    append_number(out, libdeflate_crc32(0, out.data() + begin, out.size() - begin));
  }
  return out;
}

PngChunk png_text(const std::string& keyword, const std::string& text) {
  const bool ascii = std::all_of(text.begin(), text.end(),
                                 [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  PngChunk chunk{ascii ? "tEXt" : "iTXt", {keyword.begin(), keyword.end()}};
  // The end of the keyword; then: not compressed, method 0, neither language nor translated
  // keyword.
  chunk.data.insert(chunk.data.end(), ascii ? 1 : 5, 0);
  chunk.data.insert(chunk.data.end(), text.begin(), text.end());
  return chunk;
}

std::string text_in_png(std::span<const std::uint8_t> file, const std::string& keyword) {
  for (const PngChunk& chunk : png_chunks(file)) {
    const std::size_t zeros = chunk.type == "tEXt" ? 1 : 5;
    if (chunk.type != "tEXt" && chunk.type != "iTXt") continue;
    const std::string data(chunk.data.begin(), chunk.data.end());
    if (data.starts_with(keyword + std::string(zeros, '\0')))
      return data.substr(keyword.size() + zeros);
  }
  return {};
}

std::vector<std::uint8_t> encode_png(const Image& image, const PngWords& words) {
  const int channels = words.transparent ? 4 : 3;
  // Before the first frame and once: frames are encoded on several threads.
  static const bool unfiltered = (stbi_write_force_png_filter = 0, true);
  static_cast<void>(unfiltered);

  const std::vector<std::uint8_t> pixels =
      words.transparent ? straight(image) : without_alpha(image);
  int size = 0;
  unsigned char* const bytes = stbi_write_png_to_mem(pixels.data(), image.width * channels,
                                                     image.width, image.height, channels, &size);
  if (!bytes) throw std::runtime_error("out of memory while encoding a PNG");
  std::vector<std::uint8_t> png(bytes, bytes + size);
  std::free(bytes);

  if (words.texts.empty() && words.dpi <= 0.0) return png;
  // Right behind the header: who looks for them need not read the pixels.
  std::vector<PngChunk> more;
  if (words.dpi > 0.0) more.push_back(resolution(words.dpi));
  for (const auto& [keyword, text] : words.texts) more.push_back(png_text(keyword, text));
  const std::vector<std::uint8_t> file = png_file(more);
  constexpr std::ptrdiff_t kHeaderEnd = 33;
  png.insert(png.begin() + kHeaderEnd, file.begin() + kSignature.size(), file.end());
  return png;
}

}  // namespace gjkscope
