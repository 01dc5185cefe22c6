// tests/viewport/tools/mended_lines_test.cpp: lines over every joint as laid by the tool: findings before and after
// mending.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <random>

#include "app/viewport/tools/line_tool.h"
#include "core/bodies/check.h"
#include "core/rig/posed_rig.h"
#include "core/rig/validation.h"
#include "sinew/files/gltf_import.h"
#include "tests/support/characters/real_characters.h"

namespace sinew::app {
namespace {

constexpr int kLinesEach = 15;    ///< For each character.
constexpr float kFlexes = 0.03f;  ///< Change of a belly's length over the motions, fraction of the shortest.

std::vector<std::shared_ptr<const Character>> characters() {
  std::vector<std::shared_ptr<const Character>> out;
  const std::filesystem::path assets = std::filesystem::path(SINEW_SOURCE_DIR) / "assets";
  for (const char* file : {"humanoid.glb", "horse.glb"}) out.push_back(importGltf(assets / file).value());
  for (const char* file :
       {"Fox.glb", "greenman.glb", "cesium_man.gltf", "robot.glb", "Bull.glb", "Husky.glb", "RobotExpressive.glb",
        "Trex.glb", "fighter.glb", "man.glb", "woman.glb", "SimpleSkin.gltf", "rigged_simple.gltf"}) {
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

/// Whether the belly's length changes.
bool flexes(const Rig& rig, const Motions& motions) {
  if (rig.lines.empty()) return false;
  const RigPoser poser(rig, motions.character());
  PosedRig posed;
  float least = std::numeric_limits<float>::max();
  float most = 0.0f;
  for (const Pose& pose : motions.poses()) {
    poser.pose(pose, posed);
    if (!posed.lines[0].usable) continue;
    least = std::min(least, posed.lines[0].bellyStretch);
    most = std::max(most, posed.lines[0].bellyStretch);
  }
  return most > (1.0f + kFlexes) * least;
}

/// Statistics of one character's lines.
struct Count {
  int lines = 0;
  int before = 0;   ///< Lines with a finding as laid.
  int after = 0;    ///< Lines with a finding after mending, also of muscles that ride a bone.
  int rigid = 0;    ///< Muscles that ride a bone.
  int flexed = 0;   ///< Flexing lines as laid.
  int flexing = 0;  ///< Those of them that still flex.

  void add(const Count& other) {
    lines += other.lines;
    before += other.before;
    after += other.after;
    rigid += other.rigid;
    flexed += other.flexed;
    flexing += other.flexing;
  }
  void print(const std::string& name) const {
    std::printf("  %-16s %5d %7d %6d %12d %7d %6d\n", name.c_str(), lines, before, after, rigid, flexed, flexing);
  }
};

Count countOf(const LaidLine& laid, const Motions& motions) {
  Count count{.lines = 1};
  const Rig before = withLaidLine({}, laid, nullptr).value();
  count.before = check(before, motions).empty() ? 0 : 1;
  count.flexed = flexes(before, motions) ? 1 : 0;
  const auto kept = mended(laid, motions);
  if (!kept) ADD_FAILURE() << kept.error().text();
  if (!kept) return count;
  const Rig after = withLaidLine({}, kept->laid, nullptr).value();
  EXPECT_TRUE(validate(after));
  count.after = check(after, motions).empty() ? 0 : 1;
  count.flexing = count.flexed == 1 && flexes(after, motions) ? 1 : 0;
  count.rigid = kept->laid.belly.line.empty() ? 1 : 0;
  const MuscleLine& line = kept->laid.line;
  // Ends may move along their bones, not to other ones.
  EXPECT_EQ(line.origin.bone, laid.line.origin.bone);
  EXPECT_EQ(line.insertion.bone, laid.line.insertion.bone);
  const bool changed = count.rigid == 1 || line.via || line.origin != laid.line.origin ||
                       line.insertion != laid.line.insertion || kept->laid.belly.placement != laid.belly.placement;
  EXPECT_TRUE(!changed || !kept->said.empty());
  return count;
}

TEST(MendedLines, StayInsideTheBodyAndMostlyStillFlex) {
  std::mt19937 random(5);
  const auto pick = [&](const std::vector<int>& of) { return of[random() % of.size()]; };
  Count all;
  std::puts("  character        lines  before  after  on one bone  flexed  still");
  for (const auto& character : characters()) {
    const Surface skin = bindSkin(*character);
    const Motions motions(character);
    const auto bones = static_cast<int>(character->skeleton.bones.size());
    Count here;
    for (int round = 0; round < 8 && here.lines < kLinesEach; ++round) {
      for (int b = 0; b < bones && here.lines < kLinesEach; ++b) {
        const int parent = character->skeleton.bones[static_cast<std::size_t>(b)].parent;
        if (parent < 0) continue;
        const std::vector<int> above = skinOf(*character, parent);
        const std::vector<int> below = skinOf(*character, b);
        if (above.empty() || below.empty()) continue;
        const auto at = [&](int triangle) { return SkinAnchor{triangle, glm::vec3(1.0f / 3.0f), 0.0f}; };
        const auto laid = layLine(*character, skin, at(pick(above)), at(pick(below)));
        if (laid) here.add(countOf(laid.value(), motions));
      }
    }
    here.print(character->name);
    all.add(here);
  }
  all.print("all");
  EXPECT_GE(all.lines, 2 * kLinesEach) << "of the bundled characters alone";
  // Many of these places lie on opposite sides of a limb.
  EXPECT_GT(all.before, all.lines / 3) << "else there is nothing to mend here";
  EXPECT_EQ(all.after, 0);
  EXPECT_GE(5 * all.flexing, 4 * all.flexed);
}

}  // namespace
}  // namespace sinew::app
