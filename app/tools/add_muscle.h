#pragma once  // app/tools/add_muscle.h: press on the skin and drag: an ellipsoid grows there.

#include <memory>
#include <optional>
#include <string>

#include "app/tools/input.h"
#include "app/tools/select.h"

namespace sinew::app {

/// A gesture in progress.
struct AddMuscleDrag {
  SkinAnchor anchor;
  int bone = -1;
  glm::vec2 pressPixel{0.0f};
  bool dragged = false;  ///< Has once left the press pixel by more than a click's tremor.
  Selection selectionBefore;
  std::shared_ptr<const Rig> rigBefore;
};

struct AddMuscleState {
  std::optional<AddMuscleDrag> drag;
};

/// An ellipsoid half buried in the skin at `start`, reaching to where the pointer's ray meets the tangent plane. Its
/// long axis (x) lies along the drag, its thickness (z) along the normal, +z out of the skin. Without a drag
/// (`pointer` empty, or less than 1 % of H away): 5 % of H, along `boneAxisInWorld` laid into the tangent plane.
/// Under uneven bone scale the long axis and the tangent plane are kept and their extents exact. Semi-axes in the
/// world lie within 1 % and 75 % of H.
/// @param boneInWorld  of the same moment as `start`; not flattened (asserted).
[[nodiscard]] Placement placementOnSkin(const SkinPoint& start, const std::optional<Ray>& pointer,
                                        const glm::mat4& boneInWorld, const glm::vec3& boneAxisInWorld,
                                        float characterHeight);

/// Starts at hover.skin: the muscle is there at once, selected. Error: no skin there, the bone is flattened in this
/// pose or the rig refuses; then nothing has begun.
[[nodiscard]] Result<void> beginAddMuscle(AddMuscleState& state, const ViewportContext& context,
                                          const ViewportHover& hover, const glm::vec2& pixel);

/// Follows the pointer; ends on release (one undo step), cancels on Esc and the right button. state.drag ends with it.
void updateAddMuscle(AddMuscleState& state, const FrameInput& input, const ViewportContext& context, const View& view);

/// Ends a gesture without a trace.
void cancelAddMuscle(AddMuscleState& state, Document& document);

/// For the outliner: a muscle around the middle of a bone, along it, a little thicker than the skin in the bind pose;
/// selected. One undo step. @return its name.
[[nodiscard]] Result<std::string> addMuscleOnBone(Document& document, int bone);

}  // namespace sinew::app
