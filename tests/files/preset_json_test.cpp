// tests/files/preset_json_test.cpp: valid and invalid muscle set files.
#include "core/files/preset_json.h"

#include <filesystem>

#include <gtest/gtest.h>

namespace sinew {
namespace {

const std::string kSmall =
    R"({"format": "sinew-preset", "version": 1, "title": "Small", "body": "humanoid", "muscles": [
  {"name": "biceps", "group": "arm", "belly": ["upperArm", 0.5, -5], "origin": ["upperArm", 0.1, 0],
   "insertion": ["lowerArm", 0.06, 0, 0.75], "tendons": [0.2, 0.1]},
  {"name": "pectoral", "group": "chest", "belly": ["trunk", 0.7, 26], "half_length": 0.12, "width": 1.8}]})";

TEST(PresetJson, ReadsMarksLinesAndDefaults) {
  const auto preset = presetFromJson(kSmall);
  ASSERT_TRUE(preset.ok()) << preset.error().text();
  EXPECT_EQ(preset->title, "Small");
  ASSERT_EQ(preset->muscles.size(), 2u);
  const PresetMuscle& biceps = preset->muscles[0];
  EXPECT_EQ(biceps.belly.slot, Slot::kUpperArm);
  EXPECT_EQ(biceps.belly.angle, -5.0f);
  ASSERT_TRUE(biceps.insertion.has_value());
  EXPECT_EQ(biceps.insertion->depth, 0.75f);
  EXPECT_EQ(biceps.line.tendons, glm::vec2(0.2f, 0.1f));
  EXPECT_EQ(preset->muscles[1].belly.slot, Slot::kSpine);
  EXPECT_EQ(preset->muscles[1].halfLength, 0.12f);
  EXPECT_EQ(preset->grooves, kNewGrooves);
}

TEST(PresetJson, WidthsRoundTrip) {
  Preset preset = presetFromJson(kSmall).value();
  preset.skinBlend = 0.03f;
  preset.grooves = 0.0f;
  const auto again = presetFromJson(presetToJson(preset));
  ASSERT_TRUE(again.ok()) << again.error().text();
  EXPECT_EQ(again->skinBlend, 0.03f);
  EXPECT_EQ(again->grooves, 0.0f);
}

TEST(PresetJson, BundledPresetsAreValid) {
  const auto folder = std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "presets";
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto preset = loadPreset(entry.path());
    EXPECT_TRUE(preset.ok()) << preset.error().text();
    ++count;
  }
  EXPECT_EQ(count, 3);
}

struct BadPreset {
  std::string from;
  std::string to;
  std::string place;
};

TEST(PresetJson, RefusalsNameThePlaceOnOneLine) {
  const std::vector<BadPreset> bad{{"sinew-preset", "other", "format"},
                                   {"\"version\": 1", "\"version\": 2", "version"},
                                   {"humanoid", "fish", "body"},
                                   {"\"muscles\"", "\"grooves\": 1.5, \"muscles\"", "grooves"},
                                   {"\"upperArm\", 0.5", "\"wing\", 0.5", "muscles[0].belly[0]"},
                                   {"0.5, -5", "7, -5", "muscles[0].belly[1]"},
                                   {", 0.75]", ", 2]", "muscles[0].insertion[3]"},
                                   {"[0.2, 0.1]", "[0.7, 0.7]", "muscles[0].tendons"},
                                   {"\"origin\": [\"upperArm\", 0.1, 0],", "", "muscles[0]"},
                                   {"\"half_length\": 0.12, ", "", "muscles[1].half_length"},
                                   {"\"width\": 1.8", "\"width\": 0", "muscles[1].width"},
                                   {"[\"trunk\", 0.7, 26]", "3", "muscles[1].belly"}};
  for (const auto& [from, to, place] : bad) {
    std::string text = kSmall;
    text.replace(text.find(from), from.size(), to);
    const auto preset = presetFromJson(text);
    ASSERT_FALSE(preset.ok()) << place;
    EXPECT_EQ(preset.error().place, place);
    EXPECT_EQ(preset.error().text().find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace sinew
