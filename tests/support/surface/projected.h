// tests/support/surface/projected.h: what projection alone gives, in both modes, before folds and shading.
#pragma once

#include <memory>

#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/surface.h"

namespace sinew::test {

/// The stages of core/surface up to swell() or replace(), put together by hand.
class Projected {
 public:
  Projected(const Character& character, const Rig& rig, ProjectionKind projection = ProjectionKind::kNewton);
  ~Projected();
  Projected(const Projected&) = delete;
  Projected& operator=(const Projected&) = delete;
  /// Positions, displacement and normals; the patch's where nothing has moved. Valid until the next call.
  const Surface& at(const Pose& pose);
  /// The patch alone, which takes less. Valid until the next call.
  const Surface& patchAt(const Pose& pose);
  /// Vertices of the last call that the vector path left to the scalar one.
  [[nodiscard]] std::size_t uncertified() const;
  /// What the last call gave.
  [[nodiscard]] const Surface& now() const;
  /// The patch of the last call: positions and normals without muscles.
  [[nodiscard]] const Surface& patch() const;
  [[nodiscard]] const Surface& bindPatch() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew::test
