// core/files/gltf/draco_mesh.cpp: Draco's decoders, stopped where they would exceed what the file declares.

#include "core/files/gltf/draco_mesh.h"

#include <cstring>
#include <memory>
#include <utility>

#include <draco/attributes/attribute_quantization_transform.h>
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>

namespace sinew::gltf {
namespace {

constexpr std::uint16_t kDracoVersion = 0x0202;
constexpr int kMostComponents = 16;
constexpr int kMostAttributes = 64;
/// Triangles times tables of connectivity, which Draco keeps for each attribute with seams: about 1 GiB.
constexpr std::uint64_t kMostTableTriangles = 20'000'000;
/// Bytes that Draco keeps for a vertex and attribute beside the value's.
constexpr std::uint64_t kBytesBeside = 8;

/// What the bytes say before anything is decoded.
struct DracoSizes {
  std::uint32_t vertices = 0;  ///< Those that are encoded: no more than there are in the end.
  std::uint32_t triangles = 0;
  std::uint64_t tables = 1;
};

/// A decoder of Draco's that compares what the bytes declare with what the file does, once it knows and before it
/// allocates.
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
      // Quantized values stand beside those that they become.
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

bool copyValues(const draco::PointAttribute& from, std::size_t vertices, const DracoAttribute& as,
                std::vector<std::uint8_t>& to) {
  switch (as.componentType) {
    case 5120:
      return copyValues<std::int8_t>(from, vertices, as.components, to);
    case 5121:
      return copyValues<std::uint8_t>(from, vertices, as.components, to);
    case 5122:
      return copyValues<std::int16_t>(from, vertices, as.components, to);
    case 5123:
      return copyValues<std::uint16_t>(from, vertices, as.components, to);
    case 5125:
      return copyValues<std::uint32_t>(from, vertices, as.components, to);
    default:
      return copyValues<float>(from, vertices, as.components, to);
  }
}

/// Index of the attribute of that number, or -1.
int findAttribute(const draco::Mesh& mesh, std::uint64_t id) {
  for (int i = 0; i < mesh.num_attributes(); ++i) {
    if (mesh.attribute(i)->unique_id() == id) return i;
  }
  return -1;
}

/// What values of an attribute were rounded to. @param rounded  the attribute as it was decoded, or null
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
    if (!copyValues(*from, request.vertices, wanted, result.attributes.emplace_back())) {
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

}  // namespace

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

}  // namespace sinew::gltf
