// app/viewport/render/thumbnails.h: small pictures of documents as textures, read from the cache when they are first
// shown.
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

/// The middle of a picture, as large as it goes, made as small as a thumbnail: each pixel the mean of those below it.
[[nodiscard]] Image thumbnailOf(const Image& picture);
/// What a file holds; nullopt: no picture, or not of a thumbnail's size.
[[nodiscard]] std::optional<Image> readThumbnail(std::string_view png);

/// Every call needs a current OpenGL context.
class Thumbnails {
 public:
  explicit Thumbnails(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Makes the document's from a picture of it. A cache that cannot be written to is no reason to complain.
  void keep(const std::filesystem::path& document, const Image& picture);

  /// Texture of a document's, top row first; 0: there is none. Looks at the disk once for each document that stays as
  /// it is (`changed`: its own time).
  [[nodiscard]] unsigned texture(const std::filesystem::path& document, std::filesystem::file_time_type changed);

  /// Texture of a picture that is drawn when it is first asked for.
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
