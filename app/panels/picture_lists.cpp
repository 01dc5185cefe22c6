// app/panels/picture_lists.cpp: lists over the picture: files of added clips, and findings of Play > Check muscles.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "app/editor/clip_commands.h"
#include "app/editor/muscle_set_commands.h"
#include "app/panels/overlay.h"
#include "app/ui/code_points.h"
#include "app/ui/reading_order.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

constexpr float kClipListWidth = 440.0f;  // Design pixels, as all here.
constexpr float kHighest = 0.45f;         // Of the picture.
constexpr float kClipListIndent = 22.0f;
constexpr float kIconSize = 15.0f;
constexpr float kAnswerWidth = 84.0f;

/// A line below a file's name.
struct Line {
  std::string text;
  Icon icon = Icon::kNone;
  Tint tint = palette::kMuted;
};

std::string clipText(const AnimationClip& clip) {
  char length[32];
  std::snprintf(length, sizeof length, " (%.2f s)", static_cast<double>(clip.duration));
  return clip.name + length;
}

std::vector<Line> linesOf(const EditorState& state, const ClipFileReport& file) {
  std::vector<Line> lines;
  if (file.missing) {
    lines.push_back({file.missing->reason, Icon::kWarning, palette::kWarning});
    return lines;
  }
  std::string clips;
  for (const AnimationClip& clip : state.character().clips) {
    if (clip.addedFrom == file.file) clips += (clips.empty() ? "" : ", ") + clipText(clip);
  }
  lines.push_back({clips.empty() ? "No clips" : clips});
  if (state.open.clipList.changed.contains(file.file)) {
    lines.push_back({"Changed on disk since it was read", Icon::kWarning, palette::kWarning});
  }
  for (const std::string& note : file.notes) lines.push_back({note, Icon::kNote, palette::kMuted});
  return lines;
}

float textRoom(const PanelUi& ui, float width) { return width - ui.px(2.0f * kClipListIndent + 16); }

float heightOf(const Line& line, float room) {
  return ImGui::CalcTextSize(line.text.c_str(), nullptr, false, room).y + ImGui::GetStyle().ItemSpacing.y;
}

float heightOf(const PanelUi& ui, const ClipFileReport& file, float width) {
  float height = ImGui::GetFrameHeightWithSpacing() + ui.px(4);
  for (const Line& line : linesOf(ui.state, file)) height += heightOf(line, textRoom(ui, width));
  return height;
}

void drawLine(const PanelUi& ui, const Line& line, float room) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  if (line.icon != Icon::kNone) {
    drawIcon(*ImGui::GetWindowDrawList(), line.icon, {corner.x, corner.y + ui.px(1)}, ui.px(kIconSize),
             line.tint.packed());
  }
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.px(kClipListIndent));
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + room);
  ImGui::PushStyleColor(ImGuiCol_Text, line.icon == Icon::kNone ? palette::kText : line.tint);
  ImGui::TextUnformatted(inReadingOrder(line.text).c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
}

/// The buttons that were pressed; indices into Rig::clipFiles, -1: none.
struct Wanted {
  int remove = -1;
  int locate = -1;
  bool read = false;
};

/// A button for a file that is missing or has changed. @return whether it was clicked
bool answerButton(PanelUi& ui, const std::string& id, const char* label, const char* hint) {
  const bool clicked = textButton(ui, id, (std::string(label) + "##" + id).c_str(), {ui.px(kAnswerWidth), 0.0f}, hint);
  ImGui::SameLine(0.0f, ui.px(4));
  return clicked;
}

void drawFile(PanelUi& ui, int index, float width, Wanted& wanted) {
  const ClipFileReport& file = at(ui.state.document.clipFiles.files, index);
  const std::string place = std::to_string(index);
  const std::string name = file.path.filename().string();
  const float button = ImGui::GetFrameHeight();
  const bool changed = ui.state.open.clipList.changed.contains(file.file);
  const float buttons = button + (changed || file.missing ? ui.px(kAnswerWidth + 4) : 0.0f);
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(ui.fonts.strong);
  ImGui::TextUnformatted(fitted(name, ImGui::GetContentRegionAvail().x - buttons - ui.px(8)).c_str());
  ImGui::PopFont();
  ui.widgets.note("clip-files/file/" + place);
  tooltip(ui, file.path.string());
  ImGui::SameLine(ImGui::GetContentRegionMax().x - buttons);
  if (changed) {
    wanted.read |= answerButton(ui, "clip-files/read/" + place, "Read again", "Load what other programs have written");
  } else if (file.missing && answerButton(ui, "clip-files/locate/" + place, "Locate...", "Say where the file is now")) {
    wanted.locate = index;
  }
  if (iconButton(ui, "clip-files/remove/" + place, Icon::kClose, false, button)) wanted.remove = index;
  tooltip(ui, "Remove " + name + " and its clips; keys that were made in them are kept");
  for (const Line& line : linesOf(ui.state, file)) drawLine(ui, line, textRoom(ui, width));
  ImGui::Dummy({0.0f, ui.px(4) - ImGui::GetStyle().ItemSpacing.y});
}

void drawFiles(PanelUi& ui, float width) {
  Wanted wanted;
  const int count = static_cast<int>(ui.state.document.clipFiles.files.size());
  for (int i = 0; i < count; ++i) drawFile(ui, i, width, wanted);
  if (count == 0) {
    mutedParagraph(
        "None yet. The clips of a .glb, .gltf or .vrm file can be added, with the same bones or with others.");
  }
  if (wanted.locate >= 0) showLocateClipsDialog(ui.state, wanted.locate);
  if (wanted.read) run(action("play/read-clip-files"), ui.state);
  if (wanted.remove >= 0) removeClipFile(ui.state, wanted.remove);
}

float listHeight(const PanelUi& ui, float width) {
  const std::vector<ClipFileReport>& files = ui.state.document.clipFiles.files;
  if (files.empty()) return 2.0f * ImGui::GetTextLineHeightWithSpacing() + ui.px(4);
  float height = ui.px(4);
  for (const ClipFileReport& file : files) height += heightOf(ui, file, width);
  return height;
}

}  // namespace

void drawClipList(PanelUi& ui) {
  EditorState& state = ui.state;
  if (!state.open.clipList.shown) return;
  const glm::vec4& v = state.frame.viewport;
  const float width = widthInPicture(ui, kClipListWidth);
  const float frame = ImGui::GetTextLineHeightWithSpacing() + ImGui::GetFrameHeightWithSpacing() + ui.px(18);
  const float height = std::min(listHeight(ui, width - ui.px(20)) + frame, kHighest * v.w);
  beginInPicture(ui, "clip-files", {ui.px(kBesideTools), std::max(lowestInPicture(ui) - height, 0.0f)}, {width, height},
                 0.97f, {10, 8});
  ImGui::TextUnformatted("Clips from other files");
  ui.widgets.note("clip-files/heading");
  ImGui::BeginChild("files", {0.0f, -ImGui::GetFrameHeightWithSpacing()});
  drawFiles(ui, ImGui::GetContentRegionAvail().x);
  ImGui::EndChild();
  const bool adds = textButton(ui, "clip-files/add", "Add clips...");
  ImGui::SameLine();
  if (textButton(ui, "clip-files/close", "Close")) state.open.clipList.shown = false;
  endInPicture();
  if (adds) run(action("file/add-clips"), state);
}

// The findings of Play > Check muscles; a click shows one.

namespace {

constexpr float kCheckListWidth = 560.0f;  // Design pixels, as all here.
constexpr int kMostRows = 6;

std::string momentText(const Finding& finding) {
  if (finding.clip.empty()) return "bind pose";
  char time[32];
  std::snprintf(time, sizeof time, " %.2f s", static_cast<double>(finding.time));
  return finding.clip + time;
}

std::string headingOf(const EditorState& state) {
  const std::size_t count = state.open.check.findings.size();
  if (!checkIsCurrent(state)) return "The rig has changed since it was checked";
  if (count == 0) return "All muscles stay in the flesh in all clips";
  return std::to_string(count) + (count == 1 ? " finding" : " findings") + ": click one to see it";
}

void drawRow(PanelUi& ui, int index) {
  EditorState& state = ui.state;
  const CheckState& check = state.open.check;
  const Finding& finding = at(check.findings, index);
  const int muscle = findPrimitive(state.document.rig(), at(check.muscles, index));
  const std::string name = muscle < 0 ? "(deleted)" : shownMuscleName(state.document.rig(), muscle);
  const std::string text = name + ": " + textOf(finding);
  const std::string when = momentText(finding);
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(when.c_str()).x - ui.px(16);
  ImGui::PushID(index);
  const bool chosen = ImGui::Selectable(fitted(text, room).c_str(), check.chosen == index,
                                        muscle < 0 ? ImGuiSelectableFlags_Disabled : ImGuiSelectableFlags_None);
  ImGui::PopID();
  ui.widgets.note("check/" + std::to_string(index));
  tooltip(ui, text + "\n" + when);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(when.c_str()).x);
  mutedText(when.c_str());
  if (chosen && muscle >= 0) goToFinding(state, index);
}

}  // namespace

void drawCheckList(PanelUi& ui) {
  EditorState& state = ui.state;
  if (!state.open.check.shown) return;
  const float width = widthInPicture(ui, kCheckListWidth);
  const auto rows = static_cast<float>(std::clamp(static_cast<int>(state.open.check.findings.size()), 0, kMostRows));
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const float height = rows * line + 2.0f * ImGui::GetFrameHeightWithSpacing() + ui.px(20);
  const float top = lowestInPicture(ui) - height;
  beginInPicture(ui, "check", {ui.px(kBesideTools), std::max(top, 0.0f)}, {width, height}, 0.94f, {10, 8});
  ImGui::TextUnformatted(headingOf(state).c_str());
  ui.widgets.note("check/heading");
  ImGui::BeginChild("rows", {0.0f, -ImGui::GetFrameHeightWithSpacing()});
  for (int i = 0; i < static_cast<int>(state.open.check.findings.size()); ++i) drawRow(ui, i);
  ImGui::EndChild();
  const bool current = checkIsCurrent(state);
  ImGui::BeginDisabled(current && state.open.check.findings.empty());
  const bool wanted = ImGui::Button(current ? "Mend" : "Check again");
  ImGui::EndDisabled();
  ui.widgets.note("check/mend");
  tooltip(ui, current
                  ? "Change the lines of these muscles until they stay in the flesh: pivot, via point, tendons, flex"
                  : "Look through all clips again");
  ImGui::SameLine();
  const bool closed = textButton(ui, "check/close", "Close");
  endInPicture();
  if (wanted) mendFindings(state);
  if (closed) closeCheck(state);
}

}  // namespace sinew::app
