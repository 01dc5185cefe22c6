// python/module/errors.cpp: refusals of core as exceptions of Python.
#include "python/module/errors.h"

namespace sinew::python {
namespace {

/// Text of files may be no UTF-8.
pybind11::object textOf(const std::string& text) {
  PyObject* const decoded = PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace");
  if (decoded == nullptr) throw pybind11::error_already_set();
  return pybind11::reinterpret_steal<pybind11::object>(decoded);
}

}  // namespace

void refuse(const Error& error) {
  const pybind11::object type = pybind11::module_::import("sinew._error").attr("Error");
  const pybind11::object made = type(textOf(error.reason), textOf(error.place), textOf(error.file));
  PyErr_SetObject(type.ptr(), made.ptr());
  throw pybind11::error_already_set();
}

void refuse(const std::string& place, const std::string& reason) { refuse(errorAt(place, reason)); }

}  // namespace sinew::python
