// core/files/export/gltf_rewrite.h: changes a glTF file as JSON and bytes, and packs it again.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/files/gltf/file.h"
#include "core/files/json/json.h"
#include "sinew/character/animation_clip.h"
#include "sinew/geometry/geometry.h"
#include "sinew/geometry/morph_target.h"

namespace sinew::exporting {

[[nodiscard]] Json* memberOf(Json& object, std::string_view name);  ///< Mutable member of an object, or null.
/// Member of an object, created as `empty` if absent.
[[nodiscard]] Json& ensureMember(Json& object, std::string_view name, const Json& empty);
void removeMember(Json& object, std::string_view name);

[[nodiscard]] Json numbersOf(const glm::dvec3& values);  ///< With all digits of the floats, as readers compare them.
[[nodiscard]] Json numbersOf(const std::vector<float>& values);

/// Values as bytes of the file.
template <class Value>
[[nodiscard]] std::string_view bytesOf(const std::vector<Value>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
}

struct AccessorData {
  std::string_view bytes;
  int componentType = 0;  ///< TINYGLTF_COMPONENT_TYPE_*
  std::string type;       ///< "SCALAR", "VEC3" ...
  std::size_t count = 0;
  int target = 0;                  ///< TINYGLTF_TARGET_*, 0 for none.
  std::optional<Bounds> bounds{};  ///< For positions.
};

struct PackedGltf {
  Json root;           ///< Its buffer has a byteLength but no uri.
  std::string binary;  ///< 4-byte aligned.
};

/// A file being changed. Packing removes unused accessors, bufferViews and bytes, and moves images into the buffer.
class GltfRewrite {
 public:
  GltfRewrite(Json root, gltf::File& file) : root_(std::move(root)), file_(file) {}

  [[nodiscard]] Json& root() { return root_; }
  [[nodiscard]] Json& element(std::string_view list, int index);  ///< An element of one of the root's lists.
  /// Appends to one of the root's lists, created if absent. Returns the index.
  int append(std::string_view list, Json element);
  int addAccessor(const AccessorData& data);
  /// Adds floats of a vertex attribute.
  template <class Value>
  int addAttribute(const std::vector<Value>& values, const char* type, std::optional<Bounds> bounds = {}) {
    return addAccessor({bytesOf(values), TINYGLTF_COMPONENT_TYPE_FLOAT, type, values.size(),
                        TINYGLTF_TARGET_ARRAY_BUFFER, std::move(bounds)});
  }
  int addView(std::string_view bytes, int target);  ///< @param target  TINYGLTF_TARGET_*, 0 for none
  [[nodiscard]] PackedGltf pack() &&;               ///< Throws gltf::Refusal where used bytes cannot be read.

 private:
  void takeImages();
  void dropUnused();

  Json root_;
  gltf::File& file_;
  std::vector<std::string> added_;  // bytes of added views
  std::string binary_;
};

[[nodiscard]] Result<std::string> glbOf(const PackedGltf& packed);  ///< As a .glb. Error: over 4 GiB.
/// As the text of a .gltf with its buffer in a file beside it.
[[nodiscard]] std::string gltfOf(const PackedGltf& packed, const std::string& binaryName);

// Clips of the file as JSON.

[[nodiscard]] std::string clipName(const Json& clip, int index);  ///< Name of a clip, as in the import.

/// Appends a clip. @param fileNode  [skeleton nodes]  @param targets  of the character
void addClip(const AnimationClip& clip, std::span<const int> fileNode, std::span<const MorphTarget> targets,
             GltfRewrite& rewrite);

/// Adds an accessor of key times. @param times  seconds, rising, not empty
[[nodiscard]] int addTimes(const std::vector<float>& times, GltfRewrite& rewrite);

/// Adds a linear sampler. Returns its number in the clip. @param input, output  accessors
int addSampler(int clip, int input, int output, GltfRewrite& rewrite);
/// Adds a sampler of morph weights. @param weights  [times * targets]
int addWeightSampler(int clip, const std::vector<float>& times, const std::vector<float>& weights,
                     GltfRewrite& rewrite);
/// @param sampler  of the clip  @param path  "translation", "weights" ...
void addChannel(int clip, int sampler, int node, const char* path, GltfRewrite& rewrite);

}  // namespace sinew::exporting
