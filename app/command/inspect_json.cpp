// app/command/inspect_json.cpp: a character or rig as a JSON object, docs/formats.md.
#include <algorithm>

#include "app/command/inspect_facts.h"
#include "core/rig/mesh_layers.h"

namespace sinew::app {
namespace {

int count(std::size_t size) { return static_cast<int>(size); }

template <class Items, class Show>
Json listOf(const Items& items, Show show) {
  Json list = Json::array();
  for (const auto& item : items) list.push(show(item));
  return list;
}

const std::string& asIs(const std::string& name) { return name; }

/// Slots that have a bone.
Json bodyJson(const InspectFacts& facts) {
  Json found = Json::object();
  for (const BodySlot slot : allBodySlots()) {
    const SlotBone& bone = facts.body[slot];
    if (bone.bone < 0) continue;
    Json one = Json::object();
    one.set("bone", facts.document.character->skeleton.fileName(bone.bone)).set("confidence", nameOf(bone.confidence));
    if (bone.from > 0.0f || bone.to < 1.0f) one.set("part", Json::array({bone.from, bone.to}));
    found.set(nameOf(slot), std::move(one));
  }
  return Json::object().set("kind", nameOf(facts.body.kind)).set("slots", std::move(found));
}

/// The parts of the mesh, with what they are to the muscles.
Json partsJson(const InspectFacts& facts) {
  const std::vector<MeshPart>& parts = facts.document.character->parts;
  Json list = Json::array();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Json one = Json::object();
    one.set("name", parts[i].name).set("layer", nameOf(facts.layers[i])).set("guessed", bool{facts.isGuessed[i]});
    list.push(std::move(one));
  }
  return list;
}

void addRig(Json& json, const InspectFacts& facts) {
  const Rig& rig = facts.document.rig();
  const std::vector<Wedge>& wedges = facts.rig.shadedWedges;
  json.set("character", facts.document.characterFile.string());
  json.set("primitives", count(rig.primitives.size()));
  json.set("groups", listOf(rig.groups, [](const Group& group) { return group.name; }));
  json.set("links", listOf(rig.links, [](const auto& link) { return listOf(link, asIs); }));
  json.set("lines", listOf(facts.rig.lines, asIs));
  json.set("shapes", count(facts.rig.shaped));
  json.set("keys", count(facts.rig.keys)).set("keyed_numbers", count(facts.rig.keyed));
  json.set("channels", listOf(facts.rig.channels, asIs));
  json.set("drivers", count(facts.rig.drivers));
  json.set("unattached", listOf(facts.rig.unattached, asIs));
  const Skeleton& skeleton = facts.document.character->skeleton;
  json.set("missing",
           listOf(facts.rig.missing, [&](const MissingBone& bone) { return refusalOf(bone, skeleton).text(); }));
  json.set("missing_shapes", listOf(facts.rig.missingShapes, asIs));
  json.set("missing_parts", listOf(facts.rig.missingParts, asIs));
  json.set("crease_angle", rig.smoothing.creaseAngle);
  json.set("shaded_wedges", count(wedges.size()));
  json.set("creased_wedges", static_cast<int>(std::ranges::count(wedges, true, &Wedge::creased)));
}

/// The files whose clips are added.
Json clipFilesJson(const Document& document) {
  return listOf(document.clipFiles.files, [&](const ClipFileReport& file) {
    Json clips = Json::array();
    for (const AnimationClip& clip : document.character->clips) {
      if (clip.addedFrom == file.file) clips.push(clip.name);
    }
    return Json::object()
        .set("file", file.file)
        .set("missing", file.missing ? Json(file.missing->text()) : Json())
        .set("clips", std::move(clips))
        .set("unmatched_bones", listOf(file.unmatched, asIs))
        .set("unmoved_bones", listOf(file.unmoved, asIs));
  });
}

}  // namespace

Json inspectJson(const InspectFacts& facts, const std::string& file) {
  const Character& character = *facts.document.character;
  Json json = Json::object();
  json.set("file", file);
  json.set("triangles", count(character.mesh.triangles.size()));
  json.set("triangles_dropped", character.mesh.trianglesDropped);
  json.set("vertices", count(character.mesh.positions.size()));
  json.set("wedges", count(character.mesh.wedges.size()));
  json.set("colored_wedges", count(facts.mesh.coloredWedges));
  json.set("closed", facts.mesh.bound.closed());
  json.set("border_edges", count(facts.mesh.bound.borderEdges.size()));
  json.set("non_manifold_edges", count(facts.mesh.touching.nonManifoldEdges.size()));
  json.set("height", character.height);
  json.set("joints", count(character.skeleton.bones.size()));
  json.set("joint_names", listOf(character.skeleton.bones, [](const Bone& bone) { return bone.name; }));
  json.set("helper_joints", listOf(facts.helpers, asIs));
  json.set("body", bodyJson(facts));
  json.set("clips", listOf(character.clips, [](const AnimationClip& clip) {
             return Json::object().set("name", clip.name).set("duration", clip.duration);
           }));
  json.set("clip_files", clipFilesJson(facts.document));
  json.set("morph_targets", listOf(facts.shapes, asIs));
  json.set("range_of_motion", facts.rangeOfMotion);
  json.set("materials", count(character.materials.size()));
  json.set("parts", partsJson(facts));
  json.set("textures", count(character.textures.size()));
  json.set("ignored", listOf(character.ignored, asIs));
  if (facts.hasRig()) addRig(json, facts);
  return json;
}

}  // namespace sinew::app
