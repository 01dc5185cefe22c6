// core/rig/layers.cpp: choices found by the parts' names.
#include "core/rig/layers.h"

#include <algorithm>
#include <cassert>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/geometry/at.h"
#include "core/rig/refusals.h"
#include "core/rig/validation.h"

namespace sinew {
namespace {

constexpr std::size_t kMostLayers = 65536;

}  // namespace

const char* nameOf(SkinLayer layer) {
  switch (layer) {
    case SkinLayer::kCloth:
      return "cloth";
    case SkinLayer::kRigid:
      return "rigid";
    case SkinLayer::kSkin:
      break;
  }
  return "skin";
}

std::optional<SkinLayer> skinLayerNamed(const std::string& name) {
  for (const SkinLayer layer : {SkinLayer::kSkin, SkinLayer::kCloth, SkinLayer::kRigid}) {
    if (name == nameOf(layer)) return layer;
  }
  return std::nullopt;
}

int findLayer(const Rig& rig, const std::string& part) {
  const auto found = std::ranges::find(rig.layers, part, &LayerChoice::part);
  return found == rig.layers.end() ? -1 : static_cast<int>(found - rig.layers.begin());
}

std::vector<SkinLayer> layersOf(const Rig& rig, const Character& character, std::span<const SkinLayer> guessed) {
  assert(guessed.size() == character.parts.size());
  std::vector<SkinLayer> layers(guessed.begin(), guessed.end());
  if (rig.layers.empty()) return layers;
  std::unordered_map<std::string, SkinLayer> chosen;
  for (const LayerChoice& choice : rig.layers) chosen.emplace(choice.part, choice.layer);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (const auto found = chosen.find(character.parts[i].name); found != chosen.end()) layers[i] = found->second;
  }
  return layers;
}

Result<Rig> setLayer(Rig rig, const std::string& part, std::optional<SkinLayer> layer) {
  const int index = findLayer(rig, part);
  if (!layer) {
    if (index >= 0) rig.layers.erase(rig.layers.begin() + index);
    return rig;
  }
  if (index >= 0) at(rig.layers, index).layer = *layer;
  else rig.layers.push_back({part, *layer});
  if (auto valid = validateLayers(rig); !valid) return valid.error();
  return rig;
}

Rig withoutLayers(Rig rig) {
  rig.layers.clear();
  return rig;
}

Result<void> validateLayers(const Rig& rig) {
  if (rig.layers.size() > kMostLayers) {
    return errorAt(
        "layers",
        "expected at most " + std::to_string(kMostLayers) + " parts, got " + std::to_string(rig.layers.size()),
        "the rig");
  }
  std::unordered_set<std::string> known;
  for (const LayerChoice& choice : rig.layers) {
    const std::string place = "layers." + choice.part;
    if (auto name = validateName(choice.part, place); !name) return about("layers", name.error());
    if (!known.insert(choice.part).second) {
      return errorAt(place, "expected each part once, but \"" + choice.part + "\" is there twice", "layers");
    }
  }
  return {};
}

std::vector<std::string> missingParts(const Rig& rig, const Character& character) {
  std::vector<std::string> missing;
  for (const LayerChoice& choice : rig.layers) {
    const bool known = std::ranges::find(character.parts, choice.part, &MeshPart::name) != character.parts.end();
    if (!known) missing.push_back(choice.part);
  }
  return missing;
}

}  // namespace sinew
