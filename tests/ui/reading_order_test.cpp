// tests/ui/reading_order_test.cpp: display order and joining of Hebrew and Arabic.

#include "app/ui/reading_order.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/ui/code_points.h"

namespace sinew::app {
namespace {

/// Result without the directional marks.
std::u32string drawn(std::u32string_view text) {
  std::u32string out = codePoints(inReadingOrder(utf8(text)));
  std::erase_if(out, isInvisible);
  return out;
}

TEST(ReadingOrder, OtherScriptsAreUnchanged) {
  for (const char* text : {"", "Arm.L", "左腕 センター", "왼팔", "Ωμος Рука é", "\xff\xd7"}) {
    EXPECT_EQ(inReadingOrder(text), text);
  }
}

TEST(ReadingOrder, HebrewIsReversed) {
  EXPECT_EQ(drawn(U"זרוע"), U"עורז");
  EXPECT_EQ(drawn(U"זרוע.L"), U"עורז.L") << "the line goes from left to right";
  EXPECT_EQ(drawn(U"Bone זרוע 12"), U"Bone 12 עורז") << "numbers keep their order";
  EXPECT_EQ(drawn(U"(זרוע)"), U"(עורז)");
}

TEST(ReadingOrder, ArabicLettersAreJoined) {
  // THAL and REH do not join to the left, so that AIN beside ALEF stands alone (ذراع).
  EXPECT_EQ(drawn(U"ذراع"), U"\uFEC9\uFE8D\uFEAD\uFEAB");
  // SEEN-ALEF-QAF (ساق): initial, final, isolated.
  EXPECT_EQ(drawn(U"ساق"), U"\uFED5\uFE8E\uFEB3");
  // YEH-DAL (يد), KAF-TEH-FEH (كتف): initial, medial, final.
  EXPECT_EQ(drawn(U"كتف"), U"\uFED2\uFE98\uFEDB");
  // LAM-ALEF is one ligature.
  EXPECT_EQ(drawn(U"لا").size(), 1u);
}

TEST(ReadingOrder, LineBreaksAreKept) { EXPECT_EQ(drawn(U"אב\nA\nגד\n"), U"בא\nA\nדג\n"); }

TEST(ReadingOrder, IsIdempotent) {
  for (const char* text : {"زراع", "زراع.L", "Bone זרוע 12", "אב\nגד", "ساق יד"}) {
    const std::string once = inReadingOrder(text);
    EXPECT_NE(once, text);
    EXPECT_EQ(inReadingOrder(once), once);
  }
}

}  // namespace
}  // namespace sinew::app
