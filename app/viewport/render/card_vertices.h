// app/viewport/render/card_vertices.h: drawn vertices that are on the graphics card already.
#pragma once

#include "sinew/geometry/geometry.h"

namespace sinew::app {

/// A buffer of vertices as SurfaceDrawer::Vertex, [D] of the surface's refinement.
struct CardVertices {
  unsigned buffer = 0;  ///< OpenGL name.
  Bounds bounds;        ///< World; holds them all.
};

}  // namespace sinew::app
