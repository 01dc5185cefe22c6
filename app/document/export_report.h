// app/document/export_report.h: what an export has made, in words and as JSON.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/document/export_kinds.h"

namespace sinew::app {

/// One that is done.
struct ExportResult {
  const ExportKind& kind;
  const ExportSettings& settings;
  const std::filesystem::path& file;
  const ExportReport& report;
};

/// A document (docs/formats.md), or lines for people.
[[nodiscard]] std::string exportJson(const ExportResult& result);
[[nodiscard]] std::string exportText(const ExportResult& result);

/// "RMS 0.15 % of the height, largest 2.2 % in "Walk" at 0.31 s on thigh.L; 24 joints; 660 KB"
[[nodiscard]] std::string exportFigures(const ExportReport& report);
/// The figures whose largest distance is the largest over all clips, at keys and between them; null: none was measured.
[[nodiscard]] const ErrorFigures* farthestOf(const ExportReport& report);
/// "6.9 % in "Walk" at 0.31 s on thigh.L"; with a place
[[nodiscard]] std::string largestText(const ErrorFigures& error);
/// What the file shows; null for baked points, which are the live surface.
[[nodiscard]] std::shared_ptr<const ExportedSurface> playedBy(const ExportReport& report);
/// What of the source file is not in the export, each with the reason.
[[nodiscard]] const std::vector<std::string>& leftOut(const ExportReport& report);

}  // namespace sinew::app
