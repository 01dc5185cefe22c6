// core/files/usd/materials.h: glTF materials as UsdPreviewSurface, with images as files beside the .usda.
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

/// Materials in use. PNG and JPEG images are copied; WebP becomes PNG.
class Materials {
 public:
  /// @param root  the file's JSON  @param stem  images are named STEM_N.png
  Materials(gltf::File& file, const Json& root, std::span<const Mesh> meshes, std::string stem,
            std::set<std::string>& left);

  /// Writes a scope of materials below the prim `above`, if there are any.
  void write(const std::string& above, Text& text);
  void bind(const Mesh& mesh, const std::string& above, Text& text) const;  ///< Binds a mesh to its material.

  [[nodiscard]] glm::vec4 factorOf(const Mesh& mesh) const;
  [[nodiscard]] bool isDoubleSided(const Mesh& mesh) const;
  [[nodiscard]] std::vector<SideFile> takeTextures() && { return std::move(textures_); }

 private:
  /// An input: a value, or channels of a texture.
  struct Input {
    std::string declaration;  ///< "color3f inputs:diffuseColor"
    std::string value;
    const char* shader;   ///< Prim of the texture.
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
  std::string fileOf(const Json& textureInfo);  ///< Name of the image file; "" if unreadable.
  ImageFile imageOf(int image);

  gltf::File& file_;
  const Json& root_;
  std::string stem_;
  std::set<std::string>& left_;
  std::map<int, std::string> names_;  // identifiers of materials in use
  std::set<int> colored_;             // materials with vertex colors on every mesh
  std::map<int, std::string> files_;  // by image
  std::vector<SideFile> textures_;
};

}  // namespace sinew::usd
