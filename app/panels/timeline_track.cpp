// app/panels/timeline_track.cpp: the track: scrubbing, ticks, keys, the playback range.

#include "app/panels/timeline.h"

#include <imgui_internal.h>  // NoNav: for the mouse alone.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/editor/edit.h"

namespace sinew::app {
namespace {

constexpr float kBand = 11.0f;   // Design pixels, as all here: height of the range's bar.
constexpr float kHandle = 9.0f;  // Width of a range handle.
constexpr float kKeysHeight = 5.0f;
constexpr float kLabelSpacing = 58.0f;
constexpr float kTickSpacing = 5.0f;
constexpr float kColumn = 2.0f;  // Width of a column of keys.
constexpr double kZoomPerStep = 1.25;
constexpr double kLeastFrames = 5.0;

struct Track : TrackSpan {
  PanelUi& ui;
  ImDrawList& list;
  glm::vec2 low;  ///< Window coordinates.
  glm::vec2 high;
  float band;  ///< y at the top of the scrub area.

  Track(PanelUi& panel, const glm::vec2& corner, const glm::vec2& end, double seconds, const PlayRange& span)
      : TrackSpan{corner.x, end.x, seconds, span},
        ui(panel),
        list(*ImGui::GetWindowDrawList()),
        low(corner),
        high(end),
        band(corner.y + panel.px(kBand)) {}
  [[nodiscard]] float width() const { return high.x - low.x; }
  [[nodiscard]] Transport& transport() const { return ui.state.open.transport; }
};

/// Resets the zoom when the clip changes; scrolls to the current time when it leaves the shown span.
void refresh(EditorState& state, double duration) {
  TimelineState& timeline = state.open.timeline;
  if (timeline.clip != state.open.transport.clip || timeline.shown.to > duration ||
      timeline.shown.to <= timeline.shown.from) {
    timeline = {};
    timeline.clip = state.open.transport.clip;
    timeline.shown = {0.0, std::max(duration, 1e-3)};
  }
  const double span = timeline.shown.to - timeline.shown.from;
  const double time = state.open.transport.time;
  if (time >= timeline.shown.from && time <= timeline.shown.to) return;
  const double from = std::clamp(time, 0.0, std::max(0.0, duration - span));
  timeline.shown = {from, from + span};
}

bool button(const Track& track, const char* id, float x0, float y0, float x1, float y1) {
  ImGui::SetCursorScreenPos({x0, y0});
  ImGui::PushItemFlag(ImGuiItemFlags_NoNav, true);
  ImGui::InvisibleButton(id, {std::max(1.0f, x1 - x0), std::max(1.0f, y1 - y0)});
  ImGui::PopItemFlag();
  track.ui.widgets.note(id);
  return ImGui::IsItemActive();
}

// Dragging ----------------------------------------------------------------------------------------------------------

void rangeHandle(const Track& track, const char* id, double time, bool first) {
  const float width = track.ui.px(kHandle);
  const float x = std::clamp(track.xOf(time) - (first ? 0.0f : width), track.low.x, track.high.x - width);
  const bool active = button(track, id, x, track.low.y, x + width, track.band);
  if (ImGui::IsItemHovered() || active) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (active && ImGui::IsMouseDragging(0, 0.0f)) {
    PlayRange range = playRange(track.transport(), track.ui.state.character());
    const double wanted = track.timeAt(ImGui::GetMousePos().x);
    if (first) range.from = std::min(wanted, range.to - kFrameSeconds);
    else range.to = std::max(wanted, range.from + kFrameSeconds);
    setPlayRange(track.transport(), range, track.ui.state.character());
  }
  if (ImGui::IsItemDeactivated()) keepPlayRange(track.ui.state);
  const bool lit = active || ImGui::IsItemHovered();
  const bool ranged = hasPlayRange(track.transport());
  const Tint color = lit ? palette::kText : (ranged ? palette::kAccent : palette::kMuted);
  const float edge = first ? x : x + width;
  const float inner = first ? x + width : x;
  const float middle = 0.5f * (track.low.y + track.band);
  track.list.AddTriangleFilled({edge, track.low.y}, {inner, middle}, {edge, track.band}, color.packed());
  tooltip(track.ui, first ? "Start of playback: drag" : "End of playback: drag");
}

void rangeBar(const Track& track) {
  TimelineState& timeline = track.ui.state.open.timeline;
  const Character& character = track.ui.state.character();
  const PlayRange range = playRange(track.transport(), character);
  const float x0 = std::max(track.xOf(range.from), track.low.x);
  const float x1 = std::min(track.xOf(range.to), track.high.x);
  if (x1 <= x0) return;
  const bool ranged = hasPlayRange(track.transport());
  const bool active = button(track, "timeline/range", x0, track.low.y, x1, track.band);
  if (ImGui::IsItemActivated()) {
    timeline.grabbed = range;
    timeline.grabbedAt = track.timeAt(ImGui::GetMousePos().x);
  }
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
    track.transport().ranges.erase(track.transport().clip);
    keepPlayRange(track.ui.state);
  } else if (active && ranged && ImGui::IsMouseDragging(0)) {
    const double length = timeline.grabbed.to - timeline.grabbed.from;
    const double moved = timeline.grabbed.from + track.timeAt(ImGui::GetMousePos().x) - timeline.grabbedAt;
    const double from = std::clamp(moved, 0.0, track.duration - length);
    setPlayRange(track.transport(), {from, from + length}, character);
  }
  if (ImGui::IsItemDeactivated()) keepPlayRange(track.ui.state);
  const bool lit = ImGui::IsItemHovered() || active;
  const Tint fill = ranged ? palette::kAccent.faded(lit ? 0.42f : 0.30f) : palette::kMuted.faded(lit ? 0.22f : 0.13f);
  track.list.AddRectFilled({x0, track.low.y}, {x1, track.band}, fill.packed(), track.ui.px(2));
  tooltip(track.ui, ranged ? "The part that plays: drag to move it, double click to play all"
                           : "The whole clip plays: drag an end to play a part");
}

void scrubArea(const Track& track) {
  Transport& transport = track.transport();
  const bool active = button(track, "timeline/scrub", track.low.x, track.band, track.high.x, track.high.y);
  if (active) {
    double time = track.timeAt(ImGui::GetMousePos().x);
    // Shift snaps to frames.
    if (ImGui::GetIO().KeyShift) time = std::min(std::round(time / kFrameSeconds) * kFrameSeconds, track.duration);
    transport.time = time;
    transport.playing = false;
  }
  const float wheel = ImGui::GetIO().MouseWheel;
  if (ImGui::IsItemHovered() && wheel != 0.0f) {
    PlayRange& shown = track.ui.state.open.timeline.shown;
    shown = zoomedSpan(shown, track.timeAt(ImGui::GetMousePos().x), wheel, track.duration);
  }
}

// Drawing -----------------------------------------------------------------------------------------------------------

void drawGround(const Track& track) {
  track.list.AddRectFilled({track.low.x, track.low.y}, {track.high.x, track.high.y}, palette::kBackground.packed(),
                           track.ui.px(4));
  const PlayRange range = playRange(track.transport(), track.ui.state.character());
  const float x0 = std::clamp(track.xOf(range.from), track.low.x, track.high.x);
  const float x1 = std::clamp(track.xOf(range.to), track.low.x, track.high.x);
  track.list.AddRectFilled({x0, track.band}, {x1, track.high.y}, palette::kRaised.faded(0.75f).packed());
  const float now = std::clamp(track.xOf(track.transport().time), x0, x1);
  track.list.AddRectFilled({x0, track.band}, {now, track.high.y}, palette::kAccent.faded(0.10f).packed());
}

void drawTicks(const Track& track) {
  const double perFrame = track.perSecond() * kFrameSeconds;
  const int step = tickStep(perFrame, static_cast<double>(track.ui.px(kLabelSpacing)));
  const int fine = tickStep(perFrame, static_cast<double>(track.ui.px(kTickSpacing)));
  const int small = step % fine == 0 ? fine : step;
  const auto first = static_cast<int>(std::ceil(track.shown.from / kFrameSeconds / small - 1e-9)) * small;
  const auto last = static_cast<int>(std::floor(track.shown.to / kFrameSeconds + 1e-6));
  for (int frame = first; frame <= last; frame += small) {
    const float x = std::floor(track.xOf(frame * kFrameSeconds)) + 0.5f;
    const bool labeled = frame % step == 0;
    const float length = track.ui.px(labeled ? 7.0f : 4.0f);
    track.list.AddLine({x, track.band}, {x, track.band + length},
                       (labeled ? palette::kMuted.faded(0.8f) : palette::kMuted.faded(0.35f)).packed());
    if (!labeled) continue;
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%d", frame);
    const float size = 0.86f * ImGui::GetFontSize();
    const ImVec2 at{x + track.ui.px(3), track.band + track.ui.px(1)};
    if (at.x + track.ui.px(24) > track.high.x) continue;
    track.list.AddText(ImGui::GetFont(), size, at, palette::kMuted.packed(), text.data());
  }
}

void drawKeys(const Track& track) {
  EditorState& state = track.ui.state;
  TimelineState& timeline = state.open.timeline;
  const float column = track.ui.px(kColumn);
  const int columns = std::max(1, static_cast<int>(track.width() / column));
  const bool same = timeline.densityOf.from == track.shown.from && timeline.densityOf.to == track.shown.to;
  if (!same || static_cast<int>(timeline.density.size()) != columns) {
    const auto clip = static_cast<std::size_t>(state.open.transport.clip);
    timeline.density = keyDensity(state.character().clips[clip], track.shown, columns);
    timeline.densityOf = track.shown;
  }
  const float bottom = track.high.y - track.ui.px(2);
  for (int i = 0; i < columns; ++i) {
    const float density = timeline.density[static_cast<std::size_t>(i)];
    if (density <= 0.0f) continue;
    const float x = track.low.x + static_cast<float>(i) * column;
    const float top = bottom - track.ui.px(kKeysHeight) * (0.4f + 0.6f * density);
    track.list.AddRectFilled({x, top}, {x + column - 0.5f, bottom},
                             palette::kGood.faded(0.30f + 0.55f * density).packed());
  }
}

void drawPlayhead(const Track& track) {
  const float x = std::clamp(track.xOf(track.transport().time), track.low.x, track.high.x);
  const float half = track.ui.px(4.5f);
  const float top = track.band - track.ui.px(1);
  const ImU32 color = palette::kAccent.packed();
  track.list.AddRectFilled({x - track.ui.px(1), top}, {x + track.ui.px(1), track.high.y}, color);
  track.list.AddTriangleFilled({x - half, top}, {x + half, top}, {x, top + track.ui.px(6)}, color);
}

void drawIdle(const Track& track) {
  const char* text = track.transport().clip < 0 ? "Bind pose: the shape in which muscles are made. Nothing plays"
                                                : "This clip has a single frame";
  const ImVec2 size = ImGui::CalcTextSize(text);
  track.list.AddRectFilled({track.low.x, track.low.y}, {track.high.x, track.high.y}, palette::kBackground.packed(),
                           track.ui.px(4));
  track.list.AddText({0.5f * (track.low.x + track.high.x - size.x), 0.5f * (track.low.y + track.high.y - size.y)},
                     palette::kMuted.faded(0.8f).packed(), text);
}

}  // namespace

int tickStep(double pixelsPerFrame, double leastPixels) {
  constexpr std::array kSteps{1, 2, 5, 10, 15, 30, 60, 150, 300, 600, 1800, 3600, 9000, 18000, 36000, 108000};
  for (const int step : kSteps) {
    if (step * pixelsPerFrame >= leastPixels) return step;
  }
  return kSteps.back();
}

std::vector<float> keyDensity(const AnimationClip& clip, const PlayRange& span, int columns) {
  std::vector<float> density(static_cast<std::size_t>(columns), 0.0f);
  const double scale = columns / (span.to - span.from);
  for (const Channel& channel : clip.channels) {
    for (const float time : channel.times) {
      const double at = (static_cast<double>(time) - span.from) * scale;
      if (at < 0.0 || at > columns) continue;
      density[static_cast<std::size_t>(std::min(static_cast<int>(at), columns - 1))] += 1.0f;
    }
  }
  const float most = std::ranges::max(density);
  for (float& column : density) column = most > 0.0f ? column / most : 0.0f;
  return density;
}

PlayRange zoomedSpan(const PlayRange& span, double at, float steps, double duration) {
  const double length = span.to - span.from;
  const double least = std::min(duration, kLeastFrames * kFrameSeconds);
  const double wanted = std::clamp(length * std::pow(kZoomPerStep, -static_cast<double>(steps)), least, duration);
  const double from = std::clamp(at - (at - span.from) * wanted / length, 0.0, duration - wanted);
  return {from, wanted >= duration ? duration : from + wanted};
}

double TrackSpan::timeAt(float x) const {
  return std::clamp(shown.from + static_cast<double>(x - left) / perSecond(), 0.0, duration);
}

TrackSpan drawTimelineTrack(PanelUi& ui, float gutter) {
  const double duration = clipDuration(ui.state.open.transport, ui.state.character());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float height = std::max(room.y, ui.px(26));
  refresh(ui.state, duration);
  const Track track(ui, {corner.x + gutter, corner.y}, {corner.x + room.x, corner.y + height}, duration,
                    ui.state.open.timeline.shown);
  if (duration <= 0.0) {
    drawIdle(track);
    return track;
  }
  track.list.PushClipRect({track.low.x, track.low.y}, {track.high.x, track.high.y}, true);
  drawGround(track);
  drawTicks(track);
  drawKeys(track);
  const PlayRange range = playRange(ui.state.open.transport, ui.state.character());
  rangeHandle(track, "timeline/range.in", range.from, true);
  rangeHandle(track, "timeline/range.out", range.to, false);
  rangeBar(track);
  scrubArea(track);
  drawPlayhead(track);
  track.list.PopClipRect();
  return track;
}

}  // namespace sinew::app
