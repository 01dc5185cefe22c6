// tests/surface/patches/patch_kernel_test.cpp: vectorized patches and directions match the scalar ones bit for bit.

#include "core/surface/patches/patch.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/character/skinning.h"
#include "core/geometry/normals.h"
#include "sinew/files/gltf_import.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/rigs/trial_scenes.h"
#include "tests/support/surface/mesh_checks.h"
#include "tests/support/surface/scalar_patches.h"
#include "tests/support/surface/sheets.h"

namespace sinew::test {
namespace {

constexpr PatchKind kKinds[] = {PatchKind::kPn, PatchKind::kPhong, PatchKind::kSpherigon, PatchKind::kFlat};
constexpr int kDepths[] = {1, 2, 3, 4, 5, 6, 7, 12};
constexpr std::size_t kBehind = 64;  ///< Vertices after the last one, which must stay untouched.
constexpr glm::vec3 kUntouched{-7.25f, 1e30f, std::numeric_limits<float>::lowest()};

/// Contents of the output arrays, with kBehind more elements.
struct Filled {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec3> directions;
};

Filled fillBy(const PatchKernels& kernels, PatchKind kind, const ControlMesh& mesh, const Refinement& refinement,
              const SkinnedMesh& control) {
  const auto count = static_cast<std::size_t>(refinement.vertexCount);
  const std::vector<glm::vec3> untouched(count + kBehind, kUntouched);
  Filled out{untouched, untouched, untouched};
  const auto own = [&](std::vector<glm::vec3>& all) { return std::span(all).first(count); };
  std::ranges::copy(control.positions, out.positions.begin());
  std::ranges::copy(control.normals, out.normals.begin());
  std::ranges::copy(control.normals, out.directions.begin());
  kernels.patches({kind, &mesh, &refinement, control.positions, control.normals, own(out.positions), own(out.normals)});
  kernels.directions({&mesh, &refinement, control.normals, own(out.directions)});
  return out;
}

/// All instruction sets give the reference's bits, for all kinds at these depths.
void expectSameBits(const ControlMesh& mesh, const SkinnedMesh& control, std::span<const int> depths,
                    const std::string& what) {
  for (const int depth : depths) {
    const Refinement refinement = refine(mesh, depth);
    for (const PatchKind kind : kKinds) {
      const Filled scalar = fillBy(scalarPatchKernels(), kind, mesh, refinement, control);
      ASSERT_EQ(std::ranges::count(scalar.positions, kUntouched), kBehind);
      for (const InstructionSet set : availableInstructionSets()) {
        if (set == InstructionSet::kScalar) continue;
        const std::string where = what + ", kind " + std::to_string(static_cast<int>(kind)) + ", depth " +
                                  std::to_string(depth) + ", " + nameOf(set);
        const Filled lanes = fillBy(patchKernels(set), kind, mesh, refinement, control);
        ASSERT_TRUE(sameBytes(lanes.positions, scalar.positions)) << where;
        ASSERT_TRUE(sameBytes(lanes.normals, scalar.normals)) << where;
        ASSERT_TRUE(sameBytes(lanes.directions, scalar.directions)) << where;
      }
    }
  }
}

TEST(PatchKernel, GivesTheScalarBitsOnCharacters) {
  struct Moment {
    std::string name;
    std::shared_ptr<const Character> character;
    std::vector<Pose> poses;
  };
  std::vector<Moment> moments;
  for (const char* name : {"humanoid.glb", "horse.glb", "demo.glb"}) {
    const auto character = importGltf(std::string(SINEW_SOURCE_DIR) + "/assets/" + name);
    ASSERT_TRUE(character.ok()) << name;
    moments.push_back({name, character.value(), spreadPoses(*character.value(), 1)});
  }
  for (const TrialScene& scene : trialScenes()) {
    moments.push_back({scene.name, scene.character, spreadPoses(*scene.character, 1)});
  }
  for (const auto& character : {makeLimb(), makeStrip(), makeTube(), makeCube()}) {
    moments.push_back({"synthetic", character, {randomPose(character->skeleton, 0.6f, 0.3f, 1)}});
  }
  for (const auto& [name, character, poses] : moments) {
    SkinnedMesh control;
    skin(*character, poses.back(), control);
    // Large ones at fewer depths: depths only differ in weights and strides.
    const bool large = control.positions.size() > 1500;
    const std::vector<int> few{2, 3, 5};
    expectSameBits(character->mesh, control, large ? std::span<const int>(few) : std::span<const int>(kDepths), name);
  }
}

glm::vec3 randomDirection(Random& random) {
  const auto number = [&] { return random.uniform(-1.0f, 1.0f); };
  return normalizeOr(glm::vec3(number(), number(), number()), glm::vec3(0.0f, 1.0f, 0.0f));
}

/// Triangles of any three vertices. Points coincide or are collinear; normals are opposite or nearly, so that sums of
/// them are 0 or too short to be squared in float.
SkinnedMesh degenerateControl(Random& random, std::size_t count, float scale) {
  SkinnedMesh control;
  for (std::size_t v = 0; v < count; ++v) {
    const auto number = [&] { return scale * random.uniform(-1.0f, 1.0f); };
    glm::vec3 position(number(), number(), number());
    glm::vec3 normal = randomDirection(random);
    if (v > 1 && random.chance(0.3f)) position = control.positions[v - 1];
    if (v > 1 && random.chance(0.2f)) position = 0.5f * (control.positions[v - 1] + control.positions[v - 2]);
    if (v > 0 && random.chance(0.3f)) normal = -control.normals[v - 1];
    if (random.chance(0.3f)) {
      const float tiny = random.chance(0.5f) ? random.uniform(-1e-11f, 1e-11f) : 0.0f;
      normal = {random.chance(0.5f) ? 1.0f : -1.0f, tiny, -tiny};
    }
    control.positions.push_back(position);
    control.normals.push_back(normal);
  }
  return control;
}

ControlMesh randomMesh(Random& random, int vertices, int triangles) {
  std::vector<glm::vec3> apart;
  for (int v = 0; v < vertices; ++v) apart.push_back({static_cast<float>(v), static_cast<float>(v * v % 17), 0.0f});
  std::vector<std::array<int, 3>> corners;
  for (int v = 0; v < vertices; v += 3) corners.push_back({v, (v + 1) % vertices, (v + 2) % vertices});
  while (static_cast<int>(corners.size()) < triangles) {
    const std::array<int, 3> t{random.below(vertices), random.below(vertices), random.below(vertices)};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) corners.push_back(t);
  }
  return meshOf(apart, corners);
}

TEST(PatchKernel, GivesTheScalarBitsOnDegenerateMeshes) {
  Random random(20);
  int fallbacks = 0;
  for (const int vertices : {3, 4, 7, 12, 24}) {
    for (int extra = 0; extra < 9; ++extra) {
      const ControlMesh mesh = randomMesh(random, vertices, (vertices + 2) / 3 + extra);
      for (const float scale : {1.0f, 1e-21f, 1e14f}) {
        const SkinnedMesh control = degenerateControl(random, mesh.positions.size(), scale);
        const std::string what = std::to_string(mesh.triangles.size()) + " triangles, " +
                                 std::to_string(mesh.edges.size()) + " edges, scale " + std::to_string(scale);
        expectSameBits(mesh, control, kDepths, what);
        for (const Edge& edge : mesh.edges) {
          const auto normal = [&](std::size_t i) {
            return control.normals[static_cast<std::size_t>(edge.vertices[i])];
          };
          fallbacks += glm::length(normal(0) + normal(1)) < 1e-10f ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(fallbacks, 100);  // At even depths they meet in the middle of the edge.
}

std::vector<glm::vec3> shadeBy(const PatchKernels& kernels, PatchKind kind, const ControlMesh& creased,
                               const Refinement& refinement, const SkinnedMesh& control,
                               const std::vector<glm::vec3>& wedgeNormals, const std::vector<glm::vec3>& patchNormals) {
  std::vector<glm::vec3> out(refinement.drawVertex.size() + kBehind, kUntouched);
  forEachDrawVertex(refinement, [&](std::size_t d, std::size_t v) { out[d] = patchNormals[v]; });
  for (std::size_t w = 0; w < creased.wedges.size(); ++w) {
    if (creased.wedges[w].creased) out[w] = wedgeNormals[w];
  }
  kernels.shading({kind, &creased, &refinement, control.positions, wedgeNormals,
                   std::span(out).first(refinement.drawVertex.size())});
  return out;
}

/// @return number of drawn vertices whose normal differs from the patch's
int expectSameShading(const ControlMesh& creased, const SkinnedMesh& control,
                      const std::vector<glm::vec3>& wedgeNormals, const std::string& what) {
  int shaded = 0;
  for (const int depth : kDepths) {
    const Refinement refinement = refine(creased, depth);
    for (const PatchKind kind : kKinds) {
      const Filled patch = fillBy(scalarPatchKernels(), kind, creased, refinement, control);
      const auto by = [&](const PatchKernels& kernels) {
        return shadeBy(kernels, kind, creased, refinement, control, wedgeNormals, patch.normals);
      };
      const std::vector<glm::vec3> scalar = by(scalarPatchKernels());
      forEachDrawVertex(refinement, [&](std::size_t d, std::size_t v) { shaded += scalar[d] != patch.normals[v]; });
      for (const InstructionSet set : availableInstructionSets()) {
        if (set == InstructionSet::kScalar) continue;
        EXPECT_TRUE(sameBytes(by(patchKernels(set)), scalar))
            << what << ", kind " << static_cast<int>(kind) << ", depth " << depth << ", " << nameOf(set);
      }
    }
  }
  return shaded;
}

TEST(PatchKernel, GivesTheScalarBitsOfCreases) {
  for (const auto& character : {makeLimb(), makeTwoLegged(), makeStrip(), makeTube(), makeCube()}) {
    SkinnedMesh control;
    skin(*character, randomPose(character->skeleton, 0.6f, 0.3f, 1), control);
    int shaded = 0;
    for (const float degrees : {10.0f, 20.0f, 40.0f}) {
      const ControlMesh sharp = creased(character->mesh, degrees);
      std::vector<glm::vec3> wedgeNormals;
      skinWedgeNormals(*character, sharp.wedges, control, wedgeNormals);
      shaded += expectSameShading(sharp, control, wedgeNormals, "degrees " + std::to_string(degrees));
    }
    // All edges of the cube are creased.
    EXPECT_GT(shaded, character->mesh.positions.size() == 8 ? 1000 : -1);
  }
}

// Random creased wedges, so that the last lanes hold any number of pieces; normals may be opposite.
TEST(PatchKernel, GivesTheScalarBitsOfRandomCreases) {
  Random random(7);
  int shaded = 0;
  for (int extra = 0; extra < 20; ++extra) {
    ControlMesh mesh = randomMesh(random, 12, 4 + extra);
    const SkinnedMesh control = degenerateControl(random, mesh.positions.size(), 1.0f);
    std::vector<glm::vec3> wedgeNormals = degenerateControl(random, mesh.wedges.size(), 1.0f).normals;
    for (std::size_t w = 0; w < mesh.wedges.size(); ++w) {
      mesh.wedges[w].creased = random.chance(0.3f);
      if (!mesh.wedges[w].creased) wedgeNormals[w] = control.normals[static_cast<std::size_t>(mesh.wedges[w].vertex)];
    }
    shaded += expectSameShading(mesh, control, wedgeNormals, std::to_string(mesh.triangles.size()) + " triangles");
  }
  EXPECT_GT(shaded, 1000);
}

// A zero sum has the direction with the larger weight; the first one's for equal weights.
TEST(PatchKernel, OppositeNormalsFallBackInEveryLane) {
  Random random(3);
  const ControlMesh mesh = randomMesh(random, 21, 40);
  SkinnedMesh control{mesh.positions, {}, {}};
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    control.normals.push_back(glm::vec3(v % 2 == 0 ? 1.0f : -1.0f, 0.0f, 0.0f));
  }
  const Refinement refinement = refine(mesh, 2);
  int opposite = 0;
  for (const InstructionSet set : availableInstructionSets()) {
    if (set == InstructionSet::kScalar) continue;
    const Filled filled = fillBy(patchKernels(set), PatchKind::kPhong, mesh, refinement, control);
    for (int e = 0; e < refinement.controlEdges; ++e) {
      const auto& ends = mesh.edges[static_cast<std::size_t>(e)].vertices;
      const glm::vec3 first = control.normals[static_cast<std::size_t>(ends[0])];
      opposite += first == -control.normals[static_cast<std::size_t>(ends[1])] ? 1 : 0;
      const auto place = static_cast<std::size_t>(refinement.edgeVertex(e, 1));
      EXPECT_EQ(filled.normals[place], first) << e << ", " << nameOf(set);
      EXPECT_EQ(filled.directions[place], first) << e << ", " << nameOf(set);
    }
  }
  EXPECT_GT(opposite, 20);
}

}  // namespace
}  // namespace sinew::test
