// core/surface/posed_field.h: a preparation in one pose: numbers of the rig, placed muscles, skinned mesh.
#pragma once

#include <memory>
#include <vector>

#include "core/character/skinning.h"
#include "core/rig/posed_rig.h"
#include "core/surface/preparation.h"

namespace sinew {

/// Made once per pose for all later stages. Keeps its memory, and results for unchanged numbers and weights of morph
/// targets; nothing else carries over from pose to pose.
struct PosedField {
  const PosedRig* rig = nullptr;
  SkinnedMesh control;                               ///< World.
  std::shared_ptr<const Preparation> skinnedFrom{};  ///< Preparation whose morph targets `control` caches.
  std::vector<PosedPrimitive> primitives;            ///< [A] world.
  PosedCliqueSets cliqueSets;                        ///< If keys or drivers change links.
  const BindReading* bind = nullptr;                 ///< For the numbers of this pose.

  // If keys or drivers change primitives or links:
  std::vector<FieldPrimitive> driven;  ///< [A]
  BindReading drivenBind;
  std::vector<MuscleNumbers> readWith;  ///< Numbers of drivenBind.
  std::vector<float> readWithLinks;
  std::shared_ptr<const Preparation> readFrom{};  ///< Preparation of drivenBind; null: it is empty.
  BindScratch scratch;

  /// What vertices see.  @param preparation  that of this pose
  [[nodiscard]] FieldView view(const Preparation& preparation) const {
    return {primitives, preparation.seen.get(), {}, preparation.poser->drivesLinks() ? &cliqueSets : nullptr};
  }
};

/// @param rig  posed by preparation->poser in this pose; must outlive the use of `out`.
void poseFieldAndSkin(const std::shared_ptr<const Preparation>& preparation, const PosedRig& rig, const Pose& pose,
                      PosedField& out);

/// poseFieldAndSkin() without the skinned mesh, for callers that skin by other means.
void placeMuscles(const std::shared_ptr<const Preparation>& preparation, const PosedRig& rig, PosedField& out);

/// Places only the primitives; reads nothing made from a mesh or bind pose.  @param numbers  scratch.  @param out [A]
void posePrimitives(const Preparation& preparation, const PosedRig& rig, std::vector<FieldPrimitive>& numbers,
                    std::vector<PosedPrimitive>& out);

}  // namespace sinew
