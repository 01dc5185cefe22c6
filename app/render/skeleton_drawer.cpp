// app/render/skeleton_drawer.cpp: the skeleton in x-ray.
#include "app/render/skeleton_drawer.h"

#include <algorithm>
#include <vector>

#include "app/render/picking.h"

namespace sinew::app {
namespace {

constexpr glm::vec4 kBone{0.66f, 0.72f, 0.80f, 0.82f};
constexpr glm::vec4 kHovered{0.30f, 0.72f, 1.00f, 0.92f};
constexpr glm::vec4 kSelected{1.00f, 0.40f, 0.04f, 0.96f};

struct Look {
  glm::vec4 color;
  float glow;
};

Look lookOf(int bone, const Scene& scene) {
  if (bone == scene.selectedBone) return {kSelected, 1.0f};
  if (bone == scene.hoveredBone) return {kHovered, 1.0f};
  return {kBone, 0.0f};
}

/// Octahedron from head to tail, `width` wide on each side.
glm::mat4 along(const glm::vec3& head, const glm::vec3& tail, float width) {
  const glm::vec3 y = tail - head;
  const glm::vec3 direction = normalizeOr(y, glm::vec3(0, 1, 0));
  const glm::vec3 other = std::abs(direction.z) < 0.8f ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
  const glm::vec3 x = glm::normalize(glm::cross(direction, other));
  const glm::vec3 z = glm::cross(x, direction);
  return {glm::vec4(x * width, 0), glm::vec4(y, 0), glm::vec4(z * width, 0), glm::vec4(head, 1)};
}

glm::mat4 ballAt(const glm::vec3& centre, float radius) {
  return {glm::vec4(radius, 0, 0, 0), glm::vec4(0, radius, 0, 0), glm::vec4(0, 0, radius, 0), glm::vec4(centre, 1)};
}

}  // namespace

SkeletonDrawer::SkeletonDrawer() : bones_(ShapeMesh::octahedron()), joints_(ShapeMesh::ball(6)) {}

Result<SkeletonDrawer> SkeletonDrawer::create() {
  SkeletonDrawer drawer;
  Result<GlProgram> program = GlProgram::load({"shaders/shape.vert", "shaders/bone.frag"});
  if (!program) return program.error();
  drawer.program_ = std::move(program).value();
  return drawer;
}

void SkeletonDrawer::draw(const Frame& frame) {
  const Scene& scene = frame.scene;
  const std::vector<BoneSegment> segments = boneSegments(scene.character->skeleton, *scene.pose);
  const float h = frame.height;
  std::vector<ShapeInstance> bones, joints;
  // A joint is as big as its shortest bone allows, so that fingers do not turn into a string of beads.
  std::vector<float> shortest(scene.pose->boneInWorld.size(), h);
  for (const BoneSegment& segment : segments) {
    const float length = glm::distance(segment.head, segment.tail);
    if (length < 1e-4f * h) continue;
    float& least = shortest[static_cast<std::size_t>(segment.bone)];
    least = std::min(least, length);
    const Look look = lookOf(segment.bone, scene);
    const float width = std::min(0.11f * length, 0.016f * h);
    bones.push_back({along(segment.head, segment.tail, width), look.color, glm::vec4(0, look.glow, 0, 0)});
  }
  for (std::size_t i = 0; i < scene.pose->boneInWorld.size(); ++i) {
    const Look look = lookOf(static_cast<int>(i), scene);
    const float radius = std::clamp(0.085f * shortest[i], 0.0028f * h, 0.0095f * h);
    joints.push_back(
        {ballAt(glm::vec3(scene.pose->boneInWorld[i][3]), radius), look.color, glm::vec4(0, look.glow, 0, 0)});
  }
  bones_.setInstances(bones);
  joints_.setInstances(joints);

  glClear(GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  program_.use();
  // Depth first, colour where it is nearest: one layer of translucent bone, never two.
  glDepthFunc(GL_LEQUAL);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  bones_.draw();
  joints_.draw();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  blendPremultiplied();
  glDepthFunc(GL_EQUAL);
  bones_.draw();
  joints_.draw();
  glDisable(GL_BLEND);
  glDepthFunc(GL_LESS);
  glDisable(GL_CULL_FACE);
}

}  // namespace sinew::app
