// app/document/export_report.h: the result of an export as text and JSON.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/document/export_kinds.h"

namespace sinew::app {

struct ExportResult {
  const ExportKind& kind;
  const ExportSettings& settings;
  const std::filesystem::path& file;
  const ExportReport& report;
};

[[nodiscard]] std::string exportJson(const ExportResult& result);  ///< docs/formats.md
[[nodiscard]] std::string exportText(const ExportResult& result);  ///< A table for people.

/// "RMS 0.15 % of the height, largest 2.2 % in "Walk" at 0.31 s on thigh.L; 24 joints; 660 KB"
[[nodiscard]] std::string exportFigures(const ExportReport& report);
/// Figures with the largest distance over all clips, at keys and between; null: nothing was measured.
[[nodiscard]] const ErrorFigures* farthestOf(const ExportReport& report);
[[nodiscard]] std::string largestText(const ErrorFigures& error);  ///< "6.9 % in "Walk" at 0.31 s on thigh.L"
/// The surface that the file shows; null for baked points.
[[nodiscard]] std::shared_ptr<const ExportedSurface> playedBy(const ExportReport& report);
/// Parts of the source file that were left out, with reasons.
[[nodiscard]] const std::vector<std::string>& leftOut(const ExportReport& report);

}  // namespace sinew::app
