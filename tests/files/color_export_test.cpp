// tests/files/color_export_test.cpp: vertex colors and hidden materials in .glb, .ply and .obj.

#include <cmath>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "core/files/disk/atomic_file.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/surface_export.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/temporary_folder.h"

namespace sinew {
namespace {

/// The tube with its seam; each wedge has its own color.
Character paintedTube() {
  Character character = *test::makeTube();
  std::mt19937 random(3);
  std::uniform_real_distribution<float> level(0.0f, 1.0f);
  for (Wedge& wedge : character.mesh.wedges) {
    wedge.color = {level(random), level(random), level(random), level(random)};
  }
  return character;
}

class ColorExport : public testing::Test {
 protected:
  Surface surfaceOf(const Character& character) const {
    const auto shared = std::make_shared<const Character>(character);
    Smoother smoother(shared);
    Rig rig;
    rig.smoothing.depth = 3;
    EXPECT_TRUE(smoother.prepare(rig).ok());
    Surface surface;
    smoother.smooth(bindPose(shared->skeleton), surface);
    return surface;
  }

  std::string exported(const Surface& surface, const Character& character, const std::string& name) const {
    const auto written = exportSurface(surface, character, folder_.path() / name);
    EXPECT_TRUE(written.ok()) << written.error().text();
    return written ? readWholeFile(folder_.path() / name, 1 << 26).value() : std::string();
  }

  const test::TemporaryFolder folder_;
};

TEST_F(ColorExport, GlbRoundTripsEveryColor) {
  const Character tube = paintedTube();
  const Surface surface = surfaceOf(tube);
  exported(surface, tube, "tube.glb");
  const auto imported = importGltf(folder_.path() / "tube.glb");
  ASSERT_TRUE(imported.ok()) << imported.error().text();
  const ControlMesh& back = imported.value()->mesh;
  const Refinement& refinement = *surface.refinement;
  ASSERT_EQ(back.triangles.size(), refinement.drawTriangles.size());
  EXPECT_EQ(back.wedges.size(), refinement.drawVertex.size());
  for (std::size_t t = 0; t < back.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Wedge& wedge = back.wedges[static_cast<std::size_t>(back.triangles[t].wedges[i])];
      ASSERT_EQ(wedge.color, refinement.drawColor[refinement.drawTriangles[t][i]]) << t;
    }
  }
}

TEST_F(ColorExport, PlyHasSrgbColors) {
  const Character tube = paintedTube();
  const Surface surface = surfaceOf(tube);
  const Refinement& refinement = *surface.refinement;
  const std::string bytes = exported(surface, tube, "tube.ply");
  const std::size_t header = bytes.find("end_header\n") + 11;
  EXPECT_NE(bytes.substr(0, header).find("property float t\nproperty uchar red\nproperty uchar green\n"
                                         "property uchar blue\nproperty uchar alpha\nelement face"),
            std::string::npos);
  ASSERT_EQ(bytes.size(), header + refinement.drawVertex.size() * 36 + refinement.drawTriangles.size() * 13);
  for (std::size_t d = 0; d < refinement.drawVertex.size(); ++d) {
    for (std::size_t channel = 0; channel < 4; ++channel) {
      const double shown = static_cast<unsigned char>(bytes[header + d * 36 + 32 + channel]) / 255.0;
      const double linear = shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
      const double expected = static_cast<double>(refinement.drawColor[d][static_cast<int>(channel)]);
      // Half a step of 8 bits where the curve is steepest.
      ASSERT_NEAR(channel < 3 ? linear : shown, expected, 0.0046) << d << ", " << channel;
    }
  }
}

TEST_F(ColorExport, CharactersWithoutColorsWriteNone) {
  const Character tube = *test::makeTube();
  const Surface surface = surfaceOf(tube);
  EXPECT_EQ(exported(surface, tube, "tube.glb").find("COLOR_0"), std::string::npos);
  EXPECT_EQ(exported(surface, tube, "tube.ply").find("uchar red"), std::string::npos);
}

TEST_F(ColorExport, ObjIgnoresColors) {
  const Character plain = *test::makeTube();
  const Character painted = paintedTube();
  EXPECT_EQ(exported(surfaceOf(plain), plain, "tube.obj"), exported(surfaceOf(painted), painted, "tube.obj"));
}

// A material shown opaque is exported as its author made it, and reported again on import.
TEST_F(ColorExport, HiddenMaterialsKeepTheirAlpha) {
  Character tube = *test::makeTube();
  tube.materials[0].alphaMode = AlphaMode::kMask;
  tube.materials[0].alphaCutoff = 0.75f;
  tube.materials[0].baseColor.a = 0.25f;
  tube.materials[0].shownOpaque = true;
  exported(surfaceOf(tube), tube, "tube.glb");
  const auto imported = importGltf(folder_.path() / "tube.glb");
  ASSERT_TRUE(imported.ok()) << imported.error().text();
  const Material& back = imported.value()->materials[0];
  EXPECT_EQ(back.alphaMode, AlphaMode::kMask);
  EXPECT_EQ(back.alphaCutoff, 0.75f);
  EXPECT_EQ(back.baseColor.a, 0.25f);
  EXPECT_TRUE(back.shownOpaque);
  ASSERT_EQ(imported.value()->ignored.size(), 1u);
  EXPECT_NE(imported.value()->ignored[0].find("would hide the whole character"), std::string::npos);
}

}  // namespace
}  // namespace sinew
