// core/include/sinew/files/skinned_export.h: exports a character with its muscles as glTF for any engine.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/files/exported_surface.h"
#include "sinew/files/progress.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

enum class ExportMesh {
  kRefined,   ///< Every triangle of the file, split by the rig's depth.
  kOriginal,  ///< The file's own vertices in the same order, moved and with other weights.
};

enum class ExportWeights {
  kTransferred,  ///< The file's, interpolated over triangles; the four largest.
  kRefitted,     ///< Fitted to the live surface over poses (docs/export.md).
};

enum class ExportJoints {
  kOwn,      ///< The character's own joints.
  kHelpers,  ///< Also joints that move like muscles, with keys in every clip.
};

/// Allowed scale of the joint of a muscle line, for engines with limitations.
enum class JointScale {
  kFull,     ///< Any.
  kUniform,  ///< The same along all axes.
  kNone,     ///< None: two joints for each line, one below the belly, one on top.
};

[[nodiscard]] const char* nameOf(ExportMesh mesh);  ///< "refined", "refitted", "full" ...
[[nodiscard]] const char* nameOf(ExportWeights weights);
[[nodiscard]] const char* nameOf(JointScale scale);

inline constexpr int kDefaultHelpers = 24;
inline constexpr int kMostHelpers = 256;

struct SkinnedExportSettings {
  ExportJoints joints = ExportJoints::kOwn;
  ExportMesh mesh = ExportMesh::kRefined;
  ExportWeights weights = ExportWeights::kRefitted;
  std::vector<std::string> clips{};  ///< Names of the exported clips; empty: all.
  int helpers = kDefaultHelpers;     ///< Largest number of joints added by kHelpers, 0..kMostHelpers.
  JointScale jointScale = JointScale::kFull;
  bool morphs = true;  ///< Exports morph targets and their weights in the clips.
};

/// Vertex and time of a largest distance.
struct ErrorPlace {
  std::string clip;    ///< Empty: nothing was measured.
  float time = 0.0f;   ///< Seconds in the clip.
  int vertex = -1;     ///< Refined vertex of the live surface.
  std::string bone{};  ///< Bone with the largest weight at the vertex.
};

/// Distances between exported and live vertices, percent of the character's height.
struct ErrorFigures {
  double rms = 0.0;
  double percentile999 = 0.0;  ///< Largest in 99.9 % of vertices and poses, from a histogram with classes of 0.1 %.
  double largest = 0.0;
  int poses = 0;  ///< 0: nothing was measured, and the other figures are 0.
  ErrorPlace farthest{};
};

struct ClipError {
  std::string clip;
  ErrorFigures error;      ///< At the keys.
  ErrorFigures between{};  ///< Between keys, where programs interpolate; not measured for further clips.
};

struct SkinnedExportReport {
  int joints = 0;             ///< Of all skins in the file, each node once.
  int lineJoints = 0;         ///< Joints of muscle lines among them.
  int rigidHelpers = 0;       ///< Joints among them fitted to the largest remaining errors.
  std::int64_t vertices = 0;  ///< Split as in the file.
  std::int64_t triangles = 0;
  std::uint64_t bytes = 0;         ///< All written files.
  std::vector<ClipError> clips;    ///< Exported clips, at 30 poses per second.
  ErrorFigures allClips;           ///< The same poses together.
  ErrorFigures allBetween;         ///< All clips between their keys, at 47 poses per second.
  std::vector<ClipError> further;  ///< Clips that are not exported (`moving`), at 10 poses per second.
  ErrorFigures fitted;             ///< The poses to which refitted weights are fitted; also for transferred weights.
  ErrorFigures heldOut;            ///< Similar poses that are not used by the fit.
  std::vector<std::string> left;   ///< Contents of the source file that are not exported, each with the reason.
  std::shared_ptr<const ExportedSurface> played;  ///< The exported surface as played.
};

/// Writes `characterFile` again with the surface of the bind pose instead of its meshes; nodes, clips, materials,
/// images, extensions and extras stay. A .gltf comes with NAME.bin, a .usda (see docs/export.md) with its textures
/// NAME_N.png or .jpg. Writes all files or none. The same inputs give the same bytes.
/// Morph targets of the refined mesh are differences of surfaces in the bind pose; the file's own vertices keep theirs.
/// If the rig changes weights of a node, keys replace the file's weights. Errors are measured with morph targets.
/// @param file       its ending is one of ExportForm::kSkin (sinew/files/formats.h)
/// @param character  from importGltf(characterFile).
/// @param moving     the same character with additional clips (the range of motion) at the end, to which weights are
///                   fitted as well.
/// Error: the file has changed since `character` was imported, unknown clip, more than an hour of clips, an invalid
/// rig, more than a .glb can hold, a file cannot be written, or canceled. Muscles whose bone is missing are left out
/// (core/rig/attachment.h, missingBones). Never throws.
[[nodiscard]] Result<SkinnedExportReport> exportSkinned(const std::filesystem::path& characterFile,
                                                        const std::shared_ptr<const Character>& character,
                                                        const Character& moving, const Rig& rig,
                                                        const SkinnedExportSettings& settings,
                                                        const std::filesystem::path& file,
                                                        const ExportProgress& progress = {});

}  // namespace sinew
