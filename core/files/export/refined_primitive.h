// core/files/export/refined_primitive.h: one primitive of the file as refined: vertices split where the file splits
// them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/files/export/source.h"
#include "sinew/surface/surface.h"

namespace sinew::exporting {

/// Floats per vertex that are interpolated over the file's triangles.
struct VertexAttribute {
  std::string name;  ///< TEXCOORD_n, COLOR_n or TANGENT.
  int components = 0;
  std::vector<float> values;  ///< [vertices * components]
};

struct RefinedPrimitive {
  std::vector<int> refined;  ///< [n] refined vertex that each vertex shows.
  std::vector<int> drawn;    ///< [n] drawn vertex whose shading normal it has.
  std::vector<VertexAttribute> attributes;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< As the soup winds them.
};

/// The part's triangles, split as the surface's refinement says. Two vertices are one where they show the same drawn
/// vertex and the file's texture coordinates, colors and tangents agree at the corners they lie between. Throws
/// gltf::Refusal where an attribute cannot be read.
[[nodiscard]] RefinedPrimitive refinedPrimitive(Source& source, const gltf::SoupPart& part, const ControlMesh& mesh,
                                                const Surface& surface);

}  // namespace sinew::exporting
