// app/editor/animate.h: keys and drivers of numbers. Every edit is one undo step, or reports why not.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/editor/actions.h"
#include "app/editor/editor_state.h"
#include "core/rig/animated_edit.h"
#include "sinew/character/skeleton.h"

namespace sinew::app {

// Names for interface and history.

/// "radius X of biceps L", "radius X of 3 muscles", "skin blend". @param refs  at least one, of one parameter
[[nodiscard]] std::string wordsFor(const Rig& rig, std::span<const NumberRef> refs);
/// "bend of forearm.L", "length of biceps L", "channel effort".
[[nodiscard]] std::string wordsFor(const DriverInput& input, const Skeleton& skeleton);
/// An input's value in degrees, percent or as a plain number.
[[nodiscard]] std::string inputText(DriverInputKind kind, float value);
[[nodiscard]] const char* wordFor(CurveKind kind);  ///< "Smooth"
inline constexpr std::array kCurveKinds{CurveKind::kSmooth, CurveKind::kLinear, CurveKind::kStep};
[[nodiscard]] std::string timeText(double seconds);  ///< "0.43 s"

[[nodiscard]] int findLinkBetween(const Rig& rig, const std::array<GroupId, 2>& groups);  ///< Index, or -1.
[[nodiscard]] HeldNumber held(const Rig& rig, const NumberRef& ref);
[[nodiscard]] std::optional<NumberRef> refOf(const Rig& rig, const HeldNumber& number);  ///< nullopt: no owner.
[[nodiscard]] std::vector<NumberRef> refsOf(const Rig& rig, std::span<const HeldNumber> numbers);  ///< Existing ones.

/// A number in the shown pose, with keys and drivers applied.
[[nodiscard]] float numberNow(const EditorState& state, const NumberRef& ref);
[[nodiscard]] std::optional<float> inputNow(const EditorState& state, const DriverInput& input);

[[nodiscard]] Possible hasKeyTime(const EditorState& state);  ///< Keys need a shown clip with a name.
[[nodiscard]] std::string clipNow(const EditorState& state);  ///< Name of the shown clip; empty in the bind pose.
[[nodiscard]] float timeNow(const EditorState& state);
/// The number's keys for the shown clip, or null.
[[nodiscard]] const KeyTrack* trackNow(const EditorState& state, const NumberRef& ref);
[[nodiscard]] int keyNow(const EditorState& state, const KeyTrack& track);  ///< The key at the current time, or -1.

enum class KeyValue {
  kDrawn,  ///< As in the field.
  kKeyed,  ///< From the clip's keys at the current time.
  kMeant,  ///< As in the field if edited since the last key, else from the keys.
};
void keyNumbers(EditorState& state, std::span<const NumberRef> refs, KeyValue value);
void removeKeysNow(EditorState& state, std::span<const NumberRef> refs);
void removeClipKeys(EditorState& state, std::span<const NumberRef> refs);  ///< All keys in the shown clip.

/// Adds drivers with two points: 0 at rest, a fifth of the number at a strong input (90 degrees, full contraction, 1).
void driveNumbers(EditorState& state, std::span<const NumberRef> refs, const DriverInput& input);
/// By a new channel with a key at the current time, or at the clips' start.
void driveByNewChannel(EditorState& state, std::span<const NumberRef> refs);
void stopAnimating(EditorState& state, std::span<const NumberRef> refs);  ///< Removes keys and drivers.
[[nodiscard]] DriverInput poseInput(const EditorState& state, int bone);  ///< Its current pose as a driver's input.

// Set driven key.
void startDrivenKey(EditorState& state, std::span<const NumberRef> refs, const DriverInput& input);
void endDrivenKey(EditorState& state);
/// Existing numbers of the mode; without any, the mode ends.
[[nodiscard]] std::vector<NumberRef> drivenKeyNumbers(EditorState& state);
/// The number's driven key at the current input, else the current number.
[[nodiscard]] float drivenKeyValue(const EditorState& state, const NumberRef& ref);
/// Adds points at the current input. @param values  [refs]
[[nodiscard]] Result<Rig> withDrivenKeys(const EditorState& state, std::span<const NumberRef> refs,
                                         std::span<const float> values);
/// "Key radius X of biceps L at bend of forearm.L 43 degrees"
[[nodiscard]] std::string drivenKeyLabel(const EditorState& state, std::span<const NumberRef> refs);

// Keys the number under the pointer, or the driven keys being set.
[[nodiscard]] Possible canKeyPointed(const EditorState& state);
void keyPointed(EditorState& state);

bool removePointedPoint(EditorState& state);  ///< Removes the curve's point under the pointer. @return whether any

}  // namespace sinew::app
