// app/viewport/render/reference_picture.h: reference pictures, one for each side of the character.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <vector>

#include "app/viewport/render/frame.h"
#include "app/viewport/render/scene.h"
#include "app/viewport/render/viewport.h"
#include "core/files/json/json.h"

namespace sinew::app {

class ReferenceDrawer {
 public:
  [[nodiscard]] static Result<ReferenceDrawer> create();

  void prepare(const Frame& frame);  ///< Uploads the frame's pictures and drops others.
  /// With depth test, without writing depth. @param inside  the pictures inside the body, else those behind it
  void draw(const Frame& frame, bool inside) const;

 private:
  struct Uploaded {
    std::shared_ptr<const Image> pixels;  ///< Kept alive, so that its address stays unique.
    GlTexture texture;
  };
  ReferenceDrawer() = default;

  GlProgram program_;
  GlVertexArray empty_;
  std::map<const Image*, Uploaded> textures_;
};

enum class ReferenceSide { kFront, kBack, kLeft, kRight, kTop };
inline constexpr std::size_t kReferenceSides = 5;

inline constexpr float kLeastReferenceScale = 0.05f;
inline constexpr float kMostReferenceScale = 20.0f;
inline constexpr float kMostReferenceOffset = 10.0f;

struct ReferencePicture {
  std::filesystem::path file;           ///< Empty: none.
  std::shared_ptr<const Image> pixels;  ///< Null: none, or unreadable.
  bool shown = true;
  bool inside = false;  ///< In the middle of the body; else behind it.
  float opacity = 0.5f;
  float scale = 1.0f;      ///< Height of the picture over that of the body, seen from that side.
  glm::vec2 offset{0.0f};  ///< Fraction of the character's height, right and up, seen from that side.
};
using ReferencePictures = std::array<ReferencePicture, kReferenceSides>;

[[nodiscard]] const char* nameOf(ReferenceSide side);  ///< "front"

/// Reads and scales down a .png, .jpg or .webp. Error: missing, damaged or too large.
[[nodiscard]] Result<Image> readReference(const std::filesystem::path& file);

/// Without an offset, a picture is centered on the body and stands on its lowest point; from the top it is centered
/// both ways. @param body  bounds of the bind pose, not empty  @param height  of the character
[[nodiscard]] ReferencePlane referencePlane(ReferenceSide side, const ReferencePicture& picture, const Bounds& body,
                                            float height);

/// Planes of the pictures that are shown.
[[nodiscard]] std::vector<ReferencePlane> referencePlanes(const ReferencePictures& pictures,
                                                          const Character& character);

[[nodiscard]] Json referencesToJson(const ReferencePictures& pictures);
/// Unreadable values are defaults. @param missing  errors of unreadable files, which keep their settings
[[nodiscard]] ReferencePictures referencesFromJson(const Json& json, std::vector<Error>& missing);

}  // namespace sinew::app
