// app/render/render_target.cpp: framebuffers of the picture.
#include "app/render/render_target.h"

#include <algorithm>

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

}  // namespace sinew::app
