// core/bodies/learn_full.h: how short a line gets in what its character does.
#pragma once

#include "core/bodies/motions.h"
#include "sinew/rig/muscle_line.h"

namespace sinew {

/// Full contraction from the 2nd percentile of its lengths. A line that never shortens keeps what it has.
void learnFull(MuscleLine& line, const Motions& motions);

}  // namespace sinew
