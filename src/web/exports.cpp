// What the page's script calls: texts and fonts go in as bytes, texts come out as bytes.

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

}  // namespace

extern "C" {

/// Bytes that the page may write to; `gjk_free` gives them back.
EMSCRIPTEN_KEEPALIVE void* gjk_alloc(std::size_t size) { return std::malloc(size); }
EMSCRIPTEN_KEEPALIVE void gjk_free(void* bytes) { std::free(bytes); }

/// The file of a face, or of what draws the characters that it lacks; before `gjk_start`.
EMSCRIPTEN_KEEPALIVE void gjk_font(int face, int fallback, const unsigned char* bytes,
                                   std::size_t size) {
  FaceBytes& of = fonts[static_cast<std::size_t>(face)];
  (fallback != 0 ? of.fallback : of.main).assign(bytes, bytes + size);
}

/// `themes`: a JSON object of names and texts. False when these or the fonts are not what they
/// should be.
EMSCRIPTEN_KEEPALIVE bool gjk_start(const char* themes, std::size_t size) {
  try {
    player = std::make_unique<Player>(
        std::move(fonts),
        nlohmann::json::parse(themes, themes + size).get<std::map<std::string, std::string>>());
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

/// The answer's length; its bytes are at `gjk_said` until the next call.
EMSCRIPTEN_KEEPALIVE std::size_t gjk_ask(const char* request, std::size_t size) {
  said = player->answer({request, size});
  return said.size();
}
EMSCRIPTEN_KEEPALIVE const char* gjk_said() { return said.data(); }
}
