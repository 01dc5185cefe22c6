// core/files/sculpt_file.h: a sculpted body from a file, as a surface alone.
#pragma once

#include <filesystem>

#include "sinew/geometry/control_mesh.h"
#include "sinew/geometry/result.h"

namespace sinew {

inline constexpr const char* kSculptEndings = ".glb, .gltf, .vrm, .obj or .ply";

/// Positions and triangles, welded, without influences. Of a .glb, .gltf or .vrm the skin in its bind pose, with or
/// without bones; of an .obj vertices and faces; of a .ply (text or binary) the elements vertex and face. Polygons
/// become fans. Untrusted input: sizes, numbers and indices are checked. Error: the file, the line or element, why.
[[nodiscard]] Result<ControlMesh> loadSculpt(const std::filesystem::path& file);

}  // namespace sinew
