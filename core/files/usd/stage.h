// core/files/usd/stage.h: a glTF file as a USD stage: skinned, or points over time.
#pragma once

#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/files/fit/trs.h"
#include "core/files/gltf/file.h"
#include "core/files/gltf/skin.h"
#include "core/files/json/json.h"
#include "core/files/surface_formats.h"
#include "sinew/character/animation_clip.h"
#include "sinew/geometry/geometry.h"

namespace sinew::usd {

// A glTF file's bones and clips as a Skeleton and its animations.

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

struct Stage {
  std::string text;                ///< The .usda.
  std::vector<SideFile> textures;  ///< Beside it.
  std::set<std::string> left;      ///< What of the file is not in them, each with the reason.
};

/// A SkelRoot with one Skeleton, a SkelAnimation for each clip (the first is bound), meshes and materials. Same inputs
/// give the same bytes. Throws gltf::Refusal.
/// @param file  @param root  the same file's JSON  @param stem  of the name of the .usda, whose root prim and textures
///              are called after it
[[nodiscard]] Stage skinnedStage(gltf::File& file, const Json& root, const std::string& stem);

/// One mesh at one moment.
struct MeshPoints {
  std::vector<glm::vec3> points;   ///< [vertices] world, in the file's order.
  std::vector<glm::vec3> normals;  ///< Likewise, unit; or none.
};

/// Where meshes are, moment by moment.
struct PointMoments {
  double framesPerSecond = 30.0;
  std::vector<double> frames;  ///< Rising; at least one.
  /// Fills `meshes`: one for each primitive of triangles that each node of the scene shows, in the order of nodes.
  /// Called once for every moment, in order.
  std::function<void(std::size_t moment, std::vector<MeshPoints>& meshes)> at;
};

/// The same meshes and materials without a skeleton, their points, normals and extents sampled in time. Throws
/// gltf::Refusal, also where a moment has not as many meshes or points as the file.
[[nodiscard]] Stage pointStage(gltf::File& file, const Json& root, const std::string& stem,
                               const PointMoments& moments);

}  // namespace sinew::usd
