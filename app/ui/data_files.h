// app/ui/data_files.h: where the program's own files (shaders, assets) lie.
#pragma once

#include <filesystem>

namespace sinew::app {

/// A file that ships with the program, by its path in the source tree ("shaders/surface.vert"). Looked for in the
/// folder SINEW_DATA_DIR (environment) names, then ../share/sinew of the executable's folder (an installed program),
/// the source tree, the configured data folder, and beside the executable. The first that exists; if none does, the
/// path in the first place looked at, for the message.
[[nodiscard]] std::filesystem::path dataFile(const std::filesystem::path& relative);

/// Where the pages of the documentation lie: share/doc/sinew/docs of an installed program, else docs of the source
/// tree;
/// "" if they are nowhere.
[[nodiscard]] std::filesystem::path pagesFolder();

/// Folder of the running program; empty if the system does not tell.
[[nodiscard]] std::filesystem::path executableFolder();

}  // namespace sinew::app
