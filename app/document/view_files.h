// app/document/view_files.h: how each file was last looked at, kept beside the user's other state and never in the
// file.
//
// One small JSON file for each rig or character, named after its path: two editors write different files, or the later
// one of the same.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "core/files/json/json.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

inline constexpr std::size_t kMostViews = 200;

/// $XDG_STATE_HOME/sinew/views, else views/ beside the preferences. Need not exist.
[[nodiscard]] std::filesystem::path viewsFolder();

/// What was kept for a rig or character; nullopt if there is nothing, or nothing that can be read.
[[nodiscard]] std::optional<Json> loadView(const std::filesystem::path& folder, const std::filesystem::path& file);

/// Atomic; makes the folder. Views that were written longest ago go when there are more than kMostViews.
[[nodiscard]] Result<void> storeView(const std::filesystem::path& folder, const std::filesystem::path& file,
                                     const Json& view);

}  // namespace sinew::app
