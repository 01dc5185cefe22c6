// app/cli/export_verb.h: what `sinew export` is told, and what it says it made.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/batch.h"
#include "sinew/base/result.h"
#include "sinew/export/baked_export.h"
#include "sinew/export/skinned_export.h"

namespace sinew::app {

/// What is not given is what the kind takes without it.
struct ExportOptions {
  std::filesystem::path file;  ///< Rig or character.
  std::filesystem::path output;
  std::string kind = "helpers";
  std::optional<std::string> mesh;
  std::optional<std::string> weights;
  std::optional<int> depth;
  std::vector<std::string> clips;
  std::optional<int> helpers;
  std::optional<std::string> jointScale;
  std::optional<double> framesPerSecond;
  std::optional<double> bound;  ///< Percent of the height.
  int threads = 0;              ///< At most; 0: one a core.
  bool json = false;
  BatchOptions batch;
};

void addExportOptions(CLI::App& verb, ExportOptions& options);

/// Error: an option or an ending that the kind of export has no use for; it would be passed over in silence.
[[nodiscard]] Result<void> checkExportOptions(const ExportOptions& options);

[[nodiscard]] SkinnedExportSettings skinnedSettings(const ExportOptions& options);
/// @param options  checked, of --as baked
[[nodiscard]] BakedExportSettings bakedSettings(const ExportOptions& options);

/// As options.json asks: a JSON document, or lines for people.
[[nodiscard]] std::string reportText(const ExportOptions& options, const std::filesystem::path& output,
                                     const SkinnedExportReport& report);
[[nodiscard]] std::string reportText(const ExportOptions& options, const std::filesystem::path& output,
                                     const BakedExportReport& report);

}  // namespace sinew::app
