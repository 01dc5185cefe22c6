// app/panels/inspector_line.cpp: the lines that carry the muscles: ends, lengths, via points.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "app/document/listed_muscles.h"
#include "app/document/shown_names.h"
#include "app/editor/line_commands.h"
#include "app/panels/field_edit.h"
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

// The number fields of muscle lines, one or several at once.

namespace {

using S = LineSettings;

Possible withLineSettings(const EditorState& state) {
  const int sheet = activeSheet(state.document);
  const bool ofSheet = sheet >= 0 && at(state.document.rig().sheets, sheet).line;
  return ofSheet ? withMuscle(state) : withLine(state);
}

const Control kOfLine{"inspector/section/line", "Section Muscle line", "lengths tendons volume", withLineSettings};

const std::array kFlex{
    LineNumber{Control("inspector/line/flex-height", "Flex height", "bulge higher contraction", withLineSettings),
               "%.0f %%", 0.5f, -90.0f, 400.0f, 100.0f, [](S& s) -> float& { return s.flex.x; },
               "How much higher the belly gets when the muscle is fully active.", Parameter::kFlexHeight, "height"},
    LineNumber{Control("inspector/line/flex-width", "Flex width", "bulge wider contraction", withLineSettings),
               "%.0f %%", 0.5f, -90.0f, 400.0f, 100.0f, [](S& s) -> float& { return s.flex.y; },
               "How much wider the belly gets when the muscle is fully active.", Parameter::kFlexWidth, "width"}};
const std::array kVolume{LineNumber{
    Control("inspector/line/volume", "Volume", "preserve girth squash stretch", withLineSettings, kOfLine.id), "%.2f",
    0.01f, 0.0f, kMostVolume, 1.0f, [](S& s) -> float& { return s.volume; },
    "0: the girth stays as the muscle stretches. 1: the volume stays. More: exaggerated.", Parameter::kVolume}};
const std::array kRest{
    LineNumber{
        Control("inspector/line/rest", "Rest length", "relaxed neutral", withLineSettings, kOfLine.id), "%.0f %%", 0.2f,
        100.0f * kLeastRest, 100.0f * kMostRest, 100.0f, [](S& s) -> float& { return s.rest; },
        "The length at which the belly is neither stretched nor shortened, in per cent of the line in the bind pose.",
        Parameter::kRest, "rest"},
    LineNumber{Control("inspector/line/full", "Full contraction", "flexed shortest", withLineSettings, kOfLine.id),
               "%.0f %%", 0.2f, 100.0f * kLeastFull, 100.0f * kMostFull, 100.0f, [](S& s) -> float& { return s.full; },
               "The length at which shortening activates the muscle fully.", std::nullopt, "full"}};
const std::array kTendons{LineNumber{Control("inspector/line/tendon-origin", "Tendon at the origin",
                                             "tendons sinew start", withLineSettings, kOfLine.id),
                                     "%.0f %%", 0.2f, 0.0f, 80.0f, 100.0f, [](S& s) -> float& { return s.tendons.x; },
                                     "Share of the rest length that does not stretch.", std::nullopt, "origin"},
                          LineNumber{Control("inspector/line/tendon-insertion", "Tendon at the insertion",
                                             "tendons sinew end", withLineSettings, kOfLine.id),
                                     "%.0f %%", 0.2f, 0.0f, 80.0f, 100.0f, [](S& s) -> float& { return s.tendons.y; },
                                     "Share of the rest length that does not stretch.", std::nullopt, "end"}};
const std::array kFrame{
    LineNumber{Control("inspector/line/pivot", "Pivot", "girth side bone", withLineSettings, kOfLine.id), "%.2f", 0.01f,
               0.0f, 1.0f, 1.0f, [](S& s) -> float& { return s.pivot; },
               "1: the girth grows away from the bone. 0: to all sides of the line.", std::nullopt, "pivot"},
    LineNumber{Control("inspector/line/twist", "Twist", "roll turn belly", withLineSettings, kOfLine.id), "%.2f", 0.01f,
               0.0f, 1.0f, 1.0f, [](S& s) -> float& { return s.twist; },
               "The belly turns with 0: the first bone, 1: the second.", std::nullopt, "twist"}};
const std::array kActivation{
    LineNumber{Control("inspector/line/base", "Activation by hand", "active tone", withLineSettings, kOfLine.id),
               "%.2f", 0.01f, 0.0f, 1.0f, 1.0f, [](S& s) -> float& { return s.base; },
               "How active the muscle is at rest, 0 to 1.", Parameter::kActivation, "hand"},
    LineNumber{
        Control("inspector/line/gain", "Activation from shortening", "active automatic", withLineSettings, kOfLine.id),
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

Result<Rig> edited(const EditorState& state, const SelectedLines& lines, const LineNumber& number,
                   const SharedEdit& change) {
  const MuscleLine active = at(state.document.rig().lines, lines.active);
  const auto own = [&](const MuscleLine& line) {
    return shownNumber(number, change.fromStart ? atStart(state, line) : line);
  };
  const float from = own(active);
  return editLines(state.document.rig(), lines.indices, [&](MuscleLine& line) {
    const bool exact = change.same || line.id() == active.id();
    // The others stop at the ends of the range; a typed number out of range is refused with the reason.
    const float shown = exact ? change.to : std::clamp(own(line) + (change.to - from), number.least, number.most);
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
         edited(state, lines, number, {true, false, *chosen}));
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

void numberField(PanelUi& ui, const SelectedLines& lines, const LineNumber& number, float width) {
  const std::string id = number.control.id;
  const AnimatedField animated = animatedOf(lines, number);
  const AnimatedLook animation = lookOf(ui, animated);
  ImGui::SetNextItemWidth(width);
  NumberLook look{number.format, number.speed, number.least, number.most};
  if (animation.beingSet) {
    drawDrivenKeyField(ui, id, animated, look);
    return lineMenu(ui, id, lines, number, animated);
  }
  EditorState& state = ui.state;
  const Rig& rig = state.document.rig();
  const float shown = shownNumber(number, at(rig.lines, lines.active));
  const bool differ =
      std::ranges::any_of(lines.indices, [&](int line) { return shownNumber(number, at(rig.lines, line)) != shown; });
  const std::string step = std::string(number.control.label) + " of " + namedLines(rig, lines.indices);
  const std::string format = labelled(number, shown, width);
  look.format = format.c_str();
  drawSharedField(ui, id, animated, animation, {shown, differ, step.c_str()}, look,
                  [&](const SharedEdit& change) { edit(state, step, edited(state, lines, number, change)); });
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

std::string labelled(const LineNumber& number, float value, float width) {
  const std::string format = std::string(number.word) + (*number.word == '\0' ? "" : " ") + number.format;
  const float room = width - 2.0f * ImGui::GetStyle().ItemInnerSpacing.x;
  return ImGui::CalcTextSize(numberText(format.c_str(), value).c_str()).x <= room ? format : number.format;
}

void drawFlexRow(PanelUi& ui, const SelectedLines& lines) {
  numberRow(ui, lines, lineRows().front().label, lineRows().front().numbers);
}

bool lineSection(PanelUi& ui, bool several) { return section(ui, kOfLine, several ? "Muscle lines" : "Muscle line"); }

std::span<const LineRow> lineRows() {
  static const std::array<LineRow, 6> kRows{{{"Flex", kFlex},
                                             {"Lengths", kRest},
                                             {"Volume", kVolume},
                                             {"Tendons", kTendons},
                                             {"Pivot", kFrame},
                                             {"Active", kActivation}}};
  return kRows;
}

void drawLineNumbers(PanelUi& ui) {
  const SelectedLines lines = selectedLines(ui.state.document);
  if (lines.indices.empty()) return;
  if (!lineSection(ui, lines.several())) return;
  for (const LineRow& row : lineRows().subspan(1)) numberRow(ui, lines, row.label, row.numbers);
}

}  // namespace sinew::app
