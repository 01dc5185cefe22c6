// core/bodies/own_skin.cpp: weights of one bone, corner by corner.
#include "core/bodies/own_skin.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

#include "core/character/bindings.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_on_triangle.h"

namespace sinew {
namespace {

constexpr float kHalf = 0.5f;  ///< Of the most that any triangle has.
constexpr float kFirm = 0.9f;
constexpr float kLeastCarried = 0.05f;  ///< Less follows the bone hardly.

float shareOf(const Character& character, int vertex, int bone) {
  float own = 0.0f;
  float all = 0.0f;
  for (const WeightedBinding& follows : bindingsOf(character, vertex)) {
    all += follows.weight;
    if (follows.bone() == bone) own += follows.weight;
  }
  return all > 0.0f ? own / all : 0.0f;
}

}  // namespace

OwnSkin::OwnSkin(const Character& character, int bone) : character_(character), bone_(bone) {
  const ControlMesh& mesh = character.mesh;
  std::vector<float> shares(mesh.positions.size());
  for (std::size_t v = 0; v < shares.size(); ++v) shares[v] = shareOf(character, static_cast<int>(v), bone);
  const Pose bind = bindPose(character.skeleton);
  float most = 0.0f;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const auto& corners = at(mesh.triangles, t).vertices;
    const float weight = std::min({at(shares, corners[0]), at(shares, corners[1]), at(shares, corners[2])});
    if (weight < kLeastCarried) continue;
    const auto frame = frameAt(character, {t, glm::vec3(1.0f / 3.0f)}, bind);
    if (!frame) continue;
    half_.push_back({t, *frame, weight});
    most = std::max(most, weight);
  }
  std::erase_if(half_, [&](const OwnTriangle& own) { return own.weight < kHalf * most; });
  for (const OwnTriangle& own : half_) {
    if (own.weight < kFirm * most) continue;
    firm_.push_back(own);
    middle_ += own.frame.origin;
  }
  if (!firm_.empty()) middle_ /= static_cast<float>(firm_.size());
}

std::optional<SkinFrame> OwnSkin::nearest(const glm::vec3& point) const {
  std::optional<SkinFrame> best;
  float least = std::numeric_limits<float>::max();
  for (const OwnTriangle& own : half_) {
    const auto& corners = at(character_.mesh.triangles, own.triangle).vertices;
    const auto corner = [&](std::size_t i) { return at(character_.mesh.positions, corners[i]); };
    const TriangleCorners places{corner(0), corner(1), corner(2)};
    const glm::vec3 place = mixed(places, nearestOnTriangle(point, places));
    const glm::vec3 off = point - place;
    if (glm::dot(off, off) >= least) continue;
    least = glm::dot(off, off);
    best = SkinFrame{place, own.frame.axes};
  }
  return best;
}

}  // namespace sinew
