// app/ui/changed_tiles.h: which parts of the window differ from the last frame.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

struct ImDrawData;

namespace sinew::app {

/// Equal revisions mean equal pixels. Unlisted textures count as changed in every frame.
struct TextureRevision {
  std::uintptr_t texture = 0;
  std::uint64_t revision = 0;
};

/// Compares the triangles in each square of the window with the last frame's. For windows with FramebufferScale 1.
class ChangedTiles {
 public:
  /// Pixels from the top left; rectangles are low x and y, high x and y. @param parts  changed in any case
  /// @param size  of the framebuffer; a new one changes everything  @return at most kMostRects disjoint rectangles
  [[nodiscard]] std::vector<glm::ivec4> update(const ImDrawData& data, const glm::ivec2& size,
                                               std::span<const TextureRevision> textures,
                                               std::span<const glm::vec4> parts = {});

  static constexpr int kTile = 32;
  static constexpr std::size_t kMostRects = 12;

 private:
  void hash(const ImDrawData& data, std::span<const TextureRevision> textures);

  glm::ivec2 size_{0};
  glm::ivec2 tiles_{0};
  std::uint64_t frame_ = 0;
  std::vector<std::uint64_t> before_;
  std::vector<std::uint64_t> now_;
};

/// Limits the drawing to these rectangles, pixels: each command is drawn once in each that it touches.
void clipDrawing(ImDrawData& data, std::span<const glm::ivec4> rects);

}  // namespace sinew::app
