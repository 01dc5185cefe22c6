// app/bench/rig_or_trial.h: what is measured of a file.
#pragma once

#include <filesystem>
#include <string>

#include "app/document/document.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

/// The document's own, or one of 12 muscles made by rule where it has none.
[[nodiscard]] Rig rigOrTrial(const Document& document);

/// "fox" of both fox.glb and fox.rig.json.
[[nodiscard]] std::string sceneName(const std::filesystem::path& file);

}  // namespace sinew::app
