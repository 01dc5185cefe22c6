// tests/files/vrm_test.cpp: .vrm files of both versions: bone roles, expressions as shapes, tolerated faults.
#include <gtest/gtest.h>

#include "core/bodies/body_map.h"
#include "core/rig/mirror.h"
#include "core/rig/posed_rig.h"
#include "core/rig/rig_edit.h"
#include "sinew/files/gltf_import.h"
#include "tests/support/characters/morphing_post.h"
#include "tests/support/characters/vrm_post.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/temporary_folder.h"

namespace sinew::test {
namespace {

using nlohmann::ordered_json;

class VrmFile : public ::testing::TestWithParam<bool> {
 protected:
  VrmFile() { post_.file.json["extensions"] = GetParam() ? newVrm() : oldVrm(); }
  Result<std::shared_ptr<const Character>> import() { return importGltf(folder_.write("post.vrm", post_.file.glb())); }
  [[nodiscard]] ordered_json& vrm() { return post_.file.json["extensions"][GetParam() ? "VRMC_vrm" : "VRM"]; }

  TemporaryFolder folder_;
  Post post_ = makeMorphingPost(3, 1);
};

TEST_P(VrmFile, BonesHaveSureConfidence) {
  const auto character = import().value();
  const BodySlots slots = bodySlots(*character, makeMirrorPlan(*character));
  const auto boneAt = [&](Slot slot) {
    const SlotBone& bone = slots[{slot, BodySide::kLeft}];
    EXPECT_EQ(bone.confidence, SlotConfidence::kSure);
    return bone.bone < 0 ? std::string() : character->skeleton.bones[static_cast<std::size_t>(bone.bone)].name;
  };
  EXPECT_EQ(boneAt(Slot::kHips), "hip");
  EXPECT_EQ(boneAt(Slot::kUpperLeg), "knee");
  EXPECT_EQ(slots.kind, BodyKind::kHumanoid);
  // The designer's corrections override the file.
  const std::array corrections{SlotCorrection{"hips", "knee"}};
  const BodySlots corrected = bodySlots(*character, makeMirrorPlan(*character), corrections);
  EXPECT_EQ(corrected[{Slot::kHips}].confidence, SlotConfidence::kGiven);
  EXPECT_TRUE(character->ignored.empty()) << character->ignored[0];
}

/// No bone has two roles, whatever the search found.
TEST_P(VrmFile, BoneIsAtMostOnePart) {
  for (const char* as : {"spine", "chest", "upperChest", "neck", "head", "leftHand"}) {
    ordered_json& bones = vrm()["humanoid"]["humanBones"];
    bones = GetParam() ? ordered_json{{as, {{"node", 2}}}} : ordered_json::array({{{"bone", as}, {"node", 2}}});
    const auto character = import().value();
    const BodySlots slots = bodySlots(*character, makeMirrorPlan(*character));
    const int knee = character->skeleton.findBone("knee").value();
    EXPECT_EQ(std::ranges::count(slots.bones, knee, &SlotBone::bone), 1) << as;
  }
}

TEST_P(VrmFile, ExpressionSetsItsTargets) {
  const auto character = import().value();
  EXPECT_EQ(morphNames(*character), (std::vector<std::string>{"happy", morphName(0), morphName(1), morphName(2)}));
  Rig rig;
  rig = setMorphWeight(std::move(rig), "happy", 0.8f).value();
  rig = setMorphWeight(std::move(rig), morphName(2), 0.1f).value();
  const std::vector<float> weights = RigPoser(rig, *character).pose(bindPose(character->skeleton)).morphWeights;
  EXPECT_FLOAT_EQ(weights[0], 0.4f);
  EXPECT_FLOAT_EQ(weights[1], 0.0f);
  EXPECT_FLOAT_EQ(weights[2], 0.9f);
}

TEST_P(VrmFile, ExpressionNamedLikeATargetIsDisambiguated) {
  post_.file.json["meshes"][0]["extras"]["targetNames"][1] = "happy";
  const auto character = import().value();
  EXPECT_EQ(morphNames(*character).front(), "happy (expression)");
}

/// Whatever the extension contains, the character opens, and only existing objects are referenced.
TEST_P(VrmFile, FaultyExtensionsAreSafe) {
  const ordered_json sound = post_.file.json["extensions"];
  const std::vector<ordered_json> odd{nullptr,
                                      -1,
                                      1e300,
                                      4000000000U,
                                      0.5,
                                      "text",
                                      ordered_json::array({1}),
                                      ordered_json::object(),
                                      ordered_json::array({nullptr, {{"node", 99}}})};
  Random random(GetParam() ? 1 : 2);
  for (int i = 0; i < 300; ++i) {
    post_.file.json["extensions"] = sound;
    ordered_json flat = vrm().flatten();
    const int spoilt = 1 + random.below(3);
    for (int k = 0; k < spoilt; ++k) {
      auto item = flat.begin();
      std::advance(item, random.below(static_cast<int>(flat.size())));
      // Any part of the path: the value itself or one that contains it.
      std::string path = item.key();
      for (int up = random.below(4); up > 0 && path.rfind('/') > 0; --up) path.erase(path.rfind('/'));
      ordered_json& at = vrm();
      const ordered_json::json_pointer pointer(path);
      if (at.contains(pointer)) at[pointer] = odd[static_cast<std::size_t>(random.below(static_cast<int>(odd.size())))];
    }
    const auto imported = import();
    ASSERT_TRUE(imported.ok()) << imported.error().text() << post_.file.json["extensions"];
    for (const BodyPart& part : imported.value()->bodyParts) {
      EXPECT_TRUE(bodySlotNamed(part.slot));
      EXPECT_LT(static_cast<std::size_t>(part.bone), imported.value()->skeleton.bones.size());
    }
    for (const MorphSet& set : imported.value()->morphSets) {
      for (const MorphSet::Share& each : set.shares) {
        EXPECT_LT(static_cast<std::size_t>(each.target), imported.value()->morphTargets.size());
        EXPECT_TRUE(std::isfinite(each.share));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Versions, VrmFile, ::testing::Values(true, false));

}  // namespace
}  // namespace sinew::test
