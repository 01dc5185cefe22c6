// app/viewport/tools/add_muscle.h: adds muscles by drags on the skin, and around bones.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/shape_presets.h"
#include "app/viewport/tools/select.h"
#include "app/viewport/tools/viewport_input.h"

namespace sinew::app {

/// The skin at a press. The muscle being drawn lifts the skin, so paths on later surfaces would differ.
struct SkinSnapshot {
  std::shared_ptr<const Refinement> refinement;
  std::vector<glm::vec3> positions;  ///< [V'] world.
  std::vector<glm::vec3> normals;    ///< [V'] world, unit, outward.
};

/// A world-space path on the skin from the press towards the pointer. Only the start: a click.
struct SkinStroke {
  std::vector<SkinPoint> points;
};

[[nodiscard]] SkinSnapshot snapshotOf(const Surface& surface);

/// The skin under the screen line from `start` to `pixel`: its cut with the plane through the eye and that line,
/// followed over triangles. Ends under `pixel`, or where the skin ends or turns away from the eye; folds that hide less
/// than 2 % of H are crossed. Objects in front of the skin do not matter.
/// @param start  on the snapshot's skin, in front of the eye
[[nodiscard]] SkinStroke strokeOnSkin(const SkinSnapshot& skin, const SkinPoint& start, const View& view,
                                      const glm::vec2& pixel, float characterHeight);

/// A gesture in progress; the pose is held (holdsPose).
struct AddMuscleDrag {
  SkinSnapshot skin;
  SkinPoint start;
  int bone = -1;
  glm::mat4 boneInWorld{1.0f};
  glm::vec2 pressPixel{0.0f};
  float thicker = 1.0f;  ///< Factor on thickness and width, from the wheel.
  bool dragged = false;  ///< The pointer has moved by more than kDragThreshold.
  Selection selectionBefore;
  std::shared_ptr<const Rig> rigBefore;
};

struct AddMuscleState {
  std::optional<AddMuscleDrag> drag;
};

/// A flat ellipsoid along a stroke that lifts the skin by about 1 % of H. Its x axis follows the chord of the stroke,
/// its z axis the mean skin normal, perpendicular to the chord and outwards. It protrudes equally from straight and
/// curved paths and its ends do not rise above the path: where the path arches it is thicker and higher, where the path
/// sags it lies deeper. A chord below 1 % of H is a click: 5 % of H, along `boneAxisInWorld` in the tangent plane.
/// Strokes end 150 % of H from the start. Long axis, tangent plane and extents are exact under uneven bone scale. World
/// semi-axes are 1 % to 75 % of H, at least 0.3 % when made thinner.
/// @param stroke       not empty (asserted); world
/// @param boneInWorld  at the time of the stroke; not flattened (asserted)
/// @param thicker      factor on thickness and width; the relative depth of the center stays
/// @return in bone space
[[nodiscard]] Placement placementOnSkin(const SkinStroke& stroke, const glm::mat4& boneInWorld,
                                        const glm::vec3& boneAxisInWorld, float characterHeight, float thicker = 1.0f);

/// Begins at hover.skin with a muscle that is selected. Error: no skin, the bone is flattened in this pose, or the rig
/// refuses; then nothing has begun.
[[nodiscard]] Result<void> beginAddMuscle(AddMuscleState& state, const ViewportContext& context,
                                          const ViewportHover& hover, const glm::vec2& pixel);

/// Follows the pointer; the wheel changes the thickness. Ends on release (one undo step); Esc and the right button
/// cancel. Resets state.drag at the end.
void updateAddMuscle(AddMuscleState& state, const ViewportInput& input, const ViewportContext& context,
                     const View& view);

void cancelAddMuscle(AddMuscleState& state, Document& document);  ///< Ends a gesture and undoes it.

/// Adds and selects a muscle around the middle of a bone as one undo step: along it, a little thicker than the skin in
/// the bind pose, at least 1.25 times as long as thick; a ball on a bone without length. @return its name
[[nodiscard]] Result<std::string> addMuscleOnBone(Document& document, int bone,
                                                  ShapePreset preset = ShapePreset::kEllipsoid);

}  // namespace sinew::app
