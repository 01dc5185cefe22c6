// app/viewport/tools/gizmo.h: move, rotate and scale handles of one ellipsoid: layout, hits, drags, all as values.
//
// Everything works in the pose of the current frame and returns a bone-space Placement; no matrix is decomposed.
// With B the bone's 3x3 (rotation and possibly uneven scale), q and r the placement's rotation and radii:
//   move    a world displacement d changes the center by inverse(B) d.
//   rotate  by theta about a world direction n: in bone space about normalize(inverse(B) n), in the opposite sense on
//           mirrored bones. Exact under even scale; under uneven scale the rotation is sheared with the bone, so that
//           the result stays an ellipsoid on it. About a pivot, the center rotates in the world.
//   scale   changes radii, along the primitive's own axes whatever axes are chosen.
//   shape   belly and bend of muscles that have a shape, in the mode kPoles.
//   poles   one semi-axis, measured in the world along B q e_i; the opposite pole stays, or with Alt the center.
// Muscles on flattened bones have no handles.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/viewport/render/view.h"
#include "app/viewport/tools/viewport_input.h"
#include "sinew/geometry/ellipsoid.h"

namespace sinew::app {

/// Motions of a handle: along or about an axis, in a plane, or free.
/// kWhole: move in the picture's plane, rotate about the line of sight, scale all three radii.
enum class Way { kNone, kX, kY, kZ, kXY, kYZ, kZX, kWhole };

inline constexpr std::array<Way, 3> kAxisWays = {Way::kX, Way::kY, Way::kZ};
inline constexpr std::array<Way, 3> kPlaneWays = {Way::kXY, Way::kYZ, Way::kZX};
inline constexpr std::array<Way, 7> kAllWays = {Way::kX,  Way::kY,  Way::kZ,    Way::kXY,
                                                Way::kYZ, Way::kZX, Way::kWhole};  ///< Without kNone.

[[nodiscard]] constexpr bool isAxis(Way way) { return way >= Way::kX && way <= Way::kZ; }
[[nodiscard]] constexpr bool isPlane(Way way) { return way >= Way::kXY && way <= Way::kZX; }

/// 0..2: component of a vector along the axis.
[[nodiscard]] constexpr int axisOf(Way axis) {
  assert(isAxis(axis));
  return static_cast<int>(axis) - static_cast<int>(Way::kX);
}

/// The two axes that span a plane: xy: 0, 1; yz: 1, 2; zx: 2, 0.
[[nodiscard]] constexpr std::array<int, 2> planeAxes(Way plane) {
  assert(isPlane(plane));
  const int first = static_cast<int>(plane) - static_cast<int>(Way::kXY);
  return {first, (first + 1) % 3};
}

/// The axis across a plane.
[[nodiscard]] constexpr int normalAxisOf(Way plane) { return (planeAxes(plane)[0] + 2) % 3; }

/// Index into an array with an element for each of kAllWays.
[[nodiscard]] constexpr std::size_t trackOf(Way way) {
  assert(way != Way::kNone);
  return static_cast<std::size_t>(way) - static_cast<std::size_t>(Way::kX);
}

/// "X", "YZ" ...; "" for kNone and kWhole.
[[nodiscard]] constexpr const char* nameOf(Way way) {
  constexpr std::array<const char*, 8> names = {"", "X", "Y", "Z", "XY", "YZ", "ZX", ""};
  return names[static_cast<std::size_t>(way)];
}

enum class GizmoMode { kPoles, kMove, kRotate, kScale };  ///< Pole handles exist in every mode.
enum class GizmoAxes { kWorld, kBone, kPrimitive };

enum class GizmoHandle {
  kNone,
  kMoveX,
  kMoveY,
  kMoveZ,
  kMoveXY,
  kMoveYZ,
  kMoveZX,
  kMoveCenter,
  kRotateX,
  kRotateY,
  kRotateZ,
  kRotateScreen,
  kScaleX,
  kScaleY,
  kScaleZ,
  kScaleUniform,
  kPolePlusX,
  kPoleMinusX,
  kPolePlusY,
  kPoleMinusY,
  kPolePlusZ,
  kPoleMinusZ,
  kBelly,
  kBend,
};
inline constexpr int kGizmoHandleCount = 24;  ///< kNone included.

/// "move.x", "move.xy", "move.center", "rotate.screen", "scale.uniform", "pole.+x", "shape.belly" ...; "" for kNone.
[[nodiscard]] const char* nameOf(GizmoHandle handle);
[[nodiscard]] const char* nameOf(GizmoMode mode);  ///< "poles", "move", "rotate", "scale"
[[nodiscard]] const char* nameOf(GizmoAxes axes);  ///< "world", "bone", "primitive"

/// A frame as the gizmo sees it.
struct GizmoContext {
  View view;
  glm::mat4 boneInWorld{1.0f};
  float characterHeight = 1.0f;             ///< H: the step of a snapped move is 1 % of it.
  float uiScale = 1.0f;                     ///< Pixels of View per design pixel.
  float reach = 2.0f;                       ///< Reach of the muscle; limits its belly.
  bool shapeHandles = false;                ///< With handles for belly and bend.
  std::optional<glm::vec3> pivotInWorld{};  ///< Place of the handles and center of rotations; else the center.
};

/// Motion along one way, summed over the frames of a drag.
struct GizmoTrack {
  glm::vec3 traveled{0.0f};   ///< Coordinates in the gizmo's axes (world lengths), or x = radians, or x = pixels.
  glm::vec2 lastPixel{0.0f};  ///< In the last frame.
};

/// Effect of a drag so far, in world space, for muscles dragged along.
struct GizmoEffect {
  glm::vec3 moved{0.0f};
  glm::vec3 turnAxis{0.0f, 1.0f, 0.0f};  ///< Unit.
  float angle = 0.0f;                    ///< Radians, world sense.
  glm::vec3 pivot{0.0f};                 ///< Center of rotation.
  glm::vec3 factors{1.0f};               ///< On the radii, along each primitive's own axes; 1 for poles.
};

/// A drag in progress. Deltas are in the chosen axes, relative to the placement at the start.
struct GizmoDrag {
  GizmoHandle handle = GizmoHandle::kNone;
  Placement start;
  glm::vec2 pressPixel{0.0f};
  glm::vec2 pointer{0.0f};
  float grabbedLength = 1.0f;  ///< Scale: world distance from the center at which the handle was grabbed.
  Way lock = Way::kNone;       ///< The axis whose key was pressed; kNone: that of the handle.
  std::string typed;           ///< Number being typed; "" if none.
  std::array<GizmoTrack, kAllWays.size()> tracks;  ///< By trackOf(way).
  Placement current;
  float angle = 0.0f;   ///< Rotate: radians, world sense; for the drawn wedge.
  float factor = 1.0f;  ///< Scale; for the drawn arm.
  GizmoEffect effect;
  std::string value;  ///< "X 0.12", drawn at the pointer.
};

/// The gizmo between frames.
struct GizmoState {
  GizmoMode mode = GizmoMode::kMove;
  GizmoAxes axes = GizmoAxes::kBone;
  GizmoHandle hovered = GizmoHandle::kNone;
  std::optional<GizmoDrag> drag;
};

struct HandleShape {
  GizmoHandle handle = GizmoHandle::kNone;
  glm::vec2 anchor{0.0f};          ///< A whole pixel that hits this handle.
  std::vector<glm::vec2> outline;  ///< Arrow: base, tip. Plane: four corners. Ring: closed loop. Dot: its center.
  std::vector<bool> inFront;       ///< Ring: by point, whether it faces the eye.
  float depth = 0.0f;              ///< Poles: -1..1; the nearer of two wins.
  bool facesEye = true;            ///< Poles: on the near side of the ellipsoid.
};

/// The handles that can be seen and hit, without those edge-on, pointing at the eye, covered, or off the picture.
struct GizmoLayout {
  bool visible = false;
  glm::vec2 origin{0.0f};  ///< Pixel of the center.
  std::array<glm::vec3, 3> axesInWorld{glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)};
  float uiScale = 1.0f;
  std::vector<HandleShape> handles;

  [[nodiscard]] const HandleShape* find(GizmoHandle handle) const;
  [[nodiscard]] std::map<std::string, glm::vec2> namedPixels() const;  ///< Name -> pixel of every handle in `handles`.
};

/// Unit directions of the chosen axes in the world; scale always uses the primitive's. Not orthogonal on sheared bones.
[[nodiscard]] std::array<glm::vec3, 3> gizmoAxes(GizmoAxes axes, const Placement& inBone, const glm::mat4& boneInWorld);

[[nodiscard]] GizmoLayout layoutGizmo(const GizmoState& state, const Placement& inBone, const GizmoContext& context);

[[nodiscard]] GizmoHandle hitTest(const GizmoLayout& layout, const glm::vec2& pixel);  ///< Handle there, or kNone.

/// Starts a drag at a pixel of that handle.
void beginDrag(GizmoState& state, GizmoHandle handle, const Placement& inBone, const glm::vec2& pixel,
               const GizmoContext& context);

enum class DragOutcome { kDragging, kCommitted, kCanceled };

struct DragResult {
  Placement placement;  ///< Bone space; the start's if canceled.
  DragOutcome outcome = DragOutcome::kDragging;
  GizmoEffect effect;  ///< Nothing if canceled.
};

/// The effect on another ellipsoid on its bone, none on a flattened one. Radii stay above 0.2 % of H, or their start.
[[nodiscard]] Placement draggedAlong(const GizmoEffect& effect, const Placement& start, const glm::mat4& boneInWorld,
                                     float characterHeight);

/// One frame of a drag. X/Y/Z toggle a lock to an axis. A typed number sets the value: a length in character units (in
/// a plane: along the motion so far), degrees, a factor, or for poles the semi-axis in the world. Ctrl snaps (1 % of H,
/// 15 degrees, 10 %), Shift slows to a tenth, Enter or release commits, Esc or the right button cancels. state.drag
/// ends when the outcome is not kDragging. Asserts that a drag is in progress.
[[nodiscard]] DragResult updateDrag(GizmoState& state, const ViewportInput& input, const GizmoContext& context);

[[nodiscard]] std::string describe(const GizmoState& state);  ///< For the status line.

// Shared by layout, drags and drawing.

/// kShape: the belly along y, the bend along kWhole.
enum class HandleKind { kNone, kMove, kRotate, kScale, kPole, kShape };

struct HandleParts {
  HandleKind kind = HandleKind::kNone;
  Way way = Way::kNone;  ///< Poles: their axis.
  float sign = 1.0f;     ///< Poles: which end.

  friend bool operator==(const HandleParts&, const HandleParts&) = default;
};

[[nodiscard]] HandleParts partsOf(GizmoHandle handle);
[[nodiscard]] GizmoHandle handleOf(const HandleParts& parts);  ///< Inverse of partsOf; kNone if no handle has them.

[[nodiscard]] Way wayOf(const GizmoDrag& drag);  ///< The lock, or else the way of the handle.

/// A gizmo in one frame's pose.
struct GizmoBasis {
  glm::mat3 bone{1.0f};               ///< B.
  glm::dmat3 boneInverse{1.0};        ///< Double, for bones in meters under a scale of 0.01.
  glm::vec3 origin{0.0f};             ///< Place of the handles: the pivot or the ellipsoid's center; world.
  glm::vec3 center{0.0f};             ///< The ellipsoid's, world.
  std::array<glm::vec3, 3> axes;      ///< Unit, world.
  glm::vec3 toEye{0.0f, 0.0f, 1.0f};  ///< Unit, from the origin.
  float arm = 1.0f;                   ///< World length of kGizmoArmPixels at the origin.

  [[nodiscard]] const glm::vec3& along(Way axis) const { return axes[static_cast<std::size_t>(axisOf(axis))]; }
  /// An axis, or the line of sight.
  [[nodiscard]] const glm::vec3& ringNormal(Way way) const { return isAxis(way) ? along(way) : toEye; }
};

inline constexpr float kGizmoArmPixels = 95.0f;

/// nullopt: the bone is flattened or not finite, or the origin is not before the eye.
[[nodiscard]] std::optional<GizmoBasis> gizmoBasis(GizmoAxes axes, const Placement& inBone,
                                                   const GizmoContext& context);

/// The basis of a drag: scale, poles and shape along the primitive's axes, the last two about its center, not a pivot.
[[nodiscard]] std::optional<GizmoBasis> basisOfDrag(const GizmoState& state, GizmoHandle handle,
                                                    const Placement& inBone, const GizmoContext& context);

[[nodiscard]] inline GizmoAxes effectiveAxes(GizmoMode mode, GizmoAxes axes) {
  return mode == GizmoMode::kScale || mode == GizmoMode::kPoles ? GizmoAxes::kPrimitive : axes;
}

/// Parameter of a line's point (unit direction) nearest to the ray; nullopt: parallel to 2 degrees, or behind the eye.
[[nodiscard]] std::optional<float> alongLine(const glm::vec3& origin, const glm::vec3& direction, const Ray& ray);

/// Where the ray meets a plane; nullopt: it grazes the plane within 1 degree, or the point is behind the eye.
[[nodiscard]] std::optional<glm::vec3> onPlane(const glm::vec3& origin, const glm::vec3& normal, const Ray& ray);

/// A pole relative to the center, in bone space: where the visible body is widest along an axis.
[[nodiscard]] glm::vec3 poleInBone(const Placement& inBone, int axis, float sign);

[[nodiscard]] glm::vec3 axisMiddleInBone(const Placement& inBone);  ///< Relative to the center, in bone space.
/// The point of the thickest section, half way between poles, furthest towards `toEye`; from the center, bone space.
[[nodiscard]] glm::vec3 thickestInBone(const Placement& inBone, const glm::vec3& toEye);

/// Moves the belly along the axis. @param traveled  in radii y of the start  @param typed  the belly itself
[[nodiscard]] Placement withBelly(const Placement& start, float traveled, float reach, std::optional<float> typed);
/// Moves the middle of the axis sideways.
/// @param way  X, Z, or both  @param traveled  in radii of the start  @param typed  the bend along the way, or X
[[nodiscard]] Placement withBend(const Placement& start, Way way, const glm::vec3& traveled, float reach,
                                 std::optional<float> typed);

[[nodiscard]] glm::vec3 across(const glm::vec3& direction);  ///< Any unit vector perpendicular to a unit vector.

}  // namespace sinew::app
