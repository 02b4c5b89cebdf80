#include "paint/png.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <new>
#include <utility>

namespace gjkscope {
namespace {

// Level 1 without row filters: a 1280x720 frame takes about 9 ms against 150 ms at a usual level
// with filters, and the flat fills of a frame come out smaller, too.
constexpr int kLevel = 1;

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

/// A pixel of RGBA with its colours as they are before alpha multiplies them.
void put_straight(const std::uint8_t* from, std::uint8_t* to) {
  const unsigned alpha = to[3] = from[3];
  for (int c = 0; c < 3 && alpha != 0 && alpha != 255; ++c) {
    to[c] = static_cast<std::uint8_t>(std::min(255u, (from[c] * 255u + alpha / 2) / alpha));
  }
}

/// Rows as PNG has them: a filter, none, then pixels. Without alpha they take less room than the
/// image's, and take its place.
std::vector<std::uint8_t> rows_of(Image image, int channels) {
  const std::size_t size = (static_cast<std::size_t>(image.width) * channels + 1) * image.height;
  std::vector<std::uint8_t> rows;
  if (channels == 4) rows.resize(size);
  const std::uint8_t* from = image.pixels.data();
  std::uint8_t* to = channels == 4 ? rows.data() : image.pixels.data();
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x, from += 4) {
      // Read before the filter is written over it.
      const std::array<std::uint8_t, 4> pixel = {from[0], from[1], from[2], from[3]};
      if (x == 0) *to++ = 0;
      std::copy_n(pixel.begin(), 3, to);
      if (channels == 4) put_straight(pixel.data(), to);
      to += channels;
    }
  }
  if (channels == 4) return rows;
  image.pixels.resize(size);
  return std::move(image.pixels);
}

/// As zlib has it.
std::vector<std::uint8_t> compressed(const std::vector<std::uint8_t>& bytes) {
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(kLevel), &libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  const std::size_t most = libdeflate_zlib_compress_bound(compressor.get(), bytes.size());
  // Not a vector: its pages would all be touched.
  const std::unique_ptr<std::uint8_t[]> out(new std::uint8_t[most]);
  const std::size_t size =
      libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), out.get(), most);
  return {out.get(), out.get() + size};
}

PngChunk header(const Image& image, int channels) {
  PngChunk chunk{"IHDR", {}};
  append_number(chunk.data, static_cast<std::uint32_t>(image.width));
  append_number(chunk.data, static_cast<std::uint32_t>(image.height));
  // Bits a channel; RGB or RGBA; then the only kinds there are of compression, filters, and no
  // interlacing.
  for (const int byte : {8, channels == 4 ? 6 : 2, 0, 0, 0}) {
    chunk.data.push_back(static_cast<std::uint8_t>(byte));
  }
  return chunk;
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

std::vector<std::uint8_t> encode_png(Image image, const PngWords& words) {
  const int channels = words.transparent ? 4 : 3;
  std::vector<PngChunk> chunks = {header(image, channels)};
  // Right behind the header: who looks for them need not read the pixels.
  if (words.dpi > 0.0) chunks.push_back(resolution(words.dpi));
  for (const auto& [keyword, text] : words.texts) chunks.push_back(png_text(keyword, text));
  chunks.push_back({"IDAT", compressed(rows_of(std::move(image), channels))});
  chunks.push_back({"IEND", {}});
  return png_file(chunks);
}

}  // namespace gjkscope
