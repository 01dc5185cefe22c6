// tests/surface/blending_surface_test.cpp: guarantees of the blending graph, checked on surfaces and on the field.

#include <array>
#include <cstdio>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/rig/attachment.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/rigs/trial_scenes.h"
#include "tests/support/surface/projected.h"

namespace sinew::test {
namespace {

using CharacterPtr = std::shared_ptr<const Character>;

/// Three balls in a row on a flat skin, each overlapping the next but one; each in its own group.
Rig threeBalls(const Character& strip) {
  Rig rig;
  const std::array<const char*, 3> names{"A", "B", "C"};
  for (std::size_t i = 0; i < 3; ++i) {
    rig.groups.push_back({names[i], {}});
    const glm::vec3 center(0.0f, 0.8f + 0.2f * static_cast<float>(i), 0.0f);
    rig.primitives.push_back(ellipsoidAt(strip, names[i], "end", names[i], center, glm::vec3(0.24f)));
    rig.primitives.back().territory = std::vector<std::string>{"root", "end"};
  }
  rig.smoothing.detail = DetailKind::kUniform;
  rig.smoothing.depth = 8;
  return rig;
}

Rig only(Rig rig, const std::string& names) {
  std::erase_if(rig.primitives, [&](const Primitive& p) { return names.find(p.name) == std::string::npos; });
  return rig;
}

/// Surface from the roots, before heights are filtered.
Surface surfaceOf(const CharacterPtr& character, const Rig& rig) {
  return Projected(*character, rig).at(bindPose(character->skeleton));
}

TEST(BlendingSurface, UnlinkedGroupsNeverSum) {
  const CharacterPtr strip = makeStrip();
  const Rig rig = threeBalls(*strip);
  const float tolerance = 2e-5f * strip->height;
  int byA = 0;
  int byB = 0;
  for (const float shift : {0.0f, 0.05f, 0.15f, 0.3f}) {
    Rig moved = rig;
    moved.primitives[1].placement.center.y += shift;
    const Surface both = surfaceOf(strip, only(moved, "AB"));
    const Surface a = surfaceOf(strip, only(moved, "A"));
    const Surface b = surfaceOf(strip, only(moved, "B"));
    for (std::size_t v = 0; v < both.positions.size(); ++v) {
      ASSERT_NEAR(both.displacement[v], std::max(a.displacement[v], b.displacement[v]), tolerance)
          << "vertex " << v << ", shift " << shift;
      byA += a.displacement[v] > b.displacement[v] + tolerance ? 1 : 0;
      byB += b.displacement[v] > a.displacement[v] + tolerance ? 1 : 0;
    }
  }
  EXPECT_GT(byA, 10);
  EXPECT_GT(byB, 10);
}

TEST(BlendingSurface, LinkedGroupsSum) {
  const CharacterPtr strip = makeStrip();
  Rig rig = only(threeBalls(*strip), "AB");
  const Surface apart = surfaceOf(strip, rig);
  rig.links = {{"A", "B"}};
  const Surface linked = surfaceOf(strip, rig);
  float most = 0.0f;
  for (std::size_t v = 0; v < linked.positions.size(); ++v) {
    ASSERT_GE(linked.displacement[v], apart.displacement[v] - 1e-5f);
    most = std::max(most, linked.displacement[v] - apart.displacement[v]);
  }
  EXPECT_GT(most, 0.01f) << "where both reach, the blend rises over the higher of the two";
}

TEST(BlendingSurface, ALinkInPartLiesBetweenGrooveAndSum) {
  const CharacterPtr strip = makeStrip();
  Rig rig = only(threeBalls(*strip), "AB");
  for (const float grooves : {0.0f, 0.02f}) {
    rig.surface.grooves = grooves;
    rig.links.clear();
    std::vector<Surface> rising{surfaceOf(strip, rig)};
    for (const float amount : {0.001f, 0.25f, 0.5f, 0.75f, 0.999f, 1.0f}) {
      rig.links = {{{"A", "B"}, amount}};
      rising.push_back(surfaceOf(strip, rig));
    }
    std::array<float, 6> most{};
    for (std::size_t i = 0; i < most.size(); ++i) {
      for (std::size_t v = 0; v < rising[i].displacement.size(); ++v) {
        ASSERT_GE(rising[i + 1].displacement[v], rising[i].displacement[v] - 1e-5f) << "vertex " << v;
        most[i] = std::max(most[i], rising[i + 1].displacement[v] - rising[i].displacement[v]);
      }
    }
    EXPECT_LT(most[0], 1e-3f * strip->height);
    EXPECT_LT(most[5], 1e-3f * strip->height);
    for (const std::size_t i : {1u, 2u, 3u, 4u}) EXPECT_GT(most[i], 1e-3f * strip->height) << i;
  }
}

// Few roots need the scalar path.
TEST(BlendingSurface, LinksInPartAreCertified) {
  for (const char* name : {"demo", "humanoid", "tangle", "wrapped"}) {
    TrialScene scene = bundledTrialScene(name);
    int projected = 0;
    int uncertified = 0;
    for (const float grooves : {0.0f, 0.015f}) {
      scene.rig.surface.grooves = grooves;
      for (std::size_t i = 0; i < scene.rig.links.size(); ++i) scene.rig.links[i].amount = i % 2 ? 0.7f : 0.4f;
      for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
        scene.rig.surface.mode = mode;
        const Surface surface = surfaceOf(scene.character, scene.rig);
        projected += surface.report.projected;
        uncertified += surface.report.uncertified;
      }
    }
    std::printf("  %-9s %d roots, %d without a certificate\n", name, projected, uncertified);
    EXPECT_GT(projected, 1000) << name;
    EXPECT_LT(uncertified, projected / 25) << name;
  }
}

// A - B - C: both neighbors blend with B, never with each other.
TEST(BlendingSurface, ChainIsTheMaximumOfItsPairs) {
  const CharacterPtr strip = makeStrip();
  Rig rig = threeBalls(*strip);
  rig.links = {{"A", "B"}, {"B", "C"}};
  const Surface chain = surfaceOf(strip, rig);
  const Surface ab = surfaceOf(strip, only(rig, "AB"));
  const Surface bc = surfaceOf(strip, only(rig, "BC"));
  Rig clique = rig;
  clique.links.push_back({"A", "C"});
  const Surface all = surfaceOf(strip, clique);
  float mostBelow = 0.0f;
  for (std::size_t v = 0; v < chain.positions.size(); ++v) {
    ASSERT_NEAR(chain.displacement[v], std::max(ab.displacement[v], bc.displacement[v]), 2e-5f * strip->height)
        << "vertex " << v;
    mostBelow = std::max(mostBelow, all.displacement[v] - chain.displacement[v]);
  }
  EXPECT_GT(mostBelow, 0.003f) << "with A and C linked too all three add up, so the chain did keep them apart";
}

/// F of a scene in a pose, without territories.
class PosedField {
 public:
  PosedField(const TrialScene& scene, const Pose& pose) : attachment_(attach(scene.rig, *scene.character).value()) {
    std::vector<int> groups(scene.rig.groups.size());
    std::iota(groups.begin(), groups.end(), 0);
    levels_ = cliquesAmong(attachment_.graph, groups);
    poseField(attachment_.primitives, pose.boneInWorld, 0.0f, posed_);
    for (std::size_t i = 0; i < posed_.size(); ++i) {
      candidates_.push_back({static_cast<int>(i), 1.0f, attachment_.primitives[i].group});
      bounds_.add(posed_[i].influence.center - posed_[i].influence.boundingRadius);
      bounds_.add(posed_[i].influence.center + posed_[i].influence.boundingRadius);
    }
  }

  [[nodiscard]] float at(const glm::vec3& point) const {
    return sampleField(posed_, candidates_, levels_, point).value;
  }
  [[nodiscard]] glm::vec3 anywhere(Random& random) const {
    return {random.uniform(bounds_.low.x, bounds_.high.x), random.uniform(bounds_.low.y, bounds_.high.y),
            random.uniform(bounds_.low.z, bounds_.high.z)};
  }

 private:
  Attachment attachment_;
  CliqueLevels levels_;
  std::vector<PosedPrimitive> posed_;
  std::vector<Candidate> candidates_;
  Bounds bounds_;
};

TEST(BlendingSurface, FieldIsContinuous) {
  constexpr int kSegments = 10000;
  constexpr std::array kSteps{8, 32, 128};
  std::printf("  largest change of F over a step of 10,000 segments, by steps a segment\n");
  for (const char* name : {"wrapped", "tangle"}) {
    const TrialScene& scene = trialScene(name);
    const Pose pose = spreadPoses(*scene.character, 2).back();
    const PosedField field(scene, pose);
    Random random(11);
    std::array<float, 3> jump{};
    int reached = 0;
    for (int s = 0; s < kSegments; ++s) {
      const glm::vec3 from = field.anywhere(random);
      const glm::vec3 along = 0.1f * scene.character->height * (random.rotation() * glm::vec3(1.0f, 0.0f, 0.0f));
      for (std::size_t k = 0; k < kSteps.size(); ++k) {
        float before = field.at(from);
        for (int i = 1; i <= kSteps[k]; ++i) {
          const float now = field.at(from + along * (static_cast<float>(i) / static_cast<float>(kSteps[k])));
          jump[k] = std::max(jump[k], std::abs(now - before));
          reached += now > 0.0f ? 1 : 0;
          before = now;
        }
      }
    }
    std::printf("  %-8s %d: %.5f   %d: %.5f (x%.2f)   %d: %.5f (x%.2f)\n", name, kSteps[0],
                static_cast<double>(jump[0]), kSteps[1], static_cast<double>(jump[1]),
                static_cast<double>(jump[1] / jump[0]), kSteps[2], static_cast<double>(jump[2]),
                static_cast<double>(jump[2] / jump[1]));
    EXPECT_GT(reached, kSegments);
    // With a quarter of the step, a jump would keep its size; a Lipschitz function's largest change shrinks in
    // proportion.
    EXPECT_LT(jump[1], 0.35f * jump[0]) << name;
    EXPECT_LT(jump[2], 0.35f * jump[1]) << name;
  }
}

}  // namespace
}  // namespace sinew::test
