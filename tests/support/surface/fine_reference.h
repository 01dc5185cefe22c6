// tests/support/surface/fine_reference.h: approximate limit of refinement: uniform, at a large depth.
#pragma once

#include <memory>

#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/surface.h"

namespace sinew::test {

/// The surface at one depth with all stages except the height filter. At a kink the filter acts at any depth, on a
/// strip one or two edges wide.
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
