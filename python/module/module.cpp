// python/module/module.cpp: the part of the module `sinew` that is C++. The package python/sinew is built on it.
#include <pybind11/pybind11.h>

#include "python/module/character.h"
#include "python/module/exports.h"
#include "python/module/mesh.h"
#include "python/module/rig.h"
#include "python/module/smoother.h"
#include "python/module/surface.h"

PYBIND11_MODULE(_sinew, module) {
  module.doc() = "What sinew is built on. Use sinew.";
  module.attr("version") = SINEW_MODULE_VERSION;
  sinew::python::defineMesh(module);
  sinew::python::defineCharacter(module);
  sinew::python::defineRig(module);
  sinew::python::defineSurface(module);
  sinew::python::defineSmoother(module);
  sinew::python::defineExports(module);
}
