// tests/support/characters/compressed_post.cpp: the encoders, and the JSON of their extensions.
#include "tests/support/characters/compressed_post.h"

#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

namespace sinew::test {
namespace {

using nlohmann::ordered_json;

constexpr const char* kDracoName = "KHR_draco_mesh_compression";
constexpr const char* kMeshoptName = "EXT_meshopt_compression";
constexpr std::size_t kPostVertices = 12;

template <class Number>
void addDracoAttribute(draco::Mesh& mesh, draco::GeometryAttribute::Type type, draco::DataType dataType, int components,
                       const std::vector<Number>& values) {
  draco::GeometryAttribute attribute;
  const auto stride = static_cast<std::int64_t>(static_cast<std::size_t>(components) * sizeof(Number));
  attribute.Init(type, nullptr, static_cast<std::uint8_t>(components), dataType, false, stride, 0);
  const int id = mesh.AddAttribute(attribute, true, kPostVertices);
  for (std::uint32_t v = 0; v < kPostVertices; ++v) {
    mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(v),
                                          &values[v * static_cast<std::size_t>(components)]);
  }
}

void requireExtension(Post& post, const char* name) {
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
    ordered_json& names = post.file.json[list];
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
}

ordered_json& accessorOfPart(Post& post, const std::string& part) {
  const ordered_json& index = part == "indices" ? post.primitive()["indices"] : post.attributes()[part];
  return post.file.json["accessors"][index.get<std::size_t>()];
}

}  // namespace

DracoPost dracoPost(const Post& post, DracoMethod method, int bits) {
  draco::Mesh mesh;
  mesh.set_num_points(kPostVertices);
  for (std::size_t i = 0; i < post.indices.size(); i += 3) {
    draco::Mesh::Face face;
    for (std::size_t k = 0; k < 3; ++k) face[k] = draco::PointIndex(post.indices[i + k]);
    mesh.AddFace(face);
  }
  addDracoAttribute(mesh, draco::GeometryAttribute::POSITION, draco::DT_FLOAT32, 3, post.positions);
  addDracoAttribute(mesh, draco::GeometryAttribute::GENERIC, draco::DT_UINT8, 4, post.joints);
  addDracoAttribute(mesh, draco::GeometryAttribute::GENERIC, draco::DT_FLOAT32, 4, post.weights);
  draco::ExpertEncoder encoder(mesh);
  encoder.SetEncodingMethod(method == DracoMethod::kSequential ? draco::MESH_SEQUENTIAL_ENCODING
                                                               : draco::MESH_EDGEBREAKER_ENCODING);
  for (const int attribute : {0, 2}) {
    if (bits > 0) encoder.SetAttributeQuantization(attribute, bits);
  }
  encoder.SetTrackEncodedProperties(true);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeToBuffer(&buffer).ok());
  return {std::string(buffer.data(), buffer.size()), static_cast<int>(encoder.num_encoded_points()),
          static_cast<int>(encoder.num_encoded_faces())};
}

void useDraco(Post& post, const DracoPost& mesh) {
  requireExtension(post, kDracoName);
  ordered_json& compressed = post.primitive()["extensions"][kDracoName];
  compressed["bufferView"] = post.file.view(mesh.bytes);
  compressed["attributes"] = {{"POSITION", 0}, {"JOINTS_0", 1}, {"WEIGHTS_0", 2}};
  for (const char* part : {"POSITION", "JOINTS_0", "WEIGHTS_0", "indices"}) {
    ordered_json& accessor = accessorOfPart(post, part);
    accessor.erase("bufferView");
    accessor["count"] = std::string(part) == "indices" ? 3 * mesh.triangles : mesh.vertices;
  }
}

ordered_json& dracoOf(Post& post) { return post.primitive()["extensions"][kDracoName]; }

std::string meshoptAttributes(const void* values, std::size_t count, std::size_t stride) {
  std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(count, stride));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), values, count, stride));
  return {bytes.begin(), bytes.end()};
}

std::string meshoptTriangles(const std::vector<std::uint32_t>& indices) {
  std::vector<unsigned char> bytes(meshopt_encodeIndexBufferBound(indices.size(), indices.size()));
  bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), indices.data(), indices.size()));
  return {bytes.begin(), bytes.end()};
}

std::string meshoptIndices(const std::vector<std::uint32_t>& indices) {
  std::vector<unsigned char> bytes(meshopt_encodeIndexSequenceBound(indices.size(), indices.size()));
  bytes.resize(meshopt_encodeIndexSequence(bytes.data(), bytes.size(), indices.data(), indices.size()));
  return {bytes.begin(), bytes.end()};
}

void useMeshopt(Post& post, int view, const std::string& bytes, const ordered_json& settings) {
  requireExtension(post, kMeshoptName);
  ordered_json& root = post.file.json;
  const auto own = static_cast<std::size_t>(post.file.view(bytes));
  const ordered_json range = root["bufferViews"][own];
  if (root["buffers"].size() == 1) {
    root["buffers"].push_back({{"byteLength", 65536}, {"extensions", {{kMeshoptName, {{"fallback", true}}}}}});
  }
  ordered_json& to = root["bufferViews"][static_cast<std::size_t>(view)];
  to["buffer"] = 1;
  to["byteOffset"] = 0;
  to["byteLength"] = settings["count"].get<std::size_t>() * settings["byteStride"].get<std::size_t>();
  ordered_json& compressed = to["extensions"][kMeshoptName];
  compressed = settings;
  for (const char* key : {"buffer", "byteOffset", "byteLength"}) compressed[key] = range[key];
}

ordered_json& meshoptOf(Post& post, int view) {
  return post.file.json["bufferViews"][static_cast<std::size_t>(view)]["extensions"][kMeshoptName];
}

int viewOfPart(Post& post, const std::string& part) { return accessorOfPart(post, part)["bufferView"].get<int>(); }

Post meshoptPost(bool trianglesAsIndices) {
  Post post = makePost();
  const std::size_t views = post.file.json["bufferViews"].size();
  const int indices = viewOfPart(post, "indices");
  for (std::size_t view = 0; view < views; ++view) {
    const int number = static_cast<int>(view);
    if (number == indices) continue;
    const ordered_json range = post.file.json["bufferViews"][view];
    const std::string bytes =
        post.file.binary().substr(range["byteOffset"].get<std::size_t>(), range["byteLength"].get<std::size_t>());
    const std::size_t count = bytes.size() / 4;  // All have elements of a multiple of four bytes.
    useMeshopt(post, number, meshoptAttributes(bytes.data(), count, 4),
               {{"mode", "ATTRIBUTES"}, {"count", count}, {"byteStride", 4}});
  }
  const std::vector<std::uint32_t> corners(post.indices.begin(), post.indices.end());
  useMeshopt(post, indices, trianglesAsIndices ? meshoptIndices(corners) : meshoptTriangles(corners),
             {{"mode", trianglesAsIndices ? "INDICES" : "TRIANGLES"}, {"count", corners.size()}, {"byteStride", 2}});
  return post;
}

}  // namespace sinew::test
