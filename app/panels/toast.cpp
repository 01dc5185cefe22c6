// app/panels/toast.cpp: what has just been done, for a moment, at the bottom of the picture.

#include <imgui.h>
#include <imgui_internal.h>  // Where a dialog lies, which 1.86 keeps to itself.

#include <algorithm>
#include <optional>

#include "app/panels/overlay.h"
#include "app/ui/reading_order.h"

namespace sinew::app {
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

/// A dialog that lies where the toast would: the toast's y below it, or above. None: there is no such dialog.
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

/// The toast's y above the plates that lie low in the picture, where it would cover them.
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

/// Top left corner: bottom center of the picture, above the messages; beside the pointer if that is where it would lie.
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

/// Drawn over everything, part of no window: it takes neither the pointer nor the keyboard.
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
