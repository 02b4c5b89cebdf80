#include "system_fonts.hpp"

#include <fontconfig/fontconfig.h>

#include <memory>

namespace gjkscope {
namespace {

struct Destroy {
  void operator()(FcCharSet* set) const { FcCharSetDestroy(set); }
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
  void operator()(FcFontSet* fonts) const { FcFontSetDestroy(fonts); }
};
template <class T>
using Owned = std::unique_ptr<T, Destroy>;

}  // namespace

std::vector<SystemFont> system_fonts_for(const std::u32string& characters) {
  std::vector<SystemFont> out;
  if (characters.empty() || FcInit() == FcFalse) return out;
  const Owned<FcCharSet> wanted(FcCharSetCreate());
  for (const char32_t c : characters) FcCharSetAddChar(wanted.get(), c);
  const Owned<FcPattern> pattern(FcPatternCreate());
  FcPatternAddCharSet(pattern.get(), FC_CHARSET, wanted.get());
  FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("sans-serif"));
  FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
  FcPatternAddBool(pattern.get(), FC_COLOR, FcFalse);
  FcConfigSubstitute(nullptr, pattern.get(), FcMatchPattern);
  FcDefaultSubstitute(pattern.get());
  FcResult result = FcResultMatch;
  const Owned<FcFontSet> fonts(FcFontSort(nullptr, pattern.get(), FcTrue, nullptr, &result));
  if (!fonts) return out;
  std::u32string left = characters;
  for (int i = 0; i < fonts->nfont && !left.empty(); ++i) {
    FcPattern* const font = fonts->fonts[i];
    FcChar8* file = nullptr;
    FcCharSet* has = nullptr;
    FcBool is_scalable = FcFalse;
    FcPatternGetBool(font, FC_SCALABLE, 0, &is_scalable);
    if (is_scalable == FcFalse || FcPatternGetString(font, FC_FILE, 0, &file) != FcResultMatch ||
        FcPatternGetCharSet(font, FC_CHARSET, 0, &has) != FcResultMatch)
      continue;
    SystemFont found{reinterpret_cast<const char*>(file), 0, {}};
    FcPatternGetInteger(font, FC_INDEX, 0, &found.index);
    found.index &= 0xFFFF;  // above it stands the instance of a variable font
    std::u32string rest;
    for (const char32_t c : left)
      (FcCharSetHasChar(has, c) == FcTrue ? found.characters : rest) += c;
    if (found.characters.empty()) continue;
    left = std::move(rest);
    out.push_back(std::move(found));
  }
  return out;
}

}  // namespace gjkscope
