// app/panels/inspector_line.cpp: the lines that carry the muscles: ends, lengths, via points.

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "app/document/shown_names.h"
#include "app/panels/inspector.h"
#include "app/viewport/tools/line_handles.h"
#include "core/geometry/at.h"
#include "core/rig/line_pose.h"

namespace sinew::app {
namespace {

Possible rigidMuscle(const EditorState& state) {
  return withMuscle(state).also(selectedLines(state.document).indices.empty(), "The muscle rides a line");
}

const Control kLength{"inspector/line/length", "Length", "of the muscle line stretch now range", withLine};
const Control kOtherEnd{"inspector/other-end", "Other end", "attach bone line insertion stretch", rigidMuscle,
                        "inspector/shape"};

/// The line's lengths in the current clip; null in the bind pose. Not updated during a drag: long clips take a while.
const LineLengths* rangeInClip(PanelUi& ui, const MuscleLine& line) {
  EditorState& state = ui.state;
  LineRangeState& known = state.open.lineRange;
  const int clip = state.open.transport.clip;
  if (clip < 0) return nullptr;
  const bool same = known.line == line && known.clip == clip;
  if (!same && !state.document.commands.inGesture()) {
    const Result<LineRest> rest = lineRest(line, state.character());
    if (!rest) return nullptr;
    const AnimationClip& shown = at(state.character().clips, clip);
    known = {line, clip, lengthsOver(rest.value(), state.character(), {&shown, 1})};
  }
  return known.clip == clip && known.lengths.poses > 0 ? &known.lengths : nullptr;
}

/// Lines whose bones this character has; the active one first.
std::vector<int> usableLines(PanelUi& ui, const SelectedLines& lines) {
  const PosedRig& posed = ui.state.document.posedRig(ui.state.live->pose());
  std::vector<int> usable;
  for (const int line : lines.indices) {
    if (!at(posed.lines, line).usable) continue;
    usable.insert(line == lines.active ? usable.begin() : usable.end(), line);
  }
  return usable;
}

std::string linePercent(float fraction) {
  return std::to_string(static_cast<int>(std::lround(100.0f * fraction))) + " %";
}

/// "74 %", or "62 % to 80 %"
std::string span(float least, float most) {
  const std::string from = linePercent(least);
  const std::string to = linePercent(most);
  return from == to ? from : from + " to " + to;
}

/// Maps lengths from 0.5 to 1.5 rest lengths to pixels.
struct LengthScale {
  ImVec2 corner;
  float width;
  float height;

  [[nodiscard]] float x(float stretch) const {
    constexpr float kLeast = 0.5f;
    constexpr float kMost = 1.5f;
    return corner.x + width * std::clamp((stretch - kLeast) / (kMost - kLeast), 0.0f, 1.0f);
  }
  [[nodiscard]] float right() const { return corner.x + width; }
  [[nodiscard]] float bottom() const { return corner.y + height; }
};

/// The underlined interval is where shortening activates the muscle; ticks show the lines now.
void drawLengths(PanelUi& ui, const LengthScale& scale, const std::vector<int>& lines, const LineLengths* range) {
  const EditorState& state = ui.state;
  const std::vector<PosedLine>& posed = state.document.posedRig(state.live->pose()).lines;
  const PosedLine& active = at(posed, lines.front());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float round = ImGui::GetStyle().FrameRounding;
  const ImVec2 low = scale.corner;
  const ImVec2 high{scale.right(), scale.bottom()};
  list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), round);
  // Redder means more active.
  list.AddRectFilled(low, high, palette::kAccent.faded(0.45f * active.activation).packed(), round);
  if (range) {
    list.AddRectFilled({scale.x(range->least), low.y + ui.px(4)}, {scale.x(range->most), low.y + ui.px(7)},
                       palette::kText.faded(0.55f).packed(), ui.px(1));
  }
  const float full = at(state.document.rig().lines, lines.front()).settings.full;
  list.AddRectFilled({scale.x(full), high.y - ui.px(5)}, {scale.x(1.0f), high.y - ui.px(2)},
                     palette::kAccent.faded(0.55f).packed(), ui.px(1));
  list.AddLine({scale.x(1.0f), low.y + ui.px(3)}, {scale.x(1.0f), high.y - ui.px(2)}, palette::kMuted.packed(), 1.0f);
  for (const int line : lines) {
    const float x = scale.x(at(posed, line).stretch);
    const Tint tint = line == lines.front() ? palette::kAccent : palette::kText.faded(0.6f);
    list.AddLine({x, low.y}, {x, high.y}, tint.packed(), ui.px(2));
  }
}

void lengthBar(PanelUi& ui, const std::vector<int>& lines) {
  beginRow(ui, kLength);
  const LengthScale scale{ImGui::GetCursorScreenPos(), ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight()};
  ImGui::InvisibleButton("##length", {scale.width, scale.height});
  ui.widgets.note(kLength.id);
  const EditorState& state = ui.state;
  const bool several = lines.size() > 1;
  const LineLengths* range = several ? nullptr : rangeInClip(ui, at(state.document.rig().lines, lines.front()));
  drawLengths(ui, scale, lines, range);
  const std::vector<PosedLine>& posed = state.document.posedRig(state.live->pose()).lines;
  const auto stretch = [&](int line) { return at(posed, line).stretch; };
  const float least = stretch(std::ranges::min(lines, {}, stretch));
  const float most = stretch(std::ranges::max(lines, {}, stretch));
  const std::string text = span(least, most);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const bool right = scale.x(stretch(lines.front())) < scale.corner.x + 0.5f * scale.width;
  ImGui::GetWindowDrawList()->AddText({right ? scale.right() - size.x - ui.px(6) : scale.corner.x + ui.px(6),
                                       scale.corner.y + 0.5f * (scale.height - size.y)},
                                      palette::kText.packed(), text.c_str());
  std::string hint = several ? "The lines' lengths in this pose, in per cent of their rest lengths."
                             : "The line's length in this pose, in per cent of its rest length. Active: " +
                                   linePercent(at(posed, lines.front()).activation) + ".";
  hint += "\nGrey: rest. Underlined: from rest to full contraction, where shortening activates the muscle.";
  if (range) hint += "\nAbove: its lengths in this clip, " + span(range->least, range->most) + ".";
  tooltip(ui, hint);
}

bool smallButton(PanelUi& ui, const char* label, const char* id, const char* hint, float width) {
  const bool pressed = textButton(ui, std::string("inspector/line/") + id, label, {width, 0.0f}, hint);
  return pressed;
}

void lengthButtons(PanelUi& ui) {
  EditorState& state = ui.state;
  beginRow(ui, "Set");
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 2.0f * gap) / 3.0f;
  if (smallButton(ui, "Rest", "rest-now", "Rest = now: the length in this pose becomes the rest length", width)) {
    setRestToNow(state);
  }
  ImGui::SameLine(0.0f, gap);
  if (smallButton(ui, "Full", "full-now",
                  "Full = now: at the length in this pose the muscle is fully contracted. Bend the joint first",
                  width)) {
    setFullContractionToNow(state);
  }
  ImGui::SameLine(0.0f, gap);
  if (smallButton(
          ui, "Learn", "learn",
          "Learn from clips: looks through all clips and the range of motion, and sets full contraction to the\n"
          "shortest length that is not rare",
          width)) {
    learnContraction(state);
  }
}

/// Shows both buttons if only some lines have a via point.
void viaRow(PanelUi& ui, const SelectedLines& lines) {
  EditorState& state = ui.state;
  const auto withVia = std::ranges::count_if(
      lines.indices, [&](int line) { return at(state.document.rig().lines, line).via.has_value(); });
  const bool all = withVia == std::ssize(lines.indices);
  const bool some = withVia > 0 && !all;
  beginRow(ui, "Via point");
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = some ? 0.5f * (ImGui::GetContentRegionAvail().x - gap) : -1.0f;
  bool add = false;
  bool remove = false;
  if (!all) {
    add = smallButton(ui, some ? "Add missing" : "Add", "via",
                      "A point that the line bends round, beside the joint: for muscles that would pass through it",
                      width);
  }
  if (some) ImGui::SameLine(0.0f, gap);
  if (withVia > 0)
    remove = smallButton(ui, "Remove", all ? "via" : "via-remove", "The line goes straight again", width);
  if (add) addViaPoints(state);
  if (remove) removeViaPoints(state);
}

/// "upper arm L to forearm L"; the lines' names if they connect different bones.
std::string endsText(const EditorState& state, const SelectedLines& lines) {
  const Skeleton& skeleton = state.character().skeleton;
  const auto shown = [&](const LineAnchor& anchor) {
    const std::optional<int> bone = skeleton.findBone(anchor.bone);
    return bone ? shownBoneName(skeleton, *bone) : anchor.bone + " (missing)";
  };
  std::set<std::string> ends;
  for (const int index : lines.indices) {
    const MuscleLine& line = at(state.document.rig().lines, index);
    ends.insert(shown(line.origin) + " to " + shown(line.insertion));
  }
  return ends.size() == 1 ? *ends.begin() : namedLines(state.document.rig(), lines.indices);
}

void endsRow(PanelUi& ui, const Subjects& subjects, const SelectedLines& lines) {
  std::string text = endsText(ui.state, lines);
  const std::size_t rigid = subjects.indices.size() - lines.muscles;
  if (rigid > 0) text += ", " + std::to_string(rigid) + " rigid";
  beginRow(ui, "Ends");
  const float clear = buttonWidth("Rigid");
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(
      fitted(text, ImGui::GetContentRegionAvail().x - clear - ImGui::GetStyle().ItemSpacing.x).c_str());
  ui.widgets.note("inspector/line/ends");
  tooltip(ui, text + (lines.several() ? "\nThe rows below change all of these lines."
                                      : "\nDrag the round handles in the picture to move the ends."));
  ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - clear);
  const char* hint = lines.several() ? "The muscles ride their bones again, without stretching"
                                     : "The muscle rides its bone again, without stretching";
  if (smallButton(ui, "Rigid", "remove", hint, clear)) takeOffLines(ui.state);
}

}  // namespace

void drawOtherEndRow(PanelUi& ui, const Subjects& subjects) {
  const auto rigid = [&](int index) { return at(subjects.rig->primitives, index).line.empty(); };
  if (subjects.bone < 0 || std::ranges::none_of(subjects.indices, rigid)) return;
  const Skeleton& skeleton = ui.state.character().skeleton;
  beginRow(ui, kOtherEnd);
  const bool open = ImGui::BeginCombo("##other-end", "on the same bone", ImGuiComboFlags_HeightLarge);
  ui.widgets.note(kOtherEnd.id);
  if (!open) {
    tooltip(ui, "Attach the muscle's other end to a bone: it stretches, thickens and flexes between the two.");
    return;
  }
  const int bone = boneList(ui, kOtherEnd.id, subjects.bone, -1, [&](int candidate) {
    return std::ranges::any_of(subjects.indices, [&](int index) {
      return rigid(index) && skeleton.findBone(at(subjects.rig->primitives, index).bone) != candidate;
    });
  });
  if (bone >= 0) attachOtherEnd(ui.state, bone);
  ImGui::EndCombo();
}

void drawLineRows(PanelUi& ui, const Subjects& subjects) {
  SelectedLines lines = selectedLines(ui.state.document);
  if (lines.indices.empty()) return;
  endsRow(ui, subjects, lines);
  lines = selectedLines(ui.state.document);  // The button may have made muscles rigid.
  const std::vector<int> usable = usableLines(ui, lines);
  if (usable.empty()) return;
  lengthBar(ui, usable);
  lengthButtons(ui);
  drawFlexRow(ui, lines);
  viaRow(ui, lines);
}

}  // namespace sinew::app
