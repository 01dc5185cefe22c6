// app/viewport/render/overlay_drawers.cpp: the skeleton in x-ray, and segments of a width in pixels.
#include "app/viewport/render/overlay_drawers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <glm/matrix.hpp>

#include "app/viewport/render/color_scales.h"
#include "app/viewport/render/muscle_drawer.h"
#include "app/viewport/render/picking.h"

namespace sinew::app {

namespace {

constexpr glm::vec4 kBone{0.66f, 0.72f, 0.80f, 0.84f};
constexpr glm::vec4 kHovered{0.30f, 0.72f, 1.00f, 0.94f};
constexpr glm::vec4 kSelected{1.00f, 0.40f, 0.04f, 0.97f};
constexpr float kContourWidth = 1.6f;  ///< Pixels.

struct Look {
  glm::vec4 color;
  float glow;
};

bool isIn(const std::vector<int>& bones, int bone) { return std::ranges::find(bones, bone) != bones.end(); }

Look lookOf(int bone, const Scene& scene) {
  if (bone == scene.selectedBone) return {kSelected, 1.0f};
  if (bone == scene.hoveredBone) return {kHovered, 1.0f};
  if (isIn(scene.territoryBones, bone)) return {glm::vec4(toLinear(kTerritoryColor), 0.94f), 0.7f};
  return {kBone, 0.0f};
}

bool isShown(int bone, const Frame& frame) {
  const Scene& scene = frame.scene;
  if (!scene.hiddenBones.empty() && scene.hiddenBones[static_cast<std::size_t>(bone)]) return false;
  const bool marked = bone == scene.selectedBone || bone == scene.hoveredBone;
  return (frame.settings.skeleton && (marked || !frame.settings.anatomy)) || isIn(scene.territoryBones, bone);
}

/// Depth of the nearest joint along the view, and how much deeper the furthest lies.
glm::vec2 depthRange(const Frame& frame) {
  const glm::vec3 forward = frame.view.forwardInWorld();
  glm::vec2 range(std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest());
  for (const glm::mat4& bone : frame.scene.pose->boneInWorld) {
    const float depth = glm::dot(glm::vec3(bone[3]), forward);
    range = {std::min(range.x, depth), std::max(range.y, depth)};
  }
  return {range.x, std::max(range.y - range.x, 0.25f * frame.height)};
}

glm::mat4 ballAt(const glm::vec3& center, float radius) {
  return {glm::vec4(radius, 0, 0, 0), glm::vec4(0, radius, 0, 0), glm::vec4(0, 0, radius, 0), glm::vec4(center, 1)};
}

}  // namespace

glm::mat4 boneAlong(const glm::vec3& head, const glm::vec3& tail, float width) {
  const glm::vec3 y = tail - head;
  const glm::vec3 direction = normalizeOr(y, glm::vec3(0, 1, 0));
  const glm::vec3 other = std::abs(direction.z) < 0.8f ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
  const glm::vec3 x = glm::normalize(glm::cross(direction, other));
  const glm::vec3 z = glm::cross(x, direction);
  return {glm::vec4(x * width, 0), glm::vec4(y, 0), glm::vec4(z * width, 0), glm::vec4(head, 1)};
}

SkeletonDrawer::SkeletonDrawer() : bones_(ShapeMesh::octahedron()), joints_(ShapeMesh::ball(6)) {}

Result<SkeletonDrawer> SkeletonDrawer::create() {
  SkeletonDrawer drawer;
  Result<GlProgram> program = GlProgram::load({"shaders/shape.vert", "shaders/bone.frag"});
  if (!program) return program.error();
  drawer.program_ = std::move(program).value();
  return drawer;
}

void SkeletonDrawer::place(const Frame& frame) {
  const Scene& scene = frame.scene;
  const std::vector<BoneSegment> segments = boneSegments(scene.character->skeleton, *scene.pose, scene.hiddenBones);
  const float h = frame.height;
  std::vector<ShapeInstance> bones, joints;
  // Joints scale with their shortest bone, so that fingers do not become strings of beads.
  std::vector<float> shortest(scene.pose->boneInWorld.size(), h);
  for (const BoneSegment& segment : segments) {
    const float length = glm::distance(segment.head, segment.tail);
    if (length < 1e-4f * h) continue;
    float& least = shortest[static_cast<std::size_t>(segment.bone)];
    least = std::min(least, length);
    if (!isShown(segment.bone, frame)) continue;
    const Look look = lookOf(segment.bone, scene);
    const float width = std::min(0.11f * length, 0.016f * h);
    bones.push_back({boneAlong(segment.head, segment.tail, width), look.color, glm::vec4(0, look.glow, 0, 0)});
  }
  for (std::size_t i = 0; i < scene.pose->boneInWorld.size(); ++i) {
    if (!isShown(static_cast<int>(i), frame)) continue;
    const Look look = lookOf(static_cast<int>(i), scene);
    const float radius = std::clamp(0.085f * shortest[i], 0.0028f * h, 0.0095f * h);
    joints.push_back(
        {ballAt(glm::vec3(scene.pose->boneInWorld[i][3]), radius), look.color, glm::vec4(0, look.glow, 0, 0)});
  }
  bones_.setInstances(bones);
  joints_.setInstances(joints);
}

void SkeletonDrawer::drawAll(float swell) const {
  program_.set("swell", glm::vec4(0.0f, 0.3f, 0.0f, swell));
  bones_.draw();
  program_.set("swell", glm::vec4(0.0f, 0.0f, 0.0f, swell));
  joints_.draw();
}

void SkeletonDrawer::draw(const Frame& frame) {
  if (frame.scene.pose->boneInWorld.empty()) return;
  place(frame);
  glClear(GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  program_.use();
  program_.set("depthRange", depthRange(frame));
  program_.set("contour", 0.0f);
  // Depth first, then color where nearest: only one translucent layer.
  glDepthFunc(GL_LEQUAL);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  drawAll(0.0f);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  blendPremultiplied();
  glDepthFunc(GL_EQUAL);
  drawAll(0.0f);
  // Enlarged back sides are dark edges around the bones.
  glDepthFunc(GL_LESS);
  glCullFace(GL_FRONT);
  program_.set("contour", 1.0f);
  drawAll(kContourWidth * frame.settings.lineScale);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
}

namespace {

constexpr glm::vec4 kControlEdge{0.06f, 0.62f, 0.55f, 1.0f};
constexpr glm::vec4 kTendonLine{0.88f, 0.86f, 0.80f, 0.95f};
constexpr glm::vec2 kDotRadii{2.9f, 2.1f};

}  // namespace

glm::vec3 segmentColor(SegmentClass kind) {
  // By SegmentClass.
  constexpr std::array<glm::vec3, 4> kColors{glm::vec3(0.80f, 0.84f, 0.90f), glm::vec3(0.10f, 0.80f, 0.42f),
                                             glm::vec3(1.00f, 0.52f, 0.04f), glm::vec3(1.00f, 0.07f, 0.10f)};
  return kColors[static_cast<std::size_t>(kind)];
}

LineDrawer::LineDrawer() : array_(makeVertexArray()), lines_(makeBuffer()) {
  const GLuint array = array_.id();
  glVertexArrayVertexBuffer(array, 0, lines_.id(), 0, sizeof(Line));
  glVertexArrayBindingDivisor(array, 0, 1);
  const std::array<std::size_t, 3> offsets{offsetof(Line, from), offsetof(Line, to), offsetof(Line, color)};
  for (GLuint i = 0; i < 3; ++i) setAttribute(array, i, 0, i < 2 ? 3 : 4, offsets[i]);
}

Result<LineDrawer> LineDrawer::create() {
  LineDrawer drawer;
  const Result<void> loaded = loadPrograms({{drawer.program_, {"shaders/line.vert", "shaders/line.frag"}},
                                            {drawer.dotProgram_, {"shaders/dot.vert", "shaders/dot.frag"}}});
  if (!loaded) return loaded.error();
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
