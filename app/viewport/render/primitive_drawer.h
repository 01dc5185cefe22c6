// app/viewport/render/primitive_drawer.h: shells and outlines of primitives.
#pragma once

#include "app/viewport/render/frame.h"
#include "app/viewport/render/shape_mesh.h"

namespace sinew::app {

class PrimitiveDrawer {
 public:
  [[nodiscard]] static Result<PrimitiveDrawer> create();
  void drawShells(const Frame& frame);    ///< Shells and rings, as the settings choose; fainter behind the surface.
  void drawOutlines(const Frame& frame);  ///< Outlines of selected and, fainter, hovered primitives, over everything.

 private:
  struct ShellLook {
    float ringWidth = 1.0f;  ///< Pixels.
    float dashes = 0.0f;     ///< Per ring; 0: solid.
    float strength = 1.0f;
    float lineScale = 1.0f;
    bool meets = false;  ///< With a line along the skin.
  };
  PrimitiveDrawer();
  void drawFamily(const ShapeMesh& shells, const ShellLook& look) const;
  void copyDepth(const Frame& frame);  ///< Copies the depth drawn so far, for the line where shells meet the skin.
  void drawRims(float scale) const;
  /// Adds a shape's outline; of a belly of a sheet what lies beside the sheet's other bellies.
  /// @return its number for shaders/outline.vert; 0: an ellipsoid, computed there
  [[nodiscard]] float outlineNumber(const PrimitiveShape& shape, const View& view, const Scene& scene);
  void bindOutlines() const;

  GlProgram fillProgram_, ringProgram_, outlineProgram_;
  ShapeMesh visible_, influence_, outlined_, rims_;
  GlBuffer outlines_;
  std::vector<glm::vec4> outlinePoints_;  ///< World, shape by shape; w: 1, or 0 where it is not drawn.
  GlTexture depth_;                       ///< Depth of opaque things; one sample per pixel.
  GlFramebuffer depthCopy_;
  glm::ivec2 depthSize_{0};
};

}  // namespace sinew::app
