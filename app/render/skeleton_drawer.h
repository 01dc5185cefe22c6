// app/render/skeleton_drawer.h: bones as octahedra and joints as balls, over everything.
#pragma once

#include "app/render/frame.h"
#include "app/render/shape_mesh.h"

namespace sinew::app {

class SkeletonDrawer {
 public:
  [[nodiscard]] static Result<SkeletonDrawer> create();
  /// All bones, or without DisplaySettings::skeleton those of Scene::territoryBones. The scene has a pose. Clears the
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
