// app/window/screen.cpp: the window's back buffer, drawn in parts where it still holds the frame before.

#include "app/window/screen.h"

#include <imgui.h>

#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/common.hpp>

#include "app/ui/style.h"
#include "app/viewport/render/gl_objects.h"

namespace sinew::app {
namespace {

constexpr int kMarks = 4;

/// Clears in these pixels, low corner and size, rows from below.
void clear(const glm::ivec4& pixels, float shade) {
  const Tint back = palette::kBackground;
  glEnable(GL_SCISSOR_TEST);
  glScissor(pixels.x, pixels.y, pixels.z, pixels.w);
  glClearColor(back.r, back.g, back.b + shade, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
}

/// Clears what of the rectangle lies outside of `covered`. Both: low x and y, high x and y, from the top left.
void clearAround(const glm::ivec4& rect, const glm::ivec4& covered, int height) {
  const glm::ivec2 low(std::max(rect.x, covered.x), std::max(rect.y, covered.y));
  const glm::ivec2 high(std::min(rect.z, covered.z), std::min(rect.w, covered.w));
  std::array parts{rect, glm::ivec4(0), glm::ivec4(0), glm::ivec4(0)};
  if (low.x < high.x && low.y < high.y) {
    parts = {glm::ivec4(rect.x, rect.y, rect.z, low.y), glm::ivec4(rect.x, high.y, rect.z, rect.w),
             glm::ivec4(rect.x, low.y, low.x, high.y), glm::ivec4(high.x, low.y, rect.z, high.y)};
  }
  for (const glm::ivec4& part : parts) {
    if (part.x >= part.z || part.y >= part.w) continue;
    clear({part.x, height - part.w, part.z - part.x, part.w - part.y}, 0.0f);
  }
}

/// OpenGL leaves open what the back buffer holds after a swap. One pixel in the corner, which differs from frame to
/// frame by a step of blue that nobody sees, tells whether it is the frame before.
void leaveMark(int mark) { clear({0, 0, 1, 1}, static_cast<float>(mark) / 255.0f); }

bool hasMark(int mark) {
  std::array<std::uint8_t, 4> pixel{};
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  const Tint back = palette::kBackground;
  const std::array<float, 3> wanted{back.r, back.g, back.b + static_cast<float>(mark) / 255.0f};
  for (std::size_t c = 0; c < wanted.size(); ++c) {
    if (static_cast<long>(pixel[c]) != std::lround(255.0f * wanted[c])) return false;
  }
  return true;
}

}  // namespace

Screen::Screen() : software_(isSoftwareRenderer()) {}

bool Screen::draw(ImDrawData& data, const glm::ivec2& size, std::span<const TextureRevision> textures,
                  std::span<const glm::vec4> parts, const glm::vec4& covered, bool still) {
  if (size.x <= 0 || size.y <= 0) return false;
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, size.x, size.y);
  if (!software_ || data.FramebufferScale.x != 1.0f || data.FramebufferScale.y != 1.0f) {
    clear({0, 0, size}, 0.0f);
    ImGui_ImplOpenGL3_RenderDrawData(&data);
    return true;
  }
  const std::vector<glm::ivec4> changed = tiles_.update(data, size, textures, parts);
  if (changed.empty() && still) return false;
  const glm::ivec4 inside(glm::ceil(covered.x), glm::ceil(covered.y), glm::floor(covered.z), glm::floor(covered.w));
  for (const glm::ivec4& rect : changed) clearAround(rect, inside, size.y);
  clipDrawing(data, changed);
  ImGui_ImplOpenGL3_RenderDrawData(&data);
  mark_ = (mark_ + 1) % kMarks;
  leaveMark(mark_);
  return true;
}

void Screen::noteShown() {
  if (software_ && !hasMark(mark_)) forget();
}

}  // namespace sinew::app
