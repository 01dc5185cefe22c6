// core/files/export/morph_targets.h: sample times of baked clips; morph targets of written primitives, and weights.
#pragma once

#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/files/export/gltf_rewrite.h"
#include "core/files/export/skinned_file.h"
#include "sinew/character/character.h"
#include "sinew/files/baked_export.h"

namespace sinew::exporting {

/// Sample times of a baked clip.
struct BakedClip {
  BakedClip(const Character& character, const BakedExportSettings& settings);

  const AnimationClip& clip;
  std::vector<float> times;    ///< [frames] seconds.
  std::vector<double> frames;  ///< [frames] 0, 1 ...; the last may be fractional.
};

[[nodiscard]] double momentsPerSecond(const BakedExportSettings& settings);

/// Throws gltf::Refusal if the clip has more than `most` frames.
void requireFrames(const Character& character, const BakedExportSettings& settings, int most);

/// Throws gltf::Refusal about the clip: fewer frames or vertices are needed.
[[noreturn]] void refuseClip(const BakedExportSettings& settings, const std::string& what);

/// Deltas of one target for one primitive, in its mesh's space.
struct TargetDeltas {
  std::vector<glm::vec3> positions;  ///< [vertices]
  std::vector<glm::vec3> normals;    ///< [vertices]
};

struct MeshTargets {
  std::vector<std::string> names;
  std::vector<float> weights;  ///< [names] without a clip.
  /// @param primitive  index into the written ones  @param target  index into names
  std::function<TargetDeltas(std::size_t primitive, std::size_t target)> deltas;
};

/// The nodes that show one of the primitives.
[[nodiscard]] std::set<int> nodesOf(std::span<const OutPrimitive> primitives);

/// Adds targets to a node's mesh, and as many idle ones to its other primitives (glTF). Sparse where that is smaller.
void addMorphTargets(int node, std::span<const OutPrimitive> primitives, const MeshTargets& targets,
                     GltfRewrite& rewrite);

/// Adds a linear channel for each node to the file's first clip, which is created if it was removed with its targets.
/// @param times  [keys] seconds, rising  @param weights  [keys * targets]
void addMorphWeights(const std::set<int>& nodes, const std::vector<float>& times, const std::vector<float>& weights,
                     const std::string& clip, GltfRewrite& rewrite);

}  // namespace sinew::exporting
