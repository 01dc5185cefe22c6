// python/module/exports.h: characters for other programs, written from Python.
#pragma once

#include <pybind11/pybind11.h>

namespace sinew::python {

void defineExports(pybind11::module_& module);

}  // namespace sinew::python
