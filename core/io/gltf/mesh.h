// core/io/gltf/mesh.h: mesh primitives -> one triangle soup in the bind pose.
#pragma once

#include "core/io/gltf/accessor.h"
#include "core/io/gltf/material.h"
#include "core/io/gltf/skin.h"
#include "core/mesh/weld.h"

namespace sinew::gltf {

/// All triangles of the scene's meshes, node by node in file order. Primitives without a material get one more,
/// appended to `materials`. Vertices no triangle uses are left out. Refuses more than kMaxControlTriangles, indices and
/// joints out of range, positions and weights that are not finite; points, lines and morph targets are noted.
[[nodiscard]] TriangleSoup readTriangles(const File& file, const NodeTree& tree, const BoundSkeleton& bound,
                                         Materials& materials, Accessors& accessors, Notes& notes);

}  // namespace sinew::gltf
