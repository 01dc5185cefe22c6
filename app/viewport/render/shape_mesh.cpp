// app/viewport/render/shape_mesh.cpp: balls and bones as triangles.
#include "app/viewport/render/shape_mesh.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "core/geometry/affine_image.h"

namespace sinew::app {

ShapeInstance shellOf(const PrimitiveShape& shape, float scale) {
  ShapeInstance shell;
  shell.shapeInWorld = shape.unitBallInWorld;
  if (!shape.shape.isPlain()) shell.style.w = scale;
  else if (scale != 1.0f) shell.shapeInWorld = glm::scale(shell.shapeInWorld, glm::vec3(scale));
  for (std::size_t i = 0; i < kShapeNumbers; ++i) {
    shell.form[i / 4][static_cast<glm::length_t>(i % 4)] = shapeNumbers()[i].of(shape.shape);
  }
  return shell;
}

ShapeMesh::ShapeMesh(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices)
    : array_(makeVertexArray()),
      instanceArray_(makeVertexArray()),
      vertices_(makeBuffer()),
      indices_(makeBuffer()),
      instances_(makeBuffer()),
      indexCount_(static_cast<GLsizei>(indices.size())) {
  uploadBuffer(vertices_, vertices, GL_STATIC_DRAW);
  uploadBuffer(indices_, indices, GL_STATIC_DRAW);
  const GLuint array = array_.id();
  glVertexArrayVertexBuffer(array, 0, vertices_.id(), 0, sizeof(Vertex));
  glVertexArrayElementBuffer(array, indices_.id());
  setAttribute(array, 0, 0, 3, offsetof(Vertex, position));
  setAttribute(array, 1, 0, 3, offsetof(Vertex, normal));
  for (const GLuint each : {array_.id(), instanceArray_.id()}) {
    glVertexArrayVertexBuffer(each, 1, instances_.id(), 0, sizeof(ShapeInstance));
    glVertexArrayBindingDivisor(each, 1, 1);
    constexpr GLuint kVectors = sizeof(ShapeInstance) / sizeof(glm::vec4);
    for (GLuint i = 0; i < kVectors; ++i) setAttribute(each, 2 + i, 1, 4, i * sizeof(glm::vec4));
  }
}

ShapeMesh ShapeMesh::ball(std::uint32_t rows) {
  const std::uint32_t columns = 2 * rows;
  std::vector<Vertex> vertices;
  for (std::uint32_t row = 0; row <= rows; ++row) {
    const float polar = std::numbers::pi_v<float> * static_cast<float>(row) / static_cast<float>(rows);
    for (std::uint32_t column = 0; column <= columns; ++column) {
      const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(column) / static_cast<float>(columns);
      const glm::vec3 p(std::sin(polar) * std::sin(angle), std::cos(polar), std::sin(polar) * std::cos(angle));
      vertices.push_back({p, p});
    }
  }
  std::vector<std::uint32_t> indices;
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::uint32_t a = row * (columns + 1) + column, b = a + columns + 1;
      indices.insert(indices.end(), {a, b, a + 1, a + 1, b, b + 1});
    }
  }
  return {vertices, indices};
}

ShapeMesh ShapeMesh::octahedron() {
  const std::array<glm::vec3, 4> waist{glm::vec3{1, 1.0f / 6.0f, 0}, glm::vec3{0, 1.0f / 6.0f, -1},
                                       glm::vec3{-1, 1.0f / 6.0f, 0}, glm::vec3{0, 1.0f / 6.0f, 1}};
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  const auto face = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
    for (const glm::vec3& p : {a, b, c}) {
      indices.push_back(static_cast<std::uint32_t>(vertices.size()));
      vertices.push_back({p, normal});
    }
  };
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::vec3 &here = waist[i], &next = waist[(i + 1) % 4];
    face(here, next, {0, 1, 0});
    face(next, here, {0, 0, 0});
  }
  return {vertices, indices};
}

void ShapeMesh::setInstances(std::span<const ShapeInstance> instances) {
  uploadBuffer(instances_, instances);
  instanceCount_ = static_cast<GLsizei>(instances.size());
}

void ShapeMesh::draw() const {
  if (instanceCount_ == 0) return;
  glBindVertexArray(array_.id());
  glDrawElementsInstanced(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr, instanceCount_);
}

void ShapeMesh::drawNumbered(int vertices) const {
  if (instanceCount_ == 0) return;
  glBindVertexArray(instanceArray_.id());
  glDrawArraysInstanced(GL_TRIANGLES, 0, vertices, instanceCount_);
}

}  // namespace sinew::app
