#pragma once  // app/render/line_drawer.h: the control mesh's edges.

#include "app/render/frame.h"

namespace sinew::app {

class LineDrawer {
 public:
  [[nodiscard]] static Result<LineDrawer> create();
  /// Edges of the skinned control mesh; those the surface hides are fainter.
  void drawControlMesh(const Frame& frame);

 private:
  LineDrawer();

  GlProgram program_;
  GlVertexArray array_;
  GlBuffer segments_;
};

}  // namespace sinew::app
