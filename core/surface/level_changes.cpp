// core/surface/level_changes.cpp: muscles of two rigs compared by pose; skin whose rays meet changed ones.
#include "core/surface/adaptive_levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "core/character/skinning.h"
#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/surface/posed_field.h"

namespace sinew {
namespace {

/// Largest bulge of a patch, as a fraction of the largest rise of an edge along an end's normal: 1/2 for PN triangles
/// (a third at the sides' control points, half as much more at the middle one), 3/4 for Phong's.
constexpr float kMostBulge = 0.75f;
constexpr std::size_t kFewLooked = 1024;  ///< Carriers or triangles for one thread.

bool samePosed(const PosedPrimitive& a, const PosedPrimitive& b) {
  const UnitBallMap& x = a.influence;
  const UnitBallMap& y = b.influence;
  const auto sameShape = [](const UnitShape& s, const UnitShape& t) {
    return s.isPlain == t.isPlain && s.lateral == t.lateral && s.taper == t.taper && s.bend == t.bend &&
           s.curve == t.curve && s.core == t.core && s.inverseEnd == t.inverseEnd && s.low == t.low && s.high == t.high;
  };
  return a.strength == b.strength && a.meanRadius == b.meanRadius && a.groove == b.groove && x.toUnit == y.toUnit &&
         x.center == y.center && x.boundingRadius == y.boundingRadius && x.inverseRadius == y.inverseRadius &&
         x.form == y.form && sameShape(x.shape, y.shape);
}

/// Compares what affects all samples.
bool sameElsewhere(const LevelSources& a, const LevelSources& b) {
  const auto sameWidths = [](const LevelMuscles& x, const LevelMuscles& y) {
    return x.skinBlend == y.skinBlend && x.grooves == y.grooves && x.links == y.links;
  };
  return a.tolerance == b.tolerance && a.poses == b.poses && sameCandidates(*a.rig, *b.rig) &&
         a.rig->surface.mode == b.rig->surface.mode && a.rig->surface.iso == b.rig->surface.iso &&
         a.rig->smoothing.patch == b.rig->smoothing.patch &&
         a.rig->smoothing.alongNormals == b.rig->smoothing.alongNormals &&
         std::ranges::equal(a.muscles, b.muscles, sameWidths);
}

/// An influence that an edit has changed, before or after.
struct ChangedInfluence {
  const UnitBallMap* influence = nullptr;
  float scale = 0.0f;  ///< Largest factor by which its map lengthens a vector.
};

float mostScale(const glm::mat3& map) {
  return std::sqrt(glm::dot(map[0], map[0]) + glm::dot(map[1], map[1]) + glm::dot(map[2], map[2]));
}

/// Bundle of all rays from a triangle's patch along means of its corners' directions: at s along the middle ray all are
/// within near + s turn of it, since a mean of unit directions is at most as long as a unit direction.
struct TriangleRays {
  glm::vec3 from{0.0f};  ///< Start of the middle ray.
  glm::vec3 way{0.0f};   ///< Its direction, shorter than 1.
  float near = 0.0f;
  float turn = 0.0f;
};

/// @param from, way  the corners' rays, unit.  @param bulge  largest distance of the patch from the triangle
TriangleRays raysFrom(const std::array<glm::vec3, 3>& from, const std::array<glm::vec3, 3>& way, float bulge) {
  TriangleRays out{(from[0] + from[1] + from[2]) / 3.0f, (way[0] + way[1] + way[2]) / 3.0f, 0.0f, 0.0f};
  float near = 0.0f;
  float turn = 0.0f;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::vec3 apart = from[i] - out.from;
    const glm::vec3 turned = way[i] - out.way;
    near = std::max(near, glm::dot(apart, apart));
    turn = std::max(turn, glm::dot(turned, turned));
  }
  out.near = std::sqrt(near) + bulge;
  out.turn = std::sqrt(turn);
  return out;
}

/// Whether such a ray may meet a ball, with the margins of the projection's own test: 1 % and rounding.
bool mayMeet(const TriangleRays& rays, bool bothWays, const glm::vec3& center, float radius) {
  const glm::vec3 to = center - rays.from;
  const float apart = std::sqrt(glm::dot(to, to));
  const float within = 1.01f * radius + 0.005f * apart + rays.near;
  if (apart <= within) return true;
  const float narrow = glm::dot(rays.way, rays.way) - rays.turn * rays.turn;
  if (!(narrow > 0.0f)) return true;
  const float ahead = glm::dot(to, rays.way);
  const float toward = (bothWays ? std::abs(ahead) : ahead) + within * rays.turn;
  // Least of |to - s way|^2 - (within + s turn)^2 over s > 0.
  return toward > 0.0f && 1.001f * toward * toward >= narrow * (apart - within) * (apart + within);
}

struct PosedTriangle {
  std::array<glm::vec3, 3> from{};
  std::array<glm::vec3, 3> way{};
  float bulge = 0.0f;
  bool bothWays = false;
  TriangleRays rays;  ///< In the world.

  [[nodiscard]] bool mayMeetInUnitSpace(const ChangedInfluence& changed) const {
    const UnitBallMap& influence = *changed.influence;
    const auto mapped = [&](const glm::vec3& p) { return influence.toUnit * (p - influence.center); };
    const auto turned = [&](const glm::vec3& d) { return influence.toUnit * d; };
    const TriangleRays unit = raysFrom({mapped(from[0]), mapped(from[1]), mapped(from[2])},
                                       {turned(way[0]), turned(way[1]), turned(way[2])}, changed.scale * bulge);
    return mayMeet(unit, bothWays, glm::vec3(0.0f), 1.0f);
  }

  [[nodiscard]] bool mayMeetAny(std::span<const ChangedInfluence> all) const {
    return std::ranges::any_of(all, [&](const ChangedInfluence& changed) {
      const UnitBallMap& influence = *changed.influence;
      return mayMeet(rays, bothWays, influence.center, influence.boundingRadius) &&
             (!influence.isPlain() || mayMeetInUnitSpace(changed));
    });
  }
};

class Changes {
 public:
  Changes(const Preparation& next, const LevelSources& before, const LevelSources& after)
      : next_(next), before_(before), after_(after), changed_(next.primitives.size(), false) {
    for (std::size_t pose = 0; pose < after.poses.size(); ++pose) poses_.push_back(changesIn(pose));
  }

  /// [T] 1: some ray from the triangle may meet a changed influence.
  [[nodiscard]] std::vector<std::uint8_t> triangles() const {
    std::vector<std::uint8_t> mayChange = seeingTriangles();
    // The rays are known only for `swell`, and the bulge is not known for spherigons.
    if (!next_.swells() || next_.smoothing.patch == PatchKind::kSpherigon) return mayChange;
    std::vector<std::uint8_t> out(mayChange.size(), 0);
    SkinnedMesh skinned;
    std::vector<glm::vec3> rise;
    const std::vector<float> base(next_.character().morphTargets.size(), 0.0f);
    for (std::size_t pose = 0; pose < poses_.size(); ++pose) {
      if (poses_[pose].influences.empty()) continue;
      skin(next_.character(), after_.poses[pose], base, skinned);
      skinDirections(next_.character(), next_.tables->riseInBind, skinned, rise);
      forEachIndex(out.size(), kFewLooked, [&](std::size_t t) {
        if (mayChange[t] == 0 || out[t] != 0) return;
        const PosedTriangle posed = posedTriangle(next_.mesh().triangles[t], skinned, rise, poses_[pose].carves);
        out[t] = posed.mayMeetAny(poses_[pose].influences) ? 1 : 0;
      });
    }
    return out;
  }

 private:
  struct ChangesInPose {
    std::vector<ChangedInfluence> influences;
    bool carves = false;  ///< Some muscle pulls skin inwards.
  };

  [[nodiscard]] ChangesInPose changesIn(std::size_t pose) {
    ChangesInPose out;
    const std::vector<int>& rigIndex = next_.attached->attachment.rigIndex;
    for (std::size_t i = 0; i < changed_.size(); ++i) {
      const PosedPrimitive& before = before_.muscles[pose].primitives[i];
      const PosedPrimitive& after = after_.muscles[pose].primitives[i];
      out.carves |= before.strength < 0.0f || after.strength < 0.0f;
      const bool wasHidden = std::ranges::binary_search(before_.hidden, rigIndex[i]);
      const bool isHidden = std::ranges::binary_search(after_.hidden, rigIndex[i]);
      if (wasHidden == isHidden && samePosed(before, after)) continue;
      changed_[i] = true;
      for (const PosedPrimitive* muscle : {&before, &after}) {
        const UnitBallMap& influence = muscle->influence;
        if (influence.boundingRadius == 0.0f) continue;
        out.influences.push_back({&influence, mostScale(influence.toUnit)});
      }
    }
    return out;
  }

  /// [T] 1: the triangle, one of its edges or one of its corners sees a changed muscle.
  [[nodiscard]] std::vector<std::uint8_t> seeingTriangles() const {
    const ControlMesh& mesh = next_.mesh();
    const std::size_t firstEdge = mesh.positions.size();
    const std::size_t firstTriangle = firstEdge + mesh.edges.size();
    std::vector<std::uint8_t> sees(firstTriangle + mesh.triangles.size());
    forEachIndex(sees.size(), kFewLooked, [&](std::size_t c) {
      sees[c] = std::ranges::any_of(next_.attached->candidates.of(static_cast<int>(c)),
                                    [&](const CarrierCandidate& one) { return changed_[toIndex(one.primitive)]; });
    });
    std::vector<std::uint8_t> out(mesh.triangles.size());
    forEachIndex(out.size(), kFewLooked, [&](std::size_t t) {
      const ControlTriangle& triangle = mesh.triangles[t];
      std::uint8_t any = sees[firstTriangle + t];
      for (const int v : triangle.vertices) any |= at(sees, v);
      for (const int e : triangle.edges) any |= sees[firstEdge + toIndex(e)];
      out[t] = any;
    });
    return out;
  }

  static PosedTriangle posedTriangle(const ControlTriangle& triangle, const SkinnedMesh& skinned,
                                     std::span<const glm::vec3> rise, bool bothWays) {
    PosedTriangle out;
    out.bothWays = bothWays;
    float rises = 0.0f;
    for (std::size_t i = 0; i < 3; ++i) {
      const int v = triangle.vertices[i];
      out.from[i] = at(skinned.positions, v);
      out.way[i] = at(rise, v);
      for (const int other : triangle.vertices) {
        const glm::vec3 edge = at(skinned.positions, other) - out.from[i];
        rises = std::max(rises, std::abs(glm::dot(edge, at(skinned.normals, v))));
      }
    }
    out.bulge = kMostBulge * rises;
    out.rays = raysFrom(out.from, out.way, out.bulge);
    return out;
  }

  const Preparation& next_;
  const LevelSources& before_;
  const LevelSources& after_;
  std::vector<bool> changed_;  ///< [A] in some pose.
  std::vector<ChangesInPose> poses_;
};

}  // namespace

LevelSources levelSources(const Preparation& next, std::shared_ptr<const Rig> rig, float tolerance,
                          std::vector<Pose> poses) {
  LevelSources out{std::move(rig), next.hidden, tolerance, std::move(poses), {}};
  PosedRig posed;
  std::vector<FieldPrimitive> numbers;
  for (const Pose& pose : out.poses) {
    next.poser->pose(pose, posed);
    LevelMuscles& muscles = out.muscles.emplace_back();
    muscles.skinBlend = posed.numbers.skinBlend;
    muscles.grooves = posed.numbers.grooves;
    muscles.links = posed.numbers.links;
    posePrimitives(next, posed, numbers, muscles.primitives);
  }
  return out;
}

std::vector<bool> carriersToLookAt(const Preparation& next, const LevelSources& asked, const LevelSources* former) {
  const ControlMesh& mesh = next.mesh();
  const std::size_t firstEdge = mesh.positions.size();
  const std::size_t firstTriangle = firstEdge + mesh.edges.size();
  const std::size_t carriers = firstTriangle + mesh.triangles.size();
  if (!former || !sameElsewhere(*former, asked)) return std::vector<bool>(carriers, true);
  const std::vector<std::uint8_t> seen = Changes(next, *former, asked).triangles();
  std::vector<bool> out(carriers, false);
  for (std::size_t t = 0; t < seen.size(); ++t) {
    if (seen[t] == 0) continue;
    const ControlTriangle& triangle = mesh.triangles[t];
    out[firstTriangle + t] = true;
    for (const int v : triangle.vertices) out[toIndex(v)] = true;
    for (const int e : triangle.edges) out[firstEdge + toIndex(e)] = true;
  }
  return out;
}

}  // namespace sinew
