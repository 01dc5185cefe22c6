// core/include/sinew/rig/mirror_edit.h: muscles on the other side of a character, and a clip that turns all
// joints.
#pragma once

#include <memory>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Knows a character's plane of symmetry and which bones are each other's mirror: found once. Rigs are taken by value,
/// as in sinew/rig/rig_edit.h; indices must be in range (asserted).
class MirrorEdits {
 public:
  explicit MirrorEdits(const Character& character);
  ~MirrorEdits();
  MirrorEdits(MirrorEdits&&) noexcept;
  MirrorEdits& operator=(MirrorEdits&&) noexcept;

  /// Whether anything can be mirrored.
  [[nodiscard]] bool usable() const;

  /// Appends a primitive and its mirror image, linked. A single one where the image would be itself.
  /// Error: its bone is missing or has no counterpart, or addPrimitive() refuses it.
  [[nodiscard]] Result<Rig> addPair(Rig rig, Primitive primitive) const;
  /// Appends the image of one that has no twin yet; its twin, if it has one, becomes its image.
  [[nodiscard]] Result<Rig> mirrorToOtherSide(Rig rig, int index) const;
  /// Links two different primitives; the second becomes the image of the first but for its name.
  [[nodiscard]] Result<Rig> linkTwins(Rig rig, int leader, int follower) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A clip "Range of motion" that takes every joint through what it can do (docs/editor.md). Without channels if nothing
/// can turn.
[[nodiscard]] AnimationClip rangeOfMotion(const Character& character);

}  // namespace sinew
