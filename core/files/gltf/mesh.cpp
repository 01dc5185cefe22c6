// core/files/gltf/mesh.cpp: reading mesh primitives (glTF 2.0, section 3.7).

#include "core/files/gltf/mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_set>
#include <utility>

#include <glm/matrix.hpp>

#include "core/geometry/at.h"
#include "sinew/files/gltf_import.h"

namespace sinew::gltf {
namespace {

constexpr std::size_t kMaxTriangles = static_cast<std::size_t>(kMaxControlTriangles);
/// Vertices of one primitive; twice those of the largest unindexed mesh.
constexpr std::size_t kMaxVertices = 6 * kMaxTriangles;
constexpr std::size_t kMaxInfluences = 32U << 20;
constexpr std::size_t kMaxJointSets = 16;
constexpr double kMaxCoordinate = 1e15;
constexpr double kRoundedPlace = 0.87;  ///< Steps: half a step along each axis.
constexpr double kRoundedWeight = 2.5;  ///< Steps: half a step, and the effect of four on the sum.
constexpr double kMostRoundedWeight = 0.02;
constexpr float kMostRoundedPlace =
    2.5e-4f;  ///< Of the height. Coarser pieces stay separate where rounding separated them.

struct Attributes {
  const Accessor* position = nullptr;
  const Accessor* uv = nullptr;
  const Accessor* color = nullptr;
  std::vector<const Accessor*> joints;
  std::vector<const Accessor*> weights;
};

class SoupReader {
 public:
  SoupReader(const File& file, const BoundSkeleton& bound, Materials& materials, Accessors& accessors, Notes& notes,
             SoupOrigin* origin)
      : file_(file), bound_(bound), materials_(materials), accessors_(accessors), notes_(notes), origin_(origin) {
    soup_.influenceBegin.push_back(0);
  }

  void readMesh(int node, int mesh, const MeshBinding& binding) {
    const std::string place = placeOf("meshes", toIndex(mesh));
    file_.expectSound(place);
    const std::vector<tinygltf::Primitive>& primitives = file_.model().meshes[toIndex(mesh)].primitives;
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      SoupPart part{.node = node, .mesh = mesh, .primitive = static_cast<int>(p)};
      part.firstTriangle = soup_.triangles.size();
      part.firstVertex = soup_.positions.size();
      readPrimitive(mesh, primitives[p], placeOf(place + ".primitives", p), binding);
      part.endTriangle = soup_.triangles.size();
      part.endVertex = soup_.positions.size();
      if (origin_ && part.endTriangle > part.firstTriangle) origin_->parts.push_back(part);
    }
  }

  TriangleSoup take() && { return std::move(soup_); }
  [[nodiscard]] const std::vector<MeshMaterial>& parts() const { return parts_; }

 private:
  void readPrimitive(int mesh, const tinygltf::Primitive& primitive, const std::string& place,
                     const MeshBinding& binding) {
    file_.expectSound(place);
    if (primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
      refuse(place + ".mode", "unknown mode " + std::to_string(primitive.mode));
    }
    if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
      notes_.add("parts of meshes made of points or lines are ignored: only triangles are shown");
      return;
    }
    noteUnused(primitive);
    const int material = materialOf(primitive);
    if (!primitive.attributes.contains("POSITION")) {
      notes_.add("parts of meshes without positions are ignored: there is nothing to show");
      return;
    }
    const Attributes open =
        openAttributes(primitive, place + ".attributes", at(materials_.uvSources, material).set, binding);
    const Accessor* indices = nullptr;
    if (primitive.indices >= 0) {
      indices = &accessors_.open(primitive.indices, place + ".indices", TINYGLTF_TYPE_SCALAR);
      if (indices->isFloat()) refuse(indices->place(), "indices must be unsigned integers");
    }
    startPrimitive(open.position->count());
    startPiece(open, binding);
    const bool mirrored = glm::determinant(glm::dmat3(binding.meshToBind)) < 0.0;
    const std::size_t corners = indices ? indices->count() : open.position->count();
    const std::size_t triangles = triangleCount(primitive.mode, corners);
    if (triangles > kMaxTriangles - soup_.triangles.size()) refuse(place, "more than 2 million triangles", "too large");
    const int part = partOf(mesh, material);
    for (std::size_t t = 0; t < triangles; ++t) {
      std::array<std::uint32_t, 3> triangle = triangleCorners(primitive.mode, t);
      for (std::uint32_t& corner : triangle) {
        if (indices) corner = indices->integer(corner, 0);
        if (corner >= open.position->count()) {
          refuse(indices->place(), "index " + std::to_string(corner) + "; the primitive has " +
                                       std::to_string(open.position->count()) + " vertices");
        }
        corner = vertex(corner, open, binding, at(materials_.uvSources, material));
      }
      if (mirrored) std::swap(triangle[1], triangle[2]);
      soup_.triangles.push_back(triangle);
      soup_.materials.push_back(material);
      soup_.parts.push_back(part);
    }
  }

  int partOf(int mesh, int material) {
    const auto [found, isNew] = partNumbers_.try_emplace({mesh, material}, static_cast<int>(parts_.size()));
    if (isNew) parts_.push_back({mesh, material});
    return found->second;
  }

  void noteUnused(const tinygltf::Primitive& primitive) {
    // NORMAL is computed from the welded faces (docs/design.md).
    for (const auto& [name, accessor] : primitive.attributes) {
      if (name.starts_with("COLOR_") && name != "COLOR_0")
        notes_.add("vertex colours beyond the first set are ignored");
      else if (name == "TANGENT") notes_.add("vertex tangents are ignored: normal maps do without");
    }
  }

  int materialOf(const tinygltf::Primitive& primitive) {
    if (primitive.material >= 0) return primitive.material;
    const std::size_t inFile = file_.model().materials.size();
    if (materials_.materials.size() == inFile) {
      materials_.materials.push_back({.name = "default"});
      materials_.uvSources.emplace_back();
    }
    return static_cast<int>(inFile);
  }

  Attributes openAttributes(const tinygltf::Primitive& primitive, const std::string& place, int uvSet,
                            const MeshBinding& binding) {
    const auto openNamed = [&](const std::string& name, int type, int orType = -1) {
      return &accessors_.open(primitive.attributes.at(name), place + '.' + name, type, orType);
    };
    Attributes open;
    open.position = openNamed("POSITION", TINYGLTF_TYPE_VEC3);
    const auto openMatching = [&](const std::string& name, int type, int orType = -1) {
      const Accessor* accessor = openNamed(name, type, orType);
      if (accessor->count() != open.position->count()) {
        refuse(accessor->place(), std::to_string(accessor->count()) + " values of " + name + " for " +
                                      std::to_string(open.position->count()) + " positions");
      }
      return accessor;
    };
    const std::string uv = "TEXCOORD_" + std::to_string(uvSet);
    if (primitive.attributes.contains(uv)) open.uv = openMatching(uv, TINYGLTF_TYPE_VEC2);
    if (primitive.attributes.contains("COLOR_0")) {
      open.color = openMatching("COLOR_0", TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4);
      if (!open.color->holdsColors()) {
        refuse(open.color->place(), "colours must be floats, or normalized unsigned bytes or shorts");
      }
    }
    if (binding.skin < 0) return open;
    for (std::size_t set = 0;; ++set) {
      const std::string joints = "JOINTS_" + std::to_string(set);
      const std::string weights = "WEIGHTS_" + std::to_string(set);
      if (!primitive.attributes.contains(joints) || !primitive.attributes.contains(weights)) break;
      if (set == kMaxJointSets) refuse(place, "more than 16 sets of joints");
      open.joints.push_back(openMatching(joints, TINYGLTF_TYPE_VEC4));
      open.weights.push_back(openMatching(weights, TINYGLTF_TYPE_VEC4));
      if (open.joints.back()->isFloat()) refuse(open.joints.back()->place(), "joints must be unsigned integers");
    }
    if (open.joints.empty()) notes_.add("skinned meshes without joints and weights follow the skin's first joint");
    return open;
  }

  /// Marks all vertices as not taken, without visiting them.
  void startPrimitive(std::size_t vertices) {
    if (vertices > kMaxVertices) refuse("meshes", "a primitive with more than 12 million vertices");
    ++stamp_;
    if (taken_.size() < vertices) taken_.resize(vertices);
  }

  /// Pieces start with the first rounded primitive. Primitives on one grid of integers are one piece.
  void startPiece(const Attributes& open, const MeshBinding& binding) {
    const bool onGrid = !open.position->isFloat();
    const double step = onGrid ? open.position->step() : open.position->roundedTo();
    double weight = 0.0;
    for (const Accessor* weights : open.weights)
      weight = std::max(weight, onGrid ? weights->step() : weights->roundedTo());
    const glm::dmat3 toBind(binding.meshToBind);
    const double scale = std::max({glm::length(toBind[0]), glm::length(toBind[1]), glm::length(toBind[2])});
    const RoundedPiece piece{static_cast<float>(kRoundedPlace * scale * step),
                             static_cast<float>(std::min(kRoundedWeight * weight, kMostRoundedWeight))};
    piece_ = 0;
    if (soup_.pieces.empty() && !(piece.place > 0.0f) && !(piece.weight > 0.0f)) return;
    if (soup_.pieces.empty()) {
      soup_.pieces.emplace_back();
      soup_.pieceOf.assign(soup_.positions.size(), 0);
    }
    const auto same = std::ranges::find_if(grids_, [&](const Grid& grid) {
      return onGrid && grid.meshToBind == binding.meshToBind && grid.step == step && grid.weight == weight;
    });
    if (same != grids_.end()) {
      piece_ = same->piece;
      return;
    }
    piece_ = static_cast<int>(soup_.pieces.size());
    soup_.pieces.push_back(piece);
    if (onGrid) grids_.push_back({binding.meshToBind, step, weight, piece_});
  }

  /// The soup vertex of a vertex of the primitive.
  std::uint32_t vertex(std::uint32_t index, const Attributes& open, const MeshBinding& binding,
                       const UvSource& uvSource) {
    Taken& taken = taken_[index];
    if (taken.stamp == stamp_) return taken.soupVertex;
    taken = {.stamp = stamp_, .soupVertex = static_cast<std::uint32_t>(soup_.positions.size())};
    glm::dvec4 position(0.0, 0.0, 0.0, 1.0);
    for (int axis = 0; axis < 3; ++axis) position[axis] = open.position->number(index, axis);
    position = binding.meshToBind * position;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(std::abs(position[axis]) <= kMaxCoordinate)) {
        refuse(open.position->place(), "position " + std::to_string(index) + " is not finite or too large");
      }
    }
    soup_.positions.emplace_back(position);
    if (origin_) origin_->fileVertex.push_back(index);
    glm::vec2 uv(0.0f);
    if (open.uv) uv = uvSource.apply(open.uv->number(index, 0), open.uv->number(index, 1));
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) {
      notes_.add("texture coordinates that are not finite are ignored: 0 is used");
      uv = glm::vec2(0.0f);
    }
    soup_.uvs.push_back(uv);
    if (!soup_.pieces.empty()) soup_.pieceOf.push_back(piece_);
    addColor(index, open);
    addInfluences(index, open, binding);
    return taken.soupVertex;
  }

  /// Colors start with the first colored primitive; other vertices are white.
  void addColor(std::uint32_t index, const Attributes& open) {
    if (!open.color && soup_.colors.empty()) return;
    soup_.colors.resize(soup_.positions.size(), glm::vec4(1.0f));
    if (!open.color) return;
    glm::dvec4 color(1.0);
    for (int channel = 0; channel < open.color->components(); ++channel) {
      color[channel] = open.color->number(index, channel);
    }
    if (!std::isfinite(color.r + color.g + color.b + color.a)) {
      notes_.add("vertex colours that are not finite are ignored: white is used");
      return;
    }
    soup_.colors.back() = glm::vec4(glm::clamp(color, 0.0, 1.0));
  }

  void addInfluences(std::uint32_t index, const Attributes& open, const MeshBinding& binding) {
    scratch_.clear();
    double sum = 0.0;
    for (std::size_t set = 0; set < open.joints.size(); ++set) {
      for (int c = 0; c < 4; ++c) {
        const double weight = open.weights[set]->number(index, c);
        if (!(std::abs(weight) <= kMaxCoordinate)) {
          refuse(open.weights[set]->place(),
                 "weight of vertex " + std::to_string(index) + " is not finite or too large");
        }
        if (weight < 0.0) notes_.add("skin weights below 0 are ignored: they count as 0");
        if (weight <= 0.0) continue;
        scratch_.emplace_back(bindingOf(*open.joints[set], index, c, binding), weight);
        sum += weight;
      }
    }
    if (!(sum > 1e-12)) {
      scratch_.assign(1, {firstBinding(index, open, binding), 1.0});
      sum = 1.0;
      if (!open.joints.empty()) notes_.add("vertices whose weights are all zero follow their first joint");
    }
    std::ranges::stable_sort(scratch_, {}, &std::pair<int, double>::first);
    for (std::size_t i = 0; i < scratch_.size();) {
      const int to = scratch_[i].first;
      double weight = 0.0;
      for (; i < scratch_.size() && scratch_[i].first == to; ++i) weight += scratch_[i].second;
      if (const auto share = static_cast<float>(weight / sum); share > 0.0f) soup_.influences.push_back({to, share});
    }
    if (soup_.influences.size() > kMaxInfluences) refuse(open.position->place(), "more than 33 million skin weights");
    soup_.influenceBegin.push_back(static_cast<int>(soup_.influences.size()));
  }

  int firstBinding(std::uint32_t index, const Attributes& open, const MeshBinding& binding) const {
    if (binding.skin < 0) return binding.rigid;
    if (open.joints.empty()) return at(bound_.jointBindings, binding.skin).front();
    return bindingOf(*open.joints.front(), index, 0, binding);
  }

  int bindingOf(const Accessor& joints, std::uint32_t index, int component, const MeshBinding& binding) const {
    const std::vector<int>& bindings = at(bound_.jointBindings, binding.skin);
    const std::uint32_t joint = joints.integer(index, component);
    if (joint >= bindings.size()) {
      refuse(joints.place(), "vertex " + std::to_string(index) + " names joint " + std::to_string(joint) +
                                 "; the skin has " + std::to_string(bindings.size()));
    }
    return bindings[joint];
  }

  struct Taken {
    std::uint32_t stamp = 0;
    std::uint32_t soupVertex = 0;
  };

  /// A grid of integer positions and its piece.
  struct Grid {
    glm::dmat4 meshToBind{1.0};
    double step = 0.0;
    double weight = 0.0;
    int piece = 0;
  };

  const File& file_;
  const BoundSkeleton& bound_;
  Materials& materials_;
  Accessors& accessors_;
  Notes& notes_;
  SoupOrigin* origin_;        // or null
  std::vector<Taken> taken_;  // [vertices of the largest primitive so far]
  std::uint32_t stamp_ = 0;
  int piece_ = 0;  // of the primitive that is read
  std::vector<Grid> grids_;
  std::vector<std::pair<int, double>> scratch_;
  std::vector<MeshMaterial> parts_;
  std::map<std::pair<int, int>, int> partNumbers_;
  TriangleSoup soup_;
};

}  // namespace

TriangleSoup readTriangles(const File& file, const NodeTree& tree, const BoundSkeleton& bound, Materials& materials,
                           Accessors& accessors, Notes& notes, SoupOrigin* origin, std::vector<MeshMaterial>* parts) {
  SoupReader reader(file, bound, materials, accessors, notes, origin);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (bound.meshes[i]) reader.readMesh(static_cast<int>(i), tree.nodes[i].mesh, *bound.meshes[i]);
  }
  if (parts) *parts = reader.parts();
  TriangleSoup soup = std::move(reader).take();
  if (soup.pieces.empty()) return soup;
  const float most = kMostRoundedPlace * heightOf(soup.positions);
  for (RoundedPiece& piece : soup.pieces) piece.place = std::min(piece.place, most);
  return soup;
}

std::vector<MeshPart> partsOf(const File& file, std::span<const MeshMaterial> parts,
                              std::span<const Material> materials) {
  std::vector<MeshPart> out;
  std::map<int, int> materialsOf;  // by mesh
  for (const MeshMaterial& part : parts) ++materialsOf[part.mesh];
  std::unordered_set<std::string> taken;
  std::map<std::string, int> next;
  for (const MeshMaterial& part : parts) {
    const std::string& mesh = at(file.model().meshes, part.mesh).name;
    const std::string& material = at(materials, part.material).name;
    const bool several = materialsOf[part.mesh] > 1;
    std::string wanted = several && !material.empty() ? material : mesh.empty() ? material : mesh;
    if (wanted.empty()) wanted = "part";
    std::string name = wanted;
    for (int& number = next.try_emplace(wanted, 2).first->second; !taken.insert(name).second; ++number) {
      name = wanted + ' ' + std::to_string(number);
    }
    out.push_back({std::move(name), part.material});
  }
  return out;
}

void keepUsedParts(ControlMesh& mesh, std::vector<MeshMaterial>& parts) {
  std::vector<int> number(parts.size(), -1);
  for (const ControlTriangle& triangle : mesh.triangles) at(number, triangle.part) = 0;
  std::vector<MeshMaterial> used;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = static_cast<int>(used.size());
    used.push_back(parts[i]);
  }
  for (ControlTriangle& triangle : mesh.triangles) triangle.part = at(number, triangle.part);
  parts = std::move(used);
}

float heightOf(const std::vector<glm::vec3>& positions) {
  const glm::vec3 extent = boundsOf(positions).extent();
  const float longest = std::max({extent.x, extent.y, extent.z});
  constexpr float kFlat = 1e-6f;
  return extent.y > kFlat * longest ? extent.y : longest;
}

float weldTolerance(const TriangleSoup& soup) {
  constexpr float kWeldTolerance = 1e-6f;  // of the height, docs/design.md
  return kWeldTolerance * heightOf(soup.positions);
}

}  // namespace sinew::gltf
