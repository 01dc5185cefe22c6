// tests/ui/late_letters_test.cpp: letters that appear in a frame are in the texture by its end.

#include "app/ui/late_letters.h"

#include <imgui.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "app/ui/code_points.h"

namespace sinew::app {
namespace {

/// A window with one text, no OpenGL.
class LateLettersTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf")) GTEST_SKIP() << "no fonts";
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {1280.0f, 800.0f};
    io.DeltaTime = 1.0f / 60.0f;
    fonts = loadFonts(1.0f);
    letters.reserve(1.0f);
    ASSERT_TRUE(io.Fonts->Build());
    letters.attach(fonts);
  }
  void TearDown() override {
    if (ImGui::GetCurrentContext() != nullptr) ImGui::DestroyContext();
  }

  bool frame(const std::string& text, ImFont* font = nullptr) {
    ImGui::NewFrame();
    ImGui::SetNextWindowSize({1200, 780});
    ImGui::Begin("w");
    if (font != nullptr) ImGui::PushFont(font);
    ImGui::PushTextWrapPos(1100);
    ImGui::TextUnformatted(text.c_str());
    width = ImGui::CalcTextSize(text.c_str()).x;
    ImGui::PopTextWrapPos();
    if (font != nullptr) ImGui::PopFont();
    ImGui::End();
    ImGui::Render();
    return letters.fill(*ImGui::GetDrawData(), [&](const glm::ivec4& place, std::span<const std::uint32_t> pixels) {
      ++uploads;
      places.push_back(place);
      EXPECT_EQ(pixels.size(), static_cast<std::size_t>(place.z * place.w));
    });
  }
  /// Every corner of every triangle names a pixel of the texture.
  static void expectAllInTexture() {
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int l = 0; l < data.CmdListsCount; ++l) {
      for (const ImDrawVert& vertex : data.CmdLists[l]->VtxBuffer) {
        ASSERT_TRUE(vertex.uv.x >= 0.0f && vertex.uv.x <= 1.0f && vertex.uv.y >= 0.0f && vertex.uv.y <= 1.0f);
      }
    }
  }

  Fonts fonts;
  LateLetters letters;
  int uploads = 0;
  float width = 0.0f;
  std::vector<glm::ivec4> places;
};

TEST_F(LateLettersTest, NothingIsDoneForLatin) {
  EXPECT_FALSE(frame("Biceps.L \xc3\xa9 \xce\xa9"));
  EXPECT_EQ(uploads, 0);
}

TEST_F(LateLettersTest, ALetterIsDrawnOnceAndFitsTheNextFrame) {
  EXPECT_TRUE(frame("\xd7\x90\xd7\x91\xd7\x90"));  // Hebrew alef, bet, alef.
  EXPECT_EQ(uploads, 2);
  expectAllInTexture();
  EXPECT_FALSE(frame("\xd7\x90\xd7\x91\xd7\x90"));
  EXPECT_EQ(uploads, 2);
  expectAllInTexture();
  EXPECT_TRUE(frame("\xd7\x90", fonts.strong)) << "another font's letter is another";
  EXPECT_EQ(uploads, 3);
}

TEST_F(LateLettersTest, PlacesLieInTheTextureApartFromTheFirstLetters) {
  std::u32string many;
  for (char32_t c = 0x5D0; c <= 0x5EA; ++c) many.push_back(c);
  EXPECT_TRUE(frame(utf8(many)));
  const ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  for (const glm::ivec4& place : places) {
    EXPECT_LE(place.x + place.z, atlas.TexWidth);
    EXPECT_LE(place.y + place.w, atlas.TexHeight);
    for (int y = 0; y < place.w; ++y) {
      for (int x = 0; x < place.z; ++x)
        ASSERT_EQ(atlas.TexPixelsAlpha8[(place.y + y) * atlas.TexWidth + place.x + x], 0);
    }
  }
}

TEST_F(LateLettersTest, WhatNoFontHasIsAQuestionMarkAndAskedForOnce) {
  EXPECT_TRUE(frame("\xe1\x8b\x80"));  // Ethiopic.
  expectAllInTexture();
  EXPECT_EQ(uploads, 0);
  EXPECT_FALSE(frame("\xe1\x8b\x80"));
  const float one = width;
  EXPECT_FALSE(frame("?"));
  EXPECT_EQ(one, width);
}

TEST_F(LateLettersTest, InvisibleOnesTakeNoRoom) {
  EXPECT_FALSE(frame("a\xe2\x80\xad\xe2\x80\x8d\xef\xb8\x8f"));
  const float with = width;
  EXPECT_FALSE(frame("a"));
  EXPECT_EQ(with, width);
}

TEST_F(LateLettersTest, WithoutRoomTheOldOnesMakePlaceAndNotInEveryFrame) {
  if (!letters.has(U'腕')) GTEST_SKIP() << "no fonts-noto-cjk";
  for (int i = 0; i < 70; ++i) EXPECT_FALSE(frame("a"));
  std::u32string first;
  for (char32_t c = 0x4E00; c < 0x4E00 + 800; ++c) first.push_back(c);
  std::u32string second;
  for (char32_t c = 0x5E00; c < 0x5E00 + 800; ++c) second.push_back(c);
  EXPECT_TRUE(frame(utf8(first)));
  expectAllInTexture();
  EXPECT_EQ(letters.revision(), 0u);
  EXPECT_TRUE(frame(utf8(second)));
  EXPECT_EQ(letters.revision(), 1u);
  expectAllInTexture();
  EXPECT_TRUE(frame(utf8(second)));
  EXPECT_FALSE(frame(utf8(second)));
  const int before = uploads;
  for (int i = 0; i < 30; ++i) EXPECT_FALSE(frame(utf8(second)));
  EXPECT_EQ(uploads, before);
  // More at once than there is room for: question marks, and no end of drawing.
  for (int i = 0; i < 8; ++i) (void)frame(utf8(first + second));
  EXPECT_EQ(letters.revision(), 1u);
  expectAllInTexture();
}

TEST_F(LateLettersTest, AnotherRegionDrawsThemAnew) {
  if (!letters.has(U'骨')) GTEST_SKIP() << "no fonts-noto-cjk";
  EXPECT_TRUE(frame("\xe9\xaa\xa8"));
  EXPECT_FALSE(frame("\xe9\xaa\xa8"));
  letters.setRegion(HanRegion::kJapan);
  EXPECT_EQ(letters.revision(), 1u);
  EXPECT_TRUE(frame("\xe9\xaa\xa8"));
  EXPECT_EQ(uploads, 2);
  expectAllInTexture();
}

}  // namespace
}  // namespace sinew::app
