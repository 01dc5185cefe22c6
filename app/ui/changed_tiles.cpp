// app/ui/changed_tiles.cpp: a hash of the triangles in each square of the window.

#include "app/ui/changed_tiles.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include <glm/common.hpp>

namespace sinew::app {
namespace {

constexpr std::uint64_t kStart = 0x9e3779b97f4a7c15u;

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) {
  hash = (hash ^ value) * 0xff51afd7ed558ccdu;
  return hash ^ (hash >> 32);
}

std::uint64_t bitsOf(const ImVec2& v) {
  std::uint64_t bits = 0;
  static_assert(sizeof v == sizeof bits);
  std::memcpy(&bits, &v, sizeof bits);
  return bits;
}

/// A command without its triangles.
std::uint64_t hashOf(const ImDrawCmd& command, std::span<const TextureRevision> textures, std::uint64_t frame) {
  const auto id = reinterpret_cast<std::uintptr_t>(command.TextureId);
  const auto known = std::ranges::find(textures, id, &TextureRevision::texture);
  std::uint64_t hash = mixed(kStart, id);
  hash = mixed(hash, known != textures.end() ? known->revision : frame);
  hash = mixed(hash, bitsOf({command.ClipRect.x, command.ClipRect.y}));
  return mixed(hash, bitsOf({command.ClipRect.z, command.ClipRect.w}));
}

/// Joins marked tiles in a row, and equal runs in adjacent rows, into rectangles.
std::vector<glm::ivec4> rectsOf(const std::vector<bool>& marked, const glm::ivec2& tiles) {
  std::vector<glm::ivec4> done, open;  // In tiles. Open ones end at the row above.
  for (int y = 0; y < tiles.y; ++y) {
    std::vector<glm::ivec4> row;
    for (int x = 0; x < tiles.x; ++x) {
      if (!marked[static_cast<std::size_t>(y * tiles.x + x)]) continue;
      if (!row.empty() && row.back().z == x) ++row.back().z;
      else row.emplace_back(x, y, x + 1, y + 1);
    }
    for (glm::ivec4& each : row) {
      const auto above =
          std::ranges::find_if(open, [&](const glm::ivec4& o) { return o.x == each.x && o.z == each.z; });
      if (above == open.end()) continue;
      each.y = above->y;
      open.erase(above);
    }
    done.insert(done.end(), open.begin(), open.end());
    open = std::move(row);
  }
  done.insert(done.end(), open.begin(), open.end());
  return done;
}

glm::ivec4 around(const std::vector<glm::ivec4>& rects) {
  glm::ivec4 box = rects.front();
  for (const glm::ivec4& each : rects) {
    box = {std::min(box.x, each.x), std::min(box.y, each.y), std::max(box.z, each.z), std::max(box.w, each.w)};
  }
  return box;
}

/// Pixels of the backend's scissor, which truncates and counts rows from below.
glm::ivec4 scissorOf(const ImVec4& clip, const ImDrawData& data) {
  const glm::vec4 at(clip.x - data.DisplayPos.x, clip.y - data.DisplayPos.y, clip.z - data.DisplayPos.x,
                     clip.w - data.DisplayPos.y);
  const int height = static_cast<int>(data.DisplaySize.y);
  const int left = static_cast<int>(at.x), below = static_cast<int>(data.DisplaySize.y - at.w);
  return {left, height - below - static_cast<int>(at.w - at.y), left + static_cast<int>(at.z - at.x), height - below};
}

}  // namespace

void ChangedTiles::hash(const ImDrawData& data, std::span<const TextureRevision> textures) {
  now_.assign(static_cast<std::size_t>(tiles_.x) * static_cast<std::size_t>(tiles_.y), kStart);
  const glm::vec2 origin(data.DisplayPos.x, data.DisplayPos.y);
  const auto tile = [&](float x, float y) { return (glm::vec2(x, y) - origin) / static_cast<float>(kTile); };
  for (int l = 0; l < data.CmdListsCount; ++l) {
    const ImDrawList& list = *data.CmdLists[l];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const std::uint64_t common = hashOf(command, textures, frame_);
      const glm::vec2 clipLow = glm::max(tile(command.ClipRect.x, command.ClipRect.y), glm::vec2(0.0f));
      const glm::vec2 clipHigh = glm::min(tile(command.ClipRect.z, command.ClipRect.w), glm::vec2(tiles_));
      const ImDrawIdx* index = list.IdxBuffer.Data + command.IdxOffset;
      const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
      for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
        std::uint64_t triangle = common;
        glm::vec2 low(clipHigh), high(clipLow);
        for (unsigned corner = i; corner < i + 3; ++corner) {
          const ImDrawVert& vertex = vertices[index[corner]];
          const glm::vec2 at = tile(vertex.pos.x, vertex.pos.y);
          low = glm::min(low, at);
          high = glm::max(high, at);
          triangle = mixed(mixed(mixed(triangle, bitsOf(vertex.pos)), bitsOf(vertex.uv)), vertex.col);
        }
        const glm::ivec2 first(glm::floor(glm::max(low, clipLow))), last(glm::ceil(glm::min(high, clipHigh)));
        for (int y = first.y; y < last.y; ++y) {
          for (int x = first.x; x < last.x; ++x) {
            std::uint64_t& at = now_[static_cast<std::size_t>(y * tiles_.x + x)];
            at = mixed(at, triangle);
          }
        }
      }
    }
  }
}

std::vector<glm::ivec4> ChangedTiles::update(const ImDrawData& data, const glm::ivec2& size,
                                             std::span<const TextureRevision> textures,
                                             std::span<const glm::vec4> parts) {
  ++frame_;
  const bool anew = size != size_;
  size_ = size;
  tiles_ = (size + kTile - 1) / kTile;
  hash(data, textures);
  std::vector<bool> marked(now_.size(), true);
  if (!anew) {
    for (std::size_t i = 0; i < now_.size(); ++i) marked[i] = now_[i] != before_[i];
  }
  std::swap(before_, now_);
  for (const glm::vec4& part : parts) {
    const glm::vec4 inTiles = part / static_cast<float>(kTile);
    const glm::ivec2 first(glm::clamp(glm::floor(glm::vec2(inTiles)), glm::vec2(0.0f), glm::vec2(tiles_)));
    const glm::ivec2 last(glm::clamp(glm::ceil(glm::vec2(inTiles.z, inTiles.w)), glm::vec2(0.0f), glm::vec2(tiles_)));
    for (int y = first.y; y < last.y; ++y) {
      for (int x = first.x; x < last.x; ++x) marked[static_cast<std::size_t>(y * tiles_.x + x)] = true;
    }
  }
  std::vector<glm::ivec4> rects = rectsOf(marked, tiles_);
  if (rects.size() > kMostRects) rects = {around(rects)};
  for (glm::ivec4& rect : rects) rect = glm::min(rect * kTile, glm::ivec4(size, size));
  return rects;
}

void clipDrawing(ImDrawData& data, std::span<const glm::ivec4> rects) {
  const ImVec2 origin = data.DisplayPos;
  for (int l = 0; l < data.CmdListsCount; ++l) {
    ImDrawList& list = *data.CmdLists[l];
    ImVector<ImDrawCmd> clipped;
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const glm::ivec4 own = scissorOf(command.ClipRect, data);
      for (const glm::ivec4& rect : rects) {
        const glm::ivec2 low(std::max(own.x, rect.x), std::max(own.y, rect.y));
        const glm::ivec2 high(std::min(own.z, rect.z), std::min(own.w, rect.w));
        if (low.x >= high.x || low.y >= high.y) continue;
        clipped.push_back(command);
        clipped.back().ClipRect = {static_cast<float>(low.x) + origin.x, static_cast<float>(low.y) + origin.y,
                                   static_cast<float>(high.x) + origin.x, static_cast<float>(high.y) + origin.y};
      }
    }
    list.CmdBuffer.swap(clipped);
  }
}

}  // namespace sinew::app
