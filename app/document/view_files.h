// app/document/view_files.h: the last view of each file, and thumbnails, in the user's folders.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/files/json/json.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

// Thumbnails of documents as they are on disk.

inline constexpr std::size_t kMostThumbnails = 400;

/// $XDG_CACHE_HOME/sinew/thumbnails, else ~/.cache/sinew/thumbnails. Need not exist.
[[nodiscard]] std::filesystem::path thumbnailFolder();

/// Named by the document's canonical path, size and time: a changed one has no thumbnail. "": there is no document.
[[nodiscard]] std::filesystem::path thumbnailFile(const std::filesystem::path& folder,
                                                  const std::filesystem::path& document);

/// Writes it and removes the oldest beyond kMostThumbnails.
[[nodiscard]] Result<void> keepThumbnail(const std::filesystem::path& folder, const std::filesystem::path& document,
                                         std::string_view png);

// Views: one JSON file for each rig or character, named after its path.

inline constexpr std::size_t kMostViews = 200;

/// $XDG_STATE_HOME/sinew/views, else views/ beside the preferences. Need not exist.
[[nodiscard]] std::filesystem::path viewsFolder();

/// The view kept for a rig or character; nullopt: none can be read.
[[nodiscard]] std::optional<Json> loadView(const std::filesystem::path& folder, const std::filesystem::path& file);

/// Atomic; makes the folder. Removes the oldest beyond kMostViews.
[[nodiscard]] Result<void> storeView(const std::filesystem::path& folder, const std::filesystem::path& file,
                                     const Json& view);

}  // namespace sinew::app
