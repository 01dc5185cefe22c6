// app/cli/inspect.cpp: counts, names and defects of a character, as JSON or for people.
#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <sstream>

#include <CLI/CLI.hpp>
#include <glm/geometric.hpp>

#include "app/cli/console.h"
#include "app/cli/verb.h"
#include "app/document/document.h"
#include "core/character/bindings.h"
#include "core/character/skin_bones.h"
#include "core/io/json/json.h"
#include "core/mesh/creases.h"
#include "core/mesh/topology.h"
#include "core/mesh/weld.h"
#include "core/rig/attachment.h"

namespace sinew::app {
namespace {

struct InspectOptions {
  std::filesystem::path file;
  bool json = false;
};

constexpr std::size_t kEdgesListed = 50;

int count(std::size_t size) { return static_cast<int>(size); }

std::vector<std::string> unattached(const Document& document) {
  std::vector<std::string> names;
  for (const Primitive& primitive : document.rig().primitives) {
    if (!document.character->skeleton.findBone(primitive.bone)) names.push_back(primitive.name);
  }
  return names;
}

template <class Items, class Show>
Json listOf(const Items& items, Show show) {
  Json list = Json::array();
  for (const auto& item : items) list.push(show(item));
  return list;
}

/// Wedges as the rig's crease angle splits them.
std::vector<Wedge> shadedWedges(const Document& document) {
  return creased(document.character->mesh, document.rig().smoothing.creaseAngle).wedges;
}

void addRig(Json& json, const Document& document) {
  const Rig& rig = document.rig();
  const std::vector<Wedge> wedges = shadedWedges(document);
  const auto asIs = [](const std::string& name) { return name; };
  json.set("character", document.characterFile.string());
  json.set("primitives", count(rig.primitives.size()));
  json.set("groups", listOf(rig.groups, [](const Group& group) { return group.name; }));
  json.set("links", listOf(rig.links, [&](const auto& link) { return listOf(link, asIs); }));
  json.set("unattached", listOf(unattached(document), asIs));
  json.set("missing", listOf(missingBones(rig, document.character->skeleton),
                             [](const Error& missing) { return missing.text(); }));
  json.set("crease_angle", rig.smoothing.creaseAngle);
  json.set("shaded_wedges", count(wedges.size()));
  json.set("creased_wedges", static_cast<int>(std::ranges::count(wedges, true, &Wedge::creased)));
}

std::size_t coloredWedges(const ControlMesh& mesh) {
  return static_cast<std::size_t>(
      std::ranges::count_if(mesh.wedges, [](const Wedge& wedge) { return wedge.color != glm::vec4(1.0f); }));
}

/// The mesh as it is bound, and the same joined where separately moving parts touch: only there do edges with more than
/// two triangles show that no single part has.
struct Shape {
  Topology bound;
  ControlMesh joined;
  Topology touching;
  float tolerance = 0.0f;
};

Shape shapeOf(const Character& character) {
  Shape shape;
  shape.tolerance = 1e-6f * character.height;
  shape.bound = topologyOf(character.mesh);
  shape.joined = joinedByPosition(character.mesh, shape.tolerance);
  shape.touching = topologyOf(shape.joined);
  return shape;
}

/// Names of the joints that move no skin.
std::vector<std::string> helperNames(const Character& character) {
  const std::vector<bool> helpers = helperBones(character);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < helpers.size(); ++i) {
    if (helpers[i]) names.push_back(character.skeleton.bones[i].name);
  }
  return names;
}

std::string jsonText(const Document& document, const Shape& shape) {
  const Character& character = *document.character;
  Json json = Json::object();
  json.set("triangles", count(character.mesh.triangles.size()));
  json.set("triangles_dropped", character.mesh.trianglesDropped);
  json.set("vertices", count(character.mesh.positions.size()));
  json.set("wedges", count(character.mesh.wedges.size()));
  json.set("colored_wedges", count(coloredWedges(character.mesh)));
  json.set("closed", shape.bound.closed());
  json.set("border_edges", count(shape.bound.borderEdges.size()));
  json.set("non_manifold_edges", count(shape.touching.nonManifoldEdges.size()));
  json.set("height", character.height);
  json.set("joints", count(character.skeleton.bones.size()));
  json.set("joint_names", listOf(character.skeleton.bones, [](const Bone& bone) { return bone.name; }));
  json.set("helper_joints", listOf(helperNames(character), [](const std::string& name) { return name; }));
  json.set("clips", listOf(character.clips, [](const AnimationClip& clip) {
             return Json::object().set("name", clip.name).set("duration", clip.duration);
           }));
  json.set("materials", count(character.materials.size()));
  json.set("textures", count(character.textures.size()));
  json.set("ignored", listOf(character.ignored, [](const std::string& what) { return what; }));
  if (!document.rigFile.empty()) addRig(json, document);
  return json.dump(true) + '\n';
}

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
std::string edgeText(const Character& character, const Shape& shape, const std::array<int, 2>& edge) {
  const glm::vec3 a = shape.joined.positions[static_cast<std::size_t>(edge[0])];
  const glm::vec3 b = shape.joined.positions[static_cast<std::size_t>(edge[1])];
  const auto cornerAt = [&](const ControlTriangle& triangle, const glm::vec3& place) {
    return std::ranges::find_if(triangle.vertices, [&](int vertex) {
      return glm::distance(character.mesh.positions[static_cast<std::size_t>(vertex)], place) <= 2.0f * shape.tolerance;
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

void putSurface(std::ostream& out, const Character& character, const Shape& shape) {
  const std::size_t borders = shape.bound.borderEdges.size();
  const std::size_t nonManifold = shape.touching.nonManifoldEdges.size();
  out << "  surface     ";
  if (shape.bound.closed()) {
    out << "closed\n";
  } else {
    out << "open: " << plural(borders, "border edge", "border edges") << '\n';
  }
  if (nonManifold == 0) return;
  out << "  meeting     " << plural(nonManifold, "edge", "edges") << " where more than two triangles meet";
  if (shape.bound.nonManifoldEdges.empty()) out << ", all between parts that follow different bones";
  out << '\n';
  for (std::size_t i = 0; i < std::min(nonManifold, kEdgesListed); ++i) {
    out << "              " << edgeText(character, shape, shape.touching.nonManifoldEdges[i]) << '\n';
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

void putRig(std::ostream& out, const Document& document) {
  const Rig& rig = document.rig();
  std::vector<std::string> groups;
  for (const Group& group : rig.groups) groups.push_back(group.name);
  std::vector<std::string> links;
  for (const auto& [a, b] : rig.links) links.push_back(a + " - " + b);
  out << "  character   " << document.characterFile.string() << '\n';
  out << "  primitives  " << rig.primitives.size() << '\n';
  putNames(out, "groups      ", groups);
  putNames(out, "links       ", links);
  putNames(out, "unattached  ", unattached(document));
  const std::vector<Error> missing = missingBones(rig, document.character->skeleton);
  if (!missing.empty()) out << "  missing     " << missing.size() << '\n';
  for (const Error& one : missing) out << "              " << one.text() << '\n';
  if (rig.smoothing.creaseAngle >= kNoCreases) return;
  const std::vector<Wedge> wedges = shadedWedges(document);
  out << "  creases     over " << shortNumber(rig.smoothing.creaseAngle) << " degrees: " << wedges.size() << " wedges, "
      << std::ranges::count(wedges, true, &Wedge::creased) << " of them creased\n";
}

std::string plainText(const Document& document, const Shape& shape) {
  const Character& character = *document.character;
  std::vector<std::string> joints;
  for (const Bone& bone : character.skeleton.bones) joints.push_back(bone.name);
  std::vector<std::string> clips;
  for (const AnimationClip& clip : character.clips)
    clips.push_back(clip.name + ' ' + shortNumber(clip.duration) + " s");

  std::ostringstream out;
  out << document.name() << '\n';
  if (!document.rigFile.empty()) putRig(out, document);
  out << "  triangles   " << character.mesh.triangles.size();
  if (character.mesh.trianglesDropped > 0)
    out << ", and " << character.mesh.trianglesDropped << " dropped as degenerate";
  out << "\n  vertices    " << character.mesh.positions.size() << " after welding, " << character.mesh.wedges.size()
      << " wedges\n";
  if (const std::size_t colored = coloredWedges(character.mesh); colored > 0) {
    out << "  colours     at " << colored << " of the wedges\n";
  }
  putSurface(out, character, shape);
  out << "  height      " << shortNumber(character.height) << '\n';
  putNames(out, "joints      ", joints);
  putNames(out, "helpers     ", helperNames(character));
  putNames(out, "clips       ", clips);
  out << "  materials   " << character.materials.size() << '\n';
  out << "  textures    " << character.textures.size() << '\n';
  out << "  ignored     " << (character.ignored.empty() ? "nothing" : "") << '\n';
  for (const std::string& what : character.ignored) out << "              " << what << '\n';
  return out.str();
}

void addInspectOptions(CLI::App& verb, InspectOptions& options) {
  verb.add_option_function<std::string>(
          "FILE", [&](const std::string& file) { options.file = file; }, "Character (.glb, .gltf) or rig (.rig.json)")
      ->required();
  verb.add_flag("--json", options.json, "Print JSON, for programs");
}

int runInspect(const InspectOptions& options) {
  const auto document = openDocument(options.file);
  if (!document) return badInput(document.error());
  const Shape shape = shapeOf(*document->character);
  return putResult(options.json ? jsonText(document.value(), shape) : plainText(document.value(), shape));
}

}  // namespace

Verb inspectVerb() {
  return makeVerb<InspectOptions>("inspect", "Describe a character or a rig, and what is wrong with it",
                                  addInspectOptions, runInspect);
}

}  // namespace sinew::app
