// tests/bodies/retarget_inside_test.cpp: bundled rigs on every available character: bellies lie in the flesh of their
// own part, and muscles without a place there are left out and listed.
#include <algorithm>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/bodies/body_frame.h"
#include "core/bodies/body_map.h"
#include "core/bodies/muscle_set.h"
#include "core/bodies/retarget.h"
#include "core/character/bindings.h"
#include "core/files/preset_json.h"
#include "core/geometry/at.h"
#include "core/rig/motion_clip.h"
#include "core/rig/validation.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"
#include "tests/support/characters/characters.h"
#include "tests/support/characters/real_characters.h"
#include "tests/support/surface/winding_number.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

const fs::path kRigAssets = fs::path(SINEW_SOURCE_DIR) / "assets";

struct BodyInside {
  std::shared_ptr<const Character> character;
  MirrorPlan plan;
};

/// As opened by the program; null: not available.
BodyInside bodyOf(const std::string& file) {
  std::shared_ptr<const Character> found;
  if (fs::exists(kRigAssets / file)) found = importGltf(kRigAssets / file).value();
  else found = test::realCharacter(file);
  if (!found) return {};
  MirrorPlan plan = makeMirrorPlan(*found);
  return {withRangeOfMotion(found, plan), plan};
}

glm::dvec3 bindCenter(const Primitive& primitive, const Skeleton& skeleton) {
  const Bone& bone = at(skeleton.bones, skeleton.findBone(primitive.bone).value());
  return glm::dvec3(bone.bindInWorld * glm::vec4(primitive.placement.center, 1.0f));
}

double windingOf(const Primitive& primitive, const Character& character) {
  return test::windingNumber(character.mesh, bindCenter(primitive, character.skeleton));
}

enum class Limb { kNone, kArm, kLeg };

Limb limbOf(Slot slot) {
  const auto isOf = [&](std::initializer_list<Slot> slots) { return std::ranges::find(slots, slot) != slots.end(); };
  if (isOf({Slot::kUpperArm, Slot::kLowerArm, Slot::kHand, Slot::kFrontUpper, Slot::kFrontLower, Slot::kFrontFoot}))
    return Limb::kArm;
  if (isOf({Slot::kUpperLeg, Slot::kLowerLeg, Slot::kFoot, Slot::kToes, Slot::kHindUpper, Slot::kHindLower,
            Slot::kHindFoot}))
    return Limb::kLeg;
  return Limb::kNone;
}

/// The part to which the nearest vertex of the skin belongs.
BodySlot partAround(const glm::dvec3& point, const Character& character, const BodyFrame& frame) {
  const auto distance = [&](const glm::vec3& vertex) { return glm::distance(glm::dvec3(vertex), point); };
  const auto& positions = character.mesh.positions;
  const auto nearest = static_cast<int>(std::ranges::min_element(positions, {}, distance) - positions.begin());
  const Zone zone = at(frame.zoneOfBone, strongestBone(character, nearest));
  return at(allBodySlots(), std::max(zone, 0));
}

struct SourceRig {
  std::string name;
  Rig rig;
  BodyInside body;
};

/// All bundled rigs, and the bundled sets on the characters they were made for.
const std::vector<SourceRig>& sources() {
  static const std::vector<SourceRig> all = [] {
    std::vector<SourceRig> out;
    for (const char* name : {"humanoid", "humanoid-flex", "humanoid-wrapped", "horse", "horse-flex", "horse-wrapped"}) {
      Rig rig = loadRig(kRigAssets / (std::string(name) + ".rig.json")).value();
      BodyInside body = bodyOf(fs::path(rig.character).filename().string());
      out.push_back({name, std::move(rig), std::move(body)});
    }
    for (const auto& [set, file] : {std::pair{"athlete", "humanoid.glb"}, std::pair{"animal", "horse.glb"}}) {
      BodyInside body = bodyOf(file);
      const Preset preset = loadPreset(kRigAssets / "presets" / (std::string(set) + ".json")).value();
      Rig rig = addMuscleSet({}, preset, {}, Motions(body.character), body.plan).value().fitted.rig;
      out.push_back({std::string("set ") + set, std::move(rig), std::move(body)});
    }
    return out;
  }();
  return all;
}

Zone zoneOfBone(const BodyFrame& frame, const Character& character, const std::string& bone) {
  return at(frame.zoneOfBone, character.skeleton.findBone(bone).value());
}

class RetargetOntoBody : public ::testing::TestWithParam<const char*> {};

TEST_P(RetargetOntoBody, EveryBellyLiesInsideItsPart) {
  const BodyInside to = bodyOf(GetParam());
  if (!to.character) SINEW_SKIP_WITHOUT_CHARACTERS();
  const Motions motions(to.character);
  const BodyFrame theirs = makeBodyFrame(*to.character, bodySlots(*to.character, to.plan));
  for (const auto& [name, rig, from] : sources()) {
    SCOPED_TRACE(name);
    const BodyFrame ours = makeBodyFrame(*from.character, bodySlots(*from.character, from.plan));
    const auto done = retarget(rig, *from.character, from.plan, motions, to.plan);
    if (!done) {
      EXPECT_NE(done.error().reason.find("no muscle"), std::string::npos) << done.error().text();
      continue;
    }
    EXPECT_TRUE(validate(done->rig).ok());
    std::set<std::string> named;
    for (const auto& [muscle, why] : done->leftOut) {
      EXPECT_FALSE(why.empty()) << muscle;
      named.insert(muscle);
    }
    for (const Primitive& was : rig.primitives) {
      const int index = findPrimitive(done->rig, was.name);
      EXPECT_EQ(index < 0, named.contains(was.name)) << was.name << " is kept or listed";
      if (index < 0) continue;
      const Primitive& is = at(done->rig.primitives, index);
      EXPECT_GT(windingOf(is, *to.character), 0.5)
          << was.name << " on " << is.bone << " (there " << windingOf(was, *from.character) << ")";
      const Zone before = zoneOfBone(ours, *from.character, was.bone);
      const Zone own = zoneOfBone(theirs, *to.character, is.bone);
      // One bone may have two roles in a limb. A muscle that no line keeps in the flesh rides the bone of the skin
      // above it.
      const int counterpart = before < 0 ? -1 : theirs.slots[at(allBodySlots(), before)].bone;
      const bool rides = std::ranges::any_of(done->mended, [&](const std::string& line) {
        return (line.starts_with(was.name + ':') || line.starts_with(was.mirror + ':')) &&
               line.find("it rides") != std::string::npos;
      });
      if (counterpart < 0 || to.character->skeleton.findBone(is.bone) != counterpart) {
        EXPECT_TRUE(rides || own == before) << was.name << " on " << is.bone;
      }
      if (own < 0 || limbOf(at(allBodySlots(), own).slot) == Limb::kNone) continue;
      const BodySlot part = at(allBodySlots(), own);
      if (before >= 0 && limbOf(at(allBodySlots(), before).slot) != Limb::kNone) {
        EXPECT_EQ(part.side, at(allBodySlots(), before).side) << was.name << " on " << is.bone;
        EXPECT_EQ(limbOf(part.slot), limbOf(at(allBodySlots(), before).slot)) << was.name << " on " << is.bone;
      }
      const BodySlot around = partAround(bindCenter(is, to.character->skeleton), *to.character, theirs);
      if (limbOf(around.slot) == Limb::kNone) continue;
      EXPECT_EQ(limbOf(around.slot), limbOf(part.slot)) << was.name << " lies in another limb";
      EXPECT_EQ(around.side, part.side) << was.name << " lies in the limb of the other side";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, RetargetOntoBody,
                         ::testing::Values("humanoid.glb", "horse.glb", "demo.glb", "tangle.glb", "wrapped.glb",
                                           "man.glb", "woman.glb", "fighter.glb", "cesium_man.gltf", "greenman.glb",
                                           "robot.glb", "RobotExpressive.glb", "Trex.glb", "Fox.glb", "Husky.glb",
                                           "Bull.glb"),
                         [](const auto& body) { return fs::path(body.param).stem().string(); });

}  // namespace
}  // namespace sinew
