// core/io/gltf/file.h: the bytes behind a glTF file: container, JSON, buffers, sibling files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/gltf/json.h"

namespace sinew::gltf {

using Bytes = std::span<const std::uint8_t>;

/// Bytes that keep what they lie in alive.
struct SharedBytes {
  std::shared_ptr<const std::string> owner;
  Bytes bytes;
};

/// An opened .glb or .gltf (told apart by content). Every uri of buffers and images is checked when it is opened: data:
/// uris and files inside the file's own folder, nothing else. Refuses with the JSON path or byte.
class File {
 public:
  explicit File(const std::filesystem::path& path);

  [[nodiscard]] Field root() const { return {json_.get(), ""}; }
  /// Bytes of bufferViews[index], checked against its buffer. Refuses where the buffer has no bytes.
  [[nodiscard]] Bytes bufferView(std::size_t index) const;
  [[nodiscard]] std::size_t bufferViewStride(std::size_t index) const { return views_[index].stride; }
  [[nodiscard]] std::size_t bufferViewCount() const { return views_.size(); }
  /// What a uri stands for. nullopt: the sibling file cannot be read, `why` says so.
  [[nodiscard]] std::optional<SharedBytes> read(const Field& uri, std::string& why);

 private:
  struct View {
    int buffer = 0;
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
    std::size_t stride = 0;  // 0: tightly packed
  };

  [[nodiscard]] std::string_view openContainer();
  void checkUris() const;
  void openBuffers();
  void openViews();
  [[nodiscard]] std::optional<SharedBytes> readSibling(const Field& uri, std::string& why);

  std::filesystem::path folder_;
  std::shared_ptr<const std::string> contents_;
  Bytes binaryChunk_;
  bool hasBinaryChunk_ = false;
  std::shared_ptr<const nlohmann::json> json_;
  std::vector<SharedBytes> buffers_;
  std::vector<View> views_;
  std::vector<std::pair<std::filesystem::path, SharedBytes>> siblings_;  // each read once
  std::uintmax_t siblingBytes_ = 0;
};

}  // namespace sinew::gltf
