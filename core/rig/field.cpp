// core/rig/field.cpp: sums and maxima of potentials.
#include "core/rig/field.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/potential.h"

namespace sinew {

namespace {

/// Value and gradient of one candidate, weight and sign included.
FieldSample sampleCandidate(const PosedPrimitive& primitive, float weight, const glm::vec3& point) {
  const UnitBallMap& ball = primitive.influence;
  const float rSquared = ball.rSquared(point);
  if (!(rSquared < 1.0f) || ball.boundingRadius == 0.0f) return {};
  const float factor = primitive.strength * weight;
  return {factor * potential(rSquared), factor * potentialSlope(rSquared) * ball.rSquaredSlope(point)};
}

void add(FieldSample& sum, const FieldSample& part) {
  sum.value += part.value;
  sum.gradient += part.gradient;
}

/// The highest sum above 0, with a mean of the gradients if another one ties with it.
FieldSample highest(std::span<const FieldSample> sums) {
  FieldSample best;
  for (const FieldSample& sum : sums) {
    if (sum.value > best.value) best = sum;
  }
  FieldSample other;  // `value`: kTie minus the difference.
  float most = 0.0f;
  for (const FieldSample& sum : sums) {
    const float near = std::min(kTie - (best.value - sum.value), sum.value);
    if (!(near > 0.0f)) continue;
    const glm::vec3 apart = sum.gradient - best.gradient;
    const float pull = near * near * glm::dot(apart, apart);
    if (!(pull > most)) continue;
    most = pull;
    other = {near, sum.gradient};
  }
  const float share = other.value / kTie;
  best.gradient = (best.gradient + share * other.gradient) / (1.0f + share);
  return best;
}

}  // namespace

PosedPrimitive posedPrimitive(const FieldPrimitive& primitive, const glm::mat4& carrier, float grooves) {
  const UnitBallMap influence = unitBallMap(primitive.placement, primitive.reach, carrier);
  const float radius = influence.meanRadius / primitive.reach;
  const float groove = grooves > 0.0f && radius > 0.0f ? in_float::grooveOf(grooves, radius, primitive.reach) : 0.0f;
  return {influence, primitive.strength, radius, groove};
}

void poseField(std::span<const FieldPrimitive> primitives, std::span<const glm::mat4> boneInWorld, float grooves,
               std::vector<PosedPrimitive>& out) {
  out.resize(primitives.size());
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    out[i] = posedPrimitive(primitives[i], at(boneInWorld, primitives[i].bone), grooves);
  }
}

namespace {

/// The highest sum of a clique, with its gradient.
FieldSample highest(const CliqueLists& cliques, FieldScratch& scratch) {
  scratch.ofClique.assign(cliques.size(), {});
  for (std::size_t k = 0; k < cliques.size(); ++k) {
    for (const int slot : cliques[k]) {
      if (static_cast<std::size_t>(slot) < scratch.ofSlot.size()) add(scratch.ofClique[k], at(scratch.ofSlot, slot));
    }
  }
  return highest(scratch.ofClique);
}

/// F's maximum over shares of the cliques, with its gradient.
FieldSample softest(const CliqueLists& cliques, FieldScratch& scratch) {
  const std::vector<FieldSample>& sums = scratch.ofSlot;
  scratch.softness.resize(sums.size());
  std::vector<BlendedGroup>& groups = scratch.blend.start(cliques);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    groups[i].sum = static_cast<double>(sums[i].value);
    groups[i].softness = static_cast<double>(scratch.softness[i].value);
  }
  FieldSample out;
  out.value = static_cast<float>(scratch.blend.settle());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const float m = static_cast<float>(groups[i].share);
    out.gradient += m * (sums[i].gradient + 0.5f * (1.0f - m) * scratch.softness[i].gradient);
  }
  return out;
}

}  // namespace

FieldSample sampleField(std::span<const PosedPrimitive> primitives, std::span<const Candidate> candidates,
                        CliqueLevelsView levels, const glm::vec3& point, FieldScratch& scratch) {
  FieldSample carved;
  FieldSample linked;
  std::vector<FieldSample>& ofSlot = scratch.ofSlot;
  std::vector<FieldSample>& softness = scratch.softness;
  ofSlot.clear();
  softness.clear();
  for (const Candidate& candidate : candidates) {
    const PosedPrimitive& primitive = at(primitives, candidate.primitive);
    const FieldSample part = sampleCandidate(primitive, candidate.weight, point);
    if (primitive.strength < 0.0f) {
      add(carved, part);
    } else if (levels.empty()) {
      add(linked, part);
    } else {
      const auto slot = static_cast<std::size_t>(candidate.slot);
      if (ofSlot.size() <= slot) ofSlot.resize(slot + 1);
      add(ofSlot[slot], part);
      if (!(primitive.groove > 0.0f)) continue;
      if (softness.size() <= slot) softness.resize(slot + 1);
      add(softness[slot], {primitive.groove * part.value, primitive.groove * part.gradient});
    }
  }
  FieldSample out = linked;
  for (const CliqueLevel& level : levels) {
    const FieldSample part = softness.empty() ? highest(level.cliques, scratch) : softest(level.cliques, scratch);
    const float weight = static_cast<float>(level.weight);
    add(out, {weight * part.value, weight * part.gradient});
  }
  add(out, carved);
  return out;
}

FieldSample sampleField(std::span<const PosedPrimitive> primitives, std::span<const Candidate> candidates,
                        CliqueLevelsView levels, const glm::vec3& point) {
  FieldScratch scratch;
  return sampleField(primitives, candidates, levels, point, scratch);
}

void fieldShares(std::span<const PosedPrimitive> primitives, std::span<const Candidate> candidates,
                 CliqueLevelsView levels, const glm::vec3& point, FieldScratch& scratch, std::vector<float>& out) {
  out.assign(candidates.size(), levels.empty() ? 1.0f : 0.0f);
  if (levels.empty()) return;
  (void)sampleField(primitives, candidates, levels, point, scratch);  // Leaves the sums of the slots.
  const bool soft = !scratch.softness.empty();
  std::vector<float> ofSlot;
  for (const CliqueLevel& level : levels) {
    ofSlot.assign(scratch.ofSlot.size(), 0.0f);
    if (soft) {
      (void)softest(level.cliques, scratch);
      for (std::size_t i = 0; i < ofSlot.size(); ++i) ofSlot[i] = static_cast<float>(scratch.blend.groups()[i].share);
    } else {
      (void)highest(level.cliques, scratch);
      const auto& sums = scratch.ofClique;
      const auto best = std::ranges::max_element(sums, {}, &FieldSample::value) - sums.begin();
      if (sums.empty()) continue;
      for (const int slot : level.cliques[static_cast<std::size_t>(best)]) {
        if (static_cast<std::size_t>(slot) < ofSlot.size()) at(ofSlot, slot) = 1.0f;
      }
    }
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (static_cast<std::size_t>(candidates[i].slot) >= ofSlot.size()) continue;
      const float m = at(ofSlot, candidates[i].slot);
      const float groove = soft ? at(primitives, candidates[i].primitive).groove : 0.0f;
      out[i] += static_cast<float>(level.weight) * m * (1.0f + 0.5f * groove * (1.0f - m));
    }
  }
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (at(primitives, candidates[i].primitive).strength < 0.0f) out[i] = 1.0f;
  }
}

}  // namespace sinew
