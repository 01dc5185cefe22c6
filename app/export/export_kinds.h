// app/export/export_kinds.h: what a character can be exported as, one row a kind. docs/export.md.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/character/character.h"
#include "sinew/export/baked_export.h"
#include "sinew/export/progress.h"
#include "sinew/export/skinned_export.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

/// What is exported, as it was when the export was asked for. The character is shared and read only.
struct ExportSource {
  std::filesystem::path characterFile;
  std::shared_ptr<const Character> character;  ///< May have clips made in memory at its end; they are not exported.
  Rig rig;
};

/// What an export may be told. A kind reads those that its row lists.
struct ExportSettings {
  ExportMesh mesh = ExportMesh::kRefined;
  ExportWeights weights = ExportWeights::kRefitted;
  std::optional<int> depth{};        ///< 1..kMaxDepth; none: the rig's.
  std::vector<std::string> clips{};  ///< Empty: all.
  int helpers = kDefaultHelpers;     ///< 0..kMostHelpers
  JointScale jointScale = JointScale::kFull;
  double framesPerSecond = BakedExportSettings().framesPerSecond;  ///< Of one clip.
  double bound = BakedExportSettings().bound;                      ///< Percent of the height, kLeastBound..kMostBound
};

/// What came of it.
struct ExportSummary {
  std::string figures;            ///< "RMS 0.15 % of the height, largest 2.2 %; 24 joints; 660 KB"
  std::vector<std::string> left;  ///< What of the source file is not in the export, each with the reason.
};

/// Which of the settings a kind reads.
struct ExportFields {
  bool mesh = false;
  bool depth = false;
  bool weights = false;
  bool clips = false;
  bool helpers = false;  ///< And how they may scale.
  bool oneClip = false;  ///< Exactly one, and its frames a second.
  bool bound = false;
};

struct ExportKind {
  const char* word;                      ///< Of --as.
  const char* title;                     ///< "Skinned"
  const char* purpose;                   ///< A sentence: what it is for.
  std::span<const char* const> endings;  ///< Lower case; the first is the one that a new name gets.
  ExportFields fields;
  Result<ExportSummary> (*run)(const ExportSource& source, const ExportSettings& settings,
                               const std::filesystem::path& file, const ExportProgress& progress);
};
/// In the order in which they are offered. Never empty.
[[nodiscard]] std::span<const ExportKind> exportKinds();

/// The kind's ending is appended unless the name has one of its endings.
[[nodiscard]] std::filesystem::path withExportEnding(std::filesystem::path file, const ExportKind& kind);
/// The files that are there already and an export to `file` would replace.
[[nodiscard]] std::vector<std::filesystem::path> replacedByExport(const std::filesystem::path& file);

/// "--as skinned --mesh original ..." as words; settings that are as without them are left out.
[[nodiscard]] std::vector<std::string> exportArguments(const ExportKind& kind, const ExportSettings& settings);

/// Names of the clips that the character's file has.
[[nodiscard]] std::vector<std::string> exportableClips(const Character& character);

/// The kind's run(), on what all kinds agree: clips of the file alone, the depth asked for, no muscle without its bone.
/// Never throws.
[[nodiscard]] Result<ExportSummary> runExport(const ExportKind& kind, const ExportSource& source,
                                              const ExportSettings& settings, const std::filesystem::path& file,
                                              const ExportProgress& progress);

}  // namespace sinew::app
