// app/panels/inspector_line_numbers.cpp: the number fields of muscle lines, one or several at once.

#include <imgui_internal.h>  // TempInputIsActive: whether a number is typed or dragged.

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "app/editor/line_commands.h"
#include "app/panels/field_edit.h"
#include "app/panels/inspector.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

/// A number of a line. All in shown units.
struct LineNumber {
  Control control;  ///< Its label is also the number's name in the history.
  const char* format;
  float speed;
  float least;
  float most;
  float scale;  ///< Shown units per unit of the rig.
  float& (*of)(LineSettings&);
  const char* hint;
  std::optional<Parameter> parameter = std::nullopt;  ///< None: keys and drivers cannot change it.
  const char* word = "";                              ///< Shown in the field if several share a row.
};

using S = LineSettings;

const Control kOfLine{"inspector/section/line", "Section Muscle line", "lengths tendons volume", withLine};

const std::array kFlex{
    LineNumber{Control("inspector/line/flex-height", "Flex height", "bulge higher contraction", withLine), "%.0f %%",
               0.5f, -90.0f, 400.0f, 100.0f, [](S& s) -> float& { return s.flex.x; },
               "How much higher the belly gets when the muscle is fully active.", Parameter::kFlexHeight, "height"},
    LineNumber{Control("inspector/line/flex-width", "Flex width", "bulge wider contraction", withLine), "%.0f %%", 0.5f,
               -90.0f, 400.0f, 100.0f, [](S& s) -> float& { return s.flex.y; },
               "How much wider the belly gets when the muscle is fully active.", Parameter::kFlexWidth, "width"}};
const std::array kVolume{LineNumber{
    Control("inspector/line/volume", "Volume", "preserve girth squash stretch", withLine, kOfLine.id), "%.2f", 0.01f,
    0.0f, kMostVolume, 1.0f, [](S& s) -> float& { return s.volume; },
    "0: the girth stays as the muscle stretches. 1: the volume stays. More: exaggerated.", Parameter::kVolume}};
const std::array kRest{
    LineNumber{
        Control("inspector/line/rest", "Rest length", "relaxed neutral", withLine, kOfLine.id), "%.0f %%", 0.2f,
        100.0f * kLeastRest, 100.0f * kMostRest, 100.0f, [](S& s) -> float& { return s.rest; },
        "The length at which the belly is neither stretched nor shortened, in per cent of the line in the bind pose.",
        Parameter::kRest, "rest"},
    LineNumber{Control("inspector/line/full", "Full contraction", "flexed shortest", withLine, kOfLine.id), "%.0f %%",
               0.2f, 100.0f * kLeastFull, 100.0f * kMostFull, 100.0f, [](S& s) -> float& { return s.full; },
               "The length at which shortening activates the muscle fully.", std::nullopt, "full"}};
const std::array kTendons{LineNumber{Control("inspector/line/tendon-origin", "Tendon at the origin",
                                             "tendons sinew start", withLine, kOfLine.id),
                                     "%.0f %%", 0.2f, 0.0f, 80.0f, 100.0f, [](S& s) -> float& { return s.tendons.x; },
                                     "Share of the rest length that does not stretch.", std::nullopt, "origin"},
                          LineNumber{Control("inspector/line/tendon-insertion", "Tendon at the insertion",
                                             "tendons sinew end", withLine, kOfLine.id),
                                     "%.0f %%", 0.2f, 0.0f, 80.0f, 100.0f, [](S& s) -> float& { return s.tendons.y; },
                                     "Share of the rest length that does not stretch.", std::nullopt, "end"}};
const std::array kFrame{
    LineNumber{Control("inspector/line/pivot", "Pivot", "girth side bone", withLine, kOfLine.id), "%.2f", 0.01f, 0.0f,
               1.0f, 1.0f, [](S& s) -> float& { return s.pivot; },
               "1: the girth grows away from the bone. 0: to all sides of the line.", std::nullopt, "pivot"},
    LineNumber{Control("inspector/line/twist", "Twist", "roll turn belly", withLine, kOfLine.id), "%.2f", 0.01f, 0.0f,
               1.0f, 1.0f, [](S& s) -> float& { return s.twist; },
               "The belly turns with 0: the first bone, 1: the second.", std::nullopt, "twist"}};
const std::array kActivation{
    LineNumber{Control("inspector/line/base", "Activation by hand", "active tone", withLine, kOfLine.id), "%.2f", 0.01f,
               0.0f, 1.0f, 1.0f, [](S& s) -> float& { return s.base; }, "How active the muscle is at rest, 0 to 1.",
               Parameter::kActivation, "hand"},
    LineNumber{Control("inspector/line/gain", "Activation from shortening", "active automatic", withLine, kOfLine.id),
               "%.2f", 0.01f, 0.0f, kMostGain, 1.0f, [](S& s) -> float& { return s.gain; },
               "How much shortening activates it. 0: by hand alone.", std::nullopt, "gain"}};

float shownNumber(const LineNumber& number, const MuscleLine& line) {
  LineSettings settings = line.settings;
  return number.of(settings) * number.scale;
}

/// The line as it was before the current edit.
const MuscleLine& atStart(const EditorState& state, const MuscleLine& line) {
  const Rig& rig = state.document.commands.rigOfStep();
  const int index = findLine(rig, line.id());
  return index < 0 ? line : at(rig.lines, index);
}

/// The active line's number first.
AnimatedField animatedOf(const SelectedLines& lines, const LineNumber& number) {
  AnimatedField animated{{}, {}, number.format};
  if (!number.parameter) return animated;
  const auto add = [&](int line) {
    animated.refs.push_back({*number.parameter, line});
    animated.scales.push_back(number.scale);
  };
  add(lines.active);
  for (const int line : lines.indices) {
    if (line != lines.active) add(line);
  }
  return animated;
}

/// An edit of the lines' numbers: a typed number is assigned to all, a drag makes the same change to all.
struct LineEdit {
  bool same = false;
  bool fromStart = false;  ///< "+=0.1": relative to the values before the edit.
  float from = 0.0f;       ///< The active line's; shown units.
  float to = 0.0f;
};

Result<Rig> edited(const EditorState& state, const SelectedLines& lines, const LineNumber& number,
                   const LineEdit& change) {
  const LineId active = at(state.document.rig().lines, lines.active).id();
  return editLines(state.document.rig(), lines.indices, [&](MuscleLine& line) {
    const float own = shownNumber(number, change.fromStart ? atStart(state, line) : line);
    const bool exact = change.same || line.id() == active;
    // The others stop at the ends of the range; a typed number out of range is refused with the reason.
    const float shown = exact ? change.to : std::clamp(own + (change.to - change.from), number.least, number.most);
    number.of(line.settings) = shown / number.scale;
  });
}

/// "75 %"; "" if the lines differ or one is gone: then the history names no values.
std::string commonText(const EditorState& state, const SelectedLines& lines, const LineNumber& number, bool before) {
  const Rig& rig = state.document.rig();
  std::string text;
  for (const int line : lines.indices) {
    if (line >= static_cast<int>(rig.lines.size())) return {};
    const MuscleLine& now = at(rig.lines, line);
    const std::string own = numberText(number.format, shownNumber(number, before ? atStart(state, now) : now));
    if (!text.empty() && text != own) return {};
    text = own;
  }
  return text;
}

void lineMenu(PanelUi& ui, const std::string& id, const SelectedLines& lines, const LineNumber& number,
              const AnimatedField& animated) {
  if (!ImGui::BeginPopupContextItem(id.c_str())) return;
  EditorState& state = ui.state;
  const Rig& rig = state.document.rig();
  const float shown = shownNumber(number, at(rig.lines, lines.active));
  const std::optional<float> chosen = numberMenu(ui, number.format, shown, shownNumber(number, MuscleLine{}));
  if (chosen) {
    edit(state, std::string(number.control.label) + " of " + namedLines(rig, lines.indices),
         edited(state, lines, number, {true, false, shown, *chosen}));
  }
  if (!animated.refs.empty()) ImGui::Separator();
  animationMenu(ui, animated);
  ImGui::EndPopup();
}

void hintOf(PanelUi& ui, const LineNumber& number, const std::string& animation, bool animated, bool differ) {
  if (ImGui::IsItemActive()) return;
  const std::string more = animated ? "\nRight click: reset, copy, key, drive." : "\nRight click: reset, copy, paste.";
  const char* mixed = differ ? "\nThey differ: a drag keeps the differences, a typed number is for all." : "";
  tooltip(ui, std::string(number.control.label) + "\n" + animation + number.hint + mixed + more);
}

/// The format with the number's word, if that fits.
std::string labelled(const LineNumber& number, float value, float width) {
  const std::string format = std::string(number.word) + (*number.word == '\0' ? "" : " ") + number.format;
  const float room = width - 2.0f * ImGui::GetStyle().ItemInnerSpacing.x;
  return ImGui::CalcTextSize(numberText(format.c_str(), value).c_str()).x <= room ? format : number.format;
}

void numberField(PanelUi& ui, const SelectedLines& lines, const LineNumber& number, float width) {
  const std::string id = number.control.id;
  const std::string label = "##" + id;
  const AnimatedField animated = animatedOf(lines, number);
  const AnimatedLook animation = lookOf(ui, animated);
  ImGui::SetNextItemWidth(width);
  if (animation.beingSet) {
    drawDrivenKeyField(ui, id, animated, {number.format, number.speed, number.least, number.most});
    return lineMenu(ui, id, lines, number, animated);
  }
  EditorState& state = ui.state;
  const Rig& rig = state.document.rig();
  const float before = shownNumber(number, at(rig.lines, lines.active));
  const bool differ =
      std::ranges::any_of(lines.indices, [&](int line) { return shownNumber(number, at(rig.lines, line)) != before; });
  const ImGuiID item = ImGui::GetID(label.c_str());
  const bool typed = ImGui::TempInputIsActive(item);
  const bool mixed = differ && ImGui::GetActiveID() != item;
  const bool muted = mixed && !animation.driven && !animation.keyedHere;
  const std::string step = std::string(number.control.label) + " of " + namedLines(rig, lines.indices);
  float value = before;
  Typing typing;
  const std::string format = labelled(number, value, width);
  NumberLook look{mixed ? "mixed" : format.c_str(), number.speed, number.least, number.most};
  look.clampTyped = false;
  look.typing = &typing;
  if (muted) ImGui::PushStyleColor(ImGuiCol_Text, palette::kMuted);
  pushAnimatedColors(animation);
  const bool changed = numberField(label.c_str(), value, look);
  popAnimatedColors(ui, animation);
  if (muted) ImGui::PopStyleColor();
  notePointed(ui, animated);
  beginFieldEdit(ui, id, step.c_str());
  if (changed) {
    const float from = typing.relative ? shownNumber(number, atStart(state, at(rig.lines, lines.active))) : before;
    edit(state, step, edited(state, lines, number, {typed && !typing.relative, typing.relative, from, value}));
  }
  if (!typing.refusal.empty()) refuse(state, errorAt({}, typing.refusal));
  if (ImGui::IsItemDeactivated()) {
    const std::string was = commonText(state, lines, number, true);
    const std::string is = commonText(state, lines, number, false);
    endFieldEdit(ui, was.empty() || is.empty() ? step : step + " " + was + " to " + is);
  }
  hintOf(ui, number, animation.words, !animated.refs.empty(), differ);
  lineMenu(ui, id, lines, number, animated);
}

void numberRow(PanelUi& ui, const SelectedLines& lines, const char* label, std::span<const LineNumber> numbers) {
  beginRow(ui, label);
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const auto count = static_cast<float>(numbers.size());
  const float width = (ImGui::GetContentRegionAvail().x - (count - 1.0f) * gap) / count;
  bool first = true;
  for (const LineNumber& number : numbers) {
    if (!first) ImGui::SameLine(0.0f, gap);
    first = false;
    numberField(ui, lines, number, width);
  }
}

}  // namespace

void drawFlexRow(PanelUi& ui, const SelectedLines& lines) { numberRow(ui, lines, "Flex", kFlex); }

void drawLineNumbers(PanelUi& ui) {
  const SelectedLines lines = selectedLines(ui.state.document);
  if (lines.indices.empty()) return;
  if (!section(ui, kOfLine, lines.several() ? "Muscle lines" : "Muscle line")) return;
  numberRow(ui, lines, "Lengths", kRest);
  numberRow(ui, lines, "Volume", kVolume);
  numberRow(ui, lines, "Tendons", kTendons);
  numberRow(ui, lines, "Pivot", kFrame);
  numberRow(ui, lines, "Active", kActivation);
}

}  // namespace sinew::app
