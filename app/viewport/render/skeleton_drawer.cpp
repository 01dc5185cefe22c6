// app/viewport/render/skeleton_drawer.cpp: the skeleton in x-ray.
#include "app/viewport/render/skeleton_drawer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "app/document/group_colors.h"
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

Look lookOf(int bone, const Scene& scene) {
  if (bone == scene.selectedBone) return {kSelected, 1.0f};
  if (bone == scene.hoveredBone) return {kHovered, 1.0f};
  if (std::ranges::find(scene.territoryBones, bone) != scene.territoryBones.end())
    return {glm::vec4(toLinear(kTerritoryColor), 0.94f), 0.7f};
  return {kBone, 0.0f};
}

/// All bones, or those of the territory alone.
bool isShown(int bone, const Frame& frame) {
  const std::vector<bool>& hidden = frame.scene.hiddenBones;
  if (!hidden.empty() && hidden[static_cast<std::size_t>(bone)]) return false;
  const bool marked = bone == frame.scene.selectedBone || bone == frame.scene.hoveredBone;
  return (frame.settings.skeleton && (marked || !frame.settings.anatomy)) ||
         std::ranges::find(frame.scene.territoryBones, bone) != frame.scene.territoryBones.end();
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
  // A joint is as big as its shortest bone allows, so that fingers do not turn into a string of beads.
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
  // Depth first, color where it is nearest: one layer of translucent bone, never two.
  glDepthFunc(GL_LEQUAL);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  drawAll(0.0f);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  blendPremultiplied();
  glDepthFunc(GL_EQUAL);
  drawAll(0.0f);
  // The far sides, grown: what of them no bone hides is a dark edge around each.
  glDepthFunc(GL_LESS);
  glCullFace(GL_FRONT);
  program_.set("contour", 1.0f);
  drawAll(kContourWidth * frame.settings.lineScale);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
}

}  // namespace sinew::app
