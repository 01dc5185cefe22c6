// app/viewport/tools/add_muscle.h: press on the skin and drag: an ellipsoid grows there.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/shape_presets.h"
#include "app/viewport/tools/input.h"
#include "app/viewport/tools/select.h"

namespace sinew::app {

// From the pixels of a drag to a path on the skin.

/// The skin at the moment of a press. A muscle that is being drawn lifts the skin: on the surface of each new frame the
/// same pixels would give another path, and the muscle would grow by itself.
struct SkinSnapshot {
  std::shared_ptr<const Refinement> refinement;
  std::vector<glm::vec3> positions;  ///< [V'] world.
  std::vector<glm::vec3> normals;    ///< [V'] world, unit, outward.
};

/// A path on the skin from the press towards the pointer, world space. The start is always there; it alone: a click.
struct SkinStroke {
  std::vector<SkinPoint> points;
};

/// @param surface  refined.
[[nodiscard]] SkinSnapshot snapshotOf(const Surface& surface);

/// The skin under the straight screen line from `start` to `pixel`: the cut of the skin with the plane through the eye
/// and that line, followed from triangle to triangle. It stays on one continuous piece of skin and ends under `pixel`
/// or before, where the skin ends or turns away from the eye; a fold that hides less than 2 % of H is crossed. What
/// stands in front of the skin does not end it.
/// @param start  on the snapshot's skin, in front of the eye.
[[nodiscard]] SkinStroke strokeOnSkin(const SkinSnapshot& skin, const SkinPoint& start, const View& view,
                                      const glm::vec2& pixel, float characterHeight);

/// A gesture in progress. The pose is held meanwhile (holdsPose), so what the press found holds until the release.
struct AddMuscleDrag {
  SkinSnapshot skin;
  SkinPoint start;
  int bone = -1;
  glm::mat4 boneInWorld{1.0f};
  glm::vec2 pressPixel{0.0f};
  float thicker = 1.0f;  ///< Factor on thickness and width: what the wheel has made of it.
  bool dragged = false;  ///< Has once left the press pixel by more than kDragThreshold.
  Selection selectionBefore;
  std::shared_ptr<const Rig> rigBefore;
};

struct AddMuscleState {
  std::optional<AddMuscleDrag> drag;
};

/// A flat ellipsoid in the skin along a stroke, which lifts it by about 1 % of H. Its long axis (x) lies along the
/// chord from the first point to the last, its thickness (z) along the mean skin normal made perpendicular to the
/// chord, +z out of the skin. In the middle it stands out of the skin by as much on a curved path as on a straight one,
/// and its ends are not above the path: where the path arches over the chord it is thicker and its center higher, where
/// the path sags it lies deeper. A chord below 1 % of H is a click: 5 % of H at the start, along `boneAxisInWorld` laid
/// into the tangent plane. A stroke ends where it is 150 % of H away from its start. Under uneven bone scale the long
/// axis and the tangent plane are kept and their extents exact. Semi-axes in the world lie within 1 % and 75 % of H,
/// those made thinner within 0.3 %.
/// @param stroke       not empty (asserted); world.
/// @param boneInWorld  of the same moment as the stroke; not flattened (asserted).
/// @param thicker      factor on thickness and width; the length stays, the center stays as deep for its thickness.
/// @return in bone space.
[[nodiscard]] Placement placementOnSkin(const SkinStroke& stroke, const glm::mat4& boneInWorld,
                                        const glm::vec3& boneAxisInWorld, float characterHeight, float thicker = 1.0f);

/// Starts at hover.skin: the muscle is there at once, selected. Error: no skin there, the bone is flattened in this
/// pose or the rig refuses; then nothing has begun.
[[nodiscard]] Result<void> beginAddMuscle(AddMuscleState& state, const ViewportContext& context,
                                          const ViewportHover& hover, const glm::vec2& pixel);

/// Follows the pointer, the wheel makes the muscle thicker or thinner; ends on release (one undo step), cancels on Esc
/// and the right button. state.drag ends with it.
void updateAddMuscle(AddMuscleState& state, const ViewportInput& input, const ViewportContext& context,
                     const View& view);

/// Ends a gesture without a trace.
void cancelAddMuscle(AddMuscleState& state, Document& document);

/// For the outliner: a muscle around the middle of a bone, along it, a little thicker than the skin in the bind pose
/// and at least 1.25 times as long as thick; a ball on a bone without length. Selected. One undo step. @return its
/// name.
[[nodiscard]] Result<std::string> addMuscleOnBone(Document& document, int bone,
                                                  ShapePreset preset = ShapePreset::kEllipsoid);

}  // namespace sinew::app
