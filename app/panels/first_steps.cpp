// app/panels/first_steps.cpp: the list of first steps, with instructions for the next one.

#include <algorithm>
#include <array>
#include <string>

#include "app/editor/session.h"
#include "app/panels/overlay.h"

namespace sinew::app {
namespace {

constexpr float kFirstStepsWidth = 256.0f;  // Design pixels, as all here.
constexpr float kFirstStepsMark = 22.0f;

struct StepText {
  const char* id;
  const char* what;
  std::string how;
};

std::array<StepText, kFirstSteps> textsOf(const PanelUi& ui) {
  const auto start = [&](const char* id) { return howToStart(ui, action(id)); };
  const auto capital = [](std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
  };
  return {{{"turn", "Turn the view", "Drag on empty space"},
           {"select", "Select a muscle", "Click the upper arm"},
           {"scale", "Make it thicker", capital(start("tool/scale")) + ", then drag a handle"},
           {"add", "Add a muscle", capital(start("tool/add-muscle")) + ", then draw on a thigh"},
           {"compare", "Look without muscles", capital(start("view/before")) + ", held down"}}};
}

/// A tick if the step is done, else a ring.
void drawMark(PanelUi& ui, bool done, bool next) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 middle{at.x + ui.px(7), at.y + 0.5f * ImGui::GetTextLineHeight()};
  if (!done) {
    list.AddCircle(middle, ui.px(5.5f), (next ? palette::kAccent : palette::kLine).packed(), 20, ui.px(1.5f));
    return;
  }
  const std::array tick{ImVec2{middle.x - ui.px(5), middle.y}, ImVec2{middle.x - ui.px(1), middle.y + ui.px(4)},
                        ImVec2{middle.x + ui.px(6), middle.y - ui.px(5)}};
  list.AddPolyline(tick.data(), static_cast<int>(tick.size()), palette::kGood.packed(), 0, ui.px(2));
}

/// A line for each step, and the instructions below the next one.
void drawSteps(PanelUi& ui) {
  const FirstStepsState& steps = ui.state.view.firstSteps;
  const auto next = std::ranges::find(steps.done, false) - steps.done.begin();
  const auto texts = textsOf(ui);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const bool isNext = static_cast<std::ptrdiff_t>(i) == next;
    drawMark(ui, steps.done[i], isNext);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.px(kFirstStepsMark));
    if (isNext) ImGui::TextUnformatted(texts[i].what);
    else mutedText(texts[i].what);
    ui.widgets.note(std::string("first-steps/") + texts[i].id);
    if (!isNext) continue;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.px(kFirstStepsMark));
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kAccent);
    ImGui::TextUnformatted(fitted(texts[i].how, ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopStyleColor();
    tooltip(ui, texts[i].how);
  }
}

}  // namespace

void drawFirstSteps(PanelUi& ui) {
  EditorState& state = ui.state;
  followFirstSteps(state);
  // One panel at a time.
  const bool hidden = state.open.check.shown || state.open.muscleSet.shown || state.open.bodyParts.shown ||
                      state.open.clipList.shown || state.open.reference.shown || state.open.sculptFit.shown;
  if (!state.view.firstSteps.shown || hidden || !state.hasCharacter()) return;
  const bool done = firstStepsDone(state.view.firstSteps);
  const float lines = 1.0f + (done ? 2.0f : static_cast<float>(kFirstSteps) + 1.0f);
  const float height = lines * ImGui::GetTextLineHeightWithSpacing() + ImGui::GetFrameHeightWithSpacing() + ui.px(20);
  const float width = widthInPicture(ui, kFirstStepsWidth);
  beginInPicture(ui, "first-steps", {ui.px(kBesideTools), std::max(lowestInPicture(ui) - height, 0.0f)},
                 {width, height}, 0.94f, {12, 10}, ImGuiWindowFlags_NoScrollbar);
  heading(ui, done ? "That was all" : "First steps");
  if (done) {
    mutedParagraph("Drop your own character on the window, or open one from the File menu.");
  } else {
    drawSteps(ui);
  }
  ImGui::Dummy({0.0f, ui.px(2)});
  if (textButton(ui, "first-steps/leave", done ? "Close" : "Leave")) state.view.firstSteps.shown = false;
  endInPicture();
}

}  // namespace sinew::app
