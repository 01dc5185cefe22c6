// app/document/export_kinds.h: what a character can be exported as, one row a kind. docs/export.md.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "app/document/detail_override.h"
#include "sinew/character/character.h"
#include "sinew/files/baked_export.h"
#include "sinew/files/formats.h"
#include "sinew/files/progress.h"
#include "sinew/files/skinned_export.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

/// What is exported, as it was when the export was asked for. The character is shared and read only.
struct ExportSource {
  std::filesystem::path characterFile;
  std::shared_ptr<const Character> character;  ///< May have clips made in memory at its end.
  Rig rig;
  std::filesystem::path rigFile{};  ///< Named in errors of the rig; "" where it may differ from its file.
};

/// What an export may be told. A kind reads those that its row lists.
struct ExportSettings {
  ExportMesh mesh = ExportMesh::kRefined;
  ExportWeights weights = ExportWeights::kRefitted;
  DetailOverride detail{};
  std::vector<std::string> clips{};  ///< Empty: all.
  int helpers = kDefaultHelpers;     ///< 0..kMostHelpers
  JointScale jointScale = JointScale::kFull;
  double framesPerSecond = BakedExportSettings().framesPerSecond;  ///< For one clip.
  int substeps = BakedExportSettings().substeps;                   ///< Baked moments a frame, 1..kMostSubsteps
  double bound = BakedExportSettings().bound;                      ///< Percent of the height, kLeastBound..kMostBound
};

/// What came of it.
using ExportReport = std::variant<SkinnedExportReport, BakedExportReport>;

/// Some of the settings.
struct ExportFields {
  bool mesh = false;
  bool depth = false;
  bool weights = false;
  bool clips = false;
  bool helpers = false;  ///< And how they may scale.
  bool oneClip = false;  ///< Exactly one, and its frames a second.
  bool bound = false;
  bool motion = false;  ///< The one clip may be the range of motion, which no file holds.
};

struct ExportKind {
  const char* word;      ///< Said after --as; several kinds share one if their endings tell them apart.
  const char* title;     ///< "Skinned"
  const char* purpose;   ///< A sentence: what it is for.
  ExportForm form;       ///< Has the formats.
  ExportFields fields;   ///< The settings it reads.
  ExportFields settled;  ///< Those that it has no choice in: they are as without them.
  Result<ExportReport> (*run)(const ExportSource& source, const ExportSettings& settings,
                              const std::filesystem::path& file, const ExportProgress& progress);
};
/// In the order in which they are offered; the first is what there is without a choice. Never empty.
[[nodiscard]] std::span<const ExportKind> exportKinds();

/// Words of --as, each once.
[[nodiscard]] std::vector<std::string> exportWords();
/// ".glb, .gltf or .usda": those of the word's kinds.
[[nodiscard]] std::string exportEndingsOf(const std::string& word);
/// By the word of --as and the file's ending. Error: place is "--output".
[[nodiscard]] Result<const ExportKind*> findExportKind(const std::string& word, const std::filesystem::path& file);

/// The ending that a new name gets.
[[nodiscard]] std::string usualEnding(const ExportKind& kind);
/// The kind's ending is appended unless the name has one of its endings.
[[nodiscard]] std::filesystem::path withExportEnding(std::filesystem::path file, const ExportKind& kind);
/// The files that are there already and an export to `file` would replace.
[[nodiscard]] std::vector<std::filesystem::path> replacedByExport(const std::filesystem::path& file);

/// Error: an option that the kind has no use for, which would be passed over in silence; place is the option.
/// @param isGiven  whether the command line has it: "--mesh"
[[nodiscard]] Result<void> checkExportSettings(const ExportKind& kind, const ExportSettings& settings,
                                               const std::function<bool(const char* option)>& isGiven);
/// "--as skinned --mesh original ..." as words; settings that are as without them are left out.
[[nodiscard]] std::vector<std::string> exportArguments(const ExportKind& kind, const ExportSettings& settings);

/// Names of the clips that the kind can export.
[[nodiscard]] std::vector<std::string> exportableClips(const ExportKind& kind, const Character& character);

/// Error: what the rig or the clips that are chosen lack, which runExport() would refuse.
[[nodiscard]] Result<void> checkExportSource(const ExportKind& kind, const ExportSource& source,
                                             const ExportSettings& settings);

/// Frames of the one clip that the kind holds in memory; 0 for kinds that take all clips.
[[nodiscard]] double heldFrames(const ExportKind& kind, const std::shared_ptr<const Character>& character,
                                const ExportSettings& settings);

/// The kind's run(), on what all kinds agree: clips it can export, the depth asked for, no muscle without its bone.
/// Never throws.
[[nodiscard]] Result<ExportReport> runExport(const ExportKind& kind, const ExportSource& source,
                                             const ExportSettings& settings, const std::filesystem::path& file,
                                             const ExportProgress& progress);

}  // namespace sinew::app
