// core/runtime/game_file.cpp: game files written, read and checked.

#include "core/runtime/game_file.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/geometry/at.h"
#include "core/geometry/normals.h"
#include "core/geometry/weld.h"
#include "core/rig/validation.h"
#include "core/runtime/layout.h"
#include "sinew/runtime/game_file.h"

namespace sinew::gamefile {
namespace {

// The limits of the import (sinew/files/gltf_import.h).
constexpr std::size_t kMostTriangles = 2'000'000;
constexpr std::size_t kMostBones = 4096;
constexpr std::size_t kMostNodes = 1U << 18;
constexpr std::size_t kMostPathBytes = 64U << 20;
constexpr float kMostLength = 1e15f;  ///< Squares of larger lengths overflow.
constexpr float kWeightsOff = 1e-3f;

bool isIndex(int index, std::size_t size) { return index >= 0 && toIndex(index) < size; }

/// "expected a bone of 12, got 40".
Error outOf(const char* list, std::size_t number, const char* what, int index, std::size_t size) {
  return errorAt(std::string(list) + "[" + std::to_string(number) + "]",
                 std::string("expected a ") + what + " of " + std::to_string(size) + ", got " + std::to_string(index));
}
Error wrongAt(const char* list, std::size_t number, const char* reason) {
  return errorAt(std::string(list) + "[" + std::to_string(number) + "]", reason);
}

bool isAffine(const glm::mat4& m) {
  if (m[0][3] != 0.0f || m[1][3] != 0.0f || m[2][3] != 0.0f || m[3][3] != 1.0f) return false;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      if (std::abs(m[column][row]) > kMostLength) return false;
    }
  }
  return true;
}

Result<void> checkNodes(const std::vector<Node>& nodes) {
  if (nodes.size() > kMostNodes) return errorAt("nodes", "more than " + std::to_string(kMostNodes) + " nodes");
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].parent < -1 || nodes[i].parent >= static_cast<int>(i)) {
      return wrongAt("nodes", i, "its parent must come before it");
    }
    if (nodes[i].rest.matrix && !isAffine(*nodes[i].rest.matrix))
      return wrongAt("nodes", i, "its matrix is not affine");
  }
  return {};
}

/// Sets the parent of each bone to the nearest bone above its node.
Result<void> linkBones(Skeleton& skeleton) {
  std::vector<int> boneOf(skeleton.nodes.size(), -1);
  std::vector<Bone>& bones = skeleton.bones;
  for (std::size_t b = 0; b < bones.size(); ++b) {
    if (!isIndex(bones[b].node, skeleton.nodes.size())) {
      return outOf("bones", b, "node", bones[b].node, skeleton.nodes.size());
    }
    if (at(boneOf, bones[b].node) >= 0) return wrongAt("bones", b, "another bone has the same node");
    at(boneOf, bones[b].node) = static_cast<int>(b);
    if (bones[b].name.empty()) return wrongAt("bones", b, "a bone needs a name");
    if (!isAffine(bones[b].bindInWorld)) return wrongAt("bones", b, "its bind matrix is not affine");
  }
  std::vector<int> nearest(skeleton.nodes.size(), -1);  // The bone at or above each node.
  std::size_t pathBytes = 0;
  std::vector<std::size_t> length(bones.size(), 0);
  for (std::size_t n = 0; n < skeleton.nodes.size(); ++n) {
    const int parent = skeleton.nodes[n].parent;
    const int above = parent < 0 ? -1 : at(nearest, parent);
    nearest[n] = boneOf[n] >= 0 ? boneOf[n] : above;
    if (boneOf[n] < 0) continue;
    Bone& bone = at(bones, boneOf[n]);
    bone.parent = above;
    if (above >= boneOf[n]) return wrongAt("bones", toIndex(boneOf[n]), "its parent must come before it");
    std::size_t& own = at(length, boneOf[n]);
    own = bone.name.size() + 8 + (above < 0 ? 0 : at(length, above));
    pathBytes += own;
  }
  if (pathBytes > kMostPathBytes) return errorAt("bones", "the names are too long for so deep a skeleton");
  return {};
}

Result<void> checkSkeleton(Skeleton& skeleton) {
  if (Result<void> sound = checkNodes(skeleton.nodes); !sound) return sound;
  const std::size_t bones = skeleton.bones.size();
  if (bones == 0 || bones > kMostBones) {
    return errorAt("bones", "expected 1 to " + std::to_string(kMostBones) + " bones, got " + std::to_string(bones));
  }
  if (Result<void> linked = linkBones(skeleton); !linked) return linked;
  finishBones(skeleton);
  for (std::size_t b = 0; b < bones; ++b) {
    if (!isFinite(skeleton.bones[b].inverseBindInWorld)) {
      return wrongAt("bones", b, "its bind matrix has no inverse");
    }
  }
  if (skeleton.bindings.size() < bones) return errorAt("bindings", "each bone needs one of its own");
  for (std::size_t i = 0; i < skeleton.bindings.size(); ++i) {
    const Binding& binding = skeleton.bindings[i];
    if (!isIndex(binding.bone, bones)) return outOf("bindings", i, "bone", binding.bone, bones);
    if (i < bones && toIndex(binding.bone) != i) return wrongAt("bindings", i, "the first ones must be the bones' own");
    if (!isAffine(binding.inverseBind)) return wrongAt("bindings", i, "its matrix is not affine");
  }
  return {};
}

Result<void> checkInfluences(const ControlMesh& mesh, std::size_t bindings) {
  if (mesh.influenceBegin.size() != mesh.positions.size() + 1 || mesh.influenceBegin.front() != 0 ||
      mesh.influenceBegin.back() != static_cast<int>(mesh.influences.size())) {
    return errorAt("influences", "they do not match the vertices");
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.influenceBegin[v] >= mesh.influenceBegin[v + 1] ||
        toIndex(mesh.influenceBegin[v + 1]) > mesh.influences.size()) {
      return wrongAt("vertices", v, "expected at least one influence");
    }
    float sum = 0.0f;
    for (const Influence& influence : mesh.influencesOf(static_cast<int>(v))) {
      if (!isIndex(influence.binding, bindings)) return outOf("vertices", v, "binding", influence.binding, bindings);
      if (influence.weight < 0.0f) return wrongAt("vertices", v, "a weight is below 0");
      sum += influence.weight;
    }
    if (!(std::abs(sum - 1.0f) <= kWeightsOff)) return wrongAt("vertices", v, "the weights do not sum to 1");
  }
  return {};
}

Result<void> checkTriangles(const ControlMesh& mesh, std::size_t materials, std::size_t parts) {
  std::vector<bool> vertexUsed(mesh.positions.size(), false);
  std::vector<bool> wedgeUsed(mesh.wedges.size(), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const ControlTriangle& triangle = mesh.triangles[t];
    const auto& v = triangle.vertices;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!isIndex(v[i], mesh.positions.size())) return outOf("triangles", t, "vertex", v[i], mesh.positions.size());
      const int wedge = triangle.wedges[i];
      if (!isIndex(wedge, mesh.wedges.size())) return outOf("triangles", t, "wedge", wedge, mesh.wedges.size());
      if (at(mesh.wedges, wedge).vertex != v[i]) return wrongAt("triangles", t, "a wedge is of another vertex");
      vertexUsed[toIndex(v[i])] = true;
      wedgeUsed[toIndex(wedge)] = true;
    }
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) return wrongAt("triangles", t, "it has a vertex twice");
    if (!isIndex(triangle.material, materials)) {
      return outOf("triangles", t, "material", triangle.material, materials);
    }
    if (!isIndex(triangle.part, std::max<std::size_t>(parts, 1))) {
      return outOf("triangles", t, "part", triangle.part, parts);
    }
  }
  const auto vertex = std::ranges::find(vertexUsed, false);
  if (vertex != vertexUsed.end()) {
    return wrongAt("vertices", static_cast<std::size_t>(vertex - vertexUsed.begin()), "no triangle uses it");
  }
  const auto wedge = std::ranges::find(wedgeUsed, false);
  if (wedge != wedgeUsed.end()) {
    return wrongAt("wedges", static_cast<std::size_t>(wedge - wedgeUsed.begin()), "no triangle uses it");
  }
  return {};
}

Result<void> checkMesh(const Character& character) {
  const ControlMesh& mesh = character.mesh;
  if (mesh.triangles.empty() || mesh.triangles.size() > kMostTriangles) {
    return errorAt("triangles", "expected 1 to " + std::to_string(kMostTriangles) + ", got " +
                                    std::to_string(mesh.triangles.size()));
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::vec3 size = glm::abs(mesh.positions[v]);
    if (std::max({size.x, size.y, size.z}) > kMostLength) return wrongAt("vertices", v, "it lies too far away");
  }
  if (Result<void> sound = checkInfluences(mesh, character.skeleton.bindings.size()); !sound) return sound;
  return checkTriangles(mesh, character.materials.size(), character.parts.size());
}

Result<void> checkMorphs(const Character& character) {
  for (std::size_t k = 0; k < character.morphTargets.size(); ++k) {
    const MorphTarget& target = character.morphTargets[k];
    if (target.vertices.size() != target.deltas.size()) {
      return wrongAt("morphTargets", k, "vertices and deltas differ in number");
    }
    int before = -1;
    for (const int vertex : target.vertices) {
      if (vertex <= before) return wrongAt("morphTargets", k, "its vertices do not ascend");
      if (!isIndex(vertex, character.mesh.positions.size())) {
        return outOf("morphTargets", k, "vertex", vertex, character.mesh.positions.size());
      }
      before = vertex;
    }
  }
  for (std::size_t s = 0; s < character.morphSets.size(); ++s) {
    for (const MorphSet::Share& share : character.morphSets[s].shares) {
      if (!isIndex(share.target, character.morphTargets.size())) {
        return outOf("morphSets", s, "target", share.target, character.morphTargets.size());
      }
    }
  }
  return {};
}

bool areTimes(const std::vector<float>& times) {
  return !times.empty() && std::ranges::adjacent_find(times, [](float a, float b) { return !(a < b); }) == times.end();
}

std::size_t valuesPerKey(Interpolation interpolation) { return interpolation == Interpolation::kCubicSpline ? 3 : 1; }

Result<void> checkClip(const Character& character, std::size_t number) {
  const AnimationClip& clip = character.clips[number];
  if (clip.duration < 0.0f) return wrongAt("clips", number, "its duration is below 0");
  for (const Channel& channel : clip.channels) {
    if (!isIndex(channel.node, character.skeleton.nodes.size())) {
      return outOf("clips", number, "node", channel.node, character.skeleton.nodes.size());
    }
    if (!areTimes(channel.times)) return wrongAt("clips", number, "the times of a channel do not ascend");
    if (channel.values.size() != channel.times.size() * valuesPerKey(channel.interpolation)) {
      return wrongAt("clips", number, "times and values of a channel differ in number");
    }
  }
  const std::size_t targets = character.morphTargets.size();
  for (const MorphChannel& channel : clip.morphChannels) {
    if (!isIndex(channel.firstTarget, targets) || channel.targets < 1 ||
        toIndex(channel.targets) > targets - toIndex(channel.firstTarget)) {
      return outOf("clips", number, "morph target", channel.firstTarget, targets);
    }
    if (!areTimes(channel.times)) return wrongAt("clips", number, "the times of a channel do not ascend");
    if (channel.values.size() !=
        channel.times.size() * toIndex(channel.targets) * valuesPerKey(channel.interpolation)) {
      return wrongAt("clips", number, "times and values of a channel differ in number");
    }
  }
  return {};
}

/// Checks all indices, orders and ranges that were read (layout.h), completes the skeleton; no edges or normals yet.
Result<void> checkCharacter(Character& character) {
  if (!(character.height > 0.0f) || character.height > kMostLength) return errorAt("height", "expected a number > 0");
  if (character.materials.empty()) return errorAt("materials", "expected at least one");
  for (std::size_t p = 0; p < character.parts.size(); ++p) {
    const int material = character.parts[p].material;
    if (!isIndex(material, character.materials.size())) {
      return outOf("parts", p, "material", material, character.materials.size());
    }
  }
  if (Result<void> sound = checkSkeleton(character.skeleton); !sound) return sound;
  for (std::size_t i = 0; i < character.bodyParts.size(); ++i) {
    const int bone = character.bodyParts[i].bone;
    if (!isIndex(bone, character.skeleton.bones.size())) {
      return outOf("bodyParts", i, "bone", bone, character.skeleton.bones.size());
    }
  }
  if (Result<void> sound = checkMesh(character); !sound) return sound;
  if (Result<void> sound = checkMorphs(character); !sound) return sound;
  for (std::size_t c = 0; c < character.clips.size(); ++c) {
    if (Result<void> sound = checkClip(character, c); !sound) return sound;
  }
  return {};
}

}  // namespace
}  // namespace sinew::gamefile

namespace sinew {
namespace {

using gamefile::Head;

/// The bytes after the head.
Result<std::span<const std::byte>> gameBytes(std::span<const std::byte> file) {
  Head head;
  if (file.size() < sizeof head) return errorAt("byte 0", "this is not a Sinew game file: it is too short");
  std::memcpy(&head, file.data(), sizeof head);
  if (head.magic != gamefile::kMagic) return errorAt("byte 0", "this is not a Sinew game file");
  if (head.version != gamefile::kVersion) {
    return errorAt("byte 8", "expected version " + std::to_string(gamefile::kVersion) + ", got " +
                                 std::to_string(head.version) + ": export the character again");
  }
  const auto rest = file.subspan(sizeof head);
  if (head.bytes != rest.size()) {
    return errorAt("byte 16", "the file should have " + std::to_string(head.bytes) + " bytes after its head, it has " +
                                  std::to_string(rest.size()));
  }
  if (head.sum != gamefile::sumOf(rest)) return errorAt("byte 24", "the file is damaged: its checksum does not match");
  return rest;
}

}  // namespace

Result<GameCharacter> readGameFile(std::span<const std::byte> bytes) {
  const auto rest = gameBytes(bytes);
  if (!rest) return rest.error();
  auto character = std::make_shared<Character>();
  Rig rig;
  gamefile::Reader reader(rest.value());
  fields(reader, *character);
  fields(reader, rig);
  if (!reader.failed() && reader.left() > 0) reader.refuse("expected the end of the file");
  if (reader.failed()) return reader.error();
  if (Result<void> sound = gamefile::checkCharacter(*character); !sound) return sound.error();
  findEdges(character->mesh);
  character->mesh.normals = vertexNormals(character->mesh.positions, character->mesh.triangles);
  if (Result<void> valid = validate(rig); !valid) return valid.error();
  return GameCharacter{std::move(character), std::move(rig)};
}

std::vector<std::byte> gameFile(const Character& character, const Rig& rig) {
  gamefile::Writer writer;
  writer.bytes().resize(sizeof(gamefile::Head));
  fields(writer, character);
  fields(writer, rig);
  std::vector<std::byte> bytes = std::move(writer.bytes());
  const auto rest = std::span<const std::byte>(bytes).subspan(sizeof(gamefile::Head));
  gamefile::Head head;
  head.bytes = rest.size();
  head.sum = gamefile::sumOf(rest);
  std::memcpy(bytes.data(), &head, sizeof head);
  return bytes;
}

}  // namespace sinew
