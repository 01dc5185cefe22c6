// app/viewport/render/shape_mesh.h: instanced balls and bones.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "app/viewport/render/gl_objects.h"
#include "app/viewport/render/scene.h"

namespace sinew::app {

/// shapeNumbers() packed into vectors, for shaders/form.glsl.
using FormVectors = std::array<glm::vec4, (kShapeNumbers + 3) / 4>;

/// Input of shaders/shape.vert and ring.vert.
struct ShapeInstance {
  glm::mat4 shapeInWorld{1.0f};
  glm::vec4 color{1.0f};  ///< Linear, opacity in w.
  glm::vec4 style{0.0f};  ///< Outline, glow: 0..1.
  FormVectors form{};     ///< For shapes, where style.w > 0.
};

/// The surface rho = `scale` of a primitive as an instance of the unit ball, without color, outline and glow.
[[nodiscard]] ShapeInstance shellOf(const PrimitiveShape& shape, float scale);

class ShapeMesh {
 public:
  [[nodiscard]] static ShapeMesh ball(std::uint32_t rows);  ///< Radius 1, at the origin; twice as many columns as rows.
  [[nodiscard]] static ShapeMesh octahedron();              ///< From the origin to y = 1; half width 1 at y = 1/6.

  void setInstances(std::span<const ShapeInstance> instances);
  void draw() const;  ///< Draws all instances with the program in use.
  /// Draws numbered vertices per instance in place of the mesh, for programs that compute their own shape.
  void drawNumbered(int vertices) const;

 private:
  struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
  };
  ShapeMesh(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices);

  GlVertexArray array_;
  GlVertexArray instanceArray_;  ///< Without the mesh, for drawNumbered.
  GlBuffer vertices_, indices_, instances_;
  GLsizei indexCount_ = 0;
  GLsizei instanceCount_ = 0;
};

}  // namespace sinew::app
