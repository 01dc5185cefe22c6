// core/bodies/mend_belly.h: muscles that ride the wrong bone, or skin that they should not reach. docs/muscles.md.
#pragma once

#include <optional>
#include <string>

#include "core/bodies/belly_trial.h"
#include "core/bodies/check.h"
#include "core/bodies/motions.h"
#include "core/rig/mirror.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

struct MendedBelly {
  Rig rig;
  std::string said;  ///< "rides spine.2"; empty: nothing helps, and the rig is as it was.
};

/// Tries what keeps a belly under its skin over all poses, off its line if it is on one: each bone that carries the
/// skin over it; then between two of these, on a line that carries it and does nothing else. Its twin likewise.
[[nodiscard]] Result<MendedBelly> withMendedBelly(Rig rig, int primitive, const Motions& motions,
                                                  const MirrorPlan* plan);

/// Only deeper, by its lower side alone. nullopt: that does not help.
[[nodiscard]] std::optional<BellyChoice> withDeeperBelly(const BellyChoice& choice, const SurfaceSettings& surface,
                                                         const Motions& motions);

/// A kReachesAcross's bone goes from the territory; of the twin's likewise.
[[nodiscard]] Rig withoutFarSkin(Rig rig, const Finding& finding, const MirrorPlan* plan);

}  // namespace sinew
