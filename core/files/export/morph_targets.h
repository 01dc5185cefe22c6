// core/files/export/morph_targets.h: morph targets of the written primitives, and their weights in clips.
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

// The moments of a clip that are baked, and how many may be.

struct BakedClip {
  /// @param settings  of a clip that the character has
  BakedClip(const Character& character, const BakedExportSettings& settings);

  const AnimationClip& clip;
  std::vector<float> times;    ///< [frames] seconds.
  std::vector<double> frames;  ///< [frames] 0, 1 ...; the last is no whole number where the clip ends between two.
};

[[nodiscard]] double momentsPerSecond(const BakedExportSettings& settings);

/// Before the times are made. Throws gltf::Refusal where the clip has more frames than that.
void requireFrames(const Character& character, const BakedExportSettings& settings, int most);

/// Throws gltf::Refusal: of the clip, which fewer frames or vertices would do for.
[[noreturn]] void refuseClip(const BakedExportSettings& settings, const std::string& what);

/// What one target adds to the vertices of one primitive, in its mesh's space.
struct TargetDeltas {
  std::vector<glm::vec3> positions;  ///< [vertices]
  std::vector<glm::vec3> normals;    ///< [vertices]
};

/// The targets of one mesh.
struct MeshTargets {
  std::vector<std::string> names;
  std::vector<float> weights;  ///< [names] where no clip plays.
  /// @param primitive  index into the written ones  @param target  index into names
  std::function<TargetDeltas(std::size_t primitive, std::size_t target)> deltas;
};

/// The nodes that show one of the primitives.
[[nodiscard]] std::set<int> nodesOf(std::span<const OutPrimitive> primitives);

/// Gives the mesh of a node the targets; its other primitives get as many that move nothing, as glTF asks. Sparse
/// accessors where they are smaller.
void addMorphTargets(int node, std::span<const OutPrimitive> primitives, const MeshTargets& targets,
                     GltfRewrite& rewrite);

/// A channel for each node, linear between keys, in the file's first clip, which is made where it is gone because all
/// it had were targets that are gone.
/// @param times  [keys] seconds, rising  @param weights  [keys * targets]
void addMorphWeights(const std::set<int>& nodes, const std::vector<float>& times, const std::vector<float>& weights,
                     const std::string& clip, GltfRewrite& rewrite);

}  // namespace sinew::exporting
