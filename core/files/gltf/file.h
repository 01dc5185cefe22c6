// core/files/gltf/file.h: an opened glTF file: guarded JSON, read by tinygltf, and the bytes behind it.
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
#include "core/files/gltf/vrm.h"
#include "sinew/geometry/result.h"

namespace sinew::gltf {

// What a glTF uri may name.

/// Whether it starts with "data:", in any case of letters.
[[nodiscard]] bool isDataUri(std::string_view uri);

/// The bytes of a data: uri, base64 or percent-encoded. Error: reason only.
[[nodiscard]] Result<std::vector<std::uint8_t>> decodeDataUri(std::string_view uri);

/// The relative path a uri names, percent-decoded once. Error: absolute, with a scheme, with "..", a backslash or a
/// control character, or empty. Says nothing about the disk.
[[nodiscard]] Result<std::filesystem::path> relativePathOf(std::string_view uri);

/// The real place of folder/relative, symbolic links followed; nullopt if that lies outside the folder or is not there.
[[nodiscard]] std::optional<std::filesystem::path> placeInside(const std::filesystem::path& folder,
                                                               const std::filesystem::path& relative);

/// An image still encoded: in a buffer of the file, or its own.
struct EncodedImage {
  Bytes bytes;
  std::vector<std::uint8_t> own;
};

/// A whole file. Throws Refusal.
[[nodiscard]] std::vector<std::uint8_t> contentsOf(const std::filesystem::path& path);
/// Where the uris of buffers and images begin.
[[nodiscard]] std::filesystem::path folderOf(const std::filesystem::path& path);
/// The JSON of a container, but for members called `leftOut` outside the elements of the list `keptIn`. Throws Refusal.
[[nodiscard]] Json parseJson(std::string_view text, std::string_view leftOut, std::string_view keptIn = {});

/// A .glb or .gltf. Every uri of buffers and images is checked when it is opened: data: uris and files inside the
/// file's own folder, nothing else. Compressed views and meshes are decoded; model() has plain ones in their place.
/// Refuses with the JSON path or byte.
class File {
 public:
  explicit File(const std::filesystem::path& path);
  /// The same, read already. @param folder  as folderOf() gives it
  File(std::vector<std::uint8_t> contents, std::filesystem::path folder);

  /// Types, ranges and indices in it are sound, except in what expectSound refuses; absent indices are -1.
  [[nodiscard]] const tinygltf::Model& model() const { return model_; }
  /// To be asked for every element of a list, and every value that rules.h calls checkedWhenUsed, before it is used.
  void expectSound(const std::string& place) const { guarded_.expectSound(place); }
  /// meshes[mesh].extras.targetNames; "" for what is no string.
  [[nodiscard]] const std::vector<std::string>& targetNames(int mesh) const {
    return targetNames_[static_cast<std::size_t>(mesh)];
  }
  [[nodiscard]] const Vrm& vrm() const { return vrm_; }
  [[nodiscard]] std::size_t cameras() const { return cameras_; }
  [[nodiscard]] std::size_t lights() const { return lights_; }

  /// Bytes of the model's bufferViews[index], decoded, checked against its buffer. Refuses where the buffer has none.
  [[nodiscard]] Bytes bufferView(std::size_t index) const;
  [[nodiscard]] const Unpacked& unpacked() const { return unpacked_; }
  /// Error: reason only, if it cannot be read.
  [[nodiscard]] Result<EncodedImage> encodedImage(std::size_t index);

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
