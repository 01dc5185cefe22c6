// python/module/rig_fields.h: what Python reads and writes of muscles, lines and a rig's settings, as tables by name.
#pragma once

#include <string>

#include <pybind11/pybind11.h>

#include "sinew/rig/rig.h"

namespace sinew::python {

/// One member of a muscle, a line or the settings. `write` refuses what is of the wrong kind; ranges are core's affair.
template <class Owner>
struct Field {
  const char* name;
  pybind11::object (*read)(const Owner& owner);
  void (*write)(Owner& owner, pybind11::handle value, const std::string& place);
};

/// Null: there is no such field.
template <class Owner>
[[nodiscard]] const Field<Owner>* findField(const std::string& name);

template <>
const Field<Primitive>* findField<Primitive>(const std::string& name);
template <>
const Field<MuscleLine>* findField<MuscleLine>(const std::string& name);
template <>
const Field<Rig>* findField<Rig>(const std::string& name);

/// A point on a bone from a pair (bone, (x, y, z)).
[[nodiscard]] LineAnchor anchorFrom(pybind11::handle value, const std::string& place);

}  // namespace sinew::python
