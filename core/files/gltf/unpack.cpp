// core/files/gltf/unpack.cpp: meshoptimizer and Draco behind checks, and the JSON of the two extensions.
#include "core/files/gltf/unpack.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <utility>

#include <draco/attributes/attribute_quantization_transform.h>
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#include <meshoptimizer.h>

#include "core/files/gltf/rules.h"
#include "core/geometry/at.h"
#include "sinew/files/gltf_import.h"

namespace sinew::gltf {

// Meshoptimizer.

namespace {

constexpr std::uint64_t kMostRatio = 64;  ///< Largest compression ratio of vertices: two bits for sixteen bytes.
constexpr std::uint64_t kMostStride = 256;

/// Checks the library's assertions and the rules of EXT_meshopt_compression. nullptr: no fault.
const char* faultOf(const MeshoptView& view) {
  if (view.count == 0) return "has no elements";
  if (view.mode != MeshoptMode::kAttributes) {
    if (view.stride != 2 && view.stride != 4) return "is of indices; 2 or 4 bytes are expected for each";
    if (view.filter != MeshoptFilter::kNone) return "is of indices, which have no filter";
    const bool whole = view.mode == MeshoptMode::kIndices || view.count % 3 == 0;
    return whole ? nullptr : "is of triangles; a multiple of 3 indices is expected";
  }
  if (view.stride == 0 || view.stride > kMostStride || view.stride % 4 != 0) {
    return "has a byteStride that is no multiple of 4 up to 256";
  }
  if (view.filter == MeshoptFilter::kOctahedral && view.stride != 4 && view.stride != 8) {
    return "has the filter OCTAHEDRAL, for 4 or 8 bytes";
  }
  return view.filter == MeshoptFilter::kQuaternion && view.stride != 8 ? "has the filter QUATERNION, for 8 bytes"
                                                                       : nullptr;
}

/// Whether the bytes can hold the elements.
bool holdsElements(std::uint64_t bytes, const MeshoptView& view) {
  if (view.mode == MeshoptMode::kAttributes) return view.count * view.stride / kMostRatio <= bytes;
  return (view.mode == MeshoptMode::kTriangles ? view.count / 3 : view.count) <= bytes;
}

bool decodeInto(std::vector<std::uint8_t>& to, std::span<const std::uint8_t> bytes, const MeshoptView& view) {
  switch (view.mode) {
    case MeshoptMode::kAttributes:
      return meshopt_decodeVertexBuffer(to.data(), view.count, view.stride, bytes.data(), bytes.size()) == 0;
    case MeshoptMode::kTriangles:
      return meshopt_decodeIndexBuffer(to.data(), view.count, view.stride, bytes.data(), bytes.size()) == 0;
    case MeshoptMode::kIndices:
      return meshopt_decodeIndexSequence(to.data(), view.count, view.stride, bytes.data(), bytes.size()) == 0;
  }
  return false;
}

void undoFilter(std::vector<std::uint8_t>& values, const MeshoptView& view) {
  switch (view.filter) {
    case MeshoptFilter::kNone:
      return;
    case MeshoptFilter::kOctahedral:
      return meshopt_decodeFilterOct(values.data(), view.count, view.stride);
    case MeshoptFilter::kQuaternion:
      return meshopt_decodeFilterQuat(values.data(), view.count, view.stride);
    case MeshoptFilter::kExponential:
      return meshopt_decodeFilterExp(values.data(), view.count, view.stride);
  }
}

}  // namespace

Result<std::vector<std::uint8_t>> decodeMeshopt(std::span<const std::uint8_t> bytes, const MeshoptView& view) {
  if (const char* const fault = faultOf(view)) return errorAt("", std::string("the compressed view ") + fault);
  if (!holdsElements(bytes.size(), view)) {
    return errorAt(
        "", std::to_string(bytes.size()) + " compressed bytes cannot hold " + std::to_string(view.count) + " elements");
  }
  std::vector<std::uint8_t> result(view.count * view.stride);
  if (!decodeInto(result, bytes, view)) return errorAt("", "the compressed view is damaged");
  undoFilter(result, view);
  return result;
}

namespace {

// Draco.

/// An attribute of a compressed mesh, as declared by its accessor.
struct DracoAttribute {
  std::uint64_t id = 0;   ///< Number in the compressed bytes.
  int components = 1;     ///< 1 to 16.
  int componentType = 0;  ///< TINYGLTF_COMPONENT_TYPE_* of glTF.
};

/// The file's declarations. A mesh that exceeds them is refused before allocating.
struct DracoRequest {
  std::size_t vertices = 0;       ///< Exactly.
  std::size_t mostTriangles = 0;  ///< At most.
  std::size_t mostBytes = 0;      ///< Of all decoded attributes.
  std::vector<DracoAttribute> attributes;
};

struct DracoMesh {
  std::vector<std::uint32_t> indices;                 ///< [triangles * 3], each below DracoRequest::vertices
  std::vector<std::vector<std::uint8_t>> attributes;  ///< [attributes] packed values of all vertices
  std::vector<float> steps;                           ///< [attributes] steps of rounding; 0: none
};

constexpr std::uint16_t kDracoVersion = 0x0202;
constexpr int kMostComponents = 16;
constexpr int kMostAttributes = 64;

/// Triangles times tables of connectivity, one for each attribute with seams: about 1 GiB.
constexpr std::uint64_t kMostTableTriangles = 20'000'000;

constexpr std::uint64_t kBytesBeside = 8;  ///< Bytes that Draco needs for a vertex and attribute besides the value.

/// Sizes in the header of the bytes.
struct DracoSizes {
  std::uint32_t vertices = 0;  ///< Encoded ones, at most the final number.
  std::uint32_t triangles = 0;
  std::uint64_t tables = 1;
};

/// A Draco decoder that compares sizes with the file's declarations before allocating.
template <class Decoder>
class GuardedDecoder : public Decoder {
 public:
  explicit GuardedDecoder(const DracoRequest& request) : request_(request) {}

  [[nodiscard]] const std::string& reason() const { return reason_; }

 protected:
  bool DecodeGeometryData() override {
    draco::DecoderBuffer ahead = *this->buffer();
    DracoSizes sizes;
    if (!readSizes(ahead, sizes)) return false;
    if (sizes.triangles > request_.mostTriangles) {
      return stop("has " + std::to_string(sizes.triangles) + " triangles; the file declares " +
                  std::to_string(request_.mostTriangles));
    }
    if (sizes.vertices > request_.vertices) return stop(otherVertices(sizes.vertices));
    if (sizes.triangles * sizes.tables > kMostTableTriangles) return stop("has too many seams to be read");
    return Decoder::DecodeGeometryData();
  }

  bool DecodeAllAttributes() override {
    const draco::PointCloud& cloud = *this->point_cloud();
    if (cloud.num_points() != request_.vertices) return stop(otherVertices(cloud.num_points()));
    if (cloud.num_attributes() > kMostAttributes) return stop("has more than 64 attributes");
    std::uint64_t bytes = 0;
    for (int i = 0; i < cloud.num_attributes(); ++i) {
      const draco::PointAttribute& attribute = *cloud.attribute(i);
      const int components = attribute.num_components();
      if (components < 1 || components > kMostComponents) return stop("has an attribute of more than 16 components");
      const auto size = static_cast<std::uint64_t>(draco::DataTypeLength(attribute.data_type()));
      // Quantized values are kept beside the final ones.
      bytes += static_cast<std::uint64_t>(components) * (size + 4) + kBytesBeside;
    }
    if (bytes * request_.vertices > request_.mostBytes) return stop("needs more memory than a character may");
    return Decoder::DecodeAllAttributes();
  }

 private:
  bool stop(std::string reason) {
    reason_ = std::move(reason);
    return false;
  }

  [[nodiscard]] std::string otherVertices(std::uint64_t count) const {
    return "has " + std::to_string(count) + " vertices; the file declares " + std::to_string(request_.vertices);
  }

  static bool readSizes(draco::DecoderBuffer& ahead, DracoSizes& sizes) {
    if constexpr (std::is_same_v<Decoder, draco::MeshSequentialDecoder>) {
      return draco::DecodeVarint(&sizes.triangles, &ahead) && draco::DecodeVarint(&sizes.vertices, &ahead);
    } else {
      std::uint8_t seams = 0;
      if (!draco::DecodeVarint(&sizes.vertices, &ahead) || !draco::DecodeVarint(&sizes.triangles, &ahead) ||
          !ahead.Decode(&seams)) {
        return false;
      }
      sizes.tables += seams;
      return true;
    }
  }

  const DracoRequest& request_;
  std::string reason_;
};

template <class Number>
bool copyValues(const draco::PointAttribute& from, std::size_t vertices, int components,
                std::vector<std::uint8_t>& to) {
  const std::size_t size = static_cast<std::size_t>(components) * sizeof(Number);
  to.resize(vertices * size);
  Number value[kMostComponents]{};
  for (std::size_t v = 0; v < vertices; ++v) {
    const draco::AttributeValueIndex index = from.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(v)));
    if (index.value() >= from.size()) return false;
    if (!from.ConvertValue<Number>(index, static_cast<std::int8_t>(components), value)) return false;
    std::memcpy(&to[v * size], value, size);
  }
  return true;
}

/// Index of the attribute with an id, or -1.
int findAttribute(const draco::Mesh& mesh, std::uint64_t id) {
  for (int i = 0; i < mesh.num_attributes(); ++i) {
    if (mesh.attribute(i)->unique_id() == id) return i;
  }
  return -1;
}

/// Step that an attribute was rounded to. @param rounded  the decoded attribute, or null
float stepOf(const draco::PointAttribute* rounded) {
  const draco::AttributeTransformData* const data = rounded ? rounded->GetAttributeTransformData() : nullptr;
  if (!data || data->transform_type() != draco::ATTRIBUTE_QUANTIZATION_TRANSFORM) return 0.0f;
  draco::AttributeQuantizationTransform transform;
  if (!transform.InitFromAttribute(*rounded)) return 0.0f;
  const int bits = transform.quantization_bits();
  if (bits < 1 || bits > 30 || !(transform.range() > 0.0f)) return 0.0f;
  return transform.range() / static_cast<float>((1u << static_cast<unsigned>(bits)) - 1u);
}

Result<DracoMesh> take(draco::MeshDecoder& decoder, const draco::Mesh& mesh, const DracoRequest& request) {
  DracoMesh result;
  result.indices.reserve(std::size_t{3} * mesh.num_faces());
  for (std::uint32_t f = 0; f < mesh.num_faces(); ++f) {
    for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(f))) {
      if (corner.value() >= request.vertices) return errorAt("", "a triangle names a vertex that is not there");
      result.indices.push_back(corner.value());
    }
  }
  for (const DracoAttribute& wanted : request.attributes) {
    const std::string name = "attribute " + std::to_string(wanted.id);
    const int index = findAttribute(mesh, wanted.id);
    if (index < 0) return errorAt("", "there is no " + name + " in the compressed mesh");
    const draco::PointAttribute* const from = mesh.attribute(index);
    if (from->num_components() != wanted.components) {
      return errorAt("", name + " has " + std::to_string(from->num_components()) +
                             " components; its accessor declares " + std::to_string(wanted.components));
    }
    std::vector<std::uint8_t>& values = result.attributes.emplace_back();
    const bool fits = withComponent(wanted.componentType, [&]<class T>(T) {
      return copyValues<T>(*from, request.vertices, wanted.components, values);
    });
    if (!fits) {
      return errorAt("", name + " has values that do not fit its accessor's component type");
    }
    result.steps.push_back(stepOf(decoder.GetPortableAttribute(index)));
  }
  return result;
}

template <class Decoder>
Result<DracoMesh> decodeWith(draco::DecoderBuffer& buffer, const DracoRequest& request) {
  GuardedDecoder<Decoder> decoder(request);
  draco::Mesh mesh;
  const draco::DecoderOptions options;
  const draco::Status status = decoder.Decode(options, &buffer, &mesh);
  if (!decoder.reason().empty()) return errorAt("", "the compressed mesh " + decoder.reason());
  if (!status.ok()) return errorAt("", "the compressed mesh is damaged");
  return take(decoder, mesh, request);
}

/// Decodes triangle meshes of Draco 2.2, as glTF requires. Error: reason only.
Result<DracoMesh> decodeDraco(std::span<const std::uint8_t> bytes, const DracoRequest& request) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::DecoderBuffer ahead = buffer;
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&ahead, &header).ok()) return errorAt("", "not a Draco mesh");
  if ((header.version_major << 8 | header.version_minor) != kDracoVersion) {
    return errorAt("", "Draco version " + std::to_string(header.version_major) + '.' +
                           std::to_string(header.version_minor) + "; 2.2 expected");
  }
  if (header.encoder_type != draco::TRIANGULAR_MESH) return errorAt("", "a Draco point cloud; a mesh is expected");
  switch (header.encoder_method) {
    case draco::MESH_SEQUENTIAL_ENCODING:
      return decodeWith<draco::MeshSequentialDecoder>(buffer, request);
    case draco::MESH_EDGEBREAKER_ENCODING:
      return decodeWith<draco::MeshEdgebreakerDecoder>(buffer, request);
    default:
      return errorAt("", "an unknown kind of Draco mesh");
  }
}

// Both.

/// Decoded bytes of all compressed parts; as many as a file may have.
constexpr std::uint64_t kMostUnpacked = 1ULL << 30;
constexpr std::size_t kMostTriangles = static_cast<std::size_t>(kMaxControlTriangles);
constexpr std::size_t kMostVertices = 6 * kMostTriangles;  // as for plain primitives

/// A whole number; `otherwise` if absent.
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

/// An extension of an element, or null.
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
        const std::string place = placeOfPrimitive(mesh, p);
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

  /// Views may share their bytes, so sizes are summed before decoding.
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

  /// Destination of a member of the compressed mesh.
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
    // A compressed strip becomes a list of triangles.
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

  /// Whether the file has plain values as well, for programs that cannot decompress.
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

  /// Indices in their accessor's component type.
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

  /// Several primitives may share an accessor if their values are the same.
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
