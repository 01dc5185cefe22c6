// tests/ui/name_texture_test.cpp: letters on the screen are in the next font texture.

#include "app/ui/letters.h"

#include <imgui.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "app/ui/code_points.h"
#include "app/ui/reading_order.h"

namespace sinew::app {
namespace {

class LetterTexture : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf")) GTEST_SKIP() << "no fonts";
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    (void)takeShown();
    build();
  }
  void TearDown() override {
    if (ImGui::GetCurrentContext() != nullptr) ImGui::DestroyContext();
  }
  void build() {
    ImGui::GetIO().Fonts->Clear();
    fonts = loadFonts(1.0f);
    texture.build(fonts);
  }
  /// Shows a text in a frame and starts the next. @return whether the texture was rebuilt
  bool show(const std::string& text) {
    (void)inReadingOrder(text);
    texture.want(takeShown());
    if (!texture.outdated()) return false;
    build();
    return true;
  }
  [[nodiscard]] static const ImFontGlyph* glyph(const ImFont* font, char32_t c) {
    return font->FindGlyphNoFallback(static_cast<ImWchar>(c));
  }
  /// Texture contents at a glyph.
  [[nodiscard]] static std::vector<unsigned char> pixels(const ImFontGlyph& of) {
    const ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    const auto width = static_cast<float>(atlas.TexWidth);
    const auto height = static_cast<float>(atlas.TexHeight);
    std::vector<unsigned char> out;
    for (int y = static_cast<int>(of.V0 * height + 0.5f); y < static_cast<int>(of.V1 * height + 0.5f); ++y) {
      for (int x = static_cast<int>(of.U0 * width + 0.5f); x < static_cast<int>(of.U1 * width + 0.5f); ++x)
        out.push_back(atlas.TexPixelsAlpha8[y * atlas.TexWidth + x]);
    }
    return out;
  }

  Fonts fonts;
  NameTexture texture;
};

TEST_F(LetterTexture, LatinAndGreekNeedNoExtraLetters) { EXPECT_FALSE(show("Biceps.L \xc3\xa9 \xce\xa9")); }

TEST_F(LetterTexture, EveryShownLetterIsDrawnOncePerFont) {
  const std::string text = "\xd7\x90\xd7\x91 \xd8\xb9\xd8\xb6\xd9\x84\xd8\xa9";  // Hebrew, and joined Arabic.
  EXPECT_TRUE(show(text));
  EXPECT_FALSE(show(text));
  for (const ImFont* font : {fonts.body, fonts.strong, fonts.mono}) {
    for (const char32_t c : codePoints(inReadingOrder(text))) {
      const ImFontGlyph* const found = glyph(font, c);
      ASSERT_NE(found, nullptr) << static_cast<unsigned>(c);
      if (isInvisible(c) || c == U' ') continue;
      const std::vector<unsigned char> drawn = pixels(*found);
      EXPECT_TRUE(std::ranges::any_of(drawn, [](unsigned char alpha) { return alpha > 128; }));
      LetterFaces faces;
      if (font == fonts.body && c > 0x590) {
        EXPECT_EQ(drawn, faces.draw(c, false, font->FontSize)->coverage);
      }
    }
  }
}

TEST_F(LetterTexture, UnavailableLetterIsSearchedOnce) {
  EXPECT_TRUE(show("\xe1\x8b\x80"));  // Ethiopic.
  EXPECT_EQ(glyph(fonts.body, U'ዀ'), nullptr);
  EXPECT_FALSE(show("\xe1\x8b\x80"));
  EXPECT_FALSE(texture.has(U'ዀ'));
}

TEST_F(LetterTexture, InvisibleLettersHaveNoWidth) {
  EXPECT_FALSE(show("a\xe2\x80\xad\xe2\x80\x8d\xef\xb8\x8f"));
  for (const char32_t c : {0x202D, 0x200D, 0xFE0F}) {
    ASSERT_NE(glyph(fonts.body, c), nullptr);
    EXPECT_EQ(glyph(fonts.body, c)->AdvanceX, 0.0f);
    EXPECT_EQ(glyph(fonts.body, c)->Visible, 0u);
  }
}

TEST_F(LetterTexture, ThousandsOfLettersFitAndOlderOnesAreEvicted) {
  if (!texture.has(U'腕')) GTEST_SKIP() << "no fonts-noto-cjk";
  for (const char32_t from : {0x4E00, 0x5E00, 0x6E00, 0x7E00}) {
    std::u32string many;
    for (char32_t c = from; c < from + 1000; ++c) many.push_back(c);
    EXPECT_TRUE(show(utf8(many)));
    EXPECT_FALSE(show(utf8(many)));
    for (const char32_t c : many) ASSERT_NE(glyph(fonts.body, c), nullptr);
  }
  EXPECT_EQ(glyph(fonts.body, 0x4E00), nullptr) << "forgotten";
  EXPECT_TRUE(show("\xe4\xb8\x80"));
}

TEST_F(LetterTexture, RegionChangeRedrawsLetters) {
  if (!texture.has(U'骨')) GTEST_SKIP() << "no fonts-noto-cjk";
  EXPECT_TRUE(show("\xe9\xaa\xa8"));
  const std::vector<unsigned char> before = pixels(*glyph(fonts.body, U'骨'));
  texture.setRegion(HanRegion::kJapan);
  ASSERT_TRUE(texture.outdated());
  build();
  EXPECT_NE(pixels(*glyph(fonts.body, U'骨')), before);
}

}  // namespace
}  // namespace sinew::app
