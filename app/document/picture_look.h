// app/document/picture_look.h: light and background of the picture.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace sinew::app {

enum class LightPreset { kStudio, kOutdoor, kRim, kWhite };
enum class Backdrop { kStudio, kDark, kMid, kLight, kGradient, kChecker };

inline constexpr std::array kLightNames{"studio", "outdoor", "rim", "white"};
inline constexpr std::array kBackdropNames{"studio", "dark", "mid", "light", "gradient", "checker"};

struct PictureLook {
  LightPreset light = LightPreset::kStudio;
  Backdrop backdrop = Backdrop::kStudio;
  bool occlusion = false;  ///< Screen-space ambient occlusion.

  friend bool operator==(const PictureLook&, const PictureLook&) = default;
};

/// In files, on the command line and in the state log.
[[nodiscard]] inline const char* nameOf(LightPreset light) { return kLightNames[static_cast<std::size_t>(light)]; }
[[nodiscard]] inline const char* nameOf(Backdrop backdrop) {
  return kBackdropNames[static_cast<std::size_t>(backdrop)];
}

/// The enumerator of that name, or nullopt.
template <class Enum, std::size_t N>
[[nodiscard]] std::optional<Enum> lookNamed(const std::array<const char*, N>& names, std::string_view name) {
  for (std::size_t i = 0; i < N; ++i) {
    if (name == names[i]) return static_cast<Enum>(i);
  }
  return std::nullopt;
}
[[nodiscard]] inline std::optional<LightPreset> lightNamed(std::string_view name) {
  return lookNamed<LightPreset>(kLightNames, name);
}
[[nodiscard]] inline std::optional<Backdrop> backdropNamed(std::string_view name) {
  return lookNamed<Backdrop>(kBackdropNames, name);
}

}  // namespace sinew::app
