// tests/support/rigs/rig_copies.h: how often a rig is copied.
#pragma once

#include "sinew/rig/rig.h"
#include "tests/support/allocations.h"

namespace sinew::test {

/// Counts copies of rigs with as many primitives as this one, told by the memory that these take.
class RigCopies {
 public:
  explicit RigCopies(const Rig& rig) : primitives_(rig.primitives.size() * sizeof(Primitive)) {}

  [[nodiscard]] int count() const { return static_cast<int>(primitives_.count()); }

 private:
  AllocationsOf primitives_;
};

}  // namespace sinew::test
