// app/document/export_kinds.h: the kinds of character export. docs/export.md.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/files/baked_export.h"
#include "sinew/files/formats.h"
#include "sinew/files/progress.h"
#include "sinew/files/skinned_export.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

/// Detail in place of the rig's.
struct DetailOverride {
  std::optional<int> depth{};        ///< 1..kMaxDepth; implies uniform detail.
  std::optional<DetailKind> kind{};  ///< Overrides what depth or tolerance imply.
  std::optional<float> tolerance{};  ///< kLeastTolerance..kMostTolerance; implies adaptive detail.

  friend bool operator==(const DetailOverride&, const DetailOverride&) = default;

  /// Depth or tolerance switch automatic detail off.
  void apply(SmoothingSettings& smoothing) const {
    if (depth) smoothing.depth = *depth;
    if (tolerance) smoothing.tolerance = *tolerance;
    if (depth) smoothing.detail = DetailKind::kUniform;
    else if (tolerance) smoothing.detail = DetailKind::kAdaptive;
    smoothing.detail = kind.value_or(smoothing.detail);
    if (depth || tolerance) smoothing.autoDepth = false;
  }
};

/// The character and rig to export.
struct ExportSource {
  std::filesystem::path characterFile;
  std::shared_ptr<const Character> character;  ///< May end with clips made in memory.
  Rig rig;
  std::filesystem::path rigFile{};  ///< For errors; "": the rig may differ from its file.
};

/// Settings of exports. Each kind reads those in its row.
struct ExportSettings {
  ExportMesh mesh = ExportMesh::kRefined;
  ExportWeights weights = ExportWeights::kRefitted;
  DetailOverride detail{};
  std::vector<std::string> clips{};  ///< Empty: all.
  int helpers = kDefaultHelpers;     ///< 0..kMostHelpers
  JointScale jointScale = JointScale::kFull;
  double framesPerSecond = BakedExportSettings().framesPerSecond;  ///< For one clip.
  int substeps = BakedExportSettings().substeps;                   ///< Baked samples a frame, 1..kMostSubsteps
  double bound = BakedExportSettings().bound;                      ///< Percent of the height, kLeastBound..kMostBound
};

using ExportReport = std::variant<SkinnedExportReport, BakedExportReport>;

/// Some of the settings.
struct ExportFields {
  bool mesh = false;
  bool depth = false;
  bool weights = false;
  bool clips = false;
  bool helpers = false;  ///< With jointScale.
  bool oneClip = false;  ///< Exactly one clip, with framesPerSecond.
  bool bound = false;
  bool motion = false;  ///< The clip may be the range of motion, which no file holds.
};

struct ExportKind {
  const char* word;      ///< After --as; kinds with different endings may share one.
  const char* title;     ///< "Skinned"
  const char* purpose;   ///< One sentence.
  ExportForm form;       ///< Has the formats.
  ExportFields fields;   ///< The settings it reads.
  ExportFields settled;  ///< Settings that keep their defaults.
  Result<ExportReport> (*run)(const ExportSource& source, const ExportSettings& settings,
                              const std::filesystem::path& file, const ExportProgress& progress);
};
[[nodiscard]] std::span<const ExportKind> exportKinds();  ///< In menu order; the first is the default. Never empty.

[[nodiscard]] std::vector<std::string> exportWords();                ///< Words of --as, each once.
[[nodiscard]] std::string exportEndingsOf(const std::string& word);  ///< ".glb, .gltf or .usda": of the word's kinds.
/// By the word of --as and the file's ending. Error: place is "--output".
[[nodiscard]] Result<const ExportKind*> findExportKind(const std::string& word, const std::filesystem::path& file);

[[nodiscard]] std::string usualEnding(const ExportKind& kind);  ///< Ending of a new name.
/// Appends the usual ending unless the name has one of the kind's.
[[nodiscard]] std::filesystem::path withExportEnding(std::filesystem::path file, const ExportKind& kind);
/// Existing files that an export to `file` would replace.
[[nodiscard]] std::vector<std::filesystem::path> replacedByExport(const std::filesystem::path& file);

/// Error: an option that the kind does not read; place is it. @param isGiven  on the command line: "--mesh"
[[nodiscard]] Result<void> checkExportSettings(const ExportKind& kind, const ExportSettings& settings,
                                               const std::function<bool(const char* option)>& isGiven);
/// Words for the command line ("--as skinned --mesh original ..."), without defaults.
[[nodiscard]] std::vector<std::string> exportArguments(const ExportKind& kind, const ExportSettings& settings);

/// Names of the clips that the kind can export.
[[nodiscard]] std::vector<std::string> exportableClips(const ExportKind& kind, const Character& character);

/// Error: runExport() would refuse the rig or the chosen clips.
[[nodiscard]] Result<void> checkExportSource(const ExportKind& kind, const ExportSource& source,
                                             const ExportSettings& settings);

/// Frames that the kind holds in memory; 0 for kinds that take all clips.
[[nodiscard]] double heldFrames(const ExportKind& kind, const std::shared_ptr<const Character>& character,
                                const ExportSettings& settings);

/// Runs the export with the clips that the kind can take and the detail override applied. Never throws.
[[nodiscard]] Result<ExportReport> runExport(const ExportKind& kind, const ExportSource& source,
                                             const ExportSettings& settings, const std::filesystem::path& file,
                                             const ExportProgress& progress);

}  // namespace sinew::app
