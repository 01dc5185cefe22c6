// app/viewport/render/movie.h: pictures of a job as one moving picture.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/viewport/render/viewport.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

/// Whether the name has an ending of a moving picture: .webp, .gif, .mp4; capitals too.
[[nodiscard]] bool isMovieName(const std::filesystem::path& file);

/// Before the work. Error: .gif and .mp4 need ffmpeg, which is not there.
[[nodiscard]] Result<void> checkMovieName(const std::filesystem::path& file);

/// A moving picture in the making.
class Movie {
 public:
  virtual ~Movie() = default;
  /// All pictures are as large as the first.
  virtual Result<void> add(const Image& image) = 0;
  /// The file appears whole. Without it none does.
  virtual Result<void> finish() = 0;
};

/// @param picturesPerSecond  at which it plays, > 0  @param file  checkMovieName()
[[nodiscard]] std::unique_ptr<Movie> makeMovie(const std::filesystem::path& file, double picturesPerSecond);

}  // namespace sinew::app
