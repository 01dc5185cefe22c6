// app/panels/library.cpp: the tab Library: sets of muscles for this body, with a picture of each muscle.

#include <imgui_internal.h>  // ClearActiveID, which 1.86 keeps to itself.
#include <imgui_stdlib.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "app/document/muscle_sets.h"
#include "app/editor/muscle_set_commands.h"
#include "app/editor/outliner.h"
#include "app/panels/muscle_picture.h"
#include "app/panels/panels.h"
#include "app/ui/reading_order.h"
#include "app/viewport/render/thumbnails.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

const Control kFindSets{"library/search", "Search the library", "find presets sets"};

constexpr float kLibraryGap = 6.0f;  // Design pixels, as all here.
constexpr float kRound = 4.0f;
constexpr float kCarried = 104.0f;       ///< Width of the picture beside the pointer.
constexpr float kShownOfPeople = 0.36f;  ///< Of H.
constexpr float kShownOfAnimals = 0.8f;
constexpr float kLibraryFold = 14.0f;
constexpr int kColumns = 2;

/// The muscle on this body: the left one, then its twin. Empty: it does not fit.
std::vector<Primitive> laidOf(const LibraryState& library, int set, const std::string& name) {
  const auto& primitives = at(library.laid, set).rig.primitives;
  std::vector<Primitive> found;
  for (const std::string& each : {name, name + " L", name + " R"}) {
    const auto laid = std::ranges::find(primitives, each, &Primitive::name);
    if (laid != primitives.end()) found.push_back(*laid);
  }
  return found;
}

std::string whyLeftOut(const LibraryState& library, int set, const std::string& name) {
  const auto& leftOut = at(library.laid, set).leftOut;
  const auto found = std::ranges::find(leftOut, name, &FittedPreset::LeftOut::name);
  return found == leftOut.end() ? "" : found->why;
}

ImTextureID pictureOf(PanelUi& ui, int set, int muscle) {
  Thumbnails* const thumbnails = ui.state.session.thumbnails;
  if (thumbnails == nullptr) return nullptr;
  const LibraryState& library = ui.state.open.library;
  const Preset& own = at(library.sets, set);
  const std::string key = std::to_string(ui.state.session.documentsOpened) + '/' + std::to_string(library.reads) + '/' +
                          own.name + '/' + std::to_string(muscle);
  const std::uintptr_t texture = thumbnails->texture(key, [&] {
    return musclePicture(ui.state.character(), laidOf(library, set, at(own.muscles, muscle).name),
                         own.body == BodyKind::kQuadruped ? kShownOfAnimals : kShownOfPeople);
  });
  return reinterpret_cast<ImTextureID>(texture);
}

void drawPicture(ImDrawList& list, ImTextureID picture, const ImVec2& low, const ImVec2& high, float round) {
  list.AddRectFilled(low, high, palette::kBackground.packed(), round);
  if (picture != nullptr) list.AddImageRounded(picture, low, high, {0, 0}, {1, 1}, IM_COL32_WHITE, round);
}

float pictureHeight(float width) {
  return width * static_cast<float>(kMusclePicture.y) / static_cast<float>(kMusclePicture.x);
}

/// A click adds the muscle where it belongs; it can also be dragged into the picture.
void drawTile(PanelUi& ui, int set, int muscle, float width) {
  EditorState& state = ui.state;
  LibraryState& library = state.open.library;
  const Preset& own = at(library.sets, set);
  const std::string& name = at(own.muscles, muscle).name;
  const std::string why = whyLeftOut(library, set, name);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float high = pictureHeight(width);
  ImGui::PushID(muscle);
  const bool pressed = ImGui::InvisibleButton("##tile", {width, high + ImGui::GetTextLineHeight() + ui.px(4)});
  ImGui::PopID();
  ui.widgets.note("library/" + own.name + '/' + name);
  if (!ImGui::IsItemVisible()) return;
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 corner{low.x + width, low.y + high};
  drawPicture(list, why.empty() ? pictureOf(ui, set, muscle) : nullptr, low, corner, ui.px(kRound));
  if (hovered) list.AddRect(low, corner, palette::kAccent.packed(), ui.px(kRound), 0, ui.px(1.5f));
  const Tint color = !why.empty() ? palette::kMuted.faded(0.6f) : hovered ? palette::kText : palette::kMuted;
  clippedText(list, {low.x + ui.px(2), corner.y + ui.px(2)}, width - ui.px(4), color.packed(), name);
  if (!why.empty()) return tooltip(ui, name + " has no place here: " + why);
  tooltip(ui, name + ": click to add it where it belongs, or drag it onto the character");
  const bool dragging = ImGui::IsItemActive() && ImGui::IsMouseDragging(0);
  if (dragging && library.drag.set < 0) takeFromLibrary(state, set, muscle);
  else if (pressed && library.drag.set < 0) layFromLibrary(state, set, muscle);
}

void drawSetMenu(PanelUi& ui, int set, std::optional<int>& removed) {
  const Preset& own = at(ui.state.open.library.sets, set);
  if (!ImGui::BeginPopupContextItem("##menu")) return;
  const bool mine = isOwnSet(own.name);
  if (ImGui::MenuItem("Remove set", nullptr, false, mine)) removed = set;
  ui.widgets.note("library/remove/" + own.name);
  if (!mine) tooltip(ui, "It comes with the program");
  ImGui::EndPopup();
}

/// @return whether the set is unfolded
bool drawHeader(PanelUi& ui, int set, std::optional<int>& removed) {
  LibraryState& library = ui.state.open.library;
  const Preset& own = at(library.sets, set);
  const bool folded = library.folded.contains(own.name);
  const float height = ImGui::GetFrameHeight();
  const float button = buttonWidth("Add all");
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x - button - ui.px(kLibraryGap);
  const bool pressed = ImGui::InvisibleButton("##header", {width, height});
  ui.widgets.note("library/" + own.name);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool hovered = ImGui::IsItemHovered();
  drawSetMenu(ui, set, removed);
  if (pressed && folded) library.folded.erase(own.name);
  if (pressed && !folded) library.folded.insert(own.name);
  drawIcon(list, folded ? Icon::kFoldClosed : Icon::kFoldOpen, {low.x, low.y + 0.5f * (height - ui.px(kLibraryFold))},
           ui.px(kLibraryFold), palette::kText.packed());
  const std::string count = std::to_string(own.muscles.size());
  const float counted = ImGui::CalcTextSize(count.c_str()).x + ui.px(2.0f * kLibraryGap);
  const float y = low.y + ImGui::GetStyle().FramePadding.y;
  ImGui::PushFont(ui.fonts.strong);
  const float title = std::min(ImGui::CalcTextSize(own.title.c_str()).x, width - ui.px(18) - counted);
  clippedText(list, {low.x + ui.px(18), y}, title, (hovered ? palette::kText : palette::kText.faded(0.85f)).packed(),
              own.title);
  ImGui::PopFont();
  list.AddText({low.x + ui.px(18 + kLibraryGap) + title, y}, palette::kMuted.packed(), count.c_str());
  ImGui::SameLine(0.0f, ui.px(kLibraryGap));
  if (textButton(ui, "library/add/" + own.name, "Add all", {}, "Add the whole set, with its sliders"))
    addMuscleSetNamed(ui.state, own.name);
  return !folded;
}

void drawTiles(PanelUi& ui, int set) {
  const LibraryState& library = ui.state.open.library;
  const float width = (ImGui::GetContentRegionAvail().x - (kColumns - 1) * ui.px(kLibraryGap)) / kColumns;
  int shown = 0;
  for (int i = 0; i < static_cast<int>(at(library.sets, set).muscles.size()); ++i) {
    const PresetMuscle& muscle = at(at(library.sets, set).muscles, i);
    if (!containsText(muscle.name, library.search) && !containsText(muscle.group, library.search)) continue;
    if (shown++ % kColumns != 0) ImGui::SameLine(0.0f, ui.px(kLibraryGap));
    drawTile(ui, set, i, width);
  }
  if (shown == 0) mutedText("No muscle of that name");
}

void drawNaming(PanelUi& ui) {
  LibraryState& library = ui.state.open.library;
  if (std::exchange(library.appearing, false)) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1.0f);
  const bool entered =
      ImGui::InputTextWithHint("##name", "Name of the set", &library.name, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.widgets.note("library/name");
  if (ImGui::IsItemEdited()) library.replacing = false;
  if (!library.notice.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
    ImGui::TextWrapped("%s", library.notice.c_str());
    ImGui::PopStyleColor();
  }
  const bool save = textButton(ui, "library/save", "Save");
  ImGui::SameLine();
  const bool cancel = textButton(ui, "library/cancel", "Cancel");
  if (cancel || escapePressed(ui)) library.naming = false;
  else if (save || entered) saveNewSet(ui.state);
}

void drawTop(PanelUi& ui) {
  LibraryState& library = ui.state.open.library;
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputTextWithHint("##search", kFindSets.label, &library.search);
  ui.widgets.note(kFindSets.id);
  if (library.naming) return drawNaming(ui);
  const Action& save = app::action("muscles/save-set");
  const Possible possible = save.enabled(ui.state);
  ImGui::BeginDisabled(!possible);
  if (ImGui::Button("Save selected muscles as a set", {-1.0f, 0.0f})) nameNewSet(ui.state);
  ImGui::EndDisabled();
  ui.widgets.note("library/save-set");
  tooltip(ui, tooltipOf(ui, save));
}

void drawWhy(PanelUi& ui) {
  mutedParagraph(ui.state.open.library.why);
  if (ImGui::Button("Parts of the body") && !ui.state.open.bodyParts.shown) toggleBodyParts(ui.state);
  ui.widgets.note("library/body-parts");
}

/// The dragged muscle beside the pointer, and the effect of dropping it.
void drawCarried(PanelUi& ui) {
  LibraryState& library = ui.state.open.library;
  if (library.drag.set < 0) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (ImGui::IsKeyPressed(GLFW_KEY_ESCAPE, false)) {
    ImGui::ClearActiveID();  // The button is still down.
    return leaveInLibrary(ui.state);
  }
  if (!ImGui::IsMouseDown(0)) return dropFromLibrary(ui.state, {mouse.x, mouse.y});
  carryFromLibrary(ui.state, {mouse.x, mouse.y});
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  const float width = ui.px(kCarried);
  const float pad = ui.px(kLibraryGap);
  const std::string says = inReadingOrder(library.drag.says);
  const ImVec2 text = ImGui::CalcTextSize(says.c_str());
  const ImVec2 low{mouse.x + ui.px(14), mouse.y + ui.px(14)};
  const ImVec2 size{std::max(width, text.x) + 2.0f * pad, pictureHeight(width) + text.y + 3.0f * pad};
  list.AddRectFilled(low, {low.x + size.x, low.y + size.y}, palette::kPanel.faded(0.94f).packed(), ui.px(kRound));
  const ImVec2 picture{low.x + pad, low.y + pad};
  drawPicture(list, pictureOf(ui, library.drag.set, library.drag.muscle), picture,
              {picture.x + width, picture.y + pictureHeight(width)}, ui.px(kRound));
  list.AddText({low.x + pad, low.y + 2.0f * pad + pictureHeight(width)}, palette::kText.packed(), says.c_str());
}

}  // namespace

void drawLibrary(PanelUi& ui) {
  EditorState& state = ui.state;
  if (!state.hasCharacter()) return;
  readLibrary(state);
  drawTop(ui);
  std::optional<int> removed;
  ImGui::BeginChild("library-sets");
  if (state.open.library.sets.empty()) drawWhy(ui);
  for (int set = 0; set < static_cast<int>(state.open.library.sets.size()); ++set) {
    ImGui::PushID(set);
    if (drawHeader(ui, set, removed)) drawTiles(ui, set);
    ImGui::PopID();
  }
  ImGui::EndChild();
  drawCarried(ui);
  if (removed) removeSetFromLibrary(state, *removed);
}

}  // namespace sinew::app
