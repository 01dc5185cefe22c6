// app/panels/inspector_animation.cpp: drivers and keys of the active muscle, its line, the surface, shapes and links.

#include <algorithm>
#include <array>

#include "app/editor/animate.h"
#include "app/panels/curve_editor.h"
#include "app/panels/field_edit.h"
#include "app/panels/inspector.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

using app::wordFor;

constexpr std::array kModes{DriverMode::kAdd, DriverMode::kMultiply, DriverMode::kReplace};

const char* wordFor(DriverMode mode) {
  constexpr const char* kWords[] = {"Add", "Multiply", "Replace"};
  return kWords[static_cast<int>(mode)];
}

bool anyAnimated(const EditorState& state) {
  const Rig& rig = state.document.rig();
  const int active = state.document.activePrimitive();
  if (active < 0) return false;
  const int line = findLine(rig, at(rig.primitives, active).line);
  return !at(rig.primitives, active).animated.empty() || (line >= 0 && !at(rig.lines, line).animated.empty());
}
Possible withAnimation(const EditorState& state) {
  return withMuscle(state).also(anyAnimated(state), "The muscle has neither keys nor drivers");
}
Possible withSurfaceAnimation(const EditorState& state) {
  return withCharacter(state).also(!state.document.rig().surface.animated.empty(),
                                   "The surface has neither keys nor drivers");
}

const Control kAnimation{"inspector/animation", "Animation", "of the muscle drivers keys driven keyed", withAnimation};
const Control kSurfaceAnimation{"surface/animation", "Animation", "of the surface drivers keys driven keyed",
                                withSurfaceAnimation};

/// A number with its keys and drivers, as they were when drawing began.
struct Animated {
  NumberRef ref;
  AnimatedNumber number;

  [[nodiscard]] std::string id() const { return std::string("inspector/animation/") + nameOf(ref.parameter); }
};

void addAll(std::vector<Animated>& all, const std::vector<AnimatedNumber>& numbers, int owner) {
  for (const AnimatedNumber& number : numbers) all.push_back({{number.parameter, owner}, number});
}

std::vector<Animated> animatedOf(const Subjects& subjects) {
  std::vector<Animated> all;
  addAll(all, subjects.shown().animated, subjects.active);
  const int line = findLine(*subjects.rig, subjects.shown().line);
  if (line >= 0) addAll(all, at(subjects.rig->lines, line).animated, line);
  return all;
}

/// Shown units of a number, and how it is written.
struct Shown {
  float scale = 1.0f;
  const char* format = "%.3g";
};

/// Percent where the field shows percent; lengths in the bone's units; factors as they are.
Shown shownValues(Parameter parameter, DriverMode mode) {
  if (mode == DriverMode::kMultiply) return {1.0f, "x %.3g"};
  const bool percent = parameter == Parameter::kAmount || parameter == Parameter::kFlexHeight ||
                       parameter == Parameter::kFlexWidth || parameter == Parameter::kRest ||
                       parameter == Parameter::kSkinBlend || parameter == Parameter::kGrooves ||
                       parameter == Parameter::kLinkAmount;
  return percent ? Shown{100.0f, "%.3g %%"} : Shown{};
}

Shown shownInputs(DriverInputKind kind) {
  switch (kind) {
    case DriverInputKind::kBend:
    case DriverInputKind::kTwist:
    case DriverInputKind::kAxis:
      return {1.0f, "%.1f\xc2\xb0"};
    case DriverInputKind::kLength:
    case DriverInputKind::kDistance:
      return {100.0f, "%.1f %%"};
    default:
      return {1.0f, "%.3f"};
  }
}

std::string valueText(Parameter parameter, DriverMode mode, float value) {
  const Shown shown = shownValues(parameter, mode);
  return (mode == DriverMode::kAdd && value > 0.0f ? "+" : "") + numberText(shown.format, shown.scale * value);
}

/// The width of the row without room for a button.
float besideButton() {
  return ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() - ImGui::GetStyle().ItemSpacing.x;
}

bool removeButton(PanelUi& ui, const std::string& id, const std::string& hint) {
  ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight());
  return iconButton(ui, id, Icon::kClose, false, ImGui::GetFrameHeight(), hint);
}

/// @return the choice, if it differs from `now`
template <class Kind, std::size_t kCount>
std::optional<Kind> choice(PanelUi& ui, const std::string& id, Kind now, const std::array<Kind, kCount>& kinds,
                           float width, const char* hint) {
  ImGui::SetNextItemWidth(width);
  const ImGuiComboFlags arrow = width < ui.px(90) ? ImGuiComboFlags_NoArrowButton : ImGuiComboFlags_None;
  const bool open = ImGui::BeginCombo(("##" + id).c_str(), wordFor(now), arrow);
  ui.widgets.note(id);
  std::optional<Kind> chosen;
  if (!open) {
    tooltip(ui, hint);
    return chosen;
  }
  for (const Kind kind : kinds) {
    if (ImGui::Selectable(wordFor(kind), kind == now) && kind != now) chosen = kind;
    ui.widgets.note(id + "/" + nameOf(kind));
  }
  ImGui::EndCombo();
  return chosen;
}

constexpr const char* kModeHint =
    "Add: the curve's value is added to the number. Multiply: the number is multiplied by it. Replace: it replaces the "
    "number.";
constexpr const char* kKindHint =
    "Between two points. Smooth: without overshooting. Linear: a straight line. Step: the value of the point before.";

struct DriverRow {
  PanelUi& ui;
  const Animated& of;
  int index;
  std::string id;
  std::string words;  ///< "radius X of biceps L by bend of forearm.L"
  std::optional<float> now;

  [[nodiscard]] const Driver& driver() const { return at(of.number.drivers, index); }
  [[nodiscard]] Result<Rig> with(const Driver& changed) const {
    return setDriver(ui.state.document.rig(), of.ref, changed, index);
  }
  [[nodiscard]] Result<Rig> with(const Curve& curve) const {
    Driver changed = driver();
    changed.curve = curve;
    return with(changed);
  }
};

Curve curveAtStart(const DriverRow& row) {
  const Rig& start = row.ui.state.document.commands.rigOfStep();
  const std::optional<NumberRef> ref = refOf(start, held(row.ui.state.document.rig(), row.of.ref));
  const AnimatedNumber* number = ref ? animationOf(start, *ref) : nullptr;
  const auto index = static_cast<std::size_t>(row.index);
  return number != nullptr && index < number->drivers.size() ? number->drivers[index].curve : row.driver().curve;
}

void pointFields(const DriverRow& row, int point) {
  const Curve& curve = row.driver().curve;
  if (point < 0 || point >= static_cast<int>(curve.points.size())) return;
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - gap) / 2.0f;
  for (int axis = 0; axis < 2; ++axis) {
    if (axis == 1) ImGui::SameLine(0.0f, gap);
    const std::string id = row.id + (axis == 0 ? "/point.x" : "/point.y");
    const Shown shown =
        axis == 0 ? shownInputs(row.driver().input.kind) : shownValues(row.of.ref.parameter, row.driver().mode);
    float value = shown.scale * at(curve.points, point)[axis];
    Typing typing;
    NumberLook look{shown.format, 0.01f * std::max(std::abs(value), 0.1f)};
    look.typing = &typing;
    ImGui::SetNextItemWidth(width);
    const bool edited = numberField(("##" + id).c_str(), value, look);
    editField(row.ui, id, ("Point of the driver of " + row.words).c_str(), edited, [&] {
      Curve changed = curve;
      at(changed.points, point)[axis] = value / shown.scale;
      return row.with(changed);
    });
    if (!typing.refusal.empty()) refuse(row.ui.state, errorAt({}, typing.refusal));
    tooltip(row.ui, axis == 0 ? "The input at the chosen point" : "The curve's value at the chosen point");
  }
}

void driverCurve(const DriverRow& row) {
  PanelUi& ui = row.ui;
  const DriverInputKind kind = row.driver().input.kind;
  const std::string label = "Curve of " + row.words;
  CurveView view;
  view.id = row.id + "/curve";
  view.place = {held(ui.state.document.rig(), row.of.ref), row.index, -1};
  view.now = row.now;
  view.inputText = [kind](float x) { return inputText(kind, x); };
  view.valueText = [&](float y) { return valueText(row.of.ref.parameter, row.driver().mode, y); };
  view.label = label.c_str();
  view.changed = [&](const Curve& curve) { return row.with(curve); };
  drawCurveEditor(ui, row.driver().curve, curveAtStart(row), view);
  CurvePoint chosen = ui.state.open.animate.chosen;
  const int point = chosen.point;
  chosen.point = -1;
  if (chosen == view.place) pointFields(row, point);
}

/// @return false if the rig has changed, so that what was read from it is outdated
bool driverRow(const DriverRow& row) {
  PanelUi& ui = row.ui;
  const Driver& driver = row.driver();
  const std::string input = wordsFor(driver.input, ui.state.character().skeleton);
  const std::string reading = row.now ? inputText(driver.input.kind, *row.now) : "off";
  const float readingWidth = ImGui::CalcTextSize(reading.c_str()).x + ImGui::GetStyle().ItemSpacing.x;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(fitted(input, besideButton() - readingWidth).c_str());
  ui.widgets.note(row.id);
  tooltip(ui, row.now ? "Drives " + row.words : "Off: this character has no " + input);
  ImGui::SameLine(ImGui::GetCursorPosX() + besideButton() - readingWidth + ImGui::GetStyle().ItemSpacing.x);
  mutedText(reading.c_str());
  if (removeButton(ui, row.id + "/remove", "Remove this driver")) {
    edit(ui.state, "Remove driver of " + row.words, removeDriver(ui.state.document.rig(), row.of.ref, row.index));
    return false;
  }
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - gap) / 2.0f;
  Driver changed = driver;
  if (const auto mode = choice(ui, row.id + "/mode", driver.mode, kModes, width, kModeHint)) changed.mode = *mode;
  ImGui::SameLine(0.0f, gap);
  if (const auto kind = choice(ui, row.id + "/kind", driver.curve.kind, kCurveKinds, width, kKindHint)) {
    changed.curve.kind = *kind;
  }
  if (!(changed == driver)) {
    edit(ui.state,
         std::string(changed.mode != driver.mode ? wordFor(changed.mode) : wordFor(changed.curve.kind)) + ": " +
             row.words,
         row.with(changed));
    return false;
  }
  driverCurve(row);
  return true;
}

/// To the key before (-1) or after (1) the current time.
void jump(PanelUi& ui, const KeyTrack& track, int direction) {
  const float now = timeNow(ui.state);
  std::optional<float> found;
  for (const glm::vec2& key : track.curve.points) {
    const float ahead = static_cast<float>(direction) * (key.x - now);
    if (ahead > kSameKey && (!found || ahead < static_cast<float>(direction) * (*found - now))) found = key.x;
  }
  Transport& transport = ui.state.open.transport;
  if (!found) return;
  transport.time = std::min(static_cast<double>(*found), clipDuration(transport, ui.state.character()));
  transport.playing = false;
}

/// @return false as driverRow.
bool trackRow(PanelUi& ui, const Animated& of, const KeyTrack& track) {
  const std::string id = of.id() + "/keys/" + track.clip;
  const Rig& rig = ui.state.document.rig();
  const std::array refs{of.ref};
  const std::string number = wordsFor(rig, refs);
  const std::size_t count = track.curve.points.size();
  const std::string clip = track.clip.empty() ? "every clip" : track.clip;
  const std::string text = std::to_string(count) + (count == 1 ? " key in " : " keys in ") + clip;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(fitted(text, besideButton()).c_str());
  ui.widgets.note(id);
  tooltip(ui, text + "\nIn this clip the keys of " + number + " replace the number.");
  if (removeButton(ui, id + "/remove", "Remove all keys of " + number + " in " + clip)) {
    edit(ui.state, "Remove keys of " + number + " in " + clip, removeKeys(rig, of.ref, track.clip));
    return false;
  }
  const float side = ImGui::GetFrameHeight();
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = ImGui::GetContentRegionAvail().x - 2.0f * (side + gap);
  if (const auto kind = choice(ui, id + "/kind", track.curve.kind, kCurveKinds, width, kKindHint)) {
    edit(ui.state, std::string(wordFor(*kind)) + ": keys of " + number, setKeyKind(rig, of.ref, track.clip, *kind));
    return false;
  }
  const bool shows = track.clip.empty() ? ui.state.open.transport.clip >= 0 : track.clip == clipNow(ui.state);
  ImGui::BeginDisabled(!shows);
  ImGui::SameLine(0.0f, gap);
  const char* elsewhere = "\nNot available: another clip shows";
  const auto hint = [&](const char* words) { return std::string(words) + (shows ? "" : elsewhere); };
  if (iconButton(ui, id + "/previous", Icon::kPrevious, false, side, hint("To the key before"))) jump(ui, track, -1);
  ImGui::SameLine(0.0f, gap);
  if (iconButton(ui, id + "/next", Icon::kNext, false, side, hint("To the key after"))) jump(ui, track, 1);
  ImGui::EndDisabled();
  return true;
}

/// @return false as driverRow.
bool numberRows(PanelUi& ui, const Animated& of) {
  const std::array refs{of.ref};
  std::string words = wordsFor(ui.state.document.rig(), refs);
  const std::string title = sinew::wordsFor(of.ref.parameter);
  const std::string now = valueText(of.ref.parameter, DriverMode::kReplace, numberNow(ui.state, of.ref));
  heading(ui, title.c_str());
  tooltip(ui, words);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(now.c_str()).x);
  mutedText(now.c_str());
  ui.widgets.note(of.id() + "/now");
  tooltip(ui, "The number now");
  for (int i = 0; i < static_cast<int>(of.number.drivers.size()); ++i) {
    const DriverInput& input = at(of.number.drivers, i).input;
    const DriverRow row{ui,
                        of,
                        i,
                        of.id() + "/" + std::to_string(i),
                        words + " by " + wordsFor(input, ui.state.character().skeleton),
                        inputNow(ui.state, input)};
    if (!driverRow(row)) return false;
  }
  return std::ranges::all_of(of.number.keys, [&](const KeyTrack& track) { return trackRow(ui, of, track); });
}

std::string countText(const std::vector<Animated>& all) {
  std::size_t drivers = 0;
  std::size_t keyed = 0;
  for (const Animated& one : all) {
    drivers += one.number.drivers.size();
    keyed += one.number.keys.empty() ? 0 : 1;
  }
  std::string text;
  if (drivers > 0) text = std::to_string(drivers) + (drivers == 1 ? " driver" : " drivers");
  if (keyed > 0)
    text += (text.empty() ? "" : ", ") + std::to_string(keyed) + (keyed == 1 ? " keyed number" : " keyed numbers");
  return text;
}

/// Whether the section of these owners was requested.
bool isAsked(const AnimateState& animate, bool ofSurface) {
  const ParameterOwner owner = ownerOf(animate.chosen.number.parameter);
  if (!animate.sectionWanted || owner == ParameterOwner::kMorph || owner == ParameterOwner::kLink) return false;
  return ofSurface == (owner == ParameterOwner::kSurface);
}

/// @param of  the owner of the keys and drivers
void drawSection(PanelUi& ui, const std::string& id, const std::vector<Animated>& all, bool ofSurface,
                 const std::string& of) {
  AnimateState& animate = ui.state.open.animate;
  const bool asked = isAsked(animate, ofSurface);
  if (all.empty()) {
    if (asked) animate.sectionWanted = false;
    return;
  }
  bool& open = ui.state.view.inspector.animationOpen;
  beginRow(ui, kAnimation);
  const std::string text = countText(all);
  if (ImGui::Button((fitted(text, ImGui::GetContentRegionAvail().x - ui.px(12)) + "##" + id).c_str(), {-1.0f, 0})) {
    open = !open;
  }
  ui.widgets.note(id);
  tooltip(ui, text + "\nShow or hide the drivers and keys " + of + ".");
  if (asked && open) {  // Once there are rows to scroll to.
    ImGui::SetScrollHereY(0.0f);
    animate.sectionWanted = false;
  }
  open = open || asked;
  if (!open) return;
  ImGui::PushID(id.c_str());
  for (const Animated& one : all) {
    ImGui::Dummy({0.0f, ui.px(1)});
    if (!numberRows(ui, one)) break;
  }
  ImGui::PopID();
}

}  // namespace

void drawAnimationRows(PanelUi& ui, const Subjects& subjects) {
  drawSection(ui, kAnimation.id, animatedOf(subjects), false, "of the active muscle and its line");
}

void drawSurfaceAnimation(PanelUi& ui) {
  std::vector<Animated> all;
  addAll(all, ui.state.document.rig().surface.animated, 0);
  drawSection(ui, kSurfaceAnimation.id, all, true, "of the surface");
}

void drawLinkAnimation(PanelUi& ui, int link) {
  std::vector<Animated> all;
  addAll(all, at(ui.state.document.rig().links, link).animated, link);
  ImGui::PushID(link);
  for (const Animated& one : all) {
    if (!numberRows(ui, one)) break;
  }
  ImGui::PopID();
}

void drawMorphAnimation(PanelUi& ui, int morph) {
  std::vector<Animated> all;
  addAll(all, at(ui.state.document.rig().morphs, morph).animated, morph);
  AnimateState& animate = ui.state.open.animate;
  if (animate.sectionWanted && animate.chosen.number.morph == at(ui.state.document.rig().morphs, morph).name) {
    ImGui::SetScrollHereY(0.0f);
    animate.sectionWanted = false;
  }
  ImGui::PushID(morph);
  for (const Animated& one : all) {
    if (!numberRows(ui, one)) break;
  }
  ImGui::PopID();
}

}  // namespace sinew::app
