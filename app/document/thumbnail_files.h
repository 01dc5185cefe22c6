// app/document/thumbnail_files.h: small pictures of documents on the disk, in the user's cache.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "sinew/geometry/result.h"

namespace sinew::app {

inline constexpr std::size_t kMostThumbnails = 400;

/// $XDG_CACHE_HOME/sinew/thumbnails, else ~/.cache/sinew/thumbnails. Need not exist.
[[nodiscard]] std::filesystem::path thumbnailFolder();

/// The file of a document as it is on the disk now: its canonical path, size and time of change give the name, so that
/// a document that was changed elsewhere has none. "": there is no such document.
[[nodiscard]] std::filesystem::path thumbnailFile(const std::filesystem::path& folder,
                                                  const std::filesystem::path& document);

/// Writes it and removes the oldest beyond kMostThumbnails. Error: the folder cannot be written to.
[[nodiscard]] Result<void> keepThumbnail(const std::filesystem::path& folder, const std::filesystem::path& document,
                                         std::string_view png);

}  // namespace sinew::app
