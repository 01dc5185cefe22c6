// core/include/sinew/files/formats.h: which file formats hold which form of a character.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sinew/geometry/same_version.h"

namespace sinew {

/// The forms in which a character's surface can be exported.
enum class ExportForm {
  kSkin,     ///< Joints and weights, all clips.
  kTargets,  ///< One clip: joints, weights and animated morph targets.
  kStage,    ///< One clip: every vertex in every frame, with materials.
  kCache,    ///< The same as bare points, beside a mesh.
};

/// Endings of the formats that hold one of the forms, lower case, each once; the first is the usual one.
[[nodiscard]] std::vector<std::string> exportEndings(const std::vector<ExportForm>& forms);

/// Whether the name has one of these endings; capitals too.
[[nodiscard]] bool hasExportEnding(const std::filesystem::path& file, const std::vector<ExportForm>& forms);

/// The files that an export consists of, the one named last; without textures: how many there are is not known before.
[[nodiscard]] std::vector<std::filesystem::path> exportedFiles(const std::filesystem::path& file);

}  // namespace sinew
