// core/include/sinew/character/skeleton.h: the node tree, its bones and what binds the skin to them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sinew/geometry/geometry.h"

namespace sinew {

/// Local transform of a node, relative to its parent: kept as the file gives it, never decomposed from a matrix.
struct LocalTransform {
  glm::vec3 translation{0.0f};
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};  ///< Unit.
  glm::vec3 scale{1.0f};
  std::optional<glm::mat4> matrix;  ///< If the file gave a matrix; then the three above do not count.

  [[nodiscard]] glm::mat4 toMatrix() const;
};

/// A node of the scene tree that moves a bone: the bone's own, or one above it.
struct Node {
  std::string name;
  int parent = -1;  ///< Index < own index, or -1.
  LocalTransform rest;
};

/// A joint of the skin. Bone space = the joint's local frame.
struct Bone {
  std::string name;  ///< As files name it, or "joint N". Need not be unique.
  std::string path;  ///< Names from the root joint, "/" between; unique.
  int node = 0;
  int parent = -1;                     ///< Nearest joint ancestor, index < own index, or -1.
  std::vector<int> children;           ///< Nearest joint children.
  glm::mat4 bindInWorld{1.0f};         ///< Bone -> world in the bind pose (docs/design.md).
  glm::mat4 inverseBindInWorld{1.0f};  ///< Its inverse.
  glm::vec3 tip{0.0f};                 ///< Bone space: where the bone's segment ends, see finishBones.
};

/// What a vertex follows: `bone` in its pose, after `inverseBind` took the bind position into that bone's space.
/// Usually one per bone; more where two skins bind the same joint differently.
struct Binding {
  int bone = 0;
  glm::mat4 inverseBind{1.0f};  ///< Bind position in world -> bone space.
};

struct Skeleton {
  std::vector<Node> nodes;  ///< Parents before children.
  std::vector<Bone> bones;  ///< Parents before children.
  std::vector<Binding> bindings;

  /// By path, or by name where the name is unique; nullopt if there is none or several. docs/formats.md.
  [[nodiscard]] std::optional<int> findBone(std::string_view nameOrPath) const;
  /// What a rig file calls this bone: the name where unique, else the path.
  [[nodiscard]] const std::string& fileName(int bone) const;
};

/// Fills path, children, inverseBindInWorld and tip from name, node, parent and bindInWorld. The tip is the mean of the
/// children's origins in the bind pose; a bone without children goes on in its parent's direction, half as long.
void finishBones(Skeleton& skeleton);

}  // namespace sinew
