// app/ui/fonts.h: the interface fonts, from Debian packages, or ImGui's own as the last resort.
#pragma once

struct ImFont;

namespace sinew::app {

/// Valid as long as the font atlas they were added to. Never null; several may be the same font.
struct Fonts {
  ImFont* body = nullptr;
  ImFont* strong = nullptr;  ///< Headings.
  ImFont* mono = nullptr;    ///< Numbers that change while one reads them.
};

/// Adds the fonts to the current ImGui context's atlas; the caller builds the atlas. @param scale 1 on ordinary
/// screens.
[[nodiscard]] Fonts loadFonts(float scale);

}  // namespace sinew::app
