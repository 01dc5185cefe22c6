// core/include/sinew/surface/smoother.h: the one pipeline from character, rig and pose to the surface.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/region.h"
#include "sinew/surface/surface.h"

namespace sinew {

/// Skin, patch, project, remove folds, shading normals: stages in files of their own, in order.
/// prepare() once per edit, smooth() once per pose. Editor, command line, export and tests all go through here.
/// The surface depends on the character, the rig and the pose alone, never on what was smoothed before.
/// Not thread-safe; use one Smoother per thread (the character is shared, read-only), or a
/// CrowdSmoother.
class Smoother {
 public:
  /// @param projection  anything but newton goes vertex by vertex in double precision: a reference, to compare with.
  explicit Smoother(std::shared_ptr<const Character> character, ProjectionKind projection = ProjectionKind::kNewton);
  ~Smoother();
  Smoother(Smoother&&) noexcept;
  Smoother& operator=(Smoother&&) noexcept;

  /// Another one, prepared as this one is, for another thread. Their surfaces share one Refinement.
  [[nodiscard]] Smoother twin() const;

  /// Takes the rig: attachment, candidate lists, refinement tables, triangle classes. Keeps what did not change.
  /// Error: the rig is invalid, the blending graph too large, the refined mesh would not fit memory, or the processor
  /// lacks SSE4; then the former preparation stays in force.
  /// @param hidden  indices into the rig's primitives, ascending, of those that contribute nothing: the surface is, bit
  ///                for bit, that of the rig without them. Showing and hiding re-attach nothing.
  /// @param region  [T] what is refined as the rig says, with a margin of three triangles; the rest keeps the triangles
  ///                of the control mesh, which muscles move as well. Empty: the whole body.
  [[nodiscard]] Result<void> prepare(const Rig& rig, std::span<const int> hidden = {}, const Region& region = {});

  /// Fills `out` for a pose of this skeleton. prepare() must have succeeded once. Reuses the output's memory.
  /// False: checkPose (sinew/character/pose_check.h) refuses the pose, and `out` stays as it is.
  /// @param eye  world; if given, control triangles it cannot see stay on their patches and are marked in
  /// Surface::culled
  ///             (face_culling.h): for a picture from there alone, never for shadows or export.
  bool smooth(const Pose& pose, Surface& out, const std::optional<glm::vec3>& eye = std::nullopt);

  [[nodiscard]] const Character& character() const;
  /// Indices into the prepared rig's primitives whose bone this character lacks; valid until the next prepare().
  [[nodiscard]] const std::vector<int>& unattached() const;

 private:
  struct State;
  explicit Smoother(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace sinew
