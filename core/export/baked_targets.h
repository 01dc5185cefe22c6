// core/export/baked_targets.h: a baked clip as joints and morph targets, in glTF.
#pragma once

#include <filesystem>
#include <memory>

#include "core/export/source.h"
#include "sinew/export/baked_export.h"

namespace sinew::exporting {

/// As exportBaked() for .glb and .gltf. Throws gltf::Refusal, Cancelled.
[[nodiscard]] Result<BakedExportReport> bakeTargets(Source& source, const std::shared_ptr<const Character>& character,
                                                    const Rig& rig, const BakedExportSettings& settings,
                                                    const std::filesystem::path& file, const ExportProgress& progress);

}  // namespace sinew::exporting
