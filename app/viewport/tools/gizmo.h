// app/viewport/tools/gizmo.h: move, rotate and scale handles of one ellipsoid: layout, hits, drags, all as values.
//
// Everything works in the pose of the current frame and comes back as a bone-space Placement: no matrix is decomposed.
// With B the bone's 3x3 (rotation, scale, uneven too), q and r the placement's rotation and radii:
//   move    a world displacement d changes the center by inverse(B) d: exact for every bone.
//   rotate  by theta about a world direction n: in bone space about normalize(inverse(B) n). The line n stays put in
//           the world; under even scale that is exactly the world rotation, under uneven scale the turn is sheared with
//           the bone (the result must remain an ellipsoid on the bone). Mirrored bones turn the other way round in bone
//           space, so that the world's sense is kept.
//   scale   changes radii, which lie along the primitive's own axes whatever axes are chosen.
//           About a pivot that is not the center, the center goes round it by the same turn of the world.
//   shape   belly and bend, of muscles that have a shape, while there are no other handles than poles.
//   poles   one semi-axis, measured in the world along B q e_i; the opposite pole stays, or with Alt the center.
// A bone flattened to a plane cannot be edited in the picture: its layout is empty.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/viewport/render/view.h"
#include "app/viewport/tools/gizmo_way.h"
#include "app/viewport/tools/input.h"
#include "sinew/geometry/ellipsoid.h"

namespace sinew::app {

enum class GizmoMode { kPoles, kMove, kRotate, kScale };  ///< The pole handles are there in every mode.
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

/// What a gizmo needs to know of a frame.
struct GizmoContext {
  View view;
  glm::mat4 boneInWorld{1.0f};
  float characterHeight = 1.0f;             ///< H: the step of a snapped move is 1 % of it.
  float uiScale = 1.0f;                     ///< Pixels of View per design pixel.
  float reach = 2.0f;                       ///< The muscle's reach: its belly's limit follows from it.
  bool shapeHandles = false;                ///< Belly and bend can be pulled.
  std::optional<glm::vec3> pivotInWorld{};  ///< Where the handles stand and turns turn about; else the center.
};

/// Motion along one way a handle may go, summed over the frames of a drag.
struct GizmoTrack {
  glm::vec3 traveled{0.0f};   ///< Coordinates in the gizmo's axes (world lengths), or x = radians, or x = pixels.
  glm::vec2 lastPixel{0.0f};  ///< Up to where it is summed.
};

/// What a drag has done so far, for others that are dragged along: in the world, and as factors on the radii.
struct GizmoEffect {
  glm::vec3 moved{0.0f};
  glm::vec3 turnAxis{0.0f, 1.0f, 0.0f};  ///< Unit.
  float angle = 0.0f;                    ///< Radians, world sense.
  glm::vec3 pivot{0.0f};                 ///< Center of the turn.
  glm::vec3 factors{1.0f};  ///< Factors on the radii, each primitive's own axes. Poles: 1, they pull theirs alone.
};

/// A drag in progress. Deltas are in the chosen axes, relative to the placement at the start.
struct GizmoDrag {
  GizmoHandle handle = GizmoHandle::kNone;
  Placement start;
  glm::vec2 pressPixel{0.0f};
  glm::vec2 pointer{0.0f};
  float grabbedLength = 1.0f;  ///< Scale: world distance from the center at which the handle was grabbed.
  Way lock = Way::kNone;       ///< The axis whose key was pressed; kNone: as the handle goes.
  std::string typed;           ///< Number being typed; "" if none.
  std::array<GizmoTrack, kAllWays.size()> tracks;  ///< By trackOf(way).
  Placement current;
  float angle = 0.0f;   ///< Rotate: radians so far, world sense; for the drawn wedge.
  float factor = 1.0f;  ///< Scale: so far; the drawn arm follows.
  GizmoEffect effect;
  std::string value;  ///< "X 0.12": drawn at the pointer.
};

/// The gizmo between frames.
struct GizmoState {
  GizmoMode mode = GizmoMode::kMove;
  GizmoAxes axes = GizmoAxes::kBone;
  GizmoHandle hovered = GizmoHandle::kNone;
  std::optional<GizmoDrag> drag;
};

/// One handle on the screen: a polyline or polygon in pixels and a pixel that surely hits it.
struct HandleShape {
  GizmoHandle handle = GizmoHandle::kNone;
  glm::vec2 anchor{0.0f};          ///< Whole pixels; hits this handle.
  std::vector<glm::vec2> outline;  ///< Arrow: base, tip. Plane: four corners. Ring: closed loop. Dot: its center.
  std::vector<bool> inFront;       ///< Ring: whether each point of the outline is on the half facing the eye.
  float depth = 0.0f;              ///< Poles: -1..1; the nearer wins where two lie on each other.
  bool facesEye = true;            ///< Poles: on the near side of the ellipsoid.
};

/// The handles that can be seen and hit; others (edge-on, pointing at the eye, covered, off the picture) are left out.
struct GizmoLayout {
  bool visible = false;
  glm::vec2 origin{0.0f};  ///< Pixel of the center.
  std::array<glm::vec3, 3> axesInWorld{glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)};
  float uiScale = 1.0f;
  std::vector<HandleShape> handles;

  [[nodiscard]] const HandleShape* find(GizmoHandle handle) const;
  /// Name -> pixel of every handle in `handles`.
  [[nodiscard]] std::map<std::string, glm::vec2> namedPixels() const;
};

/// Unit directions of the chosen axes in the world; scale always uses the primitive's. Not orthogonal on sheared bones.
[[nodiscard]] std::array<glm::vec3, 3> gizmoAxes(GizmoAxes axes, const Placement& inBone, const glm::mat4& boneInWorld);

[[nodiscard]] GizmoLayout layoutGizmo(const GizmoState& state, const Placement& inBone, const GizmoContext& context);

/// The handle under a pixel, or kNone.
[[nodiscard]] GizmoHandle hitTest(const GizmoLayout& layout, const glm::vec2& pixel);

/// Starts a drag at a pixel of that handle.
void beginDrag(GizmoState& state, GizmoHandle handle, const Placement& inBone, const glm::vec2& pixel,
               const GizmoContext& context);

enum class DragOutcome { kDragging, kCommitted, kCanceled };

struct DragResult {
  Placement placement;  ///< Bone space; the start's if canceled.
  DragOutcome outcome = DragOutcome::kDragging;
  GizmoEffect effect;  ///< Nothing if canceled.
};

/// The effect on another ellipsoid, from its placement at the start, on a bone as it stands now. A flattened bone: as
/// it was. Radii never go below 0.2 % of H, or what they were.
[[nodiscard]] Placement draggedAlong(const GizmoEffect& effect, const Placement& start, const glm::mat4& boneInWorld,
                                     float characterHeight);

/// One frame of a drag. X/Y/Z lock to an axis, the same key again frees. A typed number is the value: a length in
/// character units (in a plane: along the motion so far), degrees, a factor, or for poles the semi-axis in the world.
/// Ctrl snaps (1 % of H, 15 degrees, 10 %), Shift slows to a tenth, Enter or release commits, Esc or the right button
/// cancels. state.drag ends when the outcome is not kDragging. Asserts that a drag is in progress.
[[nodiscard]] DragResult updateDrag(GizmoState& state, const ViewportInput& input, const GizmoContext& context);

/// For the status bar: what is happening and what the keys would do.
[[nodiscard]] std::string describe(const GizmoState& state);

}  // namespace sinew::app
