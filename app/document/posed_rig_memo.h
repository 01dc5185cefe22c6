// app/document/posed_rig_memo.h: the document's rig in the pose that is shown, made once however many ask for it.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "core/rig/posed_rig.h"
#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

/// Remembers the last rig and the last pose that were asked for.
class PosedRigMemo {
 public:
  /// @param revision  CommandStack::revision(): equal numbers, equal rigs
  [[nodiscard]] const std::shared_ptr<const RigPoser>& poser(const Rig& rig, std::size_t revision,
                                                             const std::shared_ptr<const Character>& character);
  /// Valid until the next call.
  [[nodiscard]] const PosedRig& posed(const Rig& rig, std::size_t revision,
                                      const std::shared_ptr<const Character>& character, const Pose& pose);

 private:
  std::shared_ptr<const Character> character_;  ///< Outlives the poser.
  std::size_t revision_ = 0;
  std::shared_ptr<const RigPoser> poser_;
  std::optional<Pose> pose_;  ///< What posed_ shows.
  PosedRig posed_;
};

}  // namespace sinew::app
