// app/ui/name_texture.cpp: glyphs in rectangles of their own in ImGui's atlas.

#include "app/ui/name_texture.h"

#include <imgui.h>

#include <algorithm>
#include <vector>

#include "app/ui/code_points.h"

namespace sinew::app {
namespace {

constexpr std::size_t kMostWanted = 9000;  ///< More than that, and those that are not on the screen are forgotten.
constexpr int kAround = 1;                 ///< Pixels kept free: neighbours are blended at the edges of a letter.
constexpr char32_t kFirstLetter = 0xA0;
constexpr char32_t kLastLetter = 0xFFFD;

/// ImGui has 16 bits. Surrogates and private letters mean nothing.
bool mayBeDrawn(char32_t c) { return c >= kFirstLetter && c <= kLastLetter && !(c >= 0xD800 && c <= 0xF8FF); }

struct NameLetter {
  ImFont* font;
  char32_t letter;
  LetterImage image;
  int rectangle;  ///< ImGui's number.
};

void addLetter(const NameLetter& letter) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  const ImFontAtlasCustomRect& place = *atlas.GetCustomRectByIndex(letter.rectangle);
  const glm::ivec2 size = letter.image.size;
  const glm::ivec2 corner(place.X + kAround, place.Y + kAround);
  for (int y = 0; y < size.y; ++y) {
    std::copy_n(letter.image.coverage.begin() + static_cast<std::ptrdiff_t>(y) * size.x, size.x,
                atlas.TexPixelsAlpha8 + static_cast<std::ptrdiff_t>(corner.y + y) * atlas.TexWidth + corner.x);
  }
  const glm::vec2 low = letter.image.offset + glm::ivec2(0, static_cast<int>(letter.font->Ascent + 0.5f));
  const glm::vec2 high = low + glm::vec2(size);
  const glm::vec2 pixel(atlas.TexUvScale.x, atlas.TexUvScale.y);
  const glm::vec2 from = glm::vec2(corner) * pixel;
  const glm::vec2 to = glm::vec2(corner + size) * pixel;
  letter.font->AddGlyph(nullptr, static_cast<ImWchar>(letter.letter), low.x, low.y, high.x, high.y, from.x, from.y,
                        to.x, to.y, letter.image.advance);
}

/// Marks of direction and the like show nothing, whatever the font has for them.
void addInvisible(ImFont& font) {
  for (char32_t c = kFirstLetter; c <= kLastLetter; ++c) {
    if (mayBeDrawn(c) && isInvisible(c)) font.AddGlyph(nullptr, static_cast<ImWchar>(c), 0, 0, 0, 0, 0, 0, 0, 0, 0);
  }
}

}  // namespace

void NameTexture::want(std::u32string_view letters) {
  const ImVector<ImFont*>& fonts = ImGui::GetIO().Fonts->Fonts;
  std::set<std::pair<int, char32_t>> fresh;
  for (const char32_t c : letters) {
    if (!mayBeDrawn(c) || isInvisible(c)) continue;
    for (int font = 0; font < fonts.Size; ++font) {
      if (fonts[font]->FindGlyphNoFallback(static_cast<ImWchar>(c)) == nullptr) fresh.emplace(font, c);
    }
  }
  // Also those that no font has: they are looked for once.
  std::erase_if(fresh, [&](const auto& each) { return wanted_.contains(each); });
  if (fresh.empty()) return;
  outdated_ = true;
  if (wanted_.size() + fresh.size() > kMostWanted) wanted_.clear();
  wanted_.merge(fresh);
}

bool NameTexture::has(char32_t c) { return (c < kFirstLetter || mayBeDrawn(c)) && faces_.has(c); }

void NameTexture::setRegion(HanRegion region) {
  if (region == faces_.region()) return;
  faces_.setRegion(region);
  outdated_ = outdated_ || !wanted_.empty();
}

void NameTexture::build(const Fonts& fonts) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  std::vector<NameLetter> all;
  for (const auto& [number, c] : wanted_) {
    ImFont* const font = atlas.Fonts[number];
    const bool strong = font == fonts.strong && font != fonts.body;
    std::optional<LetterImage> image = faces_.draw(c, strong, atlas.ConfigData[number].SizePixels);
    if (!image) continue;
    const glm::ivec2 size = image->size + 2 * kAround;
    all.push_back({font, c, std::move(*image), atlas.AddCustomRectRegular(size.x, size.y)});
  }
  atlas.Build();
  for (ImFont* font : atlas.Fonts) addInvisible(*font);
  for (const NameLetter& letter : all) addLetter(letter);
  for (ImFont* font : atlas.Fonts) font->BuildLookupTable();
  outdated_ = false;
}

}  // namespace sinew::app
