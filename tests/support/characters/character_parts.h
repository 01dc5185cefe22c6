// tests/support/characters/character_parts.h: building blocks of characters made in code.
#pragma once

#include <array>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/weld.h"
#include "sinew/character/character.h"

namespace sinew::test {

using Weights = std::vector<std::pair<int, float>>;  // binding, weight > 0; sorted, sum 1.

int addVertex(TriangleSoup& soup, const glm::vec3& position, const glm::vec2& uv, const Weights& weights);
void addTriangle(TriangleSoup& soup, int a, int b, int c);
void addQuad(TriangleSoup& soup, int a, int b, int c, int d);

/// Bone with its joint at `joint` in the bind pose, parents first; node and bone share an index.
void addBone(Skeleton& skeleton, const std::string& name, int parent, const glm::vec3& joint);

/// Rotates a node back and forth between two angles, radians, keys every half second over two seconds.
void swing(AnimationClip& clip, int node, const glm::vec3& axis, float from, float to);

[[nodiscard]] std::shared_ptr<const Character> finish(const std::string& name, const TriangleSoup& soup,
                                                      Skeleton skeleton, AnimationClip clip);

using Cell = std::array<int, 3>;

/// Outer faces of the cells as quads with shared corners, facing outwards.
void boundaryQuads(const std::set<Cell>& cells, std::vector<Cell>& corners, std::vector<std::array<int, 4>>& quads);

/// Pulls every corner towards its neighbors, a few times: boxes become limbs. In cells.
[[nodiscard]] std::vector<glm::vec3> rounded(const std::vector<Cell>& corners,
                                             const std::vector<std::array<int, 4>>& quads);

}  // namespace sinew::test
