// app/panels/picture_bars.cpp: bars over the picture: tools, display modes, the flex slider, Set driven key.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/animate.h"
#include "app/panels/overlay.h"
#include "app/ui/number_field.h"
#include "app/viewport/tools/viewport_tools.h"

namespace sinew::app {
namespace {

/// From left to right; "" is a line.
constexpr std::array kDisplay{"view/textured", "view/clay",     "view/classes",    "view/heat",    "",
                              "view/wire",     "view/skeleton", "view/primitives", "view/anatomy", "view/ground",
                              "view/numbers"};
constexpr std::size_t kUnderLine = 4;  ///< Number of the strip's buttons below its line.

/// "display/wire" for "view/wire".
std::string pillId(const char* actionId) {
  const std::string id = actionId;
  return "display" + id.substr(id.find('/'));
}

float pillWidth(PanelUi& ui, std::string_view actionId) {
  if (actionId.empty()) return ui.px(13);
  return ImGui::CalcTextSize(action(actionId).label).x + 2.0f * ImGui::GetStyle().FramePadding.x + ui.px(2);
}

void drawLine(PanelUi& ui) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float x = corner.x + ui.px(5);
  ImGui::GetWindowDrawList()->AddLine({x, corner.y + ui.px(4)}, {x, corner.y + ImGui::GetFrameHeight() - ui.px(4)},
                                      palette::kLine.packed());
  ImGui::SetCursorScreenPos({corner.x + ui.px(13), corner.y});
}

/// A menu item for an action whose button had no room.
void moreItem(PanelUi& ui, const std::string& id, const Action& item) {
  const bool enabled = item.enabled(ui.state);
  const bool checked = enabled && item.checked != nullptr && item.checked(ui.state);
  const std::string keys = "   " + keyText(item, ui.state);
  const bool chosen = ImGui::MenuItem(item.label, keys.c_str(), checked, enabled);
  ui.widgets.note(id);
  tooltip(ui, item.hint);
  if (chosen) run(item, ui.state);
}

struct StripButton {
  std::string id;
  std::string actionId;
  Icon icon;
};

std::vector<StripButton> stripButtons() {
  std::vector<StripButton> buttons;
  for (const Tool* const tool : tools()) {
    const std::string id = tool->id;
    buttons.push_back({"toolstrip" + id.substr(id.find('/')), id, tool->icon});
  }
  buttons.push_back({"toolstrip/box-select", "tool/box-select", Icon::kBox});
  buttons.push_back({"toolstrip/symmetry", "edit/symmetry", Icon::kSymmetry});
  buttons.push_back({"toolstrip/axes", "tool/axes", Icon::kAxes});
  buttons.push_back({"toolstrip/territory", "tool/territory", Icon::kTerritory});
  buttons.push_back({"toolstrip/before", "view/before", Icon::kBefore});
  return buttons;
}

void drawStripButton(PanelUi& ui, const StripButton& button, float size) {
  if (button.actionId == "tool/territory") {
    drawTerritoryButton(ui, size);
  } else if (button.actionId == "view/before") {
    drawBeforeButton(ui, size);
  } else {
    actionButton(ui, button.id, action(button.actionId), button.icon, size);
  }
  if (button.actionId == "tool/axes") {
    tooltip(ui, std::string("Now: ") + nameOf(ui.state.view.tools.gizmo.axes) + " axes");
  }
}

void beginBar(PanelUi& ui, const char* name, const ImVec2& at, const ImVec2& size, const ImVec2& spacing) {
  ImGui::SetCursorPos(at);
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPanel.faded(0.88f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(4), ui.px(4)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, spacing);
  ImGui::BeginChild(
      name, size, true,
      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_AlwaysUseWindowPadding);
}

void endBar() {
  ImGui::EndChild();
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
}

Possible withLines(const EditorState& state) {
  return withCharacter(state).also(!state.document.rig().lines.empty(), "No muscle rides a line");
}

const Control kFlexSlider{"view/flex-slider", "How hard muscles flex in the picture", "contract preview tension",
                          withLines};

const Control kFlexWhose{"view/flex-whose", "Flex all muscles or the selected", "preview", withLines};

constexpr float kFlexWidth = 250.0f;  // Design pixels, as all here.
constexpr float kNarrow = 200.0f;     // Below this the word is in the slider, and the button is hidden.
constexpr float kNarrowest = 100.0f;

/// Flexes while the key is held, or from one choice in the menu to the next.
void holdFlex(PanelUi& ui, FlexState& flex) {
  const bool held = keyHeld(ui, action("view/flex"));
  if (held) flex.byKey = flex.latched;
  if (held || !flex.byKey) return;
  flex.byKey = false;
  flex.latched = false;
}

std::string flexHint(const PanelUi& ui) {
  const std::string keys = keyText(action("view/flex"), ui.state);
  const std::string held = keys.empty() ? "" : "\nHold " + keys + ": fully flexed";
  return "Flexes muscles that have a line, to see them work. Not saved." + held;
}

void whoseButton(PanelUi& ui, FlexState& flex, float width) {
  ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
  if (ImGui::Button(flex.selectedAlone ? "Selected##flexed" : "All##flexed", {width, 0.0f}))
    flex.selectedAlone = !flex.selectedAlone;
  ui.widgets.note(kFlexWhose.id);
  tooltip(ui, flex.selectedAlone ? "Flexes only the selected muscles, or all if none of them has a line. Click: all."
                                 : "Flexes all muscles that have a line. Click: only the selected ones.");
}

}  // namespace

void drawToolStrip(PanelUi& ui) {
  const std::vector<StripButton> buttons = stripButtons();
  const float size = ui.px(34);
  const float row = size + ui.px(2);
  const float line = ui.px(9);
  const float more = ui.px(26);
  const float room = ui.state.frame.viewport.w - std::max(legendHeight(ui), ui.px(10)) - ui.px(54 + 8) - line;
  const std::vector<float> rows(buttons.size(), row);
  const std::size_t shown = fittingCount(rows, room, more);
  const bool all = shown == buttons.size();
  if (room < more) holdBefore(ui, false);
  if (room < more) return;
  const float height = static_cast<float>(shown) * row + line + ui.px(8) + (all ? 0.0f : more);
  beginBar(ui, "toolstrip", {ui.px(10), ui.px(54)}, {size + ui.px(8), height}, {0.0f, ui.px(2)});
  for (std::size_t i = 0; i < shown; ++i) {
    if (i + kUnderLine == buttons.size()) {
      ImGui::Dummy({0.0f, ui.px(1)});
      ImGui::Separator();
    }
    drawStripButton(ui, buttons[i], size);
  }
  if (!all && beginMore(ui, "toolstrip/more", {size, more - ui.px(2)})) {
    for (std::size_t i = shown; i < buttons.size(); ++i) moreItem(ui, buttons[i].id, action(buttons[i].actionId));
    endMore();
  }
  if (!all) holdBefore(ui, false);
  endBar();
}

void drawDisplayBar(PanelUi& ui) {
  const float more = ui.px(28);
  const float room = ui.state.frame.viewport.z - ui.px(20 + 8);
  std::vector<float> widths;
  for (const char* id : kDisplay) widths.push_back(pillWidth(ui, id));
  const std::size_t shown = fittingCount(widths, room, more);
  const bool all = shown == widths.size();
  if (room < more) return;
  float width = ui.px(8) + (all ? 0.0f : more);
  for (std::size_t i = 0; i < shown; ++i) width += widths[i];
  beginBar(ui, "display", {ui.px(10), ui.px(10)}, {width, ImGui::GetFrameHeight() + ui.px(8)}, {ui.px(2), 0.0f});
  for (std::size_t i = 0; i < shown; ++i) {
    if (std::string_view(kDisplay[i]).empty()) {
      drawLine(ui);
      continue;
    }
    actionPill(ui, pillId(kDisplay[i]), action(kDisplay[i]));
    ImGui::SameLine();
  }
  if (!all && beginMore(ui, "display/more", {more - ui.px(2), 0.0f})) {
    for (std::size_t i = shown; i < widths.size(); ++i) {
      if (std::string_view(kDisplay[i]).empty()) ImGui::Separator();
      else moreItem(ui, pillId(kDisplay[i]), action(kDisplay[i]));
    }
    endMore();
  }
  endBar();
}

void drawFlex(PanelUi& ui) {
  FlexState& flex = ui.state.open.flex;
  const glm::vec4& v = ui.state.frame.viewport;
  if (ui.state.document.rig().lines.empty()) flex = {};
  if (ui.state.document.rig().lines.empty()) return;
  holdFlex(ui, flex);
  // Beside the numbers if there is room, else below them.
  const float room = v.z - ui.px(kBesideTools + kFromEdges);
  const float beside = room - numbersWidth(ui);
  const bool under = beside < ui.px(kNarrowest);
  const float width = std::min(ui.px(kFlexWidth), under ? room : beside);
  if (width < ui.px(kNarrowest)) return;
  const bool narrow = width < ui.px(kNarrow);
  const float height = ImGui::GetFrameHeight() + ui.px(8);
  beginInPicture(ui, "flex", {ui.px(kBesideTools), ui.px(under ? 90.0f : 54.0f)}, {width, height}, 0.88f, {8, 4},
                 ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  if (!narrow) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Flex");
    ImGui::SameLine();
  }
  float percent = 100.0f * flex.shown();
  const float button = buttonWidth("Selected");
  const float whose = narrow ? 0.0f : button + ImGui::GetStyle().ItemInnerSpacing.x;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - whose);
  const bool edited =
      numberSlider(ui, "##flex", percent, {narrow ? "Flex %.0f %%" : "%.0f %%", 0.0f, 0.0f, 100.0f, 10.0f, true});
  ui.widgets.note(kFlexSlider.id);
  if (edited) flex = {percent / 100.0f, flex.selectedAlone};
  tooltip(ui, flexHint(ui));
  if (!narrow) whoseButton(ui, flex, button);
  endInPicture();
}

// Shown while driven keys are set: the numbers, their input and its current value.

namespace {

constexpr float kDrivenKeyTop = 54.0f;  // Design pixels, as all here: below the display bar.
constexpr float kBelowFlex = 42.0f;
constexpr float kNumbers = 186.0f;  // The numbers at the right, with their margin.

}  // namespace

void drawDrivenKey(PanelUi& ui) {
  if (!ui.state.open.animate.drivenKey.isOn()) return;
  const std::vector<NumberRef> refs = drivenKeyNumbers(ui.state);
  const DriverInput input = ui.state.open.animate.drivenKey.input;
  const std::optional<float> x = inputNow(ui.state, input);
  if (refs.empty() || !x) return endDrivenKey(ui.state);
  const std::string inputWords = wordsFor(input, ui.state.character().skeleton);
  const std::string numberWords = wordsFor(ui.state.document.rig(), refs);
  const std::string text = numberWords + " by " + inputWords;
  const std::string now = inputText(input.kind, *x);
  const std::string key = keyText(action("edit/key"), ui.state);
  const std::string set = key.empty() ? "Set key" : "Set key (" + key + ")";
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  // Room for the longest text, so that nothing moves while the joint turns.
  const float reading = ImGui::CalcTextSize("-180.0\xc2\xb0").x;
  const float fixed = reading + buttonWidth(set.c_str()) + buttonWidth("Done") + 3.0f * gap + ui.px(20);
  const glm::vec4& v = ui.state.frame.viewport;
  const float left = ui.px(kBesideTools);
  const float top = ui.px(kDrivenKeyTop + (ui.state.document.rig().lines.empty() ? 0.0f : kBelowFlex));
  const float room = v.z - left - ui.px(kNumbers) - fixed;
  const std::string shown = fitted(text, std::max(room, ui.px(40)));
  const float width = fixed + ImGui::CalcTextSize(shown.c_str()).x;
  ImGui::PushStyleColor(ImGuiCol_Border, palette::kDriven);
  beginInPicture(ui, "driven-key", {left, top}, {width, ImGui::GetFrameHeight() + ui.px(8)}, 0.92f, {8, 4},
                 ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(shown.c_str());
  ui.widgets.note("driven-key/text");
  tooltip(ui, text +
                  "\nPose the joint or choose another moment, set the number in its field, and so on: each is a "
                  "point of the driver's curve.");
  ImGui::SameLine();
  const float from = ImGui::GetCursorPosX();
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kDriven);
  ImGui::TextUnformatted(now.c_str());
  ImGui::PopStyleColor();
  ui.widgets.note("driven-key/now");
  tooltip(ui, "The " + inputWords + " now");
  ImGui::SameLine(from + reading + gap);
  const bool wanted =
      textButton(ui, "driven-key/set", set.c_str(), {}, "Sets a key: at the current input, the current " + numberWords);
  ImGui::SameLine();
  const bool done = textButton(ui, "driven-key/done", "Done", {}, "Leave the driver as it is (Esc)");
  endInPicture();
  ImGui::PopStyleColor();
  if (wanted) keyPointed(ui.state);
  if (done) endDrivenKey(ui.state);
}

}  // namespace sinew::app
