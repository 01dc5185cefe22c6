// app/viewport/render/render_target.h: the picture's framebuffer: sRGB color and depth, multisampled and resolved.
#pragma once

#include "app/viewport/render/gl_objects.h"

namespace sinew::app {

class RenderTarget {
 public:
  /// Makes or remakes what does not fit. Size >= 1x1; samples >= 1, clamped to what the driver offers.
  void resize(const glm::ivec2& size, int samples);
  /// Binds it for drawing, viewport included; values are encoded to sRGB on writing and blended linearly.
  void begin() const;
  /// Averages the samples into the texture.
  void end() const;

  [[nodiscard]] const glm::ivec2& size() const { return size_; }
  /// The finished picture read as it is stored (sRGB values, not decoded).
  [[nodiscard]] GLuint texture() const { return shown_.id(); }
  [[nodiscard]] GLuint framebuffer() const { return resolved_.id(); }
  /// The same texture read as linear light.
  [[nodiscard]] GLuint linearTexture() const { return color_.id(); }

 private:
  glm::ivec2 size_{0};
  int samples_ = 0;
  GlTexture color_;
  GlTexture shown_;  ///< The same memory under a type that is not decoded.
  GlRenderbuffer depth_;
  GlRenderbuffer manyColor_;
  GlRenderbuffer manyDepth_;
  GlFramebuffer resolved_;
  GlFramebuffer many_;
};

/// The mean of pictures of the same scene, each drawn a fraction of a pixel aside.
class PictureMean {
 public:
  [[nodiscard]] static Result<PictureMean> create();

  /// Forgets what it holds.
  void begin(const glm::ivec2& size);
  void add(const RenderTarget& picture);
  /// Writes the mean over the target's picture. Same size; something was added.
  void writeTo(const RenderTarget& target) const;
  [[nodiscard]] int count() const { return count_; }

 private:
  PictureMean();
  void copy(GLuint source, GLuint framebuffer, float factor) const;

  GlProgram copyProgram_;
  GlVertexArray empty_;
  glm::ivec2 size_{0};
  int count_ = 0;
  GlTexture sum_;
  GlFramebuffer sumTarget_;
};

/// Where sample `index` of `kMeanSamples` lies: pixels from the middle, -0.5..0.5. Any 4 or 16 in a row that begin with
/// a multiple of 4 spread evenly over the pixel.
inline constexpr int kMeanSamples = 16;
inline constexpr int kFewSamples = 4;  ///< After which the mean is first shown.
/// How many make a mean of at least so many, kFewSamples or kMeanSamples.
[[nodiscard]] constexpr int meanSamples(int samples) { return samples <= kFewSamples ? kFewSamples : kMeanSamples; }
[[nodiscard]] glm::vec2 sampleOffset(int index);

}  // namespace sinew::app
