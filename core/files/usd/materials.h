// core/files/usd/materials.h: glTF's materials as UsdPreviewSurface, their images as files beside the .usda.
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/files/gltf/file.h"
#include "core/files/json/json.h"
#include "core/files/surface_formats.h"
#include "core/files/usd/meshes.h"
#include "core/files/usd/text.h"

namespace sinew::usd {

/// Those that meshes have. Images are taken over byte for byte where they are PNG or JPEG; of WebP a PNG is made.
class Materials {
 public:
  /// @param root  the file's JSON, of which images are read by `file`  @param stem  images are called STEM_N.png
  Materials(gltf::File& file, const Json& root, std::span<const Mesh> meshes, std::string stem,
            std::set<std::string>& left);

  /// A scope of them below the prim of that path; nothing where no mesh has one.
  void write(const std::string& above, Text& text);
  /// Lines that bind a mesh to its material.
  void bind(const Mesh& mesh, const std::string& above, Text& text) const;

  [[nodiscard]] glm::vec4 factorOf(const Mesh& mesh) const;
  [[nodiscard]] bool isDoubleSided(const Mesh& mesh) const;
  [[nodiscard]] std::vector<SideFile> takeTextures() && { return std::move(textures_); }

 private:
  /// A value, or a texture's channels where the material has one.
  struct Input {
    std::string declaration;  ///< "color3f inputs:diffuseColor"
    std::string value;
    const char* shader;   ///< Name of the texture's prim.
    const char* output;   ///< "float3 outputs:rgb"
    const Json* texture;  ///< glTF's textureInfo, or null.
    bool color;           ///< sRGB.
    glm::vec4 scale;
    glm::vec4 bias;
  };

  [[nodiscard]] const Json& material(int number) const;
  [[nodiscard]] std::string scopeOf(int number, const std::string& above) const;
  void writeMaterial(int number, const std::string& path, Text& text);
  [[nodiscard]] std::vector<Input> inputsOf(const Json& material) const;
  std::string writeTransform(const Input& input, const std::string& path, Text& text);
  /// Name of the file beside, "" for none that can be shown.
  std::string fileOf(const Json& textureInfo);
  ImageFile imageOf(int image);

  gltf::File& file_;
  const Json& root_;
  std::string stem_;
  std::set<std::string>& left_;
  std::map<int, std::string> names_;  // of materials in use: identifiers
  std::set<int> colored_;             // of which every mesh has vertex colors
  std::map<int, std::string> files_;  // by image
  std::vector<SideFile> textures_;
};

}  // namespace sinew::usd
