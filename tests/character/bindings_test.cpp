// tests/character/bindings_test.cpp: bones that influence a vertex.
#include "core/character/bindings.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

/// Three vertices; bone 1 is bound twice, as by two skins.
Character threeVertices() {
  Character character;
  character.skeleton.bones.resize(3);
  for (const int bone : {0, 1, 1, 2}) character.skeleton.bindings.push_back({bone, glm::mat4(1.0f)});
  character.mesh.positions.resize(3);
  character.mesh.influences = {{3, 1.0f}, {0, 0.4f}, {1, 0.3f}, {2, 0.3f}, {1, 0.5f}, {3, 0.5f}};
  character.mesh.influenceBegin = {0, 1, 4, 6};
  return character;
}

TEST(VertexBindings, FollowTheOrderOfTheMesh) {
  const Character character = threeVertices();
  std::vector<std::pair<int, float>> seen;
  for (const WeightedBinding& follows : bindingsOf(character, 1)) {
    seen.emplace_back(follows.bone(), follows.weight);
    EXPECT_GE(&follows.binding, character.skeleton.bindings.data()) << "a reference, no copy";
    EXPECT_LT(&follows.binding, character.skeleton.bindings.data() + character.skeleton.bindings.size());
  }
  const std::vector<std::pair<int, float>> expected{{0, 0.4f}, {1, 0.3f}, {1, 0.3f}};
  EXPECT_EQ(seen, expected);
}

TEST(VertexBindings, StrongestIsTheFirstOfEqualWeights) {
  const Character character = threeVertices();
  EXPECT_EQ(strongestBone(character, 0), 2);
  EXPECT_EQ(strongestBone(character, 1), 0) << "bindings are compared, not their sum on a bone";
  EXPECT_EQ(strongestBone(character, 2), 1);
}

}  // namespace
}  // namespace sinew
