// core/io/surface_glb.cpp: a surface as binary glTF 2.0: one node, one mesh, a primitive per material.
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <map>
#include <span>

#include "core/io/json/json.h"
#include "core/io/surface_formats.h"

namespace sinew {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little endian, as the machine");

// Constants of glTF 2.0.
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kVertexData = 34962;
constexpr int kIndexData = 34963;
constexpr int kNearest = 9728;
constexpr int kLinear = 9729;
constexpr int kLinearMipmapLinear = 9987;
constexpr std::array<int, 3> kWrap{10497, 33071, 33648};  // In TextureWrap's order.
constexpr std::uint32_t kGlbMagic = 0x46546C67;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

Json vector(std::span<const float> values) {
  Json array = Json::array();
  for (const float value : values) array.push(static_cast<double>(value));
  return array;
}

/// The file in the making: its JSON and its one buffer.
class GlbWriter {
 public:
  GlbWriter(const Surface& surface, const Character& character)
      : surface_(surface), character_(character), materials_(usedMaterials(surface, character)) {}

  Result<std::string> write() {
    writeMaterials();
    writeMesh();
    Json node = Json::object();
    if (!character_.name.empty()) node.set("name", character_.name);
    Json root = Json::object();
    root.set("asset", Json::object().set("version", "2.0").set("generator", "Sinew"));
    root.set("scene", 0);
    root.set("scenes", Json::array().push(Json::object().set("nodes", Json::array().push(0))));
    root.set("nodes", Json::array().push(node.set("mesh", 0)));
    root.set("meshes", Json::array().push(Json::object().set("primitives", primitives_)));
    root.set("materials", materialList_);
    if (!textureNumber_.empty()) {
      root.set("textures", textureList_).set("samplers", samplerList_).set("images", imageList_);
    }
    root.set("accessors", accessors_).set("bufferViews", views_);
    root.set("buffers", Json::array().push(Json::object().set("byteLength", static_cast<long long>(buffer_.size()))));
    return assemble(root.dump());
  }

 private:
  int addView(const void* bytes, std::size_t count, int target) {
    buffer_.append((4 - buffer_.size() % 4) % 4, '\0');
    Json view = Json::object();
    view.set("buffer", 0);
    view.set("byteOffset", static_cast<long long>(buffer_.size()));
    view.set("byteLength", static_cast<long long>(count));
    if (target != 0) view.set("target", target);
    views_.push(view);
    buffer_.append(static_cast<const char*>(bytes), count);
    return viewCount_++;
  }

  int addAccessor(int view, int componentType, std::size_t count, const char* type, const Bounds* bounds = nullptr) {
    Json accessor = Json::object();
    accessor.set("bufferView", view).set("componentType", componentType);
    accessor.set("count", static_cast<long long>(count)).set("type", type);
    if (bounds) {
      accessor.set("min", vector(std::array{bounds->low.x, bounds->low.y, bounds->low.z}));
      accessor.set("max", vector(std::array{bounds->high.x, bounds->high.y, bounds->high.z}));
    }
    accessors_.push(accessor);
    return accessorCount_++;
  }

  template <class Value>
  int addVertexData(const std::vector<Value>& values, const char* type, const Bounds* bounds = nullptr) {
    return addAccessor(addView(values.data(), values.size() * sizeof(Value), kVertexData), kFloat, values.size(), type,
                       bounds);
  }

  void writeTexture(const Texture& texture) {
    const ImageFile file = imageFile(texture);
    Json image = Json::object();
    if (!texture.name.empty()) image.set("name", texture.name);
    imageList_.push(
        image.set("bufferView", addView(file.bytes.data(), file.bytes.size(), 0)).set("mimeType", file.mimeType));
    Json sampler = Json::object();
    sampler.set("magFilter", texture.nearest ? kNearest : kLinear);
    sampler.set("minFilter", texture.nearest ? kNearest : kLinearMipmapLinear);
    sampler.set("wrapS", kWrap[static_cast<std::size_t>(texture.wrapU)]);
    sampler.set("wrapT", kWrap[static_cast<std::size_t>(texture.wrapV)]);
    samplerList_.push(sampler);
    const int number = static_cast<int>(textureNumber_.size());
    textureList_.push(Json::object().set("sampler", number).set("source", number));
  }

  Json materialJson(const Material& material) const {
    Json shading = Json::object();
    const glm::vec4 color = glm::clamp(material.baseColor, 0.0f, 1.0f);
    shading.set("baseColorFactor", vector(std::array{color.r, color.g, color.b, color.a}));
    if (material.baseColorTexture >= 0) {
      shading.set("baseColorTexture", Json::object().set("index", textureNumber_.at(material.baseColorTexture)));
    }
    shading.set("metallicFactor", std::clamp(material.metallic, 0.0f, 1.0f));
    shading.set("roughnessFactor", std::clamp(material.roughness, 0.0f, 1.0f));
    Json json = Json::object();
    if (!material.name.empty()) json.set("name", material.name);
    json.set("pbrMetallicRoughness", shading);
    const glm::vec3 emissive = glm::clamp(material.emissive, 0.0f, 1.0f);
    if (emissive != glm::vec3(0.0f)) json.set("emissiveFactor", vector(std::array{emissive.r, emissive.g, emissive.b}));
    if (material.alphaMode == AlphaMode::kBlend) json.set("alphaMode", "BLEND");
    if (material.alphaMode == AlphaMode::kMask) {
      json.set("alphaMode", "MASK").set("alphaCutoff", std::max(material.alphaCutoff, 0.0f));
    }
    if (material.doubleSided) json.set("doubleSided", true);
    return json;
  }

  void writeMaterials() {
    for (const int texture : usedTextures(materials_, character_)) {
      writeTexture(character_.textures[static_cast<std::size_t>(texture)]);
      const int number = static_cast<int>(textureNumber_.size());
      textureNumber_[texture] = number;
    }
    for (const int material : materials_) {
      materialList_.push(materialJson(character_.materials[static_cast<std::size_t>(material)]));
    }
  }

  Json writeAttributes() {
    const Refinement& refinement = *surface_.refinement;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    for (std::size_t d = 0; d < refinement.drawVertex.size(); ++d) {
      positions.push_back(surface_.positions[static_cast<std::size_t>(refinement.drawVertex[d])]);
      normals.push_back(shadingNormal(surface_, d));
    }
    const Bounds bounds = boundsOf(positions);
    Json attributes = Json::object();
    attributes.set("POSITION", addVertexData(positions, "VEC3", &bounds));
    attributes.set("NORMAL", addVertexData(normals, "VEC3"));
    attributes.set("TEXCOORD_0", addVertexData(refinement.drawUv, "VEC2"));
    return attributes;
  }

  void writeMesh() {
    const auto& triangles = surface_.refinement->drawTriangles;
    const Json attributes = writeAttributes();
    const std::vector<MaterialRun> runs = materialRuns(surface_, character_);
    for (std::size_t m = 0; m < materials_.size(); ++m) {
      std::vector<std::array<std::uint32_t, 3>> own;
      for (const MaterialRun& run : runs) {
        if (run.material != materials_[m]) continue;
        own.insert(own.end(), triangles.begin() + static_cast<std::ptrdiff_t>(run.begin),
                   triangles.begin() + static_cast<std::ptrdiff_t>(run.end));
      }
      const int view = addView(own.data(), own.size() * sizeof(own[0]), kIndexData);
      Json primitive = Json::object();
      primitive.set("attributes", attributes);
      primitive.set("indices", addAccessor(view, kUnsignedInt, own.size() * 3, "SCALAR"));
      primitives_.push(primitive.set("material", static_cast<int>(m)));
    }
  }

  Result<std::string> assemble(std::string json) {
    json.append((4 - json.size() % 4) % 4, ' ');
    buffer_.append((4 - buffer_.size() % 4) % 4, '\0');
    const std::size_t total = 12 + 8 + json.size() + 8 + buffer_.size();
    if (total > std::numeric_limits<std::uint32_t>::max()) {
      return errorAt({}, "the surface needs " + std::to_string(total) +
                             " bytes, a .glb holds at most 4 GiB; "
                             "choose a smaller depth or another format");
    }
    std::string file;
    file.reserve(total);
    const auto append = [&file](std::uint32_t word) {
      std::array<char, sizeof(word)> bytes{};
      std::memcpy(bytes.data(), &word, sizeof(word));
      file.append(bytes.data(), bytes.size());
    };
    append(kGlbMagic);
    append(2);
    append(static_cast<std::uint32_t>(total));
    append(static_cast<std::uint32_t>(json.size()));
    append(kJsonChunk);
    file += json;
    append(static_cast<std::uint32_t>(buffer_.size()));
    append(kBinaryChunk);
    file += buffer_;
    return file;
  }

  const Surface& surface_;
  const Character& character_;
  std::vector<int> materials_;
  std::map<int, int> textureNumber_;  // Of the character -> of the file.
  std::string buffer_;
  int viewCount_ = 0;
  int accessorCount_ = 0;
  Json views_ = Json::array();
  Json accessors_ = Json::array();
  Json imageList_ = Json::array();
  Json samplerList_ = Json::array();
  Json textureList_ = Json::array();
  Json materialList_ = Json::array();
  Json primitives_ = Json::array();
};

}  // namespace

Result<std::string> glbBytes(const Surface& surface, const Character& character) {
  return GlbWriter(surface, character).write();
}

}  // namespace sinew
