// app/viewport/render/primitive_drawer.h: primitives and how far they reach.
#pragma once

#include "app/viewport/render/frame.h"
#include "app/viewport/render/shape_mesh.h"

namespace sinew::app {

class PrimitiveDrawer {
 public:
  [[nodiscard]] static Result<PrimitiveDrawer> create();
  /// Shells and rings; what the surface hides shows through, fainter. Nothing unless shown by the settings.
  void drawShells(const Frame& frame);
  /// Outlines of what is selected and, fainter, of what is hovered, over everything.
  void drawOutlines(const Frame& frame);

 private:
  /// How one family of shells is drawn.
  struct ShellLook {
    float ringWidth = 1.0f;  ///< Pixels.
    float dashes = 0.0f;     ///< Per ring; 0: unbroken.
    float strength = 1.0f;
    float lineScale = 1.0f;
    bool meets = false;  ///< With a line where it meets the skin.
  };
  PrimitiveDrawer();
  void drawFamily(const ShapeMesh& shells, const ShellLook& look) const;
  /// Keeps the depth of what has been drawn, for the line where shells meet it.
  void copyDepth(const Frame& frame);
  void drawRims(float scale) const;
  /// Adds a shape's outline; its number for shaders/outline.vert, 0: an ellipsoid, whose outline is made there.
  [[nodiscard]] float outlineNumber(const PrimitiveShape& shape, const View& view);
  void bindOutlines() const;

  GlProgram fillProgram_;
  GlProgram ringProgram_;
  GlProgram outlineProgram_;
  ShapeMesh visible_;
  ShapeMesh influence_;
  ShapeMesh outlined_;
  ShapeMesh rims_;
  GlBuffer outlines_;
  std::vector<glm::vec4> outlinePoints_;  ///< World, of one shape after the other.
  GlTexture depth_;                       ///< Depth of the opaque things before the shells; one sample per pixel.
  GlFramebuffer depthCopy_;
  glm::ivec2 depthSize_{0};
};

}  // namespace sinew::app
