// tests/character/skinning_kernel_test.cpp: vectorized skinning matches scalar skinning bit for bit.

#include "core/character/skinning_kernel.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "core/character/skinning.h"
#include "core/geometry/at.h"
#include "core/surface/projection/rise.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/rigs/trial_scenes.h"
#include "tests/support/surface/mesh_checks.h"
#include "tests/support/surface/scalar_skinning.h"

namespace sinew::test {
namespace {

struct Skinned {
  SkinnedMesh mesh;
  std::vector<glm::vec3> rise;
};

Skinned skinBy(const SkinKernels& kernels, const Character& character, const Pose& pose) {
  const ControlMesh& mesh = character.mesh;
  Skinned out;
  skin(character, pose, out.mesh);
  SkinnedMesh& skinned = out.mesh;
  std::ranges::fill(skinned.positions, glm::vec3(0.0f));
  std::ranges::fill(skinned.normals, glm::vec3(0.0f));
  out.rise.resize(mesh.positions.size());
  const std::size_t all = mesh.positions.size();
  kernels.vertices({&mesh, skinned.matrices, mesh.positions, mesh.normals, skinned.positions, skinned.normals}, 0, all);
  kernels.vertices({&mesh, skinned.matrices, {}, riseDirections(mesh, kRise * character.height), {}, out.rise}, 0, all);
  return out;
}

void expectSameBits(const Character& character, const Pose& pose, const std::string& what) {
  const Skinned scalar = skinBy(scalarSkinKernels(), character, pose);
  ASSERT_EQ(scalar.mesh.positions.size(), character.mesh.positions.size());
  for (const InstructionSet set : availableInstructionSets()) {
    if (set == InstructionSet::kScalar) continue;
    const Skinned lanes = skinBy(skinKernels(set), character, pose);
    EXPECT_TRUE(sameBytes(lanes.mesh.positions, scalar.mesh.positions)) << what << ", " << nameOf(set);
    EXPECT_TRUE(sameBytes(lanes.mesh.normals, scalar.mesh.normals)) << what << ", " << nameOf(set);
    EXPECT_TRUE(sameBytes(lanes.rise, scalar.rise)) << what << ", " << nameOf(set);
  }
}

TEST(SkinningKernel, GivesTheScalarBitsOnCharacters) {
  for (const TrialScene& scene : trialScenes()) {
    for (const Pose& pose : spreadPoses(*scene.character, 2)) expectSameBits(*scene.character, pose, scene.name);
  }
}

// Bones that are mirrored, flattened, shrunk to a point, or so small or large that squares exceed the range of floats.
TEST(SkinningKernel, GivesTheScalarBitsWithExtremeBoneScales) {
  const std::vector<glm::vec3> sizes{{-1.0f, 1.0f, 1.0f},   {1.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 0.0f},
                                     {1e-7f, 1e-7f, 1e-7f}, {1e7f, 2e7f, 1e7f}, {1.0f, 1e-12f, 1.0f}};
  for (const auto& character : {makeLimb(), makeTwoLegged(), makeStrip(), makeTube(), makeCube()}) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const Pose pose = randomPose(character->skeleton, 1.0f, 0.4f, seed);
      expectSameBits(*character, pose, "random pose");
      for (const glm::vec3& size : sizes) {
        Pose sized = pose;
        for (std::size_t bone = seed % 2; bone < sized.boneInWorld.size(); bone += 2) {
          sized.boneInWorld[bone] = glm::scale(sized.boneInWorld[bone], size);
        }
        expectSameBits(*character, sized, "size " + std::to_string(size.x) + ", " + std::to_string(size.y));
      }
    }
  }
}

// Random creased wedges, so that the last lanes hold any number of them.
TEST(SkinningKernel, GivesTheScalarBitsOfCreasedWedges) {
  Random random(5);
  for (const auto& character : {makeTwoLegged(), makeTube(), makeCube()}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      SkinnedMesh skinned;
      skin(*character, randomPose(character->skeleton, 1.0f, 0.4f, seed), skinned);
      ControlMesh mesh = character->mesh;
      for (Wedge& wedge : mesh.wedges) {
        wedge.creased = random.chance(0.3f);
        wedge.normal = random.rotation() * glm::vec3(0.0f, 1.0f, 0.0f);
      }
      std::vector<glm::vec3> ofVertices;
      for (const Wedge& wedge : mesh.wedges) ofVertices.push_back(skinned.normals[toIndex(wedge.vertex)]);
      const auto by = [&](const SkinKernels& kernels) {
        std::vector<glm::vec3> normals = ofVertices;
        kernels.wedges({&character->mesh, skinned.matrices, mesh.wedges, {}, nullptr, normals});
        return normals;
      };
      const std::vector<glm::vec3> scalar = by(scalarSkinKernels());
      int turned = 0;
      for (std::size_t w = 0; w < scalar.size(); ++w) {
        const bool own = scalar[w] != ofVertices[w];
        ASSERT_EQ(own, mesh.wedges[w].creased);
        turned += own ? 1 : 0;
      }
      EXPECT_TRUE(turned > 0 || mesh.wedges.size() < 20);
      for (const InstructionSet set : availableInstructionSets()) {
        if (set == InstructionSet::kScalar) continue;
        EXPECT_TRUE(sameBytes(by(skinKernels(set)), scalar)) << nameOf(set);
      }
    }
  }
}

// Vertices after the last one neither affect results nor are written.
TEST(SkinningKernel, FillsExactlyTheRequestedCount) {
  const auto character = makeLimb();
  const Pose pose = randomPose(character->skeleton, 0.6f, 0.3f, 1);
  const SkinnedMesh whole = skinBy(scalarSkinKernels(), *character, pose).mesh;
  const glm::vec3 untouched(-7.25f, 1e30f, 3.0f);
  for (const InstructionSet set : availableInstructionSets()) {
    if (set == InstructionSet::kScalar) continue;
    for (std::size_t end = 0; end <= 35; ++end) {
      const std::size_t begin = end / 4;
      std::vector<glm::vec3> positions(end + 40, untouched);
      std::vector<glm::vec3> normals(end + 40, untouched);
      skinKernels(set).vertices(
          {&character->mesh, whole.matrices, character->mesh.positions, character->mesh.normals, positions, normals},
          begin, end);
      for (std::size_t v = 0; v < positions.size(); ++v) {
        const bool asked = v >= begin && v < end;
        ASSERT_TRUE(sameBits(positions[v], asked ? whole.positions[v] : untouched)) << end << ", " << nameOf(set);
        ASSERT_TRUE(sameBits(normals[v], asked ? whole.normals[v] : untouched)) << end << ", " << nameOf(set);
      }
    }
  }
}

}  // namespace
}  // namespace sinew::test
