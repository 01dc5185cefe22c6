// app/document/task_needs.cpp: memory by the vertices of the refined mesh, as it was measured.
#include "app/document/task_needs.h"

#include <algorithm>
#include <cmath>

#include "sinew/character/pose.h"
#include "sinew/surface/smoother.h"

namespace sinew::app {
namespace {

/// Megabytes of a task, and kilobytes more for each refined vertex: about twice what was measured.
struct Share {
  double base;
  double ofVertex;
};

Share shareOf(const std::string& verb) {
  if (verb == "export") return {500.0, 6.0};
  if (verb == "render") return {400.0, 1.5};
  return {100.0, 1.0};
}

constexpr double kOfHeldPoint = 0.05;  ///< Kilobytes of a vertex in a frame of a clip that is held whole.
constexpr double kStep = 100.0;        ///< Megabytes are asked for in hundreds.

}  // namespace

Result<TaskNeeds> taskNeeds(const std::string& verb, const std::shared_ptr<const Character>& character, const Rig& rig,
                            int threads, double heldFrames) {
  Smoother smoother(character);
  if (const auto prepared = smoother.prepare(rig); !prepared) return prepared.error();
  Surface surface;
  smoother.smooth(bindPose(character->skeleton), surface);
  const Share share = shareOf(verb);
  const double ofVertex = share.ofVertex + kOfHeldPoint * heldFrames;
  const double megabytes = share.base + ofVertex * static_cast<double>(surface.positions.size()) / 1000.0;
  return TaskNeeds{std::max(threads, 1), static_cast<int>(kStep * std::ceil(megabytes / kStep))};
}

TaskNeeds larger(const TaskNeeds& a, const TaskNeeds& b) {
  return {std::max(a.cores, b.cores), std::max(a.megabytes, b.megabytes)};
}

}  // namespace sinew::app
