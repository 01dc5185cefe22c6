// app/viewport/render/reference_drawer.cpp: one square for each picture.
#include "app/viewport/render/reference_drawer.h"

#include <algorithm>
#include <bit>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sinew::app {
namespace {

constexpr float kFadedFrom = 0.3f;  ///< Cosine of the angle at which a picture is seen: below, it grows faint.

GlTexture uploaded(const Image& image) {
  GlTexture texture = makeTexture(GL_TEXTURE_2D);
  const auto longest = static_cast<unsigned>(std::max(image.width, image.height));
  glTextureStorage2D(texture.id(), static_cast<GLsizei>(std::bit_width(longest)), GL_SRGB8_ALPHA8, image.width,
                     image.height);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(texture.id(), 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  glGenerateTextureMipmap(texture.id());
  glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(texture.id(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

/// How much of it is left where it is seen from this far aside; 0: its back is seen.
float facing(const ReferencePlane& plane, const View& view) {
  const glm::vec3 normal(plane.squareInWorld[2]);
  const glm::vec3 towards =
      view.orthographic ? -view.forwardInWorld() : glm::normalize(view.eyeInWorld - glm::vec3(plane.squareInWorld[3]));
  return glm::clamp(glm::dot(normal, towards) / kFadedFrom, 0.0f, 1.0f);
}

}  // namespace

Result<ReferenceDrawer> ReferenceDrawer::create() {
  ReferenceDrawer drawer;
  Result<GlProgram> program = GlProgram::load({"shaders/reference.vert", "shaders/reference.frag"});
  if (!program) return program.error();
  drawer.program_ = std::move(program).value();
  drawer.empty_ = makeVertexArray();
  return drawer;
}

void ReferenceDrawer::prepare(const Frame& frame) {
  const auto& planes = frame.scene.references;
  std::erase_if(textures_, [&](const auto& held) {
    return std::ranges::none_of(planes, [&](const auto& plane) { return plane.pixels.get() == held.first; });
  });
  for (const ReferencePlane& plane : planes) {
    Uploaded& held = textures_[plane.pixels.get()];
    if (!held.pixels) held = {plane.pixels, uploaded(*plane.pixels)};
  }
}

void ReferenceDrawer::draw(const Frame& frame, bool inside) const {
  const auto& planes = frame.scene.references;
  if (std::ranges::none_of(planes, [&](const ReferencePlane& plane) { return plane.inside == inside; })) return;
  glDepthMask(GL_FALSE);
  blendPremultiplied();
  program_.use();
  program_.set("pixels", 0);
  glBindVertexArray(empty_.id());
  for (const ReferencePlane& plane : planes) {
    const float left = facing(plane, frame.view);
    if (plane.inside != inside || left <= 0.0f) continue;
    program_.set("squareInWorld", plane.squareInWorld);
    program_.set("opacity", plane.opacity * left);
    glBindTextureUnit(0, textures_.at(plane.pixels.get()).texture.id());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

}  // namespace sinew::app
