// app/viewport/render/viewport.h: draws a scene into a picture of its own. Needs a current OpenGL 4.5 core context.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/viewport/render/card_vertices.h"
#include "app/viewport/render/scene.h"
#include "app/viewport/render/view.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

class RenderTarget;
struct Frame;

/// RGBA, 8 bits, sRGB, top row first; width * height * 4 bytes.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Where the last picture's time went. Without `finishFrames` the graphics processor's share is not in it.
struct DrawSeconds {
  double upload = 0.0;
  double draw = 0.0;
};

/// One picture of one character. Every call needs the context it was made in to be current.
class Viewport {
 public:
  /// @param samples per pixel, 1 or more; clamped to what the driver offers.
  /// Error: a shader is missing or refused, or the driver lacks OpenGL 4.5.
  [[nodiscard]] static Result<std::unique_ptr<Viewport>> create(int samples);
  ~Viewport();
  Viewport(const Viewport&) = delete;
  Viewport& operator=(const Viewport&) = delete;

  /// Samples that suit the renderer at hand: 4, or 1 where the processor draws.
  [[nodiscard]] static int defaultSamples();

  /// Takes textures and materials. Call when the character changes, before drawing it. Copies what it needs.
  void setCharacter(const Character& character);

  /// Draws these vertices in place of the scene's surface's positions and normals, which may be empty; its refinement
  /// and classes count. nullopt: the surface's own, as by default.
  void setCardVertices(const std::optional<CardVertices>& vertices);

  /// Draws into the own framebuffer, resized to view.size. Leaves framebuffer 0 bound, and depth test, blending,
  /// culling off. scene.character must be the one of setCharacter; scene.surface may be null (then no surface is
  /// drawn).
  /// @param moving  for one picture of a movement, soon replaced: its pixels per pixel of view.size along an edge,
  /// 0..1.
  ///                Lines keep their widths as they are seen. refine() needs a picture that is drawn without it.
  void draw(const Scene& scene, const View& view, const DisplaySettings& settings,
            std::optional<float> moving = std::nullopt);

  /// Draws a picture of which the edges are smooth and the ambient occlusion without noise: the mean of so many.
  /// @param samples  kFewSamples or kMeanSamples
  void drawMean(const Scene& scene, const View& view, const DisplaySettings& settings, int samples);

  /// Draws a resting picture once more, a fraction of a pixel aside, for a mean of kMeanSamples: smooth edges, and
  /// ambient occlusion without noise. To be called after draw(), with the same arguments, until isRefined().
  /// @return whether the picture has changed: it does so twice.
  bool refine(const Scene& scene, const View& view, const DisplaySettings& settings);
  [[nodiscard]] int samplesTaken() const;
  [[nodiscard]] bool isRefined() const;

  /// Wait for the picture at the end of draw(), so that seconds() holds all of it. Off by default.
  void setFinishFrames(bool finish);
  /// Whether draw() works out ambient occlusion. By default only on a graphics card: on the processor such a picture is
  /// one of a movement, which is not to wait for it.
  void setOccludesOnce(bool occludes);
  [[nodiscard]] const DrawSeconds& seconds() const;

  /// OpenGL texture of the last picture for ImGui::Image: values are display-ready (not decoded on reading), bottom row
  /// first, so show it with uv0 = (0, 1), uv1 = (1, 0). Changes when the size changes; 0 before the first draw().
  [[nodiscard]] unsigned colorTexture() const;
  /// Where the last draw() differs from the picture before it; elsewhere the pixels are the same. 0..1: low x and y,
  /// high x and y, from the top left.
  [[nodiscard]] const std::vector<glm::vec4>& changed() const;
  [[nodiscard]] Image readPixels() const;

 private:
  Viewport();
  [[nodiscard]] Frame beginPicture(const Scene& scene, const View& view, const DisplaySettings& settings, bool moving);
  void drawInto(const RenderTarget& target, const Frame& frame, bool kept = false);
  void shareFrame(const Frame& frame, int sample);
  void noteChange(const Frame& frame, bool kept);
  [[nodiscard]] glm::vec3 groundCenter(const Frame& frame, bool moving);
  void leave();
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew::app
