// core/include/sinew/files/baked_export.h: the live surface over one clip, as morph targets or as a point cache.
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

inline constexpr double kLeastBound = 0.001;  ///< Percent of the height: what floats in a file can hold.
inline constexpr double kMostBound = 100.0;
inline constexpr int kMostSubsteps = 16;

struct BakedExportSettings {
  std::string clip;                                  ///< Its name.
  double framesPerSecond = 30.0;                     ///< Above 0, finite; the clip's end is baked too.
  int substeps = 1;                                  ///< Moments baked a frame, 1..kMostSubsteps; .glb, .gltf.
  double bound = 0.1;                                ///< Percent of the height, kLeastBound..kMostBound; .glb, .gltf.
  ExportWeights weights = ExportWeights::kRefitted;  ///< For .glb and .gltf.
};

struct BakedExportReport {
  int frames = 0;             ///< Baked moments.
  std::int64_t vertices = 0;  ///< As the file splits them; refined ones in .pc2 and .mdd.
  std::uint64_t bytes = 0;    ///< All files that were written.
  // For .glb and .gltf; baked points are the surface itself.
  int targets = 0;
  int joints = 0;  ///< Those of all skins in the file, each node once.
  std::int64_t triangles = 0;
  ErrorFigures skinned;  ///< Joints and weights alone, in the baked frames.
  ErrorFigures baked;    ///< With the targets.
  ErrorFigures between;  ///< With the targets between baked moments, where a program blends two of them.
  std::shared_ptr<const ExportedSurface> played;  ///< What the file shows.
  std::vector<std::string> left;  ///< What of the source file is not in the export, each with the reason.
};

/// .glb, .gltf: as exportSkinned, of the refined mesh with the one clip, and as few morph targets with animated weights
/// as bring every vertex in every baked frame as near to the live surface as the bound says. .pc2, .mdd: the refined
/// vertices in world at each baked frame, beside them NAME.obj with the first (its .mtl and textures too). .usda: the
/// same points as time samples of meshes with normals and materials. All files are whole or none is written. Same
/// inputs give the same bytes.
/// @param character  as importGltf(characterFile) gave it; for baked points it may have clips of its own at the end
/// Error: unknown clip, an invalid rig, a bound that floats or singular poses do not allow, too many frames or more
/// than a file holds, a file cannot be written, or canceled. Muscles whose bone is missing are left out. Never throws.
[[nodiscard]] Result<BakedExportReport> exportBaked(const std::filesystem::path& characterFile,
                                                    const std::shared_ptr<const Character>& character, const Rig& rig,
                                                    const BakedExportSettings& settings,
                                                    const std::filesystem::path& file,
                                                    const ExportProgress& progress = {});

}  // namespace sinew
