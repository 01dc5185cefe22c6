// tests/tools/mended_lines_test.cpp: lines over every joint, as the tool makes them: what leaves the flesh before and
// after mending.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "app/tools/lay_line.h"
#include "core/check/check.h"
#include "core/rig/validation.h"
#include "sinew/io/gltf_import.h"
#include "tests/support/characters/real_characters.h"

namespace sinew::app {
namespace {

constexpr int kLinesEach = 20;  ///< Of a character.

std::vector<std::shared_ptr<const Character>> characters() {
  std::vector<std::shared_ptr<const Character>> out;
  const std::filesystem::path assets = std::filesystem::path(SINEW_SOURCE_DIR) / "assets";
  for (const char* file : {"humanoid.glb", "horse.glb"}) out.push_back(importGltf(assets / file).value());
  for (const char* file : {"Fox.glb", "greenman.glb", "cesium_man.gltf", "robot.glb"}) {
    if (auto character = test::realCharacter(file)) out.push_back(std::move(character));
  }
  return out;
}

/// Triangles of a bone's skin.
std::vector<int> skinOf(const Character& character, int bone) {
  std::vector<int> out;
  for (int t = 0; t < static_cast<int>(character.mesh.triangles.size()); ++t) {
    if (boneAt(character, {t, glm::vec3(1.0f / 3.0f), 0.0f}) == bone) out.push_back(t);
  }
  return out;
}

/// Findings of a line's own path and belly.
int findings(const Rig& rig, const Motions& motions) {
  return static_cast<int>(std::ranges::count_if(check(rig, motions), [&](const Finding& finding) {
    return !rig.primitives[static_cast<std::size_t>(finding.primitive)].line.empty();
  }));
}

TEST(MendedLines, FewerLeaveTheFleshAndThoseAreNamed) {
  std::mt19937 random(5);
  const auto pick = [&](const std::vector<int>& of) { return of[random() % of.size()]; };
  int lines = 0;
  int before = 0;
  int after = 0;
  int rigid = 0;
  int others = 0;
  for (const auto& character : characters()) {
    const Surface skin = bindSkin(*character);
    const Motions motions(character);
    const auto bones = static_cast<int>(character->skeleton.bones.size());
    int here = 0;
    for (int round = 0; round < 8 && here < kLinesEach; ++round) {
      for (int b = 0; b < bones && here < kLinesEach; ++b) {
        const int parent = character->skeleton.bones[static_cast<std::size_t>(b)].parent;
        if (parent < 0) continue;
        const std::vector<int> above = skinOf(*character, parent);
        const std::vector<int> below = skinOf(*character, b);
        if (above.empty() || below.empty()) continue;
        const auto at = [&](int triangle) { return SkinAnchor{triangle, glm::vec3(1.0f / 3.0f), 0.0f}; };
        const auto laid = layLine(*character, skin, at(pick(above)), at(pick(below)));
        if (!laid) continue;
        ++here;
        before += findings(withLaidLine({}, laid.value(), nullptr).value(), motions) > 0 ? 1 : 0;
        const auto kept = mended(laid.value(), motions);
        ASSERT_TRUE(kept.ok()) << kept.error().text();
        const Result<Rig> rig = withLaidLine({}, kept->laid, nullptr);
        ASSERT_TRUE(rig.ok()) << rig.error().text();
        EXPECT_TRUE(validate(rig.value()));
        rigid += kept->laid.belly.line.empty() ? 1 : 0;
        const int left = findings(rig.value(), motions);
        after += left > 0 ? 1 : 0;
        others += check(rig.value(), motions).empty() || left > 0 ? 0 : 1;
        // What changed is said.
        if (left > 0 || kept->laid.belly.line.empty() || kept->laid.line.via) {
          EXPECT_FALSE(kept->said.empty());
        }
      }
    }
    lines += here;
    std::printf("%s: lines so far %d, found before %d, after %d, on one bone %d, of these found %d\n",
                character->name.c_str(), lines, before, after, rigid, others);
  }
  EXPECT_GE(lines, 2 * kLinesEach) << "of the bundled characters alone";
  EXPECT_GT(before, lines / 20) << "else there is nothing to mend here";
  // Many of these places lie on opposite sides of a limb.
  EXPECT_LT(after, 2 * before / 3);
  EXPECT_LT(rigid, lines / 5);
}

}  // namespace
}  // namespace sinew::app
