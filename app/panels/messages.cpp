// app/panels/messages.cpp: what an import left out, what failed. Stays until dismissed.

#include <imgui.h>

#include <algorithm>
#include <string>

#include "app/panels/panels.h"

namespace sinew::app {
namespace {

constexpr float kWidth = 430.0f;  // Design pixels.
constexpr float kHighest = 210.0f;

float textHeight(const std::string& text, float width) {
  return ImGui::CalcTextSize(text.c_str(), nullptr, false, width).y;
}

std::string shown(const Message& message) {
  return message.count > 1 ? message.text + "  (" + std::to_string(message.count) + " times)" : message.text;
}

/// @return whether it was dismissed.
bool drawMessage(Ui& ui, const Message& message, std::size_t index) {
  const float button = ui.px(20);
  const float wrap = ImGui::GetContentRegionAvail().x - button - ui.px(18);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const Tint tint = message.kind == MessageKind::kError ? palette::kError : palette::kWarning;
  const std::string text = shown(message);
  ImGui::GetWindowDrawList()->AddRectFilled(
      {corner.x, corner.y + ui.px(2)}, {corner.x + ui.px(3), corner.y + textHeight(text, wrap)}, tint.packed(), 2.0f);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.px(12));
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + wrap);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::SameLine();
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - button);
  return iconButton(ui, "messages/dismiss/" + std::to_string(index), Icon::kClose, false, button);
}

float wantedHeight(Ui& ui) {
  const float wrap = ui.px(kWidth) - ui.px(20 + 18 + 20);
  float height = ImGui::GetFrameHeight() + ui.px(26);
  for (const Message& message : ui.state.messages)
    height += std::max(textHeight(shown(message), wrap), ui.px(20)) + ui.px(6);
  return height;
}

}  // namespace

void drawMessages(Ui& ui) {
  std::vector<Message>& messages = ui.state.messages;
  if (messages.empty()) return;
  const float height = std::min({wantedHeight(ui), ui.px(kHighest), ui.state.viewport.w * 0.6f});
  ImGui::SetCursorPos({ui.px(10), ui.state.viewport.w - height - ui.px(10)});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPanel.faded(0.95f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(8)});
  ImGui::BeginChild("messages", {std::min(ui.px(kWidth), ui.state.viewport.z - ui.px(20)), height}, true,
                    ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  ImGui::AlignTextToFramePadding();
  heading(ui, "Messages");
  const char* label = "Dismiss all";
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(label).x -
                  2.0f * ImGui::GetStyle().FramePadding.x);
  const bool all = ImGui::Button(label);
  ui.widgets.note("messages/dismiss-all");
  std::size_t dismissed = messages.size();
  for (std::size_t i = 0; i < messages.size(); ++i) {
    if (drawMessage(ui, messages[i], i)) dismissed = i;
  }
  if (all) {
    messages.clear();
  } else if (dismissed < messages.size()) {
    messages.erase(messages.begin() + static_cast<std::ptrdiff_t>(dismissed));
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
}

}  // namespace sinew::app
