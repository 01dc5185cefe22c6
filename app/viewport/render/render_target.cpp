// app/viewport/render/render_target.cpp: framebuffers and their means.
#include "app/viewport/render/render_target.h"

#include <algorithm>
#include <utility>

namespace sinew::app {

void RenderTarget::resize(const glm::ivec2& size, int samples) {
  GLint most = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  const int wanted = std::clamp(samples, 1, std::max(most, 1));
  if (size == size_ && wanted == samples_) return;
  size_ = size;
  samples_ = wanted;

  color_ = makeTexture(GL_TEXTURE_2D);
  glTextureStorage2D(color_.id(), 1, GL_SRGB8_ALPHA8, size.x, size.y);
  GLuint view = 0;
  glGenTextures(1, &view);
  shown_ = GlTexture(view);
  glTextureView(view, GL_TEXTURE_2D, color_.id(), GL_RGBA8, 0, 1, 0, 1);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTextureParameteri(view, filter, GL_LINEAR);
  }
  depth_.reset();
  many_.reset();
  manyColor_.reset();
  manyDepth_.reset();
  resolved_ = makeFramebuffer();
  glNamedFramebufferTexture(resolved_.id(), GL_COLOR_ATTACHMENT0, color_.id(), 0);
  if (samples_ == 1) {
    depth_ = makeRenderbuffer();
    glNamedRenderbufferStorage(depth_.id(), GL_DEPTH_COMPONENT32F, size.x, size.y);
    glNamedFramebufferRenderbuffer(resolved_.id(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
    return;
  }
  manyColor_ = makeRenderbuffer();
  manyDepth_ = makeRenderbuffer();
  many_ = makeFramebuffer();
  glNamedRenderbufferStorageMultisample(manyColor_.id(), samples_, GL_SRGB8_ALPHA8, size.x, size.y);
  glNamedRenderbufferStorageMultisample(manyDepth_.id(), samples_, GL_DEPTH_COMPONENT32F, size.x, size.y);
  glNamedFramebufferRenderbuffer(many_.id(), GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, manyColor_.id());
  glNamedFramebufferRenderbuffer(many_.id(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, manyDepth_.id());
}

void RenderTarget::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, samples_ == 1 ? resolved_.id() : many_.id());
  glViewport(0, 0, size_.x, size_.y);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_FRAMEBUFFER_SRGB);
}

void RenderTarget::end() const {
  if (samples_ == 1) return;
  glBlitNamedFramebuffer(many_.id(), resolved_.id(), 0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y,
                         GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

PictureMean::PictureMean() : empty_(makeVertexArray()) {}

Result<PictureMean> PictureMean::create() {
  PictureMean mean;
  Result<GlProgram> program = GlProgram::load({"shaders/fullscreen.vert", "shaders/copy.frag"});
  if (!program) return program.error();
  mean.copyProgram_ = std::move(program).value();
  return mean;
}

void PictureMean::begin(const glm::ivec2& size) {
  count_ = 0;
  if (size == size_) return;
  size_ = size;
  sum_ = makeTexture(GL_TEXTURE_2D);
  glTextureStorage2D(sum_.id(), 1, GL_RGBA32F, size.x, size.y);
  sumTarget_ = makeFramebuffer();
  glNamedFramebufferTexture(sumTarget_.id(), GL_COLOR_ATTACHMENT0, sum_.id(), 0);
}

void PictureMean::copy(GLuint source, GLuint framebuffer, float factor) const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, size_.x, size_.y);
  glBindTextureUnit(0, source);
  copyProgram_.use();
  copyProgram_.set("source", 0);
  copyProgram_.set("factor", factor);
  glBindVertexArray(empty_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void PictureMean::add(const RenderTarget& picture) {
  glDisable(GL_FRAMEBUFFER_SRGB);
  glDisable(GL_DEPTH_TEST);
  if (count_ > 0) {
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE);
  } else {
    glDisable(GL_BLEND);
  }
  copy(picture.linearTexture(), sumTarget_.id(), 1.0f);
  glDisable(GL_BLEND);
  ++count_;
}

void PictureMean::writeTo(const RenderTarget& target) const {
  glEnable(GL_FRAMEBUFFER_SRGB);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  copy(sum_.id(), target.framebuffer(), 1.0f / static_cast<float>(count_));
  glDisable(GL_FRAMEBUFFER_SRGB);
}

glm::vec2 sampleOffset(int index) {
  // The first two dimensions of Sobol's sequence.
  glm::vec2 at(0.5f / static_cast<float>(kMeanSamples));
  for (int bits = index, x = kMeanSamples / 2, y = kMeanSamples / 2, sum = 0; bits != 0; bits >>= 1, x >>= 1) {
    if ((bits & 1) != 0) {
      at.x += static_cast<float>(x) / static_cast<float>(kMeanSamples);
      sum ^= y;
      at.y = (0.5f + static_cast<float>(sum)) / static_cast<float>(kMeanSamples);
    }
    y ^= y >> 1;
  }
  return at - 0.5f;
}

}  // namespace sinew::app
