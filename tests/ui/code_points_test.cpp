// tests/ui/code_points_test.cpp: UTF-8 decoding and encoding; classes of letters.

#include "app/ui/code_points.h"

#include <gtest/gtest.h>

#include <random>
#include <string_view>

namespace sinew::app {
namespace {

bool isSurrogate(char32_t c) { return c >= 0xD800 && c <= 0xDFFF; }

TEST(CodePoints, EveryCodePointRoundTrips) {
  std::u32string all;
  for (char32_t c = 1; c <= 0x10FFFF; ++c) {
    if (!isSurrogate(c)) all.push_back(c);
  }
  EXPECT_EQ(codePoints(utf8(all)), all);
}

TEST(CodePoints, InvalidUtf8IsReplaced) {
  EXPECT_EQ(codePoints("a\xff\x62"), U"a\uFFFDb");
  EXPECT_EQ(codePoints("\xe8\x85"), U"\uFFFD\uFFFD");          // Truncated.
  EXPECT_EQ(codePoints("\xc0\xaf"), U"\uFFFD\uFFFD");          // Overlong.
  EXPECT_EQ(codePoints("\xed\xa0\x80").size(), 3u);            // A surrogate.
  EXPECT_EQ(codePoints("\xf4\x90\x80\x80").size(), 4u);        // Beyond the last code point.
  EXPECT_EQ(codePoints("\xe5\xb7\xa6\xe8\x85\x95"), U"左腕");  // Well-formed.
}

TEST(CodePoints, ArbitraryBytesGiveWellFormedText) {
  std::mt19937 random(7);
  for (int round = 0; round < 20000; ++round) {
    std::string bytes(std::uniform_int_distribution<std::size_t>(0, 12)(random), '\0');
    for (char& byte : bytes) byte = static_cast<char>(std::uniform_int_distribution<int>(-128, 127)(random));
    const std::u32string once = codePoints(bytes);
    ASSERT_LE(once.size(), bytes.size());
    ASSERT_EQ(codePoints(utf8(once)), once);
  }
}

TEST(CodePoints, ScriptsAndPropertiesAreClassified) {
  for (const char32_t c : std::u32string_view(U"左腕骨盘팔センター（")) {
    EXPECT_TRUE(isWide(c)) << static_cast<unsigned>(c);
  }
  for (const char32_t c : U"Arm éßΩЖאع") EXPECT_FALSE(isWide(c)) << static_cast<unsigned>(c);
  EXPECT_TRUE(isKana(U'タ'));
  EXPECT_FALSE(isKana(U'腕'));
  EXPECT_TRUE(isHangul(U'팔'));
  EXPECT_TRUE(isRightToLeft(U'ع') && isRightToLeft(U'א') && !isRightToLeft(U'a') && !isRightToLeft(U'腕'));
  EXPECT_TRUE(isJoinedForm(0xFECB) && !isJoinedForm(U'ع'));
  EXPECT_TRUE(isInvisible(0x200D) && isInvisible(0x202D) && !isInvisible(U' '));
}

}  // namespace
}  // namespace sinew::app
