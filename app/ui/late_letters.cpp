// app/ui/late_letters.cpp: glyphs that are found in the triangles of a frame.

#include "app/ui/late_letters.h"

#include <imgui.h>

#include <algorithm>

#include "app/ui/code_points.h"

namespace sinew::app {
namespace {

/// Texture coordinates from here on are a code point and the number of a font.
constexpr float kOutsideTexture = 4.0f;

constexpr int kAtlasWidth = 1024;      ///< Width of the texture at scale 1, beyond that twice as much.
constexpr int kAreaMargin = 64;        ///< Less than that is kept free.
constexpr float kAreaHeight = 256.0f;  ///< At scale 1: about a thousand Chinese letters.
constexpr float kMostAreaHeight = 2048.0f;
constexpr long long kFramesBetween = 60;  ///< Frames between two times that all is forgotten.
constexpr char32_t kLastLetter = 0xFFFD;

/// ImGui has 16 bits. Surrogates and private letters mean nothing.
bool mayBeDrawn(char32_t c) { return c >= 0xA0 && c <= kLastLetter && !(c >= 0xD800 && c <= 0xF8FF); }

ImFontGlyph& glyphOf(ImFont& font, char32_t c) { return font.Glyphs[font.IndexLookup[static_cast<int>(c)]]; }

void setAdvance(ImFont& font, char32_t c, float advance) {
  glyphOf(font, c).AdvanceX = advance;
  font.IndexAdvanceX[static_cast<int>(c)] = advance;
}

/// A square of one pixel at the pen, whose coordinates name the letter.
ImFontGlyph placeholder(const ImFont& font, std::size_t number, char32_t c) {
  ImFontGlyph glyph{};
  glyph.Codepoint = c & 0x3FFFFFFFu;
  glyph.Visible = isInvisible(c) ? 0u : 1u;
  glyph.X1 = glyph.Y1 = 1.0f;
  glyph.U0 = glyph.U1 = kOutsideTexture + static_cast<float>(c);
  glyph.V0 = glyph.V1 = kOutsideTexture + static_cast<float>(number);
  const bool wide = isWide(c) || (isKana(c) && c < 0xFF00);
  glyph.AdvanceX = isInvisible(c) ? 0.0f : wide ? static_cast<float>(wideEm(font.FontSize)) : font.FallbackAdvanceX;
  return glyph;
}

void placeLetter(std::span<ImDrawVert, 4> quad, const ImFontGlyph& glyph) {
  const ImVec2 pen = quad[0].pos;
  const float height = quad[2].pos.y - pen.y;
  const float scale = height > 0.0f ? height : 1.0f;
  const ImVec2 low{pen.x + glyph.X0 * scale, pen.y + glyph.Y0 * scale};
  const ImVec2 high{pen.x + glyph.X1 * scale, pen.y + glyph.Y1 * scale};
  quad[0].pos = low;
  quad[1].pos = {high.x, low.y};
  quad[2].pos = high;
  quad[3].pos = {low.x, high.y};
  quad[0].uv = {glyph.U0, glyph.V0};
  quad[1].uv = {glyph.U1, glyph.V0};
  quad[2].uv = {glyph.U1, glyph.V1};
  quad[3].uv = {glyph.U0, glyph.V1};
}

void hideLetter(std::span<ImDrawVert, 4> quad) {
  const ImVec2 white = ImGui::GetIO().Fonts->TexUvWhitePixel;
  for (ImDrawVert& corner : quad) {
    corner.pos = quad[0].pos;
    corner.uv = white;
  }
}

}  // namespace

void LateLetters::reserve(float scale) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  const int times = scale > 1.0f ? 2 : 1;
  const float height = kAreaHeight * std::max(scale * scale, 1.0f) / static_cast<float>(times);
  const glm::ivec2 size(times * kAtlasWidth - kAreaMargin, static_cast<int>(std::min(height, kMostAreaHeight)));
  atlas.TexDesiredWidth = times * kAtlasWidth;
  area_ = atlas.AddCustomRectRegular(size.x, size.y);
  sheet_ = GlyphSheet(size);
  loaded_.clear();
}

void LateLetters::attach(const Fonts& fonts) {
  const ImFontAtlasCustomRect& area = *ImGui::GetIO().Fonts->GetCustomRectByIndex(area_);
  corner_ = {area.X, area.Y};
  fonts_ = fonts;
  each_.clear();
  for (ImFont* font : {fonts.body, fonts.strong, fonts.mono}) {
    if (std::ranges::find(each_, font) == each_.end()) each_.push_back(font);
  }
  for (std::size_t number = 0; number < each_.size(); ++number) {
    ImFont& font = *each_[number];
    for (char32_t c = 0xA0; c <= kLastLetter; ++c) {
      const bool known = font.FindGlyphNoFallback(static_cast<ImWchar>(c)) != nullptr;
      if (mayBeDrawn(c) && !known) font.Glyphs.push_back(placeholder(font, number, c));
      else if (known && isInvisible(c)) glyphOf(font, c) = placeholder(font, number, c);
    }
    font.BuildLookupTable();
  }
}

bool LateLetters::has(char32_t c) { return (c < 0xA0 || mayBeDrawn(c)) && faces_.has(c); }

void LateLetters::setRegion(HanRegion region) {
  if (region == faces_.region()) return;
  faces_.setRegion(region);
  forget();
}

void LateLetters::forget() {
  for (const Slot& slot : loaded_) {
    const auto number = static_cast<std::size_t>(std::ranges::find(each_, slot.font) - each_.begin());
    ImFontGlyph& glyph = glyphOf(*slot.font, slot.letter);
    const float advance = glyph.AdvanceX;
    glyph = placeholder(*slot.font, number, slot.letter);
    glyph.AdvanceX = advance;  // Nothing moves when it comes back.
  }
  loaded_.clear();
  sheet_.clear();
  forgotAt_ = frame_;
  ++revision_;
}

bool LateLetters::load(const Slot& slot, const Upload& upload) {
  ImFont& font = *slot.font;
  ImFontGlyph& glyph = glyphOf(font, slot.letter);
  const unsigned codePoint = glyph.Codepoint;
  const std::optional<LetterImage> image = faces_.draw(slot.letter, isStrong(&font), font.FontSize);
  if (!image) {
    glyph = *font.FallbackGlyph;
  } else {
    const std::optional<glm::ivec2> place = sheet_.place(image->size);
    if (!place) return false;
    const glm::vec2 low = image->offset + glm::ivec2(0, static_cast<int>(font.Ascent + 0.5f));
    const glm::vec2 high = low + glm::vec2(image->size);
    const ImVec2 pixel = ImGui::GetIO().Fonts->TexUvScale;
    const glm::vec2 at(corner_ + *place);
    const glm::vec2 end = at + glm::vec2(image->size);
    glyph.X0 = low.x;
    glyph.Y0 = low.y;
    glyph.X1 = high.x;
    glyph.Y1 = high.y;
    glyph.U0 = at.x * pixel.x;
    glyph.V0 = at.y * pixel.y;
    glyph.U1 = end.x * pixel.x;
    glyph.V1 = end.y * pixel.y;
    glyph.Visible = image->coverage.empty() ? 0u : 1u;
    glyph.AdvanceX = image->advance;
    std::vector<std::uint32_t> pixels;
    for (const std::uint8_t alpha : image->coverage) pixels.push_back(IM_COL32(255, 255, 255, alpha));
    if (!pixels.empty()) upload({corner_ + *place, image->size}, pixels);
  }
  glyph.Codepoint = codePoint & 0x3FFFFFFFu;
  setAdvance(font, slot.letter, glyph.AdvanceX);
  loaded_.push_back(slot);
  return true;
}

bool LateLetters::fillQuad(std::span<ImDrawVert, 4> quad, const Upload& upload) {
  const auto letter = static_cast<char32_t>(quad[0].uv.x - kOutsideTexture);
  ImFont& font = *each_[std::min(static_cast<std::size_t>(quad[0].uv.y - kOutsideTexture), each_.size() - 1)];
  const bool forgetting = forgotAt_ == frame_;  // The other letters of this frame still need their places.
  const bool isNew = glyphOf(font, letter).U0 >= kOutsideTexture;
  if (isNew && !forgetting && !load({&font, letter}, upload)) {
    if (frame_ - forgotAt_ < kFramesBetween) {  // More letters at once than there are places.
      placeLetter(quad, *font.FallbackGlyph);
      return false;
    }
    forget();
  }
  const ImFontGlyph& glyph = glyphOf(font, letter);
  if (glyph.U0 >= kOutsideTexture || glyph.Visible == 0) hideLetter(quad);
  else placeLetter(quad, glyph);
  return true;
}

bool LateLetters::fill(ImDrawData& data, const Upload& upload) {
  ++frame_;
  bool again = false;
  for (int l = 0; l < data.CmdListsCount; ++l) {
    ImVector<ImDrawVert>& vertices = data.CmdLists[l]->VtxBuffer;
    for (int i = 0; i + 3 < vertices.Size;) {
      const bool late = vertices[i].uv.x >= kOutsideTexture;
      if (late) again = fillQuad(std::span<ImDrawVert, 4>(&vertices[i], 4), upload) || again;
      i += late ? 4 : 1;
    }
  }
  return again;
}

}  // namespace sinew::app
