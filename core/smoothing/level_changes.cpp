// core/smoothing/level_changes.cpp: muscles of two rigs, pose by pose, and the skin whose rays can meet what differs.
#include "core/smoothing/level_changes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/at.h"
#include "core/base/parallel.h"
#include "core/character/skinning.h"
#include "core/smoothing/place_muscles.h"

namespace sinew {
namespace {

/// How far a patch may bulge, of the most that an edge of its corners rises along a normal there: 1/2 of PN triangles
/// (a third at the sides' control points, half as much more at the middle one), 3/4 of Phong's.
constexpr float kMostBulge = 0.75f;

bool samePosed(const PosedPrimitive& a, const PosedPrimitive& b) {
  const UnitBallMap& x = a.influence;
  const UnitBallMap& y = b.influence;
  const auto sameShape = [](const UnitShape& s, const UnitShape& t) {
    return s.isPlain == t.isPlain && s.lateral == t.lateral && s.taper == t.taper && s.bend == t.bend &&
           s.curve == t.curve && s.core == t.core && s.inverseEnd == t.inverseEnd && s.low == t.low && s.high == t.high;
  };
  return a.strength == b.strength && a.meanRadius == b.meanRadius && x.toUnit == y.toUnit && x.center == y.center &&
         x.boundingRadius == y.boundingRadius && x.inverseRadius == y.inverseRadius && x.form == y.form &&
         sameShape(x.shape, y.shape);
}

/// What decides over all samples alike.
bool sameElsewhere(const LevelSources& a, const LevelSources& b) {
  const auto sameBlend = [](const LevelMuscles& x, const LevelMuscles& y) { return x.skinBlend == y.skinBlend; };
  return a.tolerance == b.tolerance && a.poses == b.poses && sameCandidates(*a.rig, *b.rig) &&
         a.rig->surface.mode == b.rig->surface.mode && a.rig->surface.iso == b.rig->surface.iso &&
         a.rig->smoothing.patch == b.rig->smoothing.patch &&
         a.rig->smoothing.projection == b.rig->smoothing.projection &&
         std::ranges::equal(a.muscles, b.muscles, sameBlend);
}

/// An influence that an edit has changed, before or after.
struct ChangedInfluence {
  int primitive = 0;
  const UnitBallMap* influence = nullptr;
  float scale = 0.0f;  ///< By how much its map lengthens anything, at most.
};

float mostScale(const glm::mat3& map) {
  return std::sqrt(glm::dot(map[0], map[0]) + glm::dot(map[1], map[1]) + glm::dot(map[2], map[2]));
}

/// A ray that begins within `near` of a place, and goes within `turn` of a direction.
struct AboutRay {
  glm::vec3 from{0.0f};
  glm::vec3 way{0.0f};  ///< Unit.
  float near = 0.0f;
  float turn = 0.0f;
  bool bothWays = false;
};

/// Whether such a ray may meet a ball. The projection's own test is as generous: a hundredth more, and rounding.
/// @param map  the ball's space; lengths there are at most `scale` times as long
bool mayMeet(const AboutRay& ray, const glm::mat3& map, float scale, const glm::vec3& center, float radius) {
  const glm::vec3 to = map * (center - ray.from);
  const glm::vec3 way = map * ray.way;
  const float apart = glm::length(to);
  const float generous = 1.01f * radius + 0.005f * apart + scale * ray.near;
  if (apart <= generous) return true;
  const float rate = glm::length(way);
  if (!(rate > 0.0f)) return true;
  const float ahead = glm::dot(to, way) / rate;
  const float along = ray.bothWays ? std::abs(ahead) : std::max(0.0f, ahead);
  const float aside = std::sqrt(std::max(0.0f, apart * apart - along * along));
  return aside <= generous + scale * ray.turn / rate * (apart + generous);
}

bool mayMeet(const AboutRay& ray, const ChangedInfluence& changed) {
  const UnitBallMap& influence = *changed.influence;
  return mayMeet(ray, glm::mat3(1.0f), 1.0f, influence.center, influence.boundingRadius) &&
         (!influence.isPlain() || mayMeet(ray, influence.toUnit, changed.scale, influence.center, 1.0f));
}

class Changes {
 public:
  Changes(const Preparation& next, const LevelSources& before, const LevelSources& after)
      : next_(next), before_(before), after_(after), changed_(next.primitives.size(), false) {
    for (std::size_t pose = 0; pose < after.poses.size(); ++pose) poses_.push_back(changesIn(pose));
  }

  /// [V] 1: some ray from around the vertex may meet what has changed.
  [[nodiscard]] std::vector<std::uint8_t> vertices() const {
    const ControlMesh& mesh = next_.mesh();
    std::vector<std::uint8_t> mayChange(mesh.positions.size(), 0);
    for (std::size_t v = 0; v < mayChange.size(); ++v) {
      mayChange[v] = std::ranges::any_of(next_.attached->candidates.of(static_cast<int>(v)),
                                         [&](const CarrierCandidate& c) { return changed_[toIndex(c.primitive)]; });
    }
    // Where rays go is known of `swell` alone, and how far a spherigon bulges of no patch.
    if (!next_.swells() || next_.smoothing.patch == PatchKind::kSpherigon) return mayChange;
    std::vector<std::uint8_t> out(mayChange.size(), 0);
    SkinnedMesh skinned;
    std::vector<glm::vec3> rise;
    const std::vector<float> base(next_.character().morphTargets.size(), 0.0f);
    for (std::size_t pose = 0; pose < poses_.size(); ++pose) {
      if (poses_[pose].influences.empty()) continue;
      skin(next_.character(), after_.poses[pose], base, skinned);
      skinDirections(next_.character(), next_.tables->riseInBind, skinned, rise);
      const std::vector<Surroundings> around = surroundingsOf(skinned, rise);
      forRanges(out.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
          if (mayChange[v] == 0 || out[v] != 0) continue;
          const Surroundings& near = around[v];
          const AboutRay ray{skinned.positions[v], rise[v], near.longest + kMostBulge * near.bulge, 2.0f * near.turn,
                             poses_[pose].carves};
          out[v] = canMeet(static_cast<int>(v), ray, poses_[pose]) ? 1 : 0;
        }
      });
    }
    return out;
  }

 private:
  /// How a vertex's triangles differ from it.
  struct Surroundings {
    float longest = 0.0f;  ///< Of its edges.
    float turn = 0.0f;     ///< Largest difference between its rise direction and a neighbor's.
    float bulge = 0.0f;    ///< How far an edge there or at a neighbor rises along the normal of an end.
  };

  struct ChangesInPose {
    std::vector<ChangedInfluence> influences;
    bool carves = false;  ///< Some muscle draws skin inwards.
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
        out.influences.push_back({static_cast<int>(i), &influence, mostScale(influence.toUnit)});
      }
    }
    return out;
  }

  [[nodiscard]] std::vector<Surroundings> surroundingsOf(const SkinnedMesh& skinned,
                                                         std::span<const glm::vec3> rise) const {
    std::vector<Surroundings> out(rise.size());
    std::vector<float> bulges(rise.size(), 0.0f);
    const auto forEachEdge = [&](const auto& visit) {
      for (const Edge& edge : next_.mesh().edges) visit(edge.vertices[0], edge.vertices[1]);
    };
    forEachEdge([&](int a, int b) {
      const glm::vec3 way = at(skinned.positions, b) - at(skinned.positions, a);
      const float rises =
          std::max(std::abs(glm::dot(way, at(skinned.normals, a))), std::abs(glm::dot(way, at(skinned.normals, b))));
      const float length = glm::length(way);
      const float turn = glm::distance(at(rise, a), at(rise, b));
      for (const int end : {a, b}) {
        at(bulges, end) = std::max(at(bulges, end), rises);
        Surroundings& around = at(out, end);
        around = {std::max(around.longest, length), std::max(around.turn, turn), 0.0f};
      }
    });
    forEachEdge([&](int a, int b) {
      const float bulge = std::max(at(bulges, a), at(bulges, b));
      for (const int end : {a, b}) at(out, end).bulge = std::max(at(out, end).bulge, bulge);
    });
    return out;
  }

  [[nodiscard]] bool canMeet(int vertex, const AboutRay& ray, const ChangesInPose& changes) const {
    const std::span<const CarrierCandidate> candidates = next_.attached->candidates.of(vertex);
    return std::ranges::any_of(changes.influences, [&](const ChangedInfluence& changed) {
      return std::ranges::find(candidates, changed.primitive, &CarrierCandidate::primitive) != candidates.end() &&
             mayMeet(ray, changed);
    });
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
    posePrimitives(next, posed, numbers, muscles.primitives);
  }
  return out;
}

std::vector<bool> carriersToLookAt(const Preparation& next, const LevelSources& asked, const LevelSources* former) {
  const ControlMesh& mesh = next.mesh();
  const std::size_t carriers = mesh.positions.size() + mesh.edges.size() + mesh.triangles.size();
  if (!former || !sameElsewhere(*former, asked)) return std::vector<bool>(carriers, true);
  const std::vector<std::uint8_t> seen = Changes(next, *former, asked).vertices();
  std::vector<bool> out;
  out.reserve(carriers);
  const auto addCarrier = [&](std::span<const int> corners) {
    out.push_back(std::ranges::any_of(corners, [&](int v) { return at(seen, v) != 0; }));
  };
  for (const std::uint8_t vertex : seen) out.push_back(vertex != 0);
  for (const Edge& edge : mesh.edges) addCarrier(edge.vertices);
  for (const ControlTriangle& triangle : mesh.triangles) addCarrier(triangle.vertices);
  return out;
}

}  // namespace sinew
