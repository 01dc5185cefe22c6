// python/module/rig_module.cpp: what Python may do with a rig.
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"
#include "core/rig/line_edit.h"
#include "core/rig/rig_edit.h"
#include "core/rig/twins.h"
#include "python/module/errors.h"
#include "python/module/rig.h"
#include "python/module/rig_fields.h"
#include "python/module/values.h"
#include "sinew/files/rig_json.h"
#include "sinew/rig/rig_edit.h"

namespace sinew::python {
namespace {

namespace py = pybind11;

/// Fields whose values name bones.
RigHandle::Bones bonesIn(const std::string& field) {
  static const std::array<std::string, 5> kNaming{"bone", "territory", "origin", "insertion", "via"};
  const bool names = std::ranges::find(kNaming, field) != kNaming.end();
  return names ? RigHandle::Bones::kMayBeNew : RigHandle::Bones::kAsBefore;
}

template <class Owner>
const Field<Owner>& fieldOf(const std::string& name) {
  const Field<Owner>* const field = findField<Owner>(name);
  if (field == nullptr) refuse(name, "there is no such field");
  return *field;
}

/// Fields by keyword; None leaves the default.
template <class Owner>
void setFields(Owner& owner, const py::dict& fields, const std::string& what) {
  for (const auto& [key, value] : fields) {
    if (value.is_none()) continue;
    const std::string name = textFrom(key, what);
    const Field<Owner>* const field = findField<Owner>(name);
    if (field == nullptr || field->write == nullptr) refuse(what, "there is nothing called \"" + name + "\" to set");
    field->write(owner, value, what + ", " + name);
  }
}

std::string subjectOf(const char* what, const std::string& name) { return std::string(what) + " \"" + name + '"'; }

std::uint32_t addMuscle(RigHandle& handle, const py::object& givenName, const py::object& group, const py::object& line,
                        const py::dict& fields) {
  const Rig& rig = handle.rig();
  Primitive muscle;
  muscle.name = textFrom(givenName, "name");
  const std::string what = subjectOf("muscle", muscle.name);
  if (muscle.name.empty()) refuse("name", "expected a name that is not empty");
  if (findPrimitive(rig, muscle.name) >= 0) refuse(what, "the rig has a muscle of this name already");
  muscle.reach = kNewReach;
  setFields(muscle, fields, what);
  Rig edited = rig;
  if (!group.is_none()) {
    muscle.group = textFrom(group, what + ", group");
    edited = withGroup(std::move(edited), muscle.group);
  }
  if (!line.is_none()) muscle.line = at(rig.lines, handle.lineNamed(textFrom(line, what + ", line"))).name;
  const std::string name = muscle.name;
  handle.replace(addPrimitive(std::move(edited), std::move(muscle)), RigHandle::Bones::kMayBeNew);
  return at(handle.rig().primitives, findPrimitive(handle.rig(), name)).id().value;
}

std::uint32_t addLineOf(RigHandle& handle, const py::object& givenName, const py::dict& fields) {
  MuscleLine line;
  line.name = textFrom(givenName, "name");
  const std::string what = subjectOf("line", line.name);
  if (line.name.empty()) refuse("name", "expected a name that is not empty");
  if (findLine(handle.rig(), line.name) >= 0) refuse(what, "the rig has a line of this name already");
  setFields(line, fields, what);
  const std::string name = line.name;
  handle.replace(addLine(handle.rig(), std::move(line)), RigHandle::Bones::kMayBeNew);
  return at(handle.rig().lines, findLine(handle.rig(), name)).id().value;
}

void setMuscle(RigHandle& handle, std::uint32_t id, const std::string& field, const py::object& value) {
  const int index = handle.muscleOf(id);
  const std::string place = subjectOf("muscle", at(handle.rig().primitives, index).name) + ", " + field;
  const std::vector<int> one{index};
  if (field == "name") {
    handle.replace(renameWithTwin(handle.rig(), index, textFrom(value, place)));
  } else if (field == "group") {
    const std::string group = textFrom(value, place);
    handle.replace(setGroupOfSeveral(withGroup(handle.rig(), group), one, group));
  } else if (field == "line") {
    const int line = value.is_none() ? -1 : handle.lineNamed(textFrom(value, place));
    handle.replace(setLineOfSeveral(handle.rig(), one, line));
  } else {
    const Field<Primitive>& entry = fieldOf<Primitive>(field);
    Primitive changed = at(handle.rig().primitives, index);
    entry.write(changed, value, place);
    handle.replace(editPrimitives(handle.rig(), one, [&](Primitive& muscle) { muscle = changed; }), bonesIn(field));
  }
}

void setLine(RigHandle& handle, std::uint32_t id, const std::string& field, const py::object& value) {
  const int index = handle.lineOf(id);
  const std::string place = subjectOf("line", at(handle.rig().lines, index).name) + ", " + field;
  if (field == "name") {
    handle.replace(renameLine(handle.rig(), index, textFrom(value, place)));
    return;
  }
  const Field<MuscleLine>& entry = fieldOf<MuscleLine>(field);
  MuscleLine changed = at(handle.rig().lines, index);
  entry.write(changed, value, place);
  handle.replace(editLine(handle.rig(), index, [&](MuscleLine& line) { line = changed; }), bonesIn(field));
}

void setSetting(RigHandle& handle, const std::string& name, const py::object& value) {
  Rig changed = handle.rig();
  fieldOf<Rig>(name).write(changed, value, name);
  const SurfaceSettings surface = changed.surface;
  const SmoothingSettings smoothing = changed.smoothing;
  auto edited = setSurface(handle.rig(), surface);
  if (edited) edited = setSmoothing(std::move(edited).value(), smoothing);
  if (!edited) refuse(name, edited.error().reason);
  handle.replace(std::move(edited));
}

std::uint32_t mirror(RigHandle& handle, const py::object& name) {
  const int index = handle.muscleNamed(textFrom(name, "muscle"));
  handle.replace(mirrorToOtherSide(handle.rig(), index, *handle.character().plan()));
  return at(handle.rig().primitives, twinOf(handle.rig(), index)).id().value;
}

void removeMuscle(RigHandle& handle, const py::object& name) {
  const std::vector<int> one{handle.muscleNamed(textFrom(name, "muscle"))};
  handle.replace(removePrimitives(handle.rig(), one));
}

void removeGroupNamed(RigHandle& handle, const py::object& name) {
  handle.replace(removeGroup(handle.rig(), handle.groupNamed(textFrom(name, "group"))));
}

/// Groups that there are not yet are made when they are linked. @param howMuch  0 unlinks.
void setLinkOf(RigHandle& handle, const py::object& one, const py::object& other, const py::object& howMuch) {
  const std::string a = textFrom(one, "group");
  const std::string b = textFrom(other, "group");
  if (a == b) refuse(subjectOf("group", a), "is one with itself already; expected two different groups");
  const float amount = numberFrom(howMuch, "amount");
  const bool linked = amount != 0.0f;
  Rig edited = linked ? withGroup(withGroup(handle.rig(), a), b) : handle.rig();
  const int first = linked ? findGroup(edited, a) : handle.groupNamed(a);
  const int second = linked ? findGroup(edited, b) : handle.groupNamed(b);
  handle.replace(setLink(std::move(edited), first, second, amount));
}

float linkAmountOf(const RigHandle& handle, const py::object& one, const py::object& other) {
  const auto nameOf = [&](const py::object& group) -> const std::string& {
    return at(handle.rig().groups, handle.groupNamed(textFrom(group, "group"))).name;
  };
  return linkAmount(handle.rig(), nameOf(one), nameOf(other));
}

void renameGroupTo(RigHandle& handle, const py::object& name, const py::object& newName) {
  handle.replace(renameGroup(handle.rig(), handle.groupNamed(textFrom(name, "group")), textFrom(newName, "name")));
}

template <class Item>
std::vector<std::uint32_t> idsOf(const std::vector<Item>& items) {
  std::vector<std::uint32_t> ids;
  for (const Item& item : items) ids.push_back(item.id().value);
  return ids;
}

py::tuple groupsOf(const RigHandle& handle) {
  std::vector<std::string> names;
  for (const Group& group : handle.rig().groups) names.push_back(group.name);
  return py::tuple(py::cast(names));
}

py::tuple linksOf(const RigHandle& handle) {
  py::list links;
  for (const Link& link : handle.rig().links) links.append(py::make_tuple(link.groups[0], link.groups[1]));
  return py::tuple(links);
}

py::dict shapeWeightsOf(const RigHandle& handle) {
  py::dict weights;
  for (const MorphWeight& morph : handle.rig().morphs) weights[py::str(morph.name)] = morph.weight;
  return weights;
}

void setShapeWeight(RigHandle& handle, const py::object& name, const py::object& weight) {
  const std::string shape = textFrom(name, "shapes");
  const std::vector<std::string> names = morphNames(*handle.character().character());
  const std::string place = subjectOf("shape", shape);
  if (std::ranges::find(names, shape) == names.end() && findMorph(handle.rig(), shape) < 0) {
    refuse(place, names.empty() ? "the character has no shapes"
                                : "the character has no shape of this name" + didYouMean(shape, names));
  }
  handle.replace(setMorphWeight(handle.rig(), shape, numberFrom(weight, place)));
}

/// Names of muscles whose bone the character lacks.
std::vector<std::string> unattachedOf(const RigHandle& handle) {
  std::vector<std::string> names;
  for (const Primitive& muscle : handle.rig().primitives) {
    if (!handle.character().character()->skeleton.findBone(muscle.bone)) names.push_back(muscle.name);
  }
  return names;
}

/// With the clips that the rig names.
std::shared_ptr<RigHandle> opened(std::shared_ptr<RigHandle> handle) {
  handle->openClips();
  return handle;
}

/// A new rig, that of a file, or that of a text as files hold it.
std::shared_ptr<RigHandle> makeRig(std::shared_ptr<CharacterHandle> character, const py::object& path,
                                   const py::object& text) {
  if (!path.is_none()) {
    const std::filesystem::path file = pathFrom(path, "path");
    Rig rig = valueOrRefuse(loadRig(file));
    std::error_code failed;
    if (!std::filesystem::equivalent(characterPath(rig, file), character->file(), failed) || failed) {
      rig.character = relativeCharacterPath(character->file(), file);
    }
    return opened(std::make_shared<RigHandle>(std::move(character), std::move(rig), file));
  }
  if (text.is_none()) return std::make_shared<RigHandle>(std::move(character));
  Rig rig = valueOrRefuse(rigFromJson(textFrom(text, "text")));
  return opened(std::make_shared<RigHandle>(std::move(character), std::move(rig), std::filesystem::path()));
}

/// Where the character of a rig file lies.
py::str characterFileOf(const py::object& path) {
  const std::filesystem::path file = pathFrom(path, "path");
  return pathText(characterPath(valueOrRefuse(loadRig(file)), file));
}

}  // namespace

void defineRig(py::module_& module) {
  py::class_<RigHandle, std::shared_ptr<RigHandle>>(module, "Rig")
      .def(py::init(&makeRig))
      .def_property_readonly("path", [](const RigHandle& handle) { return pathText(handle.file()); })
      .def_property_readonly("groups", groupsOf)
      .def_property_readonly("links", linksOf)
      .def_property_readonly("unattached", unattachedOf)
      .def_property_readonly("clip_files",
                             [](const RigHandle& handle) { return py::tuple(py::cast(handle.rig().clipFiles)); })
      .def_property_readonly("missing_clips", [](const RigHandle& handle) { return handle.missingClips(); })
      .def("_add_clips",
           [](RigHandle& handle, const py::object& path) { return handle.addClips(pathFrom(path, "path")); })
      .def("_add_muscle", addMuscle)
      .def("_add_line", addLineOf)
      .def("_muscles", [](const RigHandle& handle) { return idsOf(handle.rig().primitives); })
      .def("_lines", [](const RigHandle& handle) { return idsOf(handle.rig().lines); })
      .def("_muscle",
           [](const RigHandle& handle, const py::object& name) {
             return at(handle.rig().primitives, handle.muscleNamed(textFrom(name, "muscle"))).id().value;
           })
      .def("_line",
           [](const RigHandle& handle, const py::object& name) {
             return at(handle.rig().lines, handle.lineNamed(textFrom(name, "line"))).id().value;
           })
      .def("_has",
           [](const RigHandle& handle, const py::object& name) {
             return PyUnicode_Check(name.ptr()) != 0 && findPrimitive(handle.rig(), textFrom(name, "muscle")) >= 0;
           })
      .def("_muscle_field",
           [](const RigHandle& handle, std::uint32_t id, const std::string& field) {
             return fieldOf<Primitive>(field).read(at(handle.rig().primitives, handle.muscleOf(id)));
           })
      .def("_set_muscle_field", setMuscle)
      .def("_line_field",
           [](const RigHandle& handle, std::uint32_t id, const std::string& field) {
             return fieldOf<MuscleLine>(field).read(at(handle.rig().lines, handle.lineOf(id)));
           })
      .def("_set_line_field", setLine)
      .def("_setting",
           [](const RigHandle& handle, const std::string& name) { return fieldOf<Rig>(name).read(handle.rig()); })
      .def("_set_setting", setSetting)
      .def("_mirror", mirror)
      .def("_remove", removeMuscle)
      .def("_remove_group", removeGroupNamed)
      .def("_rename_group", renameGroupTo)
      .def("_set_link", setLinkOf)
      .def("_link_amount", linkAmountOf)
      .def("_shapes", shapeWeightsOf)
      .def("_set_shape", setShapeWeight)
      .def("_save", [](RigHandle& handle, const py::object& path) { handle.save(pathFrom(path, "path")); })
      .def("_json", [](const RigHandle& handle) { return rigToJson(handle.rig()); })
      .def("_copy_from", [](RigHandle& handle, const RigHandle& other) { handle = other; })
      .def("_equals", [](const RigHandle& a, const RigHandle& b) { return a.rig() == b.rig(); });
  module.def("character_file_of", characterFileOf);
}

}  // namespace sinew::python
