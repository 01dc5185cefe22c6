// core/files/gltf/rules.cpp: the table of glTF 2.0's members (the part of its schema that is read).

#include "core/files/gltf/rules.h"

#include <array>
#include <limits>

#include "sinew/files/gltf_import.h"

namespace sinew::gltf {

namespace {

constexpr std::uint64_t kMaxInt = std::numeric_limits<int>::max();

constexpr Rule boolean(std::string_view key) { return {.key = key, .type = Type::kBoolean}; }
constexpr Rule number(std::string_view key) { return {.key = key, .type = Type::kNumber}; }
constexpr Rule numbers(std::string_view key, std::uint64_t size) {
  return {.key = key, .type = Type::kNumbers, .limit = size};
}
constexpr Rule text(std::string_view key) { return {.key = key, .type = Type::kText}; }
constexpr Rule whole(std::string_view key) { return {.key = key, .type = Type::kWhole, .limit = kMaxWhole}; }
/// tinygltf keeps it as an int; larger values have no meaning.
constexpr Rule wholeInt(std::string_view key) { return {.key = key, .type = Type::kWhole, .limit = kMaxInt}; }
constexpr Rule index(std::string_view key, std::string_view list) {
  return {.key = key, .type = Type::kIndex, .list = list};
}
constexpr Rule marker(std::string_view key) { return {.key = key, .type = Type::kMarker}; }
constexpr Rule object(std::string_view key, std::span<const Rule> members) {
  return {.key = key, .type = Type::kObject, .members = members};
}
constexpr Rule list(std::string_view key, const Rule& element) {
  return {.key = key, .type = Type::kList, .element = &element};
}

constexpr Rule kAnything{};
constexpr Rule kAnyText = text("");
constexpr Rule kNodeIndex = index("", "nodes");
constexpr Rule kWeight = number("");  // of a morph target

constexpr std::array kAssetMembers{text("version")};
constexpr Rule kAsset = object("asset", kAssetMembers);

// Bytes. Buffers (see File::openBuffers) and strides that tinygltf would refuse are hidden from it.
constexpr std::array kBufferMembers{whole("byteLength").required(), text("uri")};
constexpr Rule kBuffer = object("", kBufferMembers);
constexpr std::array kViewMembers{index("buffer", "buffers").required(), whole("byteOffset"),
                                  whole("byteLength").required(), whole("byteStride").keptAside()};
constexpr Rule kView = object("", kViewMembers);

constexpr std::array kSparseIndexMembers{Rule{.key = "componentType", .type = Type::kComponentType}.required(),
                                         index("bufferView", "bufferViews").required(), wholeInt("byteOffset")};
constexpr std::array kSparseValueMembers{index("bufferView", "bufferViews").required(), wholeInt("byteOffset")};
constexpr std::array kSparseMembers{wholeInt("count").required(), object("indices", kSparseIndexMembers).required(),
                                    object("values", kSparseValueMembers).required()};
constexpr std::array kAccessorMembers{Rule{.key = "type", .type = Type::kShape}.required(),
                                      Rule{.key = "componentType", .type = Type::kComponentType}.required(),
                                      boolean("normalized"),
                                      whole("count").required(),
                                      index("bufferView", "bufferViews"),
                                      whole("byteOffset"),
                                      object("sparse", kSparseMembers)};
constexpr Rule kAccessor =
    object("", kAccessorMembers).checkedWhenUsed(R"({"type":"SCALAR","componentType":5126,"count":0})");

// The scene.
constexpr std::array kNodeMembers{text("name"),          index("mesh", "meshes"),      index("skin", "skins"),
                                  numbers("matrix", 16), numbers("translation", 3),    numbers("rotation", 4),
                                  numbers("scale", 3),   list("children", kNodeIndex), list("weights", kWeight)};
constexpr Rule kNode = object("", kNodeMembers).checkedWhenUsed("{}");
constexpr std::array kSceneMembers{list("nodes", kNodeIndex)};
constexpr Rule kScene = object("", kSceneMembers).checkedWhenUsed("{}");
constexpr std::array kSkinMembers{list("joints", kNodeIndex).orElse("[]"),
                                  index("inverseBindMatrices", "accessors").orElse("-1")};
constexpr Rule kSkin = object("", kSkinMembers).checkedWhenUsed(R"({"joints":[],"inverseBindMatrices":-1})");

// Meshes. tinygltf refuses indices without a bufferView, so they are hidden from it.
constexpr std::array kMorphMembers{index("POSITION", "accessors").checkedWhenUsed("-1")};
constexpr Rule kTarget = object("", kMorphMembers).checkedWhenUsed(R"({"POSITION":-1})");
constexpr std::array kPrimitiveMembers{wholeInt("mode"), list("targets", kTarget),
                                       Rule{.key = "attributes", .type = Type::kAttributes}.orElse("{}"),
                                       index("material", "materials"), index("indices", "accessors").keptAside()};
constexpr Rule kPrimitive = object("", kPrimitiveMembers).checkedWhenUsed(R"({"attributes":{}})");
constexpr std::array kMeshMembers{text("name"), list("primitives", kPrimitive), list("weights", kWeight)};
constexpr Rule kMesh = object("", kMeshMembers).checkedWhenUsed("{}");

// Materials. tinygltf would read even unused images, so they are hidden from it.
constexpr std::array kImageMembers{index("bufferView", "bufferViews"), text("uri"), text("name")};
constexpr Rule kImage = object("", kImageMembers).checkedWhenUsed("{}");
constexpr std::array kSamplerMembers{wholeInt("wrapS"), wholeInt("wrapT"), wholeInt("magFilter")};
constexpr Rule kSampler = object("", kSamplerMembers).checkedWhenUsed("{}");
constexpr std::array kWebp{index("source", "images")};
constexpr std::array kTextureExtensions{object("EXT_texture_webp", kWebp)};
constexpr std::array kTextureMembers{index("source", "images"), index("sampler", "samplers"),
                                     object("extensions", kTextureExtensions)};
constexpr Rule kTexture = object("", kTextureMembers).checkedWhenUsed("{}");
constexpr std::array kUvTransform{numbers("offset", 2), numbers("scale", 2), number("rotation"), wholeInt("texCoord")};
constexpr std::array kTextureInfoExtensions{object("KHR_texture_transform", kUvTransform)};
constexpr std::array kTextureInfo{wholeInt("texCoord"), object("extensions", kTextureInfoExtensions),
                                  index("index", "textures").required()};
constexpr std::array kNormalInfo{number("scale"), wholeInt("texCoord"), object("extensions", kTextureInfoExtensions),
                                 index("index", "textures").required()};
constexpr std::array kOcclusionInfo{number("strength"), wholeInt("texCoord"),
                                    object("extensions", kTextureInfoExtensions),
                                    index("index", "textures").required()};
constexpr std::array kGlossiness{numbers("diffuseFactor", 4), number("glossinessFactor"),
                                 object("diffuseTexture", kTextureInfo), marker("specularGlossinessTexture")};
constexpr std::array kEmissiveStrength{number("emissiveStrength")};
constexpr std::array kMaterialExtensions{object("KHR_materials_pbrSpecularGlossiness", kGlossiness),
                                         object("KHR_materials_emissive_strength", kEmissiveStrength),
                                         marker("KHR_materials_unlit")};
constexpr std::array kMetallicRoughness{numbers("baseColorFactor", 4), number("metallicFactor"),
                                        number("roughnessFactor"), object("baseColorTexture", kTextureInfo),
                                        object("metallicRoughnessTexture", kTextureInfo)};
constexpr std::array kMaterialMembers{text("name"),
                                      object("extensions", kMaterialExtensions),
                                      object("pbrMetallicRoughness", kMetallicRoughness).checkedWhenUsed("{}"),
                                      object("emissiveTexture", kTextureInfo),
                                      numbers("emissiveFactor", 3),
                                      text("alphaMode"),
                                      number("alphaCutoff"),
                                      boolean("doubleSided"),
                                      object("normalTexture", kNormalInfo),
                                      object("occlusionTexture", kOcclusionInfo)};
constexpr Rule kMaterial = object("", kMaterialMembers).checkedWhenUsed("{}");

// Animations. tinygltf drops channels and refuses files where one of these is absent, so absence becomes -1.
constexpr std::array kTargetMembers{text("path").orElse("\"\""), index("node", "nodes").checkedWhenUsed("-1")};
constexpr std::array kChannelMembers{object("target", kTargetMembers), wholeInt("sampler").checkedWhenUsed("-1")};
constexpr Rule kChannel = object("", kChannelMembers).checkedWhenUsed(R"({"sampler":-1})");
constexpr std::array kKeyMembers{text("interpolation"), index("input", "accessors").orElse("-1"),
                                 index("output", "accessors").orElse("-1")};
constexpr Rule kKeys = object("", kKeyMembers).checkedWhenUsed(R"({"input":-1,"output":-1})");
constexpr std::array kAnimationMembers{text("name"), list("channels", kChannel), list("samplers", kKeys)};
constexpr Rule kAnimation = object("", kAnimationMembers).checkedWhenUsed("{}");

constexpr std::array kLightMembers{list("lights", kAnything).keptAside()};  // Noted, not read.
constexpr std::array kFileExtensions{object("KHR_lights_punctual", kLightMembers)};

constexpr std::array kFile{list("buffers", kBuffer).keptAside(),
                           list("bufferViews", kView),
                           list("extensionsRequired", kAnyText),
                           list("extensionsUsed", kAnyText),
                           list("cameras", kAnything).keptAside(),
                           object("extensions", kFileExtensions),
                           list("accessors", kAccessor),
                           list("nodes", kNode).atMost(200'000, "more than 200,000 nodes"),
                           list("scenes", kScene),
                           index("scene", "scenes").checkedWhenUsed("-1"),
                           list("skins", kSkin),
                           list("meshes", kMesh),
                           list("images", kImage).keptAside(),
                           list("samplers", kSampler),
                           list("textures", kTexture),
                           list("materials", kMaterial).atMost(65536, "more than 65536 materials"),
                           list("animations", kAnimation).atMost(kMaxClips, "more than 1000 clips")};

}  // namespace

const Rule& assetRule() { return kAsset; }
std::span<const Rule> fileRules() { return kFile; }

}  // namespace sinew::gltf
