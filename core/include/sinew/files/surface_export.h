// core/include/sinew/files/surface_export.h: one surface as .obj, .ply or .glb.
#pragma once

#include <filesystem>
#include <string>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/surface/surface.h"

namespace sinew {

/// Whether the ending is one that exportSurface writes; capitals too.
[[nodiscard]] bool isExportName(const std::filesystem::path& file);
/// Those endings: ".obj, .ply or .glb".
[[nodiscard]] std::string exportNameEndings();

/// Format by ending. .obj: one v and vn per refined vertex, shared across seams, so that a closed surface is closed in
/// the file (vn per drawn vertex where the surface has creases); vt per wedge; nine significant digits; one usemtl per
/// material run; materials and textures go into files beside it, NAME.mtl and NAME_0.png ... (spaces in NAME become "_"
/// there). .ply (binary little endian) and .glb split per wedge; .glb carries materials and all their maps. Vertex
/// colors, where the mesh has any, are COLOR_0 in .glb (floats, linear) and red, green, blue, alpha in .ply (8 bits,
/// sRGB); .obj has no place for them. Materials keep their alpha (Material::shownOpaque is not written). Normals are
/// the shading normals. .obj and .ply count v upwards, as their readers do; glTF counts it downwards. Each file is
/// written atomically, the one named last. Error: unknown ending, nothing to write, more than a .glb can hold, or a
/// file cannot be written.
[[nodiscard]] Result<void> exportSurface(const Surface& surface, const Character& character,
                                         const std::filesystem::path& file);

}  // namespace sinew
