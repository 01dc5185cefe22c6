// tests/surface/cloth_outfits_test.cpp: clothes of any cut stay above the skin of a muscular body, also in folds.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/bodies/cloth_check.h"
#include "core/bodies/fit_preset.h"
#include "core/files/preset_json.h"
#include "core/geometry/at.h"
#include "core/rig/mesh_layers.h"
#include "core/rig/mirror.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/dressed_humanoid.h"
#include "tests/support/surface/pops.h"

namespace sinew {
namespace {

/// The bundled muscle set with uniform detail.
Rig athleteOn(const Character& character) {
  const std::filesystem::path presets = std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "presets";
  const Preset preset = loadPreset(presets / "athlete.json").value();
  Rig rig = fitPreset({}, preset, {}, character, makeMirrorPlan(character)).value().rig;
  rig.smoothing.detail = DetailKind::kUniform;
  rig.smoothing.depth = 3;
  return rig;
}

class ClothingOutfits : public ::testing::TestWithParam<test::Outfit> {};

TEST_P(ClothingOutfits, StayAboveTheSkinEvenInFolds) {
  const auto character = test::dressedHumanoid(GetParam());
  const std::vector<Pose> poses = test::posesOfClips(*character, 12);
  const ClothCount count = countClothBelow(character, athleteOn(*character), poses).value();
  EXPECT_GT(count.vertices, 3000);
  EXPECT_LE(count.below, count.bare);
  // Vertices between two walls of a fold that are about to leave it.
  const double all = static_cast<double>(count.vertices) * static_cast<double>(poses.size());
  const double most = GetParam() == test::Outfit::kLoose ? 5e-4 : 1e-4;
  EXPECT_LE(static_cast<double>(count.more), most * all) << "deepest " << count.deepest << " H in pose " << count.worst;
  // Visible ones. A loose sleeve at the bend of an elbow goes into the forearm.
  EXPECT_LE(count.seen, GetParam() == test::Outfit::kLoose ? 12 : 2) << "in pose " << count.lastSeen;
}

INSTANTIATE_TEST_SUITE_P(Outfits, ClothingOutfits, ::testing::ValuesIn(test::kOutfits), [](const auto& outfit) {
  std::string name = test::nameOf(outfit.param);
  std::erase(name, ' ');
  return name;
});

TEST(StandardClothing, PopsNoMoreThanTheSkin) {
  const auto character = test::dressedHumanoid();
  const Rig rig = athleteOn(*character);
  Rig stiff = rig;
  for (const char* part : {"Shirt", "Trousers", "Hair"}) stiff = setLayer(stiff, part, SkinLayer::kRigid).value();
  constexpr int kFrames = 40;  // For each clip.
  const test::Pops all = test::countPops(character, rig, kFrames);
  const test::Pops skin = test::countPops(character, stiff, kFrames);
  EXPECT_GT(all.frames, 100);
  // Steps where the nearest wall of a fold changes; of half a million vertex steps.
  EXPECT_LE(all.pops - skin.pops, 120);
  EXPECT_LE(all.largestPop, std::max(skin.largestPop, 0.015f));
}

/// Sum of the angles along the border of a part, in degrees per border vertex.
double meanTurnAlongHems(const Character& character, const std::string& part, const Surface& surface) {
  std::map<std::array<int, 2>, int> edges;
  for (std::size_t t = 0; t < surface.refinement->triangles.size(); ++t) {
    const int own = at(character.mesh.triangles, surface.refinement->controlOf[t]).part;
    if (at(character.parts, own).name != part) continue;
    const auto& v = surface.refinement->triangles[t];
    for (std::size_t k = 0; k < 3; ++k) ++edges[{std::min(v[k], v[(k + 1) % 3]), std::max(v[k], v[(k + 1) % 3])}];
  }
  std::map<int, std::vector<int>> next;
  for (const auto& [ends, count] : edges) {
    if (count != 1) continue;
    next[ends[0]].push_back(ends[1]);
    next[ends[1]].push_back(ends[0]);
  }
  double sum = 0.0;
  int vertices = 0;
  for (const auto& [v, others] : next) {
    if (others.size() != 2) continue;
    const glm::vec3 in = glm::normalize(at(surface.positions, v) - at(surface.positions, others[0]));
    const glm::vec3 out = glm::normalize(at(surface.positions, others[1]) - at(surface.positions, v));
    sum += static_cast<double>(glm::degrees(std::acos(std::clamp(glm::dot(in, out), -1.0f, 1.0f))));
    ++vertices;
  }
  EXPECT_GT(vertices, 50);
  return sum / std::max(vertices, 1);
}

TEST(StandardClothing, HasSmoothHems) {
  const auto character = test::dressedHumanoid();
  const Rig rig = athleteOn(*character);
  std::vector<int> all(rig.primitives.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  Smoother lifted(character);
  Smoother bare(character);
  ASSERT_TRUE(lifted.prepare(rig).ok() && bare.prepare(rig, all).ok());
  Surface surface;
  for (const Pose& pose : test::posesOfClips(*character, 6)) {
    bare.smooth(pose, surface);
    const double before = meanTurnAlongHems(*character, "Shirt", surface);
    lifted.smooth(pose, surface);
    EXPECT_LT(meanTurnAlongHems(*character, "Shirt", surface), before + 3.0) << pose.clip << ' ' << pose.time;
  }
}

}  // namespace
}  // namespace sinew
