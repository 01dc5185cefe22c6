// app/command/costs.cpp: rigs of different size smooth the same moments in turn; a clip is drawn off screen.

#include "app/command/costs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "app/ui/offscreen.h"
#include "app/viewport/render/view.h"
#include "app/viewport/render/viewport.h"
#include "core/character/bindings.h"
#include "core/character/skinning.h"
#include "core/geometry/at.h"
#include "core/rig/trial_rig.h"
#include "sinew/geometry/geometry.h"

namespace sinew::app {

namespace {

constexpr float kReach = 1.5f;

/// Running sums of the triangles' areas.
std::vector<float> runningAreas(const ControlMesh& mesh) {
  std::vector<float> sums;
  float sum = 0.0f;
  for (const ControlTriangle& triangle : mesh.triangles) {
    const auto corner = [&](std::size_t i) { return at(mesh.positions, triangle.vertices[i]); };
    sum += 0.5f * glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    sums.push_back(sum);
  }
  return sums;
}

/// Barycentric coordinates of a low-discrepancy sequence over a triangle: multiples of the plastic number.
glm::vec3 barycentric(int number) {
  float u = std::fmod(0.5f + 0.7548776662f * static_cast<float>(number % 4096), 1.0f);
  float v = std::fmod(0.5f + 0.5698402910f * static_cast<float>(number % 4096), 1.0f);
  if (u + v > 1.0f) {
    u = 1.0f - u;
    v = 1.0f - v;
  }
  return {1.0f - u - v, u, v};
}

}  // namespace

Rig evenRig(const Character& character, int muscles) {
  const ControlMesh& mesh = character.mesh;
  const std::vector<float> areas = runningAreas(mesh);
  // muscles * pi (reach radius)^2 = overlap * area
  const float share = kEvenOverlap * areas.back() / (static_cast<float>(muscles) * std::numbers::pi_v<float>);
  const float radius = std::sqrt(share) / kReach;
  Rig rig;
  rig.groups.push_back({"even", {}});
  for (int i = 0; i < muscles; ++i) {
    const float wanted = areas.back() * (static_cast<float>(i) + 0.5f) / static_cast<float>(muscles);
    const auto found = std::ranges::lower_bound(areas, wanted) - areas.begin();
    const ControlTriangle& triangle = mesh.triangles[std::min(static_cast<std::size_t>(found), areas.size() - 1)];
    const glm::vec3 weights = barycentric(i);
    glm::vec3 point(0.0f), out(0.0f);
    std::size_t nearest = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const float weight = weights[static_cast<int>(c)];
      point += weight * at(mesh.positions, triangle.vertices[c]);
      out += weight * at(mesh.normals, triangle.vertices[c]);
      if (weight > weights[static_cast<int>(nearest)]) nearest = c;
    }
    const int boneIndex = strongestBone(character, triangle.vertices[nearest]);
    const Bone& bone = at(character.skeleton.bones, boneIndex);
    const float scale = std::cbrt(std::abs(glm::determinant(glm::mat3(bone.bindInWorld))));
    Primitive primitive;
    primitive.name = "muscle " + std::to_string(i + 1);
    primitive.bone = character.skeleton.fileName(boneIndex);
    primitive.group = rig.groups.front().name;
    primitive.reach = kReach;
    const glm::vec3 center = point - 0.5f * radius * normalizeOr(out, {0.0f, 1.0f, 0.0f});
    primitive.placement.center = glm::vec3(bone.inverseBindInWorld * glm::vec4(center, 1.0f));
    primitive.placement.radii = glm::vec3(radius / (scale > 0.0f ? scale : 1.0f));
    rig.primitives.push_back(std::move(primitive));
  }
  return rig;
}

namespace {

constexpr int kFrames = 8;
constexpr int kFramesOfGrowth = 2;  ///< Few: depth 12 and 4,000 muscles take long.
constexpr std::array kDepths{2, 3, 4, 5, 6, 8, 10, 12};
constexpr std::array kMuscles{41, 400, 4000};
/// Depths with more are skipped, so that a large character does not fill the memory.
constexpr std::int64_t kMostVertices = 200'000;
constexpr double kStep = 1.0 / 60.0;
constexpr int kSamples = 4;
constexpr glm::ivec2 kSize{1280, 800};

/// A rig and its timed frames, in the order of rounds and moments.
struct Contender {
  Smoother smoother;
  Surface surface;
  std::vector<double> seconds, projected;
};

/// Smooths all moments with every rig in each round.
Result<std::vector<Contender>> run(const BenchScene& scene, const std::vector<Rig>& rigs,
                                   const std::vector<Pose>& poses, int rounds) {
  std::vector<Contender> contenders;
  for (const Rig& rig : rigs) {
    Result<Smoother> smoother = preparedSmoother(scene, rig);
    if (!smoother) return smoother.error();
    contenders.push_back({std::move(smoother.value()), {}, {}, {}});
  }
  inTurn(contenders.size(), rounds, [&](std::size_t variant, int round) {
    Contender& contender = contenders[variant];
    for (const Pose& pose : poses) {
      contender.smoother.smooth(pose, contender.surface);
      if (round == 0) continue;
      contender.seconds.push_back(contender.surface.report.seconds.total());
      contender.projected.push_back(contender.surface.report.projected);
    }
  });
  return contenders;
}

Rig withoutMuscles(Rig rig) {
  rig.primitives.clear();
  return rig;
}

/// Median time above the floor of the same moment and round, per projected vertex; at least 0.
double secondsPerProjected(const Contender& with, const Contender& floor) {
  std::vector<double> each;
  for (std::size_t i = 0; i < with.seconds.size(); ++i) {
    if (with.projected[i] > 0.0) each.push_back((with.seconds[i] - floor.seconds[i]) / with.projected[i]);
  }
  return std::max(median(std::move(each)), 0.0);
}

}  // namespace

Result<MuscleCost> measureMuscleCost(const BenchScene& scene, int rounds) {
  const Rig rig = rigAt(scene, kBenchDepth);
  const auto contenders =
      run(scene, {rig, withoutMuscles(rig)}, steadyFrames(*scene.character, kFrames, kStep), rounds);
  if (!contenders) return contenders.error();
  const Contender& with = contenders->front();
  const Contender& floor = contenders->back();
  MuscleCost cost;
  cost.withOverWithout = medianRatio(with.seconds, floor.seconds);
  cost.nsPerProjectedVertex = 1e9 * secondsPerProjected(with, floor);
  cost.nsPerVertexFloor = 1e9 * median(floor.seconds) / std::max<double>(1, floor.surface.report.refinedVertices);
  cost.frameSeconds = median(with.seconds);
  return cost;
}

Result<double> exponentOfVertices(const BenchScene& scene, int rounds) {
  std::vector<Rig> rigs;
  for (const int depth : kDepths) {
    const bool fits = refinedVertexCount(scene.character->mesh, depth) <= kMostVertices;
    if (fits || rigs.size() < 3) rigs.push_back(rigAt(scene, depth));
  }
  const auto contenders = run(scene, rigs, steadyFrames(*scene.character, kFramesOfGrowth, kStep), rounds);
  if (!contenders) return contenders.error();
  std::vector<double> vertices, seconds;
  for (const Contender& contender : contenders.value()) {
    vertices.push_back(contender.surface.report.refinedVertices);
    seconds.push_back(median(contender.seconds));
  }
  return exponent(vertices, seconds);
}

Result<double> exponentOfPrimitives(const BenchScene& scene, int rounds) {
  if (skinsOf(*scene.character).empty()) return Error{"", scene.name, "no skin to lay muscles in"};
  std::vector<Rig> rigs;
  for (const int muscles : kMuscles) {
    Rig rig = evenRig(*scene.character, muscles);
    rig.surface = scene.rig.surface;
    rig.surface.animated.clear();
    rig.smoothing = rigAt(scene, kBenchDepth).smoothing;
    rigs.push_back(std::move(rig));
  }
  rigs.push_back(withoutMuscles(rigs.front()));
  const auto contenders = run(scene, rigs, steadyFrames(*scene.character, kFramesOfGrowth, kStep), rounds);
  if (!contenders) return contenders.error();
  std::vector<double> muscles, seconds;
  for (std::size_t i = 0; i < kMuscles.size(); ++i) {
    muscles.push_back(kMuscles[i]);
    seconds.push_back(secondsPerProjected(contenders.value()[i], contenders->back()));
  }
  return exponent(muscles, seconds);
}

Result<DrawCost> measureDrawing(const BenchScene& scene, int rounds) {
  const Rig rig = rigAt(scene, kBenchDepth);
  Result<Smoother> smoother = preparedSmoother(scene, rig);
  if (!smoother) return smoother.error();
  const auto context = OffscreenContext::create();
  if (!context) return context.error();
  const auto viewport = Viewport::create(kSamples);
  if (!viewport) return viewport.error();
  viewport.value()->setCharacter(*scene.character);
  viewport.value()->setFinishFrames(true);
  const std::vector<Pose> poses = steadyFrames(*scene.character, rounds + 1, kStep);
  SkinnedMesh skinned;
  skin(*scene.character, poses.front(), skinned);
  const View view = framedView(skinned.positions, 0.5f, 0.2f, kSize, false);
  const RigPoser poser(rig, *scene.character);
  std::vector<double> draw, upload;
  for (std::size_t p = 0; p < poses.size(); ++p) {  // The first picture makes programs and textures.
    Surface surface;
    smoother.value().smooth(poses[p], surface);
    Scene picture;
    picture.character = scene.character.get();
    picture.surface = &surface;
    picture.pose = &poses[p];
    picture.primitives = shapesOf(rig, poser.pose(poses[p]));
    viewport.value()->draw(picture, view, {});
    if (p == 0) continue;
    draw.push_back(viewport.value()->seconds().draw);
    upload.push_back(viewport.value()->seconds().upload);
  }
  return DrawCost{median(draw), median(upload)};
}

}  // namespace sinew::app
