// core/files/gltf/node_tree.h: the node tree of a glTF file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "core/files/gltf/file.h"
#include "core/files/gltf/refusal.h"
#include "sinew/character/character.h"
#include "sinew/character/skeleton.h"

namespace sinew::gltf {

// Characters that would be invisible because of their alpha.

/// Some converters write alpha 0 by mistake. A material is hidden if the largest alpha it can have (base color's *
/// texture's * vertex colors') is below its cutoff (MASK) or rounds to 0 (BLEND). A hidden part of a visible character
/// is taken as intended. If every material in use is hidden, all of them become Material::shownOpaque, each with a
/// note.
void showHiddenCharacter(Character& character, Notes& notes);

/// One node as the file gives it. Matrices in double, so that products of many of them stay exact to a float.
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

/// Refuses cycles, nodes with two parents, and transforms that are not finite. The default scene counts; without any
/// scene every root does.
[[nodiscard]] NodeTree readNodes(const File& file, Notes& notes);

/// Inverse of an affine matrix; nullopt where it is singular, or so near to it that floats could not hold it.
[[nodiscard]] std::optional<glm::dmat4> affineInverse(const glm::dmat4& matrix);
/// Whether every entry fits a float with room for a few products.
[[nodiscard]] bool isTame(const glm::dmat4& matrix);

}  // namespace sinew::gltf
