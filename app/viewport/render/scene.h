// app/viewport/render/scene.h: all that one picture shows, by reference.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/document/picture_look.h"
#include "core/rig/line_rest.h"
#include "core/rig/posed_rig.h"
#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/geometry/geometry.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/surface.h"

namespace sinew::app {

/// A buffer on the graphics card: SurfaceDrawer::Vertex, [D] of the surface's refinement.
struct CardVertices {
  unsigned buffer = 0;  ///< OpenGL name.
  Bounds bounds;        ///< World, of all vertices.
};

enum class Shading { kTextured, kClay, kClasses, kHeat };

/// View state, not saved in a rig.
struct DisplaySettings {
  Shading shading = Shading::kTextured;
  bool surface = true;
  bool wire = false;         ///< Refined mesh's edges over the shading.
  bool controlMesh = false;  ///< Edges of the skinned control mesh.
  bool skeleton = false;     ///< In x-ray.
  bool primitives = false;   ///< Visible ellipsoids, translucent.
  bool influence = false;    ///< Their regions of influence, fainter.
  bool anatomy = false;      ///< Muscles as flesh and tendons, the skin as glass over them.
  bool ground = true;        ///< Grid and shadow.
  bool background = true;    ///< Off: transparent.
  bool relief = false;       ///< Shading::kClay uses normal maps.
  bool lighting = true;      ///< Off: Shading::kTextured shows base colors.
  bool territory = true;     ///< Scene::territory as a tint on the skin.
  bool segments = true;      ///< Scene::segments.
  float lineScale = 1.0f;    ///< Factor on line, outline and dot widths, for dense displays.
  PictureLook look;          ///< Light, background, ambient occlusion.
  float heatRange = 0.05f;   ///< Displacement at the ends of the heat scale, fraction of the height, > 0.
  float glass = 0.8f;        ///< With `anatomy`: how clear the skin is. 0: as without, 1: a faint rim is left.

  friend bool operator==(const DisplaySettings&, const DisplaySettings&) = default;
};

/// The muscle line that carries a primitive, in the pose.
struct ShapeLine {
  LinePath path;
  float activation = 0.0f;  ///< 0..1
  float stretch = 1.0f;     ///< Length / rest length.

  friend bool operator==(const ShapeLine&, const ShapeLine&) = default;
};

/// One primitive to draw.
struct PrimitiveShape {
  int rigIndex = 0;
  glm::mat4 unitBallInWorld{1.0f};  ///< Unit ball -> visible ellipsoid, after `shape`.
  Shape shape{};
  float reach = 1.4142135f;
  int sign = 1;
  glm::vec3 radii{1.0f};                 ///< In the rig, the same in every pose.
  std::optional<ShapeLine> line;         ///< nullopt: carried by a bone.
  glm::vec3 color{0.85f, 0.20f, 0.11f};  ///< Linear: its group's.
  bool selected = false;
  bool active = false;  ///< The last selected one, shown by handles and inspector.
  bool hovered = false;
  bool twin = false;               ///< Mirror twin of a selected one.
  int sheet = -1;                  ///< Of a belly: index into Rig::sheets. Its fibers run along y.
  glm::bvec2 tendons{true, true};  ///< On a line: towards the origin, towards the insertion.

  friend bool operator==(const PrimitiveShape&, const PrimitiveShape&) = default;
};

/// The usable primitives of a rig in a pose, in rig order. @param posed  of this rig
[[nodiscard]] std::vector<PrimitiveShape> shapesOf(const Rig& rig, const PosedRig& posed);

/// World-space ends of its three axes where rho = scale.
[[nodiscard]] std::array<glm::vec3, 6> extremesOf(const PrimitiveShape& shape, float scale);

enum class SegmentClass : std::uint8_t { kPlain, kFound, kFallback, kLost };  ///< Each has its color (segmentColor).

/// A straight line with a dot at both ends, such as a projection ray. World space.
struct SceneSegment {
  glm::vec3 from{0.0f};
  glm::vec3 to{0.0f};
  SegmentClass kind = SegmentClass::kPlain;
};

struct Image;

/// Reference picture, visible from its front only.
struct ReferencePlane {
  std::shared_ptr<const Image> pixels;
  /// Square of side 1 about the origin, x right and y up in the picture -> world; z is the unit normal towards the eye.
  glm::mat4 squareInWorld{1.0f};
  float opacity = 1.0f;
  bool inside = false;  ///< Inside the body rather than behind everything.

  friend bool operator==(const ReferencePlane&, const ReferencePlane&) = default;
};

/// A part of the mesh tinted in the color of its layer.
struct LitPart {
  int part = 0;  ///< Index into Character::parts.
  SkinLayer layer = SkinLayer::kSkin;
  bool hovered = false;

  friend bool operator==(const LitPart&, const LitPart&) = default;
};

/// A character in one pose. Pointers are valid for the call; surface is null before the first smoothing.
struct Scene {
  const Character* character = nullptr;
  const Surface* surface = nullptr;
  /// A second surface of the same refinement, drawn alike; only positions, normals and displacement are used. Or null.
  const Surface* beside = nullptr;
  std::uint64_t surfaceRevision = 0;  ///< Equal for equal surfaces of a character. 0: unknown.
  const Pose* pose = nullptr;
  std::vector<PrimitiveShape> primitives;
  int selectedBone = -1;
  int hoveredBone = -1;
  std::vector<bool> hiddenBones;                   ///< [bones]; empty: none.
  std::vector<glm::vec3> skinnedControlPositions;  ///< [V] for DisplaySettings::controlMesh; may be empty.
  std::vector<float> territory;     ///< [V] 0..1, weight of the muscle at each control vertex; empty: no tint.
  std::vector<int> territoryBones;  ///< Highlighted, and drawn even if the skeleton is hidden.
  std::vector<LitPart> litParts;
  std::vector<SkinLayer> layers;       ///< [parts] for Shading::kClasses; empty: all is skin.
  std::vector<SceneSegment> segments;  ///< Fainter behind the skin.
  std::vector<ReferencePlane> references;
};

// Names of the shadings in files, on the command line and in the state log.

inline constexpr std::array kShadingNames{"textured", "clay", "classes", "heat"};

[[nodiscard]] inline const char* nameOf(Shading shading) { return kShadingNames[static_cast<std::size_t>(shading)]; }

}  // namespace sinew::app
