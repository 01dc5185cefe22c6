// tests/rig/rig_test.cpp: equality, lookups and names.
#include "sinew/rig/rig.h"

#include <gtest/gtest.h>

#include "tests/support/rigs/random_documents.h"

namespace sinew {
namespace {

TEST(Rig, EqualityComparesEveryMember) {
  const Rig rig = test::randomDocument(5);
  ASSERT_GE(rig.primitives.size(), 1u);
  ASSERT_TRUE(rig == Rig(rig));
  const std::vector<void (*)(Rig&)> changes{
      [](Rig& r) { r.character += 'x'; },
      [](Rig& r) {
        r.surface.mode = r.surface.mode == SurfaceMode::kSwell ? SurfaceMode::kReplace : SurfaceMode::kSwell;
      },
      [](Rig& r) { r.surface.iso *= 0.5f; },
      [](Rig& r) { r.surface.skinBlend *= 0.5f; },
      [](Rig& r) { r.surface.grooves = 0.5f * r.surface.grooves + 0.1f; },
      [](Rig& r) { r.surface.unknownKeys += ' '; },
      [](Rig& r) { r.smoothing.depth += 1; },
      [](Rig& r) { r.smoothing.patch = r.smoothing.patch == PatchKind::kPn ? PatchKind::kFlat : PatchKind::kPn; },
      [](Rig& r) { r.smoothing.unknownKeys += ' '; },
      [](Rig& r) { r.groups[0].name += 'x'; },
      [](Rig& r) { r.groups[0].unknownKeys += ' '; },
      [](Rig& r) {
        r.links.push_back({"a", "b"});
      },
      [](Rig& r) { r.primitives.pop_back(); },
      [](Rig& r) { r.primitives[0].name += 'x'; },
      [](Rig& r) { r.primitives[0].bone += 'x'; },
      [](Rig& r) { r.primitives[0].group += 'x'; },
      [](Rig& r) { r.primitives[0].placement.center.z = 12345.0f; },
      [](Rig& r) { r.primitives[0].placement.rotation = glm::quat(2, 0, 0, 0); },
      [](Rig& r) { r.primitives[0].placement.radii.y = 12345.0f; },
      [](Rig& r) { r.primitives[0].reach = 12345.0f; },
      [](Rig& r) { r.primitives[0].sign *= -1; },
      [](Rig& r) { r.primitives[0].mirror += 'x'; },
      [](Rig& r) { r.primitives[0].territory = std::vector<std::string>{"only here"}; },
      [](Rig& r) { r.primitives[0].unknownKeys += ' '; },
      [](Rig& r) { r.unknownKeys += ' '; }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Rig changed = rig;
    changes[i](changed);
    EXPECT_FALSE(changed == rig) << "change " << i;
  }
}

TEST(Rig, FreeNamesAreUnusedAndContinueTheNumbering) {
  Rig rig;
  for (const char* name : {"thigh", "calf", "calf 2", "calf 3", "arm 09", "9"}) {
    rig.primitives.emplace_back().name = name;
    rig.groups.push_back({name, {}});
  }
  EXPECT_EQ(freePrimitiveName(rig, "foot"), "foot");
  EXPECT_EQ(freePrimitiveName(rig, "thigh"), "thigh 2");
  EXPECT_EQ(freePrimitiveName(rig, "calf"), "calf 4");
  EXPECT_EQ(freePrimitiveName(rig, "calf 2"), "calf 4");
  EXPECT_EQ(freePrimitiveName(rig, "arm 09"), "arm 09 2");
  EXPECT_EQ(freePrimitiveName(rig, "9"), "9 2");
  EXPECT_EQ(freeGroupName(rig, "calf"), "calf 4");
  EXPECT_EQ(findPrimitive(rig, "calf 2"), 2);
  EXPECT_EQ(findPrimitive(rig, "Calf"), -1);
  EXPECT_EQ(findGroup(rig, "9"), 5);
}

TEST(Rig, EnumNamesRoundTrip) {
  for (const auto mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) EXPECT_EQ(surfaceModeNamed(nameOf(mode)), mode);
  for (const auto patch : {PatchKind::kPn, PatchKind::kPhong, PatchKind::kSpherigon, PatchKind::kFlat}) {
    EXPECT_EQ(patchKindNamed(nameOf(patch)), patch);
  }
  EXPECT_EQ(surfaceModeNamed("Swell"), std::nullopt);
  EXPECT_EQ(patchKindNamed(""), std::nullopt);
}

}  // namespace
}  // namespace sinew
