#pragma once  // core/io/surface_export.h: one surface as .obj, .ply or .glb.

#include <filesystem>

#include "core/base/result.h"
#include "core/character/character.h"
#include "core/smoothing/surface.h"

namespace sinew {

/// Format by ending. .obj: one v and vn per refined vertex, shared across seams, so that a closed surface is closed in the
/// file; vt per wedge; nine significant digits; one usemtl per material run. .ply (binary little endian) and .glb split per
/// wedge; .glb carries materials and textures. Written atomically. Error: unknown ending, or the file cannot be written.
[[nodiscard]] Result<void> exportSurface(const Surface& surface, const Character& character, const std::filesystem::path& file);

}  // namespace sinew
