// tests/ui/elide_test.cpp: elided names: properties that readers rely on.

#include "app/ui/reading_order.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <set>
#include <vector>

namespace sinew::app {
namespace {

/// Width in a font whose letters differ in width.
float widthOf(std::string_view text) {
  float width = 0.0f;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xC0u) == 0x80u) continue;  // Counted with its first byte.
    width += c == '.' || c == 'i' || c == 'l' ? 3.0f : (c == 'm' || c == 'W' ? 11.0f : 7.0f);
  }
  return width;
}

bool isUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    const std::size_t length = c < 0x80u ? 1 : (c >= 0xF0u ? 4 : (c >= 0xE0u ? 3 : 2));
    if ((c & 0xC0u) == 0x80u || i + length > text.size()) return false;
    for (std::size_t k = 1; k < length; ++k) {
      if ((static_cast<unsigned char>(text[i + k]) & 0xC0u) != 0x80u) return false;
    }
    i += length;
  }
  return true;
}

std::string randomName(std::mt19937& random) {
  static const std::vector<std::string> kParts{"Armature_", "mixamorig:", "Left",         "ForeArm", "_Twist_", "m",
                                               "ill",       "\xc3\xa9",   "\xe9\xaa\xa8", "01",      " ",       "-L"};
  std::string name;
  const int parts = std::uniform_int_distribution<int>(0, 9)(random);
  for (int i = 0; i < parts; ++i)
    name += kParts[std::uniform_int_distribution<std::size_t>(0, kParts.size() - 1)(random)];
  return name;
}

TEST(Elide, ResultFitsAndIsUnchangedIfThereIsRoom) {
  std::mt19937 random(7);
  for (int round = 0; round < 4000; ++round) {
    const std::string name = randomName(random);
    const float room = std::uniform_real_distribution<float>(0.0f, 260.0f)(random);
    const std::string shown = elided(name, room, widthOf);
    ASSERT_TRUE(isUtf8(shown)) << name;
    if (widthOf(name) <= room) {
      ASSERT_EQ(shown, name);
      continue;
    }
    ASSERT_TRUE(widthOf(shown) <= room || shown == "...") << name << " in " << room;
    const std::size_t dots = shown.find("...");
    ASSERT_NE(dots, std::string::npos);
    ASSERT_TRUE(name.starts_with(shown.substr(0, dots))) << shown;
    ASSERT_TRUE(name.ends_with(shown.substr(dots + 3))) << shown;
  }
}

std::vector<std::string_view> viewsOf(const std::vector<std::string>& names) { return {names.begin(), names.end()}; }

void staysDistinct(const std::vector<std::string>& names, float least) {
  const std::vector<std::string_view> views = viewsOf(names);
  const SharedEnds shared = sharedEnds(views);
  for (float room = least; room < 320.0f; room += 3.0f) {
    std::set<std::string> shown;
    for (const std::string& name : names) {
      shown.insert(elided(name, room, widthOf, shared));
      EXPECT_LE(widthOf(elided(name, room, widthOf, shared)), room);
    }
    EXPECT_EQ(shown.size(), names.size()) << room;
  }
}

TEST(Elide, NamesThatDifferAtTheirEndStayDifferent) {
  staysDistinct({"Armature_Character_LeftForeArm_Twist_01", "Armature_Character_LeftForeArm_Twist_02",
                 "Armature_Character_LeftForeArm", "Armature_Character_LeftHand"},
                70.0f);
}

TEST(Elide, NamesThatDifferInTheirMiddleStayDifferent) {
  staysDistinct({"Armature_Character_hips_Twist_01", "Armature_Character_spine_Twist_01",
                 "Armature_Character_thigh.L_Twist_01", "Armature_Character_thigh.R_Twist_01", "Root"},
                70.0f);
}

TEST(Elide, SharedPrefixIsRemovedFirst) {
  const std::vector<std::string> names{"mixamorig:LeftForeArm", "mixamorig:LeftUpLeg", "mixamorig:Spine", "Armature"};
  const std::vector<std::string_view> views = viewsOf(names);
  const SharedEnds shared = sharedEnds(views);
  EXPECT_EQ(shared.prefix, "mixamorig:");
  EXPECT_EQ(elided(names[0], widthOf("...LeftForeArm"), widthOf, shared), "...LeftForeArm");
  EXPECT_EQ(elided(names[0], widthOf(names[0]), widthOf, shared), names[0]);
}

TEST(Elide, StartIsKeptIfThereIsRoom) {
  const std::vector<std::string> names{"neck_Joint_01 muscle L", "neck_Joint_01 muscle R"};
  const std::vector<std::string_view> views = viewsOf(names);
  const SharedEnds shared = sharedEnds(views);
  const std::string shown = elided(names[0], widthOf("neck_Joint_0...L"), widthOf, shared);
  EXPECT_TRUE(shown.starts_with("neck")) << shown;
  EXPECT_TRUE(shown.ends_with("L")) << shown;
}

TEST(Elide, SharedEndsLieAtSeparatorsAndLeaveAName) {
  const auto of = [](std::vector<std::string_view> names) {
    const SharedEnds shared = sharedEnds(names);
    return std::string(shared.prefix) + "|" + std::string(shared.suffix);
  };
  EXPECT_EQ(of({}), "|");
  EXPECT_EQ(of({"a_b"}), "|");
  EXPECT_EQ(of({"thigh.L", "thigh.R"}), "thigh.|");
  EXPECT_EQ(of({"thigh", "thing"}), "|");
  EXPECT_EQ(of({"a_", "a_b"}), "|");
  EXPECT_EQ(of({"a_1_x", "a_2_x", "b"}), "a_|_x");
  EXPECT_EQ(of({"a_1", "b_1", "c_2", "d_2"}), "|") << "half is not most";
  for (const std::string& name : {std::string("m_"), std::string("_m"), std::string("m_m")}) {
    EXPECT_FALSE(elided(name, 1.0f, widthOf, {"m_", "_m"}).empty());
  }
}

}  // namespace
}  // namespace sinew::app
