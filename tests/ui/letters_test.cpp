// tests/ui/letters_test.cpp: which font has a letter, and how it is drawn.

#include <gtest/gtest.h>

#include <filesystem>
#include <string_view>

#include "app/ui/letters.h"

namespace sinew::app {
namespace {

constexpr const char* kNoto = "/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc";
constexpr const char* kDejaVu = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

TEST(LetterFonts, RegionFollowsTheNamesOrElseTheLocale) {
  EXPECT_EQ(hanRegion(U"左腕 センター", "zh_CN.UTF-8"), HanRegion::kJapan);
  EXPECT_EQ(hanRegion(U"왼팔 左腕", "ja_JP.UTF-8"), HanRegion::kKorea);
  EXPECT_EQ(hanRegion(U"左臂", "ja_JP.UTF-8"), HanRegion::kJapan);
  EXPECT_EQ(hanRegion(U"左臂", "zh_TW.UTF-8"), HanRegion::kTaiwan);
  EXPECT_EQ(hanRegion(U"左臂", "zh_HK"), HanRegion::kHongKong);
  EXPECT_EQ(hanRegion(U"左臂", "zh_CN.UTF-8"), HanRegion::kMainland);
  EXPECT_EQ(hanRegion(U"", "C"), HanRegion::kMainland);
}

TEST(LetterFonts, FontFollowsTheRegion) {
  EXPECT_EQ(fontFilesFor(U'骨', false, HanRegion::kJapan).front(), (FontFile{kNoto, 0}));
  EXPECT_EQ(fontFilesFor(U'骨', false, HanRegion::kMainland).front(), (FontFile{kNoto, 2}));
  EXPECT_EQ(fontFilesFor(U'骨', false, HanRegion::kHongKong).front(), (FontFile{kNoto, 4}));
  const std::vector<FontFile> strong = fontFilesFor(U'骨', true, HanRegion::kKorea);
  EXPECT_NE(strong[0].file.find("Bold"), std::string_view::npos);
  EXPECT_EQ(strong[1], (FontFile{kNoto, 1})) << "where there is no bold one";
  EXPECT_NE(fontFilesFor(U'ع', false, HanRegion::kJapan).front().file, kNoto);
}

TEST(LetterFaces, RequiredFontPackageCoversItsScripts) {
  if (!std::filesystem::exists(kDejaVu)) GTEST_SKIP() << "no fonts-dejavu-core";
  LetterFaces faces;
  for (const char32_t c : std::u32string_view(U"عﻋאΩЖԱა")) {
    EXPECT_TRUE(faces.has(c)) << static_cast<unsigned>(c);
  }
  EXPECT_FALSE(faces.has(0x12000)) << "cuneiform";
  const std::optional<LetterImage> image = faces.draw(U'ع', false, 15.0f);
  ASSERT_TRUE(image);
  EXPECT_GT(image->size.x, 3);
  EXPECT_EQ(image->coverage.size(), static_cast<std::size_t>(image->size.x * image->size.y));
  EXPECT_FALSE(faces.draw(0x12000, false, 15.0f));
}

TEST(LetterFaces, WideLettersFillTheirSquareAndFitTheLine) {
  if (!std::filesystem::exists(kNoto)) GTEST_SKIP() << "no fonts-noto-cjk";
  LetterFaces faces;
  for (const HanRegion region : {HanRegion::kJapan, HanRegion::kMainland}) {
    faces.setRegion(region);
    for (const float height : {15.0f, 30.0f}) {
      for (const char32_t c : std::u32string_view(U"腕骨センター팔盘")) {
        const std::optional<LetterImage> image = faces.draw(c, false, height);
        ASSERT_TRUE(image) << static_cast<unsigned>(c);
        EXPECT_NEAR(image->advance, static_cast<float>(wideEm(height)), 0.11f * height) << static_cast<unsigned>(c);
        EXPECT_GE(image->offset.y, -static_cast<int>(0.9f * height));  // Inter's ascent is 0.8 of the line.
        EXPECT_LE(image->offset.y + image->size.y, static_cast<int>(0.2f * height));
      }
    }
  }
}

}  // namespace
}  // namespace sinew::app
