// core/export/baked_points.h: a baked clip as points over time: .pc2, .mdd, .usda.
#pragma once

#include <filesystem>
#include <memory>

#include "core/export/source.h"
#include "sinew/export/baked_export.h"

namespace sinew::exporting {

/// As exportBaked() for names of baked points. Throws gltf::Refusal, Cancelled.
[[nodiscard]] Result<BakedExportReport> bakePoints(Source& source, const std::shared_ptr<const Character>& character,
                                                   const Rig& rig, const BakedExportSettings& settings,
                                                   const std::filesystem::path& file, const ExportProgress& progress);

}  // namespace sinew::exporting
