// core/files/export/formats.h: the table of export formats, one row for each format and form.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/export/gltf_rewrite.h"
#include "core/files/export/source.h"
#include "sinew/files/baked_export.h"
#include "sinew/files/formats.h"

namespace sinew::exporting {

/// Writes a finished glTF. Returns the bytes of all files. Throws gltf::Refusal.
/// @param left  receives what the format cannot hold
using WriteSkin = Result<std::uint64_t>(const Source& source, const PackedGltf& packed,
                                        const std::filesystem::path& file, std::vector<std::string>& left);
WriteSkin writeGlb, writeGltf, writeUsd;

/// exportBaked() for this format. Throws gltf::Refusal, Canceled.
using BakeClip = Result<BakedExportReport>(Source& source, const std::shared_ptr<const Character>& character,
                                           const Rig& rig, const BakedExportSettings& settings,
                                           const std::filesystem::path& file, const ExportProgress& progress);
BakeClip bakeTargets, bakeStage, bakeCache;

struct ExportFormat {
  std::string_view ending;  ///< Lower case.
  ExportForm form;
  WriteSkin* writeSkin = nullptr;             ///< For ExportForm::kSkin.
  BakeClip* bakeClip = nullptr;               ///< For the other forms.
  std::array<std::string_view, 2> besides{};  ///< Endings of side files.
};

/// By the name's ending; null: none of the forms has that ending.
[[nodiscard]] const ExportFormat* findFormat(const std::filesystem::path& file, const std::vector<ExportForm>& forms);

}  // namespace sinew::exporting
