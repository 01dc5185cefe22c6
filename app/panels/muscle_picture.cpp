// app/panels/muscle_picture.cpp: a depth buffer, one light, and red where the skin lies near a muscle.
#include "app/panels/muscle_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"
#include "core/geometry/normals.h"

namespace sinew::app {
namespace {

constexpr int kFiner = 2;              ///< Samples per pixel, along an edge.
constexpr float kAroundMuscle = 4.0f;  ///< Least height of the picture, in longest radii of the muscle.
constexpr float kNearSkin = 1.45f;     ///< Radii from the center: skin this near is red.
constexpr glm::vec3 kClay{0.62f, 0.60f, 0.58f};
constexpr glm::vec3 kFlesh{0.86f, 0.33f, 0.27f};
constexpr glm::vec3 kPictureBackground{0.150f, 0.163f, 0.188f};
constexpr glm::vec3 kLight{-0.35f, 0.55f, 0.75f};  ///< In the picture's axes: from the left, above, in front.
constexpr float kAmbient = 0.28f;

/// The map from the world to the unit ball of a muscle.
struct Ball {
  glm::mat3 toUnit{1.0f};
  glm::vec3 center{0.0f};

  /// 1 well inside, 0 outside.
  [[nodiscard]] float weightAt(const glm::vec3& point) const {
    const float away = glm::length(toUnit * (point - center));
    return glm::smoothstep(kNearSkin, 0.85f * kNearSkin, away);
  }
};

std::optional<Placement> inWorld(const Character& character, const Primitive& muscle) {
  const auto bone = character.skeleton.findBone(muscle.bone);
  if (!bone) return std::nullopt;
  const glm::dmat4 bind(at(character.skeleton.bones, *bone).bindInWorld);
  return imageOf(muscle.placement, {glm::dmat3(bind), glm::dvec3(bind[3])});
}

Ball ballOf(const Placement& placement) {
  const glm::mat3 axes = glm::mat3_cast(placement.rotation);
  Ball ball;
  ball.center = placement.center;
  for (glm::length_t i = 0; i < 3; ++i) {
    for (glm::length_t k = 0; k < 3; ++k) ball.toUnit[k][i] = axes[i][k] / placement.radii[i];
  }
  return ball;
}

/// A level view along the normal of the skin over the muscle.
struct PictureCamera {
  glm::vec3 right{1.0f, 0.0f, 0.0f};
  glm::vec3 up{0.0f, 1.0f, 0.0f};
  glm::vec3 towards{0.0f, 0.0f, 1.0f};  ///< The viewer.
  glm::vec3 target{0.0f};
  float pixelsPerUnit = 1.0f;
  glm::vec2 middle{0.0f};

  /// Pixels, and nearness to the viewer.
  [[nodiscard]] glm::vec3 of(const glm::vec3& world) const {
    const glm::vec3 offset = world - target;
    return {middle.x + pixelsPerUnit * glm::dot(offset, right), middle.y - pixelsPerUnit * glm::dot(offset, up),
            glm::dot(offset, towards)};
  }
};

/// Mean normal of the skin near a muscle.
glm::vec3 outwards(const ControlMesh& mesh, const Ball& ball) {
  glm::vec3 sum(0.0f);
  float nearest = std::numeric_limits<float>::max();
  glm::vec3 ofNearest(0.0f, 0.0f, 1.0f);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    sum += ball.weightAt(mesh.positions[v]) * mesh.normals[v];
    const float away = glm::distance(mesh.positions[v], ball.center);
    if (away < nearest) {
      nearest = away;
      ofNearest = mesh.normals[v];
    }
  }
  return normalizeOr(sum, ofNearest);
}

PictureCamera cameraFor(const Character& character, const Placement& muscle, float least, const glm::ivec2& pixels) {
  PictureCamera camera;
  glm::vec3 from = outwards(character.mesh, ballOf(muscle));
  from.y = std::clamp(from.y, -0.35f, 0.35f);  // Nearly level.
  camera.towards = normalizeOr(from, {0.0f, 0.0f, 1.0f});
  camera.right = normalizeOr(glm::cross(glm::vec3(0.0f, 1.0f, 0.0f), camera.towards), {1.0f, 0.0f, 0.0f});
  camera.up = glm::cross(camera.towards, camera.right);
  camera.target = muscle.center;
  const float longest = std::max({muscle.radii.x, muscle.radii.y, muscle.radii.z});
  const float shown = std::max(least * character.height, kAroundMuscle * longest);
  camera.pixelsPerUnit = static_cast<float>(pixels.y) / shown;
  camera.middle = 0.5f * glm::vec2(pixels);
  return camera;
}

class Painter {
 public:
  Painter(const Character& character, const PictureCamera& camera, std::vector<Ball> muscles, const glm::ivec2& size)
      : mesh_(character.mesh),
        camera_(camera),
        muscles_(std::move(muscles)),
        size_(size),
        near_(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), -std::numeric_limits<float>::max()),
        colors_(near_.size(), kPictureBackground) {}

  std::vector<glm::vec3> paint() {
    for (const ControlTriangle& triangle : mesh_.triangles) draw(triangle.vertices);
    return std::move(colors_);
  }

 private:
  void draw(const std::array<int, 3>& corners) {
    std::array<glm::vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = camera_.of(at(mesh_.positions, corners[k]));
    const glm::vec2 a(p[0]), b(p[1]), c(p[2]);
    const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (std::abs(area) < 1e-6f) return;
    const glm::vec2 least = glm::min(a, glm::min(b, c));
    const glm::vec2 most = glm::max(a, glm::max(b, c));
    const int x0 = std::max(static_cast<int>(std::floor(std::max(least.x, 0.0f))), 0);
    const int y0 = std::max(static_cast<int>(std::floor(std::max(least.y, 0.0f))), 0);
    const int x1 = static_cast<int>(std::min(most.x, static_cast<float>(size_.x) - 1.0f));
    const int y1 = static_cast<int>(std::min(most.y, static_cast<float>(size_.y) - 1.0f));
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        const glm::vec2 q(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        const float u = ((b.x - q.x) * (c.y - q.y) - (b.y - q.y) * (c.x - q.x)) / area;
        const float v = ((c.x - q.x) * (a.y - q.y) - (c.y - q.y) * (a.x - q.x)) / area;
        const float w = 1.0f - u - v;
        if (u < 0.0f || v < 0.0f || w < 0.0f) continue;
        const float nearness = u * p[0].z + v * p[1].z + w * p[2].z;
        const std::size_t pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(x);
        if (nearness <= near_[pixel]) continue;
        near_[pixel] = nearness;
        colors_[pixel] = shade(corners, {u, v, w});
      }
    }
  }

  [[nodiscard]] glm::vec3 shade(const std::array<int, 3>& corners, const glm::vec3& weights) const {
    glm::vec3 point(0.0f);
    glm::vec3 normal(0.0f);
    for (glm::length_t k = 0; k < 3; ++k) {
      const int corner = corners[static_cast<std::size_t>(k)];
      point += weights[k] * at(mesh_.positions, corner);
      normal += weights[k] * at(mesh_.normals, corner);
    }
    normal = normalizeOr(normal, camera_.towards);
    if (glm::dot(normal, camera_.towards) < 0.0f) normal = -normal;
    const glm::vec3 seen(glm::dot(normal, camera_.right), glm::dot(normal, camera_.up),
                         glm::dot(normal, camera_.towards));
    const float light = kAmbient + (1.0f - kAmbient) * std::max(glm::dot(seen, glm::normalize(kLight)), 0.0f);
    float weight = 0.0f;
    for (const Ball& muscle : muscles_) weight = std::max(weight, muscle.weightAt(point));
    return light * glm::mix(kClay, kFlesh, weight);
  }

  const ControlMesh& mesh_;
  const PictureCamera& camera_;
  std::vector<Ball> muscles_;
  glm::ivec2 size_;
  std::vector<float> near_;
  std::vector<glm::vec3> colors_;
};

}  // namespace

Image musclePicture(const Character& character, std::span<const Primitive> muscles, float least) {
  Image image{kMusclePicture.x, kMusclePicture.y, {}};
  std::vector<Ball> balls;
  std::optional<Placement> first;
  for (const Primitive& muscle : muscles) {
    const auto placement = inWorld(character, muscle);
    if (!placement) continue;
    balls.push_back(ballOf(*placement));
    if (!first) first = placement;
  }
  const glm::ivec2 fine = kFiner * kMusclePicture;
  const PictureCamera camera = cameraFor(character, first.value_or(Placement{}), least, fine);
  const std::vector<glm::vec3> colors = Painter(character, camera, std::move(balls), fine).paint();
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      glm::vec3 sum(0.0f);
      for (int k = 0; k < kFiner * kFiner; ++k) {
        const int from = (kFiner * y + k / kFiner) * fine.x + kFiner * x + k % kFiner;
        sum += at(colors, from);
      }
      sum *= 255.0f / static_cast<float>(kFiner * kFiner);
      for (glm::length_t c = 0; c < 3; ++c)
        image.rgba.push_back(static_cast<std::uint8_t>(std::clamp(sum[c] + 0.5f, 0.0f, 255.0f)));
      image.rgba.push_back(255);
    }
  }
  return image;
}

}  // namespace sinew::app
