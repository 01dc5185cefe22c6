// tests/document/muscle_names_test.cpp: a muscle is named after its bone until it is renamed.

#include "app/document/shown_names.h"

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sinew/rig/rig_edit.h"

namespace sinew::app {
namespace {

/// Bones with these names at the origin; the first is the parent of all.
Skeleton skeletonOf(const std::vector<std::string>& names) {
  Skeleton skeleton;
  for (std::size_t i = 0; i < names.size(); ++i) {
    skeleton.nodes.emplace_back();
    skeleton.nodes.back().name = names[i];
    Bone bone;
    bone.name = names[i];
    bone.path = names[i];
    bone.node = static_cast<int>(i);
    bone.parent = i == 0 ? -1 : 0;
    skeleton.bones.push_back(bone);
  }
  return skeleton;
}

const Skeleton kLimbs = skeletonOf({"spine", "arm.L", "arm.R", "leg.L", "leg.R"});

Rig rigOf(const std::vector<std::array<std::string, 2>>& muscles) {
  Rig rig;
  for (const auto& [name, bone] : muscles) {
    Primitive primitive;
    primitive.name = name;
    primitive.bone = bone;
    rig = addPrimitive(std::move(rig), primitive).value();
  }
  return rig;
}

/// Names after the first muscle moved to `bone`.
std::vector<std::string> namesAfter(const Rig& before, const std::string& bone) {
  Rig after = before;
  after.primitives.front().bone = bone;
  std::vector<std::string> names;
  for (const Primitive& primitive : withDefaultNames(before, after, kLimbs).primitives) names.push_back(primitive.name);
  return names;
}

using Names = std::vector<std::string>;

TEST(DefaultNames, FollowTheBone) {
  EXPECT_EQ(namesAfter(rigOf({{"arm.L muscle", "arm.L"}}), "leg.L"), Names{"leg.L muscle"});
  EXPECT_EQ(namesAfter(rigOf({{"arm.L muscle 3", "arm.L"}}), "leg.L"), Names{"leg.L muscle"});
  EXPECT_EQ(namesAfter(rigOf({{"arm.L muscle", "arm.L"}, {"leg.L muscle", "leg.L"}}), "leg.L"),
            (Names{"leg.L muscle 2", "leg.L muscle"}));
  EXPECT_EQ(namesAfter(rigOf({{"arm.L muscle", "arm.L"}, {"arm.L muscle 2", "arm.L"}}), "leg.L"),
            (Names{"leg.L muscle", "arm.L muscle 2"}))
      << "the one that stays keeps its name";
}

TEST(DefaultNames, TypedNamesAreKept) {
  for (const char* typed : {"biceps", "arm.L muscles", "arm.L muscle x", "arm.L muscle 2b", "leg.L muscle", "muscle"}) {
    EXPECT_EQ(namesAfter(rigOf({{typed, "arm.L"}}), "leg.L"), Names{typed});
  }
  EXPECT_EQ(namesAfter(rigOf({{"arm.L muscle", "gone"}}), "leg.L"), Names{"arm.L muscle"});
  EXPECT_EQ(namesAfter(rigOf({{"arm.L muscle", "arm.L"}}), "arm.L"), Names{"arm.L muscle"}) << "it has not moved";
}

TEST(DefaultNames, TwinsAreNamedTogether) {
  const Rig pair = setMirror(rigOf({{"arm.L muscle", "arm.L"}, {"arm.R muscle", "arm.R"}}), 0, 1);
  EXPECT_EQ(namesAfter(pair, "leg.L"), (Names{"leg.L muscle", "leg.R muscle"}));
  EXPECT_EQ(namesAfter(pair, "spine"), (Names{"spine muscle L", "spine muscle R"}));
  const Rig back = setMirror(rigOf({{"spine muscle L", "spine"}, {"spine muscle R", "spine"}}), 0, 1);
  EXPECT_EQ(namesAfter(back, "arm.L"), (Names{"arm.L muscle", "arm.R muscle"}));
  const Rig renamed = setMirror(rigOf({{"arm.L muscle", "arm.L"}, {"biceps", "arm.R"}}), 0, 1);
  EXPECT_EQ(namesAfter(renamed, "leg.L"), (Names{"leg.L muscle", "biceps"}));
}

TEST(DefaultNames, TwinLinksFollowTheNewNames) {
  const Rig pair = setMirror(rigOf({{"arm.L muscle", "arm.L"}, {"arm.R muscle", "arm.R"}}), 0, 1);
  Rig moved = pair;
  moved.primitives[0].bone = "leg.L";
  const Rig named = withDefaultNames(pair, moved, kLimbs);
  EXPECT_EQ(named.primitives[0].mirror, "leg.R muscle");
  EXPECT_EQ(named.primitives[1].mirror, "leg.L muscle");
}

}  // namespace
}  // namespace sinew::app
