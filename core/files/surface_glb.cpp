// core/files/surface_glb.cpp: a surface as .glb (one node, one mesh, a primitive per material), .obj and .ply.
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <ostream>
#include <set>
#include <span>
#include <streambuf>
#include <string>

#include <tiny_gltf.h>
#include <glm/geometric.hpp>

#include "core/files/json/json.h"
#include "core/files/surface_formats.h"
#include "core/geometry/at.h"
#include "sinew/character/material.h"

namespace sinew {
namespace {

/// KHR_texture_transform: rotates, scales and moves u, v.
struct MapTransform {
  glm::dvec2 offset{0.0};
  double rotation = 0.0;  ///< Radians.
  glm::dvec2 scale{1.0};
};

/// nullopt: it shears, which the extension cannot express.
std::optional<MapTransform> transformOf(const TextureMap& map) {
  constexpr double kSlant = 1e-5;  // of the lengths: places are floats
  const glm::dvec2 u(map.place[0].x, map.place[1].x), v(map.place[0].y, map.place[1].y);
  if (!(std::abs(glm::dot(u, v)) <= kSlant * glm::length(u) * glm::length(v))) return std::nullopt;
  MapTransform result;
  result.offset = {map.place[0].z, map.place[1].z};
  const bool along = glm::dot(u, u) > 0.0;
  result.rotation = along ? std::atan2(-u.y, u.x) : std::atan2(v.x, v.y);
  result.scale.x = glm::length(u);
  result.scale.y = std::sin(result.rotation) * v.x + std::cos(result.rotation) * v.y;
  return result;
}

tinygltf::Value pairValue(const glm::dvec2& pair) {
  return tinygltf::Value(tinygltf::Value::Array{tinygltf::Value(pair.x), tinygltf::Value(pair.y)});
}

/// Fills one of tinygltf's three kinds of texture info. False if the map cannot be written.
template <class Info>
bool putMap(const TextureMap& map, const std::map<int, int>& textureNumber, std::set<std::string>& extensions,
            Info& info) {
  const auto transform = map.texture >= 0 ? transformOf(map) : std::nullopt;
  if (!transform) return false;
  info.index = textureNumber.at(map.texture);
  if (map.place == TextureMap{}.place) return true;
  tinygltf::Value::Object written;
  written["offset"] = pairValue(transform->offset);
  written["rotation"] = tinygltf::Value(transform->rotation);
  written["scale"] = pairValue(transform->scale);
  info.extensions["KHR_texture_transform"] = tinygltf::Value(std::move(written));
  extensions.insert("KHR_texture_transform");
  return true;
}

void putEmissive(const Material& from, bool withMap, std::set<std::string>& extensions, tinygltf::Material& to) {
  glm::vec3 color = withMap || from.emissiveMap.texture < 0 ? glm::max(from.emissive, 0.0f) : glm::vec3(0.0f);
  const float strength = std::max({color.r, color.g, color.b, 1.0f});
  color /= strength;
  to.emissiveFactor = {static_cast<double>(color.r), static_cast<double>(color.g), static_cast<double>(color.b)};
  if (!(strength > 1.0f)) return;
  tinygltf::Value::Object written;
  written["emissiveStrength"] = tinygltf::Value(static_cast<double>(strength));
  to.extensions["KHR_materials_emissive_strength"] = tinygltf::Value(std::move(written));
  extensions.insert("KHR_materials_emissive_strength");
}

/// @param textureNumber  the character's -> the file's  @param extensions  receives those in use
tinygltf::Material gltfMaterial(const Material& from, const std::map<int, int>& textureNumber,
                                std::set<std::string>& extensions) {
  tinygltf::Material material;
  tinygltf::PbrMetallicRoughness& shading = material.pbrMetallicRoughness;
  material.name = validUtf8(from.name);
  const glm::dvec4 color = glm::clamp(from.baseColor, 0.0f, 1.0f);
  shading.baseColorFactor = {color.r, color.g, color.b, color.a};
  if (from.baseColorTexture >= 0) shading.baseColorTexture.index = textureNumber.at(from.baseColorTexture);
  const bool mapped = putMap(from.metallicRoughnessMap, textureNumber, extensions, shading.metallicRoughnessTexture) ||
                      from.metallicRoughnessMap.texture < 0;
  shading.metallicFactor = mapped ? static_cast<double>(std::clamp(from.metallic, 0.0f, 1.0f)) : 0.0;
  shading.roughnessFactor = static_cast<double>(std::clamp(from.roughness, 0.0f, 1.0f));
  putEmissive(from, putMap(from.emissiveMap, textureNumber, extensions, material.emissiveTexture), extensions,
              material);
  if (putMap(from.normalMap, textureNumber, extensions, material.normalTexture)) {
    material.normalTexture.scale = static_cast<double>(from.normalScale);
  }
  if (putMap(from.occlusionMap, textureNumber, extensions, material.occlusionTexture)) {
    material.occlusionTexture.strength = static_cast<double>(from.occlusionStrength);
  }
  if (from.alphaMode == AlphaMode::kBlend) material.alphaMode = "BLEND";
  if (from.alphaMode == AlphaMode::kMask) {
    material.alphaMode = "MASK";
    material.alphaCutoff = static_cast<double>(std::max(from.alphaCutoff, 0.0f));
  }
  material.doubleSided = from.doubleSided;
  if (from.unlit) {
    material.extensions["KHR_materials_unlit"] = tinygltf::Value(tinygltf::Value::Object{});
    extensions.insert("KHR_materials_unlit");
  }
  return material;
}

static_assert(std::endian::native == std::endian::little, "glTF is little endian, as the machine");

constexpr std::size_t kMaxGlbBytes = std::numeric_limits<std::uint32_t>::max();
/// In TextureWrap's order.
constexpr std::array kWrap{TINYGLTF_TEXTURE_WRAP_REPEAT, TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE,
                           TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT};

/// Writes to a string without the copies of a string stream.
class StringBuffer : public std::streambuf {
 public:
  explicit StringBuffer(std::string& to) : to_(to) {}

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    to_.append(bytes, static_cast<std::size_t>(count));
    return count;
  }
  int_type overflow(int_type c) override {
    to_ += traits_type::to_char_type(c);
    return c;
  }

 private:
  std::string& to_;
};

template <std::size_t N>
std::vector<double> numbers(const std::array<float, N>& values) {
  return {values.begin(), values.end()};
}

Error tooLarge(std::size_t bytes) {
  return errorAt({}, "the surface needs " + std::to_string(bytes) +
                         " bytes, a .glb holds at most 4 GiB; choose a smaller depth or another format");
}

/// Builds the file. tinygltf throws at names that are not UTF-8.
class GlbWriter {
 public:
  GlbWriter(const Surface& surface, const Character& character)
      : surface_(surface), character_(character), materials_(usedMaterials(surface, character)) {
    model_.buffers.emplace_back();
  }

  Result<std::string> write() {
    model_.asset.version = "2.0";
    model_.asset.generator = "Sinew";
    writeMaterials();
    writeMesh();
    tinygltf::Node& node = model_.nodes.emplace_back();
    node.name = validUtf8(character_.name);
    node.mesh = 0;
    model_.scenes.emplace_back().nodes = {0};
    model_.defaultScene = 0;
    return assemble();
  }

 private:
  int addView(const void* bytes, std::size_t count, int target) {
    std::vector<unsigned char>& data = model_.buffers[0].data;
    data.resize((data.size() + 3) / 4 * 4);
    tinygltf::BufferView& view = model_.bufferViews.emplace_back();
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = count;
    view.target = target;
    const auto* from = static_cast<const unsigned char*>(bytes);
    data.insert(data.end(), from, from + count);
    return static_cast<int>(model_.bufferViews.size()) - 1;
  }

  int addAccessor(int view, int componentType, std::size_t count, int type, const Bounds* bounds = nullptr) {
    tinygltf::Accessor& accessor = model_.accessors.emplace_back();
    accessor.bufferView = view;
    accessor.componentType = componentType;
    accessor.count = count;
    accessor.type = type;
    if (bounds) {
      accessor.minValues = numbers(std::array{bounds->low.x, bounds->low.y, bounds->low.z});
      accessor.maxValues = numbers(std::array{bounds->high.x, bounds->high.y, bounds->high.z});
    }
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  template <class Value>
  int addVertexData(const std::vector<Value>& values, int type, const Bounds* bounds = nullptr) {
    const int view = addView(values.data(), values.size() * sizeof(Value), TINYGLTF_TARGET_ARRAY_BUFFER);
    return addAccessor(view, TINYGLTF_COMPONENT_TYPE_FLOAT, values.size(), type, bounds);
  }

  void writeTexture(const Texture& texture) {
    const ImageFile file = imageFile(texture);
    const int number = static_cast<int>(model_.textures.size());
    tinygltf::Image& image = model_.images.emplace_back();
    image.name = validUtf8(texture.name);
    image.bufferView = addView(file.bytes.data(), file.bytes.size(), 0);
    image.mimeType = file.mimeType;
    tinygltf::Sampler& sampler = model_.samplers.emplace_back();
    sampler.magFilter = texture.nearest ? TINYGLTF_TEXTURE_FILTER_NEAREST : TINYGLTF_TEXTURE_FILTER_LINEAR;
    sampler.minFilter =
        texture.nearest ? TINYGLTF_TEXTURE_FILTER_NEAREST : TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
    sampler.wrapS = kWrap[static_cast<std::size_t>(texture.wrapU)];
    sampler.wrapT = kWrap[static_cast<std::size_t>(texture.wrapV)];
    tinygltf::Texture& joined = model_.textures.emplace_back();
    joined.sampler = number;
    joined.source = number;
  }

  void writeMaterials() {
    for (const int texture : usedTextures(materials_, character_, Maps::kAll)) {
      textureNumber_[texture] = static_cast<int>(model_.textures.size());
      writeTexture(at(character_.textures, texture));
    }
    std::set<std::string> extensions;
    for (const int material : materials_) {
      model_.materials.push_back(gltfMaterial(at(character_.materials, material), textureNumber_, extensions));
    }
    model_.extensionsUsed.assign(extensions.begin(), extensions.end());
  }

  std::map<std::string, int> writeAttributes() {
    const Refinement& refinement = *surface_.refinement;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    forEachDrawVertex(refinement, [&](std::size_t d, std::size_t vertex) {
      positions.push_back(surface_.positions[vertex]);
      normals.push_back(shadingNormal(surface_, d));
    });
    const Bounds bounds = boundsOf(positions);
    const int position = addVertexData(positions, TINYGLTF_TYPE_VEC3, &bounds);
    const int normal = addVertexData(normals, TINYGLTF_TYPE_VEC3);
    const int uv = addVertexData(refinement.drawUv, TINYGLTF_TYPE_VEC2);
    std::map<std::string, int> attributes{{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}};
    if (!refinement.drawColor.empty()) {
      attributes["COLOR_0"] = addVertexData(refinement.drawColor, TINYGLTF_TYPE_VEC4);
    }
    return attributes;
  }

  void writeMesh() {
    const auto& triangles = surface_.refinement->drawTriangles;
    const std::map<std::string, int> attributes = writeAttributes();
    const std::vector<MaterialRun> runs = materialRuns(surface_, character_);
    tinygltf::Mesh& mesh = model_.meshes.emplace_back();
    for (std::size_t m = 0; m < materials_.size(); ++m) {
      std::vector<std::array<std::uint32_t, 3>> own;
      for (const MaterialRun& run : runs) {
        if (run.material != materials_[m]) continue;
        own.insert(own.end(), triangles.begin() + static_cast<std::ptrdiff_t>(run.begin),
                   triangles.begin() + static_cast<std::ptrdiff_t>(run.end));
      }
      const int view = addView(own.data(), own.size() * sizeof(own[0]), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
      tinygltf::Primitive& primitive = mesh.primitives.emplace_back();
      primitive.attributes = attributes;
      primitive.indices = addAccessor(view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, own.size() * 3, TINYGLTF_TYPE_SCALAR);
      primitive.material = static_cast<int>(m);
      primitive.mode = TINYGLTF_MODE_TRIANGLES;
    }
  }

  /// tinygltf does not check that sizes fit 32 bits.
  Result<std::string> assemble() const {
    const std::size_t bytes = model_.buffers[0].data.size();
    if (bytes > kMaxGlbBytes) return tooLarge(bytes);
    std::string file;
    file.reserve(bytes + (1U << 16));
    StringBuffer buffer(file);
    std::ostream stream(&buffer);
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model_, stream, false, true)) {
      return errorAt({}, "the surface cannot be written as glTF");
    }
    if (file.size() > kMaxGlbBytes) return tooLarge(file.size());
    return file;
  }

  const Surface& surface_;
  const Character& character_;
  std::vector<int> materials_;
  std::map<int, int> textureNumber_;  // The character's -> the file's.
  tinygltf::Model model_;
};

}  // namespace

Result<std::string> glbBytes(const Surface& surface, const Character& character) {
  return GlbWriter(surface, character).write();
}

// Wavefront .obj with .mtl, and binary .ply.

namespace {

void appendLine(std::string& out, const char* word, std::initializer_list<float> values, int digits) {
  out += word;
  for (const float value : values) {
    std::array<char, 40> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits).ptr;
    out += ' ';
    out.append(text.data(), end);
  }
  out += '\n';
}

/// Nine digits are exact for a float.
void appendExact(std::string& out, const char* word, std::initializer_list<float> values) {
  appendLine(out, word, values, 9);
}

/// For colors, which need no more than 8 bits.
void appendRounded(std::string& out, const char* word, std::initializer_list<float> values) {
  appendLine(out, word, values, 6);
}

/// [materials of the character] a unique word for each used material; empty for unused ones.
std::vector<std::string> materialWords(const std::vector<int>& used, const Character& character) {
  std::vector<std::string> words(character.materials.size());
  std::set<std::string> taken;
  for (const int material : used) {
    const auto m = toIndex(material);
    std::string word = asWord(character.materials[m].name);
    if (word.empty() || taken.contains(word)) word += (word.empty() ? "material_" : "_") + std::to_string(m);
    while (!taken.insert(word).second) word += '_';
    words[m] = word;
  }
  return words;
}

std::string mtlText(const std::vector<int>& used, const Character& character, const std::vector<std::string>& words,
                    const std::vector<std::string>& textureNames) {
  std::string out = "# Made by Sinew\n";
  for (const int index : used) {
    const Material& material = at(character.materials, index);
    out += "newmtl " + at(words, index) + '\n';
    appendRounded(out, "Kd", {material.baseColor.r, material.baseColor.g, material.baseColor.b});
    appendRounded(out, "Ks", {0.04f, 0.04f, 0.04f});
    // Blinn exponent of similar roughness to a GGX lobe of roughness^2.
    const float roughness = std::clamp(material.roughness, 0.05f, 1.0f);
    appendRounded(out, "Ns", {std::min(2.0f / (roughness * roughness * roughness * roughness) - 2.0f, 1000.0f)});
    const bool glows = material.emissiveMap.texture < 0;  // Not with a map, which .mtl lacks.
    const glm::vec3 glow = glows ? glm::clamp(material.emissive, 0.0f, 1.0f) : glm::vec3(0.0f);
    appendRounded(out, "Ke", {glow.r, glow.g, glow.b});
    const bool opaque = material.alphaMode == AlphaMode::kOpaque;
    appendRounded(out, "d", {opaque ? 1.0f : material.baseColor.a});
    out += "illum 2\n";
    if (material.baseColorTexture < 0) continue;
    const std::string& texture = at(textureNames, material.baseColorTexture);
    out += "map_Kd " + texture + '\n';
    if (!opaque) out += "map_d -imfchan m " + texture + '\n';
  }
  return out;
}

void appendFace(std::string& out, const Surface& surface, const std::array<std::uint32_t, 3>& drawn) {
  out += 'f';
  for (const std::uint32_t corner : drawn) {
    const std::string vertex = std::to_string(surface.refinement->drawVertex[corner] + 1);
    const std::string wedge = std::to_string(corner + 1);
    out += ' ' + vertex + '/' + wedge + '/' + (surface.shadingNormals.empty() ? vertex : wedge);
  }
  out += '\n';
}

std::string objText(const Surface& surface, const Character& character, const std::vector<std::string>& words,
                    const std::string& mtlName) {
  const Refinement& refinement = *surface.refinement;
  std::string out = "# Made by Sinew\nmtllib " + mtlName + '\n';
  if (!character.name.empty()) out += "o " + asWord(character.name) + '\n';
  for (const glm::vec3& p : surface.positions) appendExact(out, "v", {p.x, p.y, p.z});
  for (const glm::vec2& uv : refinement.drawUv) appendExact(out, "vt", {uv.x, 1.0f - uv.y});
  const bool creased = !surface.shadingNormals.empty();
  for (const glm::vec3& n : creased ? surface.shadingNormals : surface.normals) appendExact(out, "vn", {n.x, n.y, n.z});
  for (const MaterialRun& run : materialRuns(surface, character)) {
    out += "usemtl " + at(words, run.material) + '\n';
    for (std::size_t t = run.begin; t < run.end; ++t) appendFace(out, surface, refinement.drawTriangles[t]);
  }
  return out;
}

template <class Value>
void appendRaw(std::string& out, const Value& value) {
  static_assert(std::endian::native == std::endian::little, "files are little endian, as the machine");
  std::array<char, sizeof(Value)> bytes{};
  std::memcpy(bytes.data(), &value, sizeof(Value));
  out.append(bytes.data(), bytes.size());
}

/// sRGB of 8 bits, as programs show it; alpha stays linear.
std::array<std::uint8_t, 4> shownColor(const glm::vec4& linear) {
  const auto byteOf = [](float share) { return static_cast<std::uint8_t>(std::lround(255.0f * share)); };
  const auto encoded = [](float l) {
    return l <= 0.0031308f ? 12.92f * l : 1.055f * std::pow(l, 1.0f / 2.4f) - 0.055f;
  };
  return {byteOf(encoded(linear.r)), byteOf(encoded(linear.g)), byteOf(encoded(linear.b)), byteOf(linear.a)};
}

}  // namespace

std::string asWord(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) <= ' ' || c == '#' || c == 0x7f) c = '_';
  }
  return name;
}

ObjFiles objFiles(const Surface& surface, const Character& character, const std::string& stem) {
  ObjFiles files;
  const std::string base = asWord(stem);
  const std::vector<int> materials = usedMaterials(surface, character);
  std::vector<std::string> textureNames(character.textures.size());
  int number = 0;
  for (const int texture : usedTextures(materials, character, Maps::kBaseColor)) {
    ImageFile image = imageFile(at(character.textures, texture));
    std::string& name = at(textureNames, texture);
    name = base + '_' + std::to_string(number++) + image.ending;
    files.sides.push_back({name, std::move(image.bytes)});
  }
  const std::vector<std::string> words = materialWords(materials, character);
  files.sides.push_back({base + ".mtl", mtlText(materials, character, words, textureNames)});
  files.obj = objText(surface, character, words, files.sides.back().name);
  return files;
}

std::string plyBytes(const Surface& surface) {
  const Refinement& refinement = *surface.refinement;
  const std::size_t vertices = refinement.drawVertex.size();
  std::string out =
      "ply\nformat binary_little_endian 1.0\ncomment Made by Sinew\nelement vertex " + std::to_string(vertices) + '\n';
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "s", "t"}) {
    out += std::string("property float ") + name + '\n';
  }
  const bool colored = !refinement.drawColor.empty();
  if (colored) {
    for (const char* name : {"red", "green", "blue", "alpha"}) out += std::string("property uchar ") + name + '\n';
  }
  out += "element face " + std::to_string(refinement.drawTriangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
  out.reserve(out.size() + vertices * (8 * sizeof(float) + (colored ? 4 : 0)) + refinement.drawTriangles.size() * 13);
  forEachDrawVertex(refinement, [&](std::size_t d, std::size_t vertex) {
    const glm::vec3& p = surface.positions[vertex];
    const glm::vec3 n = shadingNormal(surface, d);
    const glm::vec2& uv = refinement.drawUv[d];
    appendRaw(out, std::array{p.x, p.y, p.z, n.x, n.y, n.z, uv.x, 1.0f - uv.y});
    if (colored) appendRaw(out, shownColor(refinement.drawColor[d]));
  });
  for (const auto& triangle : refinement.drawTriangles) {
    out += '\3';
    appendRaw(out, triangle);
  }
  return out;
}

}  // namespace sinew
