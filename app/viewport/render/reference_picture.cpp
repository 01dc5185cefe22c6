// app/viewport/render/reference_picture.cpp: decodes, places and draws reference pictures.

#include "app/viewport/render/reference_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/viewport/render/view.h"
#include "core/files/disk/atomic_file.h"
#include "core/files/gltf/material.h"

namespace sinew::app {

namespace {

constexpr float kFadedFrom = 0.3f;  ///< Cosine of the viewing angle below which a picture fades.

GlTexture uploaded(const Image& image) {
  GlTexture texture = uploadTexture(GL_SRGB8_ALPHA8, image.width, image.height, image.rgba, true);
  glTextureParameteri(texture.id(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

/// Factor on the opacity for oblique views; 0: from behind.
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

namespace {

constexpr std::uintmax_t kLargestReference = 64u << 20;
constexpr std::size_t kMostPixels = std::size_t{gltf::kMaxImageSide} * gltf::kMaxImageSide;
constexpr int kLargestSide = 4096;    ///< After scaling.
constexpr float kRoomBehind = 0.02f;  ///< Between body and picture, fraction of the height.

constexpr float kQuarter = 0.5f * std::numbers::pi_v<float>;

struct Seen {
  const char* name;
  float yaw, pitch;  ///< As cameraAxes().
};
constexpr std::array<Seen, kReferenceSides> kSides{{{"front", 0.0f, 0.0f},
                                                    {"back", 2.0f * kQuarter, 0.0f},
                                                    {"left", kQuarter, 0.0f},
                                                    {"right", -kQuarter, 0.0f},
                                                    {"top", 0.0f, kQuarter}}};

const Seen& seenFrom(ReferenceSide side) { return kSides[static_cast<std::size_t>(side)]; }

/// Means of two by two pixels; an odd last row or column is dropped.
Image halved(const Image& image) {
  Image half{std::max(image.width / 2, 1), std::max(image.height / 2, 1), {}};
  half.rgba.reserve(4 * static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
  const int right = image.width > 1 ? 1 : 0;
  const int below = image.height > 1 ? 1 : 0;
  const auto value = [&](int x, int y, std::size_t channel) {
    const auto pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
    return static_cast<unsigned>(image.rgba[4 * pixel + channel]);
  };
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      for (std::size_t c = 0; c < 4; ++c) {
        const unsigned sum = value(2 * x, 2 * y, c) + value(2 * x + right, 2 * y, c) + value(2 * x, 2 * y + below, c) +
                             value(2 * x + right, 2 * y + below, c);
        half.rgba.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
      }
    }
  }
  return half;
}

std::optional<std::size_t> sideNamed(const std::string& name) {
  for (std::size_t side = 0; side < kReferenceSides; ++side) {
    if (name == nameOf(static_cast<ReferenceSide>(side))) return side;
  }
  return std::nullopt;
}

/// Leaves the value unchanged if the number is out of range.
void read(const Json& json, float least, float most, float& value) {
  const double number = json.number(std::nan(""));
  if (number >= double{least} && number <= double{most}) value = static_cast<float>(number);
}

}  // namespace

const char* nameOf(ReferenceSide side) { return seenFrom(side).name; }

Result<Image> readReference(const std::filesystem::path& file) {
  const auto bytes = readWholeBytes(file, kLargestReference);
  if (!bytes) return bytes.error();
  Result<gltf::Image> decoded = gltf::decodeImage(bytes.value(), kMostPixels);
  if (!decoded) return Error{file.string(), "", decoded.error().reason};
  Image image{decoded->width, decoded->height, std::move(decoded.value().rgba)};
  while (std::max(image.width, image.height) > kLargestSide) image = halved(image);
  return image;
}

ReferencePlane referencePlane(ReferenceSide side, const ReferencePicture& picture, const Bounds& body, float height) {
  const glm::mat3 axes = cameraAxes(seenFrom(side).yaw, seenFrom(side).pitch);  // Right, up, towards the eye.
  const glm::vec3 half = 0.5f * body.extent();
  const auto reach = [&](int axis) { return glm::dot(glm::abs(axes[axis]), half); };
  const float bodyUp = reach(1) > 0.0f ? 2.0f * reach(1) : height;
  const float up = picture.scale * bodyUp;
  const float across = up * static_cast<float>(picture.pixels->width) / static_cast<float>(picture.pixels->height);
  glm::vec3 center = body.center() + height * (picture.offset.x * axes[0] + picture.offset.y * axes[1]);
  if (side != ReferenceSide::kTop) center += (0.5f * up - reach(1)) * axes[1];
  if (!picture.inside) center -= (reach(2) + kRoomBehind * height) * axes[2];
  ReferencePlane plane{picture.pixels, glm::mat4(1.0f), picture.opacity, picture.inside};
  plane.squareInWorld = {glm::vec4(across * axes[0], 0.0f), glm::vec4(up * axes[1], 0.0f), glm::vec4(axes[2], 0.0f),
                         glm::vec4(center, 1.0f)};
  return plane;
}

std::vector<ReferencePlane> referencePlanes(const ReferencePictures& pictures, const Character& character) {
  const auto isSeen = [](const ReferencePicture& picture) { return picture.pixels && picture.shown; };
  std::vector<ReferencePlane> planes;
  if (std::ranges::none_of(pictures, isSeen)) return planes;
  const Bounds body = boundsOf(character.mesh.positions);
  if (body.isEmpty()) return planes;
  for (std::size_t side = 0; side < kReferenceSides; ++side) {
    if (!isSeen(pictures[side])) continue;
    planes.push_back(referencePlane(static_cast<ReferenceSide>(side), pictures[side], body, character.height));
  }
  return planes;
}

Json referencesToJson(const ReferencePictures& pictures) {
  Json json = Json::array();
  for (std::size_t side = 0; side < kReferenceSides; ++side) {
    const ReferencePicture& picture = pictures[side];
    if (picture.file.empty()) continue;
    json.push(Json::object()
                  .set("side", nameOf(static_cast<ReferenceSide>(side)))
                  .set("file", picture.file.string())
                  .set("shown", picture.shown)
                  .set("inside", picture.inside)
                  .set("opacity", picture.opacity)
                  .set("scale", picture.scale)
                  .set("offset", Json::array().push(picture.offset.x).push(picture.offset.y)));
  }
  return json;
}

ReferencePictures referencesFromJson(const Json& json, std::vector<Error>& missing) {
  ReferencePictures pictures;
  for (const Json& item : json.items()) {
    const std::optional<std::size_t> side = sideNamed(item.at("side").text(""));
    const std::filesystem::path file = item.at("file").text("");
    if (!side || !file.is_absolute()) continue;
    ReferencePicture picture;
    picture.file = file;
    picture.shown = item.at("shown").boolean(true);
    picture.inside = item.at("inside").boolean(false);
    read(item.at("opacity"), 0.0f, 1.0f, picture.opacity);
    read(item.at("scale"), kLeastReferenceScale, kMostReferenceScale, picture.scale);
    if (const std::vector<Json>& offset = item.at("offset").items(); offset.size() == 2) {
      read(offset[0], -kMostReferenceOffset, kMostReferenceOffset, picture.offset.x);
      read(offset[1], -kMostReferenceOffset, kMostReferenceOffset, picture.offset.y);
    }
    if (Result<Image> image = readReference(file)) {
      picture.pixels = std::make_shared<const Image>(std::move(image).value());
    } else {
      missing.push_back(image.error());
    }
    pictures[*side] = std::move(picture);
  }
  return pictures;
}

}  // namespace sinew::app
