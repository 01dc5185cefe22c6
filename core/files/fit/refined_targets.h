// core/files/fit/refined_targets.h: morph targets of the file on the refined surface, and their weights in the clips.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/files/fit/poses.h"
#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew::exporting {

/// What one target does to a surface at weight 1, in the bind pose with muscles at rest. Only what moves.
struct RefinedTarget {
  std::vector<int> vertices;       ///< Refined, ascending.
  std::vector<glm::vec3> deltas;   ///< [vertices] world.
  std::vector<int> drawn;          ///< Drawn vertices, ascending.
  std::vector<glm::vec3> normals;  ///< [drawn] what is added to their shading normals.
};

/// Weights of all targets over one clip, linear between keys.
struct MorphKeys {
  std::string clip;
  std::vector<float> times;    ///< [keys] seconds, rising.
  std::vector<float> weights;  ///< [keys][targets]
};

/// The targets as a file holds them, and as a program plays them.
struct PlayedMorphs {
  std::vector<RefinedTarget> targets;  ///< [Character::morphTargets]
  std::vector<float> rest;             ///< [targets] weights where no clip plays, the rig's share included.
  std::vector<bool> keyed;             ///< [targets] the rig changes weights of the node: its keys replace the file's.
  std::vector<MorphKeys> clips;        ///< Of the exported clips.
};

/// No target weighs anything.
[[nodiscard]] Pose withoutMorphs(const Character& character, Pose pose);

/// The surface with each target at 1, less that with none.
/// @param surfaces  prepared with a rig that adds no weights.  @param bind  theirs, with no target
[[nodiscard]] std::vector<RefinedTarget> refinedTargets(const Character& character, LiveSurfaces& surfaces,
                                                        const Surface& bind);
/// Those of the file's own vertices: what it has in it.
[[nodiscard]] std::vector<RefinedTarget> originalTargets(const Character& character);

/// Fills all but the targets.
/// @param poses  those of exported clips, clip by clip
void setMorphKeys(const Character& character, const Rig& rig, std::span<const ExportPose> poses, PlayedMorphs& out);

}  // namespace sinew::exporting
