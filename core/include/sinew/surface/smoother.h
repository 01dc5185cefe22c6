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

/// Skin, patch, project, remove folds, shading normals: stages in files of their own, in order.
/// prepare() once per edit, smooth() once per pose. Editor, command line, export and tests all go through here.
/// The surface depends only on the character, the rig and the pose, never on earlier ones.
/// Not thread-safe; use one Smoother per thread (the character is shared, read-only), or a CrowdSmoother.
class Smoother {
 public:
  /// @param projection  all but newton work vertex by vertex in double precision: references to compare with.
  explicit Smoother(std::shared_ptr<const Character> character, ProjectionKind projection = ProjectionKind::kNewton);
  ~Smoother();
  Smoother(Smoother&&) noexcept;
  Smoother& operator=(Smoother&&) noexcept;

  /// A copy for another thread, with the same preparation. Their surfaces share one Refinement.
  [[nodiscard]] Smoother twin() const;

  /// Prepares a rig: attachment, candidate lists, refinement tables, triangle classes. Reuses unchanged parts.
  /// Error: the rig is invalid, the blending graph too large, the refined mesh would not fit memory, or the processor
  /// lacks SSE4; then the former preparation stays in force.
  /// @param hidden  indices into the rig's primitives, ascending, that contribute nothing: the surface is, to the bit,
  ///                that of the rig without them. Showing and hiding attach nothing again.
  /// @param region  [T] triangles to refine by the rig's settings, with a margin of three triangles; the others stay
  ///                single triangles, which muscles move as well. Empty: the whole body.
  [[nodiscard]] Result<void> prepare(const Rig& rig, std::span<const int> hidden = {}, const Region& region = {});

  /// Fills `out` for a pose of this skeleton. prepare() must have succeeded once. Reuses the output's memory.
  /// False: checkPose (sinew/character/pose_check.h) refuses the pose, and `out` stays as it is.
  /// @param eye  world; if given, control triangles whose vertex normals point away from it stay on their patches, as
  ///             in the paper (4.3): for comparison, since muscles past the outline are missing.
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
