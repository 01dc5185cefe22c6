// core/files/gltf/file.h: an opened glTF file: guarded JSON, read by tinygltf, and its bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tiny_gltf.h>

#include "core/files/gltf/glb.h"
#include "core/files/gltf/guard.h"
#include "core/files/gltf/unpack.h"
#include "core/files/json/json.h"
#include "sinew/geometry/result.h"

namespace sinew::gltf {

/// Humanoid bones and expressions of a .vrm file 1.0 (VRMC_vrm) or 0.x (VRM); else empty. Only indices are checked.
struct Vrm {
  struct HumanBone {
    std::string name;  ///< "leftUpperArm"
    int node = -1;
  };
  struct Bind {
    int node = -1;  ///< 1.0
    int mesh = -1;  ///< 0.x: all nodes that show it.
    int target = 0;
    float weight = 1.0f;
  };
  struct Expression {
    std::string name;
    std::vector<Bind> binds;
  };
  std::vector<HumanBone> bones;
  std::vector<Expression> expressions;
};

[[nodiscard]] bool isDataUri(std::string_view uri);  ///< Whether it starts with "data:", ignoring case.

/// The relative path of a uri, percent-decoded once; the disk is not checked. Error: absolute, with a scheme, "..", a
/// backslash or a control character, or empty.
[[nodiscard]] Result<std::filesystem::path> relativePathOf(std::string_view uri);

/// The real path of folder/relative, links followed; nullopt if it is outside the folder or does not exist.
[[nodiscard]] std::optional<std::filesystem::path> placeInside(const std::filesystem::path& folder,
                                                               const std::filesystem::path& relative);

/// An encoded image, in a buffer of the file or in `own`.
struct EncodedImage {
  Bytes bytes;
  std::vector<std::uint8_t> own;
};

/// A whole file. Throws Refusal.
[[nodiscard]] std::vector<std::uint8_t> contentsOf(const std::filesystem::path& path);
/// Base folder for uris of buffers and images.
[[nodiscard]] std::filesystem::path folderOf(const std::filesystem::path& path);
/// The JSON of a container, without members named `leftOut` outside elements of the list `keptIn`. Throws Refusal.
[[nodiscard]] Json parseJson(std::string_view text, std::string_view leftOut, std::string_view keptIn = {});

/// A .glb or .gltf. Opening checks every uri of buffers and images: only data: uris and files inside the file's own
/// folder are allowed. Compressed views and meshes are decoded; model() has plain ones. Refuses with the JSON path or
/// byte.
class File {
 public:
  explicit File(const std::filesystem::path& path);
  /// Parses contents. @param folder  from folderOf()
  File(std::vector<std::uint8_t> contents, std::filesystem::path folder);

  /// Types, ranges and indices are sound except where expectSound refuses; absent indices are -1.
  [[nodiscard]] const tinygltf::Model& model() const { return model_; }
  /// Call before using any element of a list and any value that rules.h calls checkedWhenUsed.
  void expectSound(const std::string& place) const { guarded_.expectSound(place); }
  /// meshes[mesh].extras.targetNames; "" for non-strings.
  [[nodiscard]] const std::vector<std::string>& targetNames(int mesh) const {
    return targetNames_[static_cast<std::size_t>(mesh)];
  }
  [[nodiscard]] const Vrm& vrm() const { return vrm_; }
  [[nodiscard]] std::size_t cameras() const { return cameras_; }
  [[nodiscard]] std::size_t lights() const { return lights_; }

  /// Decoded bytes of the model's bufferViews[index]. Refuses a buffer without bytes.
  [[nodiscard]] Bytes bufferView(std::size_t index) const;
  [[nodiscard]] const Unpacked& unpacked() const { return unpacked_; }
  [[nodiscard]] Result<EncodedImage> encodedImage(std::size_t index);  ///< Error: cannot be read; reason only.

 private:
  void parse(const std::string& text);
  void adopt(const Json& root);
  void openBuffers(const Json& list, std::vector<std::uint8_t> file, const Container& container);
  void checkViews() const;
  [[nodiscard]] Bytes bytesOf(std::size_t buffer) const;
  [[nodiscard]] Result<std::vector<std::uint8_t>> read(const std::string& uri, const std::string& place);
  [[nodiscard]] Result<std::vector<std::uint8_t>> readSibling(const std::string& uri, const std::string& place);

  std::filesystem::path folder_;
  Guarded guarded_;
  tinygltf::Model model_;
  std::vector<bool> hasBytes_;                         // [buffers]
  std::vector<std::vector<std::string>> targetNames_;  // [meshes]
  Unpacked unpacked_;
  Vrm vrm_;
  std::size_t cameras_ = 0;
  std::size_t lights_ = 0;
  std::uintmax_t siblingBytes_ = 0;
};

}  // namespace sinew::gltf
