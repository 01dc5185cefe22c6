// app/gpu/coverage.cpp: what the shaders have no code for, and their limits.
#include "app/gpu/coverage.h"

#include <algorithm>

#include "app/gpu/card_layout.h"

namespace sinew::app {
namespace {

/// What the lists of muscles exceed.
std::optional<std::string> tooMany(const CandidateLists& lists) {
  for (std::size_t carrier = 0; carrier + 1 < lists.begin.size(); ++carrier) {
    const auto own = lists.of(static_cast<int>(carrier));
    if (own.size() > card::kMostCandidates) {
      return "more than " + std::to_string(card::kMostCandidates) + " muscles may reach one place of the skin";
    }
    if (std::ranges::any_of(own, [](const CarrierCandidate& one) { return one.slot >= card::kMostSlots; })) {
      return "muscles of more than " + std::to_string(card::kMostSlots) + " groups may reach one place of the skin";
    }
  }
  for (const CliqueLists& cliques : lists.cliqueSets) {
    if (cliques.size() > card::kMostCliques) {
      return "groups blend in more than " + std::to_string(card::kMostCliques) + " ways at one place of the skin";
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> leftToProcessor(const Preparation& preparation, int bodies) {
  if (preparation.smoothing.projection == ProjectionKind::kBisection) {
    return "roots are to be found by bisection";
  }
  if (!preparation.swells() && preparation.poser->drivesMuscles()) {
    return "in replace, keys or drivers change muscles";
  }
  if (preparation.layered && preparation.layered->layers.hasCloth()) return "the character wears cloth";
  if (preparation.refined->creased) return "the surface has creases";
  if (bodies > 1 && !preparation.character().morphTargets.empty()) return "a crowd's bodies have morph targets";
  return tooMany(*preparation.seen);
}

}  // namespace sinew::app
