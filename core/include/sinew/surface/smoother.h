// core/include/sinew/surface/smoother.h: the pipeline from character, rig and pose to the surface.
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

/// Stages: skin, patch, project, remove folds, shading normals. Call prepare() once per edit and smooth() once per
/// pose. The surface depends only on the character, the rig and the pose, never on earlier poses. Not thread-safe; use
/// one Smoother per thread, which share the character, or a CrowdSmoother.
class Smoother {
 public:
  /// @param projection  all but kNewton work vertex by vertex in double precision, as a reference.
  explicit Smoother(std::shared_ptr<const Character> character, ProjectionKind projection = ProjectionKind::kNewton);
  ~Smoother();
  Smoother(Smoother&&) noexcept;
  Smoother& operator=(Smoother&&) noexcept;

  /// Another Smoother with the same preparation, for another thread. Their surfaces share one Refinement.
  [[nodiscard]] Smoother twin() const;

  /// Prepares for a rig: attachment, candidate lists, refinement tables, triangle classes; reuses what did not change.
  /// Error: the rig is invalid, the blending graph too large, the refined mesh would not fit memory, or the processor
  /// lacks SSE4; then the former preparation stays valid.
  /// @param hidden  ascending indices of primitives to ignore: the surface is bit for bit that of the rig without them.
  /// @param region  [T] refined as the rig says, with a margin of three triangles; elsewhere the surface has the
  ///                triangles of the control mesh, which muscles move as well. Empty: the whole body.
  [[nodiscard]] Result<void> prepare(const Rig& rig, std::span<const int> hidden = {}, const Region& region = {});

  /// Fills `out` for a pose of this skeleton. prepare() must have succeeded once. Reuses the output's memory.
  /// False: checkPose() (sinew/character/pose_check.h) refuses the pose, and `out` stays as it is.
  /// @param eye  world; control triangles invisible from there stay on their patches and are marked in Surface::culled:
  ///             only for pictures from there, never for shadows or export.
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
