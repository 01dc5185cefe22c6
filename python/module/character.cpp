// python/module/character.cpp: a character as Python holds it: its names, its poses.
#include "python/module/character.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "core/character/clip_names.h"
#include "core/character/pose_override.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"
#include "core/geometry/weld.h"
#include "core/rig/motion_clip.h"
#include "core/rig/rig_edit.h"
#include "python/module/arrays.h"
#include "python/module/bone_nodes.h"
#include "python/module/errors.h"
#include "python/module/mesh.h"
#include "python/module/values.h"
#include "sinew/character/character_pose.h"
#include "sinew/character/node_locals.h"
#include "sinew/files/gltf_import.h"

namespace sinew::python {
namespace {

namespace py = pybind11;

py::tuple bonesOf(const CharacterHandle& handle) {
  const Skeleton& skeleton = handle.character()->skeleton;
  py::tuple bones(skeleton.bones.size());
  for (std::size_t i = 0; i < skeleton.bones.size(); ++i) {
    const Bone& bone = skeleton.bones[i];
    bones[i] = py::make_tuple(i, skeleton.fileName(static_cast<int>(i)), bone.path, bone.parent);
  }
  return bones;
}

py::tuple nodesOf(const CharacterHandle& handle) {
  auto nodes = [&] {
    const py::gil_scoped_release released;
    return nodesOfBones(handle.file(), handle.character()->skeleton);
  }();
  return py::tuple(py::cast(valueOrRefuse(std::move(nodes))));
}

py::list clipListOf(const CharacterHandle& handle) {
  py::list clips;
  for (const AnimationClip& clip : handle.character()->clips) clips.append(py::make_tuple(clip.name, clip.duration));
  return clips;
}

py::tuple shapeNamesOf(const CharacterHandle& handle) { return py::tuple(py::cast(morphNames(*handle.character()))); }

py::array poseOf(CharacterHandle& handle, const py::object& clip, const py::object& time) {
  return matricesOf(handle.poseAt(clip, doubleFrom(time, "time")).boneInWorld);
}

/// Bone and what is given of it, refused where the character lacks the bone.
template <class Set>
void eachBone(const Skeleton& skeleton, const py::object& given, const std::string& what, Set set) {
  if (given.is_none()) return;
  if (PyDict_Check(given.ptr()) == 0) refuse(what, "expected a dict by bone, got " + kindOf(given));
  for (const auto& [name, value] : py::reinterpret_borrow<py::dict>(given)) {
    const std::string bone = textFrom(name, what);
    const std::string place = what + "[\"" + bone + "\"]";
    const auto found = skeleton.findBone(bone);
    if (!found) {
      std::vector<std::string> names;
      for (std::size_t i = 0; i < skeleton.bones.size(); ++i) names.push_back(skeleton.fileName(static_cast<int>(i)));
      refuse(place, "the character has no bone of this name" + didYouMean(bone, names));
    }
    set(*found, value, place);
  }
}

/// Joints turned on top of a moment. @param turns  bone -> x, y, z, w
py::array turnedPose(CharacterHandle& handle, const py::object& turns, const py::object& clip, const py::object& time) {
  const Skeleton& skeleton = handle.character()->skeleton;
  PoseOverrides overrides;
  if (turns.is_none()) refuse("turns", "expected a dict by bone, got None");
  eachBone(skeleton, turns, "turns", [&](int bone, py::handle turn, const std::string& place) {
    overrides.set(bone, rotationFrom(turn, place));
  });
  return matricesOf(posed(skeleton, handle.poseAt(clip, doubleFrom(time, "time")), overrides).boneInWorld);
}

/// What a node of the file says as a matrix is never taken apart: then all three are needed.
void refuseHalves(const Skeleton& skeleton, const std::vector<LocalTransform>& locals, const std::vector<int>& given) {
  for (std::size_t node = 0; node < locals.size(); ++node) {
    if (given[node] == 0 || given[node] == 3 || !locals[node].matrix) continue;
    refuse("\"" + skeleton.nodes[node].name + '"',
           "expected a translation, a rotation and a scale: the file has a matrix here, which is not taken apart");
  }
}

/// Joints set in their parents' space, the others as in a clip or at rest.
py::array poseOfLocals(CharacterHandle& handle, const py::object& translations, const py::object& rotations,
                       const py::object& scales, const py::object& clip, const py::object& time) {
  const Skeleton& skeleton = handle.character()->skeleton;
  const double seconds = doubleFrom(time, "time");
  std::vector<LocalTransform> locals = restLocals(skeleton);
  if (!clip.is_none()) {
    const AnimationClip& played = handle.clipNamed(textFrom(clip, "clip"));
    if (played.turnsBindPose) refuse("clip", "expected a clip of the file: this one is made, and turns the bind pose");
    locals = sampleLocals(skeleton, played, std::clamp(static_cast<float>(seconds), 0.0f, played.duration));
  }
  std::vector<int> given(locals.size(), 0);
  const auto local = [&](int bone) -> LocalTransform& {
    const int node = at(skeleton.bones, bone).node;
    ++at(given, node);
    return at(locals, node);
  };
  eachBone(skeleton, translations, "translations", [&](int bone, py::handle value, const std::string& place) {
    local(bone).translation = vectorFrom(value, place);
  });
  eachBone(skeleton, rotations, "rotations", [&](int bone, py::handle value, const std::string& place) {
    local(bone).rotation = rotationFrom(value, place);
  });
  eachBone(skeleton, scales, "scales",
           [&](int bone, py::handle value, const std::string& place) { local(bone).scale = vectorFrom(value, place); });
  refuseHalves(skeleton, locals, given);
  for (std::size_t node = 0; node < locals.size(); ++node) {
    if (given[node] > 0) locals[node].matrix.reset();
  }
  return matricesOf(poseFromLocals(skeleton, locals).boneInWorld);
}

/// What `sinew inspect` tells besides names. The word is as there.
py::dict factsOf(CharacterHandle& handle) {
  const Character& character = *handle.character();
  const Topology topology = topologyOf(character.mesh);
  py::dict facts;
  facts["triangles"] = character.mesh.triangles.size();
  facts["triangles_dropped"] = character.mesh.trianglesDropped;
  facts["vertices"] = character.mesh.positions.size();
  facts["wedges"] = character.mesh.wedges.size();
  facts["closed"] = topology.closed();
  facts["border_edges"] = topology.borderEdges.size();
  facts["non_manifold_edges"] = topology.nonManifoldEdges.size();
  facts["height"] = character.height;
  facts["joints"] = character.skeleton.bones.size();
  const AnimationClip* const motion = handle.moving() == handle.character() ? nullptr : &handle.moving()->clips.back();
  facts["range_of_motion"] = motion == nullptr ? 0.0f : motion->duration;
  facts["textures"] = character.textures.size();
  py::list materials;
  for (const Material& material : character.materials) materials.append(material.name);
  facts["materials"] = materials;
  facts["ignored"] = character.ignored;
  return facts;
}

}  // namespace

CharacterHandle::CharacterHandle(const std::filesystem::path& file) : file_(file) {
  auto read = [&] {
    const py::gil_scoped_release released;
    return importGltf(file);
  }();
  character_ = valueOrRefuse(std::move(read));
}

const std::shared_ptr<const MirrorPlan>& CharacterHandle::plan() {
  if (!plan_) plan_ = std::make_shared<const MirrorPlan>(makeMirrorPlan(*character_));
  return plan_;
}

const std::shared_ptr<const Character>& CharacterHandle::moving() {
  if (!moving_) moving_ = withRangeOfMotion(character_, *plan());
  return moving_;
}

/// With those that it has, so that all keep their names.
WithClipFiles CharacterHandle::readClips(const std::vector<std::filesystem::path>& files,
                                         const std::vector<SlotCorrection>& corrections) const {
  Rig rig;
  rig.slots = corrections;
  rig.clipFiles = clipFiles_;
  for (const std::filesystem::path& file : files) {
    const std::string name = std::filesystem::absolute(file).lexically_normal().string();
    if (std::ranges::find(rig.clipFiles, name) == rig.clipFiles.end()) rig.clipFiles.push_back(name);
  }
  const std::shared_ptr<const Character> character = character_;
  const py::gil_scoped_release released;
  return withClipFiles(character, rig, {});
}

void CharacterHandle::take(WithClipFiles with) {
  character_ = std::move(with.character);
  moving_.reset();
  clipFiles_.clear();
  for (const ClipFileReport& file : with.files) {
    if (!file.missing) clipFiles_.push_back(file.file);
  }
}

std::vector<std::string> CharacterHandle::addClips(const std::filesystem::path& file,
                                                   const std::vector<SlotCorrection>& corrections) {
  WithClipFiles with = readClips({file}, corrections);
  const std::string name = std::filesystem::absolute(file).lexically_normal().string();
  const ClipFileReport report = *std::ranges::find(with.files, name, &ClipFileReport::file);
  if (report.missing) refuse({file.string(), report.missing->place, report.missing->reason});
  const auto& clips = with.character->clips;
  if (std::ranges::find(clips, name, &AnimationClip::addedFrom) == clips.end()) {
    refuse({file.string(), "", "no clips are added: " + (report.notes.empty() ? "it has none" : report.notes.back())});
  }
  take(std::move(with));
  return report.notes;
}

std::vector<std::string> CharacterHandle::openClips(const std::vector<std::filesystem::path>& files,
                                                    const std::vector<SlotCorrection>& corrections) {
  if (files.empty()) return {};
  WithClipFiles with = readClips(files, corrections);
  std::vector<std::string> missing;
  for (const Error& error : missingOf(with.files)) missing.push_back(error.text());
  take(std::move(with));
  return missing;
}

const AnimationClip& CharacterHandle::clipNamed(const std::string& name) {
  const Character& from = name == kRangeOfMotionName ? *moving() : *character_;
  const int clip = findClip(from, name);
  if (clip < 0) {
    refuse({file_.string(), "clip \"" + name + '"',
            noSuchClip(name, character_->clips, {std::string(kRangeOfMotionName)})});
  }
  return at(from.clips, clip);
}

Pose CharacterHandle::poseAt(py::handle clip, double seconds) {
  if (clip.is_none()) return bindPose(character_->skeleton);
  return samplePose(*character_, clipNamed(textFrom(clip, "clip")), static_cast<float>(seconds));
}

void defineCharacter(py::module_& module) {
  py::class_<CharacterHandle, std::shared_ptr<CharacterHandle>>(module, "Character")
      .def(py::init([](const py::object& file) { return std::make_shared<CharacterHandle>(pathFrom(file, "path")); }))
      .def_property_readonly("name", [](const CharacterHandle& handle) { return handle.character()->name; })
      .def_property_readonly("path", [](const CharacterHandle& handle) { return pathText(handle.file()); })
      .def_property_readonly("height", [](const CharacterHandle& handle) { return handle.character()->height; })
      .def_property_readonly("ignored", [](const CharacterHandle& handle) { return handle.character()->ignored; })
      .def_property_readonly("shapes", shapeNamesOf)
      .def_property_readonly("mesh", [](const CharacterHandle& handle) { return MeshHandle{handle.character()}; })
      .def("_bones", bonesOf)
      .def("_nodes", nodesOf)
      .def("_clips", clipListOf)
      .def("_add_clips",
           [](CharacterHandle& handle, const py::object& path) { return handle.addClips(pathFrom(path, "path"), {}); })
      .def("_facts", factsOf)
      .def("_pose", poseOf)
      .def("_rest", [](const CharacterHandle& h) { return matricesOf(restPose(h.character()->skeleton).boneInWorld); })
      .def("_turned", turnedPose)
      .def("_from_locals", poseOfLocals)
      .def("_duration", [](CharacterHandle& handle, const py::object& clip) {
        return static_cast<double>(handle.clipNamed(textFrom(clip, "clip")).duration);
      });
}

}  // namespace sinew::python
