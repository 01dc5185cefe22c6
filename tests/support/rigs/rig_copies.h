// tests/support/rigs/rig_copies.h: counts copies of a rig.
#pragma once

#include "sinew/rig/rig.h"
#include "tests/support/allocations.h"

namespace sinew::test {

/// Counts copies of rigs with as many primitives as this one, recognized by the size of their allocation.
class RigCopies {
 public:
  explicit RigCopies(const Rig& rig) : primitives_(rig.primitives.size() * sizeof(Primitive)) {}

  [[nodiscard]] int count() const { return static_cast<int>(primitives_.count()); }

 private:
  AllocationsOf primitives_;
};

}  // namespace sinew::test
