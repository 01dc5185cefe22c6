// app/ui/style.h: the look of the interface: fonts, colors, spacing.
#pragma once

#include <imgui.h>

namespace sinew::app {

/// Fonts from Debian packages, else ImGui's own. Valid as long as their atlas. Never null; may be equal.
struct Fonts {
  ImFont* body = nullptr;
  ImFont* strong = nullptr;  ///< Headings.
  ImFont* mono = nullptr;    ///< Changing numbers.
};

/// Adds the fonts to the current ImGui context's atlas; the caller builds it. @param scale  1 on ordinary screens
[[nodiscard]] Fonts loadFonts(float scale);

/// A constexpr color (ImVec4 of 1.86 cannot be one) that converts to ImGui's two forms.
struct Tint {
  float r = 0.0f;
  float g = 0.0f;
  float b = 0.0f;
  float a = 1.0f;

  operator ImVec4() const { return {r, g, b, a}; }  // NOLINT: implicit on purpose
  [[nodiscard]] constexpr Tint faded(float alpha) const { return {r, g, b, alpha}; }
  [[nodiscard]] ImU32 packed() const { return ImGui::ColorConvertFloat4ToU32({r, g, b, a * ImGui::GetStyle().Alpha}); }
};

/// All colors; others are lighter or fainter variants.
namespace palette {
inline constexpr Tint kBackground{0.086f, 0.094f, 0.110f, 1.0f};
inline constexpr Tint kPanel{0.118f, 0.129f, 0.149f, 1.0f};
inline constexpr Tint kRaised{0.165f, 0.180f, 0.208f, 1.0f};
inline constexpr Tint kLine{0.220f, 0.239f, 0.275f, 1.0f};
inline constexpr Tint kText{0.890f, 0.902f, 0.922f, 1.0f};
inline constexpr Tint kMuted{0.580f, 0.612f, 0.663f, 1.0f};
inline constexpr Tint kAccent{0.929f, 0.541f, 0.376f, 1.0f};  ///< Selected or running.
inline constexpr Tint kWarning{0.949f, 0.757f, 0.361f, 1.0f};
inline constexpr Tint kError{0.937f, 0.400f, 0.400f, 1.0f};
inline constexpr Tint kGood{0.451f, 0.788f, 0.569f, 1.0f};
inline constexpr Tint kKeyed{0.918f, 0.698f, 0.176f, 1.0f};   ///< Keyed numbers, and keys.
inline constexpr Tint kDriven{0.624f, 0.502f, 0.929f, 1.0f};  ///< Driven numbers.
}  // namespace palette

/// Sets colors, spacing and rounding of the current ImGui context. @param scale 1 on ordinary screens.
void applyStyle(float scale);

}  // namespace sinew::app
