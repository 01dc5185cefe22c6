// app/document/command_stack.h: the history of rig, pose and play ranges of clips: undo, redo, gestures.
#pragma once

#include <compare>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/character/pose_override.h"
#include "core/rig/references.h"
#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

/// A part of a clip, seconds.
struct PlayRange {
  double from = 0.0;
  double to = 0.0;

  friend bool operator==(const PlayRange&, const PlayRange&) = default;
};

using PlayRanges = std::map<int, PlayRange>;  ///< By clip index; a clip that plays as a whole has none.

/// Identity of a clip while clips of other files are added and removed.
struct ClipId {
  std::string file;  ///< AnimationClip::addedFrom
  int place = 0;     ///< Among the clips of that file.

  friend auto operator<=>(const ClipId&, const ClipId&) = default;
};

using KeptPlayRanges = std::map<ClipId, PlayRange>;  ///< Play ranges in the history.

[[nodiscard]] std::vector<ClipId> clipIds(const Character& character);      ///< [clips]
[[nodiscard]] int indexOf(const Character& character, const ClipId& clip);  ///< Index of the clip, or -1.

/// To the history's form and back, without ranges of missing clips.
[[nodiscard]] KeptPlayRanges keptRanges(const PlayRanges& ranges, const Character& character);
[[nodiscard]] PlayRanges rangesOf(const KeptPlayRanges& ranges, const Character& character);

/// A linear history. Each step holds a whole rig (a few kilobytes, shared), the pose made by hand and the play ranges.
/// Only the stack writes the rig; its primitives and groups have identities that last as long as the stack.
/// A gesture (one drag) shows its states at once and leaves one step, or none if canceled or without effect.
class CommandStack {
 public:
  /// Corrects every edit before it is shown, so that linked twins follow. The three rigs share identities.
  using Keeper = std::function<Rig(const Rig& atStart, const Rig& shown, Rig wanted)>;

  explicit CommandStack(Rig rig);

  void setKeeper(Keeper keeper) { keeper_ = std::move(keeper); }

  [[nodiscard]] const Rig& rig() const { return *current_; }
  [[nodiscard]] std::shared_ptr<const Rig> sharedRig() const { return current_; }
  /// The last step's rig: inside a gesture, the rig from before it.
  [[nodiscard]] const Rig& rigOfStep() const { return *steps_[position_].rig; }
  /// Grows with every change of rig(), undo and redo included.
  [[nodiscard]] std::size_t revision() const { return revision_; }

  /// Adds a step and drops redo. No step if nothing changes. Ends an open gesture first.
  void apply(const std::string& label, Rig rig);
  void applyPose(const std::string& label, const PoseOverrides& pose);  ///< The same for the pose made by hand.
  /// The same for the play ranges; a gesture stays open if nothing changes.
  void applyRanges(const std::string& label, const KeptPlayRanges& ranges);
  void startFrom(const PoseOverrides& pose, const KeptPlayRanges& ranges);  ///< Sets both for all steps so far.
  /// The last step's pose and ranges. View state: no modification.
  [[nodiscard]] const PoseOverrides& pose() const { return steps_[position_].pose; }
  [[nodiscard]] const KeptPlayRanges& ranges() const { return steps_[position_].ranges; }

  void beginGesture(const std::string& label);
  void updateGesture(Rig rig);  ///< Only inside a gesture.
  void endGesture();
  void endGesture(const std::string& label);  ///< Under another label.
  void cancelGesture();                       ///< Back to the rig from before it.
  [[nodiscard]] bool inGesture() const { return gesture_; }

  [[nodiscard]] bool canUndo() const;
  [[nodiscard]] bool canRedo() const;
  void undo();  ///< Inside a gesture: cancels it.
  void redo();
  void jumpTo(std::size_t step);  ///< 0 = the start.

  [[nodiscard]] std::size_t position() const { return position_; }  ///< Steps done.
  [[nodiscard]] std::size_t stepCount() const { return steps_.size() - 1; }
  [[nodiscard]] const std::string& label(std::size_t step) const { return steps_[step].label; }  ///< 0 = "Open".

  void markSaved() { saved_ = current_; }
  [[nodiscard]] bool modified() const;  ///< Differs from what was last saved, as a value.

 private:
  struct Step {
    std::string label;
    std::shared_ptr<const Rig> rig;
    PoseOverrides pose;
    KeptPlayRanges ranges;
  };
  void show(std::shared_ptr<const Rig> rig);
  void push(Step step);

  std::vector<Step> steps_;
  std::size_t position_ = 0;
  std::shared_ptr<const Rig> current_;
  std::shared_ptr<const Rig> saved_;
  bool gesture_ = false;
  std::string gestureLabel_;
  std::size_t revision_ = 0;
  Keeper keeper_;
  IdentitySource identities_;
};

}  // namespace sinew::app
