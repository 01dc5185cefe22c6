// core/io/gltf/material.cpp: the part of glTF's materials that Sinew draws.

#include "core/io/gltf/material.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <tuple>

#include "core/io/gltf/image.h"

namespace sinew::gltf {
namespace {

constexpr std::size_t kMostPixels = 96U << 20;         // of all textures: 384 MiB as RGBA
constexpr std::size_t kMostEncodedBytes = 256U << 20;  // kept for export
constexpr std::size_t kMostMaterials = 65536;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

float unitNumber(const Field& field, double fallback) {
  return static_cast<float>(std::clamp(field.number(fallback), 0.0, 1.0));
}

TextureWrap wrapOf(const Field& field) {
  switch (field.count(10497)) {
    case 33071:
      return TextureWrap::kClampToEdge;
    case 33648:
      return TextureWrap::kMirroredRepeat;
    default:
      return TextureWrap::kRepeat;
  }
}

class MaterialReader {
 public:
  MaterialReader(File& file, Notes& notes) : file_(file), root_(file.root()), notes_(notes) {}

  Materials run() && {
    const Field list = root_.member("materials");
    if (list.size() > kMostMaterials) refuse(list.place(), "more than 65536 materials");
    for (std::size_t i = 0; i < list.size(); ++i) read(list.item(i), i);
    return std::move(result_);
  }

 private:
  void read(const Field& field, std::size_t number) {
    Material material;
    UvSource uv;
    material.name = std::string(field.member("name").text(""));
    if (material.name.empty()) material.name = "material " + std::to_string(number);
    const Field glossiness = field.member("extensions").member("KHR_materials_pbrSpecularGlossiness");
    if (glossiness.exists()) readGlossiness(glossiness, material, uv);
    else readMetallic(field.member("pbrMetallicRoughness"), material, uv);
    if (field.member("extensions").member("KHR_materials_unlit").exists()) {
      material.metallic = 0.0f;
      material.roughness = 1.0f;
    }
    readEmissive(field, material);
    readAlpha(field, material);
    material.doubleSided = field.member("doubleSided").boolean(false);
    for (const char* unused : {"normalTexture", "occlusionTexture"}) {
      if (field.member(unused).exists()) notes_.add(std::string("materials: ") + unused + " is not drawn");
    }
    result_.materials.push_back(std::move(material));
    result_.uvSources.push_back(uv);
  }

  void readMetallic(const Field& pbr, Material& material, UvSource& uv) {
    readColor(pbr.member("baseColorFactor"), material);
    material.metallic = unitNumber(pbr.member("metallicFactor"), 1.0);
    material.roughness = unitNumber(pbr.member("roughnessFactor"), 1.0);
    material.baseColorTexture = readTexture(pbr.member("baseColorTexture"), uv);
    if (pbr.member("metallicRoughnessTexture").exists()) {
      // The factors only scale the texture; alone they would turn skin into chrome.
      material.metallic = 0.0f;
      notes_.add("materials: metallicRoughnessTexture is not drawn");
    }
  }

  void readGlossiness(const Field& glossiness, Material& material, UvSource& uv) {
    readColor(glossiness.member("diffuseFactor"), material);
    material.metallic = 0.0f;
    material.roughness = 1.0f - unitNumber(glossiness.member("glossinessFactor"), 1.0);
    material.baseColorTexture = readTexture(glossiness.member("diffuseTexture"), uv);
    if (glossiness.member("specularGlossinessTexture").exists()) {
      material.roughness = 1.0f;
      notes_.add("materials: specularGlossinessTexture is not drawn");
    }
  }

  static void readColor(const Field& field, Material& material) {
    std::array<double, 4> color{1.0, 1.0, 1.0, 1.0};
    field.numbers(color);
    for (int i = 0; i < 4; ++i) material.baseColor[i] = static_cast<float>(std::clamp(color[at(i)], 0.0, 1.0));
  }

  void readEmissive(const Field& field, Material& material) {
    if (field.member("emissiveTexture").exists()) {
      notes_.add("materials: emissiveTexture is not drawn");
      return;
    }
    std::array<double, 3> color{0.0, 0.0, 0.0};
    field.member("emissiveFactor").numbers(color);
    for (int i = 0; i < 3; ++i) material.emissive[i] = static_cast<float>(std::clamp(color[at(i)], 0.0, 1.0));
  }

  void readAlpha(const Field& field, Material& material) {
    const std::string_view mode = field.member("alphaMode").text("OPAQUE");
    if (mode == "MASK") material.alphaMode = AlphaMode::kMask;
    else if (mode == "BLEND") material.alphaMode = AlphaMode::kBlend;
    else if (mode != "OPAQUE") refuse(field.member("alphaMode").place(), "expected OPAQUE, MASK or BLEND");
    material.alphaCutoff = unitNumber(field.member("alphaCutoff"), 0.5);
  }

  /// Index into the result's textures, or -1.
  int readTexture(const Field& info, UvSource& uv) {
    if (!info.exists()) return -1;
    uv.set = static_cast<int>(std::min<std::uint64_t>(info.member("texCoord").count(0), 1U << 20));
    readTransform(info.member("extensions").member("KHR_texture_transform"), uv);
    const Field textures = root_.member("textures");
    const Field texture = textures.item(at(info.member("index").requiredIndex(textures.size(), "texture")));
    const Field images = root_.member("images");
    const std::optional<int> image = texture.member("source").index(images.size(), "image");
    if (!image) {
      notes_.add(texture.place() + ": has no PNG or JPEG source; drawn without");
      return -1;
    }
    const std::optional<int> sampler = texture.member("sampler").index(root_.member("samplers").size(), "sampler");
    const Texture settings = readSampler(sampler);
    const auto key = std::tuple(*image, settings.wrapU, settings.wrapV, settings.nearest);
    const auto known = known_.find(key);
    return known != known_.end() ? known->second : known_[key] = makeTexture(*image, settings);
  }

  /// Rotation about the origin, counter-clockwise in uv, then offset (KHR_texture_transform).
  static void readTransform(const Field& field, UvSource& uv) {
    if (!field.exists()) return;
    std::array<double, 2> offset{0.0, 0.0};
    std::array<double, 2> scale{1.0, 1.0};
    field.member("offset").numbers(offset);
    field.member("scale").numbers(scale);
    const double angle = field.member("rotation").number(0.0);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    uv.transform = {c * scale[0], s * scale[1], offset[0], -s * scale[0], c * scale[1], offset[1]};
    if (field.member("texCoord").exists()) {
      uv.set = static_cast<int>(std::min<std::uint64_t>(field.member("texCoord").count(0), 1U << 20));
    }
  }

  Texture readSampler(std::optional<int> index) const {
    Texture settings;
    if (!index) return settings;
    const Field sampler = root_.member("samplers").item(at(*index));
    settings.wrapU = wrapOf(sampler.member("wrapS"));
    settings.wrapV = wrapOf(sampler.member("wrapT"));
    settings.nearest = sampler.member("magFilter").count(9729) == 9728;
    return settings;
  }

  int makeTexture(int number, Texture texture) {
    const Field field = root_.member("images").item(at(number));
    const auto leaveOut = [&](const std::string& why) {
      notes_.add(field.place() + ": " + why + "; drawn without");
      return -1;
    };
    std::string why = "has neither uri nor bufferView";
    const std::optional<SharedBytes> encoded = imageBytes(field, why);
    if (!encoded) return leaveOut(why);
    if (encoded->bytes.size() > kMostEncodedBytes - encodedBytes_) return leaveOut("the images are too large together");
    Result<Image> image = decodeImage(encoded->bytes, kMostPixels - pixels_);
    if (!image) return leaveOut(image.error().reason);
    texture.name = std::string(field.member("name").text(""));
    if (texture.name.empty()) texture.name = "image " + std::to_string(number);
    texture.width = image->width;
    texture.height = image->height;
    texture.rgba = std::move(image.value().rgba);
    texture.mimeType = image->mimeType;
    texture.encoded.assign(encoded->bytes.begin(), encoded->bytes.end());
    pixels_ += texture.rgba.size() / 4;
    encodedBytes_ += texture.encoded.size();
    result_.textures.push_back(std::move(texture));
    return static_cast<int>(result_.textures.size()) - 1;
  }

  std::optional<SharedBytes> imageBytes(const Field& field, std::string& why) {
    if (const auto view = field.member("bufferView").index(file_.bufferViewCount(), "bufferView")) {
      return SharedBytes{nullptr, file_.bufferView(at(*view))};
    }
    if (!field.member("uri").exists()) return std::nullopt;
    return file_.read(field.member("uri"), why);
  }

  File& file_;
  const Field root_;
  Notes& notes_;
  std::map<std::tuple<int, TextureWrap, TextureWrap, bool>, int> known_;
  std::size_t pixels_ = 0;
  std::size_t encodedBytes_ = 0;
  Materials result_;
};

}  // namespace

glm::vec2 UvSource::apply(double u, double v) const {
  return {static_cast<float>(transform[0] * u + transform[1] * v + transform[2]),
          static_cast<float>(transform[3] * u + transform[4] * v + transform[5])};
}

Materials readMaterials(File& file, Notes& notes) { return MaterialReader(file, notes).run(); }

}  // namespace sinew::gltf
