// core/files/usd/stage.h: a glTF file as a USD stage: skinned, or points over time.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "core/files/gltf/file.h"
#include "core/files/json/json.h"
#include "core/files/surface_formats.h"
#include "sinew/geometry/geometry.h"

namespace sinew::usd {

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
