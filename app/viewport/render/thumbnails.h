// app/viewport/render/thumbnails.h: thumbnails of documents as textures, read from the cache when first shown.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "app/viewport/render/gl_objects.h"
#include "app/viewport/render/viewport.h"

namespace sinew::app {

inline constexpr glm::ivec2 kThumbnailSize{144, 108};

[[nodiscard]] Image thumbnailOf(const Image& picture);  ///< The largest middle part of it, scaled down by averaging.
/// nullopt: not a picture, or not of a thumbnail's size.
[[nodiscard]] std::optional<Image> readThumbnail(std::string_view png);

/// Every call needs a current OpenGL context.
class Thumbnails {
 public:
  explicit Thumbnails(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Stores a document's thumbnail, made from a picture of it. Does nothing if the cache cannot be written.
  void keep(const std::filesystem::path& document, const Image& picture);

  /// Top row first; 0: none. Reads the disk once per state of the document. @param changed  the time of its last change
  [[nodiscard]] unsigned texture(const std::filesystem::path& document, std::filesystem::file_time_type changed);

  /// Texture of a picture that is drawn on first use.
  [[nodiscard]] unsigned texture(const std::string& key, const std::function<Image()>& draw);

 private:
  struct Shown {
    std::filesystem::file_time_type changed;
    GlTexture texture;
  };
  std::filesystem::path folder_;
  std::map<std::string, Shown> shown_;
  std::map<std::string, GlTexture> drawn_;
};

}  // namespace sinew::app
