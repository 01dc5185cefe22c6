// app/panels/timeline.cpp: which clip, which moment, playing or not.

#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "app/panels/panels.h"

namespace sinew::app {
namespace {

std::string clipName(const Character& character, int clip) {
  if (clip < 0) return "Bind pose";
  const std::string& name = character.clips[static_cast<std::size_t>(clip)].name;
  return name.empty() ? "clip " + std::to_string(clip + 1) : name;
}

void clipChoice(Ui& ui) {
  Transport& transport = ui.state.transport;
  const Character& character = ui.state.character();
  ImGui::SetNextItemWidth(ui.px(170));
  const bool open =
      ImGui::BeginCombo("##clip", clipName(character, transport.clip).c_str(), ImGuiComboFlags_HeightLarge);
  ui.widgets.note("timeline/clip");
  if (!open) return;
  for (int clip = -1; clip < static_cast<int>(character.clips.size()); ++clip) {
    ImGui::PushID(clip);
    const bool chosen = ImGui::Selectable(clipName(character, clip).c_str(), clip == transport.clip);
    ImGui::PopID();
    ui.widgets.note("timeline/clip/" + std::to_string(clip));
    if (chosen) chooseClip(transport, clip, character);
  }
  ImGui::EndCombo();
}

void transportButtons(Ui& ui) {
  const float size = ImGui::GetFrameHeight();
  const float gap = ui.px(2);
  const bool playing = ui.state.transport.playing;
  actionButton(ui, "timeline/start", action("play/start"), Icon::kStart, size);
  ImGui::SameLine(0.0f, gap);
  actionButton(ui, "timeline/previous", action("play/previous"), Icon::kPrevious, size);
  ImGui::SameLine(0.0f, gap);
  actionButton(ui, "timeline/play", action("play/toggle"), playing ? Icon::kPause : Icon::kPlay, size);
  ImGui::SameLine(0.0f, gap);
  actionButton(ui, "timeline/next", action("play/next"), Icon::kNext, size);
  ImGui::SameLine(0.0f, gap);
  actionButton(ui, "timeline/loop", action("play/loop"), Icon::kLoop, size);
}

void speedField(Ui& ui) {
  ImGui::SetNextItemWidth(ui.px(84));
  ImGui::DragFloat("##speed", &ui.state.transport.speed, 0.01f, 0.1f, 4.0f, "%.2f x", ImGuiSliderFlags_AlwaysClamp);
  ui.widgets.note("timeline/speed");
  tooltip(ui, "Speed");
}

void timeReadout(Ui& ui, double duration) {
  char text[64];
  std::snprintf(text, sizeof text, "%6.2f / %.2f s", ui.state.transport.time, duration);
  ImGui::PushFont(ui.fonts.mono);
  const float width = ImGui::CalcTextSize(text).x;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
  ImGui::AlignTextToFramePadding();
  mutedText(text);
  ImGui::PopFont();
  ui.widgets.note("timeline/time");
}

void scrubber(Ui& ui, double duration) {
  Transport& transport = ui.state.transport;
  ImGui::BeginDisabled(duration <= 0.0);
  auto time = static_cast<float>(transport.time);
  ImGui::SetNextItemWidth(-1.0f);
  beginFilledSlider();
  const bool scrubbed = ImGui::SliderFloat("##scrub", &time, 0.0f, static_cast<float>(std::max(duration, 1e-3)), "",
                                           ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
  endFilledSlider(ui, duration > 0.0 ? static_cast<float>(transport.time / duration) : 0.0f);
  if (scrubbed) {
    transport.time = std::min(static_cast<double>(time), duration);
    transport.playing = false;
  }
  ui.widgets.note("timeline/scrub");
  ImGui::EndDisabled();
}

}  // namespace

void drawTimeline(Ui& ui) {
  const double duration = clipDuration(ui.state.transport, ui.state.character());
  clipChoice(ui);
  ImGui::SameLine(0.0f, ui.px(12));
  transportButtons(ui);
  ImGui::SameLine(0.0f, ui.px(12));
  speedField(ui);
  timeReadout(ui, duration);
  scrubber(ui, duration);
}

}  // namespace sinew::app
