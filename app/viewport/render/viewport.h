// app/viewport/render/viewport.h: draws a scene into a picture.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

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

/// Times of the last picture; without setFinishFrames not those of the graphics card.
struct DrawSeconds {
  double upload = 0.0;
  double draw = 0.0;
};

/// One picture of one character. Every call needs the OpenGL 4.5 core context in which it was created to be current.
class Viewport {
 public:
  /// @param samples  >= 1, clamped to the driver's maximum. Error: a shader is missing or refused, or no OpenGL 4.5.
  [[nodiscard]] static Result<std::unique_ptr<Viewport>> create(int samples);
  ~Viewport();
  Viewport(const Viewport&) = delete;
  Viewport& operator=(const Viewport&) = delete;

  [[nodiscard]] static int defaultSamples();  ///< 4, or 1 where the processor draws.

  /// Uploads textures and copies materials. Call before drawing another character.
  void setCharacter(const Character& character);

  /// Draws these vertices with refinement and classes of Scene::surface. nullopt, the default: the surface's own.
  void setCardVertices(const std::optional<CardVertices>& vertices);

  /// Draws into its own framebuffer, resized to view.size. Leaves framebuffer 0 bound, and depth test, blending and
  /// culling off. scene.character must be that of setCharacter; without scene.surface no surface is drawn.
  /// @param moving  for one picture of a movement, soon replaced: its resolution as a fraction of view.size, 0..1;
  /// lines keep their apparent widths. refine() needs a picture without it.
  void draw(const Scene& scene, const View& view, const DisplaySettings& settings,
            std::optional<float> moving = std::nullopt);

  /// The mean of several pictures: smooth edges, occlusion without noise. @param samples  kFewSamples or kMeanSamples
  void drawMean(const Scene& scene, const View& view, const DisplaySettings& settings, int samples);

  /// Adds a picture to a mean of kMeanSamples. Call it after draw() with the same arguments until isRefined().
  /// @return whether the picture has changed, which happens twice
  bool refine(const Scene& scene, const View& view, const DisplaySettings& settings);
  [[nodiscard]] int samplesTaken() const;
  [[nodiscard]] bool isRefined() const;

  /// Wait for the graphics card in draw(), so that seconds() includes it. Off by default.
  void setFinishFrames(bool finish);
  /// Whether draw() computes ambient occlusion; by default not on the processor, where movements must not wait.
  void setOccludesOnce(bool occludes);
  [[nodiscard]] const DrawSeconds& seconds() const;

  /// OpenGL texture of the last picture for ImGui::Image: not decoded, bottom row first, so use uv0 = (0, 1), uv1 =
  /// (1, 0). Changes with the size; 0 before the first draw().
  [[nodiscard]] unsigned colorTexture() const;
  /// Boxes in which the last draw() differs from the picture before it: 0..1, low and high corner from the top left.
  [[nodiscard]] const std::vector<glm::vec4>& changed() const;
  [[nodiscard]] Image readPixels() const;

 private:
  Viewport();
  [[nodiscard]] Frame frameOf(const Scene& scene, const View& view, const DisplaySettings& settings, bool moving);
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
