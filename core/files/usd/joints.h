// core/files/usd/joints.h: a glTF file's bones and clips as a Skeleton and its animations.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/files/fit/trs.h"
#include "core/files/gltf/skin.h"
#include "sinew/character/animation_clip.h"

namespace sinew::usd {

struct Joint {
  std::string name{};     ///< As in the file; each once.
  std::string path{};     ///< Identifiers from the root joint, "/" between.
  int parent = -1;        ///< Index < own index, or -1.
  glm::dmat4 bind{1.0};   ///< Joint -> world in the bind pose.
  exporting::Trs rest{};  ///< In the parent's space.
};

struct SampledClip {
  std::string name;
  std::vector<double> frames;                       ///< Rising.
  std::vector<std::vector<exporting::Trs>> locals;  ///< [frames][joints] in the parents' spaces.
};

struct Joints {
  std::vector<Joint> joints;   ///< Parents before children; one root.
  std::vector<int> ofBinding;  ///< [bindings of the skeleton] whose bind matrix is that binding's.
  std::vector<SampledClip> clips;
};

inline constexpr double kFramesPerSecond = 30.0;
/// Joints times frames of all clips together.
inline constexpr double kMostSamples = 4e7;

/// Frames of a clip that are written: the whole ones, and its end.
[[nodiscard]] std::vector<double> framesOf(const AnimationClip& clip);

/// Joints are the bones, and those nodes above bones that ever scale unevenly: folded into the joints below they would
/// shear them. Other nodes above a joint are folded into it. A bone that two skins bind differently has a joint for
/// each. A scale that never changes and is the same along all axes is taken out of the joint's space: USD keeps scales
/// in 11 bits. Throws gltf::Refusal where the clips have too many frames.
[[nodiscard]] Joints jointsOf(const gltf::BoundSkeleton& bound, std::span<const AnimationClip> clips);

}  // namespace sinew::usd
