// core/rig/attachment.cpp: resolves names to indices, and territories to weights of control vertices.
#include "core/rig/attachment.h"

#include <algorithm>

#include "core/character/bindings.h"
#include "core/character/bone_segments.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"
#include "core/geometry/potential.h"

namespace sinew {
namespace {

Result<const BlendingGraph*> graphOf(const Rig& rig, BlendingGraphMemo& graphs) {
  std::vector<GroupLink> links;
  for (const Link& link : rig.links) {
    const auto& [a, b] = link.groups;
    links.push_back({findGroup(rig, a), findGroup(rig, b), link.amount, !link.animated.empty()});
  }
  return graphs.graph(static_cast<int>(rig.groups.size()), links);
}

void setNumbers(const MuscleNumbers& numbers, float iso, FieldPrimitive& field) {
  field.placement = numbers.placement;
  field.reach = numbers.reach;
  field.strength = static_cast<float>(field.sign) * numbers.amount * strengthFor(iso, numbers.reach);
}

FieldPrimitive fieldPrimitive(const Rig& rig, const Primitive& primitive, int bone) {
  FieldPrimitive field;
  field.bone = bone;
  field.sign = primitive.sign;
  field.group = findGroup(rig, primitive.group);
  setNumbers({primitive.placement, primitive.reach, primitive.amount}, rig.surface.iso, field);
  return field;
}

/// Adds the bone, its parent and its children.
void addAround(int bone, const Skeleton& skeleton, std::vector<int>& bones) {
  const Bone& own = at(skeleton.bones, bone);
  bones.insert(bones.end(), own.children.begin(), own.children.end());
  bones.push_back(bone);
  if (own.parent >= 0) bones.push_back(own.parent);
}

void addAlong(const MuscleLine& line, const Skeleton& skeleton, std::vector<int>& bones) {
  const std::optional<int> origin = skeleton.findBone(line.origin.bone);
  const std::optional<int> insertion = skeleton.findBone(line.insertion.bone);
  if (!origin || !insertion) return;
  addAround(*origin, skeleton, bones);
  addAround(*insertion, skeleton, bones);
  const std::vector<int> between = bonesBetween(skeleton, *origin, *insertion);
  bones.insert(bones.end(), between.begin(), between.end());
}

template <class Check>
void checkLineBones(const MuscleLine& line, const std::string& place, Check check) {
  const std::string subject = "muscle line \"" + line.name + '"';
  check(line.origin.bone, place + ".origin.bone", subject + ", origin");
  check(line.insertion.bone, place + ".insertion.bone", subject + ", insertion");
  if (line.via) check(line.via->bone, place + ".via.bone", subject + ", via point");
}

template <class Check>
void checkEdgeBones(const MuscleSheet& sheet, const std::string& place, Check check) {
  for (std::size_t e = 0; e < sheet.edges.size(); ++e) {
    const std::string edge = place + ".edges[" + std::to_string(e) + "]";
    const std::vector<LineAnchor>& points = sheet.edges[e].points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      check(points[p].bone, edge + ".points[" + std::to_string(p) + "].bone", "sheet \"" + sheet.name + "\", edge");
    }
  }
}

template <class Check>
void checkDriverBones(const std::vector<AnimatedNumber>& animated, const std::string& place, const std::string& subject,
                      Check check) {
  for (std::size_t i = 0; i < animated.size(); ++i) {
    for (std::size_t d = 0; d < animated[i].drivers.size(); ++d) {
      const DriverInput& input = animated[i].drivers[d].input;
      const std::string own = place + ".animated[" + std::to_string(i) + "].drivers[" + std::to_string(d) + "].input";
      const std::string words = subject + ", driver of " + wordsFor(animated[i].parameter);
      if (input.kind == DriverInputKind::kDistance) {
        check(input.from.bone, own + ".from.bone", words);
        check(input.to.bone, own + ".to.bone", words);
      } else if (input.kind <= DriverInputKind::kPose) {
        check(input.bone, own + ".bone", words);
      }
    }
  }
}

/// Appends primitive `index` to the vertices in its territory.
void addCandidates(const Character& character, const std::vector<int>& territory, int index,
                   std::vector<std::vector<Candidate>>& candidatesOfVertex) {
  std::vector<bool> isTerritoryBone(character.skeleton.bones.size(), false);
  for (const int bone : territory) at(isTerritoryBone, bone) = true;
  for (std::size_t v = 0; v < candidatesOfVertex.size(); ++v) {
    const float weight = territoryWeight(character, static_cast<int>(v), isTerritoryBone);
    if (weight > 0.0f) candidatesOfVertex[v].push_back({index, weight, 0});
  }
}

}  // namespace

std::vector<MissingBone> missingBones(const Rig& rig, const Skeleton& skeleton) {
  std::vector<MissingBone> missing;
  const auto check = [&](const std::string& bone, const std::string& place, const std::string& subject) {
    if (skeleton.findBone(bone)) return;
    missing.push_back({errorAt(place, "this character has no bone \"" + bone + '"', subject), bone});
  };
  checkDriverBones(rig.surface.animated, "surface", "surface", check);
  for (std::size_t i = 0; i < rig.lines.size(); ++i) {
    const MuscleLine& line = rig.lines[i];
    const std::string place = "lines[" + std::to_string(i) + "]";
    checkLineBones(line, place, check);
    checkDriverBones(line.animated, place, "muscle line \"" + line.name + '"', check);
  }
  for (std::size_t i = 0; i < rig.sheets.size(); ++i) {
    checkEdgeBones(rig.sheets[i], "sheets[" + std::to_string(i) + "]", check);
  }
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const Primitive& primitive = rig.primitives[i];
    const std::string place = "primitives[" + std::to_string(i) + "]";
    const std::string subject = "muscle \"" + primitive.name + '"';
    check(primitive.bone, place + ".bone", subject);
    checkDriverBones(primitive.animated, place, subject, check);
    if (!primitive.territory) continue;
    for (std::size_t t = 0; t < primitive.territory->size(); ++t) {
      check((*primitive.territory)[t], place + ".territory[" + std::to_string(t) + "]", subject + ", territory");
    }
  }
  for (std::size_t i = 0; i < rig.morphs.size(); ++i) {
    const MorphWeight& morph = rig.morphs[i];
    checkDriverBones(morph.animated, "shapes[" + std::to_string(i) + "]", "shape \"" + morph.name + '"', check);
  }
  for (std::size_t i = 0; i < rig.links.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    checkDriverBones(rig.links[i].animated, "links[" + std::to_string(i) + "]", "link " + number, check);
  }
  return missing;
}

Error refusalOf(const MissingBone& missing, const Skeleton& skeleton) {
  std::vector<std::string> names;
  for (std::size_t bone = 0; bone < skeleton.bones.size(); ++bone) {
    names.push_back(skeleton.fileName(static_cast<int>(bone)));
  }
  Error error = missing;
  error.reason += didYouMean(missing.bone, names);
  return error;
}

bool hasBones(const MuscleLine& line, const Skeleton& skeleton) {
  return skeleton.findBone(line.origin.bone) && skeleton.findBone(line.insertion.bone) &&
         (!line.via || skeleton.findBone(line.via->bone));
}

std::vector<int> territoryBones(const Primitive& primitive, int bone, const MuscleLine* line,
                                const Skeleton& skeleton) {
  std::vector<int> bones;
  if (primitive.territory) {
    for (const std::string& name : *primitive.territory) {
      if (const std::optional<int> found = skeleton.findBone(name)) bones.push_back(*found);
    }
  } else {
    addAround(bone, skeleton, bones);
    if (line) addAlong(*line, skeleton, bones);
  }
  std::ranges::sort(bones);
  bones.erase(std::unique(bones.begin(), bones.end()), bones.end());
  return bones;
}

float territoryWeight(const Character& character, int vertex, const std::vector<bool>& isTerritoryBone) {
  float sum = 0.0f;
  for (const WeightedBinding& follows : bindingsOf(character, vertex)) {
    if (at(isTerritoryBone, follows.bone())) sum += follows.weight;
  }
  return smoothstep(0.0f, 0.5f, sum);
}

bool samePlaces(const Rig& a, const Rig& b) {
  const auto sameGroup = [](const Group& x, const Group& y) { return x.name == y.name; };
  const auto samePlace = [](const Primitive& x, const Primitive& y) {
    return x.bone == y.bone && x.group == y.group && x.line == y.line && x.territory == y.territory;
  };
  const auto sameSpan = [](const MuscleLine& x, const MuscleLine& y) {
    return x.name == y.name && x.origin.bone == y.origin.bone && x.insertion.bone == y.insertion.bone &&
           x.via.has_value() == y.via.has_value() && (!x.via || x.via->bone == y.via->bone);
  };
  return std::ranges::equal(a.lines, b.lines, sameSpan) && std::ranges::equal(a.primitives, b.primitives, samePlace) &&
         std::ranges::equal(a.groups, b.groups, sameGroup);
}

bool sameCandidates(const Rig& a, const Rig& b) {
  const auto sameLink = [](const Link& x, const Link& y) {
    return x.groups == y.groups && x.amount == y.amount && x.animated.empty() == y.animated.empty();
  };
  return samePlaces(a, b) && std::ranges::equal(a.links, b.links, sameLink);
}

Result<Attachment> relinked(Attachment attachment, const Rig& rig, BlendingGraphMemo& graphs) {
  const Result<const BlendingGraph*> graph = graphOf(rig, graphs);
  if (!graph) return graph.error();
  attachment.graph = *graph.value();
  return attachment;
}

std::vector<FieldPrimitive> fieldPrimitives(const Rig& rig, const Attachment& attachment) {
  std::vector<FieldPrimitive> primitives = attachment.primitives;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const Primitive& primitive = at(rig.primitives, attachment.rigIndex[i]);
    primitives[i].sign = primitive.sign;
    setNumbers({primitive.placement, primitive.reach, primitive.amount}, rig.surface.iso, primitives[i]);
  }
  return primitives;
}

void setNumbers(const RigNumbers& numbers, float iso, const Attachment& attachment,
                std::span<FieldPrimitive> primitives) {
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    setNumbers(at(numbers.primitives, attachment.rigIndex[i]), iso, primitives[i]);
  }
}

Result<Attachment> attach(const Rig& rig, const Character& character) {
  BlendingGraphMemo graphs;
  return attach(rig, character, graphs);
}

Result<Attachment> attach(const Rig& rig, const Character& character, BlendingGraphMemo& graphs) {
  const Result<const BlendingGraph*> graph = graphOf(rig, graphs);
  if (!graph) return graph.error();
  Attachment attachment;
  attachment.graph = *graph.value();
  attachment.candidatesOfVertex.resize(character.mesh.positions.size());
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const Primitive& primitive = rig.primitives[i];
    const std::optional<int> bone = character.skeleton.findBone(primitive.bone);
    const MuscleLine* line = lineOf(rig, primitive);
    if (!bone || (line && !hasBones(*line, character.skeleton))) {
      attachment.unattached.push_back(static_cast<int>(i));
      continue;
    }
    const int index = static_cast<int>(attachment.primitives.size());
    attachment.primitives.push_back(fieldPrimitive(rig, primitive, *bone));
    attachment.rigIndex.push_back(static_cast<int>(i));
    addCandidates(character, territoryBones(primitive, *bone, line, character.skeleton), index,
                  attachment.candidatesOfVertex);
  }
  return attachment;
}

}  // namespace sinew
