// app/command/inspect_text.cpp: a character or rig in lines for people, and a row of a table.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <sstream>

#include <glm/geometric.hpp>

#include "app/command/inspect_facts.h"
#include "core/character/bindings.h"
#include "core/character/range_of_motion.h"
#include "core/geometry/creases.h"
#include "core/rig/mesh_layers.h"

namespace sinew::app {
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

/// The bone a vertex follows most.
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

/// Where a joined edge is, so that a modeller finds it: its ends, the bones it follows, the materials it lies between.
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
  for (const auto& [a, b] : rig.links) links.push_back(a + " - " + b);
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

/// A line for each part of the body; those that the body's kind does not have are left out.
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

}  // namespace sinew::app
