// python/module/rig_fields.cpp: the tables of fields.
#include "python/module/rig_fields.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <vector>

#include <pybind11/stl.h>

#include "core/geometry/nearest_name.h"
#include "python/module/errors.h"
#include "python/module/values.h"

namespace sinew::python {
namespace {

namespace py = pybind11;

py::tuple tupleOf(const glm::vec3& v) { return py::make_tuple(v.x, v.y, v.z); }
py::tuple tupleOf(const glm::vec2& v) { return py::make_tuple(v.x, v.y); }

py::object tupleOf(const LineAnchor& anchor) { return py::make_tuple(anchor.bone, tupleOf(anchor.point)); }

glm::vec2 pairFrom(py::handle value, const std::string& place) {
  const std::vector<float> numbers = numbersFrom(value, 2, place);
  return {numbers[0], numbers[1]};
}

/// A setting that is one of several words.
template <class Kind>
Kind wordFrom(py::handle value, const std::string& place, std::optional<Kind> (*kindNamed)(const std::string&),
              const std::vector<std::string>& words) {
  const std::string word = textFrom(value, place);
  const auto kind = kindNamed(word);
  if (!kind) refuse(place, "expected " + listed(words, "or") + ", got \"" + word + '"');
  return *kind;
}

template <class Owner, std::size_t count>
const Field<Owner>* fieldNamed(const Field<Owner> (&fields)[count], const std::string& name) {
  const auto* const found = std::ranges::find(fields, std::string_view(name),
                                              [](const Field<Owner>& field) { return std::string_view(field.name); });
  return found == std::end(fields) ? nullptr : found;
}

py::object territoryOf(const Primitive& muscle) {
  if (!muscle.territory) return py::none();
  return py::tuple(py::cast(*muscle.territory));
}

void setTerritory(Primitive& muscle, py::handle value, const std::string& place) {
  muscle.territory.reset();
  if (!value.is_none()) muscle.territory = textsFrom(value, place);
}

void setSign(Primitive& muscle, py::handle value, const std::string& place) {
  const int sign = integerFrom(value, place);
  if (sign != 1 && sign != -1)
    refuse(place, "expected 1, which adds, or -1, which carves, got " + std::to_string(sign));
  muscle.sign = sign;
}

const Field<Primitive> kMuscleFields[] = {
    {"center", [](const Primitive& m) -> py::object { return tupleOf(m.placement.center); },
     [](Primitive& m, py::handle v, const std::string& place) { m.placement.center = vectorFrom(v, place); }},
    {"radii", [](const Primitive& m) -> py::object { return tupleOf(m.placement.radii); },
     [](Primitive& m, py::handle v, const std::string& place) { m.placement.radii = vectorFrom(v, place); }},
    {"rotation",
     [](const Primitive& m) -> py::object {
       const glm::quat& q = m.placement.rotation;
       return py::make_tuple(q.x, q.y, q.z, q.w);
     },
     [](Primitive& m, py::handle v, const std::string& place) { m.placement.rotation = rotationFrom(v, place); }},
    {"core", [](const Primitive& m) -> py::object { return py::float_(m.placement.shape.core); },
     [](Primitive& m, py::handle v, const std::string& place) { m.placement.shape.core = numberFrom(v, place); }},
    {"belly", [](const Primitive& m) -> py::object { return py::float_(m.placement.shape.belly); },
     [](Primitive& m, py::handle v, const std::string& place) { m.placement.shape.belly = numberFrom(v, place); }},
    {"bend", [](const Primitive& m) -> py::object { return tupleOf(m.placement.shape.bend); },
     [](Primitive& m, py::handle v, const std::string& place) { m.placement.shape.bend = pairFrom(v, place); }},
    {"reach", [](const Primitive& m) -> py::object { return py::float_(m.reach); },
     [](Primitive& m, py::handle v, const std::string& place) { m.reach = numberFrom(v, place); }},
    {"amount", [](const Primitive& m) -> py::object { return py::float_(m.amount); },
     [](Primitive& m, py::handle v, const std::string& place) { m.amount = numberFrom(v, place); }},
    {"sign", [](const Primitive& m) -> py::object { return py::int_(m.sign); }, setSign},
    {"territory", territoryOf, setTerritory},
    {"bone", [](const Primitive& m) -> py::object { return py::str(m.bone); },
     [](Primitive& m, py::handle v, const std::string& place) { m.bone = textFrom(v, place); }},
    // Read here alone: whoever writes these changes other muscles as well.
    {"name", [](const Primitive& m) -> py::object { return py::str(m.name); }, nullptr},
    {"group", [](const Primitive& m) -> py::object { return py::str(m.group); }, nullptr},
    {"line", [](const Primitive& m) -> py::object { return m.line.empty() ? py::object(py::none()) : py::str(m.line); },
     nullptr},
    {"mirror",
     [](const Primitive& m) -> py::object { return m.mirror.empty() ? py::object(py::none()) : py::str(m.mirror); },
     nullptr},
};

template <float LineSettings::*member>
Field<MuscleLine> lineNumber(const char* name) {
  return {name, [](const MuscleLine& line) -> py::object { return py::float_(line.settings.*member); },
          [](MuscleLine& line, py::handle value, const std::string& place) {
            line.settings.*member = numberFrom(value, place);
          }};
}

template <glm::vec2 LineSettings::*member>
Field<MuscleLine> linePair(const char* name) {
  return {name, [](const MuscleLine& line) -> py::object { return tupleOf(line.settings.*member); },
          [](MuscleLine& line, py::handle value, const std::string& place) {
            line.settings.*member = pairFrom(value, place);
          }};
}

const Field<MuscleLine> kLineFields[] = {
    {"origin", [](const MuscleLine& l) -> py::object { return tupleOf(l.origin); },
     [](MuscleLine& l, py::handle v, const std::string& place) { l.origin = anchorFrom(v, place); }},
    {"insertion", [](const MuscleLine& l) -> py::object { return tupleOf(l.insertion); },
     [](MuscleLine& l, py::handle v, const std::string& place) { l.insertion = anchorFrom(v, place); }},
    {"via", [](const MuscleLine& l) -> py::object { return l.via ? tupleOf(*l.via) : py::object(py::none()); },
     [](MuscleLine& l, py::handle v, const std::string& place) {
       l.via.reset();
       if (!v.is_none()) l.via = anchorFrom(v, place);
     }},
    lineNumber<&LineSettings::rest>("rest"),
    linePair<&LineSettings::tendons>("tendons"),
    lineNumber<&LineSettings::volume>("volume"),
    linePair<&LineSettings::limits>("limits"),
    lineNumber<&LineSettings::pivot>("pivot"),
    lineNumber<&LineSettings::twist>("twist"),
    linePair<&LineSettings::flex>("flex"),
    lineNumber<&LineSettings::base>("base"),
    lineNumber<&LineSettings::gain>("gain"),
    lineNumber<&LineSettings::full>("full"),
    {"name", [](const MuscleLine& l) -> py::object { return py::str(l.name); }, nullptr},
    {"mirror",
     [](const MuscleLine& l) -> py::object { return l.mirror.empty() ? py::object(py::none()) : py::str(l.mirror); },
     nullptr},
};

const Field<Rig> kSettings[] = {
    {"mode", [](const Rig& r) -> py::object { return py::str(nameOf(r.surface.mode)); },
     [](Rig& r, py::handle v, const std::string& place) {
       r.surface.mode = wordFrom(v, place, surfaceModeNamed, {"swell", "replace"});
     }},
    {"iso", [](const Rig& r) -> py::object { return py::float_(r.surface.iso); },
     [](Rig& r, py::handle v, const std::string& place) { r.surface.iso = numberFrom(v, place); }},
    {"skin_blend", [](const Rig& r) -> py::object { return py::float_(r.surface.skinBlend); },
     [](Rig& r, py::handle v, const std::string& place) { r.surface.skinBlend = numberFrom(v, place); }},
    {"grooves", [](const Rig& r) -> py::object { return py::float_(r.surface.grooves); },
     [](Rig& r, py::handle v, const std::string& place) { r.surface.grooves = numberFrom(v, place); }},
    {"depth", [](const Rig& r) -> py::object { return py::int_(r.smoothing.depth); },
     [](Rig& r, py::handle v, const std::string& place) { r.smoothing.depth = integerFrom(v, place); }},
    {"patch", [](const Rig& r) -> py::object { return py::str(nameOf(r.smoothing.patch)); },
     [](Rig& r, py::handle v, const std::string& place) {
       r.smoothing.patch = wordFrom(v, place, patchKindNamed, {"pn", "phong", "spherigon", "flat"});
     }},
    {"projection",
     [](const Rig& r) -> py::object {
       return py::str(nameOf(r.smoothing.alongNormals ? ProjectionKind::kAnalytic : ProjectionKind::kNewton));
     },
     [](Rig& r, py::handle v, const std::string& place) {
       const auto word = wordFrom(v, place, projectionKindNamed, {"newton", "bisection", "analytic"});
       r.smoothing.alongNormals = word == ProjectionKind::kAnalytic;
     }},
    {"crease_angle", [](const Rig& r) -> py::object { return py::float_(r.smoothing.creaseAngle); },
     [](Rig& r, py::handle v, const std::string& place) { r.smoothing.creaseAngle = numberFrom(v, place); }},
    {"detail", [](const Rig& r) -> py::object { return py::str(nameOf(r.smoothing.detail)); },
     [](Rig& r, py::handle v, const std::string& place) {
       r.smoothing.detail = wordFrom(v, place, detailKindNamed, {"uniform", "adaptive"});
     }},
    {"tolerance", [](const Rig& r) -> py::object { return py::float_(r.smoothing.tolerance); },
     [](Rig& r, py::handle v, const std::string& place) { r.smoothing.tolerance = numberFrom(v, place); }},
};

}  // namespace

LineAnchor anchorFrom(py::handle value, const std::string& place) {
  const std::string expected = "expected a pair of a bone and a point in its space, (bone, (x, y, z)), got ";
  if (PyUnicode_Check(value.ptr()) != 0) refuse(place, expected + kindOf(value));
  const py::object items = py::reinterpret_steal<py::object>(PySequence_Fast(value.ptr(), ""));
  if (!items) {
    PyErr_Clear();
    refuse(place, expected + kindOf(value));
  }
  const Py_ssize_t count = PySequence_Fast_GET_SIZE(items.ptr());
  if (count != 2) refuse(place, expected + std::to_string(count) + " of them");
  return {textFrom(PySequence_Fast_GET_ITEM(items.ptr(), 0), place + ", bone"),
          vectorFrom(PySequence_Fast_GET_ITEM(items.ptr(), 1), place + ", point"),
          {}};
}

template <>
const Field<Primitive>* findField<Primitive>(const std::string& name) {
  return fieldNamed(kMuscleFields, name);
}

template <>
const Field<MuscleLine>* findField<MuscleLine>(const std::string& name) {
  return fieldNamed(kLineFields, name);
}

template <>
const Field<Rig>* findField<Rig>(const std::string& name) {
  return fieldNamed(kSettings, name);
}

}  // namespace sinew::python
