// app/panels/timeline_keys.cpp: rows of keys above the track, for keyed numbers and channels.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <imgui_internal.h>  // NoNav: for the mouse alone.
#include <imgui_stdlib.h>

#include "app/editor/animate.h"
#include "app/panels/field_edit.h"
#include "app/panels/timeline.h"
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
  for (std::size_t i = 0; i < rig.links.size(); ++i) {
    addNumbers(rows, state, rig.links[i].animated, static_cast<int>(i));
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

namespace {

constexpr float kRow = 22.0f;  // Design pixels, as all here.
constexpr float kKeyGap = 4.0f;
constexpr std::size_t kMostKeyRows = 6;
constexpr float kGutter = 210.0f;
constexpr float kLeastTrack = 320.0f;
constexpr float kValueWidth = 54.0f;
constexpr float kKey = 5.0f;  // Half a diamond.

struct ShownRow {
  PanelUi& ui;
  const KeyRow& keys;
  const TrackSpan& span;
  glm::vec2 low;
  glm::vec2 high;

  [[nodiscard]] const std::vector<glm::vec2>& points() const { return keys.track.curve.points; }
  [[nodiscard]] float middle() const { return 0.5f * (low.y + high.y); }
  [[nodiscard]] int keyUnder(float x) const {
    float reach = ui.px(kKey + 2.0f);
    int nearest = -1;
    for (int i = 0; i < static_cast<int>(points().size()); ++i) {
      const float away = std::abs(span.xOf(static_cast<double>(points()[static_cast<std::size_t>(i)].x)) - x);
      if (away > reach) continue;
      reach = away;
      nearest = i;
    }
    return nearest;
  }
};

void drawKeys(const ShownRow& row, int lit) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float half = row.ui.px(kKey);
  for (int i = 0; i < static_cast<int>(row.points().size()); ++i) {
    const float x = row.span.xOf(static_cast<double>(row.points()[static_cast<std::size_t>(i)].x));
    if (x < row.span.left - half || x > row.span.right + half) continue;
    const float size = i == lit ? half + 1.5f : half;
    const float y = row.middle();
    list.AddQuadFilled({x - size, y}, {x, y - size}, {x + size, y}, {x, y + size}, palette::kKeyed.packed());
    list.AddQuad({x - size, y}, {x, y - size}, {x + size, y}, {x, y + size}, palette::kBackground.packed());
    row.ui.widgets.note(row.keys.id + "/key/" + std::to_string(i), {x - half, y - half, 2.0f * half, 2.0f * half});
  }
}

/// @return whether the rig has changed, so that what was read from it is outdated
bool channelItems(const ShownRow& row) {
  PanelUi& ui = row.ui;
  const Rig& rig = ui.state.document.rig();
  std::string name = row.keys.channel;
  ImGui::SetNextItemWidth(ui.px(150));
  const bool entered = ImGui::InputText("##channel-name", &name, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.widgets.note("context/channel-name");
  tooltip(ui, "The channel's name, in every clip. Enter renames it");
  if (entered) {
    edit(ui.state, "Rename " + row.keys.name + " to " + name, renameChannel(rig, row.keys.channel, name));
    ImGui::CloseCurrentPopup();
    return true;
  }
  const bool removed = contextItem(ui, "Remove channel", "channel-remove");
  tooltip(ui, "In every clip, with the drivers that read it");
  if (removed) edit(ui.state, "Remove " + row.keys.name, removeChannel(rig, row.keys.channel));
  return removed;
}

void rowMenu(const ShownRow& row) {
  PanelUi& ui = row.ui;
  AnimateState& animate = ui.state.open.animate;
  if (!ImGui::BeginPopup((row.keys.id + "/menu").c_str())) return;
  const Rig& rig = ui.state.document.rig();
  const int key = animate.menuRow == row.keys.id ? animate.menuKey : -1;
  bool changed = row.keys.isChannel() && channelItems(row);
  if (changed) return ImGui::EndPopup();
  if (row.keys.isChannel()) ImGui::Separator();
  const bool there = key >= 0 && key < static_cast<int>(row.points().size());
  const bool removed = contextItem(ui, "Remove key", "key-remove", there);
  if (removed) {
    const std::string at = timeText(static_cast<double>(row.points()[static_cast<std::size_t>(key)].x));
    changed = edit(ui.state, "Remove key of " + row.keys.name + " at " + at, withoutKey(rig, row.keys, key));
  }
  ImGui::Separator();
  for (const CurveKind kind : kCurveKinds) {
    if (changed) break;
    const bool own = row.keys.track.curve.kind == kind;
    const bool chosen = ImGui::MenuItem(wordFor(kind), nullptr, own);
    ui.widgets.note(std::string("context/kind/") + nameOf(kind));
    tooltip(ui, "Between the keys of this row");
    if (!chosen || own) continue;
    changed =
        edit(ui.state, std::string(wordFor(kind)) + ": keys of " + row.keys.name, withKeyKind(rig, row.keys, kind));
  }
  ImGui::EndPopup();
}

double snapped(const ShownRow& row, double time) {
  if (ImGui::GetIO().KeyShift) time = std::round(time / kFrameSeconds) * kFrameSeconds;
  return std::clamp(time, 0.0, row.span.duration);
}

/// Drags, double clicks and the menu.
void keysArea(const ShownRow& row) {
  PanelUi& ui = row.ui;
  PointDrag& drag = ui.state.open.animate.drag;
  ImGui::SetCursorScreenPos({row.low.x, row.low.y});
  ImGui::PushItemFlag(ImGuiItemFlags_NoNav, true);
  ImGui::InvisibleButton(("##" + row.keys.id).c_str(), {row.high.x - row.low.x, row.high.y - row.low.y});
  ImGui::PopItemFlag();
  const float mouse = ImGui::GetMousePos().x;
  const bool dragging = drag.item == row.keys.id;
  const int under = ImGui::IsItemHovered() && !dragging ? row.keyUnder(mouse) : -1;
  std::optional<Result<Rig>> wanted;
  std::string label = "Move key of " + row.keys.name;
  if (ImGui::IsItemActivated()) {
    drag = {row.keys.id, under, {}, {}};
    if (under >= 0) {
      drag.grip.x = row.span.xOf(static_cast<double>(row.points()[static_cast<std::size_t>(under)].x)) - mouse;
    }
    if (under < 0 && ImGui::IsMouseDoubleClicked(0)) {
      const auto time = static_cast<float>(snapped(row, row.span.timeAt(mouse)));
      label = "Key " + row.keys.name + " at " + timeText(static_cast<double>(time));
      wanted = withKeyAt(ui.state.document.rig(), row.keys, time, valueAt(row.keys.track.curve, time));
    }
  } else if (dragging && drag.point >= 0 && ImGui::IsItemActive() && ImGui::IsMouseDragging(0, 2.0f)) {
    const double time = snapped(row, row.span.timeAt(mouse + drag.grip.x));
    label += " to " + timeText(time);
    const Document& document = ui.state.document;
    wanted =
        withKeyMoved(document.commands.rigOfStep(), document.rig(), row.keys, drag.point, static_cast<float>(time));
  }
  beginFieldEdit(ui, row.keys.id, label.c_str());
  if (wanted) edit(ui.state, label, std::move(*wanted));
  endFieldEdit(ui);
  if (ImGui::IsItemDeactivated() && dragging) drag = {};
  if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(1)) {
    ui.state.open.animate.menuRow = row.keys.id;
    ui.state.open.animate.menuKey = under;
    ImGui::OpenPopup((row.keys.id + "/menu").c_str());
  }
  if (!dragging) {
    tooltip(ui, under >= 0 ? timeText(static_cast<double>(row.points()[static_cast<std::size_t>(under)].x)) +
                                 "\nDrag moves the key (Shift: to frames). Right click: remove, interpolation"
                           : row.keys.name + "\nDouble-click adds a key. Right click: interpolation");
  }
  drawKeys(row, dragging ? -1 : under);
  rowMenu(row);
}

/// A channel's value at the current time; an edit sets a key.
void channelValue(const ShownRow& row, float right) {
  PanelUi& ui = row.ui;
  const std::string id = row.keys.id + "/value";
  const float width = ui.px(kValueWidth);
  ImGui::SetCursorScreenPos({right - width, row.low.y});
  float value = valueAt(row.keys.track.curve, timeNow(ui.state));
  Typing typing;
  NumberLook look{"%.2f", 0.01f};
  look.step = 0.1f;
  look.typing = &typing;
  ImGui::SetNextItemWidth(width);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(4), ui.px(2)});
  const bool edited = numberField(("##" + id).c_str(), value, look);
  ImGui::PopStyleVar();
  if (ImGui::IsItemActivated()) ui.state.open.transport.playing = false;
  const std::string label = "Key " + row.keys.name + " at " + timeText(ui.state.open.transport.time);
  editField(ui, id, label.c_str(), edited,
            [&] { return withKeyAt(ui.state.document.rig(), row.keys, timeNow(ui.state), value); });
  if (!typing.refusal.empty()) refuse(ui.state, errorAt({}, typing.refusal));
  tooltip(ui, "The channel's value at this moment. An edit sets a key here");
}

/// The number's muscle, or the first on its line; -1: a number of another owner.
int muscleOf(const Rig& rig, const NumberRef& ref) {
  const ParameterOwner owner = ownerOf(ref.parameter);
  if (owner == ParameterOwner::kPrimitive) return ref.owner;
  if (owner != ParameterOwner::kLine) return -1;
  const std::string& line = rig.lines[static_cast<std::size_t>(ref.owner)].name;
  const auto found = std::ranges::find(rig.primitives, line, &Primitive::line);
  return found == rig.primitives.end() ? -1 : static_cast<int>(found - rig.primitives.begin());
}

void nameButton(const ShownRow& row, float left, float right) {
  PanelUi& ui = row.ui;
  const float width = right - left - ui.px(6);
  if (width < ui.px(20)) return;
  ImGui::SetCursorScreenPos({left, row.low.y});
  const bool pressed = ImGui::InvisibleButton(("##name" + row.keys.id).c_str(), {width, row.high.y - row.low.y});
  ui.widgets.note(row.keys.id + "/name");
  const bool lit = ImGui::IsItemHovered() && !row.keys.isChannel();
  const std::string text = fitted(row.keys.name, width);
  const ImVec2 at{left, row.middle() - 0.5f * ImGui::GetTextLineHeight()};
  ImGui::GetWindowDrawList()->AddText(at, (lit ? palette::kText : palette::kMuted).packed(), text.c_str());
  const int muscle = row.keys.isChannel() ? -1 : muscleOf(ui.state.document.rig(), row.keys.ref);
  tooltip(ui, row.keys.name + (muscle >= 0 ? "\nClick selects the muscle" : ""));
  if (pressed && muscle >= 0) ui.state.document.selection.set(ui.state.document.idAt(muscle));
}

}  // namespace

float keyRowsHeight(const EditorState& state) {
  if (!state.hasCharacter()) return 0.0f;
  const std::size_t count = std::min(keyRows(state).size(), kMostKeyRows);
  return count == 0 ? 0.0f : static_cast<float>(count) * kRow + kKeyGap;
}

float keyRowsGutter(const PanelUi& ui) {
  const bool room = ImGui::GetContentRegionAvail().x >= ui.px(kGutter + kLeastTrack);
  return room && !keyRows(ui.state).empty() ? ui.px(kGutter) : 0.0f;
}

void drawKeyRows(PanelUi& ui, const TrackSpan& span, float gutter, float height) {
  std::vector<KeyRow> rows = keyRows(ui.state);
  if (rows.empty()) return;
  std::ranges::reverse(rows);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
  ImGui::BeginChild("keys", {ImGui::GetContentRegionAvail().x, height - ui.px(kKeyGap)}, false,
                    ImGuiWindowFlags_NoBackground);
  ImGui::PopStyleVar();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float y = corner.y;
  for (const KeyRow& keys : rows) {
    const ShownRow row{ui, keys, span, {span.left, y}, {span.right, y + ui.px(kRow - 2.0f)}};
    y += ui.px(kRow);
    list.AddRectFilled({row.low.x, row.low.y}, {row.high.x, row.high.y}, palette::kBackground.packed(), ui.px(3));
    float nameEnd = span.left;
    if (gutter > 0.0f && keys.isChannel()) {
      channelValue(row, span.left - ui.px(6));
      nameEnd -= ui.px(kValueWidth + 6.0f);
    }
    if (gutter > 0.0f) nameButton(row, corner.x, nameEnd);
    ImGui::PushClipRect({row.low.x, row.low.y}, {row.high.x, row.high.y}, true);
    const float now = span.xOf(ui.state.open.transport.time);
    list.AddLine({now, row.low.y}, {now, row.high.y}, palette::kAccent.faded(0.6f).packed(), ui.px(1));
    keysArea(row);
    ImGui::PopClipRect();
  }
  ImGui::SetCursorScreenPos({corner.x, corner.y + static_cast<float>(rows.size()) * ui.px(kRow) - ui.px(2)});
  ImGui::Dummy({1.0f, 1.0f});
  ImGui::EndChild();
}

}  // namespace sinew::app
