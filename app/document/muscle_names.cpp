// app/document/muscle_names.cpp: how the history calls what a step changed.

#include "app/document/muscle_names.h"

namespace sinew::app {

std::string namedMuscles(const Rig& rig, std::span<const int> indices) {
  if (indices.size() == 1) return rig.primitives[static_cast<std::size_t>(indices.front())].name;
  return std::to_string(indices.size()) + " muscles";
}

}  // namespace sinew::app
