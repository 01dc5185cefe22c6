// tests/runtime/game_file_test.cpp: a written file gives the same surface when read; damaged files are refused.

#include <cstring>

#include <gtest/gtest.h>

#include "core/runtime/game_file.h"
#include "sinew/runtime/game_file.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_animation.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/rigs/trial_scenes.h"

namespace sinew::test {
namespace {

using Bytes = std::vector<std::byte>;

/// Adds a valid checksum, so that the checks after it are exercised.
Bytes withSum(Bytes bytes) {
  gamefile::Head head;
  if (bytes.size() < sizeof head) return bytes;
  std::memcpy(&head, bytes.data(), sizeof head);
  const auto rest = std::span<const std::byte>(bytes).subspan(sizeof head);
  head.bytes = rest.size();
  head.sum = gamefile::sumOf(rest);
  std::memcpy(bytes.data(), &head, sizeof head);
  return bytes;
}

std::string reasonOf(const Bytes& bytes) {
  const auto read = readGameFile(bytes);
  return read ? "" : read.error().text();
}

Surface surfaceOf(const std::shared_ptr<const Character>& character, const Rig& rig, const Pose& pose) {
  Smoother smoother(character);
  const auto prepared = smoother.prepare(rig);
  EXPECT_TRUE(prepared.ok()) << prepared.error().text();
  Surface surface;
  if (prepared) smoother.smooth(pose, surface);
  return surface;
}

void expectSameSurface(const Surface& a, const Surface& b, const std::string& name) {
  ASSERT_FALSE(a.positions.empty()) << name;
  EXPECT_TRUE(a.positions == b.positions) << name;
  EXPECT_TRUE(a.normals == b.normals) << name;
  EXPECT_TRUE(a.shadingNormals == b.shadingNormals) << name;
  EXPECT_TRUE(a.refinement->drawUv == b.refinement->drawUv) << name;
  EXPECT_TRUE(a.refinement->drawColor == b.refinement->drawColor) << name;
  EXPECT_TRUE(a.refinement->drawTriangles == b.refinement->drawTriangles) << name;
}

GameCharacter limbGame() {
  const auto limb = makeLimb();
  return {limb, animatedLimbRig(*limb, 3)};
}

class BundledGameFile : public testing::TestWithParam<const char*> {};

TEST_P(BundledGameFile, GivesTheSameSurfaceBitForBit) {
  const TrialScene scene = bundledTrialScene(GetParam());
  const Bytes bytes = gameFile(*scene.character, scene.rig);
  const auto read = readGameFile(bytes);
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_TRUE(gameFile(*read->character, read->rig) == bytes) << "what was read is not written as it was";
  for (const Pose& pose : spreadPoses(*scene.character, 2)) {
    expectSameSurface(surfaceOf(scene.character, scene.rig, pose), surfaceOf(read->character, read->rig, pose),
                      scene.name);
  }
  ASSERT_EQ(read->character->clips.size(), scene.character->clips.size());
  for (std::size_t c = 0; c < read->character->clips.size(); ++c) {
    const float time = 0.4f * read->character->clips[c].duration;
    EXPECT_EQ(samplePose(read->character->skeleton, read->character->clips[c], time),
              samplePose(scene.character->skeleton, scene.character->clips[c], time));
  }
}

INSTANTIATE_TEST_SUITE_P(Rigs, BundledGameFile,
                         testing::Values("humanoid", "humanoid-wrapped", "horse-flex", "tangle", "demo"));

TEST(GameFile, KeepsAdaptiveDetailCreasesAndEveryAnimatedNumber) {
  GameCharacter game = limbGame();
  game.rig.smoothing.creaseAngle = 30.0f;
  game.rig.surface.grooves = 0.02f;
  for (const DetailKind detail : {DetailKind::kUniform, DetailKind::kAdaptive}) {
    game.rig.smoothing.detail = detail;
    const auto read = readGameFile(gameFile(*game.character, game.rig));
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(read->rig.surface.grooves, 0.02f);
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const Pose pose = randomPose(game.character->skeleton, 1.0f, 0.1f, seed);
      expectSameSurface(surfaceOf(game.character, game.rig, pose), surfaceOf(read->character, read->rig, pose),
                        nameOf(detail));
    }
  }
}

TEST(GameFile, RefusesOtherFilesAndOtherVersions) {
  const GameCharacter game = limbGame();
  Bytes bytes = gameFile(*game.character, game.rig);
  EXPECT_NE(reasonOf({}).find("too short"), std::string::npos);
  Bytes other = bytes;
  other[0] = std::byte{'g'};
  EXPECT_NE(reasonOf(other).find("not a Sinew game file"), std::string::npos) << reasonOf(other);
  other = bytes;
  other[8] = std::byte{1};
  EXPECT_NE(reasonOf(other).find("expected version 4, got 1"), std::string::npos) << reasonOf(other);
  other = bytes;
  other.push_back(std::byte{0});
  EXPECT_NE(reasonOf(other).find("bytes after its head"), std::string::npos) << reasonOf(other);
  EXPECT_NE(reasonOf(withSum(other)).find("expected the end"), std::string::npos) << reasonOf(withSum(other));
  other = bytes;
  other[bytes.size() / 2] ^= std::byte{1};
  EXPECT_NE(reasonOf(other).find("damaged"), std::string::npos) << reasonOf(other);
}

TEST(GameFile, RefusesEveryTruncatedFileOnOneLine) {
  const GameCharacter game = limbGame();
  const Bytes bytes = gameFile(*game.character, game.rig);
  for (std::size_t size = 0; size < bytes.size(); size += size < 200 ? 1 : 37) {
    const std::string reason = reasonOf(withSum(Bytes(bytes.begin(), bytes.begin() + static_cast<long>(size))));
    ASSERT_FALSE(reason.empty()) << size;
    EXPECT_EQ(reason.find('\n'), std::string::npos) << reason;
  }
}

TEST(GameFile, NamesTheInvalidElement) {
  using Break = void (*)(Character&, Rig&);
  const std::pair<const char*, Break> cases[] = {
      {"triangles[2]: expected a vertex of", [](Character& c, Rig&) { c.mesh.triangles[2].vertices[1] = 1 << 20; }},
      {"triangles[2]: expected a wedge of", [](Character& c, Rig&) { c.mesh.triangles[2].wedges[1] = -1; }},
      {"triangles[2]: it has a vertex twice",
       [](Character& c, Rig&) {
         c.mesh.triangles[2].vertices[1] = c.mesh.triangles[2].vertices[0];
         c.mesh.triangles[2].wedges[1] = c.mesh.triangles[2].wedges[0];
       }},
      {"triangles[0]: expected a material of", [](Character& c, Rig&) { c.mesh.triangles[0].material = 7; }},
      {"triangles[0]: expected a part of", [](Character& c, Rig&) { c.mesh.triangles[0].part = 7; }},
      {"vertices[0]: expected a binding of", [](Character& c, Rig&) { c.mesh.influences[0].binding = 9999; }},
      {"vertices[0]: the weights do not sum to 1", [](Character& c, Rig&) { c.mesh.influences[0].weight = 3.0f; }},
      {"vertices[1]: it lies too far away", [](Character& c, Rig&) { c.mesh.positions[1].x = 1e20f; }},
      {"a number is not finite", [](Character& c, Rig&) { c.mesh.positions[1].x = std::nanf(""); }},
      {"influences: they do not match the vertices", [](Character& c, Rig&) { c.mesh.influenceBegin.pop_back(); }},
      {"bones[1]: expected a node of", [](Character& c, Rig&) { c.skeleton.bones[1].node = 500; }},
      {"nodes[1]: its parent must come before it", [](Character& c, Rig&) { c.skeleton.nodes[1].parent = 1; }},
      {"bones[0]: its bind matrix has no inverse",
       [](Character& c, Rig&) { c.skeleton.bones[0].bindInWorld[0] = glm::vec4(0.0f); }},
      {"height: expected a number > 0", [](Character& c, Rig&) { c.height = 0.0f; }},
      {"clips[0]: expected a morph target of",
       [](Character& c, Rig&) {
         c.morphTargets.resize(2);
         MorphChannel channel{1, 2, Interpolation::kLinear, {0.0f}, {0.0f, 0.0f}};
         c.clips.resize(1);
         c.clips[0].morphChannels = {channel};
       }},
      {"materials: expected at least one", [](Character& c, Rig&) { c.materials.clear(); }},
      {"primitives[0].radii", [](Character&, Rig& r) { r.primitives[0].placement.radii.x = -1.0f; }},
      {"smoothing.depth", [](Character&, Rig& r) { r.smoothing.depth = 99; }},
  };
  for (const auto& [words, breakIt] : cases) {
    const GameCharacter game = limbGame();
    Character character = *game.character;
    Rig rig = game.rig;
    breakIt(character, rig);
    const std::string reason = reasonOf(gameFile(character, rig));
    EXPECT_NE(reason.find(words), std::string::npos) << words << "\n" << reason;
    EXPECT_EQ(reason.find('\n'), std::string::npos);
  }
}

TEST(GameFile, CorruptedBytesAreSafe) {
  GameCharacter game = limbGame();
  game.rig.smoothing.depth = 1;
  const Bytes bytes = gameFile(*game.character, game.rig);
  Random random(7);
  int accepted = 0;
  for (int round = 0; round < 3000; ++round) {
    Bytes broken = bytes;
    for (int k = 0; k <= random.below(3); ++k) {
      const std::size_t place = sizeof(gamefile::Head) + random.next() % (bytes.size() - sizeof(gamefile::Head));
      broken[place] = static_cast<std::byte>(random.chance(0.3f) ? 0xff : random.below(256));
    }
    const auto read = readGameFile(withSum(std::move(broken)));
    if (!read) {
      ASSERT_FALSE(read.error().reason.empty());
      continue;
    }
    ++accepted;
    if (accepted % 10 != 0) continue;
    Smoother smoother(read->character);
    if (!smoother.prepare(read->rig)) continue;
    Surface surface;
    smoother.smooth(bindPose(read->character->skeleton), surface);
  }
  EXPECT_GT(accepted, 100);
}

}  // namespace
}  // namespace sinew::test
