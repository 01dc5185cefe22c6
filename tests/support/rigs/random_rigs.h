// tests/support/rigs/random_rigs.h: seeded rigs and poses; the same seed gives the same on every machine.
#pragma once

#include <cstdint>

#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/rig/rig.h"

namespace sinew::test {

/// Small, fast, portable generator (SplitMix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  [[nodiscard]] std::uint64_t next();
  [[nodiscard]] float uniform(float low, float high);
  [[nodiscard]] int below(int count);  ///< 0 .. count-1
  [[nodiscard]] bool chance(float probability) { return uniform(0.0f, 1.0f) < probability; }
  [[nodiscard]] glm::quat rotation();

 private:
  std::uint64_t state_;
};

struct RigRecipe {
  int primitives = 5;
  int groups = 3;           ///< 1..8
  float linkChance = 0.4f;  ///< Chance of each pair of groups to be linked.
  float partChance = 0.0f;  ///< Chance of a link to have an amount below 1.
  float carveChance = 0.15f;
  float radiusLow = 0.03f;  ///< Fractions of H.
  float radiusHigh = 0.10f;
  float shapedChance = 0.0f;   ///< Chance of a primitive to be no ellipsoid.
  float reachHigh = 2.0f;      ///< At least 1.2.
  float groovesChance = 0.0f;  ///< Chance of soft grooves, 0.002 H to 0.3 H wide.
};

/// Many muscles with steep rims.
inline constexpr RigRecipe kShortReach{.primitives = 24, .reachHigh = 1.5f};

/// A random valid shape for a reach; plain, straight and untapered ones among them.
[[nodiscard]] Shape randomShape(Random& random, float reach);

/// Ellipsoids as a designer might set them: centers a little under or over the skin of random bones, any orientation,
/// reach from 1.2; default territories but for a few.
[[nodiscard]] Rig randomRig(const Character& character, const RigRecipe& recipe, std::uint64_t seed);

/// Every bone rotated against its parent by up to `angle` radians and scaled unevenly by up to `stretch`, from the bind
/// pose.
[[nodiscard]] Pose randomPose(const Skeleton& skeleton, float angle, float stretch, std::uint64_t seed);

/// One ellipsoid of the given radii (character units) on a bone, centered at a bind-pose point in the world.
[[nodiscard]] Primitive ellipsoidAt(const Character& character, const std::string& name, const std::string& bone,
                                    const std::string& group, const glm::vec3& centerInBindWorld,
                                    const glm::vec3& radii);

}  // namespace sinew::test
