// core/files/surface_obj_ply.cpp: the two formats without a scene: Wavefront .obj with .mtl, and binary .ply.
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <set>

#include "core/files/surface_formats.h"
#include "core/geometry/at.h"

namespace sinew {
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

/// Nine digits tell any float from its neighbors.
void appendExact(std::string& out, const char* word, std::initializer_list<float> values) {
  appendLine(out, word, values, 9);
}

/// Colors and the like: what eight bits of a screen cannot tell is left out.
void appendRounded(std::string& out, const char* word, std::initializer_list<float> values) {
  appendLine(out, word, values, 6);
}

/// One word per used material, [materials of the character]; unused ones stay empty.
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
    // Shininess that looks about as rough (Blinn's exponent for a GGX lobe of roughness^2).
    const float roughness = std::clamp(material.roughness, 0.05f, 1.0f);
    appendRounded(out, "Ns", {std::min(2.0f / (roughness * roughness * roughness * roughness) - 2.0f, 1000.0f)});
    const bool glows = material.emissiveMap.texture < 0;  // All of it, not what a map says.
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

/// As programs that read .ply show it: sRGB, 8 bits; alpha stays linear.
std::array<std::uint8_t, 4> shownColor(const glm::vec4& linear) {
  const auto byteOf = [](float share) { return static_cast<std::uint8_t>(std::lround(255.0f * share)); };
  const auto encoded = [](float l) {
    return l <= 0.0031308f ? 12.92f * l : 1.055f * std::pow(l, 1.0f / 2.4f) - 0.055f;
  };
  return {byteOf(encoded(linear.r)), byteOf(encoded(linear.g)), byteOf(encoded(linear.b)), byteOf(linear.a)};
}

}  // namespace

// Words in these formats end at white space, and names must not start a comment.
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
