// app/document/visibility.h: which muscles the editor shows, moves and lets be picked. Never saved.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sinew/character/skeleton.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

/// One of the three switches that muscles and bones have.
enum class Mark { kHidden, kLocked, kSolo };

/// View state. Bones by path (Bone::path); what is said of a bone holds for every muscle on it and below it. What is
/// said of a muscle stays while undo has taken it away.
struct Visibility {
  /// Who carries a mark.
  struct Marks {
    std::set<PrimitiveId> muscles;
    std::set<std::string> bones;

    [[nodiscard]] bool empty() const { return muscles.empty() && bones.empty(); }
    friend bool operator==(const Marks&, const Marks&) = default;
  };

  Marks hidden;
  Marks locked;
  Marks solo;                                     ///< If a bone or a muscle of the rig carries it, the rest is hidden.
  std::optional<std::set<PrimitiveId>> isolated;  ///< Only these muscles are shown, in what is otherwise visible.
  PrimitiveId newest;                             ///< The last that welcomeNew has seen.
  bool bare = false;                              ///< No muscle at all: the character as it was before.

  [[nodiscard]] Marks& marks(Mark mark);
  [[nodiscard]] const Marks& marks(Mark mark) const;
  void setMuscle(Mark mark, PrimitiveId muscle, bool on);
  void setBone(Mark mark, const std::string& bonePath, bool on);
  /// Nothing is left out and nothing locked.
  [[nodiscard]] bool plain() const;

  friend bool operator==(const Visibility&, const Visibility&) = default;
};

/// Index into Skeleton::bones for every primitive of the rig; -1: unattached. What Skeleton::findBone says, quicker for
/// many.
[[nodiscard]] std::vector<int> boneOfEach(const Rig& rig, const Skeleton& skeleton);

/// What holds for each muscle of a rig after bones, solo, isolation and `bare` are taken into account.
struct EffectiveVisibility {
  std::vector<bool> visible;     ///< [primitives] False: not drawn, and does not deform the skin.
  std::vector<bool> locked;      ///< [primitives]
  std::vector<bool> boneHidden;  ///< [bones] itself or a bone above it.
  std::vector<bool> boneLocked;  ///< [bones]
};
/// @param boneOf  boneOfEach(rig, skeleton)
[[nodiscard]] EffectiveVisibility effectiveVisibility(const Visibility& visibility, const Rig& rig,
                                                      const Skeleton& skeleton, const std::vector<int>& boneOf);

/// Rig indices of the muscles that are left out, ascending.
[[nodiscard]] std::vector<int> hiddenPrimitives(const Visibility& visibility, const Rig& rig, const Skeleton& skeleton);
/// By rig index: neither hidden nor locked.
[[nodiscard]] bool isPickable(const Visibility& visibility, const Rig& rig, const Skeleton& skeleton, int primitive);

/// A muscle made while others are soloed or isolated joins them: it is what one works on. Identities grow, so that what
/// undo or redo bring back is not new.
void welcomeNew(Visibility& visibility, const Rig& rig, const Skeleton& skeleton);

}  // namespace sinew::app
