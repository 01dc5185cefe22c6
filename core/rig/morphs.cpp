// core/rig/morphs.cpp: finds entries of morph weights by name.
#include "core/rig/morphs.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "core/geometry/at.h"
#include "core/rig/validation.h"

namespace sinew {
namespace {

constexpr std::size_t kMostMorphs = 1024;

Result<void> validateWeight(float weight, const std::string& place) {
  if (weight >= kLeastMorphWeight && weight <= kMostMorphWeight) return {};
  return outOfRange(place, "a number from -10 to 10", weight, "weight");
}

}  // namespace

std::vector<std::string> morphNames(const Character& character) {
  std::vector<std::string> names;
  std::unordered_set<std::string> known;
  for (const MorphSet& set : character.morphSets) {
    if (known.insert(set.name).second) names.push_back(set.name);
  }
  for (const MorphTarget& target : character.morphTargets) {
    if (known.insert(target.name).second) names.push_back(target.name);
  }
  return names;
}

bool isIdle(const MorphWeight& morph) {
  return morph.weight == 0.0f && morph.animated.empty() && morph.unknownKeys.empty();
}

Rig withMorphsOf(Rig rig, const Character& character, KeepIdle idle) {
  const std::vector<std::string> names = morphNames(character);
  if (std::ranges::equal(rig.morphs, names, {}, &MorphWeight::name)) return rig;
  std::vector<MorphWeight> morphs;
  for (const std::string& name : names) {
    const int index = findMorph(rig, name);
    if (index < 0) morphs.push_back({.name = name, .weight = 0.0f, .animated = {}, .unknownKeys = {}});
    else morphs.push_back(std::exchange(at(rig.morphs, index), {}));
  }
  for (MorphWeight& other : rig.morphs) {
    const bool stays = idle == KeepIdle::kYes || !isIdle(other);
    if (!other.name.empty() && stays) morphs.push_back(std::move(other));
  }
  rig.morphs = std::move(morphs);
  return rig;
}

Result<Rig> setMorphWeight(Rig rig, const std::string& name, float weight) {
  int index = findMorph(rig, name);
  if (index < 0) {
    index = static_cast<int>(rig.morphs.size());
    rig.morphs.push_back({.name = name, .weight = 0.0f, .animated = {}, .unknownKeys = {}});
  }
  const std::string place = indexed("shapes", static_cast<std::size_t>(index));
  if (auto valid = validateWeight(weight, place + ".weight"); !valid)
    return about(quoted("shape", name), valid.error());
  at(rig.morphs, index).weight = weight;
  return rig;
}

Rig withoutMorphWeights(Rig rig) {
  for (MorphWeight& morph : rig.morphs) morph.weight = 0.0f;
  return rig;
}

Result<void> validateMorphs(const Rig& rig) {
  const auto used = rig.morphs.size() - static_cast<std::size_t>(std::ranges::count_if(rig.morphs, isIdle));
  if (auto count = validateCount("shapes", "shapes", used, kMostMorphs); !count) return count;
  std::unordered_set<std::string> known;
  for (std::size_t i = 0; i < rig.morphs.size(); ++i) {
    const MorphWeight& morph = rig.morphs[i];
    const std::string place = indexed("shapes", i);
    const std::string subject = quoted("shape", morph.name);
    if (auto name = validateName(morph.name, place + ".name"); !name) return about("a shape", name.error());
    if (!known.insert(morph.name).second) {
      return errorAt(place + ".name", "expected each shape once, but \"" + morph.name + "\" is there twice", subject);
    }
    if (auto weight = validateWeight(morph.weight, place + ".weight"); !weight) return about(subject, weight.error());
    if (auto animated = validateAnimated(morph.animated, ParameterOwner::kMorph, place); !animated) {
      return about(subject, animated.error());
    }
  }
  return {};
}

}  // namespace sinew
