// app/viewport/gpu/coverage.cpp: what the shaders have no code for, and their limits.
#include "app/viewport/gpu/coverage.h"

#include <algorithm>

#include "app/viewport/gpu/card_layout.h"

namespace sinew::app {
namespace {

/// What the lists of muscles exceed.
std::optional<std::string> tooMany(const CandidateLists& lists) {
  std::size_t muscles = 0, ways = 0;
  int groups = 0;
  for (std::size_t carrier = 0; carrier + 1 < lists.begin.size(); ++carrier) {
    const auto own = lists.of(static_cast<int>(carrier));
    muscles = std::max(muscles, own.size());
    for (const CarrierCandidate& one : own) groups = std::max(groups, one.slot + 1);
  }
  for (const CliqueLists& cliques : lists.cliqueSets) ways = std::max(ways, cliques.size());
  const auto most = [](const auto& number) { return " one place of the skin, at most " + std::to_string(number); };
  if (muscles > card::kMostCandidates) {
    return std::to_string(muscles) + " muscles reach" + most(card::kMostCandidates);
  }
  if (groups > card::kMostSlots) return std::to_string(groups) + " groups reach" + most(card::kMostSlots);
  if (ways > card::kMostCliques)
    return "groups blend in " + std::to_string(ways) + " ways at" + most(card::kMostCliques);
  return std::nullopt;
}

}  // namespace

std::optional<std::string> leftToProcessor(const Preparation& preparation, int bodies) {
  if (!preparation.swells() && preparation.poser->drivesMuscles()) {
    return "in replace, keys or drivers change muscles";
  }
  if (preparation.layered && preparation.layered->layers.hasCloth()) return "the character wears cloth";
  if (preparation.refined->creased) return "the surface has creases";
  if (bodies > 1 && !preparation.character().morphTargets.empty()) return "a crowd's bodies have morph targets";
  return tooMany(*preparation.seen);
}

}  // namespace sinew::app
