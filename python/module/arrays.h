// python/module/arrays.h: memory of core as NumPy arrays, without a copy.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <pybind11/numpy.h>

#include "sinew/geometry/geometry.h"

namespace sinew::python {

enum class Access { kRead, kWrite };

/// An array over memory that `owner` holds; the array keeps the owner alive. NumPy takes no reference to nothing, so an
/// empty list is an empty array of its own.
/// @param strides  bytes  @param data  null where nothing is there
template <class T>
pybind11::array viewOf(const T* data, std::vector<pybind11::ssize_t> shape, std::vector<pybind11::ssize_t> strides,
                       pybind11::handle owner, Access access) {
  if (data == nullptr || shape.front() == 0) return pybind11::array_t<T>(std::move(shape));
  pybind11::array view(pybind11::dtype::of<T>(), std::move(shape), std::move(strides), data, owner);
  if (access == Access::kRead) view.attr("flags").attr("writeable") = false;
  return view;
}

/// [N, width] over numbers that lie close together: vectors of glm, arrays of three.
template <class T, class Row>
pybind11::array rowsOf(const std::vector<Row>& rows, pybind11::handle owner, Access access = Access::kRead) {
  static_assert(sizeof(Row) % sizeof(T) == 0);
  constexpr auto kWidth = static_cast<pybind11::ssize_t>(sizeof(Row) / sizeof(T));
  return viewOf<T>(reinterpret_cast<const T*>(rows.data()), {static_cast<pybind11::ssize_t>(rows.size()), kWidth},
                   {static_cast<pybind11::ssize_t>(sizeof(Row)), static_cast<pybind11::ssize_t>(sizeof(T))}, owner,
                   access);
}

/// [N] over a list of numbers.
template <class T>
pybind11::array listOf(const std::vector<T>& list, pybind11::handle owner, Access access = Access::kRead) {
  return viewOf<T>(list.data(), {static_cast<pybind11::ssize_t>(list.size())},
                   {static_cast<pybind11::ssize_t>(sizeof(T))}, owner, access);
}

/// [N, ...] over one member of each element of a list. @param member  of the first element; null where there is none
template <class T, class Element>
pybind11::array membersOf(const std::vector<Element>& list, const T* member, pybind11::ssize_t width,
                          pybind11::handle owner) {
  return viewOf<T>(member, {static_cast<pybind11::ssize_t>(list.size()), width},
                   {static_cast<pybind11::ssize_t>(sizeof(Element)), static_cast<pybind11::ssize_t>(sizeof(T))}, owner,
                   Access::kRead);
}

/// [bones, 4, 4] as matrices that multiply columns; a copy.
[[nodiscard]] inline pybind11::array matricesOf(const std::vector<glm::mat4>& matrices) {
  pybind11::array_t<float> made(
      {static_cast<pybind11::ssize_t>(matrices.size()), pybind11::ssize_t{4}, pybind11::ssize_t{4}});
  auto numbers = made.mutable_unchecked<3>();
  for (std::size_t i = 0; i < matrices.size(); ++i) {
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) {
        numbers(static_cast<pybind11::ssize_t>(i), row, column) = matrices[i][column][row];
      }
    }
  }
  return made;
}

}  // namespace sinew::python
