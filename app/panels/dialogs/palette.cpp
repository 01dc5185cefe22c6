// app/panels/dialogs/palette.cpp: Ctrl+P: everything that can be done or gone to, found by a few letters.

#include <imgui.h>
#include <imgui_stdlib.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "app/document/shown_names.h"
#include "app/editor/commands.h"
#include "app/editor/hidden_bones.h"
#include "app/editor/session.h"
#include "app/names/readable_names.h"
#include "app/panels/dialogs/dialogs.h"
#include "app/panels/dialogs/palette_search.h"
#include "app/panels/dialogs/palette_words.h"
#include "app/ui/reading_order.h"
#include "core/base/at.h"

namespace sinew::app {
namespace {

constexpr const char* kTitle = "palette";
constexpr float kWidth = 580.0f;  // Design pixels.
constexpr int kRows = 11;
constexpr std::size_t kMostFound = 200;

constexpr int kDocument = 3;  // What stands behind actions that fit as well.
constexpr int kFiles = 10;

enum class EntryKind { kAction, kPanel, kMuscle, kBone, kClip, kFile };

/// What choosing a row does.
struct Entry {
  EntryKind kind = EntryKind::kAction;
  std::string id;  ///< "file/save", "muscle/NAME", "bone/NAME", "clip/NAME", "panel/learn", "sample/0", "recent/0"
  const Action* action = nullptr;
  PrimitiveId muscle;
  int bone = -1;
  std::filesystem::path file;
  int place = -1;        ///< Of kPanel: into panelCommands(); of kClip: the clip, -1: the bind pose.
  std::string why = {};  ///< Why it cannot be done now; "" if it can.
};

struct Entries {
  std::vector<Entry> entries;
  std::vector<Candidate> candidates;  ///< The same rows.
};

int recentRank(const EditorState& state, const std::string& id) {
  const auto& recent = state.session.preferences.recentActions;
  const auto found = std::ranges::find(recent, id);
  return found == recent.end() ? -1 : static_cast<int>(found - recent.begin());
}

std::string otherWords(const Entry& entry) {
  if (entry.kind == EntryKind::kPanel) return panelCommands()[static_cast<std::size_t>(entry.place)].synonyms;
  return entry.kind == EntryKind::kClip ? "play animation" : std::string(synonymsOf(entry.id));
}

int laterOf(EntryKind kind) {
  if (kind == EntryKind::kFile) return kFiles;
  return kind == EntryKind::kAction || kind == EntryKind::kPanel ? 0 : kDocument;
}

void add(Entries& all, const EditorState& state, Entry entry, std::string label, std::string context) {
  const int recent = recentRank(state, entry.id);
  all.candidates.push_back(
      {std::move(label), std::move(context), recent, entry.why.empty(), otherWords(entry), laterOf(entry.kind)});
  all.entries.push_back(std::move(entry));
}

void addActions(Entries& all, const EditorState& state) {
  for (const Menu& menu : menus()) {
    for (const Action& item : actions()) {
      if (item.menu() != menu.id || std::string_view(item.id) == "help/palette") continue;
      add(all, state, {EntryKind::kAction, item.id, &item, {}, -1, {}, -1, item.enabled(state).reason()}, item.label,
          menu.title);
    }
  }
}

void addPanels(Entries& all, const EditorState& state) {
  const std::span<const PanelCommand> commands = panelCommands();
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const PanelCommand& command = commands[i];
    add(all, state,
        {EntryKind::kPanel, command.id, nullptr, {}, -1, {}, static_cast<int>(i), command.enabled(state).reason()},
        command.label, command.context);
  }
}

void addClips(Entries& all, const EditorState& state) {
  if (!state.hasCharacter()) return;
  const std::vector<std::string> names = shownClipNames(state.character());
  for (int clip = -1; clip < static_cast<int>(names.size()); ++clip) {
    const std::string name = clip < 0 ? "Bind pose" : at(names, clip);
    add(all, state, {EntryKind::kClip, "clip/" + name, nullptr, {}, -1, {}, clip}, name, "Clip");
  }
}

void addPlacesInDocument(Entries& all, const EditorState& state) {
  if (!state.hasCharacter()) return;
  const Rig& rig = state.document.rig();
  for (int i = 0; i < static_cast<int>(rig.primitives.size()); ++i) {
    const Primitive& primitive = at(rig.primitives, i);
    add(all, state, {EntryKind::kMuscle, "muscle/" + primitive.name, nullptr, primitive.id(), -1, {}},
        shownMuscleName(rig, i), "Muscle on " + primitive.bone);
  }
  const Skeleton& skeleton = state.character().skeleton;
  const std::vector<std::string> names = shownBoneNames(skeleton);
  const std::vector<bool> hidden = hiddenBones(state);
  for (int bone = 0; bone < static_cast<int>(skeleton.bones.size()); ++bone) {
    if (isHidden(hidden, bone)) continue;
    const auto index = static_cast<std::size_t>(bone);
    const std::string& fileName = skeleton.bones[index].name;
    add(all, state, {EntryKind::kBone, "bone/" + skeleton.fileName(bone), nullptr, {}, bone, {}}, names[index],
        names[index] == fileName ? "Bone" : "Bone " + fileName);
  }
}

void addFiles(Entries& all, const EditorState& state) {
  const std::vector<Sample> ours = samples();
  for (std::size_t i = 0; i < ours.size(); ++i) {
    add(all, state, {EntryKind::kFile, "sample/" + std::to_string(i), nullptr, {}, -1, ours[i].file}, ours[i].name,
        "Sample");
  }
  const auto& recent = state.session.preferences.recentFiles;
  for (std::size_t i = 0; i < recent.size(); ++i) {
    std::error_code failed;
    const bool there = std::filesystem::is_regular_file(recent[i], failed);
    add(all, state,
        {EntryKind::kFile,
         "recent/" + std::to_string(i),
         nullptr,
         {},
         -1,
         recent[i],
         -1,
         there ? "" : "No longer there"},
        recent[i].filename().string(), "Recent file in " + recent[i].parent_path().string());
  }
}

Entries gather(const EditorState& state) {
  Entries all;
  addActions(all, state);
  addPanels(all, state);
  addClips(all, state);
  addPlacesInDocument(all, state);
  addFiles(all, state);
  return all;
}

void choose(EditorState& state, const Entry& entry) {
  rememberAction(state.session.preferences.recentActions, entry.id);
  switch (entry.kind) {
    case EntryKind::kAction:
      run(*entry.action, state);
      break;
    case EntryKind::kPanel:
      panelCommands()[static_cast<std::size_t>(entry.place)].run(state);
      break;
    case EntryKind::kClip:
      chooseClip(state.open.transport, entry.place, state.character());
      break;
    case EntryKind::kMuscle:
      jumpToMuscle(state, entry.muscle);
      break;
    case EntryKind::kBone:
      jumpToBone(state, entry.bone);
      break;
    case EntryKind::kFile:
      request(state, {IntentKind::kOpenFile, entry.file});
      break;
  }
}

Icon iconOf(const Entry& entry) {
  switch (entry.kind) {
    case EntryKind::kMuscle:
      return Icon::kMuscle;
    case EntryKind::kBone:
      return Icon::kBone;
    case EntryKind::kFile:
      return Icon::kFile;
    case EntryKind::kClip:
      return Icon::kPlay;
    case EntryKind::kAction:
    case EntryKind::kPanel:
      break;
  }
  return Icon::kNone;
}

/// The label, letters that were asked for in the accent's color.
void drawMarked(ImDrawList& list, ImVec2 at, const std::string& text, const std::vector<std::size_t>& marks,
                Tint tint) {
  const std::string whole = inReadingOrder(text);
  if (whole != text) {  // Its letters stand in another order than its bytes.
    list.AddText(at, tint.packed(), whole.c_str());
    return;
  }
  std::size_t begin = 0;
  while (begin < text.size()) {
    const bool marked = std::ranges::binary_search(marks, begin);
    std::size_t end = begin + 1;
    while (end < text.size() && std::ranges::binary_search(marks, end) == marked) ++end;
    const char* first = text.c_str() + begin;
    const char* last = text.c_str() + end;
    list.AddText(at, (marked ? palette::kAccent : tint).packed(), first, last);
    at.x += ImGui::CalcTextSize(first, last).x;
    begin = end;
  }
}

/// @return whether it was clicked.
bool drawRow(PanelUi& ui, const Entry& entry, const Candidate& candidate, const Found& found, bool chosen,
             float height) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::PushID(entry.id.c_str());
  const bool clicked = ImGui::Selectable("##row", chosen, ImGuiSelectableFlags_DontClosePopups, {0.0f, height});
  ImGui::PopID();
  ui.widgets.note("palette/" + entry.id);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float middle = corner.y + 0.5f * (height - ImGui::GetTextLineHeight());
  drawIcon(list, iconOf(entry), {corner.x + ui.px(6), corner.y + 0.5f * (height - ui.px(14))}, ui.px(14),
           palette::kMuted.packed());
  drawMarked(list, {corner.x + ui.px(30), middle}, candidate.label, found.marks,
             candidate.usable ? palette::kText : palette::kMuted.faded(0.6f));
  const float right = corner.x + ImGui::GetContentRegionAvail().x - ui.px(8);
  // Where something cannot be done, the reason is worth more than the keys.
  const bool usable = candidate.usable;
  const std::string keys = usable && entry.action != nullptr ? keyText(*entry.action, ui.state) : entry.why;
  const float keysWidth = keys.empty() ? 0.0f : ImGui::CalcTextSize(keys.c_str()).x;
  list.AddText({right - keysWidth, middle}, (usable ? palette::kText : palette::kMuted).packed(), keys.c_str());
  const float contextLeft =
      corner.x + ui.px(30) + ImGui::CalcTextSize(inReadingOrder(candidate.label).c_str()).x + ui.px(12);
  list.PushClipRect({contextLeft, corner.y}, {right - keysWidth - ui.px(12), corner.y + height}, true);
  list.AddText({contextLeft, middle}, palette::kMuted.faded(0.8f).packed(), inReadingOrder(candidate.context).c_str());
  list.PopClipRect();
  return clicked;
}

/// Up, Down and the pages move the choice. @param chosen  -1: none. @return where it is now
int movedChoice(int chosen, int count) {
  if (count == 0) return -1;
  if (ImGui::IsKeyPressed(GLFW_KEY_DOWN)) return (chosen + 1) % count;
  if (ImGui::IsKeyPressed(GLFW_KEY_UP)) return chosen <= 0 ? count - 1 : chosen - 1;
  if (ImGui::IsKeyPressed(GLFW_KEY_PAGE_DOWN)) return std::min(chosen + kRows, count - 1);
  if (ImGui::IsKeyPressed(GLFW_KEY_PAGE_UP)) return std::max(chosen - kRows, 0);
  return chosen;
}

/// @return the row to take, or -1.
int drawFound(PanelUi& ui, const Entries& all, const std::vector<Found>& found, int lit, bool moved) {
  int taken = -1;
  const float height = ImGui::GetTextLineHeight() + ui.px(10);
  const int rows = std::clamp(static_cast<int>(found.size()), 1, kRows);
  ImGui::BeginChild("found", {0.0f, static_cast<float>(rows) * height});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, 0.0f});
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::size_t index = found[i].index;
    const bool chosen = static_cast<int>(i) == lit;
    if (drawRow(ui, all.entries[index], all.candidates[index], found[i], chosen, height)) taken = static_cast<int>(i);
    if (chosen && moved && !ImGui::IsItemVisible()) ImGui::SetScrollHereY(0.5f);
  }
  if (found.empty()) {
    ImGui::SetCursorPos({ui.px(30), ui.px(8)});
    mutedText("Nothing found.");
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
  return taken;
}

void drawContents(PanelUi& ui) {
  PaletteState& palette = ui.state.dialogs.palette;
  if (palette.appearing) ImGui::SetKeyboardFocusHere();
  palette.appearing = false;
  ImGui::SetNextItemWidth(-1.0f);
  const bool entered =
      ImGui::InputTextWithHint("##query", "Actions, buttons, muscles, bones, clips, samples, recent files",
                               &palette.query, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.widgets.note("palette/query");
  if (ImGui::IsItemEdited()) palette.chosen = -1;
  const Entries all = gather(ui.state);
  const std::vector<Found> found = search(palette.query, all.candidates, kMostFound);
  const int count = static_cast<int>(found.size());
  const int before = palette.chosen >= 0 ? std::min(palette.chosen, count - 1) : preselected(found, all.candidates);
  const int lit = movedChoice(before, count);
  if (lit != before) palette.chosen = lit;
  int taken = drawFound(ui, all, found, lit, lit != before);
  if (entered) taken = lit;
  const bool usable = taken >= 0 && all.candidates[at(found, taken).index].usable;
  if (usable || ImGui::IsKeyPressed(GLFW_KEY_ESCAPE, false)) {
    ui.state.dialogs.palette = {};
    ImGui::CloseCurrentPopup();
  } else if (entered || taken >= 0) {
    palette.appearing = true;  // What cannot be done now leaves the palette as it is.
  }
  if (usable) choose(ui.state, all.entries[at(found, taken).index]);
}

}  // namespace

void drawPalette(PanelUi& ui) {
  if (!ui.state.dialogs.palette.shown) return;
  if (ui.state.dialogs.palette.appearing && !ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float width = std::min(ui.px(kWidth), display.x - ui.px(20));
  ImGui::SetNextWindowPos({0.5f * display.x, 0.14f * display.y}, ImGuiCond_Always, {0.5f, 0.0f});
  ImGui::SetNextWindowSize({width, 0.0f});
  pushDialogStyle(ui);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(10)});
  const bool open = ImGui::BeginPopup(kTitle, ImGuiWindowFlags_NoMove);
  if (open) {
    drawContents(ui);
    ImGui::EndPopup();
  } else {
    ui.state.dialogs.palette = {};  // A click beside it.
  }
  ImGui::PopStyleVar();
  popDialogStyle();
}

}  // namespace sinew::app
