// app/editor/animate.cpp: keys and drivers of numbers, with the edits of core/rig/animated_edit.h.
#include "app/editor/animate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "app/document/shown_names.h"
#include "app/editor/edit.h"
#include "app/editor/sheet_commands.h"
#include "core/geometry/nearest_name.h"
#include "core/rig/driver_input.h"

namespace sinew::app {

namespace {

std::string ownerName(const Rig& rig, const NumberRef& ref) {
  const auto index = static_cast<std::size_t>(ref.owner);
  const ParameterOwner owner = ownerOf(ref.parameter);
  if (owner == ParameterOwner::kMorph) return rig.morphs[index].name;
  if (owner == ParameterOwner::kLink) return rig.links[index].groups[0] + " and " + rig.links[index].groups[1];
  return owner == ParameterOwner::kLine ? rig.lines[index].name : rig.primitives[index].name;
}

/// "turn about X of " for an axis of the frame.
std::string turnWords(const glm::vec3& axis) {
  constexpr const char* kWords[][2] = {{"turn about X of ", "turn about -X of "},
                                       {"turn about Y of ", "turn about -Y of "},
                                       {"turn about Z of ", "turn about -Z of "}};
  for (int i = 0; i < 3; ++i) {
    if (std::abs(axis[i]) == 1.0f) return kWords[i][axis[i] < 0.0f ? 1 : 0];
  }
  return "turn of ";
}

}  // namespace

std::string wordsFor(const Rig& rig, std::span<const NumberRef> refs) {
  const Parameter parameter = refs.front().parameter;
  std::string words = sinew::wordsFor(parameter);
  words[0] = toLower(words[0]);
  if (ownerOf(parameter) == ParameterOwner::kSurface) return words;
  const char* several = ownerOf(parameter) == ParameterOwner::kMorph ? " shapes" : " muscles";
  return words + " of " + (refs.size() == 1 ? ownerName(rig, refs.front()) : std::to_string(refs.size()) + several);
}

std::string wordsFor(const DriverInput& input, const Skeleton& skeleton) {
  const std::string bone = shownBoneName(skeleton, input.bone);
  switch (input.kind) {
    case DriverInputKind::kBend:
      return "bend of " + bone;
    case DriverInputKind::kTwist:
      return "twist of " + bone;
    case DriverInputKind::kAxis:
      return turnWords(input.axis) + bone;
    case DriverInputKind::kPose:
      return "pose of " + bone;
    case DriverInputKind::kLength:
      return "length of " + input.line;
    case DriverInputKind::kDistance:
      return "distance from " + shownBoneName(skeleton, input.from.bone) + " to " +
             shownBoneName(skeleton, input.to.bone);
    case DriverInputKind::kChannel:
      break;
  }
  return "channel " + input.channel;
}

std::string inputText(DriverInputKind kind, float value) {
  char text[32];
  const auto number = static_cast<double>(value);
  switch (kind) {
    case DriverInputKind::kBend:
    case DriverInputKind::kTwist:
    case DriverInputKind::kAxis:
      std::snprintf(text, sizeof text, "%.1f\xc2\xb0", number);
      break;
    case DriverInputKind::kLength:
    case DriverInputKind::kDistance:
      std::snprintf(text, sizeof text, "%.0f %%", 100.0 * number);
      break;
    default:
      std::snprintf(text, sizeof text, "%.2f", number);
  }
  return text;
}

const char* wordFor(CurveKind kind) {
  constexpr const char* kWords[] = {"Smooth", "Linear", "Step"};
  return kWords[static_cast<int>(kind)];
}

std::string timeText(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f s", seconds);
  return text;
}

namespace {

constexpr float kStrongBend = 90.0f;  // Degrees.
constexpr float kStep = 0.2f;         // Change at a strong input, as a fraction of the number.

/// Applies an edit to each number. @param change  (Rig, const NumberRef&) -> Result<Rig>
template <class Change>
Result<Rig> withAll(Rig rig, std::span<const NumberRef> refs, Change change) {
  for (const NumberRef& ref : refs) {
    Result<Rig> next = change(std::move(rig), ref);
    if (!next) return next;
    rig = std::move(next).value();
  }
  return rig;
}

/// Change by a new driver at a strong input.
float strongStep(const Rig& rig, const NumberRef& ref) {
  const float drawn = numberOf(rig, ref);
  switch (ref.parameter) {
    case Parameter::kActivation:
      return 1.0f - drawn;
    case Parameter::kCenterX:
    case Parameter::kCenterY:
    case Parameter::kCenterZ: {
      const glm::vec3& radii = rig.primitives[static_cast<std::size_t>(ref.owner)].placement.radii;
      return kStep * std::max({radii.x, radii.y, radii.z});
    }
    case Parameter::kMorphWeight:
      return 1.0f;
    case Parameter::kLinkAmount:
      return drawn > 0.5f ? -drawn : 1.0f - drawn;
    case Parameter::kGrooves:
      return drawn == 0.0f ? kNewGrooves : kStep * drawn;
    default:
      return kStep * (drawn == 0.0f ? 1.0f : std::abs(drawn));
  }
}

Curve firstCurve(DriverInputKind kind, float step) {
  switch (kind) {
    case DriverInputKind::kBend:
    case DriverInputKind::kTwist:
    case DriverInputKind::kAxis:
      return {{{0.0f, 0.0f}, {kStrongBend, step}}, CurveKind::kSmooth};
    case DriverInputKind::kLength:
      return {{{0.75f, step}, {1.0f, 0.0f}}, CurveKind::kSmooth};
    case DriverInputKind::kDistance:
      return {{{0.5f, step}, {1.0f, 0.0f}}, CurveKind::kSmooth};
    default:
      return {{{0.0f, 0.0f}, {1.0f, step}}, CurveKind::kSmooth};
  }
}

Result<Rig> driven(const Rig& rig, std::span<const NumberRef> refs, const DriverInput& input) {
  return withAll(rig, refs, [&](Rig of, const NumberRef& ref) {
    Driver driver{input, firstCurve(input.kind, strongStep(of, ref)), DriverMode::kAdd, {}};
    return setDriver(std::move(of), ref, std::move(driver));
  });
}

/// Shows where the curves are: in the inspector, under a shape's name, or under the groups.
void showDrivers(EditorState& state, const NumberRef& ref, const std::string& done) {
  if (ownerOf(ref.parameter) == ParameterOwner::kMorph) {
    state.open.shapes.chosen = state.document.rig().morphs[static_cast<std::size_t>(ref.owner)].name;
    return say(state, done + ". Its curve is under its name");
  }
  if (ownerOf(ref.parameter) == ParameterOwner::kLink) {
    state.open.blending.animatedLink = held(state.document.rig(), ref).link;
    return say(state, done + ". Its curve is under the groups");
  }
  state.view.inspector.animationOpen = true;
  say(state, done + ". Its curve is under Animation");
}

}  // namespace

int findLinkBetween(const Rig& rig, const std::array<GroupId, 2>& groups) {
  const int a = findGroup(rig, groups[0]);
  const int b = findGroup(rig, groups[1]);
  if (a < 0 || b < 0) return -1;
  return findLink(rig, rig.groups[static_cast<std::size_t>(a)].name, rig.groups[static_cast<std::size_t>(b)].name);
}

HeldNumber held(const Rig& rig, const NumberRef& ref) {
  const auto index = static_cast<std::size_t>(ref.owner);
  switch (ownerOf(ref.parameter)) {
    case ParameterOwner::kPrimitive:
      return {ref.parameter, rig.primitives[index].id(), {}};
    case ParameterOwner::kLine:
      return {ref.parameter, {}, rig.lines[index].id()};
    case ParameterOwner::kMorph:
      return {ref.parameter, {}, {}, rig.morphs[index].name};
    case ParameterOwner::kLink: {
      const auto groupOf = [&](std::size_t end) {
        const int group = findGroup(rig, rig.links[index].groups[end]);
        return group < 0 ? GroupId() : rig.groups[static_cast<std::size_t>(group)].id();
      };
      return {ref.parameter, {}, {}, {}, {groupOf(0), groupOf(1)}};
    }
    case ParameterOwner::kSurface:
      break;
  }
  return {ref.parameter, {}, {}};
}

std::optional<NumberRef> refOf(const Rig& rig, const HeldNumber& number) {
  int owner = 0;
  const ParameterOwner kind = ownerOf(number.parameter);
  if (kind == ParameterOwner::kPrimitive) owner = findPrimitive(rig, number.primitive);
  if (kind == ParameterOwner::kLine) owner = findLine(rig, number.line);
  if (kind == ParameterOwner::kMorph) owner = findMorph(rig, number.morph);
  if (kind == ParameterOwner::kLink) owner = findLinkBetween(rig, number.link);
  if (owner < 0) return std::nullopt;
  return NumberRef{number.parameter, owner};
}

std::vector<NumberRef> refsOf(const Rig& rig, std::span<const HeldNumber> numbers) {
  std::vector<NumberRef> refs;
  for (const HeldNumber& number : numbers) {
    if (const std::optional<NumberRef> ref = refOf(rig, number)) refs.push_back(*ref);
  }
  return refs;
}

float numberNow(const EditorState& state, const NumberRef& ref) {
  if (!state.hasCharacter()) return numberOf(state.document.rig(), ref);
  return numberOf(state.document.posedRig(state.live->pose()).numbers, ref);
}

std::optional<float> inputNow(const EditorState& state, const DriverInput& input) {
  if (!state.hasCharacter()) return std::nullopt;
  return sinew::inputNow(input, state.document.rig(), state.character(), state.live->pose());
}

Possible hasKeyTime(const EditorState& state) {
  if (!state.hasCharacter() || state.open.transport.clip < 0) {
    return {false, "Choose a clip first: the bind pose has no time"};
  }
  return {!clipNow(state).empty(), "This clip has no name in its file, and keys go by the clip's name"};
}

std::string clipNow(const EditorState& state) {
  const int clip = state.open.transport.clip;
  return clip < 0 ? std::string() : state.character().clips[static_cast<std::size_t>(clip)].name;
}

float timeNow(const EditorState& state) { return static_cast<float>(state.open.transport.time); }

const KeyTrack* trackNow(const EditorState& state, const NumberRef& ref) {
  const AnimatedNumber* number = animationOf(state.document.rig(), ref);
  return number == nullptr ? nullptr : trackIn(number->keys, clipNow(state));
}

int keyNow(const EditorState& state, const KeyTrack& track) {
  const std::vector<glm::vec2>& points = track.curve.points;
  const auto found = std::ranges::find_if(
      points, [&](const glm::vec2& point) { return std::abs(point.x - timeNow(state)) < kSameKey; });
  return found == points.end() ? -1 : static_cast<int>(found - points.begin());
}

namespace {

/// The drawn number is unchanged since the last key; if that is unknown, it equals some key.
bool untouched(const EditorState& state, const NumberRef& ref, const KeyTrack& track) {
  const Rig& rig = state.document.rig();
  const float drawn = numberOf(rig, ref);
  const auto& known = state.open.animate.keyed;
  const auto found = std::ranges::find(known, held(rig, ref), &KeyedNumber::number);
  if (found != known.end()) return found->drawn == drawn;
  return std::ranges::any_of(track.curve.points, [&](const glm::vec2& point) { return point.y == drawn; });
}

void rememberDrawn(EditorState& state, const NumberRef& ref) {
  std::vector<KeyedNumber>& known = state.open.animate.keyed;
  const HeldNumber number = held(state.document.rig(), ref);
  std::erase_if(known, [&](const KeyedNumber& other) { return other.number == number; });
  known.push_back({number, numberOf(state.document.rig(), ref)});
}

std::string clipWords(const KeyTrack* track, const std::string& clip) {
  return track != nullptr && track->clip.empty() ? " in every clip" : " in " + clip;
}

}  // namespace

void keyNumbers(EditorState& state, std::span<const NumberRef> refs, KeyValue value) {
  const Possible possible = hasKeyTime(state);
  if (!possible) return sayRefusal(state, possible.reason());
  const float time = timeNow(state);
  const auto valueOf = [&](const Rig& rig, const NumberRef& ref) {
    const KeyTrack* track = trackNow(state, ref);
    const bool byKeys =
        value == KeyValue::kKeyed || (value == KeyValue::kMeant && track && untouched(state, ref, *track));
    return byKeys && track != nullptr ? valueAt(track->curve, time) : numberOf(rig, ref);
  };
  const Rig& rig = state.document.rig();
  const std::string label = "Key " + wordsFor(rig, refs) + " at " + timeText(time);
  const bool done = edit(state, label, withAll(rig, refs, [&](Rig of, const NumberRef& ref) {
                           const KeyTrack* track = trackNow(state, ref);
                           const float now = valueOf(of, ref);
                           return setKey(std::move(of), ref, track ? track->clip : clipNow(state), time, now);
                         }));
  if (!done) return;
  for (const NumberRef& ref : refs) rememberDrawn(state, ref);
  say(state, label);
}

void removeKeysNow(EditorState& state, std::span<const NumberRef> refs) {
  const Rig& rig = state.document.rig();
  const std::string label = "Remove key of " + wordsFor(rig, refs) + " at " + timeText(timeNow(state));
  edit(state, label, withAll(rig, refs, [&](Rig of, const NumberRef& ref) -> Result<Rig> {
         const KeyTrack* track = trackNow(state, ref);
         const int key = track == nullptr ? -1 : keyNow(state, *track);
         if (key < 0) return of;
         return removeKey(std::move(of), ref, track->clip, key);
       }));
}

void removeClipKeys(EditorState& state, std::span<const NumberRef> refs) {
  const Rig& rig = state.document.rig();
  const KeyTrack* shown = refs.empty() ? nullptr : trackNow(state, refs.front());
  edit(state, "Remove keys of " + wordsFor(rig, refs) + clipWords(shown, clipNow(state)),
       withAll(rig, refs, [&](Rig of, const NumberRef& ref) -> Result<Rig> {
         const KeyTrack* track = trackNow(state, ref);
         if (track == nullptr) return of;
         return removeKeys(std::move(of), ref, track->clip);
       }));
}

void driveNumbers(EditorState& state, std::span<const NumberRef> refs, const DriverInput& input) {
  const Rig& rig = state.document.rig();
  const std::string label = "Drive " + wordsFor(rig, refs) + " by " + wordsFor(input, state.character().skeleton);
  if (edit(state, label, driven(rig, refs, input))) showDrivers(state, refs.front(), label);
}

void driveByNewChannel(EditorState& state, std::span<const NumberRef> refs) {
  const Rig& rig = state.document.rig();
  const std::string name = freeChannelName(rig, "effort");
  const std::string clip = clipNow(state);
  Result<Rig> made = setChannelKey(rig, name, clip, clip.empty() ? 0.0f : timeNow(state), 0.0f);
  if (!made) return refuse(state, made.error());
  DriverInput input;
  input.kind = DriverInputKind::kChannel;
  input.channel = name;
  const std::string label = "Drive " + wordsFor(rig, refs) + " by channel " + name;
  if (edit(state, label, driven(made.value(), refs, input))) showDrivers(state, refs.front(), label);
}

void stopAnimating(EditorState& state, std::span<const NumberRef> refs) {
  const Rig& rig = state.document.rig();
  edit(state, "Remove keys and drivers of " + wordsFor(rig, refs),
       withAll(rig, refs, [](Rig of, const NumberRef& ref) { return Result(removeAnimation(std::move(of), ref)); }));
}

DriverInput poseInput(const EditorState& state, int bone) {
  const Skeleton& skeleton = state.character().skeleton;
  DriverInput input;
  input.kind = DriverInputKind::kPose;
  input.bone = skeleton.fileName(bone);
  input.rotation = heldTurn(skeleton, state.live->pose(), bone);
  return input;
}

void startDrivenKey(EditorState& state, std::span<const NumberRef> refs, const DriverInput& input) {
  if (!inputNow(state, input)) return sayRefusal(state, "This character lacks what the driver would read");
  DrivenKeyMode& mode = state.open.animate.drivenKey;
  mode = {{}, input};
  for (const NumberRef& ref : refs) mode.numbers.push_back(held(state.document.rig(), ref));
  state.open.transport.playing = false;
}

void endDrivenKey(EditorState& state) { state.open.animate.drivenKey = {}; }

std::vector<NumberRef> drivenKeyNumbers(EditorState& state) {
  std::vector<NumberRef> refs = refsOf(state.document.rig(), state.open.animate.drivenKey.numbers);
  if (refs.empty()) endDrivenKey(state);
  return refs;
}

float drivenKeyValue(const EditorState& state, const NumberRef& ref) {
  const DriverInput& input = state.open.animate.drivenKey.input;
  const AnimatedNumber* number = animationOf(state.document.rig(), ref);
  const std::optional<float> x = inputNow(state, input);
  if (number != nullptr && x) {
    for (const Driver& driver : number->drivers) {
      if (driver.mode == DriverMode::kReplace && driver.input == input) return valueAt(driver.curve, *x);
    }
  }
  return numberNow(state, ref);
}

Result<Rig> withDrivenKeys(const EditorState& state, std::span<const NumberRef> refs, std::span<const float> values) {
  const DriverInput& input = state.open.animate.drivenKey.input;
  const std::optional<float> x = inputNow(state, input);
  if (!x) return errorAt({}, "the driver's input is not in this character");
  std::size_t next = 0;
  return withAll(state.document.rig(), refs, [&](Rig of, const NumberRef& ref) {
    return setDrivenKey(std::move(of), ref, input, *x, values[next++]);
  });
}

std::string drivenKeyLabel(const EditorState& state, std::span<const NumberRef> refs) {
  const DriverInput& input = state.open.animate.drivenKey.input;
  const float x = inputNow(state, input).value_or(0.0f);
  return "Key " + wordsFor(state.document.rig(), refs) + " at " + wordsFor(input, state.character().skeleton) + " " +
         inputText(input.kind, x);
}

Possible canKeyPointed(const EditorState& state) {
  if (state.open.animate.drivenKey.isOn()) return {};
  if (state.open.animate.pointed.empty()) return {false, "Point at a number of a muscle first"};
  return hasKeyTime(state);
}

void keyPointed(EditorState& state) {
  if (state.open.animate.drivenKey.isOn()) {
    const std::vector<NumberRef> refs = drivenKeyNumbers(state);
    if (refs.empty()) return;
    std::vector<float> values;
    for (const NumberRef& ref : refs) values.push_back(drivenKeyValue(state, ref));
    const std::string label = drivenKeyLabel(state, refs);
    if (edit(state, label, withDrivenKeys(state, refs, values))) say(state, label);
    return;
  }
  const std::vector<NumberRef> refs = refsOf(state.document.rig(), state.open.animate.pointed);
  if (!refs.empty()) keyNumbers(state, refs, KeyValue::kMeant);
}

bool removePointedPoint(EditorState& state) {
  const CurvePoint pointed = state.open.animate.pointedPoint;
  if (!pointed.sheet.empty()) return removeProfilePoint(state, pointed.sheet, pointed.along, pointed.point);
  const std::optional<NumberRef> ref = refOf(state.document.rig(), pointed.number);
  const AnimatedNumber* number = ref ? animationOf(state.document.rig(), *ref) : nullptr;
  if (number == nullptr || pointed.driver < 0 || pointed.driver >= static_cast<int>(number->drivers.size()))
    return false;
  Driver driver = number->drivers[static_cast<std::size_t>(pointed.driver)];
  std::vector<glm::vec2>& points = driver.curve.points;
  if (pointed.point < 0 || pointed.point >= static_cast<int>(points.size())) return false;
  if (points.size() == 1) {
    sayRefusal(state, "A driver's curve keeps one point; remove the driver instead");
    return true;
  }
  points.erase(points.begin() + pointed.point);
  const std::string label = "Remove point of the driver of " + wordsFor(state.document.rig(), std::span(&*ref, 1));
  edit(state, label, setDriver(state.document.rig(), *ref, driver, pointed.driver));
  return true;
}

}  // namespace sinew::app
