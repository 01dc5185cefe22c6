// core/include/sinew/rig/mirror_edit.h: mirror images of muscles, and a clip that moves all joints.
#pragma once

#include <memory>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Finds a character's mirror plane and pairs of bones once. Rigs are taken by value, as in sinew/rig/rig_edit.h;
/// indices must be in range (asserted).
class MirrorEdits {
 public:
  explicit MirrorEdits(const Character& character);
  ~MirrorEdits();
  MirrorEdits(MirrorEdits&&) noexcept;
  MirrorEdits& operator=(MirrorEdits&&) noexcept;

  [[nodiscard]] bool usable() const;  ///< Whether anything can be mirrored.

  /// Appends a primitive and its mirror image, linked; only the primitive if it is its own image.
  /// Error: its bone is missing or has no counterpart, or addPrimitive() refuses it.
  [[nodiscard]] Result<Rig> addPair(Rig rig, Primitive primitive) const;
  /// Makes the twin of a primitive its image, or appends one if it has none.
  [[nodiscard]] Result<Rig> mirrorToOtherSide(Rig rig, int index) const;
  /// Links two different primitives and makes the second the image of the first, except for its name.
  [[nodiscard]] Result<Rig> linkTwins(Rig rig, int leader, int follower) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A clip "Range of motion" that moves every joint through its range (docs/editor.md); no channels if none can turn.
[[nodiscard]] AnimationClip rangeOfMotion(const Character& character);

}  // namespace sinew
