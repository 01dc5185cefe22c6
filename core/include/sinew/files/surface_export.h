// core/include/sinew/files/surface_export.h: exports one surface as .obj, .ply or .glb.
#pragma once

#include <filesystem>
#include <string>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/surface/surface.h"

namespace sinew {

/// The ending is one that exportSurface() writes, in any case.
[[nodiscard]] bool isExportName(const std::filesystem::path& file);
[[nodiscard]] std::string exportNameEndings();  ///< ".obj, .ply or .glb"

/// Format by ending. .obj: one v and vn per refined vertex, shared across seams, so that a closed surface is closed in
/// the file (vn per drawn vertex if the surface has creases); vt per wedge; nine significant digits; one usemtl per
/// material run; materials and textures in NAME.mtl and NAME_0.png ... (spaces in NAME become "_" there). .ply (binary
/// little endian) and .glb are split per wedge; .glb has materials and all their maps. Vertex colors, if any, are
/// COLOR_0 in .glb (floats, linear) and red, green, blue, alpha in .ply (8 bits, sRGB); .obj has none. Materials keep
/// their alpha (Material::shownOpaque is not written). Normals are the shading normals. v points upwards in .obj and
/// .ply, downwards in glTF. Each file is written atomically, the named one last. Error: unknown ending, nothing to
/// write, more than a .glb can hold, or a file cannot be written.
[[nodiscard]] Result<void> exportSurface(const Surface& surface, const Character& character,
                                         const std::filesystem::path& file);

}  // namespace sinew
