// core/include/sinew/files/baked_export.h: exports the surface over one clip as morph targets or as a point cache.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/files/progress.h"
#include "sinew/files/skinned_export.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

inline constexpr double kLeastBound = 0.001;  ///< Percent of the height; the precision of floats in a file.
inline constexpr double kMostBound = 100.0;
inline constexpr int kMostSubsteps = 16;

struct BakedExportSettings {
  std::string clip;               ///< Name.
  double framesPerSecond = 30.0;  ///< Above 0, finite; the clip's end is baked too.
  int substeps = 1;               ///< Sample times per frame, 1..kMostSubsteps; .glb, .gltf.
  double bound = 0.1;             ///< Largest error, percent of the height, kLeastBound..kMostBound; .glb, .gltf.
  ExportWeights weights = ExportWeights::kRefitted;  ///< For .glb and .gltf.
};

struct BakedExportReport {
  int frames = 0;             ///< Baked sample times.
  std::int64_t vertices = 0;  ///< Split as in the file; refined vertices in .pc2 and .mdd.
  std::uint64_t bytes = 0;    ///< All written files.
  // For .glb and .gltf; baked points are the surface itself.
  int targets = 0;
  int joints = 0;  ///< Of all skins in the file, each node once.
  std::int64_t triangles = 0;
  ErrorFigures skinned;  ///< Only joints and weights, in the baked frames.
  ErrorFigures baked;    ///< With the targets.
  ErrorFigures between;  ///< With the targets, between baked sample times, where programs interpolate.
  std::shared_ptr<const ExportedSurface> played;  ///< The exported surface as played.
  std::vector<std::string> left;  ///< Contents of the source file that are not exported, each with the reason.
};

/// .glb, .gltf: as exportSkinned() of the refined mesh with one clip, with as few animated morph targets as keep every
/// vertex in every baked frame within the bound of the live surface. .pc2, .mdd: refined vertices in the world at each
/// baked frame, and NAME.obj with the first (with its .mtl and textures). .usda: the same points as time samples of
/// meshes with normals and materials. Writes all files or none. The same inputs give the same bytes.
/// @param character  from importGltf(characterFile); for baked points it may have additional clips at the end
/// Error: unknown clip, an invalid rig, a bound that floats or singular poses do not allow, too many frames or more
/// than a file can hold, a file cannot be written, or canceled. Muscles whose bone is missing are left out. Never
/// throws.
[[nodiscard]] Result<BakedExportReport> exportBaked(const std::filesystem::path& characterFile,
                                                    const std::shared_ptr<const Character>& character, const Rig& rig,
                                                    const BakedExportSettings& settings,
                                                    const std::filesystem::path& file,
                                                    const ExportProgress& progress = {});

}  // namespace sinew
