// core/include/sinew/files/formats.h: file formats for the forms of an exported character.
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
  kCache,    ///< One clip: every vertex in every frame as bare points, next to a mesh.
};

/// Endings of the formats for these forms, lower case, each once; the first is the default.
[[nodiscard]] std::vector<std::string> exportEndings(const std::vector<ExportForm>& forms);

/// The name has one of these endings, in any case.
[[nodiscard]] bool hasExportEnding(const std::filesystem::path& file, const std::vector<ExportForm>& forms);

/// Files of an export without textures, whose number is not known before; the named one is last.
[[nodiscard]] std::vector<std::filesystem::path> exportedFiles(const std::filesystem::path& file);

}  // namespace sinew
