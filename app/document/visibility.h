// app/document/visibility.h: which muscles the editor shows and lets the user pick. Not saved in the rig.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sinew/character/skeleton.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

enum class Mark { kHidden, kLocked, kSolo };  ///< A switch of muscles and bones.

/// View state. Bones by Bone::path; a bone's mark applies to all muscles on it and below. Marks of undone muscles stay.
/// Those of a sheet are on its first belly (listed_muscles.h).
struct Visibility {
  struct Marks {
    std::set<PrimitiveId> muscles;
    std::set<std::string> bones;

    [[nodiscard]] bool empty() const { return muscles.empty() && bones.empty(); }
    friend bool operator==(const Marks&, const Marks&) = default;
  };

  Marks hidden;
  Marks locked;
  Marks solo;                                     ///< If not empty, everything else is hidden.
  std::optional<std::set<PrimitiveId>> isolated;  ///< Of the visible muscles, only these are shown.
  PrimitiveId newest;                             ///< The last one that welcomeNew() has seen.
  bool bare = false;                              ///< Without muscles.

  [[nodiscard]] Marks& marks(Mark mark);
  [[nodiscard]] const Marks& marks(Mark mark) const;
  void setMuscle(Mark mark, PrimitiveId muscle, bool on);
  void setBone(Mark mark, const std::string& bonePath, bool on);
  [[nodiscard]] bool plain() const;  ///< Nothing is hidden or locked.

  friend bool operator==(const Visibility&, const Visibility&) = default;
};

/// [primitives] index into Skeleton::bones; -1: unattached. Faster than Skeleton::findBone for many.
[[nodiscard]] std::vector<int> boneOfEach(const Rig& rig, const Skeleton& skeleton);

/// Visibility of each muscle and bone with all marks applied.
struct EffectiveVisibility {
  std::vector<bool> visible;     ///< [primitives] Drawn, and deforms the skin.
  std::vector<bool> locked;      ///< [primitives]
  std::vector<bool> boneHidden;  ///< [bones] Itself or a bone above.
  std::vector<bool> boneLocked;  ///< [bones]
};
/// @param boneOf  boneOfEach(rig, skeleton)
[[nodiscard]] EffectiveVisibility effectiveVisibility(const Visibility& visibility, const Rig& rig,
                                                      const Skeleton& skeleton, const std::vector<int>& boneOf);

/// Rig indices of invisible muscles, ascending.
[[nodiscard]] std::vector<int> hiddenPrimitives(const Visibility& visibility, const Rig& rig, const Skeleton& skeleton);
/// Neither hidden nor locked. @param primitive  rig index
[[nodiscard]] bool isPickable(const Visibility& visibility, const Rig& rig, const Skeleton& skeleton, int primitive);

/// New muscles join those that are soloed or isolated. Identities grow, so muscles restored by undo are not new.
void welcomeNew(Visibility& visibility, const Rig& rig, const Skeleton& skeleton);

}  // namespace sinew::app
