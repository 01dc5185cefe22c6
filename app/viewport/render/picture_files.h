// app/viewport/render/picture_files.h: .png files, and moving pictures.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/viewport/render/viewport.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

/// A .png file; the same bytes for the same picture. Without alpha if opaque. Error: out of memory.
[[nodiscard]] Result<std::string> pngBytes(const Image& image);

/// Whether the extension is .webp, .gif or .mp4, in any case.
[[nodiscard]] bool isMovieName(const std::filesystem::path& file);

/// Error: .gif and .mp4 need ffmpeg, which is not installed.
[[nodiscard]] Result<void> checkMovieName(const std::filesystem::path& file);

/// A moving picture being written.
class Movie {
 public:
  virtual ~Movie() = default;
  virtual Result<void> add(const Image& image) = 0;  ///< All pictures have the size of the first.
  virtual Result<void> finish() = 0;                 ///< Writes the file atomically.
};

/// @param file  passed checkMovieName()  @param picturesPerSecond  > 0
[[nodiscard]] std::unique_ptr<Movie> makeMovie(const std::filesystem::path& file, double picturesPerSecond);

}  // namespace sinew::app
