// app/panels/messages.cpp: messages and their count in the status line; the toast; parts of panels over the picture.
#include <algorithm>
#include <optional>
#include <string>

#include <imgui_internal.h>  // Position of a dialog: internal in 1.86.

#include "app/panels/overlay.h"
#include "app/ui/reading_order.h"

namespace sinew::app {
namespace {

constexpr float kMessagesWidth = 450.0f;  // Design pixels.
constexpr float kMessagesHighest = 230.0f;
constexpr float kMessagesButton = 20.0f;
constexpr float kTextLeft = 24.0f;
constexpr float kMessagesNarrowest = 0.85f;  ///< Fraction of its width that a panel keeps beside the axes.

float textHeight(const std::string& text, float width) {
  return ImGui::CalcTextSize(text.c_str(), nullptr, false, width).y;
}

std::string shown(const Message& message) {
  return message.count > 1 ? message.text + "  (" + std::to_string(message.count) + " times)" : message.text;
}

struct KindLook {
  const char* name;
  Icon icon;
  Tint tint;
};
KindLook lookOf(MessageKind kind) {
  switch (kind) {
    case MessageKind::kError:
      return {"error: ", Icon::kError, palette::kError};
    case MessageKind::kWarning:
      return {"warning: ", Icon::kWarning, palette::kWarning};
    case MessageKind::kNote:
      break;
  }
  return {"note: ", Icon::kNote, palette::kMuted};
}

std::string allText(const std::vector<Message>& messages) {
  std::string text;
  for (const Message& message : messages) text += lookOf(message.kind).name + shown(message) + "\n";
  return text;
}

/// @return whether it was dismissed
bool drawMessage(PanelUi& ui, const Message& message, std::size_t index) {
  const float button = ui.px(kMessagesButton);
  const float wrap = ImGui::GetContentRegionAvail().x - 2.0f * button - ui.px(kTextLeft + 8);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const std::string text = shown(message);
  const std::string place = std::to_string(index);
  const KindLook look = lookOf(message.kind);
  drawIcon(*ImGui::GetWindowDrawList(), look.icon, {corner.x, corner.y + ui.px(1)}, ui.px(15), look.tint.packed());
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.px(kTextLeft));
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + wrap);
  ImGui::TextUnformatted(inReadingOrder(text).c_str());
  ImGui::PopTextWrapPos();
  ImGui::SameLine();
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 2.0f * button);
  if (iconButton(ui, "messages/copy/" + place, Icon::kCopy, false, button)) ImGui::SetClipboardText(text.c_str());
  tooltip(ui, "Copy the text");
  ImGui::SameLine(0.0f, 0.0f);
  const bool dismissed = iconButton(ui, "messages/dismiss/" + place, Icon::kClose, false, button);
  tooltip(ui, "Dismiss");
  return dismissed;
}

float wantedHeight(PanelUi& ui) {
  const float wrap = ui.px(kMessagesWidth) - ui.px(2 * kMessagesButton + kTextLeft + 8 + 20);
  float height = ImGui::GetFrameHeight() + ui.px(26);
  for (const Message& message : ui.state.session.messages)
    height += std::max(textHeight(shown(message), wrap), ui.px(kMessagesButton)) + ui.px(6);
  return height;
}

/// The title, and buttons at the right. @return whether to clear all
bool drawMessagesHead(PanelUi& ui) {
  ImGui::AlignTextToFramePadding();
  heading(ui, "Messages");
  const float size = ImGui::GetFrameHeight();
  ImGui::SameLine(ImGui::GetContentRegionMax().x - buttonWidth("Copy all") - buttonWidth("Clear") - size -
                  2.0f * ui.px(4));
  if (textButton(ui, "messages/copy-all", "Copy all"))
    ImGui::SetClipboardText(allText(ui.state.session.messages).c_str());
  ImGui::SameLine(0.0f, ui.px(4));
  const bool all = textButton(ui, "messages/dismiss-all", "Clear");
  ImGui::SameLine(0.0f, ui.px(4));
  if (iconButton(ui, "messages/hide", Icon::kMinimize, false, size)) ui.state.session.messagesShown = false;
  tooltip(ui, "Hide; the status line still counts them");
  return all;
}

}  // namespace

float messagesHeight(PanelUi& ui) {
  if (ui.state.session.messages.empty() || !ui.state.session.messagesShown) return 0.0f;
  return std::min({wantedHeight(ui), ui.px(kMessagesHighest), ui.state.frame.viewport.w * 0.4f});
}

float lowestInPicture(PanelUi& ui) {
  const float messages = messagesHeight(ui);
  const float lowest = ui.state.frame.viewport.w - ui.px(kFromEdges);
  return messages > 0.0f ? lowest - messages - ui.px(kFromEdges) : lowest;
}

float widthInPicture(const PanelUi& ui, float wanted) {
  const float picture = ui.state.frame.viewport.z;
  const float besideAxes = picture - ui.px(kBesideTools + kBesideAxes);
  const bool fits = besideAxes >= kMessagesNarrowest * ui.px(wanted);
  return std::min(ui.px(wanted), fits ? besideAxes : picture - ui.px(kBesideTools + kFromEdges));
}

void beginInPicture(PanelUi& ui, const char* name, const ImVec2& at, const ImVec2& size, float opacity,
                    const ImVec2& padding, ImGuiWindowFlags flags) {
  ImGui::SetCursorPos(at);
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPanel.faded(opacity));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(padding.x), ui.px(padding.y)});
  ImGui::BeginChild(name, size, true, flags | ImGuiWindowFlags_AlwaysUseWindowPadding);
}

void endInPicture() {
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

void drawRamp(const ImVec2& low, float width, float bottom, int steps, ImU32 (*color)(float)) {
  for (int i = 0; i < steps; ++i) {
    const float a = static_cast<float>(i) / static_cast<float>(steps);
    const float b = static_cast<float>(i + 1) / static_cast<float>(steps);
    ImGui::GetWindowDrawList()->AddRectFilledMultiColor({low.x + a * width, low.y}, {low.x + b * width, bottom},
                                                        color(a), color(b), color(b), color(a));
  }
}

void drawMessages(PanelUi& ui) {
  std::vector<Message>& messages = ui.state.session.messages;
  const float height = messagesHeight(ui);
  if (height <= 0.0f) return;
  ImGui::SetCursorPos({ui.px(10), ui.state.frame.viewport.w - height - ui.px(10)});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPanel.faded(0.95f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(8)});
  ImGui::BeginChild("messages", {std::min(ui.px(kMessagesWidth), ui.state.frame.viewport.z - ui.px(20)), height}, true,
                    ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  if (ui.state.session.messagesSaid != ui.state.open.messagesSeen) ImGui::SetScrollY(0.0f);  // The newest is on top.
  ui.state.open.messagesSeen = ui.state.session.messagesSaid;
  const bool all = drawMessagesHead(ui);
  std::size_t dismissed = messages.size();
  for (std::size_t i = messages.size(); i-- > 0;) {  // The newest first.
    if (drawMessage(ui, messages[i], i)) dismissed = i;
  }
  if (all) {
    messages.clear();
  } else if (dismissed < messages.size()) {
    messages.erase(messages.begin() + static_cast<std::ptrdiff_t>(dismissed));
  }
  const bool over = ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows);
  ImGui::EndChild();
  ImGui::PopStyleColor();
  // A click in the picture hides them; the status line still counts them.
  const bool work = ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1) || ImGui::IsMouseClicked(2);
  if (work && !over && ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows)) ui.state.session.messagesShown = false;
}

float drawMessageBadge(PanelUi& ui) {
  const std::vector<Message>& messages = ui.state.session.messages;
  if (messages.empty()) return 0.0f;
  const KindLook look = lookOf(std::ranges::max(messages, {}, &Message::kind).kind);
  const std::string count = std::to_string(messages.size());
  const float height = ImGui::GetTextLineHeight() + ui.px(4);
  const float width = ImGui::CalcTextSize(count.c_str()).x + ui.px(34);
  const float right = ImGui::GetContentRegionMax().x;
  ImGui::SetCursorPos({right - width, ImGui::GetCursorPosY() - ui.px(2)});
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton("badge", {width, height}))
    ui.state.session.messagesShown = !ui.state.session.messagesShown;
  ui.widgets.note("status/messages");
  const bool lit = ImGui::IsItemHovered() || ui.state.session.messagesShown;
  tooltip(ui, ui.state.session.messagesShown ? "Hide the messages" : "Show the messages");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width, corner.y + height}, look.tint.faded(lit ? 0.30f : 0.16f).packed(),
                     0.5f * height);
  drawIcon(list, look.icon, {corner.x + ui.px(7), corner.y + 0.5f * (height - ui.px(14))}, ui.px(14),
           look.tint.packed());
  list.AddText({corner.x + ui.px(26), corner.y + ui.px(2)}, palette::kText.packed(), count.c_str());
  return width;
}

// The toast: a short message at the bottom of the picture.

namespace {

constexpr float kPadX = 14.0f;  // Design pixels, as all here.
constexpr float kPadY = 8.0f;
constexpr float kWidest = 520.0f;
constexpr float kAboveBottom = 14.0f;
constexpr float kFromPointer = 22.0f;
constexpr float kFromDialog = 6.0f;
constexpr float kIcon = 15.0f;
constexpr float kIconGap = 8.0f;

bool near(const ImVec2& point, const ImVec2& low, const ImVec2& high, float distance) {
  return point.x > low.x - distance && point.x < high.x + distance && point.y > low.y - distance &&
         point.y < high.y + distance;
}

/// The toast's y below or above a dialog that would overlap it; none without such a dialog.
std::optional<float> besideDialog(const PanelUi& ui, const ImVec2& low, const ImVec2& size) {
  const ImGuiWindow* const dialog = ImGui::GetTopMostPopupModal();
  if (dialog == nullptr) return std::nullopt;
  const ImRect taken = dialog->Rect();
  if (!taken.Overlaps(ImRect(low, {low.x + size.x, low.y + size.y}))) return std::nullopt;
  const float gap = ui.px(kFromDialog);
  const float below = taken.Max.y + gap;
  const bool fits = below + size.y + gap <= ImGui::GetIO().DisplaySize.y;
  return fits ? below : std::max(taken.Min.y - gap - size.y, 0.0f);
}

/// The toast's y above plates at the bottom of the picture that it would cover.
float abovePlates(const PanelUi& ui, const ImVec2& low, const ImVec2& size) {
  const glm::vec4& picture = ui.state.frame.viewport;
  float y = low.y;
  for (const glm::vec4& box : ui.covered) {
    const bool isPlate = box.y > picture.y + 0.4f * picture.w;
    const bool covers = low.x < box.z && low.x + size.x > box.x && low.y < box.w && low.y + size.y > box.y;
    if (isPlate && covers) y = std::min(y, box.y - ui.px(kAboveBottom) - size.y);
  }
  return y;
}

/// Top left corner: at the bottom center of the picture, above the messages, and not under the pointer.
ImVec2 placeOf(PanelUi& ui, const ImVec2& size) {
  const glm::vec4& picture = ui.state.frame.viewport;
  const float below = messagesHeight(ui);
  ImVec2 low{picture.x + 0.5f * (picture.z - size.x), picture.y + picture.w - ui.px(kAboveBottom) - size.y -
                                                          (below > 0.0f ? below + ui.px(kAboveBottom) : 0.0f)};
  low.y = abovePlates(ui, low, size);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (const std::optional<float> y = besideDialog(ui, low, size)) return {low.x, *y};
  const float distance = ui.px(kFromPointer);
  if (!near(mouse, low, {low.x + size.x, low.y + size.y}, distance)) return low;
  low.y = mouse.y - distance - size.y;
  if (low.y < picture.y) low.y = mouse.y + distance;
  return low;
}

}  // namespace

/// Drawn in front of all windows; takes neither pointer nor keyboard.
void drawToast(PanelUi& ui) {
  std::optional<Toast>& toast = ui.state.session.toast;
  if (!toast) return;
  const std::optional<double> change = secondsToChange(*toast, ui.state.frame.now);
  if (!change) {
    toast.reset();
    return;
  }
  ui.wakeIn(*change);
  const float shown = opacity(*toast, ui.state.frame.now);
  const float widest = std::min(ui.px(kWidest), ui.state.frame.viewport.z - ui.px(2 * kPadX + kIcon + kIconGap + 20));
  const std::string words = inReadingOrder(toast->text);
  const ImVec2 text = ImGui::CalcTextSize(words.c_str(), nullptr, false, widest);
  const ImVec2 size{text.x + ui.px(2 * kPadX + kIcon + kIconGap), text.y + ui.px(2 * kPadY)};
  const ImVec2 low = placeOf(ui, size);
  const ImVec2 high{low.x + size.x, low.y + size.y};
  const Tint tint = toast->refusal ? palette::kWarning : palette::kGood;
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.AddRectFilled(low, high, palette::kRaised.faded(0.97f * shown).packed(), ui.px(6));
  list.AddRect(low, high, tint.faded(0.55f * shown).packed(), ui.px(6));
  drawIcon(list, toast->refusal ? Icon::kWarning : Icon::kNote, {low.x + ui.px(kPadX), low.y + ui.px(kPadY)},
           ui.px(kIcon), tint.faded(shown).packed());
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + ui.px(kPadX + kIcon + kIconGap), low.y + ui.px(kPadY)},
               palette::kText.faded(shown).packed(), words.c_str(), nullptr, widest);
  ui.widgets.note("toast", {low.x, low.y, size.x, size.y});
}

}  // namespace sinew::app
