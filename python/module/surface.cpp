// python/module/surface.cpp: a surface as NumPy arrays over its own memory.
#include "python/module/surface.h"

#include <algorithm>
#include <utility>

#include <pybind11/numpy.h>

#include "core/geometry/at.h"
#include "python/module/arrays.h"
#include "python/module/errors.h"
#include "python/module/values.h"
#include "sinew/files/surface_export.h"

namespace sinew::python {
namespace {

namespace py = pybind11;

constexpr std::size_t kMostIdle = 4;  ///< As many as a loop over frames lets go at once.

const SurfaceHandle& surfaceHandle(const py::object& self) { return self.cast<const SurfaceHandle&>(); }
const Refinement& refinementOf(const py::object& self) { return *surfaceHandle(self).surface().refinement; }

template <class T, class Row>
py::array shared(const std::vector<Row>& rows, const py::object& self) {
  return rowsOf<T>(rows, self);
}

/// Values of refined vertices, one for each drawn vertex. A copy.
py::array drawn(const py::object& self, glm::vec3 (*value)(const Surface& surface, std::size_t drawn)) {
  const Surface& surface = surfaceHandle(self).surface();
  py::array_t<float> made({static_cast<py::ssize_t>(surface.refinement->drawVertex.size()), py::ssize_t{3}});
  auto out = made.mutable_unchecked<2>();
  for (std::size_t i = 0; i < surface.refinement->drawVertex.size(); ++i) {
    const glm::vec3 vector = value(surface, i);
    for (int axis = 0; axis < 3; ++axis) out(static_cast<py::ssize_t>(i), axis) = vector[axis];
  }
  return made;
}

/// Materials of the refined triangles. A copy.
py::array materialsOf(const py::object& self) {
  const Refinement& refinement = refinementOf(self);
  const auto& triangles = surfaceHandle(self).memory->character->mesh.triangles;
  py::array_t<int> made(static_cast<py::ssize_t>(refinement.controlOf.size()));
  auto out = made.mutable_unchecked<1>();
  for (std::size_t i = 0; i < refinement.controlOf.size(); ++i) {
    out(static_cast<py::ssize_t>(i)) = at(triangles, refinement.controlOf[i]).material;
  }
  return made;
}

/// Whoever wrote into the arrays may have written anything.
void checkFinite(const Surface& surface, const std::filesystem::path& file) {
  const auto finite = [](const glm::vec3& v) { return isFinite(v); };
  const auto place = std::ranges::find_if_not(surface.positions, finite);
  if (place != surface.positions.end()) {
    const auto vertex = std::to_string(place - surface.positions.begin());
    refuse({file.string(), "positions[" + vertex + ']', "expected finite numbers"});
  }
  if (!std::ranges::all_of(surface.normals, finite)) refuse({file.string(), "normals", "expected finite numbers"});
}

void save(const SurfaceHandle& handle, const py::object& path) {
  const std::filesystem::path file = pathFrom(path, "path");
  checkFinite(handle.surface(), file);
  const auto written = [&] {
    const py::gil_scoped_release released;
    return exportSurface(handle.surface(), *handle.memory->character, file);
  }();
  valueOrRefuse(written);
}

py::dict reportOf(const SurfaceHandle& handle) {
  const SmoothingReport& report = handle.surface().report;
  py::dict facts;
  facts["mode"] = nameOf(report.mode);
  facts["depth"] = report.depth;
  facts["patch"] = nameOf(report.patch);
  facts["projection"] = nameOf(report.projection);
  facts["control_triangles"] = report.controlTriangles;
  facts["refined_triangles"] = report.refinedTriangles;
  facts["refined_vertices"] = report.refinedVertices;
  facts["implicit"] = report.implicitTriangles;
  facts["straddling"] = report.straddlingTriangles;
  facts["normal"] = report.normalTriangles;
  facts["primitives"] = report.primitives;
  facts["cliques"] = report.cliques;
  facts["guarded"] = report.guarded;
  facts["unwrapped"] = report.unwrapped;
  facts["unresolved"] = report.unresolved;
  facts["residual_max"] = report.residualMax;
  facts["seconds"] = report.seconds.total();
  return facts;
}

}  // namespace

std::shared_ptr<SurfaceMemory> SurfacePool::take(const std::shared_ptr<SurfacePool>& pool,
                                                 const std::shared_ptr<const Character>& character) {
  std::unique_ptr<SurfaceMemory> memory;
  {
    const std::scoped_lock lock(pool->mutex_);
    if (!pool->idle_.empty()) {
      memory = std::move(pool->idle_.back());
      pool->idle_.pop_back();
    }
  }
  if (!memory) memory = std::make_unique<SurfaceMemory>();
  memory->character = character;
  const auto giveBack = [weak = std::weak_ptr(pool)](SurfaceMemory* free) {
    std::unique_ptr<SurfaceMemory> owned(free);
    const std::shared_ptr<SurfacePool> there = weak.lock();
    if (!there) return;
    const std::scoped_lock lock(there->mutex_);
    if (there->idle_.size() < kMostIdle) there->idle_.push_back(std::move(owned));
  };
  return {memory.release(), giveBack};
}

void defineSurface(py::module_& module) {
  const auto array = [](py::array (*make)(const py::object&)) {
    return [make](const py::object& self) { return make(self); };
  };
  py::class_<SurfaceMemory, std::shared_ptr<SurfaceMemory>>(module, "SurfaceMemory");
  py::class_<SurfaceHandle>(module, "Surface")
      .def(py::init([](std::shared_ptr<SurfaceMemory> memory) { return SurfaceHandle{std::move(memory)}; }))
      .def_property_readonly("positions", array([](const py::object& s) {
                               return rowsOf<float>(surfaceHandle(s).surface().positions, s, Access::kWrite);
                             }))
      .def_property_readonly("normals", array([](const py::object& s) {
                               return rowsOf<float>(surfaceHandle(s).surface().normals, s, Access::kWrite);
                             }))
      .def_property_readonly(
          "displacement", array([](const py::object& s) { return listOf(surfaceHandle(s).surface().displacement, s); }))
      .def_property_readonly("triangles",
                             array([](const py::object& s) { return shared<int>(refinementOf(s).triangles, s); }))
      .def_property_readonly("uv", array([](const py::object& s) { return shared<float>(refinementOf(s).drawUv, s); }))
      .def_property_readonly("uv_triangles", array([](const py::object& s) {
                               return shared<std::uint32_t>(refinementOf(s).drawTriangles, s);
                             }))
      .def_property_readonly("uv_vertices",
                             array([](const py::object& s) { return listOf(refinementOf(s).drawVertex, s); }))
      .def_property_readonly("colors",
                             array([](const py::object& s) { return shared<float>(refinementOf(s).drawColor, s); }))
      .def_property_readonly("control_triangles",
                             array([](const py::object& s) { return listOf(refinementOf(s).controlOf, s); }))
      .def_property_readonly("materials", array(materialsOf))
      .def_property_readonly("split_positions", array([](const py::object& s) {
                               return drawn(s, [](const Surface& surface, std::size_t i) {
                                 return at(surface.positions, surface.refinement->drawVertex[i]);
                               });
                             }))
      .def_property_readonly("split_normals", array([](const py::object& s) { return drawn(s, shadingNormal); }))
      .def_property_readonly("report", reportOf)
      .def("_save", save);
}

}  // namespace sinew::python
