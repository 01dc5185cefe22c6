// app/viewport/render/overlay_drawers.h: bones and lines over the surface.
#pragma once

#include <span>

#include "app/viewport/render/frame.h"
#include "app/viewport/render/shape_mesh.h"

namespace sinew::app {

/// Maps the segment from the origin to y = 1 to that from head to tail, `width` wide on each side.
[[nodiscard]] glm::mat4 boneAlong(const glm::vec3& head, const glm::vec3& tail, float width);

/// Bones as octahedra and joints as balls, in x-ray.
class SkeletonDrawer {
 public:
  [[nodiscard]] static Result<SkeletonDrawer> create();
  /// The bones of DisplaySettings::skeleton (with `anatomy` only the selected and the hovered one) and of
  /// Scene::territoryBones. Needs a pose. Clears the depth, so that bones hide only one another: draw last.
  void draw(const Frame& frame);

 private:
  SkeletonDrawer();
  void place(const Frame& frame);
  void drawAll(float swell) const;

  GlProgram program_;
  ShapeMesh bones_;
  ShapeMesh joints_;
};

/// Lines of a width in pixels.
class LineDrawer {
 public:
  [[nodiscard]] static Result<LineDrawer> create();
  void drawControlMesh(const Frame& frame);  ///< Edges of the skinned control mesh; fainter where hidden.
  /// Scene::segments with a dot at both ends, the larger one at `from`; fainter where hidden.
  void drawSegments(const Frame& frame);
  /// Lines of selected and hovered muscles: pale at tendons, flesh-colored at bellies.
  void drawMuscleLines(const Frame& frame);

 private:
  /// Input of shaders/line.vert and dot.vert.
  struct Line {
    glm::vec3 from;
    glm::vec3 to;
    glm::vec4 color;  ///< Linear; opacity in w.
  };
  LineDrawer();
  void draw(std::span<const Line> lines, float width, const glm::vec2& dotRadii, float hidden) const;

  GlProgram program_;
  GlProgram dotProgram_;
  GlVertexArray array_;
  GlBuffer lines_;
};

[[nodiscard]] glm::vec3 segmentColor(SegmentClass kind);  ///< Linear color of a class of segments, for legends.

}  // namespace sinew::app
