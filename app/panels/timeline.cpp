// app/panels/timeline.cpp: the timeline's controls: clip, playback, speed, time.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

#include "app/document/shown_names.h"
#include "app/editor/edit.h"
#include "app/editor/pose_commands.h"
#include "app/panels/panels.h"
#include "app/panels/timeline.h"
#include "app/ui/number_field.h"
#include "core/character/range_of_motion.h"
#include "core/geometry/at.h"
#include "core/rig/motion_clip.h"

namespace sinew::app {
namespace {

const Control kClipChoice{"timeline/clip", "Clip", "animation choose"};
const Control kPlaySpeed{"timeline/speed", "Speed", "playback slow fast"};

constexpr float kClipWidth = 180.0f;  // Design pixels.
constexpr float kClipNarrowest = 96.0f;
constexpr float kSpeedWidth = 84.0f;
constexpr float kTimelineLowest = 60.0f;  // Controls and track.

std::string clipName(const std::vector<std::string>& shown, int clip) {
  return clip < 0 ? "Bind pose" : at(shown, clip);
}

/// "From walk.glb"; "" for the character's own clips.
std::string originOf(const AnimationClip& clip) {
  return clip.addedFrom.empty() ? "" : "From " + std::filesystem::path(clip.addedFrom).filename().string();
}

/// The name in the file if it differs from the drawn one, and the file if it is not the character's.
void fileNameTooltip(PanelUi& ui, const std::string& drawn, int clip) {
  if (clip < 0) return;
  const AnimationClip& shown = at(ui.state.character().clips, clip);
  std::string text = shown.name != drawn ? shown.name : "";
  const std::string origin = originOf(shown);
  if (!origin.empty()) text += (text.empty() ? "" : "\n") + origin;
  if (!text.empty()) tooltip(ui, text);
}

void originHeading(PanelUi& ui, int clip) {
  const std::vector<AnimationClip>& clips = ui.state.character().clips;
  const std::string before = clip > 0 ? at(clips, clip - 1).addedFrom : "";
  if (clip < 0 || at(clips, clip).addedFrom == before) return;
  ImGui::Separator();
  const std::string origin = originOf(at(clips, clip));
  if (!origin.empty()) mutedText(fitted(origin, ImGui::GetContentRegionAvail().x).c_str());
}

bool clipRow(PanelUi& ui, const std::vector<std::string>& names, int clip) {
  const Character& character = ui.state.character();
  ImGui::PushID(clip);
  const std::string shown = fitted(clipName(names, clip), ImGui::GetContentRegionAvail().x - ui.px(70));
  const bool chosen = ImGui::Selectable(shown.c_str(), clip == ui.state.open.transport.clip);
  ImGui::PopID();
  ui.widgets.note("timeline/clip/" + std::to_string(clip));
  fileNameTooltip(ui, shown, clip);
  if (clip < 0) return chosen;
  char length[32];
  const float seconds = at(character.clips, clip).duration;
  std::snprintf(length, sizeof length, "%.2f s", static_cast<double>(seconds));
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(length).x);
  mutedText(length);
  return chosen;
}

void clipChoice(PanelUi& ui, float width) {
  Transport& transport = ui.state.open.transport;
  const Character& character = ui.state.character();
  const std::vector<std::string> names = shownClipNames(character);
  const float room = width - ImGui::GetFrameHeight() - 2.0f * ImGui::GetStyle().FramePadding.x;
  const std::string shown = fitted(clipName(names, transport.clip), room);
  ImGui::SetNextItemWidth(width);
  // The rows are as wide as the list, so they cannot determine its width.
  ImGui::SetNextWindowSizeConstraints({ui.px(300), 0.0f}, {ui.px(480), ui.px(420)});
  const bool open = ImGui::BeginCombo("##clip", shown.c_str(), ImGuiComboFlags_HeightLarge);
  ui.widgets.note(kClipChoice.id);
  if (!open) {
    fileNameTooltip(ui, shown, transport.clip);
    return;
  }
  for (int clip = -1; clip < static_cast<int>(character.clips.size()); ++clip) {
    originHeading(ui, clip);
    if (clipRow(ui, names, clip)) chooseClip(transport, clip, character);
  }
  ImGui::Separator();
  const bool adds = ImGui::Selectable(action("file/add-clips").label);
  ui.widgets.note("timeline/clip/add");
  tooltip(ui, hintOf(ui, action("file/add-clips")));
  if (adds) run(action("file/add-clips"), ui.state);
  if (findClip(character, kRangeOfMotionName) < 0) {
    const bool wanted = ImGui::Selectable("Make range of motion");
    ui.widgets.note("timeline/clip/range-of-motion");
    if (wanted) run(action("play/range-of-motion"), ui.state);
  }
  ImGui::EndCombo();
}

void speedField(PanelUi& ui) {
  ImGui::SetNextItemWidth(ui.px(kSpeedWidth));
  NumberLook look{"%.2f x", 0.01f, 0.1f, 4.0f, 0.25f};
  Typing typing;
  look.typing = &typing;
  numberField("##speed", ui.state.open.transport.speed, look);
  if (!typing.refusal.empty()) sayRefusal(ui.state, typing.refusal);
  ui.widgets.note(kPlaySpeed.id);
  tooltip(ui, "Speed: drag (Shift: precise, Ctrl: steps), or double-click to type");
}

/// The number of joints that are turned by hand, which explains an odd pose.
std::string posedText(const EditorState& state) {
  const PoseOverrides& overrides = state.open.transport.overrides;
  const bool holds = overrides.from == TurnsFrom::kBindPose;
  return std::to_string(overrides.turns.size()) + (overrides.turns.size() == 1 ? " joint posed" : " joints posed") +
         (holds ? ", held" : "");
}

float posedWidth(const PanelUi& ui) {
  if (!isPosed(ui.state)) return 0.0f;
  return ImGui::CalcTextSize(posedText(ui.state).c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x + ui.px(2) +
         ImGui::GetFrameHeight();
}

/// A button with the number of posed joints, and one that resets them.
void posedChip(PanelUi& ui) {
  if (!isPosed(ui.state)) return;
  ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccent.faded(0.22f));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, palette::kAccent.faded(0.34f));
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, palette::kAccent.faded(0.42f));
  const bool chosen = ImGui::Button((posedText(ui.state) + "##posed").c_str());
  ImGui::PopStyleColor(3);
  ui.widgets.note("timeline/posed");
  tooltip(ui,
          "Joints are turned by hand, on top of the clip. A pose is only for viewing: neither the rig nor a file "
          "changes. Click for the pose tool.");
  if (chosen) run(action("tool/pose"), ui.state);
  ImGui::SameLine(0.0f, ui.px(2));
  actionButton(ui, "timeline/pose-reset", action("tool/pose-reset"), Icon::kClose, ImGui::GetFrameHeight());
}

void transportButton(PanelUi& ui, const char* id, const char* actionId, Icon icon) {
  actionButton(ui, id, action(actionId), icon, ImGui::GetFrameHeight());
}

void playButton(PanelUi& ui) {
  transportButton(ui, "timeline/play", "play/toggle", ui.state.open.transport.playing ? Icon::kPause : Icon::kPlay);
}

/// A control beside the clip's name.
struct TimelinePart {
  int place;     ///< From left to right.
  float before;  ///< Gap before it, design pixels.
  float width;   ///< Window coordinates.
  void (*draw)(PanelUi&);
};

/// The most important first: the last ones go into the menu if there is no room.
std::vector<TimelinePart> partsOf(const PanelUi& ui) {
  const float button = ImGui::GetFrameHeight();
  std::vector<TimelinePart> parts{
      {2, 2, button, playButton},
      {1, 2, button, [](PanelUi& u) { transportButton(u, "timeline/previous", "play/previous", Icon::kPrevious); }},
      {3, 2, button, [](PanelUi& u) { transportButton(u, "timeline/next", "play/next", Icon::kNext); }},
      {0, 12, button, [](PanelUi& u) { transportButton(u, "timeline/start", "play/start", Icon::kStart); }},
      {4, 2, button, [](PanelUi& u) { transportButton(u, "timeline/end", "play/end", Icon::kEnd); }},
      {5, 8, button, [](PanelUi& u) { transportButton(u, "timeline/loop", "play/loop", Icon::kLoop); }}};
  if (isPosed(ui.state)) parts.push_back({7, 12, posedWidth(ui), posedChip});
  parts.push_back({6, 12, ui.px(kSpeedWidth), speedField});
  return parts;
}

std::string shownTime(const EditorState& state, double duration, bool seconds) {
  char text[96];
  const auto frames = [](double time) { return static_cast<int>(std::lround(time / kFrameSeconds)); };
  const double time = state.open.transport.time;
  if (seconds) {
    std::snprintf(text, sizeof text, "%d / %d   %6.2f / %.2f s", frames(time), frames(duration), time, duration);
  } else {
    std::snprintf(text, sizeof text, "%d / %d", frames(time), frames(duration));
  }
  return text;
}

/// The longest form of the time that fits, at the right end.
void timeReadout(PanelUi& ui, double duration, float room) {
  ImGui::PushFont(ui.fonts.mono);
  for (const bool seconds : {true, false}) {
    const std::string text = shownTime(ui.state, duration, seconds);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    if (width + ui.px(12) > room) continue;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    ImGui::AlignTextToFramePadding();
    mutedText(text.c_str());
    ui.widgets.note("timeline/time");
    break;
  }
  ImGui::PopFont();
}

void drawParts(PanelUi& ui, std::vector<TimelinePart> parts) {
  std::ranges::sort(parts, {}, &TimelinePart::place);
  for (const TimelinePart& part : parts) {
    ImGui::SameLine(0.0f, ui.px(part.before));
    part.draw(ui);
  }
}

void drawControls(PanelUi& ui) {
  const double duration = clipDuration(ui.state.open.transport, ui.state.character());
  const std::vector<TimelinePart> parts = partsOf(ui);
  std::vector<float> widths;
  for (const TimelinePart& part : parts) widths.push_back(ui.px(part.before) + part.width);
  const float room = ImGui::GetContentRegionAvail().x;
  const float all = std::accumulate(widths.begin(), widths.end(), 0.0f);
  const float clip = std::clamp(room - all, ui.px(kClipNarrowest), ui.px(kClipWidth));
  const float more = ui.px(12) + ImGui::GetFrameHeight();
  const std::size_t shown = fittingCount(widths, room - clip, more);
  const auto split = parts.begin() + static_cast<std::ptrdiff_t>(shown);
  clipChoice(ui, clip);
  drawParts(ui, {parts.begin(), split});
  const float used = clip + std::accumulate(widths.begin(), widths.begin() + static_cast<std::ptrdiff_t>(shown), 0.0f);
  if (shown < parts.size()) {
    ImGui::SameLine(0.0f, ui.px(12));
    const float side = ImGui::GetFrameHeight();
    if (beginMore(ui, "timeline/more", {side, side})) {
      drawParts(ui, {split, parts.end()});
      endMore();
    }
  } else {
    timeReadout(ui, duration, room - used);
  }
}

}  // namespace

void drawTimeline(PanelUi& ui) {
  // Rows of keys are above the rest, so that nothing moves when they appear.
  const float wished = ui.px(keyRowsHeight(ui.state));
  const float rows = std::max(0.0f, std::min(wished, ImGui::GetContentRegionAvail().y - ui.px(kTimelineLowest)));
  const ImVec2 top = ImGui::GetCursorScreenPos();
  const float gutter = keyRowsGutter(ui);
  ImGui::SetCursorScreenPos({top.x, top.y + rows});
  drawControls(ui);
  const TrackSpan span = drawTimelineTrack(ui, gutter);
  if (rows <= 0.0f) return;
  ImGui::SetCursorScreenPos(top);
  drawKeyRows(ui, span, gutter, rows);
}

}  // namespace sinew::app
