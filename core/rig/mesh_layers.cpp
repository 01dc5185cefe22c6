// core/rig/mesh_layers.cpp: guesses the layers of parts; finds skin under cloth and cloth over skin by a tree.
#include "core/rig/mesh_layers.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <glm/geometric.hpp>

#include "core/character/bindings.h"
#include "core/character/bone_names.h"
#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/geometry/triangle_tree.h"
#include "core/rig/validation.h"

namespace sinew {

const char* nameOf(SkinLayer layer) {
  constexpr std::array kLayers{"skin", "cloth", "rigid"};
  return kLayers[static_cast<std::size_t>(layer)];
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
  constexpr std::size_t kMostLayers = 65536;
  if (auto count = validateCount("layers", "parts", rig.layers.size(), kMostLayers); !count) return count;
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

// Samples of each part against the triangles of the others.

namespace {

constexpr std::size_t kPartSamples = 160;       ///< Triangles of a part that are looked at, at most,
constexpr std::size_t kFewPartSamples = 8;      ///< and where there are very many parts,
constexpr std::size_t kAllPartSamples = 8'000;  ///< of all parts together.
constexpr float kOverWithin = 0.05f;    ///< Largest distance of a garment from the skin under it, fraction of H.
constexpr float kOverAlong = 0.4f;      ///< Cosine between normals, and between a normal and the direction to the skin.
constexpr float kOverShare = 0.5f;      ///< Fraction of the area over another part, from which a part is cloth.
constexpr float kNamedShare = 0.25f;    ///< The same for parts named as garments.
constexpr float kInsideShare = 0.5f;    ///< Fraction of the area inside others, from which a part is rigid.
constexpr float kInsideWinding = 0.4f;  ///< Below 0.5, since part of an eye is outside its socket.
constexpr float kSmallPart = 0.25f;     ///< Largest area of a part inside others, fraction of the body's.
constexpr float kSewnShare = 0.5f;      ///< Fraction of the border.

constexpr std::array<std::string_view, 16> kRigidWords{"eye",   "eyes",   "eyeball", "eyeballs", "iris",  "cornea",
                                                       "pupil", "pupils", "sclera",  "tooth",    "teeth", "tongue",
                                                       "gum",   "gums",   "denture", "glasses"};
constexpr std::array<std::string_view, 14> kHairWords{"hair",    "beard",     "moustache", "mustache", "brow",
                                                      "brows",   "eyebrow",   "eyebrows",  "lash",     "lashes",
                                                      "eyelash", "eyelashes", "haircut",   "ponytail"};
constexpr std::array<std::string_view, 33> kGarmentWords{
    "shirt", "tshirt",  "trousers", "pants",   "shorts", "dress", "skirt", "jacket", "coat", "hat",    "cap",
    "cloth", "clothes", "clothing", "outfit",  "sock",   "socks", "shoe",  "shoes",  "boot", "boots",  "footwear",
    "glove", "gloves",  "jeans",    "sweater", "hoodie", "vest",  "top",   "bottom", "suit", "sleeve", "armor"};

template <std::size_t N>
bool hasWordOf(const std::vector<std::string>& words, const std::array<std::string_view, N>& wanted) {
  return std::ranges::any_of(words,
                             [&](const std::string& word) { return std::ranges::find(wanted, word) != wanted.end(); });
}

/// The middle of a triangle, a sample of its part's surface.
struct PartSample {
  glm::vec3 middle{0.0f};
  glm::vec3 normal{0.0f};  ///< Unit.
  float area = 0.0f;
};

struct PartFacts {
  std::vector<int> triangles;
  std::vector<PartSample> samples;
  float area = 0.0f;
  std::set<int> bones;
  int border = 0;         ///< Edges with one triangle of this part.
  int sewn = 0;           ///< Those that also have one of another part.
  float over = 0.0f;      ///< Fraction of the area over other parts.
  float nearSkin = 0.0f;  ///< Fraction of the area close to other parts.
  std::vector<std::string> words;

  [[nodiscard]] bool isSewn() const {
    return border > 0 && static_cast<float>(sewn) >= kSewnShare * static_cast<float>(border);
  }
  [[nodiscard]] float weight() const { return area * static_cast<float>(bones.size()) * (1.0f - over); }
};

class LayerGuesser {
 public:
  explicit LayerGuesser(const Character& character)
      : character_(character), mesh_(character.mesh), height_(character.height), facts_(character.parts.size()) {
    gatherTriangles();
    gatherBorders();
    for (std::size_t p = 0; p < facts_.size(); ++p) {
      facts_[p].words = wordsOf(character.parts[p].name);
      const auto material = wordsOf(at(character.materials, character.parts[p].material).name);
      facts_[p].words.insert(facts_[p].words.end(), material.begin(), material.end());
    }
  }

  std::vector<SkinLayer> guess() {
    for (std::size_t p = 0; p < facts_.size(); ++p) measureOver(static_cast<int>(p));
    std::vector<SkinLayer> layers(facts_.size(), SkinLayer::kSkin);
    const auto body =
        static_cast<std::size_t>(std::ranges::max_element(facts_, {}, &PartFacts::weight) - facts_.begin());
    for (std::size_t p = 0; p < facts_.size(); ++p) {
      const PartFacts& part = facts_[p];
      if (p == body || part.isSewn()) continue;
      const bool hair = hasWordOf(part.words, kHairWords);
      if (!hair && hasWordOf(part.words, kRigidWords)) layers[p] = SkinLayer::kRigid;
      else if (part.over >= kOverShare || (hair && part.nearSkin >= kNamedShare) ||
               (part.over >= kNamedShare && hasWordOf(part.words, kGarmentWords))) {
        layers[p] = SkinLayer::kCloth;
      }
    }
    findInside(facts_[body].area, body, layers);
    return layers;
  }

 private:
  void gatherTriangles() {
    for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) {
      PartFacts& part = at(facts_, at(mesh_.triangles, t).part);
      part.triangles.push_back(t);
      const TriangleCorners c = controlCorners(mesh_, t);
      part.area += 0.5f * glm::length(glm::cross(c[1] - c[0], c[2] - c[0]));
    }
    const std::size_t most = std::clamp(kAllPartSamples / facts_.size(), kFewPartSamples, kPartSamples);
    for (PartFacts& part : facts_) {
      const std::size_t step = (part.triangles.size() + most - 1) / most;
      for (std::size_t i = 0; i < part.triangles.size(); i += std::max<std::size_t>(step, 1)) addSample(i, part);
    }
  }

  void addSample(std::size_t i, PartFacts& part) const {
    const int t = part.triangles[i];
    const TriangleCorners c = controlCorners(mesh_, t);
    const glm::vec3 face = glm::cross(c[1] - c[0], c[2] - c[0]);
    const float area = 0.5f * glm::length(face);
    if (!(area > 0.0f)) return;
    part.samples.push_back({(c[0] + c[1] + c[2]) / 3.0f, face / (2.0f * area), area});
    for (const int v : at(mesh_.triangles, t).vertices) {
      for (const WeightedBinding& follows : bindingsOf(character_, v)) part.bones.insert(follows.bone());
    }
  }

  void gatherBorders() {
    struct AtEdge {
      std::array<int, 2> parts{-1, -1};
      std::array<int, 2> counts{0, 0};
    };
    std::vector<AtEdge> edges(mesh_.edges.size());
    for (const ControlTriangle& triangle : mesh_.triangles) {
      for (const int e : triangle.edges) {
        AtEdge& edge = at(edges, e);
        const std::size_t slot = edge.parts[0] == triangle.part || edge.parts[0] < 0 ? 0 : 1;
        edge.parts[slot] = triangle.part;
        ++edge.counts[slot];
      }
    }
    for (const AtEdge& edge : edges) {
      for (std::size_t slot = 0; slot < 2; ++slot) {
        if (edge.counts[slot] != 1) continue;
        PartFacts& part = at(facts_, edge.parts[slot]);
        ++part.border;
        if (edge.parts[1 - slot] >= 0) ++part.sewn;
      }
    }
  }

  [[nodiscard]] TriangleTree treeOf(const std::vector<int>& triangles) const {
    std::vector<TriangleCorners> corners;
    for (const int t : triangles) corners.push_back(controlCorners(mesh_, t));
    return {corners, triangles};
  }

  /// The triangles of all parts for which isIn() is true.
  template <class IsIn>
  [[nodiscard]] std::vector<int> trianglesOf(IsIn isIn) const {
    std::vector<int> triangles;
    for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) {
      if (isIn(toIndex(at(mesh_.triangles, t).part))) triangles.push_back(t);
    }
    return triangles;
  }

  [[nodiscard]] glm::vec3 normalOf(int triangle) const {
    const TriangleCorners c = controlCorners(mesh_, triangle);
    return normalizeOr(glm::cross(c[1] - c[0], c[2] - c[0]), glm::vec3(0.0f));
  }

  /// Measures how much of a part has other parts under it that face the same way.
  void measureOver(int p) {
    PartFacts& part = at(facts_, p);
    const TriangleTree& all = wholeTree();
    const float within = kOverWithin * height_;
    float over = 0.0f;
    float nearby = 0.0f;
    float whole = 0.0f;
    for (const PartSample& sample : part.samples) {
      whole += sample.area;
      const auto own = [&](int t) { return at(mesh_.triangles, t).part == p ? 2.0f * within : 0.0f; };
      const NearestPoint found = all.nearest(sample.middle, within, own);
      if (found.triangle < 0) continue;
      nearby += sample.area;
      const glm::vec3 way = sample.middle - mixed(controlCorners(mesh_, found.triangle), found.shares);
      const glm::vec3 under = normalOf(found.triangle);
      const float along = glm::dot(way, under);
      const bool isAbove = along > kOverAlong * found.distance && glm::dot(under, sample.normal) > kOverAlong;
      if (isAbove) over += sample.area;
    }
    if (whole > 0.0f) {
      part.over = over / whole;
      part.nearSkin = nearby / whole;
    }
  }

  [[nodiscard]] const TriangleTree& wholeTree() {
    if (!whole_) whole_.emplace(treeOf(trianglesOf([](std::size_t) { return true; })));
    return *whole_;
  }

  void findInside(float bodyArea, std::size_t body, std::vector<SkinLayer>& layers) const {
    const auto isSmall = [&](std::size_t p) {
      return p != body && layers[p] == SkinLayer::kSkin && !facts_[p].isSewn() &&
             facts_[p].area < kSmallPart * bodyArea;
    };
    bool any = false;
    for (std::size_t p = 0; p < facts_.size(); ++p) any |= isSmall(p);
    if (!any) return;
    const std::vector<SkinLayer> before = layers;
    const TriangleTree tree = treeOf(trianglesOf([&](std::size_t p) { return before[p] == SkinLayer::kSkin; }));
    std::vector<std::size_t> inside;
    for (std::size_t p = 0; p < facts_.size(); ++p) {
      if (isSmall(p) && shareInside(p, tree) >= kInsideShare) inside.push_back(p);
    }
    for (const std::size_t p : inside) layers[p] = SkinLayer::kRigid;
  }

  /// Fraction of the part's area inside others. Subtracts the part's own winding number.
  [[nodiscard]] float shareInside(std::size_t p, const TriangleTree& tree) const {
    float inside = 0.0f;
    float whole = 0.0f;
    const TriangleTree own = treeOf(facts_[p].triangles);
    constexpr std::size_t kFew = 24;
    const std::span<const PartSample> samples = facts_[p].samples;
    const std::size_t step = std::max<std::size_t>(1, samples.size() / kFew);
    for (std::size_t i = 0; i < samples.size(); i += step) {
      const glm::vec3 off = samples[i].middle + 1e-3f * height_ * samples[i].normal;
      whole += samples[i].area;
      if (tree.windingAt(off) - own.windingAt(off) > kInsideWinding) inside += samples[i].area;
    }
    return whole > 0.0f ? inside / whole : 0.0f;
  }

  const Character& character_;
  const ControlMesh& mesh_;
  float height_;
  std::vector<PartFacts> facts_;  ///< [parts]
  std::optional<TriangleTree> whole_{};
};

}  // namespace

std::vector<SkinLayer> guessLayers(const Character& character) {
  if (character.parts.size() < 2) return std::vector<SkinLayer>(character.parts.size(), SkinLayer::kSkin);
  return LayerGuesser(character).guess();
}

namespace {

// Where parts meet, the first of these wins.
static_assert(SkinLayer::kSkin < SkinLayer::kCloth && SkinLayer::kCloth < SkinLayer::kRigid);

/// 0..1: agreement of a vertex's weights with those of a triangle's corners.
float weightLikeness(const Character& character, int vertex, int triangle) {
  float shared = 0.0f;
  for (const int corner : at(character.mesh.triangles, triangle).vertices) {
    for (const WeightedBinding& own : bindingsOf(character, vertex)) {
      float other = 0.0f;
      for (const WeightedBinding& follows : bindingsOf(character, corner)) {
        if (follows.bone() == own.bone()) other += follows.weight;
      }
      shared += std::min(own.weight, other);
    }
  }
  return std::min(shared / 3.0f, 1.0f);
}

class LayerFinder {
 public:
  LayerFinder(const Character& character, MeshLayers& out)
      : character_(character),
        mesh_(character.mesh),
        firstEdge_(mesh_.positions.size()),
        firstTriangle_(firstEdge_ + mesh_.edges.size()),
        out_(out) {}

  void run() {
    out_.carriers.assign(firstTriangle_ + mesh_.triangles.size(), SkinLayer::kRigid);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const ControlTriangle& triangle = mesh_.triangles[t];
      const SkinLayer layer = at(out_.parts, triangle.part);
      out_.carriers[firstTriangle_ + t] = layer;
      for (const int v : triangle.vertices) take(toIndex(v), layer);
      for (const int e : triangle.edges) take(firstEdge_ + toIndex(e), layer);
    }
    const auto first = out_.carriers.begin() + static_cast<std::ptrdiff_t>(firstTriangle_);
    const bool both = std::find(first, out_.carriers.end(), SkinLayer::kSkin) != out_.carriers.end() &&
                      std::find(first, out_.carriers.end(), SkinLayer::kCloth) != out_.carriers.end();
    if (!both) return;
    findNearest(SkinLayer::kCloth, SkinLayer::kSkin, out_.skinUnder);
    findNearest(SkinLayer::kSkin, SkinLayer::kCloth, out_.clothOver);
  }

 private:
  void take(std::size_t carrier, SkinLayer layer) { out_.carriers[carrier] = std::min(out_.carriers[carrier], layer); }

  void findNearest(SkinLayer from, SkinLayer to, std::vector<int>& out) const {
    std::vector<TriangleCorners> corners;
    std::vector<int> numbers;
    for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) {
      if (out_.carriers[firstTriangle_ + toIndex(t)] != to) continue;
      corners.push_back(controlCorners(mesh_, t));
      numbers.push_back(t);
    }
    const TriangleTree tree(corners, numbers);
    const float reach = kClothReach * character_.height;
    out.assign(mesh_.positions.size(), -1);
    forEachIndex(out.size(), 64, [&](std::size_t v) {
      if (out_.carriers[v] != from) return;
      const int vertex = static_cast<int>(v);
      const auto cost = [&](int t) { return 0.5f * reach * (1.0f - weightLikeness(character_, vertex, t)); };
      out[v] = tree.nearest(mesh_.positions[v], 1.5f * reach, cost).triangle;
    });
  }

  const Character& character_;
  const ControlMesh& mesh_;
  std::size_t firstEdge_;
  std::size_t firstTriangle_;
  MeshLayers& out_;
};

}  // namespace

MeshLayers meshLayers(const Character& character, std::span<const SkinLayer> layers) {
  MeshLayers out;
  out.parts.assign(layers.begin(), layers.end());
  LayerFinder(character, out).run();
  return out;
}

SkinMesh skinOf(const ControlMesh& mesh, const MeshLayers& layers) {
  SkinMesh skin;
  std::vector<int> number(mesh.positions.size(), -1);
  const std::size_t firstTriangle = mesh.positions.size() + mesh.edges.size();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (layers.carriers[firstTriangle + t] != SkinLayer::kSkin) continue;
    ControlTriangle triangle = mesh.triangles[t];
    for (int& v : triangle.vertices) {
      int& own = at(number, v);
      if (own < 0) {
        own = static_cast<int>(skin.vertices.size());
        skin.vertices.push_back(v);
        skin.mesh.positions.push_back(at(mesh.positions, v));
      }
      v = own;
    }
    skin.mesh.triangles.push_back(triangle);
  }
  return skin;
}

}  // namespace sinew
