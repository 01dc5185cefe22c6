// core/character/bindings.h: which bones a vertex follows.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/character/pose.h"

namespace sinew {

[[nodiscard]] std::vector<bool> bonesWithSkin(const Character& character);  ///< [bones] Skin follows the bone.

/// [bones] No skin follows the bone or any below it (core/character/joint_roles.h).
[[nodiscard]] std::vector<bool> helperBones(const Character& character);

/// One bone that a vertex follows. A bone may occur twice if two skins bind it differently.
struct WeightedBinding {
  const Binding& binding;
  float weight = 0.0f;

  [[nodiscard]] int bone() const { return binding.bone; }
};

/// A range of WeightedBinding. <ranges> would be shorter, but clang 14 cannot compile the views of g++ 12.
struct BindingRange {
  struct Iterator {
    const Influence* influence = nullptr;
    const Binding* bindings = nullptr;

    WeightedBinding operator*() const {
      return {bindings[static_cast<std::size_t>(influence->binding)], influence->weight};
    }
    Iterator& operator++() {
      ++influence;
      return *this;
    }
    friend bool operator==(const Iterator&, const Iterator&) = default;
  };

  std::span<const Influence> influences;
  const Binding* bindings = nullptr;

  [[nodiscard]] Iterator begin() const { return {influences.data(), bindings}; }
  [[nodiscard]] Iterator end() const { return {influences.data() + influences.size(), bindings}; }
};

/// The bindings of one vertex with its weights, in the order of the mesh.
[[nodiscard]] inline BindingRange bindingsOf(const Character& character, int vertex) {
  return {character.mesh.influencesOf(vertex), character.skeleton.bindings.data()};
}

/// The bone of the binding with the largest weight, the first of equal ones.
[[nodiscard]] inline int strongestBone(const Character& character, int vertex) {
  const auto influences = character.mesh.influencesOf(vertex);
  const auto strongest = std::ranges::max_element(influences, {}, &Influence::weight);
  return character.skeleton.bindings[static_cast<std::size_t>(strongest->binding)].bone;
}

/// Takes a vertex from the bind pose to a pose: the weighted sum of its bindings' matrices.
[[nodiscard]] inline glm::mat4 skinMatrix(const Character& character, const Pose& pose, int vertex) {
  glm::mat4 sum(0.0f);
  for (const WeightedBinding& follows : bindingsOf(character, vertex)) {
    const glm::mat4& bone = pose.boneInWorld[static_cast<std::size_t>(follows.bone())];
    const glm::mat4& inverse = follows.binding.inverseBind;
    // By columns: products of whole matrices are not always inlined and then take most of the time.
    for (glm::length_t c = 0; c < 4; ++c) {
      const glm::vec4& way = inverse[c];
      sum[c] += follows.weight * (bone[0] * way.x + bone[1] * way.y + bone[2] * way.z + bone[3] * way.w);
    }
  }
  return sum;
}

}  // namespace sinew
