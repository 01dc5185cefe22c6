// app/ui/name_texture.h: letters of names in the font texture, beside the scripts that the fonts begin with.
#pragma once

#include <set>
#include <string_view>
#include <utility>

#include "app/ui/fonts.h"
#include "app/ui/letter_faces.h"

namespace sinew::app {

/// The letters are known when a document opens; others come with what is typed or shown. The texture is built again
/// with them.
class NameTexture {
 public:
  /// Letters that are shown from now on; those that the texture has do not matter.
  void want(std::u32string_view letters);
  void setRegion(HanRegion region);
  /// Whether build() would add or change a letter.
  [[nodiscard]] bool outdated() const { return outdated_; }
  /// Builds the atlas of the current ImGui context, to which the fonts were added, with all letters that were wanted.
  void build(const Fonts& fonts);

  /// Whether an installed font has it.
  [[nodiscard]] bool has(char32_t c);

 private:
  LetterFaces faces_;
  std::set<std::pair<int, char32_t>> wanted_;  ///< By ImGui's number of the font that lacks it.
  bool outdated_ = false;
};

}  // namespace sinew::app
