// core/include/sinew/files/skinned_export.h: a character with its muscles at rest as glTF that any engine plays.
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
  kRefined,   ///< Every triangle of the file as the rig's depth splits it.
  kOriginal,  ///< The file's own vertices, in its order; moved, with other weights.
};

enum class ExportWeights {
  kTransferred,  ///< The file's, interpolated over the triangles; the four largest.
  kRefitted,     ///< Fitted to the live surface over poses (docs/export.md).
};

enum class ExportJoints {
  kOwn,      ///< The character's own joints.
  kHelpers,  ///< And joints that move as muscles do, keyed in every clip.
};

/// How a muscle line's joint may scale, for engines that cannot do all.
enum class JointScale {
  kFull,     ///< Along each of its axes.
  kUniform,  ///< Alike along all.
  kNone,     ///< Not at all: two joints a line, one under the belly, one on top.
};

/// "refined", "refitted", "full" ...
[[nodiscard]] const char* nameOf(ExportMesh mesh);
[[nodiscard]] const char* nameOf(ExportWeights weights);
[[nodiscard]] const char* nameOf(JointScale scale);

inline constexpr int kDefaultHelpers = 24;
inline constexpr int kMostHelpers = 256;

struct SkinnedExportSettings {
  ExportJoints joints = ExportJoints::kOwn;
  ExportMesh mesh = ExportMesh::kRefined;
  ExportWeights weights = ExportWeights::kRefitted;
  std::vector<std::string> clips{};  ///< Names of those to keep; empty: all.
  int helpers = kDefaultHelpers;     ///< Joints that kHelpers may add, 0..kMostHelpers.
  JointScale jointScale = JointScale::kFull;
  bool morphs = true;  ///< Morph targets come along, with their weights in the clips.
};

/// The vertex and the moment of a largest distance.
struct ErrorPlace {
  std::string clip;    ///< Empty: nothing was measured.
  float time = 0.0f;   ///< Seconds into it.
  int vertex = -1;     ///< Of the refined vertices of the live surface.
  std::string bone{};  ///< That the vertex follows most.
};

/// Distances between exported and live vertices, percent of the character's height.
struct ErrorFigures {
  double rms = 0.0;
  double percentile999 = 0.0;  ///< At most this in 99.9 of 100 vertices and poses; read from classes 0.1 % wide.
  double largest = 0.0;
  int poses = 0;  ///< 0: nothing was measured, the others are 0.
  ErrorPlace farthest{};
};

struct ClipError {
  std::string clip;
  ErrorFigures error;      ///< At the keys.
  ErrorFigures between{};  ///< Between keys, where a program interpolates them; not measured of further clips.
};

struct SkinnedExportReport {
  int joints = 0;             ///< Those of all skins in the file, each node once.
  int lineJoints = 0;         ///< Among them those of muscle lines ...
  int rigidHelpers = 0;       ///< ... and those fitted where most error was left.
  std::int64_t vertices = 0;  ///< As the file splits them.
  std::int64_t triangles = 0;
  std::uint64_t bytes = 0;         ///< All files that were written.
  std::vector<ClipError> clips;    ///< Those exported, at 30 poses a second.
  ErrorFigures allClips;           ///< The same poses together.
  ErrorFigures allBetween;         ///< All clips between their keys, at 47 poses a second.
  std::vector<ClipError> further;  ///< Clips that are not exported (`moving`), at 10 poses a second.
  ErrorFigures fitted;            ///< The poses that refitted weights are fitted to; measured for transferred ones too.
  ErrorFigures heldOut;           ///< Poses of the same kind, but kept from the fit.
  std::vector<std::string> left;  ///< What of the source file is not in the export, each with the reason.
  std::shared_ptr<const ExportedSurface> played;  ///< What the file shows.
};

/// Morph targets: the refined mesh has each as the surface with it at 1 less that with none, in the bind pose; the
/// file's own vertices keep theirs. Where the rig changes weights of a node, keys replace the file's. What is printed
/// of errors includes them.
/// Writes `characterFile` again with the surface of the bind pose in place of its meshes; nodes, clips, materials,
/// images, extensions and extras stay as they are there. A .gltf has NAME.bin beside it; a .usda, which holds what USD
/// can say of it (docs/export.md), its textures NAME_N.png or .jpg. All are whole or not written.
/// Same inputs give the same bytes.
/// @param file       its ending is one of ExportForm::kSkin (sinew/files/formats.h)
/// @param character  as importGltf(characterFile) gave it.
/// @param moving     the same character, with the clips that weights are also fitted to (the range of motion) at the
///                   end of its own.
/// Error: the file is no longer what `character` was imported from, unknown clip, clips of more than an hour together,
/// an invalid rig, more than a .glb holds, a file cannot be written, or canceled. Muscles whose bone is missing are
/// left out (core/rig/attachment.h, missingBones). Never throws.
[[nodiscard]] Result<SkinnedExportReport> exportSkinned(const std::filesystem::path& characterFile,
                                                        const std::shared_ptr<const Character>& character,
                                                        const Character& moving, const Rig& rig,
                                                        const SkinnedExportSettings& settings,
                                                        const std::filesystem::path& file,
                                                        const ExportProgress& progress = {});

}  // namespace sinew
