// app/viewport/render/skeleton_drawer.h: bones as octahedra and joints as balls, over everything.
#pragma once

#include "app/viewport/render/frame.h"
#include "app/viewport/render/shape_mesh.h"

namespace sinew::app {

/// From the origin to y = 1 -> from head to tail, `width` wide on each side.
[[nodiscard]] glm::mat4 boneAlong(const glm::vec3& head, const glm::vec3& tail, float width);

class SkeletonDrawer {
 public:
  [[nodiscard]] static Result<SkeletonDrawer> create();
  /// All bones, or without DisplaySettings::skeleton those of Scene::territoryBones; with DisplaySettings::anatomy,
  /// which has bones of its own, the selected and the hovered one. The scene has a pose. Clears the
  /// depth, so that bones hide only one another: draw last.
  void draw(const Frame& frame);

 private:
  SkeletonDrawer();
  void place(const Frame& frame);
  void drawAll(float swell) const;

  GlProgram program_;
  ShapeMesh bones_;
  ShapeMesh joints_;
};

}  // namespace sinew::app
