// core/character/bindings.h: which bones a vertex follows.
#pragma once

#include <algorithm>
#include <cstddef>
#include <ranges>

#include "sinew/character/character.h"

namespace sinew {

/// One bone that a vertex follows. A bone may come twice, if two skins bind it differently.
struct WeightedBinding {
  const Binding& binding;
  float weight = 0.0f;

  [[nodiscard]] int bone() const { return binding.bone; }
};

/// The bindings of one vertex with its weights, in the order of the mesh. The character must outlive the use.
[[nodiscard]] inline auto bindingsOf(const Character& character, int vertex) {
  return character.mesh.influencesOf(vertex) |
         std::views::transform([&bindings = character.skeleton.bindings](const Influence& influence) {
           return WeightedBinding{bindings[static_cast<std::size_t>(influence.binding)], influence.weight};
         });
}

/// The bone of the binding with the most weight, the first of equals.
[[nodiscard]] inline int strongestBone(const Character& character, int vertex) {
  const auto influences = character.mesh.influencesOf(vertex);
  const auto strongest = std::ranges::max_element(influences, {}, &Influence::weight);
  return character.skeleton.bindings[static_cast<std::size_t>(strongest->binding)].bone;
}

}  // namespace sinew
