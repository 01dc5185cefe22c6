// app/document/muscle_names.cpp: how the history calls what a step changed.

#include "app/document/muscle_names.h"

#include "core/base/at.h"

namespace sinew::app {

std::string namedMuscles(const Rig& rig, std::span<const int> indices) {
  if (indices.size() == 1) return at(rig.primitives, indices.front()).name;
  return std::to_string(indices.size()) + " muscles";
}

}  // namespace sinew::app
