// core/files/usd/stage.h: a glTF file as a USD stage: skinned, or as points over time.
#pragma once

#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/files/fit/helper_motion.h"
#include "core/files/gltf/file.h"
#include "core/files/gltf/skin.h"
#include "core/files/json/json.h"
#include "core/files/surface_formats.h"
#include "sinew/character/animation_clip.h"
#include "sinew/geometry/geometry.h"

namespace sinew::usd {

// Joints and clips.

struct Joint {
  std::string name{};     ///< As in the file; unique.
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
  std::vector<int> ofBinding;  ///< [bindings of the skeleton] joint with its bind matrix.
  std::vector<SampledClip> clips;
};

[[nodiscard]] std::vector<double> framesOf(const AnimationClip& clip);  ///< Frames of a clip: whole ones, and its end.

/// Joints are the bones, and nodes above them that ever scale unevenly, which would shear joints below if folded. Other
/// nodes above a joint are folded into it. A bone that two skins bind differently has a joint for each. Constant
/// uniform scales are removed from a joint's space, since USD stores scales in 11 bits. Throws gltf::Refusal for too
/// many frames.
[[nodiscard]] Joints jointsOf(const gltf::BoundSkeleton& bound, std::span<const AnimationClip> clips);

// Stages.

struct Stage {
  std::string text;                ///< The .usda.
  std::vector<SideFile> textures;  ///< Beside it.
  std::set<std::string> left;      ///< Parts of the file that are left out, with reasons.
};

/// A SkelRoot with one Skeleton, a SkelAnimation for each clip (the first is bound), meshes and materials.
/// Deterministic. Throws gltf::Refusal. @param root  the file's JSON  @param stem  of the .usda, for names of the root
/// prim and textures
[[nodiscard]] Stage skinnedStage(gltf::File& file, const Json& root, const std::string& stem);

struct MeshPoints {
  std::vector<glm::vec3> points;   ///< [vertices] world, in the file's order.
  std::vector<glm::vec3> normals;  ///< [vertices] unit, or none.
};

struct PointMoments {
  double framesPerSecond = 30.0;
  std::vector<double> frames;  ///< Rising; at least one.
  /// Fills `meshes`: each triangle primitive of each node, in node order. Called once for every frame, in order.
  std::function<void(std::size_t moment, std::vector<MeshPoints>& meshes)> at;
};

/// The same meshes and materials without a skeleton: points, normals and extents are sampled over time. Throws
/// gltf::Refusal, also if a frame has other numbers of meshes or points than the file.
[[nodiscard]] Stage pointStage(gltf::File& file, const Json& root, const std::string& stem,
                               const PointMoments& moments);

}  // namespace sinew::usd
