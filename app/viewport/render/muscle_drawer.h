// app/viewport/render/muscle_drawer.h: muscles as flesh and tendons under glassy skin.
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

  void place(const Frame& frame);            ///< Sets the muscles to draw.
  void drawFlesh(const Frame& frame) const;  ///< Bellies, tendons and, where the skeleton is shown, bones: opaque.
  void drawDepths() const;                   ///< The same with shaders/depth.frag for ScreenOcclusion.
  void drawHollows() const;                  ///< Translucent volumes that carves remove.
  /// The nearest layer of skin before the muscles, written to the depth too.
  void drawGlass(const Frame& frame, const SurfaceDrawer& surface) const;

 private:
  /// One part of a tendon: input of shaders/tendon.vert.
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
  struct Programs {
    GlProgram belly, tendon, bone;
  };
  void drawBodies(const Programs& programs) const;

  Programs lit_, depth_;
  GlProgram hollow_, glass_, glassDepth_, wiredGlass_;
  ShapeMesh bellies_, smallBellies_;  ///< By size in the picture.
  ShapeMesh hollows_, bones_;
  std::size_t hollowCount_ = 0;
  GlVertexArray tendonArray_;
  GlBuffer tendonBuffer_, tendonIndices_;
  std::vector<TendonInstance> tendons_;
};

/// Unit ball -> world with y along the fibres: the axis with the longest radius, y if equal; always y for shapes.
[[nodiscard]] glm::mat4 alongFibres(const PrimitiveShape& shape);

}  // namespace sinew::app
