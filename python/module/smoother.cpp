// python/module/smoother.cpp: the pipeline as Python calls it. The interpreter's lock is released while it works.
#include "python/module/smoother.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include "core/character/skinning.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"
#include "core/rig/attachment.h"
#include "core/rig/rig_edit.h"
#include "python/module/errors.h"
#include "python/module/rig.h"
#include "python/module/surface.h"
#include "python/module/values.h"
#include "sinew/geometry/threads.h"
#include "sinew/surface/crowd_smoother.h"

namespace sinew::python {
namespace {

namespace py = pybind11;

constexpr double kSameFrame = 1e-3;  ///< Share of a frame: less is rounding.
constexpr double kMostFrames = 1e7;

/// What is prepared is read by several threads at once; only prepare() has it alone.
class SmootherHandle {
 public:
  explicit SmootherHandle(std::shared_ptr<CharacterHandle> character)
      : character_(std::move(character)), smoother_(character_->character()) {}

  void prepare(const RigHandle& handle, bool leaveOutMissing) {
    const Rig rig = handle.rig();
    const auto missing = missingBones(rig, character_->character()->skeleton);
    if (!missing.empty() && !leaveOutMissing) {
      Error refusal = refusalOf(missing.front(), character_->character()->skeleton);
      refusal.file = handle.file().string();
      refuse(refusal);
    }
    const auto prepared = [&] {
      const py::gil_scoped_release released;
      const std::unique_lock lock(mutex_);
      return smoother_.prepare(rig);
    }();
    if (!prepared) refuse({handle.file().string(), prepared.error().place, prepared.error().reason});
    lines_.clear();
    for (const MuscleLine& line : rig.lines) lines_.push_back(line.name);
  }

  /// @param threads  0: all cores
  [[nodiscard]] std::vector<std::shared_ptr<SurfaceMemory>> smooth(const std::vector<Pose>& poses, int threads) {
    const py::gil_scoped_release released;
    std::vector<std::shared_ptr<SurfaceMemory>> made;
    std::vector<Surface> surfaces;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      made.push_back(SurfacePool::take(pool_, character_->character()));
      surfaces.push_back(std::move(made.back()->surface));
    }
    {
      const ThreadLimit limit(threads);
      const std::shared_lock lock(mutex_);
      smoother_.smooth(poses, surfaces);
    }
    for (std::size_t i = 0; i < poses.size(); ++i) made[i]->surface = std::move(surfaces[i]);
    return made;
  }

  [[nodiscard]] CharacterHandle& character() const { return *character_; }
  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }

 private:
  std::shared_ptr<CharacterHandle> character_;
  std::shared_mutex mutex_;
  CrowdSmoother smoother_;
  std::shared_ptr<SurfacePool> pool_ = std::make_shared<SurfacePool>();
  std::vector<std::string> lines_;  ///< Of the rig, in its order.
};

/// Weights of morph targets in place of those of the file or the clip; an expression adds to its targets.
void setPoseShapes(Pose& pose, const Character& character, const py::object& shapes) {
  if (shapes.is_none()) return;
  const std::vector<std::string> names = morphNames(character);
  std::vector<float> weights = morphWeightsOr(character, pose.morphWeights);
  const auto given = numbersByName(shapes, "shapes");
  for (const auto& [name, weight] : given) {
    if (std::ranges::find(names, name) == names.end()) {
      refuse("shapes[\"" + name + "\"]", names.empty()
                                             ? "the character has no shapes"
                                             : "the character has no shape of this name" + didYouMean(name, names));
    }
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (character.morphTargets[i].name == name) weights[i] = weight;
    }
  }
  // After all targets, so that the order of the dict does not matter.
  for (const auto& [name, weight] : given) {
    for (const MorphSet& set : character.morphSets) {
      if (set.name != name) continue;
      for (const MorphSet::Share& share : set.shares) at(weights, share.target) += weight * share.share;
    }
  }
  pose.morphWeights = std::move(weights);
}

void setFlex(Pose& pose, const std::vector<std::string>& lines, const py::object& flex, const py::object& flexed) {
  pose.flex = numberFrom(flex, "flex");
  if (pose.flex < 0.0f || pose.flex > 1.0f) {
    refuse("flex", "expected a number from 0 to 1, got " + std::string(py::str(flex)));
  }
  if (flexed.is_none()) return;
  for (const std::string& name : textsFrom(flexed, "flexed")) {
    const auto found = std::ranges::find(lines, name);
    if (found == lines.end()) {
      refuse("flexed", "the rig has no line \"" + name + '"' + didYouMean(name, lines));
    }
    pose.flexedLines.push_back(static_cast<int>(found - lines.begin()));
  }
  std::ranges::sort(pose.flexedLines);
  const auto repeated = std::ranges::unique(pose.flexedLines);
  pose.flexedLines.erase(repeated.begin(), repeated.end());
  if (pose.flexedLines.empty()) pose.flex = 0.0f;  // None is not all.
}

std::shared_ptr<SurfaceMemory> smoothOne(SmootherHandle& handle, const py::object& clip, const py::object& time,
                                         const py::object& bones, const py::object& shapes, const py::object& flex,
                                         const py::object& flexed, const py::object& threads) {
  CharacterHandle& character = handle.character();
  const double seconds = doubleFrom(time, "time");
  if (seconds < 0.0) refuse("time", "expected seconds >= 0, got " + std::string(py::str(time)));
  Pose pose = character.poseAt(clip, seconds);
  if (!bones.is_none()) pose.boneInWorld = bonesFrom(bones, character.character()->skeleton);
  setPoseShapes(pose, *character.character(), shapes);
  setFlex(pose, handle.lines(), flex, flexed);
  return handle.smooth({std::move(pose)}, threadsFrom(threads)).front();
}

/// Frames of a clip as the command line counts them: i / fps, to its end.
int framesOf(SmootherHandle& handle, const py::object& clip, const py::object& fps) {
  const double rate = doubleFrom(fps, "fps");
  if (rate <= 0.0) refuse("fps", "expected frames a second above 0, got " + std::string(py::str(fps)));
  const AnimationClip& found = handle.character().clipNamed(textFrom(clip, "clip"));
  const double last = std::floor(static_cast<double>(found.duration) * rate + kSameFrame);
  if (last > kMostFrames) refuse("fps", "expected fewer frames a second: these are more than ten million");
  return static_cast<int>(last) + 1;
}

std::vector<std::shared_ptr<SurfaceMemory>> smoothFrames(SmootherHandle& handle, const py::object& clip, double fps,
                                                         int first, int count, int threads) {
  std::vector<Pose> poses;
  for (int frame = first; frame < first + count; ++frame) poses.push_back(handle.character().poseAt(clip, frame / fps));
  return handle.smooth(poses, threads);
}

/// Threads that a number of them comes to.
int threadsMeant(const py::object& value) {
  const ThreadLimit limit(threadsFrom(value));
  return threadCount();
}

}  // namespace

void defineSmoother(py::module_& module) {
  py::class_<SmootherHandle, std::shared_ptr<SmootherHandle>>(module, "Smoother")
      .def(py::init<std::shared_ptr<CharacterHandle>>())
      .def("_prepare", &SmootherHandle::prepare)
      .def("_smooth", smoothOne)
      .def("_count_frames", framesOf)
      .def("_frames", smoothFrames);
  module.def("threads_meant", threadsMeant);
}

}  // namespace sinew::python
