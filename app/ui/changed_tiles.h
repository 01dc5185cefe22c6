// app/ui/changed_tiles.h: which parts of the window look different from the frame before.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

struct ImDrawData;

namespace sinew::app {

/// A texture whose content is known: equal revisions, equal pixels. A texture that is not listed counts as changed in
/// every frame.
struct TextureRevision {
  std::uintptr_t texture = 0;
  std::uint64_t revision = 0;
};

/// Compares what is drawn in each square of the window with the frame before, without looking at a pixel. For windows
/// with one pixel per unit of ImGui's (FramebufferScale 1).
class ChangedTiles {
 public:
  /// @param size  of the framebuffer, pixels; another one than before: everything has changed
  /// @param parts  low x and y, high x and y: changed whatever is drawn there
  /// @return rectangles that hold all changes, at most kMostRects: low x and y, high x and y; pixels, from the top
  /// left.
  ///         Within the framebuffer, no two overlap.
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

/// Limits the drawing to these rectangles (pixels, as above): each command is drawn once in each that it touches.
void clipDrawing(ImDrawData& data, std::span<const glm::ivec4> rects);

}  // namespace sinew::app
