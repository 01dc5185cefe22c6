// core/rig/mirror_edit.cpp: the edits of twins with the character's plan.
#include "sinew/rig/mirror_edit.h"

#include <utility>

#include "core/rig/motion_clip.h"
#include "core/rig/twins.h"

namespace sinew {

struct MirrorEdits::State {
  MirrorPlan plan;
};

MirrorEdits::MirrorEdits(const Character& character)
    : state_(std::make_unique<State>(State{makeMirrorPlan(character)})) {}
MirrorEdits::~MirrorEdits() = default;
MirrorEdits::MirrorEdits(MirrorEdits&&) noexcept = default;
MirrorEdits& MirrorEdits::operator=(MirrorEdits&&) noexcept = default;

bool MirrorEdits::usable() const { return state_->plan.usable(); }

Result<Rig> MirrorEdits::addPair(Rig rig, Primitive primitive) const {
  return sinew::addPair(std::move(rig), std::move(primitive), state_->plan);
}

Result<Rig> MirrorEdits::mirrorToOtherSide(Rig rig, int index) const {
  return sinew::mirrorToOtherSide(std::move(rig), index, state_->plan);
}

Result<Rig> MirrorEdits::linkTwins(Rig rig, int leader, int follower) const {
  return sinew::linkTwins(std::move(rig), leader, follower, state_->plan);
}

AnimationClip rangeOfMotion(const Character& character) {
  return rangeOfMotion(character.skeleton, motionHints(character));
}

}  // namespace sinew
