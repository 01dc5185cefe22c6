// app/viewport/render/line_drawer.h: lines of a width in pixels: the control mesh's edges, free segments.
#pragma once

#include <span>

#include "app/viewport/render/frame.h"

namespace sinew::app {

class LineDrawer {
 public:
  [[nodiscard]] static Result<LineDrawer> create();
  /// Edges of the skinned control mesh; those the surface hides are fainter.
  void drawControlMesh(const Frame& frame);
  /// Scene::segments with a dot at both ends, the larger at `from`; what the surface hides is fainter.
  void drawSegments(const Frame& frame);
  /// The lines of selected and hovered muscles: tendons pale, bellies in the color of their flesh.
  void drawMuscleLines(const Frame& frame);

 private:
  /// One segment, as shaders/line.vert and dot.vert read it.
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

/// Linear color of a class of segments, for legends.
[[nodiscard]] glm::vec3 segmentColor(SegmentClass kind);

}  // namespace sinew::app
