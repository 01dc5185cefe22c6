// app/ui/glyph_sheet.h: places for glyphs in a rectangle of the font texture.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace sinew::app {

/// Fills a rectangle row by row; what has been placed stays until all is cleared.
class GlyphSheet {
 public:
  explicit GlyphSheet(const glm::ivec2& size = {0, 0}) : size_(size) {}

  /// The low corner of a place of that size, a pixel apart from all others and from the sheet's low edges. None: there
  /// is no more room.
  [[nodiscard]] std::optional<glm::ivec2> place(const glm::ivec2& size);
  void clear() { rows_.clear(); }

 private:
  struct Row {
    int top;
    int height;
    int used;
  };

  glm::ivec2 size_;
  std::vector<Row> rows_;
};

}  // namespace sinew::app
