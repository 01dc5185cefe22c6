// app/command/inspect_facts.cpp: counting what a document holds.
#include "app/command/inspect_facts.h"

#include <algorithm>

#include "core/character/bindings.h"
#include "core/geometry/creases.h"
#include "core/geometry/weld.h"
#include "core/rig/mesh_layers.h"
#include "core/rig/morphs.h"
#include "core/rig/motion_clip.h"

namespace sinew::app {
namespace {

MeshFacts meshFacts(const Character& character) {
  MeshFacts facts;
  facts.tolerance = 1e-6f * character.height;
  facts.bound = topologyOf(character.mesh);
  facts.joined = joinedByPosition(character.mesh, facts.tolerance);
  facts.touching = topologyOf(facts.joined);
  facts.coloredWedges = static_cast<std::size_t>(
      std::ranges::count_if(character.mesh.wedges, [](const Wedge& wedge) { return wedge.color != glm::vec4(1.0f); }));
  return facts;
}

std::vector<std::string> helperNames(const Character& character) {
  const std::vector<bool> helpers = helperBones(character);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < helpers.size(); ++i) {
    if (helpers[i]) names.push_back(character.skeleton.bones[i].name);
  }
  return names;
}

void count(const std::vector<AnimatedNumber>& animated, RigFacts& facts) {
  for (const AnimatedNumber& number : animated) {
    if (!number.keys.empty()) ++facts.keyed;
    for (const KeyTrack& track : number.keys) facts.keys += track.curve.points.size();
    facts.drivers += number.drivers.size();
  }
}

RigFacts rigFacts(const Document& document) {
  const Rig& rig = document.rig();
  const Character& character = *document.character;
  const std::vector<std::string> shapes = morphNames(character);
  RigFacts facts;
  count(rig.surface.animated, facts);
  for (const MuscleLine& line : rig.lines) {
    facts.lines.push_back(line.name);
    count(line.animated, facts);
  }
  for (const Primitive& primitive : rig.primitives) {
    if (!character.skeleton.findBone(primitive.bone)) facts.unattached.push_back(primitive.name);
    if (!primitive.placement.shape.isPlain()) ++facts.shaped;
    count(primitive.animated, facts);
  }
  for (const RigChannel& channel : rig.channels) {
    if (std::ranges::find(facts.channels, channel.name) == facts.channels.end()) facts.channels.push_back(channel.name);
  }
  for (const MorphWeight& morph : rig.morphs) {
    count(morph.animated, facts);
    if (!isIdle(morph) && std::ranges::count(shapes, morph.name) == 0) facts.missingShapes.push_back(morph.name);
  }
  facts.missingParts = missingParts(rig, character);
  facts.missing = missingBones(rig, character.skeleton);
  facts.shadedWedges = creased(character.mesh, rig.smoothing.creaseAngle).wedges;
  return facts;
}

}  // namespace

InspectFacts factsOf(const Document& document) {
  const Character& character = *document.character;
  InspectFacts facts{document, meshFacts(character), helperNames(character), morphNames(character), 0.0f, {}};
  facts.body = bodySlots(character, makeMirrorPlan(character), document.rig().slots);
  facts.layers = layersOf(document.rig(), character, guessLayers(character));
  for (const MeshPart& part : character.parts) facts.isGuessed.push_back(findLayer(document.rig(), part.name) < 0);
  const AnimationClip motion = rangeOfMotion(character.skeleton, motionHints(character));
  if (!motion.channels.empty()) facts.rangeOfMotion = motion.duration;
  if (facts.hasRig()) facts.rig = rigFacts(document);
  return facts;
}

}  // namespace sinew::app
