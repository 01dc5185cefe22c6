// app/document/command_stack.cpp: the history of rig, pose and play ranges.
#include "app/document/command_stack.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <string>
#include <utility>

namespace sinew::app {

// Identities of clips.

std::vector<ClipId> clipIds(const Character& character) {
  std::vector<ClipId> ids;
  std::map<std::string, int> counts;
  for (const AnimationClip& clip : character.clips) ids.push_back({clip.addedFrom, counts[clip.addedFrom]++});
  return ids;
}

int indexOf(const Character& character, const ClipId& clip) {
  const std::vector<ClipId> ids = clipIds(character);
  const auto found = std::ranges::find(ids, clip);
  return found == ids.end() ? -1 : static_cast<int>(found - ids.begin());
}

KeptPlayRanges keptRanges(const PlayRanges& ranges, const Character& character) {
  const std::vector<ClipId> ids = clipIds(character);
  KeptPlayRanges kept;
  for (const auto& [clip, range] : ranges) {
    if (clip >= 0 && clip < static_cast<int>(ids.size())) kept[ids[static_cast<std::size_t>(clip)]] = range;
  }
  return kept;
}

PlayRanges rangesOf(const KeptPlayRanges& ranges, const Character& character) {
  const std::vector<ClipId> ids = clipIds(character);
  PlayRanges found;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto range = ranges.find(ids[i]);
    if (range != ranges.end()) found[static_cast<int>(i)] = range->second;
  }
  return found;
}

CommandStack::CommandStack(Rig rig) {
  identities_.identify(rig, Rig{});
  current_ = std::make_shared<const Rig>(std::move(rig));
  saved_ = current_;
  steps_.push_back({"Open", current_, {}, {}});
}

void CommandStack::show(std::shared_ptr<const Rig> rig) {
  if (current_ == rig) return;
  current_ = std::move(rig);
  ++revision_;
}

void CommandStack::apply(const std::string& label, Rig rig) {
  beginGesture(label);
  updateGesture(std::move(rig));
  endGesture();
}

void CommandStack::beginGesture(const std::string& label) {
  if (gesture_) endGesture();
  gesture_ = true;
  gestureLabel_ = label;
}

void CommandStack::updateGesture(Rig rig) {
  assert(gesture_);
  if (*current_ == rig) return;
  identities_.identify(rig, *current_);
  if (keeper_) {
    rig = keeper_(*steps_[position_].rig, *current_, std::move(rig));
    identities_.identify(rig, *current_);  // It may have added some.
  }
  if (*current_ == rig) return;
  show(std::make_shared<const Rig>(std::move(rig)));
}

void CommandStack::endGesture() {
  if (!gesture_) return;
  gesture_ = false;
  const std::shared_ptr<const Rig> before = steps_[position_].rig;
  if (current_ == before) return;
  if (*current_ == *before) {
    current_ = before;  // Equal as a value, so the revision stays.
    return;
  }
  push({gestureLabel_, current_, pose(), ranges()});
}

void CommandStack::endGesture(const std::string& label) {
  gestureLabel_ = label;
  endGesture();
}

void CommandStack::push(Step step) {
  steps_.resize(position_ + 1);
  steps_.push_back(std::move(step));
  ++position_;
}

void CommandStack::applyPose(const std::string& label, const PoseOverrides& pose) {
  endGesture();
  if (!(this->pose() == pose)) push({label, current_, pose, ranges()});
}

void CommandStack::applyRanges(const std::string& label, const KeptPlayRanges& ranges) {
  if (this->ranges() == ranges) return;
  endGesture();
  push({label, current_, pose(), ranges});
}

void CommandStack::cancelGesture() {
  if (!gesture_) return;
  gesture_ = false;
  show(steps_[position_].rig);
}

void CommandStack::startFrom(const PoseOverrides& pose, const KeptPlayRanges& ranges) {
  for (Step& step : steps_) {
    step.pose = pose;
    step.ranges = ranges;
  }
}

bool CommandStack::canUndo() const { return gesture_ || position_ > 0; }

bool CommandStack::canRedo() const { return !gesture_ && position_ + 1 < steps_.size(); }

void CommandStack::undo() {
  if (gesture_) {
    cancelGesture();
  } else if (position_ > 0) {
    show(steps_[--position_].rig);
  }
}

void CommandStack::redo() {
  if (canRedo()) show(steps_[++position_].rig);
}

void CommandStack::jumpTo(std::size_t step) {
  assert(step < steps_.size());
  cancelGesture();
  position_ = step;
  show(steps_[position_].rig);
}

bool CommandStack::modified() const { return saved_ != current_ && !(*saved_ == *current_); }

}  // namespace sinew::app
