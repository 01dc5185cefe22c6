// app/command/inspect_facts.cpp: counts the contents of a document, and writes them as text and JSON.

#include "app/command/inspect_facts.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <sstream>

#include <glm/geometric.hpp>

#include "core/character/bindings.h"
#include "core/character/range_of_motion.h"
#include "core/files/rig_json_parts.h"
#include "core/geometry/normals.h"
#include "core/geometry/weld.h"
#include "core/rig/mesh_layers.h"
#include "core/rig/motion_clip.h"
#include "core/rig/rig_edit.h"
#include "core/rig/validation.h"

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
  for (const Link& link : rig.links) count(link.animated, facts);
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

// Text.

namespace {

constexpr std::size_t kEdgesListed = 8;

std::string plural(std::size_t number, const std::string& singular, const std::string& many) {
  return std::to_string(number) + ' ' + (number == 1 ? singular : many);
}

std::string shortNumber(float value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6).ptr;
  return {text.data(), end};
}

std::string pointText(const glm::vec3& p) {
  return '(' + shortNumber(p.x) + ", " + shortNumber(p.y) + ", " + shortNumber(p.z) + ')';
}

const std::string& strongestBoneName(const Character& character, int vertex) {
  return character.skeleton.bones[static_cast<std::size_t>(strongestBone(character, vertex))].name;
}

std::string quotedList(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "\"" : ", \"") + name + '"';
  return text;
}

void addOnce(std::vector<std::string>& names, const std::string& name) {
  if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

/// Where a joined edge is, for a modeller: its ends, bones and materials.
std::string edgeText(const Character& character, const MeshFacts& mesh, const std::array<int, 2>& edge) {
  const glm::vec3 a = mesh.joined.positions[static_cast<std::size_t>(edge[0])];
  const glm::vec3 b = mesh.joined.positions[static_cast<std::size_t>(edge[1])];
  const auto cornerAt = [&](const ControlTriangle& triangle, const glm::vec3& place) {
    return std::ranges::find_if(triangle.vertices, [&](int vertex) {
      return glm::distance(character.mesh.positions[static_cast<std::size_t>(vertex)], place) <= 2.0f * mesh.tolerance;
    });
  };
  std::size_t triangles = 0;
  std::vector<std::string> materials;
  std::vector<std::string> bones;
  for (const ControlTriangle& triangle : character.mesh.triangles) {
    const auto atA = cornerAt(triangle, a);
    if (atA == triangle.vertices.end() || cornerAt(triangle, b) == triangle.vertices.end()) continue;
    ++triangles;
    addOnce(bones, strongestBoneName(character, *atA));
    addOnce(materials, character.materials[static_cast<std::size_t>(triangle.material)].name);
  }
  return pointText(a) + " - " + pointText(b) + ": " + plural(triangles, "triangle", "triangles") + ", bone " +
         quotedList(bones) + ", material " + quotedList(materials);
}

void putSurface(std::ostream& out, const Character& character, const MeshFacts& mesh) {
  const std::size_t borders = mesh.bound.borderEdges.size();
  const std::size_t nonManifold = mesh.touching.nonManifoldEdges.size();
  out << "  surface     ";
  if (mesh.bound.closed()) {
    out << "closed\n";
  } else {
    out << "open: " << plural(borders, "border edge", "border edges") << '\n';
  }
  if (nonManifold == 0) return;
  out << "  meeting     " << plural(nonManifold, "edge", "edges") << " where more than two triangles meet";
  if (mesh.bound.nonManifoldEdges.empty()) out << ", all between parts that follow different bones";
  out << '\n';
  for (std::size_t i = 0; i < std::min(nonManifold, kEdgesListed); ++i) {
    out << "              " << edgeText(character, mesh, mesh.touching.nonManifoldEdges[i]) << '\n';
  }
  if (nonManifold > kEdgesListed) out << "              and " << nonManifold - kEdgesListed << " more\n";
}

void putNames(std::ostream& out, const char* title, const std::vector<std::string>& names) {
  out << "  " << title << names.size();
  const char* before = ": ";
  for (const std::string& name : names) {
    out << before << name;
    before = ", ";
  }
  out << '\n';
}

/// "Body skin, Shirt cloth (guessed)".
void putParts(std::ostream& out, const InspectFacts& facts) {
  const std::vector<MeshPart>& parts = facts.document.character->parts;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    names.push_back(parts[i].name + ' ' + nameOf(facts.layers[i]) + (facts.isGuessed[i] ? " (guessed)" : ""));
  }
  putNames(out, "parts       ", names);
  if (!facts.rig.missingParts.empty()) putNames(out, "no parts    ", facts.rig.missingParts);
}

void putRig(std::ostream& out, const InspectFacts& facts) {
  const Rig& rig = facts.document.rig();
  std::vector<std::string> groups;
  for (const Group& group : rig.groups) groups.push_back(group.name);
  std::vector<std::string> links;
  for (const Link& link : rig.links) {
    const std::string amount = link.amount < 1.0f ? numberText(100.0f * link.amount) + " %" : std::string();
    const std::string animated = link.animated.empty() ? "" : "animated";
    links.push_back(link.groups[0] + " - " + link.groups[1]);
    if (!amount.empty() || !animated.empty())
      links.back() += " (" + amount + (amount.empty() || animated.empty() ? "" : ", ") + animated + ")";
  }
  out << "  character   " << facts.document.characterFile.string() << '\n';
  out << "  primitives  " << rig.primitives.size();
  if (facts.rig.shaped > 0) out << ", " << facts.rig.shaped << " of them shaped";
  out << '\n';
  putNames(out, "groups      ", groups);
  putNames(out, "links       ", links);
  putNames(out, "lines       ", facts.rig.lines);
  out << "  keys        " << facts.rig.keys;
  if (facts.rig.keys > 0) out << ", of " << plural(facts.rig.keyed, "number", "numbers");
  out << '\n';
  putNames(out, "channels    ", facts.rig.channels);
  out << "  drivers     " << facts.rig.drivers << '\n';
  putNames(out, "unattached  ", facts.rig.unattached);
  if (!facts.rig.missing.empty()) out << "  missing     " << plural(facts.rig.missing.size(), "bone", "bones") << '\n';
  for (const MissingBone& one : facts.rig.missing) {
    out << "              " << refusalOf(one, facts.document.character->skeleton).text() << '\n';
  }
  if (!facts.rig.missingShapes.empty()) putNames(out, "no shapes   ", facts.rig.missingShapes);
  if (rig.smoothing.creaseAngle >= kNoCreases) return;
  const std::vector<Wedge>& wedges = facts.rig.shadedWedges;
  out << "  creases     over " << shortNumber(rig.smoothing.creaseAngle) << " degrees: " << wedges.size() << " wedges, "
      << std::ranges::count(wedges, true, &Wedge::creased) << " of them creased\n";
}

/// A line for each part that this kind of body has.
void putBody(std::ostream& out, const InspectFacts& facts) {
  out << "  body        " << nameOf(facts.body.kind) << '\n';
  for (const BodySlot slot : allBodySlots()) {
    const SlotBone& bone = facts.body[slot];
    if (bone.confidence == SlotConfidence::kMissing) continue;
    out << "              " << std::left << std::setw(14) << nameOf(slot) << std::setw(9) << nameOf(bone.confidence)
        << (bone.bone < 0 ? "none" : facts.document.character->skeleton.fileName(bone.bone));
    if (bone.from > 0.0f || bone.to < 1.0f) {
      out << ", from " << std::lround(100.0f * bone.from) << " to " << std::lround(100.0f * bone.to) << " %";
    }
    out << '\n';
  }
}

}  // namespace

std::string inspectText(const InspectFacts& facts) {
  const Character& character = *facts.document.character;
  std::vector<std::string> joints;
  for (const Bone& bone : character.skeleton.bones) joints.push_back(bone.name);
  std::vector<std::string> clips;
  for (const AnimationClip& clip : character.clips)
    clips.push_back(clip.name + ' ' + shortNumber(clip.duration) + " s" +
                    (clip.addedFrom.empty() ? "" : " of " + std::filesystem::path(clip.addedFrom).filename().string()));

  std::ostringstream out;
  out << facts.document.name() << '\n';
  if (facts.hasRig()) putRig(out, facts);
  out << "  triangles   " << character.mesh.triangles.size();
  if (character.mesh.trianglesDropped > 0)
    out << ", and " << character.mesh.trianglesDropped << " dropped as degenerate";
  out << "\n  vertices    " << character.mesh.positions.size() << " after welding, " << character.mesh.wedges.size()
      << " wedges\n";
  if (const std::size_t colored = facts.mesh.coloredWedges; colored > 0) {
    out << "  colours     at " << colored << " of the wedges\n";
  }
  putSurface(out, character, facts.mesh);
  out << "  height      " << shortNumber(character.height) << '\n';
  putNames(out, "joints      ", joints);
  putNames(out, "helpers     ", facts.helpers);
  putBody(out, facts);
  putNames(out, "clips       ", clips);
  putNames(out, "shapes      ", facts.shapes);
  out << "  motion      ";
  if (facts.rangeOfMotion > 0.0f) out << kRangeOfMotionName << ' ' << shortNumber(facts.rangeOfMotion) << " s\n";
  else out << "no joint can turn\n";
  out << "  materials   " << character.materials.size() << '\n';
  putParts(out, facts);
  out << "  textures    " << character.textures.size() << '\n';
  const std::vector<ClipFileReport>& files = facts.document.clipFiles.files;
  for (const Error& missing : missingOf(files)) out << "  clips left  " << missing.text() << '\n';
  for (const std::string& note : notesOf(files)) out << "  clips added " << note << '\n';
  out << "  ignored     " << (character.ignored.empty() ? "nothing" : "") << '\n';
  for (const std::string& what : character.ignored) out << "              " << what << '\n';
  return out.str();
}

std::vector<std::string> inspectHead() {
  return {"file",  "triangles", "vertices", "border edges", "height",  "joints",
          "clips", "motion s",  "muscles",  "lines",        "missing", "ignored"};
}

std::vector<std::string> inspectRow(const InspectFacts& facts, const std::string& file) {
  const Character& character = *facts.document.character;
  const auto ofRig = [&](std::size_t number) { return facts.hasRig() ? std::to_string(number) : std::string("-"); };
  return {file,
          std::to_string(character.mesh.triangles.size()),
          std::to_string(character.mesh.positions.size()),
          std::to_string(facts.mesh.bound.borderEdges.size()),
          shortNumber(character.height),
          std::to_string(character.skeleton.bones.size()),
          std::to_string(character.clips.size()),
          shortNumber(facts.rangeOfMotion),
          ofRig(facts.document.rig().primitives.size()),
          ofRig(facts.rig.lines.size()),
          ofRig(facts.rig.missing.size()),
          std::to_string(character.ignored.size())};
}

// JSON: docs/formats.md.

namespace {

int count(std::size_t size) { return static_cast<int>(size); }

/// Slots with a bone.
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
  json.set("groups", jsonList(rig.groups, [](const Group& group) { return group.name; }));
  json.set("links", jsonList(rig.links, linkNode));
  json.set("lines", jsonList(facts.rig.lines));
  json.set("shapes", count(facts.rig.shaped));
  json.set("keys", count(facts.rig.keys)).set("keyed_numbers", count(facts.rig.keyed));
  json.set("channels", jsonList(facts.rig.channels));
  json.set("drivers", count(facts.rig.drivers));
  json.set("unattached", jsonList(facts.rig.unattached));
  const Skeleton& skeleton = facts.document.character->skeleton;
  json.set("missing",
           jsonList(facts.rig.missing, [&](const MissingBone& bone) { return refusalOf(bone, skeleton).text(); }));
  json.set("missing_shapes", jsonList(facts.rig.missingShapes));
  json.set("missing_parts", jsonList(facts.rig.missingParts));
  json.set("crease_angle", rig.smoothing.creaseAngle);
  json.set("shaded_wedges", count(wedges.size()));
  json.set("creased_wedges", static_cast<int>(std::ranges::count(wedges, true, &Wedge::creased)));
}

Json clipFilesJson(const Document& document) {
  return jsonList(document.clipFiles.files, [&](const ClipFileReport& file) {
    Json clips = Json::array();
    for (const AnimationClip& clip : document.character->clips) {
      if (clip.addedFrom == file.file) clips.push(clip.name);
    }
    return Json::object()
        .set("file", file.file)
        .set("missing", file.missing ? Json(file.missing->text()) : Json())
        .set("clips", std::move(clips))
        .set("unmatched_bones", jsonList(file.unmatched))
        .set("unmoved_bones", jsonList(file.unmoved));
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
  json.set("joint_names", jsonList(character.skeleton.bones, [](const Bone& bone) { return bone.name; }));
  json.set("helper_joints", jsonList(facts.helpers));
  json.set("body", bodyJson(facts));
  json.set("clips", jsonList(character.clips, [](const AnimationClip& clip) {
             return Json::object().set("name", clip.name).set("duration", clip.duration);
           }));
  json.set("clip_files", clipFilesJson(facts.document));
  json.set("morph_targets", jsonList(facts.shapes));
  json.set("range_of_motion", facts.rangeOfMotion);
  json.set("materials", count(character.materials.size()));
  json.set("parts", partsJson(facts));
  json.set("textures", count(character.textures.size()));
  json.set("ignored", jsonList(character.ignored));
  if (facts.hasRig()) addRig(json, facts);
  return json;
}

}  // namespace sinew::app
