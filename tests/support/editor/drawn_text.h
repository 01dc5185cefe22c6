// tests/support/editor/drawn_text.h: text drawn by ImGui, read from its triangles.
#pragma once

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace sinew::app {

/// A letter on the screen.
struct Glyph {
  ImVec4 box;        ///< x0, y0, x1, y1 in window coordinates, as drawn.
  ImVec4 clip;       ///< Clip rectangle.
  std::string list;  ///< The window it belongs to.
  ImVec2 uv;         ///< Of its upper left corner in the atlas: which letter it is.
};

/// Visible letters of the frame that ImGui::Render() has ended. Icons and frames have no texture, so every textured
/// quad is a letter.
inline std::vector<Glyph> drawnGlyphs() {
  std::vector<Glyph> glyphs;
  const ImDrawData& data = *ImGui::GetDrawData();
  const ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  const auto textured = [&](const ImDrawVert& v) { return v.uv.x != atlas.TexUvWhitePixel.x; };
  // Lines have texture coordinates too, in the rows that the atlas keeps for them.
  const auto ofLine = [&](const ImDrawVert& a, const ImDrawVert& b) {
    return std::ranges::any_of(atlas.TexUvLines, [&](const ImVec4& row) { return row.x == a.uv.x || row.z == b.uv.x; });
  };
  for (int l = 0; l < data.CmdListsCount; ++l) {
    const ImDrawList& list = *data.CmdLists[l];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      for (unsigned i = 0; i + 5 < command.ElemCount; i += 3) {
        const ImDrawIdx* index = &list.IdxBuffer[static_cast<int>(command.IdxOffset + i)];
        // A letter is the triangles 0 1 2 and 0 2 3.
        if (index[1] != index[0] + 1 || index[2] != index[0] + 2 || index[3] != index[0] || index[4] != index[0] + 2 ||
            index[5] != index[0] + 3) {
          continue;
        }
        const auto vertex = [&](int k) { return list.VtxBuffer[static_cast<int>(command.VtxOffset + index[0]) + k]; };
        const ImDrawVert a = vertex(0);
        const ImDrawVert c = vertex(2);
        if (!textured(a) || !textured(c) || a.uv.x == c.uv.x || a.uv.y == c.uv.y || ofLine(a, c)) continue;
        const ImVec4& clip = command.ClipRect;
        if (c.pos.x <= clip.x || c.pos.y <= clip.y || a.pos.x >= clip.z || a.pos.y >= clip.w) continue;
        glyphs.push_back({{a.pos.x, a.pos.y, c.pos.x, c.pos.y}, clip, list._OwnerName ? list._OwnerName : "", a.uv});
      }
    }
  }
  return glyphs;
}

/// The letters inside a box of a window as text, from left to right; for boxes of one line.
inline std::string textIn(const std::vector<Glyph>& glyphs, const std::string& window, const ImVec4& box) {
  struct Letter {
    float pen;
    float end;
    char letter;
  };
  std::vector<Letter> line;
  const ImFont& font = *ImGui::GetIO().Fonts->Fonts[0];
  for (const Glyph& glyph : glyphs) {
    const float x = 0.5f * (glyph.box.x + glyph.box.z);
    const float y = 0.5f * (glyph.box.y + glyph.box.w);
    if (glyph.list != window || x < box.x || x > box.z || y < box.y || y > box.w) continue;
    const auto* const found = std::ranges::find_if(
        font.Glyphs, [&](const ImFontGlyph& each) { return each.U0 == glyph.uv.x && each.V0 == glyph.uv.y; });
    if (found == font.Glyphs.end() || found->Codepoint > 127) continue;
    const float scale = (glyph.box.z - glyph.box.x) / (found->X1 - found->X0);
    const float pen = glyph.box.x - scale * found->X0;
    line.push_back({pen, pen + scale * found->AdvanceX, static_cast<char>(found->Codepoint)});
  }
  std::ranges::stable_sort(line, {}, &Letter::pen);
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0 && line[i].pen - line[i - 1].end > 2.0f) text += ' ';
    text += line[i].letter;
  }
  return text;
}

/// Fraction of the smaller of two letters that the other covers.
inline float covered(const Glyph& a, const Glyph& b) {
  const float x = std::min(a.box.z, b.box.z) - std::max(a.box.x, b.box.x);
  const float y = std::min(a.box.w, b.box.w) - std::max(a.box.y, b.box.y);
  if (x <= 0.0f || y <= 0.0f) return 0.0f;
  const auto area = [](const ImVec4& box) { return (box.z - box.x) * (box.w - box.y); };
  return x * y / std::max(std::min(area(a.box), area(b.box)), 1e-3f);
}

}  // namespace sinew::app
