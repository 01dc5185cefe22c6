// core/files/fit/live_surfaces.cpp: what no file may hold.
#include "core/files/fit/live_surfaces.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/files/gltf/refusal.h"
#include "sinew/character/pose_check.h"

namespace sinew::exporting {

void requireFinite(const Character& character, const Pose& pose, const Surface& surface) {
  const auto isSound = [](const glm::vec3& position) { return isFinite(position); };
  // Of a pose that is refused the surface is that of another.
  if (isSoundPose(character, pose) && std::ranges::all_of(surface.positions, isSound)) return;
  std::array<char, 32> second{};
  std::snprintf(second.data(), second.size(), "%.3f s", static_cast<double>(pose.time));
  const std::string place = pose.clip.empty() ? "bind pose" : "clip \"" + pose.clip + "\" at " + second.data();
  gltf::refuse(place, "moves or scales bones so far that places are no longer finite numbers");
}

}  // namespace sinew::exporting
