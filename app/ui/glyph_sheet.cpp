// app/ui/glyph_sheet.cpp: rows of glyphs of like heights.

#include "app/ui/glyph_sheet.h"

namespace sinew::app {
namespace {

constexpr int kGlyphsApart = 1;  // Pixels: neighbours are blended at the edges of a letter.
constexpr int kRowStep = 4;      // Heights of rows are multiples, so that few are begun.

}  // namespace

std::optional<glm::ivec2> GlyphSheet::place(const glm::ivec2& size) {
  const glm::ivec2 need = size + kGlyphsApart;
  for (Row& row : rows_) {
    if (need.y > row.height || 2 * need.y < row.height || row.used + need.x > size_.x) continue;
    const glm::ivec2 corner(row.used + kGlyphsApart, row.top + kGlyphsApart);
    row.used += need.x;
    return corner;
  }
  const int top = rows_.empty() ? 0 : rows_.back().top + rows_.back().height;
  const int height = (need.y + kRowStep - 1) / kRowStep * kRowStep;
  if (top + height > size_.y || need.x > size_.x) return std::nullopt;
  rows_.push_back({top, height, need.x});
  return glm::ivec2(kGlyphsApart, top + kGlyphsApart);
}

}  // namespace sinew::app
