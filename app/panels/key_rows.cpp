// app/panels/key_rows.cpp: the tracks of keys that the timeline shows below its own, and their edits.

#include "app/panels/key_rows.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/editor/animate.h"
#include "app/editor/animated_names.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

void addNumbers(std::vector<KeyRow>& rows, const EditorState& state, const std::vector<AnimatedNumber>& animated,
                int owner) {
  for (const AnimatedNumber& number : animated) {
    const KeyTrack* track = trackIn(number.keys, clipNow(state));
    if (track == nullptr) continue;
    const std::array refs{NumberRef{number.parameter, owner}};
    const std::string name = wordsFor(state.document.rig(), refs);
    const bool known = std::ranges::any_of(rows, [&](const KeyRow& row) { return row.name == name; });
    if (!known) rows.push_back({"timeline/row/" + name, name, refs[0], {}, *track});
  }
}

void addChannels(std::vector<KeyRow>& rows, const EditorState& state) {
  const Rig& rig = state.document.rig();
  for (const RigChannel& channel : rig.channels) {
    const std::string name = "channel " + channel.name;
    if (std::ranges::any_of(rows, [&](const KeyRow& row) { return row.name == name; })) continue;
    int track = findChannel(rig, channel.name, clipNow(state));
    if (track < 0) track = findChannel(rig, channel.name, {});
    if (track < 0) continue;
    rows.push_back({"timeline/row/" + name, name, {}, channel.name, at(rig.channels, track).track});
  }
}

}  // namespace

std::vector<KeyRow> keyRows(const EditorState& state) {
  std::vector<KeyRow> rows;
  if (!hasKeyTime(state)) return rows;
  const Rig& rig = state.document.rig();
  for (const PrimitiveId id : state.document.selection.primitives) {
    const int index = findPrimitive(rig, id);
    if (index < 0) continue;
    const Primitive& primitive = at(rig.primitives, index);
    addNumbers(rows, state, primitive.animated, index);
    const int line = findLine(rig, primitive.line);
    if (line >= 0) addNumbers(rows, state, at(rig.lines, line).animated, line);
  }
  addNumbers(rows, state, rig.surface.animated, 0);
  for (std::size_t i = 0; i < rig.morphs.size(); ++i) {
    addNumbers(rows, state, rig.morphs[i].animated, static_cast<int>(i));
  }
  addChannels(rows, state);
  return rows;
}

Result<Rig> withKeyAt(const Rig& rig, const KeyRow& row, float time, float value) {
  if (row.isChannel()) return setChannelKey(rig, row.channel, row.track.clip, time, value);
  return setKey(rig, row.ref, row.track.clip, time, value);
}

Result<Rig> withKeyMoved(const Rig& start, const Rig& shown, const KeyRow& row, int key, float time) {
  if (!row.isChannel()) {
    const Result<Rig> moved = moveKey(start, row.ref, row.track.clip, key, time);
    if (!moved) return moved;
    const std::vector<KeyTrack>& tracks = animationOf(moved.value(), row.ref)->keys;
    return setTrack(shown, row.ref, *std::ranges::find(tracks, row.track.clip, &KeyTrack::clip));
  }
  const int index = findChannel(start, row.channel, row.track.clip);
  if (index < 0) return errorAt("", "the channel is gone", "channel");
  std::vector<glm::vec2> points = at(start.channels, index).track.curve.points;
  const float value = at(points, key).y;
  points.erase(points.begin() + key);
  Result<Rig> rest = editChannel(shown, row.channel, row.track.clip, [&](Curve& curve) {
    curve.points = points.empty() ? std::vector<glm::vec2>{{time, value}} : points;
  });
  return rest ? setChannelKey(std::move(rest).value(), row.channel, row.track.clip, time, value) : rest;
}

Result<Rig> withoutKey(const Rig& rig, const KeyRow& row, int key) {
  if (!row.isChannel()) return removeKey(rig, row.ref, row.track.clip, key);
  if (row.track.curve.points.size() < 2) return errorAt("", "a channel keeps one key in a clip", "channel");
  return editChannel(rig, row.channel, row.track.clip,
                     [&](Curve& curve) { curve.points.erase(curve.points.begin() + key); });
}

Result<Rig> withKeyKind(const Rig& rig, const KeyRow& row, CurveKind kind) {
  if (row.isChannel()) return editChannel(rig, row.channel, row.track.clip, [&](Curve& curve) { curve.kind = kind; });
  return setKeyKind(rig, row.ref, row.track.clip, kind);
}

}  // namespace sinew::app
