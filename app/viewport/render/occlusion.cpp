// app/viewport/render/occlusion.cpp: occlusion of the picture, and rays through the body as voxels.
#include "app/viewport/render/occlusion.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>

#include "core/surface/patches/patch.h"

namespace sinew::app {

namespace {

constexpr float kRadius = 0.075f;        ///< How far a surface darkens its neighbors, fraction of the height.
constexpr float kMuscleRadius = 0.040f;  ///< The same for muscles, which lie close together.
constexpr GLuint kUnit = 5;              ///< Texture unit of shaders/surface.frag.
constexpr int kTaps = 16;
constexpr int kTapsOnProcessor = 12;

GlTexture target(GlFramebuffer& framebuffer, GLenum format, const glm::ivec2& size) {
  GlTexture texture = makeTexture(GL_TEXTURE_2D);
  glTextureStorage2D(texture.id(), 1, format, size.x, size.y);
  glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  framebuffer = makeFramebuffer();
  glNamedFramebufferTexture(framebuffer.id(), GL_COLOR_ATTACHMENT0, texture.id(), 0);
  return texture;
}

/// Position of a pixel relative to the eye, at depth 1; without perspective at depth 0.
glm::vec3 pixelPlace(const View& view, const glm::vec2& pixel) {
  const Ray ray = view.rayThrough(pixel);
  const glm::vec3 forward = view.forwardInWorld();
  if (!view.orthographic) return ray.direction / glm::dot(ray.direction, forward);
  const glm::vec3 from = ray.origin - view.eyeInWorld;
  return from - forward * glm::dot(from, forward);
}

void setPixels(const GlProgram& program, const View& view) {
  const glm::vec2 size(view.size);
  const glm::vec3 corner = pixelPlace(view, {0.0f, size.y});  // OpenGL counts rows from below.
  program.set("corner", corner);
  program.set("stepX", (pixelPlace(view, size) - corner) / size.x);
  program.set("stepY", (pixelPlace(view, {0.0f, 0.0f}) - corner) / size.y);
}

}  // namespace

ScreenOcclusion::ScreenOcclusion() : empty_(makeVertexArray()) {}

Result<ScreenOcclusion> ScreenOcclusion::create() {
  ScreenOcclusion made;
  const Result<void> loaded =
      loadPrograms({{made.surfaceProgram_, {"shaders/depth.vert", "shaders/depth.frag"}},
                    {made.occlusionProgram_, {"shaders/fullscreen.vert", "shaders/occlusion.frag"}},
                    {made.blurProgram_, {"shaders/fullscreen.vert", "shaders/occlusion_blur.frag"}}});
  if (!loaded) return loaded.error();
  return made;
}

void ScreenOcclusion::resize(const glm::ivec2& size) {
  if (size == size_) return;
  size_ = size;
  surface_ = target(surfaceTarget_, GL_RGBA32F, size);
  depth_ = makeRenderbuffer();
  glNamedRenderbufferStorage(depth_.id(), GL_DEPTH_COMPONENT32F, size.x, size.y);
  glNamedFramebufferRenderbuffer(surfaceTarget_.id(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
  open_ = target(openTarget_, GL_R16F, size);
  blurred_ = target(blurredTarget_, GL_R16F, size);
}

void ScreenOcclusion::drawSurface(const Frame& frame, const SurfaceDrawer& surface, const MuscleDrawer& muscles) const {
  glBindFramebuffer(GL_FRAMEBUFFER, surfaceTarget_.id());
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClearDepth(1.0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  if (frame.settings.anatomy) {
    muscles.drawDepths();
  } else {
    glDisable(GL_BLEND);
    surfaceProgram_.use();
    surfaceProgram_.set("baseMap", 0);
    surface.drawOpaque(surfaceProgram_, frame);
  }
  glDisable(GL_DEPTH_TEST);
}

void ScreenOcclusion::prepare(const Frame& frame, const SurfaceDrawer& surface, const MuscleDrawer& muscles,
                              int sample) {
  resize(frame.view.size);
  glViewport(0, 0, size_.x, size_.y);
  glDisable(GL_BLEND);
  glDisable(GL_FRAMEBUFFER_SRGB);
  drawSurface(frame, surface, muscles);

  const float radius = (frame.settings.anatomy ? kMuscleRadius : kRadius) * frame.height;
  const auto rotation = static_cast<float>(sample < 0 ? 0 : sample);
  glBindFramebuffer(GL_FRAMEBUFFER, openTarget_.id());
  glBindTextureUnit(0, surface_.id());
  occlusionProgram_.use();
  occlusionProgram_.set("surface", 0);
  setPixels(occlusionProgram_, frame.view);
  // Each sample falls between those before it. Not the golden ratio, which separates the taps of one sample.
  occlusionProgram_.set("reach",
                        glm::vec4(radius, 0.5f * radius * frame.view.clipFromView[1][1] * static_cast<float>(size_.y),
                                  rotation * 0.75487767f, rotation * 0.56984029f));
  occlusionProgram_.set("taps", isSoftwareRenderer() ? kTapsOnProcessor : kTaps);
  glBindVertexArray(empty_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindFramebuffer(GL_FRAMEBUFFER, blurredTarget_.id());
  glBindTextureUnit(1, open_.id());
  blurProgram_.use();
  blurProgram_.set("surface", 0);
  blurProgram_.set("source", 1);
  blurProgram_.set("width", sample < 0 ? 3 : 2);
  blurProgram_.set("range", 0.3f * radius);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindTextureUnit(kUnit, blurred_.id());
}

namespace {

constexpr int kCells = 56;      ///< Along the longest side of the body.
constexpr int kRays = 80;       ///< Over the whole sphere.
constexpr int kMostSteps = 19;  ///< Cells along a ray: a third of the body.
constexpr float kStart = 2.1f;  ///< Cells above the surface where rays start, to clear its own voxels.
constexpr int kSmoothings = 2;

/// A grid of cells; those that contain surface are set.
class Voxels {
 public:
  explicit Voxels(const Bounds& bounds) {
    const glm::vec3 extent = bounds.extent();
    cell_ = std::max({extent.x, extent.y, extent.z, 1e-20f}) / static_cast<float>(kCells);
    low_ = bounds.low - cell_;
    for (int axis = 0; axis < 3; ++axis) count_[axis] = static_cast<int>(std::ceil(extent[axis] / cell_)) + 3;
    set_.assign(
        static_cast<std::size_t>(count_.x) * static_cast<std::size_t>(count_.y) * static_cast<std::size_t>(count_.z),
        0);
  }

  [[nodiscard]] float cell() const { return cell_; }
  /// In cells from the low corner.
  [[nodiscard]] glm::vec3 inCells(const glm::vec3& world) const { return (world - low_) / cell_; }
  [[nodiscard]] bool isInside(const glm::ivec3& c) const {
    return c.x >= 0 && c.y >= 0 && c.z >= 0 && c.x < count_.x && c.y < count_.y && c.z < count_.z;
  }
  [[nodiscard]] bool at(const glm::ivec3& c) const { return set_[indexOf(c)] != 0; }
  void mark(const glm::vec3& cells) {
    const glm::ivec3 c(cells);
    if (isInside(c)) set_[indexOf(c)] = 1;
  }

 private:
  [[nodiscard]] std::size_t indexOf(const glm::ivec3& c) const {
    return static_cast<std::size_t>(c.x) +
           static_cast<std::size_t>(count_.x) *
               (static_cast<std::size_t>(c.y) + static_cast<std::size_t>(count_.y) * static_cast<std::size_t>(c.z));
  }

  glm::vec3 low_{0.0f};
  float cell_ = 1.0f;
  glm::ivec3 count_{1};
  std::vector<std::uint8_t> set_;
};

Voxels voxelsOf(const ControlMesh& mesh) {
  Voxels voxels(boundsOf(mesh.positions));
  for (const ControlTriangle& triangle : mesh.triangles) {
    std::array<glm::vec3, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = voxels.inCells(mesh.positions[static_cast<std::size_t>(triangle.vertices[i])]);
    }
    const float longest = std::sqrt(std::max(
        {glm::dot(p[1] - p[0], p[1] - p[0]), glm::dot(p[2] - p[1], p[2] - p[1]), glm::dot(p[0] - p[2], p[0] - p[2])}));
    const int steps = std::clamp(static_cast<int>(std::ceil(longest * 1.6f)), 1, 4 * kCells);
    for (int j = 0; j <= steps; ++j) {
      for (int k = 0; j + k <= steps; ++k) {
        const float u = static_cast<float>(j) / static_cast<float>(steps);
        const float v = static_cast<float>(k) / static_cast<float>(steps);
        voxels.mark(p[0] + u * (p[1] - p[0]) + v * (p[2] - p[0]));
      }
    }
  }
  return voxels;
}

/// Light of a ray: 0 if it is stopped at once, 1 if it escapes.
float passage(const Voxels& voxels, const glm::vec3& start, const glm::vec3& direction) {
  for (int step = 1; step <= kMostSteps; ++step) {
    const glm::vec3 at = start + direction * static_cast<float>(step);
    const glm::ivec3 cell(glm::floor(at));
    if (!voxels.isInside(cell)) return 1.0f;
    if (voxels.at(cell)) return static_cast<float>(step - 1) / static_cast<float>(kMostSteps);
  }
  return 1.0f;
}

float opennessAt(const Voxels& voxels, std::span<const glm::vec3> directions, const glm::vec3& position,
                 const glm::vec3& normal) {
  const glm::vec3 start = voxels.inCells(position) + kStart * normal;
  float seen = 0.0f, all = 0.0f;
  for (const glm::vec3& direction : directions) {
    const float facing = glm::dot(direction, normal);
    if (facing <= 0.05f) continue;
    seen += facing * passage(voxels, start, direction);
    all += facing;
  }
  return all > 0.0f ? seen / all : 1.0f;
}

/// Moves each value half way to the mean of its neighbors.
void smoothAlongEdges(const ControlMesh& mesh, std::vector<float>& values) {
  std::vector<float> sum(values.size(), 0.0f), count(values.size(), 0.0f);
  for (const Edge& edge : mesh.edges) {
    const auto a = static_cast<std::size_t>(edge.vertices[0]), b = static_cast<std::size_t>(edge.vertices[1]);
    sum[a] += values[b];
    sum[b] += values[a];
    count[a] += 1.0f;
    count[b] += 1.0f;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (count[i] > 0.0f) values[i] = 0.5f * (values[i] + sum[i] / count[i]);
  }
}

}  // namespace

std::vector<float> bakeOpenness(const ControlMesh& mesh) {
  std::vector<float> open(mesh.positions.size(), 1.0f);
  if (open.empty() || mesh.triangles.empty()) return open;
  const Voxels voxels = voxelsOf(mesh);
  const std::vector<glm::vec3> directions = evenDirections(kRays);
  for (std::size_t i = 0; i < open.size(); ++i) {
    open[i] = opennessAt(voxels, directions, mesh.positions[i], mesh.normals[i]);
  }
  for (int i = 0; i < kSmoothings; ++i) smoothAlongEdges(mesh, open);
  return open;
}

std::vector<float> spreadOverRefinement(std::span<const float> values, const ControlMesh& mesh,
                                        const Refinement& refinement) {
  assert(values.size() == mesh.positions.size());
  std::vector<float> spread(static_cast<std::size_t>(refinement.vertexCount));
  interpolateValues(mesh, refinement, values, spread);
  return spread;
}

}  // namespace sinew::app
