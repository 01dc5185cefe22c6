// core/files/gltf/unpack.cpp: the JSON of the two extensions, checked by hand, and where their decoded bytes go.

#include "core/files/gltf/unpack.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/files/gltf/draco_mesh.h"
#include "core/files/gltf/meshopt_view.h"
#include "core/files/gltf/rules.h"
#include "core/geometry/at.h"
#include "sinew/files/gltf_import.h"

namespace sinew::gltf {
namespace {

/// Of all compressed parts of a file together, decoded; no more than a file may have in the first place.
constexpr std::uint64_t kMostUnpacked = 1ULL << 30;
constexpr std::size_t kMostTriangles = static_cast<std::size_t>(kMaxControlTriangles);
constexpr std::size_t kMostVertices = 6 * kMostTriangles;  // As of plain primitives.

/// The member of an object that must be a whole number; `otherwise` where it is absent.
std::uint64_t wholeIn(const Json& object, std::string_view name, const std::string& place,
                      std::optional<std::uint64_t> otherwise = {}) {
  const Json* const member = object.find(name);
  const std::string at = place + '.' + std::string(name);
  if (!member && otherwise) return *otherwise;
  if (!member) refuse(at, "missing");
  const double value = member->number(-1.0);
  if (!(value >= 0.0 && value <= static_cast<double>(kMaxWhole)) || value != std::floor(value)) {
    refuse(at, "expected a whole number >= 0");
  }
  return static_cast<std::uint64_t>(value);
}

std::size_t indexIn(const Json& object, std::string_view name, const std::string& place, std::size_t size) {
  const std::uint64_t index = wholeIn(object, name, place);
  if (index >= size) {
    refuse(place + '.' + std::string(name),
           "there is no element " + std::to_string(index) + "; the file has " + std::to_string(size));
  }
  return static_cast<std::size_t>(index);
}

/// The extension of an element, or null.
const Json* extensionOf(const Json& element, std::string_view name) {
  if (element.kind != Json::Kind::kObject) return nullptr;
  const Json& extensions = element.at("extensions");
  return extensions.kind == Json::Kind::kObject ? extensions.find(name) : nullptr;
}

template <class Value, std::size_t N>
Value wordIn(const Json& object, std::string_view name, const std::string& place,
             const std::array<std::pair<std::string_view, Value>, N>& words) {
  const std::string text = object.at(name).text("");
  const auto found = std::ranges::find(words, std::string_view(text), &std::pair<std::string_view, Value>::first);
  if (found == words.end())
    refuse(place + '.' + std::string(name), "unknown; " + std::string(words[0].first) + " is one");
  return found->second;
}

constexpr std::array<std::pair<std::string_view, MeshoptMode>, 3> kModes{{{"ATTRIBUTES", MeshoptMode::kAttributes},
                                                                          {"TRIANGLES", MeshoptMode::kTriangles},
                                                                          {"INDICES", MeshoptMode::kIndices}}};
constexpr std::array<std::pair<std::string_view, MeshoptFilter>, 4> kFilters{
    {{"NONE", MeshoptFilter::kNone},
     {"OCTAHEDRAL", MeshoptFilter::kOctahedral},
     {"QUATERNION", MeshoptFilter::kQuaternion},
     {"EXPONENTIAL", MeshoptFilter::kExponential}}};

class Unpacker {
 public:
  Unpacker(const Json& root, const Guarded& guarded, const BufferRange& bytes, tinygltf::Model& model)
      : root_(root), guarded_(guarded), bytes_(bytes), model_(model), fileViews_(model.bufferViews.size()) {}

  Unpacked run() && {
    std::vector<std::pair<std::size_t, PackedView>> packed;
    for (std::size_t view = 0; view < fileViews_; ++view) {
      const Json* const compressed = extensionOf(root_.at("bufferViews").items()[view], kMeshopt);
      if (compressed) packed.emplace_back(view, checkView(view, *compressed));
    }
    for (const auto& [view, from] : packed) {
      Result<std::vector<std::uint8_t>> decoded = decodeMeshopt(from.bytes, from.as);
      if (!decoded) refuse(placeOfView(view), decoded.error().reason, "damaged");
      result_.views[view] = std::move(decoded).value();
    }
    const std::vector<Json>& meshes = root_.at("meshes").items();
    for (std::size_t mesh = 0; mesh < model_.meshes.size(); ++mesh) {
      for (std::size_t p = 0; p < model_.meshes[mesh].primitives.size(); ++p) {
        const Json& primitive = meshes[mesh].at("primitives").items()[p];
        const Json* const compressed = extensionOf(primitive, kDraco);
        const std::string place = placeOf(placeOf("meshes", mesh) + ".primitives", p);
        if (compressed) unpackPrimitive(primitive, *compressed, place, model_.meshes[mesh].primitives[p]);
      }
    }
    return std::move(result_);
  }

 private:
  struct PackedView {
    MeshoptView as;
    Bytes bytes;
  };

  static std::string placeOfView(std::size_t view) {
    return placeOf("bufferViews", view) + ".extensions." + std::string(kMeshopt);
  }

  /// Views may share their bytes, so that sizes are added up before any is decoded.
  PackedView checkView(std::size_t view, const Json& compressed) {
    const std::string place = placeOfView(view);
    const std::size_t buffer = indexIn(compressed, "buffer", place, model_.buffers.size());
    MeshoptView as{wholeIn(compressed, "count", place), wholeIn(compressed, "byteStride", place),
                   wordIn(compressed, "mode", place, kModes), MeshoptFilter::kNone};
    if (compressed.find("filter")) as.filter = wordIn(compressed, "filter", place, kFilters);
    const std::uint64_t declared = model_.bufferViews[view].byteLength;
    if (as.stride == 0 || as.count != declared / as.stride || declared % as.stride != 0) {
      refuse(place, std::to_string(as.count) + " elements of " + std::to_string(as.stride) + " bytes; the view has " +
                        std::to_string(declared) + " bytes");
    }
    reserve(declared, place);
    return {as, bytes_(buffer, wholeIn(compressed, "byteOffset", place, 0), wholeIn(compressed, "byteLength", place),
                       place)};
  }

  void reserve(std::uint64_t bytes, const std::string& place) {
    if (bytes > kMostUnpacked - unpacked_) {
      refuse(place, "the compressed parts of the file become more than 1 GiB together", "too large");
    }
    unpacked_ += bytes;
  }

  /// Where a member of the compressed mesh goes.
  struct Goal {
    std::string place;
    std::size_t accessor = 0;
  };

  void unpackPrimitive(const Json& primitive, const Json& compressed, const std::string& at,
                       tinygltf::Primitive& plain) {
    const std::string place = at + ".extensions." + std::string(kDraco);
    const std::size_t view = indexIn(compressed, "bufferView", place, fileViews_);
    const Json& numbers = compressed.at("attributes");
    if (numbers.kind != Json::Kind::kObject) refuse(place + ".attributes", "expected an object");
    DracoRequest request;
    std::vector<Goal> goals;
    for (const Json& number : numbers.children) {
      const Json& own = primitive.at("attributes");
      if (own.kind != Json::Kind::kObject || !own.find(number.key)) continue;
      const std::string to = at + ".attributes";
      goals.push_back({to + '.' + number.key, indexIn(own, number.key, to, model_.accessors.size())});
      const tinygltf::Accessor& accessor = sound(goals.back());
      request.attributes.push_back({wholeIn(numbers, number.key, place + ".attributes"),
                                    tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)),
                                    accessor.componentType});
    }
    if (goals.empty()) refuse(place + ".attributes", "none of the primitive's attributes is in it");
    const Goal corners{at + ".indices", indexIn(primitive, "indices", at, model_.accessors.size())};
    result_.spent.insert(view);
    if (hasPlainCopy(goals, corners)) return;
    if (plain.mode != TINYGLTF_MODE_TRIANGLES && plain.mode != TINYGLTF_MODE_TRIANGLE_STRIP) {
      refuse(at + ".mode",
             "only triangles and strips of them are compressed so, not mode " + std::to_string(plain.mode));
    }
    request.vertices = model_.accessors[goals.front().accessor].count;
    for (const Goal& goal : goals) {
      if (model_.accessors[goal.accessor].count != request.vertices) {
        refuse(goal.place, "has another count than the primitive's other attributes");
      }
    }
    const std::size_t declared = sound(corners).count;
    const bool strip = plain.mode == TINYGLTF_MODE_TRIANGLE_STRIP;
    if (request.vertices > kMostVertices) refuse(at, "more than 12 million vertices", "too large");
    if (declared / 3 > kMostTriangles) refuse(at, "more than 2 million triangles", "too large");
    // A strip is written as the list of triangles that it is compressed as.
    request.mostTriangles = strip ? std::min(declared, kMostTriangles) : declared / 3;
    request.mostBytes = static_cast<std::size_t>(kMostUnpacked - unpacked_);
    Result<DracoMesh> decoded = decodeDraco(viewBytes(view, place), request);
    if (!decoded) refuse(place, decoded.error().reason, "damaged");
    if (!strip && decoded->indices.size() != declared) {
      refuse(place, "the compressed mesh has " + std::to_string(decoded->indices.size() / 3) +
                        " triangles; the file declares " + std::to_string(declared) + " indices");
    }
    for (std::size_t i = 0; i < goals.size(); ++i)
      give(goals[i], std::move(decoded.value().attributes[i]), request.vertices, decoded->steps[i]);
    give(corners, asComponents(decoded->indices, corners), decoded->indices.size(), 0.0f);
    plain.mode = TINYGLTF_MODE_TRIANGLES;
  }

  const tinygltf::Accessor& sound(const Goal& goal) const {
    guarded_.expectSound(placeOf("accessors", goal.accessor));
    return model_.accessors[goal.accessor];
  }

  /// Files for programs that cannot decompress, too, have all values a second time.
  [[nodiscard]] bool hasPlainCopy(const std::vector<Goal>& goals, const Goal& corners) const {
    const auto isPlain = [&](const Goal& goal) {
      return model_.accessors[goal.accessor].bufferView >= 0 && !result_.accessors.contains(goal.accessor);
    };
    return std::ranges::count(model_.extensionsRequired, kDraco) == 0 && isPlain(corners) &&
           std::ranges::all_of(goals, isPlain);
  }

  [[nodiscard]] Bytes viewBytes(std::size_t view, const std::string& place) const {
    if (const auto own = result_.views.find(view); own != result_.views.end()) return own->second;
    const tinygltf::BufferView& from = model_.bufferViews[view];
    return bytes_(toIndex(from.buffer), from.byteOffset, from.byteLength, place);
  }

  /// Indices as their accessor declares them.
  std::vector<std::uint8_t> asComponents(const std::vector<std::uint32_t>& indices, const Goal& corners) const {
    const int type = model_.accessors[corners.accessor].componentType;
    if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
        type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
      refuse(corners.place, "indices must be unsigned integers");
    }
    const auto size = toIndex(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type)));
    const std::uint32_t most = std::numeric_limits<std::uint32_t>::max() >> (32 - 8 * size);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(indices.size() * size);
    for (const std::uint32_t index : indices) {
      if (index > most) refuse(corners.place, "index " + std::to_string(index) + " does not fit its component type");
      for (std::size_t i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(index >> (8 * i) & 0xff));
    }
    return bytes;
  }

  /// An accessor may belong to several primitives if they give it the same.
  void give(const Goal& goal, std::vector<std::uint8_t> bytes, std::size_t count, float step) {
    tinygltf::Accessor& accessor = model_.accessors[goal.accessor];
    if (!result_.accessors.try_emplace(goal.accessor, step).second) {
      if (result_.views.at(toIndex(accessor.bufferView)) == bytes && accessor.count == count) return;
      refuse(goal.place, "two compressed meshes give its accessor different values");
    }
    reserve(bytes.size(), goal.place);
    accessor.count = count;
    accessor.byteOffset = 0;
    accessor.bufferView = static_cast<int>(model_.bufferViews.size());
    tinygltf::BufferView& view = model_.bufferViews.emplace_back();
    view.buffer = 0;
    view.byteLength = bytes.size();
    result_.views[model_.bufferViews.size() - 1] = std::move(bytes);
  }

  const Json& root_;
  const Guarded& guarded_;
  const BufferRange& bytes_;
  tinygltf::Model& model_;
  std::size_t fileViews_;
  std::uint64_t unpacked_ = 0;
  Unpacked result_;
};

}  // namespace

bool isFallback(const Json& buffer) {
  const Json* const extension = extensionOf(buffer, kMeshopt);
  return extension && extension->at("fallback").boolean(false);
}

Unpacked unpack(const Json& root, const Guarded& guarded, const BufferRange& bytes, tinygltf::Model& model) {
  return Unpacker(root, guarded, bytes, model).run();
}

}  // namespace sinew::gltf
