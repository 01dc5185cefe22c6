// app/viewport/render/shape_mesh.h: a small fixed mesh drawn many times: balls and bones.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "app/viewport/render/gl_objects.h"
#include "app/viewport/render/scene.h"

namespace sinew::app {

/// The numbers of a shape, in the order of shapeNumbers(), four to a vector: shaders/form.glsl takes them apart.
using FormVectors = std::array<glm::vec4, (kShapeNumbers + 3) / 4>;

/// One copy, as shaders/shape.vert and ring.vert read it.
struct ShapeInstance {
  glm::mat4 shapeInWorld{1.0f};
  glm::vec4 color{1.0f};  ///< Linear, opacity in w.
  glm::vec4 style{0.0f};  ///< Outline, glow: 0..1.
  FormVectors form{};     ///< A shape's, where style.w > 0.
};

/// The surface rho = `scale` of a primitive, made of the unit ball; color, outline and glow are left to the caller.
[[nodiscard]] ShapeInstance shellOf(const PrimitiveShape& shape, float scale);

class ShapeMesh {
 public:
  [[nodiscard]] static ShapeMesh ball(
      std::uint32_t rows);                      ///< Radius 1 around the origin; twice as many columns as rows.
  [[nodiscard]] static ShapeMesh octahedron();  ///< From the origin to +Y at 1; half width 1 at a sixth of the way.

  void setInstances(std::span<const ShapeInstance> instances);
  /// Draws the mesh once an instance with the program in use.
  void draw() const;
  /// Draws `vertices` numbered vertices an instance instead of the mesh: for programs that make their own shape.
  void drawNumbered(int vertices) const;

 private:
  struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
  };
  ShapeMesh(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices);

  GlVertexArray array_;
  GlVertexArray instanceArray_;  ///< Without the mesh, for drawNumbered.
  GlBuffer vertices_;
  GlBuffer indices_;
  GlBuffer instances_;
  GLsizei indexCount_ = 0;
  GLsizei instanceCount_ = 0;
};

}  // namespace sinew::app
