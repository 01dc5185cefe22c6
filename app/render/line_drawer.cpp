// app/render/line_drawer.cpp: segments of a width in pixels.
#include "app/render/line_drawer.h"

#include <array>
#include <vector>

namespace sinew::app {

LineDrawer::LineDrawer() : array_(makeVertexArray()), segments_(makeBuffer()) {
  const GLuint array = array_.id();
  glVertexArrayVertexBuffer(array, 0, segments_.id(), 0, 2 * sizeof(glm::vec3));
  glVertexArrayBindingDivisor(array, 0, 1);
  for (GLuint end = 0; end < 2; ++end) {
    glEnableVertexArrayAttrib(array, end);
    glVertexArrayAttribFormat(array, end, 3, GL_FLOAT, GL_FALSE, end * static_cast<GLuint>(sizeof(glm::vec3)));
    glVertexArrayAttribBinding(array, end, 0);
  }
}

Result<LineDrawer> LineDrawer::create() {
  LineDrawer drawer;
  Result<GlProgram> program = GlProgram::load({"shaders/line.vert", "shaders/line.frag"});
  if (!program) return program.error();
  drawer.program_ = std::move(program).value();
  return drawer;
}

void LineDrawer::drawControlMesh(const Frame& frame) {
  const std::vector<glm::vec3>& positions = frame.scene.skinnedControlPositions;
  const ControlMesh& mesh = frame.scene.character->mesh;
  if (positions.size() != mesh.positions.size()) return;
  std::vector<std::array<glm::vec3, 2>> segments;
  segments.reserve(mesh.edges.size());
  for (const Edge& edge : mesh.edges) {
    segments.push_back({positions[static_cast<std::size_t>(edge.vertices[0])],
                        positions[static_cast<std::size_t>(edge.vertices[1])]});
  }
  uploadBuffer(segments_, std::span<const std::array<glm::vec3, 2>>(segments));
  program_.use();
  program_.set("tint", glm::vec4(0.10f, 0.72f, 0.62f, 1.0f));
  program_.set("width", 1.1f * frame.settings.lineScale);
  glBindVertexArray(array_.id());
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  blendPremultiplied();
  struct Pass {
    GLenum depth;
    float opacity;
  };
  for (const Pass& pass : {Pass{GL_GREATER, 0.16f}, Pass{GL_LEQUAL, 0.85f}}) {
    glDepthFunc(pass.depth);
    program_.set("opacity", pass.opacity);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, static_cast<GLsizei>(segments.size()));
  }
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
}

}  // namespace sinew::app
