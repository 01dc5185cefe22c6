// app/command/error_map.h: how far an export is off, vertex by vertex, as a mesh.
#pragma once

#include <filesystem>

#include "sinew/files/exported_surface.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

/// A binary .ply with the exported mesh in the bind pose. Each vertex has x, y, z, red, green, blue and "error", its
/// largest distance to the live surface in percent of the height. White is none, the darkest red the largest of all.
[[nodiscard]] Result<void> writeErrorMap(const ExportedSurface& exported, const std::filesystem::path& file);

}  // namespace sinew::app
