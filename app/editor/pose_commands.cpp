// app/editor/pose_commands.cpp: resets, mirror images and copies of a pose; the range of motion.
#include "app/editor/pose_commands.h"

#include <algorithm>
#include <string>
#include <utility>

#include "app/document/shown_names.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/visibility_commands.h"
#include "core/character/range_of_motion.h"
#include "core/geometry/at.h"
#include "core/rig/motion_clip.h"

namespace sinew::app {
namespace {

constexpr glm::quat kIdentity(1.0f, 0.0f, 0.0f, 0.0f);

/// Side of the mirror plane: -1, +1; 0 for a bone that is its own twin or has none.
int sideOf(const MirrorPlan& mirror, const Skeleton& skeleton, int bone) {
  const int twin = at(mirror.twinOf, bone);
  if (twin < 0 || twin == bone) return 0;
  const glm::dvec3 origin(glm::vec3(at(skeleton.bones, bone).bindInWorld[3]));
  return distanceTo(mirror.plane, origin) < 0.0 ? -1 : 1;
}

/// Rotations of one side on both.
PoseOverrides sideOnBoth(const PoseOverrides& overrides, const MirrorPlan& mirror, const Skeleton& skeleton, int side) {
  PoseOverrides result = overrides;
  for (int bone = 0; bone < static_cast<int>(skeleton.bones.size()); ++bone) {
    if (sideOf(mirror, skeleton, bone) != side) continue;
    const int twin = at(mirror.twinOf, bone);
    result.set(twin, mirroredTurn(overrides.turnOf(bone), at(skeleton.bones, bone), at(skeleton.bones, twin),
                                  glm::vec3(mirror.plane.normal)));
  }
  return result;
}

}  // namespace

bool isPosed(const EditorState& state) { return !state.open.transport.overrides.isEmpty(); }

bool selectedJointIsPosed(const EditorState& state) {
  const int bone = state.document.selection.bone;
  return bone >= 0 && state.open.transport.overrides.turnOf(bone) != kIdentity;
}

void resetJoint(EditorState& state) {
  if (state.document.selection.bone < 0) return;
  state.open.transport.overrides.set(state.document.selection.bone, kIdentity);
  keepPose(state, "Reset joint");
}

void resetPose(EditorState& state) {
  state.open.transport.overrides.turns.clear();
  keepPose(state, "Reset pose");
}

void mirrorPose(EditorState& state) {
  if (!state.hasCharacter()) return;
  const Skeleton& skeleton = state.character().skeleton;
  const MirrorPlan mirror = state.document.mirror ? *state.document.mirror : makeMirrorPlan(state.character());
  if (!mirror.usable()) {
    addMessage(state.session, MessageKind::kNote,
               "The pose was not mirrored: no joint of this character has a counterpart");
    return;
  }
  PoseOverrides& overrides = state.open.transport.overrides;
  const int bone = state.document.selection.bone;
  const int side = bone >= 0 ? sideOf(mirror, skeleton, bone) : 0;
  overrides = side != 0 ? sideOnBoth(overrides, mirror, skeleton, side)
                        : mirroredPose(overrides, skeleton, mirror.twinOf, glm::vec3(mirror.plane.normal));
  keepPose(state, "Mirror pose");
}

std::vector<NamedTurn> namedTurns(const PoseOverrides& overrides, const Skeleton& skeleton) {
  std::vector<NamedTurn> turns;
  for (const JointTurn& turn : overrides.turns) turns.emplace_back(skeleton.fileName(turn.bone), turn.turn);
  return turns;
}

FoundTurns turnsOf(const std::vector<NamedTurn>& turns, TurnsFrom from, const Skeleton& skeleton) {
  FoundTurns found;
  found.overrides.from = from;
  for (const auto& [name, turn] : turns) {
    if (const auto bone = skeleton.findBone(name)) found.overrides.set(*bone, turn);
    else ++found.missing;
  }
  return found;
}

void copyPose(EditorState& state) {
  state.view.copiedPose = namedTurns(state.open.transport.overrides, state.character().skeleton);
}

void pastePose(EditorState& state) {
  PoseOverrides& overrides = state.open.transport.overrides;
  const FoundTurns found = turnsOf(state.view.copiedPose, overrides.from, state.character().skeleton);
  overrides = found.overrides;
  keepPose(state, "Paste pose");
  if (found.missing > 0) {
    addMessage(state.session, MessageKind::kNote,
               withCount(static_cast<std::size_t>(found.missing), "joint") +
                   " of the copied pose ignored: this character does not have them");
  }
}

void toggleHoldPose(EditorState& state) {
  if (!state.hasCharacter()) return;
  Transport& transport = state.open.transport;
  const TurnsFrom other = transport.overrides.from == TurnsFrom::kMoment ? TurnsFrom::kBindPose : TurnsFrom::kMoment;
  Transport plain = transport;
  plain.overrides = {};
  transport.overrides =
      startingFrom(other, state.character().skeleton, poseAt(plain, state.character()), transport.overrides);
  keepPose(state, other == TurnsFrom::kBindPose ? "Hold turned joints" : "Release turned joints");
}

void selectParentJoint(Document& document) {
  int& bone = document.selection.bone;
  if (bone < 0) bone = 0;
  else if (const int parent = at(document.character->skeleton.bones, bone).parent; parent >= 0) {
    bone = parent;
  }
}

void selectChildJoint(EditorState& state) {
  int& bone = state.document.selection.bone;
  const std::vector<bool> hidden = hiddenBones(state);
  const Skeleton& skeleton = state.character().skeleton;
  const auto isShown = [&](int candidate) { return !isHidden(hidden, candidate); };
  if (bone < 0) {
    for (bone = 0; isHidden(hidden, bone);) ++bone;
    return;
  }
  const std::vector<int>& children = at(skeleton.bones, bone).children;
  const auto child = std::ranges::find_if(children, isShown);
  if (child != children.end()) bone = *child;
}

void playRangeOfMotion(EditorState& state) {
  if (!state.hasCharacter()) return;
  std::shared_ptr<const Character> extended = withRangeOfMotion(state.document.character);
  if (extended != state.document.character) {
    std::shared_ptr<const Character> former = std::exchange(state.document.character, extended);
    Result<LiveSurface> live = LiveSurface::create(state.document, state.open.transport);
    if (!live) {
      state.document.character = std::move(former);
      addMessage(state.session, MessageKind::kError, live.error().plainText());
      return;
    }
    state.live = std::move(live).value();
    ++state.session.documentsOpened;
  }
  const int clip = findClip(state.character(), kRangeOfMotionName);
  if (clip < 0) {
    addMessage(state.session, MessageKind::kNote, "No range of motion: this character has no joint to turn");
    return;
  }
  chooseClip(state.open.transport, clip, state.character());
  state.open.transport.playing = clipDuration(state.open.transport, state.character()) > 0.0;
}

}  // namespace sinew::app
