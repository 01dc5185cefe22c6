// app/viewport/render/render_target.h: the picture's framebuffer, and means of pictures.
#pragma once

#include "app/viewport/render/gl_objects.h"

namespace sinew::app {

class RenderTarget {
 public:
  /// Size >= 1x1; samples >= 1, clamped to the driver's maximum.
  void resize(const glm::ivec2& size, int samples);
  /// Binds framebuffer and viewport; colors are linear and stored as sRGB.
  void begin() const;
  /// Averages the samples into the texture.
  void end() const;

  [[nodiscard]] const glm::ivec2& size() const { return size_; }
  /// The finished picture, read without decoding sRGB.
  [[nodiscard]] GLuint texture() const { return shown_.id(); }
  [[nodiscard]] GLuint framebuffer() const { return resolved_.id(); }
  /// The same texture read as linear light.
  [[nodiscard]] GLuint linearTexture() const { return color_.id(); }

 private:
  glm::ivec2 size_{0};
  int samples_ = 0;
  GlTexture color_;
  GlTexture shown_;  ///< The same memory, not decoded.
  GlRenderbuffer depth_, manyColor_, manyDepth_;
  GlFramebuffer resolved_, many_;
};

/// Mean of pictures of one scene, each shifted by a fraction of a pixel.
class PictureMean {
 public:
  [[nodiscard]] static Result<PictureMean> create();

  void begin(const glm::ivec2& size);
  void add(const RenderTarget& picture);
  /// Writes the mean of at least one picture to a target of the same size.
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

inline constexpr int kMeanSamples = 16;
inline constexpr int kFewSamples = 4;  ///< After which the mean is first shown.
/// kFewSamples or kMeanSamples, at least `samples` if possible.
[[nodiscard]] constexpr int meanSamples(int samples) { return samples <= kFewSamples ? kFewSamples : kMeanSamples; }
/// Offset of a sample in pixels, -0.5..0.5. Any 4 or 16 in a row from a multiple of 4 spread evenly over the pixel.
[[nodiscard]] glm::vec2 sampleOffset(int index);

}  // namespace sinew::app
