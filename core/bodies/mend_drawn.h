// core/bodies/mend_drawn.h: a muscle that has just been drawn over a joint, kept in the flesh.
#pragma once

#include <optional>

#include "core/bodies/belly_trial.h"

namespace sinew {

struct DrawnMuscle {
  BellyChoice choice;
  bool isClean = true;
};

/// The first that stays in the flesh in all poses (docs/check.md): muscles that go with one bone of the line, while a
/// tendon crosses the joint; the same with an end of a line over several joints on a bone between; one that rides a
/// bone, the best of these if none is clean. Full contraction is learned from the motions. nullopt: there is no skin to
/// follow.
/// @param drawn  on a line that has a rest
[[nodiscard]] std::optional<DrawnMuscle> withDrawnMuscle(const BellyChoice& drawn, const SurfaceSettings& surface,
                                                         const Motions& motions);

/// Of these only those that leave the muscle where it is and as it is. nullopt: none is clean.
[[nodiscard]] std::optional<BellyChoice> withNearerEnd(const BellyChoice& drawn, const SurfaceSettings& surface,
                                                       const Motions& motions);

}  // namespace sinew
