// app/command/batch_names.h: the names of a job's files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sinew/geometry/result.h"

namespace sinew::app {

/// "{name}" replaced by the input's name without folder and ending (fox of a/fox.rig.json), and %d or %0Nd by the
/// frame. Error: a frame and no such field, several, another '%', or "{name}" missing where there is a list.
[[nodiscard]] Result<std::filesystem::path> nameOfItem(const std::filesystem::path& pattern, const std::string& option,
                                                       const std::filesystem::path& input, bool listed,
                                                       std::optional<int> frame);

}  // namespace sinew::app
