// python/module/errors.h: refusals of core as exceptions of Python.
#pragma once

#include <string>
#include <utility>

#include <pybind11/pybind11.h>

#include "sinew/geometry/result.h"

namespace sinew::python {

/// Throws sinew.Error with the refusal's file, place and reason. Needs the interpreter's lock.
[[noreturn]] void refuse(const Error& error);
/// The same of an argument: `center: expected 3 numbers, got 2`.
[[noreturn]] void refuse(const std::string& place, const std::string& reason);

template <class T>
T valueOrRefuse(Result<T> result) {
  if (!result) refuse(result.error());
  return std::move(result).value();
}

inline void valueOrRefuse(const Result<void>& result) {
  if (!result) refuse(result.error());
}

}  // namespace sinew::python
