// tests/support/surface/fine_reference.h: what refinement without end would give, or nearly: one depth everywhere,
// deep.
#pragma once

#include <memory>

#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/surface.h"

namespace sinew::test {

/// The surface at one depth, by all stages but the filter of heights. At a kink that works at any depth, however fine:
/// what it takes off is an edge or two wide.
class FineReference {
 public:
  /// @param rig  a valid one; its detail is not read
  FineReference(const std::shared_ptr<const Character>& character, Rig rig, int depth);
  ~FineReference();
  FineReference(const FineReference&) = delete;
  FineReference& operator=(const FineReference&) = delete;
  /// Valid until the next call.
  const Surface& at(const Pose& pose);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew::test
