// app/ui/late_letters.h: letters that no one could know beforehand, drawn into the font texture when they are first
// seen.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "app/ui/fonts.h"
#include "app/ui/glyph_sheet.h"
#include "app/ui/letter_faces.h"

struct ImDrawData;
struct ImDrawVert;
struct ImFont;
struct ImFontGlyph;

namespace sinew::app {

/// The fonts begin with a few scripts. Every other code point has a glyph whose texture coordinates lie outside of the
/// texture and say which it is. Whatever draws text, such quads are in what ImGui hands over at the end of a frame:
/// there they become the letter, in a part of the texture that is kept free for that.
class LateLetters {
 public:
  /// Pixels of a rectangle of the texture, RGBA, row by row.
  using Upload = std::function<void(const glm::ivec4& rectangle, std::span<const std::uint32_t> pixels)>;

  /// Before the atlas is built, after the fonts were added: keeps a part of it free.
  void reserve(float scale);
  /// After it is built; again after every building. Fonts may be the same.
  void attach(const Fonts& fonts);
  /// Of what is drawn from now on.
  void setRegion(HanRegion region);
  /// After ImGui::Render(), before it is drawn. @return whether another frame is wanted, as letters had other widths
  /// than was thought, or are still to come
  [[nodiscard]] bool fill(ImDrawData& data, const Upload& upload);

  [[nodiscard]] bool has(char32_t c);
  /// Grows when places in the texture get another content.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

 private:
  struct Slot {
    ImFont* font;
    char32_t letter;
  };

  [[nodiscard]] bool fillQuad(std::span<ImDrawVert, 4> quad, const Upload& upload);
  [[nodiscard]] bool load(const Slot& slot, const Upload& upload);
  void forget();
  [[nodiscard]] bool isStrong(const ImFont* font) const { return font == fonts_.strong && font != fonts_.body; }

  LetterFaces faces_;
  Fonts fonts_;
  std::vector<ImFont*> each_;  ///< Every font once.
  int area_ = -1;              ///< ImGui's number of the part that is kept free.
  glm::ivec2 corner_{0};
  GlyphSheet sheet_;
  std::vector<Slot> loaded_;
  long long frame_ = 0;
  long long forgotAt_ = -1'000'000;
  std::uint64_t revision_ = 0;
};

}  // namespace sinew::app
