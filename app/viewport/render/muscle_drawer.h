// app/viewport/render/muscle_drawer.h: muscles as in an anatomy book: flesh, tendons, and the skin as glass over them.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "app/viewport/render/frame.h"
#include "app/viewport/render/shape_mesh.h"
#include "app/viewport/render/surface_drawer.h"

namespace sinew::app {

class MuscleDrawer {
 public:
  [[nodiscard]] static Result<MuscleDrawer> create();

  /// Takes the muscles of the frame's scene for all that follows.
  void place(const Frame& frame);
  /// Bellies, tendons and, where the skeleton is shown, bones: opaque.
  void drawFlesh(const Frame& frame) const;
  /// The same for ScreenOcclusion, as shaders/depth.frag writes it.
  void drawDepths() const;
  /// What carves take away, seen through.
  void drawHollows() const;
  /// The nearest layer of the skin that no muscle hides; it takes its place in the depth too.
  void drawGlass(const Frame& frame, const SurfaceDrawer& surface) const;

 private:
  /// One part of a tendon, as shaders/tendon.vert reads it.
  struct TendonInstance {
    std::array<glm::vec4, 4> curve{};
    glm::vec4 halfX{0.0f};
    glm::vec4 halfZ{0.0f};
    glm::vec4 fibres{0.0f};
    glm::vec4 style{0.0f};
  };
  MuscleDrawer();
  void addTendons(const PrimitiveShape& shape, const ShapeInstance& belly, float height);
  void addBones(const Frame& frame);
  /// What makes vertices of bellies, tendons and bones, each with the same fragments.
  struct Programs {
    GlProgram belly, tendon, bone;
  };
  void drawBodies(const Programs& programs) const;

  Programs lit_, depth_;
  GlProgram hollow_, glass_, glassDepth_, wiredGlass_;
  ShapeMesh bellies_;       ///< Those that are large in the picture,
  ShapeMesh smallBellies_;  ///< and the others.
  ShapeMesh hollows_;
  ShapeMesh bones_;
  std::size_t hollowCount_ = 0;
  GlVertexArray tendonArray_;
  GlBuffer tendonBuffer_;
  GlBuffer tendonIndices_;
  std::vector<TendonInstance> tendons_;
};

/// Unit ball -> world with y along the fibres: the longest of the muscle's radii, and of equal ones y; of a shape y.
[[nodiscard]] glm::mat4 alongFibres(const PrimitiveShape& shape);

}  // namespace sinew::app
