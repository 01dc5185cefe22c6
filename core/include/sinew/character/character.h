// core/include/sinew/character/character.h: what a glTF file becomes: read-only after import.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sinew/character/body_part.h"
#include "sinew/mesh/control_mesh.h"
#include "sinew/mesh/morph_target.h"
#include "sinew/skeleton/animation_clip.h"
#include "sinew/skeleton/skeleton.h"

namespace sinew {

enum class TextureWrap { kRepeat, kClampToEdge, kMirroredRepeat };

/// Image in sRGB, 8 bits, RGBA, top row first; width * height * 4 bytes.
struct Texture {
  std::string name;
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
  std::vector<std::uint8_t> encoded;  ///< The PNG, JPEG or WebP it came from, for export.
  std::string mimeType;               ///< "image/png", "image/jpeg" or "image/webp".
  TextureWrap wrapU = TextureWrap::kRepeat;
  TextureWrap wrapV = TextureWrap::kRepeat;
  bool nearest = false;  ///< Magnify without smoothing.
};

enum class AlphaMode { kOpaque, kMask, kBlend };

/// The part of glTF's metallic-roughness model that Sinew draws. Colors linear. The base color is baseColor * texture
/// * Wedge::color.
struct Material {
  std::string name;
  glm::vec4 baseColor{1.0f};
  int baseColorTexture = -1;  ///< Index into Character::textures, or -1.
  float metallic = 0.0f;      ///< 0..1
  float roughness = 1.0f;     ///< 0..1
  glm::vec3 emissive{0.0f};
  AlphaMode alphaMode = AlphaMode::kOpaque;
  float alphaCutoff = 0.5f;
  bool doubleSided = false;
  bool shownOpaque = false;  ///< Drawn as kOpaque: its alpha would hide the whole character. Exports keep the alpha.
};

/// Control mesh + morph targets + skeleton + clips + materials. docs/design.md.
struct Character {
  std::string name;                       ///< File name without folder and ending.
  ControlMesh mesh;                       ///< With every morph target at 0.
  std::vector<MorphTarget> morphTargets;  ///< Those of one node in the order of its mesh.
  std::vector<MorphSet> morphSets;        ///< Expressions; their names are unlike those of targets.
  Skeleton skeleton;
  std::vector<BodyPart> bodyParts;  ///< Each part once; empty where the file names none.
  std::vector<AnimationClip> clips;
  std::vector<Material> materials;  ///< At least one.
  std::vector<Texture> textures;
  std::vector<std::string> ignored;  ///< What the file holds and Sinew does not use, each with the reason.
  float height = 1.0f;               ///< H: y extent of the welded mesh in the bind pose (largest extent if flat); > 0.
};

}  // namespace sinew
