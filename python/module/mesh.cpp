// python/module/mesh.cpp: the mesh of a character as NumPy arrays over its own memory, read only.
#include "python/module/mesh.h"

#include <cstddef>

#include <pybind11/numpy.h>

#include "python/module/arrays.h"

namespace sinew::python {
namespace {

namespace py = pybind11;

const MeshHandle& meshHandle(const py::object& self) { return self.cast<const MeshHandle&>(); }

/// One member of every element, as [N, width].
template <class T, class Element, class Member>
py::array column(const std::vector<Element>& list, Member Element::*member, const py::object& owner) {
  const T* const first = list.empty() ? nullptr : reinterpret_cast<const T*>(&(list.front().*member));
  return membersOf<T>(list, first, static_cast<py::ssize_t>(sizeof(Member) / sizeof(T)), owner);
}

/// The same as [N].
template <class Element, class T>
py::array flatColumn(const std::vector<Element>& list, T Element::*member, const py::object& owner) {
  const T* const first = list.empty() ? nullptr : &(list.front().*member);
  return viewOf<T>(first, {static_cast<py::ssize_t>(list.size())}, {static_cast<py::ssize_t>(sizeof(Element))}, owner,
                   Access::kRead);
}

/// [influences] bones: bindings are several where skins bind a joint in different ways. A copy.
py::array influenceBones(const py::object& self) {
  const Character& character = *meshHandle(self).character;
  py::array_t<int> bones(static_cast<py::ssize_t>(character.mesh.influences.size()));
  auto out = bones.mutable_unchecked<1>();
  for (std::size_t i = 0; i < character.mesh.influences.size(); ++i) {
    const auto binding = static_cast<std::size_t>(character.mesh.influences[i].binding);
    out(static_cast<py::ssize_t>(i)) = character.skeleton.bindings[binding].bone;
  }
  return bones;
}

}  // namespace

void defineMesh(py::module_& module) {
  const auto array = [](py::array (*make)(const py::object&)) {
    return [make](const py::object& self) { return make(self); };
  };
  py::class_<MeshHandle>(module, "Mesh")
      .def_property_readonly(
          "positions", array([](const py::object& s) { return rowsOf<float>(meshHandle(s).mesh().positions, s); }))
      .def_property_readonly("normals",
                             array([](const py::object& s) { return rowsOf<float>(meshHandle(s).mesh().normals, s); }))
      .def_property_readonly("triangles", array([](const py::object& s) {
                               return column<int>(meshHandle(s).mesh().triangles, &ControlTriangle::vertices, s);
                             }))
      .def_property_readonly("uv_triangles", array([](const py::object& s) {
                               return column<int>(meshHandle(s).mesh().triangles, &ControlTriangle::wedges, s);
                             }))
      .def_property_readonly("materials", array([](const py::object& s) {
                               return flatColumn(meshHandle(s).mesh().triangles, &ControlTriangle::material, s);
                             }))
      .def_property_readonly(
          "uv", array([](const py::object& s) { return column<float>(meshHandle(s).mesh().wedges, &Wedge::uv, s); }))
      .def_property_readonly("influence_begin",
                             array([](const py::object& s) { return listOf(meshHandle(s).mesh().influenceBegin, s); }))
      .def_property_readonly("influence_bones", array(influenceBones))
      .def_property_readonly("influence_weights", array([](const py::object& s) {
                               return flatColumn(meshHandle(s).mesh().influences, &Influence::weight, s);
                             }));
}

}  // namespace sinew::python
