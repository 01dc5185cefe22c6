// app/panels/inspector/inspector_line.cpp: the line that carries the muscle: its ends, its length, how it flexes.

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "app/document/shown_names.h"
#include "app/editor/hidden_bones.h"
#include "app/panels/inspector/inspector.h"
#include "app/panels/shared/animated_field.h"
#include "app/panels/shared/field_edit.h"
#include "app/tools/line_handles.h"
#include "core/base/at.h"
#include "core/lines/line_fitting.h"
#include "core/rig/line_edit.h"
#include "core/symmetry/line_twins.h"

namespace sinew::app {
namespace {

/// A number of a line. All in shown units.
struct LineNumber {
  const char* id;
  const char* name;
  const char* format;
  float speed;
  float least;
  float most;
  float scale;  ///< Shown units per unit of the rig.
  float& (*of)(LineSettings&);
  const char* hint;
  std::optional<Parameter> parameter = std::nullopt;  ///< What keys and drivers call it.
};

using S = LineSettings;

constexpr std::array kFlex{
    LineNumber{"flex-height", "Flex height", "%.0f %%", 0.5f, -90.0f, 400.0f, 100.0f,
               [](S& s) -> float& { return s.flex.x; },
               "How much higher the belly gets when the muscle is fully active.", Parameter::kFlexHeight},
    LineNumber{"flex-width", "Flex width", "%.0f %%", 0.5f, -90.0f, 400.0f, 100.0f,
               [](S& s) -> float& { return s.flex.y; },
               "How much wider the belly gets when the muscle is fully active.", Parameter::kFlexWidth}};
constexpr std::array kVolume{LineNumber{
    "volume", "Volume", "%.2f", 0.01f, 0.0f, kMostVolume, 1.0f, [](S& s) -> float& { return s.volume; },
    "0: the girth stays as the muscle stretches. 1: the volume stays. More: exaggerated.", Parameter::kVolume}};
constexpr std::array kRest{LineNumber{
    "rest", "Rest length", "%.0f %%", 0.2f, 100.0f * kLeastRest, 100.0f * kMostRest, 100.0f,
    [](S& s) -> float& { return s.rest; },
    "The length at which the belly is neither stretched nor shortened, in per cent of the line in the bind pose.",
    Parameter::kRest}};
constexpr std::array kTendons{
    LineNumber{"tendon-origin", "Tendon at the origin", "%.0f %%", 0.2f, 0.0f, 80.0f, 100.0f,
               [](S& s) -> float& { return s.tendons.x; }, "Share of the rest length that does not stretch."},
    LineNumber{"tendon-insertion", "Tendon at the insertion", "%.0f %%", 0.2f, 0.0f, 80.0f, 100.0f,
               [](S& s) -> float& { return s.tendons.y; }, "Share of the rest length that does not stretch."}};
constexpr std::array kFrame{
    LineNumber{"pivot", "Pivot", "%.2f", 0.01f, 0.0f, 1.0f, 1.0f, [](S& s) -> float& { return s.pivot; },
               "1: the girth grows away from the bone. 0: to all sides of the line."},
    LineNumber{"twist", "Twist", "%.2f", 0.01f, 0.0f, 1.0f, 1.0f, [](S& s) -> float& { return s.twist; },
               "The belly turns with 0: the first bone, 1: the second."}};
constexpr std::array kActivation{
    LineNumber{"base", "Activation by hand", "%.2f", 0.01f, 0.0f, 1.0f, 1.0f, [](S& s) -> float& { return s.base; },
               "How active the muscle is at rest, 0 to 1.", Parameter::kActivation},
    LineNumber{"gain", "Activation from shortening", "%.2f", 0.01f, 0.0f, kMostGain, 1.0f,
               [](S& s) -> float& { return s.gain; }, "How much shortening activates it. 0: by hand alone."},
    LineNumber{"full", "Full contraction", "%.0f %%", 0.2f, 100.0f * kLeastFull, 100.0f * kMostFull, 100.0f,
               [](S& s) -> float& { return s.full; }, "The length at which shortening activates the muscle fully."}};

float shownNumber(const LineNumber& number, const MuscleLine& line) {
  LineSettings settings = line.settings;
  return number.of(settings) * number.scale;
}

void lineMenu(PanelUi& ui, const std::string& id, const AnimatedField& animated) {
  if (animated.refs.empty() || !ImGui::BeginPopupContextItem(id.c_str())) return;
  animationMenu(ui, animated);
  ImGui::EndPopup();
}

void numberField(PanelUi& ui, int line, const LineNumber& number, float width) {
  const std::string id = std::string("inspector/line/") + number.id;
  AnimatedField animated{{}, {}, number.format};
  if (number.parameter) animated = {{{*number.parameter, line}}, {number.scale}, number.format};
  const AnimatedLook animation = lookOf(ui, animated);
  if (animation.beingSet) {
    ImGui::SetNextItemWidth(width);
    drawDrivenKeyField(ui, id, animated, {number.format, number.speed, number.least, number.most});
    return lineMenu(ui, id, animated);
  }
  const Rig& rig = ui.state.document.rig();
  float value = shownNumber(number, at(rig.lines, line));
  Typing typing;
  NumberLook look{number.format, number.speed, number.least, number.most};
  look.clampTyped = false;
  look.typing = &typing;
  ImGui::SetNextItemWidth(width);
  pushAnimatedColors(animation);
  const bool edited = numberField(("##" + id).c_str(), value, look);
  popAnimatedColors(ui, animation);
  notePointed(ui, animated);
  const std::string label = std::string(number.name) + " of " + at(rig.lines, line).name;
  const auto changed = [&] {
    return editLine(ui.state.document.rig(), line,
                    [&](MuscleLine& of) { number.of(of.settings) = value / number.scale; });
  };
  const auto shown = [&](const Rig& of) {
    const bool there = line < static_cast<int>(of.lines.size());
    return there ? numberText(number.format, shownNumber(number, at(of.lines, line))) : "";
  };
  editNumber(ui, id, label.c_str(), edited, typing, changed, shown);
  const bool quiet = ImGui::IsItemActive();
  if (!quiet) {
    const std::string more = animated.refs.empty() ? "" : "\nRight click: key, drive.";
    tooltip(ui, std::string(number.name) + "\n" + animation.words + number.hint + more);
  }
  ui.widgets.note(id);
  lineMenu(ui, id, animated);
}

void numberRow(PanelUi& ui, int line, const char* label, std::span<const LineNumber> numbers) {
  beginRow(ui, label);
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const auto count = static_cast<float>(numbers.size());
  const float width = (ImGui::GetContentRegionAvail().x - (count - 1.0f) * gap) / count;
  bool first = true;
  for (const LineNumber& number : numbers) {
    if (!first) ImGui::SameLine(0.0f, gap);
    first = false;
    numberField(ui, line, number, width);
  }
}

/// The line's lengths in the clip that is shown; none in the bind pose. A drag waits for its end: long clips take a
/// while.
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

/// From half to one and a half of the rest length: the shaded part activates, the tick is now.
void lengthBar(PanelUi& ui, const MuscleLine& line, const ShownLine& shown) {
  beginRow(ui, "Length");
  constexpr float kLeast = 0.5f;
  constexpr float kMost = 1.5f;
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = ImGui::GetFrameHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("##length", {width, height});
  ui.widgets.note("inspector/line/length");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto x = [&](float stretch) {
    return at.x + width * std::clamp((stretch - kLeast) / (kMost - kLeast), 0.0f, 1.0f);
  };
  const float round = ImGui::GetStyle().FrameRounding;
  list.AddRectFilled(at, {at.x + width, at.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg), round);
  // The redder, the more active.
  list.AddRectFilled(at, {at.x + width, at.y + height}, palette::kAccent.faded(0.45f * shown.activation).packed(),
                     round);
  const LineLengths* range = rangeInClip(ui, line);
  if (range) {
    list.AddRectFilled({x(range->least), at.y + ui.px(4)}, {x(range->most), at.y + ui.px(7)},
                       palette::kText.faded(0.55f).packed(), ui.px(1));
  }
  list.AddRectFilled({x(line.settings.full), at.y + height - ui.px(5)}, {x(1.0f), at.y + height - ui.px(2)},
                     palette::kAccent.faded(0.55f).packed(), ui.px(1));
  list.AddLine({x(1.0f), at.y + ui.px(3)}, {x(1.0f), at.y + height - ui.px(2)}, palette::kMuted.packed(), 1.0f);
  list.AddLine({x(shown.stretch), at.y}, {x(shown.stretch), at.y + height}, palette::kAccent.packed(), ui.px(2));
  const auto percent = [](float share) { return std::to_string(static_cast<int>(std::lround(100.0f * share))) + " %"; };
  const std::string text = percent(shown.stretch);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const bool right = x(shown.stretch) < at.x + 0.5f * width;
  list.AddText({right ? at.x + width - size.x - ui.px(6) : at.x + ui.px(6), at.y + 0.5f * (height - size.y)},
               palette::kText.packed(), text.c_str());
  std::string hint =
      "The line's length in this pose, in per cent of its rest length. Active: " + percent(shown.activation) +
      ".\nGrey: rest. Underlined: from rest to full contraction, where shortening activates the muscle.";
  if (range)
    hint += "\nAbove: its lengths in this clip, " + percent(range->least) + " to " + percent(range->most) + ".";
  tooltip(ui, hint);
}

void learn(PanelUi& ui, int line) {
  EditorState& state = ui.state;
  const MuscleLine& own = at(state.document.rig().lines, line);
  const Result<LineRest> rest = lineRest(own, state.character());
  if (!rest) return refuse(state, rest.error());
  const LineLengths lengths = lengthsOver(rest.value(), state.character(), state.character().clips);
  Result<Learned> learned = withLearned(state.document.rig(), line, lengths);
  if (!learned) return sayRefusal(state, learned.error().plainText());
  edit(state, "Learn contraction of " + own.name, std::move(learned.value().rig));
  say(state, learned->said);
  if (!learned->warning.empty()) addMessage(state.session, MessageKind::kWarning, learned->warning);
}

bool smallButton(PanelUi& ui, const char* label, const char* id, const char* hint, float width) {
  const bool pressed = ImGui::Button(label, {width, 0.0f});
  ui.widgets.note(std::string("inspector/line/") + id);
  tooltip(ui, hint);
  return pressed;
}

void lengthButtons(PanelUi& ui, int line, const ShownLine& shown) {
  EditorState& state = ui.state;
  const std::string name = at(state.document.rig().lines, line).name;
  beginRow(ui, "Set");
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 2.0f * gap) / 3.0f;
  if (smallButton(ui, "Rest", "rest-now", "Rest = now: the length in this pose becomes the rest length", width)) {
    edit(state, "Rest length of " + name, withRestNow(state.document.rig(), line, shown.stretch));
  }
  ImGui::SameLine(0.0f, gap);
  if (smallButton(ui, "Full", "full-now",
                  "Full = now: at the length in this pose the muscle is fully contracted. Bend the joint first",
                  width)) {
    edit(state, "Full contraction of " + name, withFullNow(state.document.rig(), line, shown.stretch));
  }
  ImGui::SameLine(0.0f, gap);
  if (smallButton(
          ui, "Learn", "learn",
          "Learn from clips: looks through all clips and the range of motion, and sets full contraction to the\n"
          "shortest length that is not rare",
          width)) {
    learn(ui, line);
  }
}

void viaRow(PanelUi& ui, int line) {
  EditorState& state = ui.state;
  const MuscleLine& own = at(state.document.rig().lines, line);
  const std::string name = own.name;
  beginRow(ui, "Via point");
  if (own.via) {
    if (smallButton(ui, "Remove", "via", "The line goes straight again", -1.0f)) {
      edit(state, "Remove via point of " + name, withoutViaPoint(state.document.rig(), line));
    }
  } else if (smallButton(ui, "Add", "via",
                         "A point that the line bends round, beside the joint: for muscles that would pass through it",
                         -1.0f)) {
    edit(state, "Add via point to " + name, withViaPoint(state.document.rig(), line, state.character()));
  }
}

void endsRow(PanelUi& ui, const Subjects& subjects, const MuscleLine& line) {
  const Skeleton& skeleton = ui.state.character().skeleton;
  const auto shown = [&](const LineAnchor& anchor) {
    const std::optional<int> bone = skeleton.findBone(anchor.bone);
    return bone ? shownBoneName(skeleton, *bone) : anchor.bone + " (missing)";
  };
  const std::string both = shown(line.origin) + " to " + shown(line.insertion);
  beginRow(ui, "Ends");
  const float clear = ImGui::CalcTextSize("Rigid").x + 2.0f * ImGui::GetStyle().FramePadding.x;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(
      fitted(both, ImGui::GetContentRegionAvail().x - clear - ImGui::GetStyle().ItemSpacing.x).c_str());
  tooltip(ui, both + "\nDrag the round handles in the picture to move the ends.");
  ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - clear);
  if (smallButton(ui, "Rigid", "remove", "The muscle rides its bone again, without stretching", clear)) {
    edit(ui.state, "Take " + subjects.shown().name + " off its line",
         setLineOfSeveral(ui.state.document.rig(), subjects.indices, -1));
  }
}

}  // namespace

void drawOtherEndRow(PanelUi& ui, const Subjects& subjects) {
  if (subjects.several() || subjects.bone < 0 || !subjects.shown().line.empty()) return;
  const Skeleton& skeleton = ui.state.character().skeleton;
  beginRow(ui, "Other end");
  const bool open = ImGui::BeginCombo("##other-end", "on the same bone", ImGuiComboFlags_HeightLarge);
  ui.widgets.note("inspector/other-end");
  if (!open) {
    tooltip(ui, "Attach the muscle's other end to a bone: it stretches, thickens and flexes between the two.");
    return;
  }
  const std::vector<bool> hidden = hiddenBones(ui.state);
  const std::vector<std::string> names = shownFileNames(skeleton);
  for (int bone = 0; bone < static_cast<int>(skeleton.bones.size()); ++bone) {
    if (isHidden(hidden, bone) || bone == subjects.bone) continue;
    const bool chosen = ImGui::Selectable(at(names, bone).c_str());
    ui.widgets.note("inspector/other-end/" + skeleton.fileName(bone));
    if (!chosen) continue;
    const Document& document = ui.state.document;
    Result<Rig> lined = withOtherEnd(document.rig(), subjects.active, bone, ui.state.character());
    if (lined && document.mirror) {
      lined = withTwinOnLine(std::move(lined).value(), subjects.active, *document.mirror);
    }
    edit(ui.state, "Attach " + subjects.shown().name + " to " + at(names, bone), std::move(lined));
  }
  ImGui::EndCombo();
}

void drawLineRows(PanelUi& ui, const Subjects& subjects) {
  if (subjects.several() || subjects.bone < 0) return;
  const int line = findLine(ui.state.document.rig(), subjects.shown().line);
  if (line < 0) return;
  endsRow(ui, subjects, at(subjects.rig->lines, line));
  const std::optional<ShownLine> shown = activeLine(ui.state.document, ui.state.live->pose());
  if (!shown || findLine(ui.state.document.rig(), subjects.shown().line) != line) return;
  lengthBar(ui, at(subjects.rig->lines, line), *shown);
  lengthButtons(ui, line, *shown);
  numberRow(ui, line, "Flex", kFlex);
  viaRow(ui, line);
}

void drawLineNumbers(PanelUi& ui, const Subjects& subjects) {
  if (subjects.several() || subjects.bone < 0) return;
  const int line = findLine(ui.state.document.rig(), subjects.shown().line);
  if (line < 0) return;
  section(ui, "Muscle line");
  numberRow(ui, line, "Rest", kRest);
  numberRow(ui, line, "Volume", kVolume);
  numberRow(ui, line, "Tendons", kTendons);
  numberRow(ui, line, "Pivot", kFrame);
  numberRow(ui, line, "Active", kActivation);
}

}  // namespace sinew::app
