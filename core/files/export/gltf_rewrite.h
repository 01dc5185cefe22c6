// core/files/export/gltf_rewrite.h: a glTF file read as JSON and bytes, changed, and put together again.
#pragma once

#include <cstdint>
#include <functional>
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

// Which bytes of a view accessors refer to, and where they come to lie without the
// others.

/// Stretches of a view. They begin at multiples of 4 and keep their order, so that numbers stay aligned.
class UsedBytes {
 public:
  void add(std::uint64_t begin, std::uint64_t end);
  /// All that is used has been added. @param length  of the view
  void close(std::uint64_t length);

  /// After close(): in order, each behind the one before, with bytes between that nothing refers to.
  [[nodiscard]] const std::vector<std::pair<std::uint64_t, std::uint64_t>>& stretches() const { return stretches_; }
  /// Of all of them together.
  [[nodiscard]] std::uint64_t length() const;
  /// Where a byte that is used comes to lie.
  [[nodiscard]] std::uint64_t placeOf(std::uint64_t byte) const;

 private:
  std::vector<std::pair<std::uint64_t, std::uint64_t>> stretches_;  ///< Begin and end.
};

/// Calls visit(what names a bufferView, bytes from its byteOffset on, of the view) for all accessors and their sparse
/// parts; 0 bytes: it is not known how many.
void visitUses(Json& root, const std::function<void(Json& user, std::uint64_t bytes)>& visit);

/// Member of an object that is to be changed, or null.
[[nodiscard]] Json* memberOf(Json& object, std::string_view name);
/// Member of an object; an empty one of that kind is made where there is none.
[[nodiscard]] Json& ensureMember(Json& object, std::string_view name, const Json& empty);
void removeMember(Json& object, std::string_view name);

/// Every digit of the floats, which is what a reader compares with.
[[nodiscard]] Json numbersOf(const glm::dvec3& values);
[[nodiscard]] Json numbersOf(const std::vector<float>& values);

/// Values as they will lie in the file.
template <class Value>
[[nodiscard]] std::string_view bytesOf(const std::vector<Value>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
}

/// Numbers of a vertex attribute, of indices or matrices, as they will lie in the file.
struct AccessorData {
  std::string_view bytes;
  int componentType = 0;  ///< TINYGLTF_COMPONENT_TYPE_*
  std::string type;       ///< "SCALAR", "VEC3" ...
  std::size_t count = 0;
  int target = 0;                  ///< TINYGLTF_TARGET_*, 0 for none.
  std::optional<Bounds> bounds{};  ///< Positions have them.
};

/// What a file consists of in the end.
struct PackedGltf {
  Json root;           ///< Its one buffer has a byteLength, no uri yet.
  std::string binary;  ///< 4-byte aligned.
};

/// Accessors, bufferViews and bytes of them that nothing refers to any more are left out, and images come into the
/// buffer as they are.
class GltfRewrite {
 public:
  GltfRewrite(Json root, gltf::File& file) : root_(std::move(root)), file_(file) {}

  [[nodiscard]] Json& root() { return root_; }
  /// Element of one of the root's lists.
  [[nodiscard]] Json& element(std::string_view list, int index);
  /// Appends to one of the root's lists, which is made where it is absent. Returns its index.
  int append(std::string_view list, Json element);
  int addAccessor(const AccessorData& data);
  /// Floats of a vertex attribute, one value a vertex.
  template <class Value>
  int addAttribute(const std::vector<Value>& values, const char* type, std::optional<Bounds> bounds = {}) {
    return addAccessor({bytesOf(values), TINYGLTF_COMPONENT_TYPE_FLOAT, type, values.size(),
                        TINYGLTF_TARGET_ARRAY_BUFFER, std::move(bounds)});
  }
  /// @param target  TINYGLTF_TARGET_*, 0 for none
  int addView(std::string_view bytes, int target);
  /// Throws gltf::Refusal where bytes that are kept cannot be read.
  [[nodiscard]] PackedGltf pack() &&;

 private:
  void takeImages();
  [[nodiscard]] std::vector<UsedBytes> findUsedBytes();
  void dropUnused();

  Json root_;
  gltf::File& file_;
  std::vector<std::string> added_;  // bytes of the views beyond the file's own
  std::string binary_;
};

/// As a .glb. Error: over 4 GiB.
[[nodiscard]] Result<std::string> glbOf(const PackedGltf& packed);
/// As the text of a .gltf whose buffer lies in a file of that name beside it.
[[nodiscard]] std::string gltfOf(const PackedGltf& packed, const std::string& binaryName);

// Clips of the file as JSON: what they are called, and channels that are added to them.

/// As the import names it.
[[nodiscard]] std::string clipName(const Json& clip, int index);

/// A clip of its own at the end of the file's.
/// @param fileNode  [skeleton nodes]  @param targets  of the character
void addClip(const AnimationClip& clip, std::span<const int> fileNode, std::span<const MorphTarget> targets,
             GltfRewrite& rewrite);

/// An accessor of key times. @param times  seconds, rising, not empty
[[nodiscard]] int addTimes(const std::vector<float>& times, GltfRewrite& rewrite);

/// Linear between keys. Returns the sampler's number in the clip. @param input, output  accessors
int addSampler(int clip, int input, int output, GltfRewrite& rewrite);
/// Of weights of morph targets. @param weights  [times * targets]
int addWeightSampler(int clip, const std::vector<float>& times, const std::vector<float>& weights,
                     GltfRewrite& rewrite);
/// @param sampler  of the clip  @param path  "translation", "weights" ...
void addChannel(int clip, int sampler, int node, const char* path, GltfRewrite& rewrite);

}  // namespace sinew::exporting
