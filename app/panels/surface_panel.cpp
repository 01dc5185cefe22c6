// app/panels/surface_panel.cpp: the panels Surface and Smoothing.

#include "app/panels/field_edit.h"
#include "app/panels/inspector.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/geometry/normals.h"
#include "sinew/rig/rig_edit.h"

namespace sinew::app {
namespace {

Possible uniform(const EditorState& state) {
  return withCharacter(state).also(state.document.rig().smoothing.detail == DetailKind::kUniform,
                                   "Choose the detail Uniform first");
}
Possible adaptive(const EditorState& state) {
  return withCharacter(state).also(state.document.rig().smoothing.detail == DetailKind::kAdaptive,
                                   "Choose the detail Adaptive first");
}

const Control kMode{"surface/mode", "Mode", "of the surface swell replace"};
const Control kIso{"surface/iso", "Tightness", "iso value threshold wrap"};
const Control kGrooves{"surface/grooves", "Grooves", "soft crisp creases between muscles not linked width"};
const Control kSkinBlend{"surface/skin-blend", "Skin blend", "soft rise transition"};
const Control kDepth{"smoothing/depth", "Depth", "subdivision level resolution fine", uniform};
const Control kTolerance{"smoothing/tolerance", "Tolerance", "adaptive error subdivision fine", adaptive};
const Control kAutoDetail{"smoothing/auto", "Automatic detail", "size on screen lod"};
const Control kDetail{"smoothing/detail", "Detail", "adaptive or uniform subdivision"};
const Control kPatch{"smoothing/patch", "Rounding", "patch curve smooth pn phong spherigon flat"};
const Control kCrease{"smoothing/crease", "Crease", "angle hard edge sharp normals"};

constexpr int kDepthOfSlider = 8;
constexpr const char* kAutoLabel = "Auto";
constexpr float kIsoRange[] = {0.05f, 0.9f};
constexpr float kBlendRange[] = {0.5f, 15.0f};   // Per cent of the height.
constexpr float kGroovesRange[] = {0.0f, 5.0f};  // Per cent of the height.

/// The name of a value in the interface, and its effect, with the technical term in brackets.
struct Word {
  const char* name;
  const char* hint;
};

Word surfaceWord(SurfaceMode mode) {
  if (mode == SurfaceMode::kSwell) return {"Swell", "The skin rises over the muscles"};
  return {"Replace", "The muscles become the surface"};
}

Word surfaceWord(PatchKind patch) {
  switch (patch) {
    case PatchKind::kPn:
      return {"Smooth", "Round, along the normals of the vertices (PN triangles)"};
    case PatchKind::kPhong:
      return {"Soft", "Rounder than flat, with the least work (Phong tessellation)"};
    case PatchKind::kSpherigon:
      return {"Full", "As parts of spheres: the fullest shape (spherigon)"};
    case PatchKind::kFlat:
      break;
  }
  return {"Flat", "The triangles of the file as they are"};
}

Word surfaceWord(DetailKind detail) {
  if (detail == DetailKind::kAdaptive)
    return {"Adaptive", "Fine where muscles shape the skin, coarse where it is flat"};
  return {"Uniform", "Every triangle of the file becomes depth x depth triangles (N-adic)"};
}

/// A choice among named values. @param apply  (value) -> Result<Rig>
template <class Kind, std::size_t kCount, class Apply>
void choiceRow(PanelUi& ui, const Control& control, Kind current, const std::array<Kind, kCount>& kinds,
               const std::string& hint, Apply apply) {
  beginRow(ui, control);
  const std::string id = control.id;
  const bool open = ImGui::BeginCombo(("##" + id).c_str(), surfaceWord(current).name);
  ui.widgets.note(id);
  if (!open) {
    tooltip(ui, hint + "\n" + surfaceWord(current).name + ": " + surfaceWord(current).hint + ".");
    return;
  }
  for (const Kind kind : kinds) {
    const bool chosen = ImGui::Selectable(surfaceWord(kind).name, kind == current);
    ui.widgets.note(id + "/" + nameOf(kind));
    tooltip(ui, surfaceWord(kind).hint);
    if (chosen && kind != current) edit(ui.state, control.label, apply(kind));
  }
  ImGui::EndCombo();
}

/// The check box that lets depth or tolerance follow the size on screen.
template <class Changed>
void autoBox(PanelUi& ui, const SmoothingSettings& before, const char* hint, Changed changed) {
  ImGui::SameLine();
  bool automatic = before.autoDepth;
  const bool switched = ImGui::Checkbox(kAutoLabel, &automatic);
  ui.widgets.note(kAutoDetail.id);
  tooltip(ui, hint);
  if (switched) edit(ui.state, "Auto detail", changed([&](SmoothingSettings& s) { s.autoDepth = automatic; }));
}

float besideAutoBox() {
  const float box = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + ImGui::CalcTextSize(kAutoLabel).x;
  return ImGui::GetContentRegionAvail().x - box - ImGui::GetStyle().ItemSpacing.x;
}

/// The slider is disabled while the depth follows the size on screen.
template <class Changed>
void depthRow(PanelUi& ui, const SmoothingSettings& before, Changed changed) {
  beginRow(ui, kDepth);
  const float width = besideAutoBox();
  const char* format = before.autoDepth && width > ui.px(64) ? "auto: %.0f" : "%.0f";
  ImGui::SetNextItemWidth(width);
  const int shown = before.autoDepth ? ui.state.live->depth() : before.depth;
  auto depth = static_cast<float>(shown);
  NumberLook look{format, 0.0f, 1.0f, static_cast<float>(std::max(kDepthOfSlider, shown)), 1.0f, true};
  Typing typing;
  look.typing = &typing;
  ImGui::BeginDisabled(before.autoDepth);
  const bool edited = numberSlider(ui, "##depth", depth, look);
  editNumber(
      ui, kDepth.id, kDepth.label, edited && !before.autoDepth, typing,
      [&] { return changed([&](SmoothingSettings& s) { s.depth = static_cast<int>(depth); }); },
      [](const Rig& rig) { return std::to_string(rig.smoothing.depth); });
  ImGui::EndDisabled();
  tooltip(ui, "How fine the skin is: every triangle of the file becomes depth x depth triangles.");
  autoBox(ui, before, "Chooses the depth from the character's size on screen. Exported files use the depth set here.",
          changed);
}

/// The tolerance of adaptive detail, percent of the height.
template <class Changed>
void toleranceRow(PanelUi& ui, const SmoothingSettings& before, Changed changed) {
  constexpr float kPercent = 100.0f;
  beginRow(ui, kTolerance);
  const float width = besideAutoBox();
  const char* format = before.autoDepth && width > ui.px(84) ? "auto: %.2f %%" : "%.2f %%";
  ImGui::SetNextItemWidth(width);
  float percent = kPercent * (before.autoDepth ? ui.state.live->tolerance() : before.tolerance);
  NumberLook look{format, 0.0f, kPercent * kLeastTolerance, kPercent * kMostTolerance, 0.01f, false, true};
  Typing typing;
  look.typing = &typing;
  ImGui::BeginDisabled(before.autoDepth);
  const bool edited = numberSlider(ui, "##tolerance", percent, look);
  editNumber(
      ui, kTolerance.id, kTolerance.label, edited && !before.autoDepth, typing,
      [&] { return changed([&](SmoothingSettings& s) { s.tolerance = percent / kPercent; }); },
      [](const Rig& rig) { return numberText("%.2f %%", kPercent * rig.smoothing.tolerance); });
  ImGui::EndDisabled();
  tooltip(ui, "How far triangles may lie off the smooth surface, per cent of the character's height.");
  autoBox(
      ui, before,
      "Chooses the tolerance from the character's size on screen: half a pixel. Exported files use the one set here.",
      changed);
}

template <class Changed>
void creaseRow(PanelUi& ui, const SmoothingSettings& before, Changed changed) {
  beginRow(ui, kCrease);
  float degrees = before.creaseAngle;
  const char* format = degrees >= kNoCreases ? "smooth" : "%.0f\xc2\xb0";
  NumberLook look{format, 0.0f, 0.0f, kNoCreases, 15.0f};
  Typing typing;
  look.typing = &typing;
  const bool edited = numberSlider(ui, "##crease", degrees, look);
  editNumber(
      ui, kCrease.id, "Crease angle", edited, typing,
      [&] { return changed([&](SmoothingSettings& s) { s.creaseAngle = degrees; }); },
      [](const Rig& rig) { return numberText("%.0f\xc2\xb0", rig.smoothing.creaseAngle); });
  tooltip(ui, "Faces that meet at a sharper angle than this keep a hard edge. 180: smooth everywhere.");
}

/// A number of the surface that keys and drivers can change, in percent of the character's height.
struct HeightShare {
  const Control& control;
  Parameter parameter;
  const float (&range)[2];
  bool logarithmic;
  const char* hint;
};

template <class Changed>
void heightShareRow(PanelUi& ui, const HeightShare& row, const SurfaceSettings& before, Changed changed) {
  beginRow(ui, row.control);
  constexpr float kPercent = 100.0f;
  const char* const id = row.control.id;
  const AnimatedField animated{{{row.parameter, 0}}, {kPercent}, "%.1f %%"};
  const AnimatedLook animation = lookOf(ui, animated);
  NumberLook look{animated.format, 0.0f, row.range[0], row.range[1], 0.5f, false, row.logarithmic};
  const auto menu = [&] {
    if (!ImGui::BeginPopupContextItem(id)) return;
    animationMenu(ui, animated);
    ImGui::EndPopup();
  };
  if (animation.beingSet) {
    look.speed = 0.02f;
    look.logarithmic = false;
    drawDrivenKeyField(ui, id, animated, look);
    return menu();
  }
  float percent = numberOf(before, row.parameter) * kPercent;
  look.clampTyped = false;
  Typing typing;
  look.typing = &typing;
  pushAnimatedColors(animation);
  const bool edited = numberSlider(ui, (std::string("##") + id).c_str(), percent, look);
  popAnimatedColors(ui, animation);
  notePointed(ui, animated);
  editNumber(
      ui, id, row.control.label, edited, typing,
      [&] { return changed([&](SurfaceSettings& s) { *numberIn(s, row.parameter) = percent / kPercent; }); },
      [&](const Rig& rig) { return numberText(look.format, kPercent * numberOf(rig.surface, row.parameter)); });
  tooltip(ui, animation.words + row.hint + "\nRight click: key, drive.");
  menu();
}

/// Explains why `replace` shows less than was placed: it needs muscles that wrap the body.
void replaceNote(PanelUi& ui) {
  const bool plays = ui.state.open.transport.playing;
  const SmoothingReport& report = plays ? ui.state.live->report() : ui.state.live->surface().report;
  if (report.mode != SurfaceMode::kReplace || report.unwrapped == 0) return;
  std::string text = "Muscles do not wrap this body: only skin inside a muscle rises, the rest stays as it is.";
  const auto carves = [](const Primitive& p) { return p.sign < 0; };
  if (std::ranges::any_of(ui.state.document.rig().primitives, carves)) {
    text += " Carves cut into muscles, not into bare skin.";
  }
  text += " Swell is made for muscles that lie in the skin.";
  ImGui::PushTextWrapPos(0.0f);
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  ui.widgets.note("surface/replace-note");
  ImGui::PopTextWrapPos();
}

}  // namespace

void drawSurfacePanel(PanelUi& ui) {
  const SurfaceSettings before = ui.state.document.rig().surface;
  const auto changed = [&](auto change) {
    SurfaceSettings settings = before;
    change(settings);
    return setSurface(ui.state.document.rig(), settings);
  };
  choiceRow(ui, kMode, before.mode, std::array{SurfaceMode::kSwell, SurfaceMode::kReplace},
            "How muscles show in the skin.",
            [&](SurfaceMode mode) { return changed([&](SurfaceSettings& s) { s.mode = mode; }); });
  replaceNote(ui);
  beginRow(ui, kIso);
  float iso = before.iso;
  NumberLook isoLook{"%.3f", 0.0f, kIsoRange[0], kIsoRange[1], 0.05f};
  isoLook.clampTyped = false;
  Typing typing;
  isoLook.typing = &typing;
  const bool edited = numberSlider(ui, "##iso", iso, isoLook);
  editNumber(
      ui, kIso.id, kIso.label, edited, typing, [&] { return changed([&](SurfaceSettings& s) { s.iso = iso; }); },
      [&](const Rig& rig) { return numberText(isoLook.format, rig.surface.iso); });
  tooltip(
      ui,
      "How tightly the skin lies around muscles that blend: higher is tighter. A muscle on its own keeps its radii. "
      "(Iso value of the field.)");
  heightShareRow(ui,
                 {kGrooves, Parameter::kGrooves, kGroovesRange, false,
                  "How soft the grooves between muscles that are not linked are, in percent of the character's height. "
                  "0: crisp."},
                 before, changed);
  heightShareRow(ui,
                 {kSkinBlend, Parameter::kSkinBlend, kBlendRange, true,
                  "How softly the skin rises into a muscle, in percent of the character's height. Small muscles blend "
                  "over their own size at most."},
                 before, changed);
  drawSurfaceAnimation(ui);
}

void drawSmoothingPanel(PanelUi& ui) {
  const SmoothingSettings before = ui.state.document.rig().smoothing;
  const auto changed = [&](auto change) {
    SmoothingSettings settings = before;
    change(settings);
    return setSmoothing(ui.state.document.rig(), settings);
  };
  if (before.detail == DetailKind::kAdaptive) toleranceRow(ui, before, changed);
  else depthRow(ui, before, changed);
  choiceRow(ui, kDetail, before.detail, std::array{DetailKind::kAdaptive, DetailKind::kUniform},
            "How finely the file's triangles are divided.",
            [&](DetailKind detail) { return changed([&](SmoothingSettings& s) { s.detail = detail; }); });
  choiceRow(ui, kPatch, before.patch,
            std::array{PatchKind::kPn, PatchKind::kPhong, PatchKind::kSpherigon, PatchKind::kFlat},
            "How the skin curves between the file's vertices (patch).",
            [&](PatchKind patch) { return changed([&](SmoothingSettings& s) { s.patch = patch; }); });
  creaseRow(ui, before, changed);
}

}  // namespace sinew::app
