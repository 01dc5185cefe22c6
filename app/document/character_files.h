// app/document/character_files.h: which files are characters, by their names, and what they are called without endings.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace sinew::app {

/// Lower case. A .vrm is a .glb that says which bone is which.
inline constexpr std::array<std::string_view, 3> kCharacterEndings{".glb", ".gltf", ".vrm"};

/// @param lowerName  in lower case
[[nodiscard]] inline bool isCharacterName(std::string_view lowerName) {
  return std::ranges::any_of(kCharacterEndings, [&](std::string_view end) { return lowerName.ends_with(end); });
}

/// "fox" of "fox.rig.json", "fox.glb" ...; nullopt for other names.
[[nodiscard]] inline std::optional<std::string> withoutEnding(std::string_view name) {
  const auto stemBefore = [name](std::string_view end) {
    const bool ends = name.size() > end.size() && name.ends_with(end);
    return ends ? std::optional(std::string(name.substr(0, name.size() - end.size()))) : std::nullopt;
  };
  std::optional<std::string> stem = stemBefore(".rig.json");
  for (std::size_t i = 0; i < kCharacterEndings.size() && !stem; ++i) stem = stemBefore(kCharacterEndings[i]);
  return stem;
}

}  // namespace sinew::app
