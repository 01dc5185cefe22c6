// app/viewport/render/reference_picture.h: pictures to work after, one for each side of the character, and where they
// stand.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

#include "app/viewport/render/scene.h"
#include "app/viewport/render/viewport.h"
#include "core/files/json/json.h"

namespace sinew::app {

enum class ReferenceSide { kFront, kBack, kLeft, kRight, kTop };
inline constexpr std::size_t kReferenceSides = 5;

inline constexpr float kLeastReferenceScale = 0.05f;
inline constexpr float kMostReferenceScale = 20.0f;
inline constexpr float kMostReferenceOffset = 10.0f;

struct ReferencePicture {
  std::filesystem::path file;           ///< "": there is none.
  std::shared_ptr<const Image> pixels;  ///< Null: there is none, or it cannot be read.
  bool shown = true;
  bool inside = false;  ///< Through the middle of the body; else behind it.
  float opacity = 0.5f;
  float scale = 1.0f;      ///< Height of the picture over that of the body as it is seen from there.
  glm::vec2 offset{0.0f};  ///< Of the character's height, right and up as it is seen from there.
};
using ReferencePictures = std::array<ReferencePicture, kReferenceSides>;

/// "front"
[[nodiscard]] const char* nameOf(ReferenceSide side);

/// A .png, .jpg or .webp, made as small as the editor needs it. Error: it is missing, damaged or too large.
[[nodiscard]] Result<Image> readReference(const std::filesystem::path& file);

/// Where a picture stands. Without an offset it stands on the body's lowest point and its middle is the body's; from
/// the top its middle is the body's both ways.
/// @param body  of the bind pose, not empty  @param height  the character's
[[nodiscard]] ReferencePlane referencePlane(ReferenceSide side, const ReferencePicture& picture, const Bounds& body,
                                            float height);

/// Those that are shown.
[[nodiscard]] std::vector<ReferencePlane> referencePlanes(const ReferencePictures& pictures,
                                                          const Character& character);

[[nodiscard]] Json referencesToJson(const ReferencePictures& pictures);
/// What cannot be read is the default. @param missing  files that cannot be shown: they keep their places
[[nodiscard]] ReferencePictures referencesFromJson(const Json& json, std::vector<Error>& missing);

}  // namespace sinew::app
