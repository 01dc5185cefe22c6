// core/include/sinew/character/skeleton.h: the node tree, its bones and bindings.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sinew/geometry/geometry.h"

namespace sinew {

/// Local transform of a node relative to its parent, as in the file; matrices are not decomposed.
struct LocalTransform {
  glm::vec3 translation{0.0f};
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};  ///< Unit.
  glm::vec3 scale{1.0f};
  std::optional<glm::mat4> matrix;  ///< If in the file; replaces the members above.

  [[nodiscard]] glm::mat4 toMatrix() const;
};

/// A node of the scene: that of a bone, or one above it.
struct Node {
  std::string name;
  int parent = -1;  ///< Index < own index, or -1.
  LocalTransform rest;
};

/// A joint of the skin. Bone space = the joint's local frame.
struct Bone {
  std::string name;  ///< Name in the file, or "joint N". Need not be unique.
  std::string path;  ///< Names from the root joint, separated by "/"; unique.
  int node = 0;
  int parent = -1;                     ///< Nearest joint ancestor, index < own index, or -1.
  std::vector<int> children;           ///< Nearest joint children.
  glm::mat4 bindInWorld{1.0f};         ///< Bone -> world in the bind pose (docs/design.md).
  glm::mat4 inverseBindInWorld{1.0f};  ///< Its inverse.
  glm::vec3 tip{0.0f};                 ///< Bone space: end of the bone's segment, see finishBones.
};

/// Binds vertices to a bone. Usually one per bone; more if two skins bind the same joint differently.
struct Binding {
  int bone = 0;
  glm::mat4 inverseBind{1.0f};  ///< Bind position in world -> bone space.
};

struct Skeleton {
  std::vector<Node> nodes;  ///< Parents before children.
  std::vector<Bone> bones;  ///< Parents before children.
  std::vector<Binding> bindings;

  /// By path, or by name if it is unique; nullopt: none or several. docs/formats.md.
  [[nodiscard]] std::optional<int> findBone(std::string_view nameOrPath) const;
  /// The bone in rig files: its name if unique, else its path.
  [[nodiscard]] const std::string& fileName(int bone) const;
};

/// Fills path, children, inverseBindInWorld and tip from name, node, parent and bindInWorld. The tip is the mean of the
/// children's origins in the bind pose; a bone without children has its parent's direction and half its length.
void finishBones(Skeleton& skeleton);

}  // namespace sinew
