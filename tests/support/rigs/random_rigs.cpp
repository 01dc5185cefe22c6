// tests/support/rigs/random_rigs.cpp: seeded rigs and poses.

#include "tests/support/rigs/random_rigs.h"

#include <cassert>
#include <cmath>
#include <span>
#include <string>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/character/bindings.h"
#include "core/geometry/affine_image.h"
#include "core/geometry/index_table.h"

namespace sinew::test {
namespace {

/// World units per bone unit in the bind pose.
float bindScale(const Bone& bone) { return std::cbrt(std::abs(glm::determinant(glm::mat3(bone.bindInWorld)))); }

}  // namespace

std::uint64_t Random::next() {
  const std::uint64_t value = splitMix64(state_);
  state_ += kSplitMixStep;
  return value;
}

float Random::uniform(float low, float high) {
  const double unit = static_cast<double>(next() >> 11) * 0x1.0p-53;
  return static_cast<float>(static_cast<double>(low) + unit * (static_cast<double>(high) - static_cast<double>(low)));
}

int Random::below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }

glm::quat Random::rotation() {
  const float z = uniform(-1.0f, 1.0f);
  const float around = uniform(0.0f, glm::two_pi<float>());
  const float flat = std::sqrt(1.0f - z * z);
  return glm::angleAxis(uniform(0.0f, glm::pi<float>()),
                        glm::vec3(flat * std::cos(around), flat * std::sin(around), z));
}

Primitive ellipsoidAt(const Character& character, const std::string& name, const std::string& bone,
                      const std::string& group, const glm::vec3& centerInBindWorld, const glm::vec3& radii) {
  const auto index = character.skeleton.findBone(bone);
  assert(index);
  const Bone& found = character.skeleton.bones[static_cast<std::size_t>(*index)];
  Primitive out;
  out.name = name;
  out.bone = bone;
  out.group = group;
  out.placement.center = glm::vec3(found.inverseBindInWorld * glm::vec4(centerInBindWorld, 1.0f));
  out.placement.radii = radii / bindScale(found);
  return out;
}

Shape randomShape(Random& random, float reach) {
  Shape shape;
  for (const std::span<const ShapeNumber> key : shapeKeys()) {
    if (!random.chance(0.6f)) continue;
    for (const ShapeNumber& number : key) {
      const auto [low, high] = number.range(shape, reach);
      number.member(shape) = random.uniform(low, high);
    }
  }
  return shape;
}

Rig randomRig(const Character& character, const RigRecipe& recipe, std::uint64_t seed) {
  Random random(seed);
  const ControlMesh& mesh = character.mesh;
  const float height = character.height;
  Rig rig;
  for (int i = 0; i < recipe.groups; ++i) {
    rig.groups.push_back({"group " + std::to_string(i), {}});
    for (int j = 0; j < i; ++j) {
      if (!random.chance(recipe.linkChance)) continue;
      rig.links.push_back({{"group " + std::to_string(j), "group " + std::to_string(i)}});
      if (recipe.partChance > 0.0f && random.chance(recipe.partChance))
        rig.links.back().amount = random.chance(0.5f) ? 0.5f : random.uniform(0.05f, 0.95f);
    }
  }
  for (int i = 0; i < recipe.primitives; ++i) {
    const int vertex = random.below(static_cast<int>(mesh.positions.size()));
    const int bone = strongestBone(character, vertex);
    const glm::vec3 normal = mesh.normals[static_cast<std::size_t>(vertex)];
    const glm::vec3 center =
        mesh.positions[static_cast<std::size_t>(vertex)] + random.uniform(-0.06f, 0.02f) * height * normal;
    const auto radius = [&] { return height * random.uniform(recipe.radiusLow, recipe.radiusHigh); };
    const glm::vec3 radii(radius(), radius(), radius());
    const std::string group = "group " + std::to_string(random.below(recipe.groups));
    Primitive primitive =
        ellipsoidAt(character, "muscle " + std::to_string(i), character.skeleton.fileName(bone), group, center, radii);
    primitive.placement.rotation = random.rotation();
    primitive.reach = random.uniform(1.2f, recipe.reachHigh);
    primitive.sign = random.chance(recipe.carveChance) ? -1 : 1;
    if (random.chance(0.15f)) {
      const int other = random.below(static_cast<int>(character.skeleton.bones.size()));
      primitive.territory = {{primitive.bone, character.skeleton.fileName(other)}};
    }
    if (recipe.shapedChance > 0.0f && random.chance(recipe.shapedChance)) {
      primitive.placement.shape = randomShape(random, primitive.reach);
    }
    rig.primitives.push_back(primitive);
  }
  if (recipe.groovesChance > 0.0f && random.chance(recipe.groovesChance)) {
    rig.surface.grooves = random.chance(0.25f) ? random.uniform(0.05f, 0.3f) : random.uniform(0.002f, 0.05f);
  }
  return rig;
}

Pose randomPose(const Skeleton& skeleton, float angle, float stretch, std::uint64_t seed) {
  Random random(seed);
  Pose pose;
  for (const Bone& bone : skeleton.bones) {
    const auto parent = static_cast<std::size_t>(bone.parent);
    glm::mat4 inWorld = bone.bindInWorld;
    if (bone.parent >= 0)
      inWorld = pose.boneInWorld[parent] * skeleton.bones[parent].inverseBindInWorld * bone.bindInWorld;
    const float share = random.uniform(0.0f, 1.0f);
    glm::quat turn = glm::slerp(glm::quat(1.0f, 0.0f, 0.0f, 0.0f), random.rotation(), share * angle / glm::pi<float>());
    glm::vec3 scale(1.0f);
    for (int i = 0; i < 3; ++i) scale[i] += random.uniform(-stretch, stretch);
    pose.boneInWorld.push_back(inWorld * glm::mat4_cast(turn) * glm::scale(glm::mat4(1.0f), scale));
  }
  return pose;
}

}  // namespace sinew::test
