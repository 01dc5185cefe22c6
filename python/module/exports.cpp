// python/module/exports.cpp: characters for other programs. The interpreter's lock is released while they are made.
#include "python/module/exports.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include "core/character/clip_names.h"
#include "core/geometry/nearest_name.h"
#include "core/rig/attachment.h"
#include "core/rig/motion_clip.h"
#include "python/module/errors.h"
#include "python/module/rig.h"
#include "python/module/values.h"
#include "sinew/files/baked_export.h"
#include "sinew/files/formats.h"
#include "sinew/files/skinned_export.h"
#include "sinew/geometry/threads.h"

namespace sinew::python {
namespace {

namespace py = pybind11;

py::dict dictOf(const ErrorFigures& error) {
  py::dict figures;
  figures["poses"] = error.poses;
  figures["rms"] = error.rms;
  figures["percentile_99_9"] = error.percentile999;
  figures["max"] = error.largest;
  return figures;
}

py::dict errorsOfClips(const std::vector<ClipError>& clips) {
  py::dict errors;
  for (const ClipError& clip : clips) errors[py::str(clip.clip)] = dictOf(clip.error);
  return errors;
}

py::dict dictOf(const SkinnedExportReport& report) {
  py::dict facts;
  facts["joints"] = report.joints;
  facts["line_joints"] = report.lineJoints;
  facts["rigid_helpers"] = report.rigidHelpers;
  facts["vertices"] = report.vertices;
  facts["triangles"] = report.triangles;
  facts["bytes"] = report.bytes;
  facts["all_clips"] = dictOf(report.allClips);
  facts["clips"] = errorsOfClips(report.clips);
  facts["fitted"] = dictOf(report.fitted);
  facts["held_out"] = dictOf(report.heldOut);
  facts["left_out"] = report.left;
  return facts;
}

py::dict dictOf(const BakedExportReport& report) {
  py::dict facts;
  facts["frames"] = report.frames;
  facts["targets"] = report.targets;
  facts["joints"] = report.joints;
  facts["vertices"] = report.vertices;
  facts["triangles"] = report.triangles;
  facts["bytes"] = report.bytes;
  facts["skinned"] = dictOf(report.skinned);
  facts["baked"] = dictOf(report.baked);
  facts["left_out"] = report.left;
  return facts;
}

/// Calls a function of Python now and then, and hears Ctrl+C. What is raised there cancels, and is raised again.
class Progress {
 public:
  explicit Progress(py::object callback) : callback_(std::move(callback)) {
    if (!callback_.is_none() && PyCallable_Check(callback_.ptr()) == 0) {
      refuse("progress", "expected a function of the share that is done, got " + kindOf(callback_));
    }
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() = default;

  [[nodiscard]] ExportProgress asked() {
    return [this](double share) { return goesOn(share); };
  }
  /// With the interpreter's lock.
  void raiseAgain() {
    if (raised_) std::rethrow_exception(std::exchange(raised_, nullptr));
  }

 private:
  bool goesOn(double share) {
    const py::gil_scoped_acquire acquired;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (callback_.is_none()) return true;
      const py::object answer = callback_(share);
      return answer.ptr() != Py_False;
    } catch (...) {
      raised_ = std::current_exception();
      return false;
    }
  }

  py::object callback_;
  std::exception_ptr raised_;
};

template <class Kind, std::size_t count>
Kind wordFrom(const py::object& value, const char* place, const std::pair<const char*, Kind> (&words)[count]) {
  const std::string word = textFrom(value, place);
  std::vector<std::string> known;
  for (const auto& [name, kind] : words) {
    if (word == name) return kind;
    known.emplace_back(name);
  }
  refuse(place, "expected " + listed(known, "or") + ", got \"" + word + '"');
}

ExportWeights weightsFrom(const py::object& value) {
  return wordFrom<ExportWeights>(
      value, "weights", {{"refitted", ExportWeights::kRefitted}, {"transferred", ExportWeights::kTransferred}});
}

void checkBones(const RigHandle& handle) {
  const Skeleton& skeleton = handle.character().character()->skeleton;
  const auto missing = missingBones(handle.rig(), skeleton);
  if (missing.empty()) return;
  Error refusal = refusalOf(missing.front(), skeleton);
  refusal.file = handle.file().string();
  refuse(refusal);
}

void checkEnding(const std::filesystem::path& file, const std::vector<ExportForm>& forms) {
  if (hasExportEnding(file, forms)) return;
  refuse({file.string(), {}, "expected a name that ends in " + listed(exportEndings(forms), "or")});
}

void checkClip(const CharacterHandle& handle, const Character& with, const std::string& name) {
  if (findClip(with, name) >= 0) return;
  refuse({handle.file().string(), "clip \"" + name + '"', noSuchClip(name, handle.character()->clips)});
}

SkinnedExportSettings skinnedSettings(const py::dict& options) {
  SkinnedExportSettings settings;
  settings.mesh = wordFrom<ExportMesh>(options["mesh"], "mesh",
                                       {{"refined", ExportMesh::kRefined}, {"original", ExportMesh::kOriginal}});
  settings.weights = weightsFrom(options["weights"]);
  settings.jointScale = wordFrom<JointScale>(
      options["joint_scale"], "joint_scale",
      {{"full", JointScale::kFull}, {"uniform", JointScale::kUniform}, {"none", JointScale::kNone}});
  settings.morphs = truthFrom(options["shapes"], "shapes");
  const py::object helpers = options["helpers"];
  if (!helpers.is_none()) {
    settings.joints = ExportJoints::kHelpers;
    settings.helpers = integerFrom(helpers, "helpers");
    if (settings.helpers < 0 || settings.helpers > kMostHelpers) {
      refuse("helpers",
             "expected 0 to " + std::to_string(kMostHelpers) + " joints, got " + std::to_string(settings.helpers));
    }
    if (settings.weights != ExportWeights::kRefitted) {
      refuse("weights", "expected \"refitted\": muscle joints need weights that are fitted to them");
    }
  }
  const py::object clips = options["clips"];
  if (!clips.is_none()) settings.clips = textsFrom(clips, "clips");
  return settings;
}

py::dict exportSkinnedFrom(const RigHandle& handle, const py::object& path, const py::dict& options) {
  const std::filesystem::path file = pathFrom(path, "path");
  checkEnding(file, {ExportForm::kSkin});
  const SkinnedExportSettings settings = skinnedSettings(options);
  const int threads = threadsFrom(options["threads"]);
  Progress progress(options["progress"]);
  CharacterHandle& character = handle.character();
  for (const std::string& clip : settings.clips) checkClip(character, *character.character(), clip);
  checkBones(handle);
  const auto moving = character.moving();
  const Rig rig = handle.rig();
  const auto report = [&] {
    const py::gil_scoped_release released;
    const ThreadLimit limit(threads);
    return exportSkinned(character.file(), character.character(), *moving, rig, settings, file, progress.asked());
  }();
  progress.raiseAgain();
  if (!report) refuse(report.error());
  return dictOf(report.value());
}

BakedExportSettings bakedSettings(const py::object& clip, const py::dict& options) {
  BakedExportSettings settings;
  settings.clip = textFrom(clip, "clip");
  settings.framesPerSecond = doubleFrom(options["fps"], "fps");
  if (settings.framesPerSecond <= 0.0) refuse("fps", "expected frames a second above 0");
  settings.substeps = integerFrom(options["substeps"], "substeps");
  if (settings.substeps < 1 || settings.substeps > kMostSubsteps) {
    refuse("substeps", "expected 1 to " + std::to_string(kMostSubsteps) + ", got " + std::to_string(settings.substeps));
  }
  settings.bound = doubleFrom(options["bound"], "bound");
  if (settings.bound < kLeastBound || settings.bound > kMostBound) {
    refuse("bound", "expected 0.001 to 100 percent of the height, got " + std::string(py::str(options["bound"])));
  }
  settings.weights = weightsFrom(options["weights"]);
  return settings;
}

py::dict exportBakedFrom(const RigHandle& handle, const py::object& path, const py::object& clip,
                         const py::dict& options) {
  const std::filesystem::path file = pathFrom(path, "path");
  checkEnding(file, {ExportForm::kTargets, ExportForm::kStage, ExportForm::kCache});
  const BakedExportSettings settings = bakedSettings(clip, options);
  const int threads = threadsFrom(options["threads"]);
  Progress progress(options["progress"]);
  CharacterHandle& character = handle.character();
  // Only bare points can be of a clip that no file holds.
  const bool points = !hasExportEnding(file, {ExportForm::kTargets});
  const auto moving = points && settings.clip == kRangeOfMotionName ? character.moving() : character.character();
  checkClip(character, *moving, settings.clip);
  checkBones(handle);
  const Rig rig = handle.rig();
  const auto report = [&] {
    const py::gil_scoped_release released;
    const ThreadLimit limit(threads);
    return exportBaked(character.file(), moving, rig, settings, file, progress.asked());
  }();
  progress.raiseAgain();
  if (!report) refuse(report.error());
  return dictOf(report.value());
}

}  // namespace

void defineExports(py::module_& module) {
  module.def("export_skinned", exportSkinnedFrom);
  module.def("export_baked", exportBakedFrom);
}

}  // namespace sinew::python
