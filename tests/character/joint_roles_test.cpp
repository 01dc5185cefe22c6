// tests/character/joint_roles_test.cpp: joint roles inferred from names.

#include "core/character/joint_roles.h"

#include <string>

#include <gtest/gtest.h>

namespace sinew {
namespace {

/// Role of a joint under the root.
JointRole roleOf(const std::string& name) {
  Skeleton skeleton;
  skeleton.bones.resize(3);
  skeleton.bones[0].name = "body";
  skeleton.bones[0].children = {1};
  skeleton.bones[1].name = name;
  skeleton.bones[1].parent = 0;
  skeleton.bones[1].children = {2};
  skeleton.bones[2].name = "next";
  skeleton.bones[2].parent = 1;
  return jointRoles(skeleton)[1];
}

// A hip with a side starts a leg; one without a side is the pelvis.
TEST(JointRoles, HipWithASideIsALegJoint) {
  for (const char* name :
       {"hip.L", "hip_R", "LeftHip", "right hip", "hip_fl", "hip_fr", "hip bl", "BR_hip", "hip_rt"}) {
    EXPECT_EQ(roleOf(name), JointRole::kHip) << name;
  }
  for (const char* name : {"hip", "bright hip", "upright_hip", "cleft-hip", "hip skull", "hip L R"}) {
    EXPECT_EQ(roleOf(name), JointRole::kStill) << name;
  }
}

}  // namespace
}  // namespace sinew
