// tests/surface/level_changes_test.cpp: an edit reevaluates levels wherever it has an effect, and nowhere else; part of
// a mesh gets the whole's levels.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/geometry/at.h"
#include "core/surface/adaptive_levels.h"
#include "core/surface/patches/sample_points.h"
#include "core/surface/sampling.h"
#include "sinew/geometry/threads.h"
#include "tests/support/characters/body_with_arms.h"
#include "tests/support/characters/stand_ins.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/long_run.h"
#include "tests/support/rigs/random_animation.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/rigs/trial_scenes.h"

namespace sinew::test {
namespace {

using CharacterPtr = std::shared_ptr<const Character>;
using PreparationPtr = std::shared_ptr<const Preparation>;

struct Preparer {
  std::shared_ptr<const CharacterTables> tables;
  BlendingGraphMemo graphs{};

  explicit Preparer(const CharacterPtr& character) : tables(characterTables(character)) {}
  PreparationPtr operator()(const Rig& rig, const Preparation* former = nullptr, std::span<const int> hidden = {}) {
    return prepare(tables, rig, {.hidden = hidden}, former, graphs).value();
  }
};

/// Random edit of one muscle by a drag, a number field or a visibility switch.
Rig edited(Rig rig, Random& random) {
  Primitive& primitive = at(rig.primitives, random.below(static_cast<int>(rig.primitives.size())));
  switch (random.below(6)) {
    case 0:
      primitive.placement.radii *= random.uniform(0.6f, 1.6f);
      break;
    case 1:
      primitive.placement.center += 0.4f * random.uniform(-1.0f, 1.0f) * primitive.placement.radii;
      break;
    case 2:
      primitive.reach = random.uniform(1.2f, 2.0f);
      break;
    case 3:
      primitive.sign = -primitive.sign;
      break;
    case 4:
      primitive.amount = random.uniform(0.4f, 1.0f);
      break;
    default:
      primitive.placement.rotation = random.rotation();
      break;
  }
  return rig;
}

/// Samples of every edge and triangle, with the carrier of each.
struct AllSamples {
  SampledPart part;
  SurfaceSampler sampler;

  explicit AllSamples(const Preparation& next) : part(sampledPart(next, all(next))), sampler(part, points(next)) {}

  static SampledPiece all(const Preparation& next) {
    SampledPiece out;
    for (std::size_t t = 0; t < next.mesh().triangles.size(); ++t) out.push_back(static_cast<int>(t));
    return out;
  }
  static Refinement points(const Preparation& next) {
    return samplePoints(next.mesh(), {std::vector<std::uint8_t>(next.mesh().edges.size(), 4),
                                      std::vector<std::uint8_t>(next.mesh().triangles.size(), 4)});
  }
  const Surface& sample(const Pose& pose) { return sampler.sample(pose, part.asked); }
};

int carrierOf(const Refinement& points, int vertex) {
  if (vertex < points.controlVertices) return vertex;
  const auto pieceOf = [&](const std::vector<int>& begin) {
    return static_cast<int>(std::ranges::upper_bound(begin, vertex) - begin.begin()) - 1;
  };
  if (vertex < points.insideBegin.front()) return points.controlVertices + pieceOf(points.edgeBegin);
  return points.controlVertices + points.controlEdges + pieceOf(points.insideBegin);
}

TEST(LevelChanges, EveryChangedSampleIsReevaluated) {
  Random random(5);
  std::size_t changed = 0;
  std::size_t looked = 0;
  std::size_t carriers = 0;
  for (const CharacterPtr& character : {makeLimb(), makeTube(), makeBodyWithArms(), makeTwoLegged()}) {
    Preparer prepared(character);
    for (std::uint64_t seed = 0; seed < (longRun() ? 12u : 6u); ++seed) {
      Rig rig = randomRig(*character, {.primitives = 6, .shapedChance = 0.3f, .reachHigh = 1.6f}, seed);
      rig.smoothing.detail = DetailKind::kAdaptive;
      if (seed % 3 == 1) rig.smoothing.patch = PatchKind::kPhong;
      if (seed % 6 == 5) rig.smoothing.patch = PatchKind::kFlat;
      const Rig after = edited(rig, random);
      std::vector<int> hidden;
      if (seed % 4 == 3) hidden.push_back(random.below(6));
      const PreparationPtr first = prepared(rig);
      const PreparationPtr second = prepared(after, first.get(), hidden);
      const LevelSources& sources = second->detail->from;
      const std::vector<bool> asked = carriersToLookAt(*second, sources, &first->detail->from);
      carriers += asked.size();
      looked += static_cast<std::size_t>(std::ranges::count(asked, true));
      AllSamples before(*first);
      AllSamples now(*second);
      for (const Pose& pose : sources.poses) {
        const Surface& a = before.sample(pose);
        const Surface& b = now.sample(pose);
        for (int v = 0; v < b.refinement->vertexCount; ++v) {
          if (at(a.positions, v) == at(b.positions, v) && at(a.normals, v) == at(b.normals, v)) continue;
          ++changed;
          ASSERT_TRUE(asked[toIndex(carrierOf(*b.refinement, v))]) << "seed " << seed << ", sample " << v;
        }
      }
    }
  }
  EXPECT_GT(changed, 1000u);
  EXPECT_LT(looked, carriers * 2 / 3) << "and little besides";
}

TEST(LevelChanges, LevelsAfterAnEditMatchAFreshStart) {
  Random random(11);
  for (const char* name : {"humanoid-flex", "horse"}) {
    const TrialScene scene = bundledTrialScene(name);
    Preparer prepared(scene.character);
    Rig rig = scene.rig;
    rig.smoothing.detail = DetailKind::kAdaptive;
    rig.smoothing.tolerance = 0.002f;
    PreparationPtr former = prepared(rig);
    for (int edit = 0; edit < 6; ++edit) {
      rig = edited(rig, random);
      if (edit == 4 && !rig.lines.empty()) rig.lines.front().origin.point += 0.01f * scene.character->height;
      const std::vector<int> hidden = edit == 2 ? std::vector<int>{1} : std::vector<int>{};
      former = prepared(rig, former.get(), hidden);
      const PreparationPtr fresh = prepared(rig, nullptr, hidden);
      ASSERT_EQ(former->detail->needed, fresh->detail->needed) << name << ", edit " << edit;
      ASSERT_EQ(former->detail->posesOf, fresh->detail->posesOf) << name << ", edit " << edit;
      ASSERT_EQ(former->detail->levels, fresh->detail->levels) << name << ", edit " << edit;
      ASSERT_EQ(former->detail->splits, fresh->detail->splits) << name << ", edit " << edit;
      ASSERT_EQ(former->refinement().triangles, fresh->refinement().triangles);
      ASSERT_EQ(former->refinement().inside, fresh->refinement().inside);
    }
  }
}

TEST(LevelChanges, WidthsOfTheSurfaceAffectAllSamples) {
  const CharacterPtr character = makeLimb();
  Preparer prepared(character);
  Rig rig = randomRig(*character, {.primitives = 2}, 1);
  rig.smoothing.detail = DetailKind::kAdaptive;
  const PreparationPtr first = prepared(rig);
  for (float SurfaceSettings::*const width : {&SurfaceSettings::skinBlend, &SurfaceSettings::grooves}) {
    Rig after = rig;
    after.surface.*width += 0.01f;
    const PreparationPtr second = prepared(after, first.get());
    const std::vector<bool> asked = carriersToLookAt(*second, second->detail->from, &first->detail->from);
    EXPECT_EQ(std::ranges::count(asked, false), 0);
  }
}

// Pieces hold about a thousand triangles, ranges a thousand vertices: only a fine mesh has several.
TEST(LevelChanges, LevelsDoNotDependOnThreads) {
  const CharacterPtr character = fineHumanoid();
  Rig rig = randomRig(*character, {.primitives = 4}, 3);
  rig.smoothing.detail = DetailKind::kAdaptive;
  Rig after = rig;
  after.primitives.front().placement.radii *= 1.4f;
  std::vector<PreparationPtr> found;
  for (const int threads : {1, 0}) {
    const ThreadLimit limit(threads);
    Preparer prepared(character);
    found.push_back(prepared(rig));
    found.push_back(prepared(after, found.back().get()));
  }
  const ControlMesh& mesh = found.front()->mesh();
  const auto pieces = sampledPieces(*found.front(), std::vector<std::uint8_t>(mesh.triangles.size(), 1));
  EXPECT_GT(pieces.size(), 8u);
  EXPECT_NE(found[0]->detail->needed, found[1]->detail->needed);
  for (const std::size_t i : {0u, 1u}) {
    ASSERT_EQ(found[i]->detail->needed, found[i + 2]->detail->needed);
    ASSERT_EQ(found[i]->detail->levels, found[i + 2]->detail->levels);
    ASSERT_EQ(found[i]->refinement().triangles, found[i + 2]->refinement().triangles);
  }
}

TEST(LevelChanges, PartialMeshMatchesTheWhole) {
  const TrialScene scene = bundledTrialScene("tangle");
  Preparer prepared(scene.character);
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    const PreparationPtr whole = prepared(withMode(scene.rig, mode));
    AllSamples all(*whole);
    SampledPiece piece;
    for (int t = 3; t < static_cast<int>(whole->mesh().triangles.size()); t += 11) piece.push_back(t);
    const SampledPart part = sampledPart(*whole, piece);
    const ControlMesh& mesh = part.mesh();
    RefinementLevels levels{std::vector<std::uint8_t>(part.edges.size(), 0),
                            std::vector<std::uint8_t>(part.triangles.size(), 0)};
    for (const int t : part.asked) {
      at(levels.triangles, t) = 4;
      for (const int e : at(mesh.triangles, t).edges) at(levels.edges, e) = 4;
    }
    SurfaceSampler sampler(part, samplePoints(mesh, levels));
    int moved = 0;
    for (const Pose& pose : spreadPoses(*scene.character, 3)) {
      const Surface& a = sampler.sample(pose, part.asked);
      const Surface& b = all.sample(pose);
      const auto expectSame = [&](int own, int other) {
        EXPECT_EQ(at(a.positions, own), at(b.positions, other));
        EXPECT_EQ(at(a.normals, own), at(b.normals, other));
        moved += at(a.displacement, own) != 0.0f ? 1 : 0;
      };
      for (const int t : part.asked) {
        for (const int e : at(mesh.triangles, t).edges) {
          for (int step = 1; step < 4; ++step) {
            expectSame(a.refinement->edgeVertex(e, step), b.refinement->edgeVertex(at(part.edges, e), step));
          }
        }
        for (int i = 0; i < a.refinement->insideVertices(t); ++i) {
          expectSame(at(a.refinement->insideBegin, t) + i, at(b.refinement->insideBegin, at(part.triangles, t)) + i);
        }
      }
    }
    EXPECT_GT(moved, 100);
  }
}

}  // namespace
}  // namespace sinew::test
