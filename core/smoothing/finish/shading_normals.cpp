// core/smoothing/finish/shading_normals.cpp: the field's normals, held to those of the faces, without teeth.
#include "core/smoothing/finish/shading_normals.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/at.h"
#include "core/base/smoothstep.h"

namespace sinew {
namespace {

constexpr float kFreedom = 0.145f;  ///< About 8 degrees.
constexpr float kTeeth = 0.23f;     ///< Largest weight of the second step.
// Difference between neighbours' deltas from which the second step works, from which it works whole, and where it ends.
constexpr float kTeethFrom = 0.22f;
constexpr float kTeethWhole = 0.45f;
constexpr float kCliffFrom = 0.45f;
constexpr float kCliffWhole = 0.8f;
constexpr float kRotationFrom = -0.95f;  ///< Cosine between face normals from which a rotation between them counts.
constexpr float kRotationWhole = -0.7f;
constexpr float kTurnedWhole = 0.1f;  ///< Turn of a vertex from which the second step works whole.

float filteredAt(std::span<const float> filtered, std::size_t v) { return filtered.empty() ? 0.0f : filtered[v]; }

/// Unit, where the length is that of a sum of a few weighted unit vectors; `fallback` where they cancel.
glm::vec3 unitOr(const glm::vec3& sum, const glm::vec3& fallback) {
  const float squared = glm::dot(sum, sum);
  return squared > 1e-12f ? sum / std::sqrt(squared) : fallback;
}

/// What the least rotation that takes `from` to `to`, both unit, adds to v. Opposite ones have no such rotation:
/// towards them it goes over into their plain difference.
glm::vec3 turnOf(const glm::vec3& v, const glm::vec3& from, const glm::vec3& to) {
  const float cosine = glm::dot(from, to);
  const float share = smoothstep(kRotationFrom, kRotationWhole, cosine);
  if (share == 0.0f) return to - from;
  const glm::vec3 axis = glm::cross(from, to);
  const glm::vec3 across = glm::cross(axis, v);
  const glm::vec3 turn = across + glm::cross(axis, across) / (1.0f + cosine);
  return share == 1.0f ? turn : share * turn + (1.0f - share) * (to - from);
}

/// acos to 7e-5, for -1 <= x <= 1 (Abramowitz & Stegun 4.4.45): a weight needs no more.
float roughAcos(float x) {
  const float positive = std::min(std::abs(x), 1.0f);
  const float polynomial = 1.5707288f + positive * (-0.2121144f + positive * (0.0742610f - positive * 0.0187293f));
  const float angle = std::sqrt(1.0f - positive) * polynomial;
  return x < 0.0f ? 3.14159265f - angle : angle;
}

/// A refined triangle as its corners see it: its normal times the angle at each.
struct CornerNormals {
  glm::vec3 face{0.0f};  ///< Twice the area, along the normal.
  float a = 0.0f;        ///< Factors of `face`.
  float b = 0.0f;
  float c = 0.0f;
};

CornerNormals cornerNormals(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::vec3 ab = b - a;
  const glm::vec3 bc = c - b;
  const glm::vec3 ca = a - c;
  CornerNormals out{glm::cross(ab, bc)};
  const float area = std::sqrt(glm::dot(out.face, out.face));
  if (!(area > 0.0f)) return {};
  const float perArea = 1.0f / area;
  const float perAb = 1.0f / std::sqrt(glm::dot(ab, ab));
  const float perBc = 1.0f / std::sqrt(glm::dot(bc, bc));
  const float perCa = 1.0f / std::sqrt(glm::dot(ca, ca));
  const auto factor = [perArea](float cosine) { return perArea * roughAcos(cosine); };
  out.a = factor(-glm::dot(ab, ca) * perAb * perCa);
  out.b = factor(-glm::dot(bc, ab) * perBc * perAb);
  out.c = factor(-glm::dot(ca, bc) * perCa * perBc);
  return out;
}

}  // namespace

void ShadingNormals::sumFaces(const Refinement& refinement, const MovedTriangles& moved,
                              std::span<const glm::vec3> patch, std::span<const glm::vec3> positions) {
  faces_.resize(patch.size());
  for (const int v : moved.corners) at(faces_, v) = {};
  for (const int triangle : moved.refined) {
    const std::array<int, 3>& t = at(refinement.triangles, triangle);
    const auto a = static_cast<std::size_t>(t[0]);
    const auto b = static_cast<std::size_t>(t[1]);
    const auto c = static_cast<std::size_t>(t[2]);
    const CornerNormals flat = cornerNormals(patch[a], patch[b], patch[c]);
    const bool still = positions[a] == patch[a] && positions[b] == patch[b] && positions[c] == patch[c];
    const CornerNormals lifted = still ? flat : cornerNormals(positions[a], positions[b], positions[c]);
    faces_[a].patch += flat.a * flat.face;
    faces_[b].patch += flat.b * flat.face;
    faces_[c].patch += flat.c * flat.face;
    faces_[a].surface += lifted.a * lifted.face;
    faces_[b].surface += lifted.b * lifted.face;
    faces_[c].surface += lifted.c * lifted.face;
  }
}

void ShadingNormals::holdToFaces(const MovedTriangles& moved, std::span<const glm::vec3> patchNormals,
                                 std::span<const float> filtered, std::span<const glm::vec3> normals) {
  deltas_.resize(normals.size());
  isTurned_.resize(normals.size());
  turn_.resize(normals.size());
  for (const int vertex : moved.corners) {
    const auto v = static_cast<std::size_t>(vertex);
    const glm::vec3& own = patchNormals[v];
    glm::vec3& delta = deltas_[v];
    delta = normals[v] - own;
    turn_[v] = glm::dot(delta, delta);
    if (moved.isNear[v]) {
      const glm::vec3 shown = turnOf(own, unitOr(faces_[v].patch, own), unitOr(faces_[v].surface, own));
      turn_[v] = std::max(turn_[v], glm::dot(shown, shown));
      const glm::vec3 beyond = delta - shown;
      const float squared = glm::dot(beyond, beyond);
      const float freedom = kFreedom * (1.0f - filteredAt(filtered, v));
      if (squared > freedom * freedom) delta = shown + (freedom / std::sqrt(squared)) * beyond;
    }
    // Two deltas of less than half the difference that counts cannot be that far apart.
    isTurned_[v] = glm::dot(delta, delta) > 0.25f * kTeethFrom * kTeethFrom ? 1 : 0;
  }
}

bool ShadingNormals::findTeeth(const Refinement& refinement, const MovedTriangles& moved) {
  spread_.resize(deltas_.size());
  for (const int v : moved.corners) at(spread_, v) = 0.0f;
  bool found = false;
  for (const int triangle : moved.refined) {
    const std::array<int, 3>& t = at(refinement.triangles, triangle);
    const auto a = static_cast<std::size_t>(t[0]);
    const auto b = static_cast<std::size_t>(t[1]);
    const auto c = static_cast<std::size_t>(t[2]);
    if ((isTurned_[a] | isTurned_[b] | isTurned_[c]) == 0) continue;
    const auto compare = [&](std::size_t v, std::size_t w) {
      const glm::vec3 apart = deltas_[v] - deltas_[w];
      const float squared = glm::dot(apart, apart);
      if (squared <= kTeethFrom * kTeethFrom) return;
      spread_[v] = std::max(spread_[v], squared);
      spread_[w] = std::max(spread_[w], squared);
      found = true;
    };
    compare(a, b);
    compare(b, c);
    compare(c, a);
  }
  return found;
}

void ShadingNormals::gatherAroundTeeth(const Refinement& refinement, const MovedTriangles& moved) {
  nearTeeth_.resize(deltas_.size());
  for (const int v : moved.corners) at(nearTeeth_, v) = 0;
  const auto any = [](const auto& flags, const std::array<int, 3>& t) {
    return at(flags, t[0]) > 0 || at(flags, t[1]) > 0 || at(flags, t[2]) > 0;
  };
  for (const int triangle : moved.refined) {
    const std::array<int, 3>& t = at(refinement.triangles, triangle);
    if (!any(spread_, t)) continue;
    for (const int v : t) at(nearTeeth_, v) = 1;
  }
  aroundTeeth_.clear();
  for (const int triangle : moved.refined) {
    if (any(nearTeeth_, at(refinement.triangles, triangle))) aroundTeeth_.push_back(triangle);
  }
}

void ShadingNormals::laplacianOf(const std::vector<glm::vec3>& values, const Refinement& refinement,
                                 const MovedTriangles& moved, std::vector<glm::vec3>& out) const {
  out.resize(values.size());
  for (const int v : moved.corners) at(out, v) = glm::vec3(0.0f);
  for (const int triangle : aroundTeeth_) {
    const std::array<int, 3>& t = at(refinement.triangles, triangle);
    const auto a = static_cast<std::size_t>(t[0]);
    const auto b = static_cast<std::size_t>(t[1]);
    const auto c = static_cast<std::size_t>(t[2]);
    out[a] += values[b] + values[c];
    out[b] += values[c] + values[a];
    out[c] += values[a] + values[b];
  }
  for (const int vertex : moved.corners) {
    const auto v = static_cast<std::size_t>(vertex);
    if (nearTeeth_[v]) out[v] = out[v] / static_cast<float>(2 * refinement.trianglesAt[v]) - values[v];
    else out[v] = glm::vec3(0.0f);
  }
}

void ShadingNormals::removeTeeth(const Refinement& refinement, const MovedTriangles& moved,
                                 std::span<const float> filtered) {
  if (!findTeeth(refinement, moved)) return;
  gatherAroundTeeth(refinement, moved);
  laplacianOf(deltas_, refinement, moved, first_);
  laplacianOf(first_, refinement, moved, second_);
  for (const int vertex : moved.corners) {
    const auto v = static_cast<std::size_t>(vertex);
    if (spread_[v] == 0.0f) continue;
    const float apart = std::sqrt(spread_[v]);
    // Only where something has turned; from there on continuously.
    const float weight = kTeeth * smoothstep(kTeethFrom, kTeethWhole, apart) *
                         (1.0f - (1.0f - filteredAt(filtered, v)) * smoothstep(kCliffFrom, kCliffWhole, apart)) *
                         smoothstep(0.0f, kTurnedWhole, std::sqrt(turn_[v]));
    deltas_[v] -= weight * second_[v];
  }
}

void ShadingNormals::apply(const Refinement& refinement, const MovedTriangles& moved, std::span<const glm::vec3> patch,
                           std::span<const glm::vec3> positions, std::span<const glm::vec3> patchNormals,
                           std::span<const float> filtered, std::span<glm::vec3> normals) {
  sumFaces(refinement, moved, patch, positions);
  holdToFaces(moved, patchNormals, filtered, normals);
  removeTeeth(refinement, moved, filtered);
  for (const int vertex : moved.corners) {
    const auto v = static_cast<std::size_t>(vertex);
    if (deltas_[v] == normals[v] - patchNormals[v]) continue;
    normals[v] = unitOr(patchNormals[v] + deltas_[v], normals[v]);
  }
}

}  // namespace sinew
