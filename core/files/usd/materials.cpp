// core/files/usd/materials.cpp: shading networks: surface <- textures <- texture coordinates.
#include "core/files/usd/materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/files/gltf/material.h"
#include "core/geometry/at.h"

namespace sinew::usd {
namespace {

constexpr int kClamp = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
constexpr int kMirror = TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT;
constexpr std::size_t kMostPixels = static_cast<std::size_t>(gltf::kMaxImageSide) * gltf::kMaxImageSide;  // of an image

float numberIn(const Json& object, std::string_view name, double otherwise) {
  return static_cast<float>(object.at(name).number(otherwise));
}

template <int N>
glm::vec<N, float> vectorIn(const Json& object, std::string_view name, float otherwise) {
  glm::vec<N, float> result(otherwise);
  const std::vector<Json>& items = object.at(name).items();
  for (int i = 0; i < N && i < static_cast<int>(items.size()); ++i) {
    result[i] = static_cast<float>(sinew::at(items, i).number(static_cast<double>(otherwise)));
  }
  return result;
}

/// Element of one of the root's lists, or a null value.
const Json& elementOf(const Json& root, std::string_view list, const Json& index) {
  static const Json kNone;
  const std::vector<Json>& items = root.at(list).items();
  const double number = index.number(-1.0);
  return number >= 0.0 && number < static_cast<double>(items.size()) ? items[static_cast<std::size_t>(number)] : kNone;
}

std::string wrapOf(const Json& sampler, const char* axis) {
  const double mode = sampler.at(axis).number(0.0);
  return quoted(mode == kClamp ? "clamp" : mode == kMirror ? "mirror" : "repeat");
}

void openShader(const std::string& name, const char* id, Text& text) {
  text.open("def Shader \"" + name + '"');
  text.line("uniform token info:id = \"" + std::string(id) + '"');
}

}  // namespace

Materials::Materials(gltf::File& file, const Json& root, std::span<const Mesh> meshes, std::string stem,
                     std::set<std::string>& left)
    : file_(file), root_(root), stem_(std::move(stem)), left_(left) {
  // Brackets and @ have a meaning in asset paths of USD.
  for (char& c : stem_) {
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7f || std::string_view("@[]:\\").find(c) != std::string::npos) {
      c = '_';
    }
  }
  std::set<int> plain;
  for (const Mesh& mesh : meshes) {
    if (mesh.material < 0) continue;
    names_.try_emplace(mesh.material);
    (mesh.colors.empty() ? plain : colored_).insert(mesh.material);
  }
  for (const int number : plain) colored_.erase(number);
  Siblings siblings;
  for (auto& [number, name] : names_) {
    name = siblings.fresh(identifierOf(material(number).at("name").text(""), "Material"));
  }
}

const Json& Materials::material(int number) const { return elementOf(root_, "materials", Json(number)); }

std::string Materials::scopeOf(int number, const std::string& above) const {
  return above + "/Materials/" + names_.at(number);
}

glm::vec4 Materials::factorOf(const Mesh& mesh) const {
  if (mesh.material < 0) return glm::vec4(1.0f);
  const Json& pbr = material(mesh.material).at("pbrMetallicRoughness");
  return vectorIn<4>(pbr, "baseColorFactor", 1.0f);
}

bool Materials::isDoubleSided(const Mesh& mesh) const {
  return mesh.material >= 0 && material(mesh.material).at("doubleSided").boolean(false);
}

void Materials::bind(const Mesh& mesh, const std::string& above, Text& text) const {
  if (mesh.material >= 0) text.attribute("rel material:binding", '<' + scopeOf(mesh.material, above) + '>');
}

void Materials::write(const std::string& above, Text& text) {
  if (names_.empty()) return;
  text.open("def Scope \"Materials\"");
  for (const auto& [number, name] : names_) writeMaterial(number, scopeOf(number, above), text);
  text.close();
}

std::vector<Materials::Input> Materials::inputsOf(const Json& material) const {
  static constexpr glm::vec4 kOne{1.0f};
  static constexpr glm::vec4 kZero{0.0f};
  const Json& glossy = material.at("extensions").at("KHR_materials_pbrSpecularGlossiness");
  const bool isGlossy = glossy.kind == Json::Kind::kObject;
  const Json& pbr = isGlossy ? glossy : material.at("pbrMetallicRoughness");
  const auto color = vectorIn<4>(pbr, isGlossy ? "diffuseFactor" : "baseColorFactor", 1.0f);
  const Json* base = pbr.find(isGlossy ? "diffuseTexture" : "baseColorTexture");
  const float metallic = isGlossy ? 0.0f : numberIn(pbr, "metallicFactor", 1.0);
  const float roughness =
      isGlossy ? 1.0f - numberIn(pbr, "glossinessFactor", 1.0) : numberIn(pbr, "roughnessFactor", 1.0);
  const Json* rough = isGlossy ? nullptr : pbr.find("metallicRoughnessTexture");
  const auto glow = vectorIn<3>(material, "emissiveFactor", 0.0f);
  const Json* normal = material.find("normalTexture");
  const Json* dark = material.find("occlusionTexture");
  const std::string alpha = material.at("alphaMode").text("OPAQUE");
  std::vector<Input> inputs{{"color3f inputs:diffuseColor", tupleText(glm::vec3(color)), "BaseColor",
                             "float3 outputs:rgb", base, true, color, kZero},
                            {"float inputs:metallic", numberText(metallic), "MetallicRoughness", "float outputs:b",
                             rough, false, glm::vec4(1.0f, roughness, metallic, 1.0f), kZero},
                            {"float inputs:roughness", numberText(roughness), "MetallicRoughness", "float outputs:g",
                             rough, false, glm::vec4(1.0f, roughness, metallic, 1.0f), kZero},
                            {"color3f inputs:emissiveColor", tupleText(glow), "Emissive", "float3 outputs:rgb",
                             material.find("emissiveTexture"), true, glm::vec4(glow, 1.0f), kZero}};
  if (alpha == "MASK" || alpha == "BLEND") {
    inputs.push_back(
        {"float inputs:opacity", numberText(color.a), "BaseColor", "float outputs:a", base, true, color, kZero});
  }
  if (alpha == "MASK") {
    inputs.push_back({"float inputs:opacityThreshold", numberText(numberIn(material, "alphaCutoff", 0.5)), "", "",
                      nullptr, false, kOne, kZero});
  }
  if (normal) {
    const float strength = numberIn(*normal, "scale", 1.0);
    inputs.push_back({"normal3f inputs:normal",
                      {},
                      "Normal",
                      "float3 outputs:rgb",
                      normal,
                      false,
                      glm::vec4(2.0f * strength, 2.0f * strength, 2.0f, 1.0f),
                      glm::vec4(-strength, -strength, -1.0f, 0.0f)});
  }
  if (dark) {
    const float strength = numberIn(*dark, "strength", 1.0);
    inputs.push_back({"float inputs:occlusion",
                      {},
                      "Occlusion",
                      "float outputs:r",
                      dark,
                      false,
                      glm::vec4(strength, 1.0f, 1.0f, 1.0f),
                      glm::vec4(1.0f - strength, 0.0f, 0.0f, 0.0f)});
  }
  return inputs;
}

void Materials::writeMaterial(int number, const std::string& path, Text& text) {
  const Json& from = material(number);
  const std::string& name = names_.at(number);
  text.open("def Material \"" + name + '"', displayName(from.at("name").text(""), name));
  text.attribute("token outputs:surface.connect", '<' + path + "/Surface.outputs:surface>");
  struct Prim {
    Input input;
    std::string file;
    std::set<std::string> outputs;
  };
  std::map<std::string, Prim> textures;  // by name of the prim
  openShader("Surface", "UsdPreviewSurface", text);
  const std::vector<Input> inputs = inputsOf(from);
  const bool isColored = colored_.contains(number);
  bool readsColors = false;
  for (const Input& input : inputs) {
    const std::string file = input.texture ? fileOf(*input.texture) : std::string();
    if (!file.empty()) {
      const std::string output = input.output;
      textures.try_emplace(input.shader, Prim{input, file, {}}).first->second.outputs.insert(output);
      text.attribute(input.declaration + ".connect",
                     '<' + path + '/' + input.shader + '.' + output.substr(output.find(' ') + 1) + '>');
    } else if (isColored && &input == &inputs.front()) {
      readsColors = true;
      text.attribute(input.declaration + ".connect", '<' + path + "/VertexColor.outputs:result>");
    } else if (!input.value.empty()) {
      text.attribute(input.declaration, input.value);
    }
  }
  text.line("token outputs:surface");
  text.close();
  if (isColored && !readsColors) {
    left_.insert("vertex colours over textures: UsdPreviewSurface cannot multiply them; they are in displayColor");
  }
  if (readsColors) {
    openShader("VertexColor", "UsdPrimvarReader_float3", text);
    text.line("string inputs:varname = \"displayColor\"");
    text.line("float3 outputs:result");
    text.close();
  }
  for (const auto& [shader, prim] : textures) {
    const std::string st = writeTransform(prim.input, path, text);
    openShader(shader, "UsdUVTexture", text);
    text.attribute("asset inputs:file", '@' + prim.file + '@');
    text.attribute("float2 inputs:st.connect", '<' + st + ".outputs:result>");
    text.attribute("token inputs:sourceColorSpace", quoted(prim.input.color ? "sRGB" : "raw"));
    const Json& texture = elementOf(root_, "textures", prim.input.texture->at("index"));
    const Json& sampler = elementOf(root_, "samplers", texture.at("sampler"));
    text.attribute("token inputs:wrapS", wrapOf(sampler, "wrapS"));
    text.attribute("token inputs:wrapT", wrapOf(sampler, "wrapT"));
    text.attribute("float4 inputs:scale", tupleText(prim.input.scale));
    text.attribute("float4 inputs:bias", tupleText(prim.input.bias));
    for (const std::string& output : prim.outputs) text.line(output);
    text.close();
  }
  text.close();
}

/// The transform of glTF is for v downwards; in USD v goes upwards. Returns the path of the prim that outputs st.
std::string Materials::writeTransform(const Input& input, const std::string& path, Text& text) {
  const std::string shader = std::string(input.shader) + "_st";
  const Json& transform = input.texture->at("extensions").at("KHR_texture_transform");
  const double own = input.texture->at("texCoord").number(0.0);
  const double set = std::clamp(transform.at("texCoord").number(own), 0.0, 255.0);
  openShader(shader, "UsdPrimvarReader_float2", text);
  text.attribute("string inputs:varname", quoted(uvName(static_cast<std::size_t>(set))));
  text.line("float2 outputs:result");
  text.close();
  if (transform.kind != Json::Kind::kObject) return path + '/' + shader;
  const auto offset = vectorIn<2>(transform, "offset", 0.0f);
  const auto scale = vectorIn<2>(transform, "scale", 1.0f);
  const float angle = numberIn(transform, "rotation", 0.0);
  openShader(shader + "_transform", "UsdTransform2d", text);
  text.attribute("float2 inputs:in.connect", '<' + path + '/' + shader + ".outputs:result>");
  text.attribute("float inputs:rotation", numberText(angle * 180.0f / std::numbers::pi_v<float>));
  text.attribute("float2 inputs:scale", tupleText(scale));
  const glm::vec2 translation(offset.x + std::sin(angle) * scale.y, 1.0f - offset.y - std::cos(angle) * scale.y);
  text.attribute("float2 inputs:translation", tupleText(translation));
  text.line("float2 outputs:result");
  text.close();
  return path + '/' + shader + "_transform";
}

std::string Materials::fileOf(const Json& textureInfo) {
  const Json& texture = elementOf(root_, "textures", textureInfo.at("index"));
  const Json& webp = texture.at("extensions").at("EXT_texture_webp").at("source");
  const Json& source = webp.isNull() ? texture.at("source") : webp;
  if (elementOf(root_, "images", source).isNull()) {
    left_.insert("textures without an image that can be read");
    return {};
  }
  const auto image = static_cast<int>(source.number(0.0));
  if (const auto known = files_.find(image); known != files_.end()) return known->second;
  std::string& name = files_[image];
  ImageFile made = imageOf(image);
  if (made.bytes.empty()) {
    left_.insert("textures without an image that can be read");
    return {};
  }
  name = stem_ + '_' + std::to_string(textures_.size()) + made.ending;
  textures_.push_back({name, std::move(made.bytes)});
  return name;
}

/// Images other than PNG and JPEG become PNG. Empty without an image.
ImageFile Materials::imageOf(int image) {
  const Result<gltf::EncodedImage> encoded = file_.encodedImage(toIndex(image));
  if (!encoded) return {};
  const std::string_view bytes(reinterpret_cast<const char*>(encoded->bytes.data()), encoded->bytes.size());
  if (const std::string ending(imageEnding(encoded->bytes)); !ending.empty()) return {std::string(bytes), {}, ending};
  Result<gltf::Image> decoded = gltf::decodeImage(encoded->bytes, kMostPixels);
  if (!decoded) return {};
  Texture texture;
  texture.width = decoded->width;
  texture.height = decoded->height;
  texture.rgba = std::move(decoded.value().rgba);
  return imageFile(texture);
}

}  // namespace sinew::usd
