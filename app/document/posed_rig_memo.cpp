// app/document/posed_rig_memo.cpp: a rig is taken up when its revision changes, posed when the pose does.
#include "app/document/posed_rig_memo.h"

namespace sinew::app {

const std::shared_ptr<const RigPoser>& PosedRigMemo::poser(const Rig& rig, std::size_t revision,
                                                           const std::shared_ptr<const Character>& character) {
  if (poser_ && revision_ == revision && character_ == character) return poser_;
  character_ = character;
  revision_ = revision;
  poser_ = std::make_shared<const RigPoser>(rig, *character);
  pose_.reset();
  return poser_;
}

const PosedRig& PosedRigMemo::posed(const Rig& rig, std::size_t revision,
                                    const std::shared_ptr<const Character>& character, const Pose& pose) {
  const RigPoser& asked = *poser(rig, revision, character);
  if (pose_ != pose) {
    pose_ = pose;
    asked.pose(pose, posed_);
  }
  return posed_;
}

}  // namespace sinew::app
