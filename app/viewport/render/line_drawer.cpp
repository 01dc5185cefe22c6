// app/viewport/render/line_drawer.cpp: segments of a width in pixels.
#include "app/viewport/render/line_drawer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/matrix.hpp>

#include "app/viewport/render/color_scales.h"
#include "app/viewport/render/muscle_drawer.h"

namespace sinew::app {
namespace {

constexpr glm::vec4 kControlEdge{0.06f, 0.62f, 0.55f, 1.0f};
constexpr glm::vec4 kTendonLine{0.88f, 0.86f, 0.80f, 0.95f};
constexpr glm::vec2 kDotRadii{2.9f, 2.1f};

}  // namespace

glm::vec3 segmentColor(SegmentClass kind) {
  switch (kind) {
    case SegmentClass::kFound:
      return {0.10f, 0.80f, 0.42f};
    case SegmentClass::kFallback:
      return {1.00f, 0.52f, 0.04f};
    case SegmentClass::kLost:
      return {1.00f, 0.07f, 0.10f};
    case SegmentClass::kPlain:
      break;
  }
  return {0.80f, 0.84f, 0.90f};
}

LineDrawer::LineDrawer() : array_(makeVertexArray()), lines_(makeBuffer()) {
  const GLuint array = array_.id();
  glVertexArrayVertexBuffer(array, 0, lines_.id(), 0, sizeof(Line));
  glVertexArrayBindingDivisor(array, 0, 1);
  const std::array<std::size_t, 3> offsets{offsetof(Line, from), offsetof(Line, to), offsetof(Line, color)};
  for (GLuint i = 0; i < 3; ++i) {
    glEnableVertexArrayAttrib(array, i);
    glVertexArrayAttribFormat(array, i, i < 2 ? 3 : 4, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offsets[i]));
    glVertexArrayAttribBinding(array, i, 0);
  }
}

Result<LineDrawer> LineDrawer::create() {
  LineDrawer drawer;
  Result<GlProgram> program = GlProgram::load({"shaders/line.vert", "shaders/line.frag"});
  if (!program) return program.error();
  Result<GlProgram> dots = GlProgram::load({"shaders/dot.vert", "shaders/dot.frag"});
  if (!dots) return dots.error();
  drawer.program_ = std::move(program).value();
  drawer.dotProgram_ = std::move(dots).value();
  return drawer;
}

void LineDrawer::draw(std::span<const Line> lines, float width, const glm::vec2& dotRadii, float hidden) const {
  if (lines.empty()) return;
  uploadBuffer(lines_, lines);
  const auto count = static_cast<GLsizei>(lines.size());
  glBindVertexArray(array_.id());
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  blendPremultiplied();
  for (const bool inSight : {false, true}) {
    glDepthFunc(inSight ? GL_LEQUAL : GL_GREATER);
    program_.use();
    program_.set("width", width);
    program_.set("opacity", inSight ? 1.0f : hidden);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, count);
    if (dotRadii == glm::vec2(0.0f)) continue;
    dotProgram_.use();
    dotProgram_.set("radii", dotRadii);
    dotProgram_.set("opacity", inSight ? 1.0f : hidden);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 12, count);
  }
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
}

void LineDrawer::drawControlMesh(const Frame& frame) {
  const std::vector<glm::vec3>& positions = frame.scene.skinnedControlPositions;
  const ControlMesh& mesh = frame.scene.character->mesh;
  if (positions.size() != mesh.positions.size()) return;
  std::vector<Line> lines;
  lines.reserve(mesh.edges.size());
  for (const Edge& edge : mesh.edges) {
    lines.push_back({positions[static_cast<std::size_t>(edge.vertices[0])],
                     positions[static_cast<std::size_t>(edge.vertices[1])], kControlEdge});
  }
  draw(lines, 1.1f * frame.settings.lineScale, glm::vec2(0.0f), 0.18f);
}

void LineDrawer::drawSegments(const Frame& frame) {
  std::vector<Line> lines;
  lines.reserve(frame.scene.segments.size());
  for (const SceneSegment& segment : frame.scene.segments) {
    lines.push_back({segment.from, segment.to, glm::vec4(segmentColor(segment.kind), 0.95f)});
  }
  draw(lines, 1.1f * frame.settings.lineScale, kDotRadii * frame.settings.lineScale, 0.45f);
}

void LineDrawer::drawMuscleLines(const Frame& frame) {
  std::vector<Line> lines;
  std::vector<const LinePath*> drawn;
  for (const PrimitiveShape& shape : frame.scene.primitives) {
    if (!shape.line || !(shape.selected || shape.hovered || shape.twin)) continue;
    const LinePath& path = shape.line->path;
    if (std::ranges::any_of(drawn, [&](const LinePath* other) { return *other == path; })) continue;
    drawn.push_back(&path);
    const glm::vec3 flesh = linearFromSrgb(fleshColor(shape.line->activation));
    const glm::mat4 inBelly = glm::inverse(alongFibres(shape));
    const std::vector<glm::vec3> points = pointsAlong(path);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const glm::vec3 middle = 0.5f * (points[i - 1] + points[i]);
      const bool belly = std::abs((inBelly * glm::vec4(middle, 1.0f)).y) < 1.0f;
      lines.push_back({points[i - 1], points[i], belly ? glm::vec4(flesh, 0.95f) : kTendonLine});
    }
  }
  draw(lines, 2.2f * frame.settings.lineScale, glm::vec2(0.0f), 0.55f);
}

}  // namespace sinew::app
