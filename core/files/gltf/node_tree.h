// core/files/gltf/node_tree.h: the node tree of a glTF file; characters hidden by their alpha.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "core/files/gltf/file.h"
#include "core/files/gltf/glb.h"
#include "sinew/character/character.h"
#include "sinew/character/skeleton.h"

namespace sinew::gltf {

/// Sets Material::shownOpaque with a note if every material in use is hidden, since some converters write alpha 0 by
/// mistake. A material is hidden if its largest alpha (base color * texture * vertex colors) is below its cutoff (MASK)
/// or rounds to 0 (BLEND). A hidden part of a visible character is taken as intended.
void showHiddenCharacter(Character& character, Notes& notes);

/// A node of the file. Matrices are doubles, so that products of many are exact to a float.
struct TreeNode {
  std::string name;
  int parent = -1;
  bool inScene = false;
  LocalTransform rest;
  glm::dmat4 local{1.0};
  glm::dmat4 restInWorld{1.0};
  int mesh = -1;
  int skin = -1;
};

struct NodeTree {
  std::vector<TreeNode> nodes;  ///< As numbered in the file.
  std::vector<int> order;       ///< All nodes, parents before children.

  [[nodiscard]] const TreeNode& operator[](int node) const { return nodes[static_cast<std::size_t>(node)]; }
};

/// Takes the default scene, else every root. Refuses cycles, nodes with two parents, transforms that are not finite.
[[nodiscard]] NodeTree readNodes(const File& file, Notes& notes);

/// Inverse of an affine matrix; nullopt if it is singular or nearly so.
[[nodiscard]] std::optional<glm::dmat4> affineInverse(const glm::dmat4& matrix);
[[nodiscard]] bool isTame(const glm::dmat4& matrix);  ///< Whether every entry, and products of a few, fit a float.

}  // namespace sinew::gltf
