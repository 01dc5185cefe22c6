// python/module/smoother.h: the pipeline as Python calls it, from any of its threads.
#pragma once

#include <pybind11/pybind11.h>

namespace sinew::python {

void defineSmoother(pybind11::module_& module);

}  // namespace sinew::python
