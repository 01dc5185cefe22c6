// python/module/mesh.h: the mesh of a character as NumPy arrays over its own memory.
#pragma once

#include <memory>

#include <pybind11/pybind11.h>

#include "sinew/character/character.h"

namespace sinew::python {

/// Keeps the character; arrays keep the handle.
struct MeshHandle {
  std::shared_ptr<const Character> character;

  [[nodiscard]] const ControlMesh& mesh() const { return character->mesh; }
};

void defineMesh(pybind11::module_& module);

}  // namespace sinew::python
