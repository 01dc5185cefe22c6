#pragma once  // app/render/primitive_drawer.h: ellipsoids and how far they reach.

#include "app/render/frame.h"
#include "app/render/shape_mesh.h"

namespace sinew::app {

class PrimitiveDrawer {
 public:
  [[nodiscard]] static Result<PrimitiveDrawer> create();
  /// What the surface hides shows through, fainter.
  void draw(const Frame& frame);

 private:
  PrimitiveDrawer();
  void drawShells(const ShapeMesh& shells, float width, float dashes, float strength) const;

  GlProgram fillProgram_;
  GlProgram ringProgram_;
  ShapeMesh visible_;
  ShapeMesh influence_;
};

}  // namespace sinew::app
