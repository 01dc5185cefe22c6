// core/surface/posed_field.h: a preparation in one pose: the rig's numbers, the placed muscles, the skinned mesh.
#pragma once

#include <memory>
#include <vector>

#include "core/character/skinning.h"
#include "core/rig/posed_rig.h"
#include "core/surface/preparation.h"

namespace sinew {

/// Made once per pose; everything after it reads it. Keeps its memory, and what stays the same while numbers and
/// weights of morph targets do; nothing else goes from pose to pose.
struct PosedField {
  const PosedRig* rig = nullptr;
  SkinnedMesh control;                               ///< World.
  std::shared_ptr<const Preparation> skinnedFrom{};  ///< Whose morph targets the mesh remembers.
  std::vector<PosedPrimitive> primitives;            ///< [A] world.
  const BindReading* bind = nullptr;                 ///< With the numbers of this pose.

  // Where keys or drivers change primitives.
  std::vector<FieldPrimitive> driven;  ///< [A]
  BindReading drivenBind;
  std::vector<MuscleNumbers> readWith;            ///< The numbers that drivenBind was read with,
  std::shared_ptr<const Preparation> readFrom{};  ///< and the preparation; null: it holds nothing.
  BindScratch scratch;
};

/// @param rig  posed by preparation->poser in this pose; must outlive the use of `out`.
void poseFieldAndSkin(const std::shared_ptr<const Preparation>& preparation, const PosedRig& rig, const Pose& pose,
                      PosedField& out);

// The muscles of a pose without its mesh, for those who skin by other means.

/// What poseFieldAndSkin does, but for the skinned mesh, which it leaves as it is.
/// @param rig  as there
void placeMuscles(const std::shared_ptr<const Preparation>& preparation, const PosedRig& rig, PosedField& out);

/// The primitives alone: reads nothing that follows from a mesh or a bind pose.
/// @param numbers  scratch.  @param out [A] world
void posePrimitives(const Preparation& preparation, const PosedRig& rig, std::vector<FieldPrimitive>& numbers,
                    std::vector<PosedPrimitive>& out);

}  // namespace sinew
