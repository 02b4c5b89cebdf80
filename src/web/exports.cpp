// The functions that the page's script calls. Texts and fonts go in and texts come out as bytes.

#include <emscripten/emscripten.h>

#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "web/player.hpp"

namespace {

using namespace gjkscope;

std::array<FaceBytes, kFaceCount> fonts;
std::unique_ptr<Player> player;
std::string said;

/// Encodes a character below U+10000.
std::string utf8(char32_t c) {
  const auto tail = [](char32_t bits) { return static_cast<char>(0x80 | (bits & 0x3F)); };
  if (c < 0x80) return {static_cast<char>(c)};
  if (c < 0x800) return {static_cast<char>(0xC0 | (c >> 6)), tail(c)};
  return {static_cast<char>(0xE0 | (c >> 12)), tail(c >> 6), tail(c)};
}

}  // namespace

extern "C" {

/// Bytes that the page may write to; `gjk_free` gives them back.
EMSCRIPTEN_KEEPALIVE void* gjk_alloc(std::size_t size) { return std::malloc(size); }
EMSCRIPTEN_KEEPALIVE void gjk_free(void* bytes) { std::free(bytes); }

/// All characters that the fonts must have, one after the other, at `gjk_said`; their length.
EMSCRIPTEN_KEEPALIVE std::size_t gjk_characters() {
  said.clear();
  for (const char32_t c : Fonts::characters()) said += utf8(c);
  return said.size();
}

/// The file of a face, or of what draws the characters that it lacks; before `gjk_start`.
EMSCRIPTEN_KEEPALIVE void gjk_font(int face, int fallback, const unsigned char* bytes,
                                   std::size_t size) {
  FaceBytes& of = fonts[face];
  (fallback != 0 ? of.fallback : of.main).assign(bytes, bytes + size);
}

/// `assets`: a JSON object of `themes`, texts by name, and `terms`, a text. False when these or the
/// fonts are not what they should be.
EMSCRIPTEN_KEEPALIVE bool gjk_start(const char* assets, std::size_t size) {
  try {
    const nlohmann::ordered_json texts = nlohmann::ordered_json::parse(assets, assets + size);
    player = std::make_unique<Player>(std::move(fonts),
                                      texts.at("themes").get<std::map<std::string, std::string>>(),
                                      texts.at("terms").get<std::string>());
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

/// The answer's length; its bytes are at `gjk_said` until the next call. Before `gjk_start`
/// commands alone are answered.
EMSCRIPTEN_KEEPALIVE std::size_t gjk_ask(const char* request, std::size_t size) {
  said = player ? player->answer({request, size}) : Player::command({request, size});
  return said.size();
}
EMSCRIPTEN_KEEPALIVE const char* gjk_said() { return said.data(); }
}
