// app/panels/timeline/timeline.cpp: which clip, which moment, playing or not.

#include <imgui.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "app/document/motion_clip.h"
#include "app/document/shown_names.h"
#include "app/editor/pose_commands.h"
#include "app/panels/timeline/timeline.h"
#include "app/panels/timeline/timeline_track.h"
#include "core/skeleton/range_of_motion.h"

namespace sinew::app {
namespace {

/// As the list shows it.
std::string clipName(const std::vector<std::string>& shown, int clip) {
  return clip < 0 ? "Bind pose" : shown[static_cast<std::size_t>(clip)];
}

/// The name in the file, where another is shown.
void fileNameTooltip(PanelUi& ui, const std::vector<std::string>& shown, int clip) {
  if (clip < 0) return;
  const std::string& name = ui.state.character().clips[static_cast<std::size_t>(clip)].name;
  if (!name.empty() && name != clipName(shown, clip)) tooltip(ui, name);
}

/// One row of the list: the name, and at its right how long it lasts.
bool clipRow(PanelUi& ui, const std::vector<std::string>& names, int clip) {
  const Character& character = ui.state.character();
  ImGui::PushID(clip);
  const bool chosen = ImGui::Selectable(clipName(names, clip).c_str(), clip == ui.state.open.transport.clip);
  ImGui::PopID();
  ui.widgets.note("timeline/clip/" + std::to_string(clip));
  fileNameTooltip(ui, names, clip);
  if (clip < 0) return chosen;
  char length[32];
  const AnimationClip& shown = character.clips[static_cast<std::size_t>(clip)];
  std::snprintf(length, sizeof length, "%.2f s", static_cast<double>(shown.duration));
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(length).x);
  mutedText(length);
  return chosen;
}

void clipChoice(PanelUi& ui) {
  Transport& transport = ui.state.open.transport;
  const Character& character = ui.state.character();
  const std::vector<std::string> names = shownClipNames(character);
  ImGui::SetNextItemWidth(ui.px(180));
  ImGui::SetNextWindowSizeConstraints({ui.px(240), 0.0f}, {ui.px(480), ui.px(420)});
  const bool open = ImGui::BeginCombo("##clip", clipName(names, transport.clip).c_str(), ImGuiComboFlags_HeightLarge);
  ui.widgets.note("timeline/clip");
  if (!open) {
    fileNameTooltip(ui, names, transport.clip);
    return;
  }
  for (int clip = -1; clip < static_cast<int>(character.clips.size()); ++clip) {
    if (clipRow(ui, names, clip)) chooseClip(transport, clip, character);
  }
  if (findClip(character, kRangeOfMotionName) < 0) {
    ImGui::Separator();
    const bool wanted = ImGui::Selectable("Make range of motion");
    ui.widgets.note("timeline/clip/range-of-motion");
    if (wanted) run(action("play/range-of-motion"), ui.state);
  }
  ImGui::EndCombo();
}

void transportButtons(PanelUi& ui) {
  const float size = ImGui::GetFrameHeight();
  const float gap = ui.px(2);
  const bool playing = ui.state.open.transport.playing;
  actionButton(ui, "timeline/start", action("play/start"), Icon::kStart, size);
  ImGui::SameLine(0.0f, gap);
  actionButton(ui, "timeline/previous", action("play/previous"), Icon::kPrevious, size);
  ImGui::SameLine(0.0f, gap);
  actionButton(ui, "timeline/play", action("play/toggle"), playing ? Icon::kPause : Icon::kPlay, size);
  ImGui::SameLine(0.0f, gap);
  actionButton(ui, "timeline/next", action("play/next"), Icon::kNext, size);
  ImGui::SameLine(0.0f, gap);
  actionButton(ui, "timeline/end", action("play/end"), Icon::kEnd, size);
  ImGui::SameLine(0.0f, ui.px(8));
  actionButton(ui, "timeline/loop", action("play/loop"), Icon::kLoop, size);
}

void speedField(PanelUi& ui) {
  ImGui::SetNextItemWidth(ui.px(84));
  ImGui::DragFloat("##speed", &ui.state.open.transport.speed, 0.01f, 0.1f, 4.0f, "%.2f x",
                   ImGuiSliderFlags_AlwaysClamp);
  ui.widgets.note("timeline/speed");
  tooltip(ui, "Speed: drag, or double click to type");
}

/// How many joints are turned by hand, so that an odd pose is explained, and a button that resets them.
void posedChip(PanelUi& ui) {
  if (!isPosed(ui.state)) return;
  const PoseOverrides& overrides = ui.state.open.transport.overrides;
  const bool holds = overrides.from == TurnsFrom::kBindPose;
  const std::string text = std::to_string(overrides.turns.size()) +
                           (overrides.turns.size() == 1 ? " joint posed" : " joints posed") + (holds ? ", held" : "");
  ImGui::SameLine(0.0f, ui.px(12));
  ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccent.faded(0.22f));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, palette::kAccent.faded(0.34f));
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, palette::kAccent.faded(0.42f));
  const bool chosen = ImGui::Button((text + "##posed").c_str());
  ImGui::PopStyleColor(3);
  ui.widgets.note("timeline/posed");
  tooltip(ui,
          "Joints are turned by hand, on top of the clip. A pose is only for viewing: neither the rig nor a file "
          "changes. Click for the pose tool.");
  if (chosen) run(action("tool/pose"), ui.state);
  ImGui::SameLine(0.0f, ui.px(2));
  actionButton(ui, "timeline/pose-reset", action("tool/pose-reset"), Icon::kClose, ImGui::GetFrameHeight());
}

void timeReadout(PanelUi& ui, double duration) {
  char text[96];
  const auto frames = [](double seconds) { return static_cast<int>(std::lround(seconds / kFrameSeconds)); };
  std::snprintf(text, sizeof text, "%d / %d   %6.2f / %.2f s", frames(ui.state.open.transport.time), frames(duration),
                ui.state.open.transport.time, duration);
  ImGui::PushFont(ui.fonts.mono);
  const float width = ImGui::CalcTextSize(text).x;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
  ImGui::AlignTextToFramePadding();
  mutedText(text);
  ImGui::PopFont();
  ui.widgets.note("timeline/time");
}

}  // namespace

void drawTimeline(PanelUi& ui) {
  const double duration = clipDuration(ui.state.open.transport, ui.state.character());
  clipChoice(ui);
  ImGui::SameLine(0.0f, ui.px(12));
  transportButtons(ui);
  ImGui::SameLine(0.0f, ui.px(12));
  speedField(ui);
  posedChip(ui);
  timeReadout(ui, duration);
  drawTimelineTrack(ui);
}

}  // namespace sinew::app
