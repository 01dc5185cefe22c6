// app/editor/animate.h: what can be done with the keys and drivers of numbers. Every function that edits leaves one
// undo step, or the reason why not.
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

// How the interface and the history call numbers that are keyed or driven, and inputs.

/// "radius X of biceps L", "radius X of 3 muscles", "skin blend". At least one, all of one parameter.
[[nodiscard]] std::string wordsFor(const Rig& rig, std::span<const NumberRef> refs);
/// "bend of forearm.L", "length of biceps L", "channel effort".
[[nodiscard]] std::string wordsFor(const DriverInput& input, const Skeleton& skeleton);
/// The input's value as it is read: degrees, per cent or a plain number.
[[nodiscard]] std::string inputText(DriverInputKind kind, float value);
/// "Smooth"
[[nodiscard]] const char* wordFor(CurveKind kind);
inline constexpr std::array kCurveKinds{CurveKind::kSmooth, CurveKind::kLinear, CurveKind::kStep};
/// "0.43 s"
[[nodiscard]] std::string timeText(double seconds);

[[nodiscard]] HeldNumber held(const Rig& rig, const NumberRef& ref);
/// nullopt: its owner is gone.
[[nodiscard]] std::optional<NumberRef> refOf(const Rig& rig, const HeldNumber& number);
/// Those that are there.
[[nodiscard]] std::vector<NumberRef> refsOf(const Rig& rig, std::span<const HeldNumber> numbers);

/// A number as keys and drivers leave it in the pose that is shown.
[[nodiscard]] float numberNow(const EditorState& state, const NumberRef& ref);
[[nodiscard]] std::optional<float> inputNow(const EditorState& state, const DriverInput& input);

// Keys.
/// There is a clip whose name keys can go by.
[[nodiscard]] Possible hasKeyTime(const EditorState& state);
/// Name of the clip that shows, empty in the bind pose, and the moment.
[[nodiscard]] std::string clipNow(const EditorState& state);
[[nodiscard]] float timeNow(const EditorState& state);
/// The keys that count in the clip that shows, or null.
[[nodiscard]] const KeyTrack* trackNow(const EditorState& state, const NumberRef& ref);
/// The key at this moment, or -1.
[[nodiscard]] int keyNow(const EditorState& state, const KeyTrack& track);

enum class KeyValue {
  kDrawn,  ///< What the field shows.
  kKeyed,  ///< What the clip's keys make of it at this moment.
  kMeant,  ///< What was set since it was keyed last; where nothing was, what the keys make of it.
};
void keyNumbers(EditorState& state, std::span<const NumberRef> refs, KeyValue value);
void removeKeysNow(EditorState& state, std::span<const NumberRef> refs);
/// All in the clip that shows.
void removeClipKeys(EditorState& state, std::span<const NumberRef> refs);

// Drivers.
/// With two points: at rest nothing is added, at a strong bend (full contraction, the pose, 1) a fifth of the number.
void driveNumbers(EditorState& state, std::span<const NumberRef> refs, const DriverInput& input);
/// By a new channel with a key here, or at the start of the first clip.
void driveByNewChannel(EditorState& state, std::span<const NumberRef> refs);
/// Keys and drivers.
void stopAnimating(EditorState& state, std::span<const NumberRef> refs);
/// As the joint is turned now.
[[nodiscard]] DriverInput poseInput(const EditorState& state, int bone);

// Set driven key.
void startDrivenKey(EditorState& state, std::span<const NumberRef> refs, const DriverInput& input);
void endDrivenKey(EditorState& state);
/// Those of the mode that are there; the mode ends where none is.
[[nodiscard]] std::vector<NumberRef> drivenKeyNumbers(EditorState& state);
/// What the number's driven key says where the input is now; without one, what the number is now.
[[nodiscard]] float drivenKeyValue(const EditorState& state, const NumberRef& ref);
/// Points where the input is now. @param values  one a number
[[nodiscard]] Result<Rig> withDrivenKeys(const EditorState& state, std::span<const NumberRef> refs,
                                         std::span<const float> values);
/// "Key radius X of biceps L at bend of forearm.L 43 degrees"
[[nodiscard]] std::string drivenKeyLabel(const EditorState& state, std::span<const NumberRef> refs);

// The action: a key of the number under the pointer, or a driven key of those being set.
[[nodiscard]] Possible canKeyPointed(const EditorState& state);
void keyPointed(EditorState& state);

/// Removes the point of a curve under the pointer. @return false: there is none.
bool removePointedPoint(EditorState& state);

}  // namespace sinew::app
