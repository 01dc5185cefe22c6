// tests/support/characters/stand_ins.cpp: patches of the bundled characters, refined, then made irregular or split into
// parts.
#include "tests/support/characters/stand_ins.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/weld.h"
#include "core/surface/patches/patch.h"
#include "sinew/files/gltf_import.h"
#include "tests/support/characters/character_parts.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew::test {
namespace {

std::shared_ptr<const Character> bundled(const char* name) {
  return importGltf(std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / (std::string(name) + ".glb")).value();
}

/// A character's patches at a depth, as a mesh of their own.
struct Split {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<Weights> weights;
  std::vector<std::array<int, 3>> triangles;
};

Weights mixed(const ControlMesh& mesh, const std::array<int, 3>& corners, const glm::dvec3& shares) {
  std::map<int, float> sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto share = static_cast<float>(shares[static_cast<int>(i)]);
    if (!(share > 1e-6f)) continue;
    for (const Influence& one : mesh.influencesOf(corners[i])) sum[one.binding] += share * one.weight;
  }
  return {sum.begin(), sum.end()};
}

Split split(const Character& character, int depth) {
  const ControlMesh& mesh = character.mesh;
  const Refinement refinement = refine(mesh, depth);
  Split out;
  out.positions.resize(toIndex(refinement.vertexCount));
  out.normals.resize(out.positions.size());
  out.weights.resize(out.positions.size());
  out.triangles = refinement.triangles;
  evaluatePatches(PatchKind::kPn, mesh, refinement, mesh.positions, mesh.normals, out.positions, out.normals);
  for (std::size_t i = 0; i < out.triangles.size(); ++i) {
    const int control = refinement.controlOf[i];
    for (const int v : out.triangles[i]) {
      if (!at(out.weights, v).empty()) continue;
      at(out.weights, v) =
          mixed(mesh, at(mesh.triangles, control).vertices, controlCoordinates(mesh, refinement, control, v));
    }
  }
  return out;
}

std::shared_ptr<const Character> made(const Character& from, const std::string& name, const TriangleSoup& soup) {
  auto out = std::make_shared<Character>(from);
  out->name = name;
  out->mesh = weld(soup, 1e-6f * from.height);
  out->morphTargets.clear();
  out->morphSets.clear();
  return out;
}

TriangleSoup soupOf(const Split& split) {
  TriangleSoup soup;
  for (std::size_t v = 0; v < split.positions.size(); ++v) {
    addVertex(soup, split.positions[v], glm::vec2(0.0f), split.weights[v]);
  }
  for (const auto& t : split.triangles) addTriangle(soup, t[0], t[1], t[2]);
  return soup;
}

/// Moves each vertex within the skin by up to a quarter of its shortest edge.
void moveAbout(Split& split, Random& random) {
  std::vector<float> shortest(split.positions.size(), 1e30f);
  const std::vector<glm::vec3> before = split.positions;
  for (const auto& t : split.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const float length = glm::distance(at(before, t[i]), at(before, t[(i + 1) % 3]));
      for (const std::size_t end : {i, (i + 1) % 3}) at(shortest, t[end]) = std::min(at(shortest, t[end]), length);
    }
  }
  for (std::size_t v = 0; v < before.size(); ++v) {
    const glm::vec3 way(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const glm::vec3& n = split.normals[v];
    split.positions[v] += 0.25f * shortest[v] * (way - glm::dot(way, n) * n);
  }
}

/// Flips a third of the edges, wherever both new triangles face like the old ones.
void turnEdges(Split& split, Random& random) {
  std::map<std::array<int, 2>, std::size_t> sides;  // An edge as a triangle runs it -> that triangle.
  const auto faceOf = [&](const std::array<int, 3>& t) {
    const glm::vec3& a = at(split.positions, t[0]);
    return glm::cross(at(split.positions, t[1]) - a, at(split.positions, t[2]) - a);
  };
  const auto add = [&](std::size_t triangle) {
    const auto& t = split.triangles[triangle];
    for (std::size_t i = 0; i < 3; ++i) sides[{t[i], t[(i + 1) % 3]}] = triangle;
  };
  for (std::size_t t = 0; t < split.triangles.size(); ++t) add(t);
  const auto edges = sides;
  for (const auto& one : edges) {
    const std::array<int, 2> edge = one.first;
    const int a = edge[0];
    const int b = edge[1];
    const auto own = sides.find({a, b});
    const auto other = sides.find({b, a});
    if (a > b || own == sides.end() || other == sides.end() || !random.chance(0.33f)) continue;
    const std::array pair{own->second, other->second};
    const auto beyond = [&](std::size_t triangle) {
      return *std::ranges::find_if(split.triangles[triangle], [&](int v) { return v != edge[0] && v != edge[1]; });
    };
    const int c = beyond(pair[0]);
    const int d = beyond(pair[1]);
    const std::array<std::array<int, 3>, 2> turned{{{c, d, b}, {d, c, a}}};
    const glm::vec3 facing = glm::normalize(faceOf(split.triangles[pair[0]]) + faceOf(split.triangles[pair[1]]));
    const bool faces = std::ranges::all_of(turned, [&](const auto& t) {
      const glm::vec3 face = faceOf(t);
      return glm::dot(face, facing) > 0.8f * glm::length(face);
    });
    if (!faces || sides.count({c, d}) != 0 || sides.count({d, c}) != 0) continue;
    sides.erase(own);
    sides.erase(other);
    for (std::size_t i = 0; i < 2; ++i) split.triangles[pair[i]] = turned[i];
    for (const std::size_t triangle : pair) add(triangle);
  }
}

/// Which of the eight parts a bone's skin belongs to.
int partOf(const std::string& bone) {
  const int right = bone.ends_with(".R") ? 1 : 0;
  if (bone == "head" || bone == "neck") return 0;
  if (bone.starts_with("upper_arm")) return 2 + right;
  if (bone.starts_with("forearm") || bone.starts_with("hand")) return 4 + right;
  if (bone.starts_with("thigh") || bone.starts_with("shin") || bone.starts_with("foot") || bone.starts_with("toe")) {
    return 6 + right;
  }
  return 1;
}

}  // namespace

std::shared_ptr<const Character> irregularHorse() {
  const auto horse = bundled("horse");
  Split uneven = split(*horse, 2);
  Random random(1);
  moveAbout(uneven, random);
  turnEdges(uneven, random);
  return made(*horse, "irregular horse", soupOf(uneven));
}

std::shared_ptr<const Character> fineHumanoid() {
  const auto humanoid = bundled("humanoid");
  return made(*humanoid, "fine humanoid", soupOf(split(*humanoid, 9)));
}

std::shared_ptr<const Character> humanoidInParts() {
  const auto humanoid = bundled("humanoid");
  const Split whole = split(*humanoid, 2);
  const Skeleton& skeleton = humanoid->skeleton;
  const auto partOfVertex = [&](int v) {
    const auto most = std::ranges::max_element(at(whole.weights, v), {}, &std::pair<int, float>::second);
    return partOf(at(skeleton.bones, at(skeleton.bindings, most->first).bone).name);
  };
  std::vector<std::array<bool, 8>> partsAt(whole.positions.size());
  std::vector<int> parts;
  for (const auto& t : whole.triangles) {
    std::array<int, 3> votes{partOfVertex(t[0]), partOfVertex(t[1]), partOfVertex(t[2])};
    std::ranges::sort(votes);
    parts.push_back(votes[1]);
    for (const int v : t) at(partsAt, v)[toIndex(votes[1])] = true;
  }
  TriangleSoup soup;
  std::map<std::array<int, 2>, int> added;  // Part and vertex.
  for (std::size_t i = 0; i < whole.triangles.size(); ++i) {
    std::array<int, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const int v = whole.triangles[i][k];
      const auto [place, isNew] = added.try_emplace({parts[i], v}, 0);
      if (isNew) {
        // Borders of later parts lie deeper.
        const bool isBorder = std::ranges::count(at(partsAt, v), true) > 1;
        const float depth = isBorder ? 5e-4f * static_cast<float>(parts[i]) * humanoid->height : 0.0f;
        place->second = addVertex(soup, at(whole.positions, v) - depth * at(whole.normals, v), glm::vec2(0.0f),
                                  at(whole.weights, v));
      }
      corners[k] = place->second;
    }
    addTriangle(soup, corners[0], corners[1], corners[2]);
  }
  soup.parts = parts;
  auto out = std::make_shared<Character>(*made(*humanoid, "humanoid in parts", soup));
  out->parts.clear();
  for (const char* name : {"head", "trunk", "arm.L", "arm.R", "forearm.L", "forearm.R", "leg.L", "leg.R"}) {
    out->parts.push_back({name, 0});
  }
  return out;
}

}  // namespace sinew::test
