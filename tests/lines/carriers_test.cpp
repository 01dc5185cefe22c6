// tests/lines/carriers_test.cpp: what muscles ride, one by one and all together.
#include "core/lines/carriers.h"

#include <gtest/gtest.h>

#include "sinew/io/gltf_import.h"
#include "sinew/io/rig_json.h"

namespace sinew::test {
namespace {

TEST(Carriers, OneMusclesCarrierIsAmongAllOfThem) {
  const std::filesystem::path assets = std::filesystem::path(SINEW_SOURCE_DIR) / "assets";
  const auto character = importGltf(assets / "humanoid.glb").value();
  Rig rig = loadRig(assets / "humanoid-flex.rig.json").value();
  rig.primitives[0].bone = "none";
  rig.lines.back().via = LineAnchor{"none", {}, {}};
  Pose pose = samplePose(character->skeleton, character->clips.at(0), 0.4f);
  pose.flex = 0.7f;
  for (const std::vector<int>& flexed : {std::vector<int>{}, std::vector<int>{1}, std::vector<int>{0, 4}}) {
    pose.flexedLines = flexed;
    const auto all = carriersOf(rig, *character, pose);
    EXPECT_FALSE(all[0]);
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(carrierOf(rig, rig.primitives[i], *character, pose), all[i]) << rig.primitives[i].name;
    }
  }
}

}  // namespace
}  // namespace sinew::test
