// app/panels/inspector/surface_panel.cpp: how the surface is made: mode, iso value, skin blend; depth, patch,
// projection.

#include <imgui.h>
#include "app/panels/inspector/inspector.h"
#include "app/panels/shared/field_edit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/mesh/creases.h"
#include "core/rig/rig_edit.h"

namespace sinew::app {
namespace {

constexpr int kDepthOfSlider = 8;
constexpr float kIsoRange[] = {0.05f, 0.9f};
constexpr float kBlendRange[] = {0.5f, 15.0f};  // Per cent of the height.

/// A choice among named values. @param apply  (value) -> Result<Rig>
template <class Kind, std::size_t kCount, class Apply>
void choiceRow(PanelUi& ui, const char* label, const std::string& id, Kind current,
               const std::array<Kind, kCount>& kinds, const char* hint, Apply apply) {
  beginRow(ui, label);
  const bool open = ImGui::BeginCombo(("##" + id).c_str(), nameOf(current));
  ui.widgets.note(id);
  if (!open) {
    tooltip(ui, hint);
    return;
  }
  for (const Kind kind : kinds) {
    const bool chosen = ImGui::Selectable(nameOf(kind), kind == current);
    ui.widgets.note(id + "/" + nameOf(kind));
    if (chosen && kind != current) edit(ui.state, label, apply(kind));
  }
  ImGui::EndCombo();
}

/// The slider is shown but not moved while the depth follows the size on screen.
template <class Changed>
void depthRow(PanelUi& ui, const SmoothingSettings& before, Changed changed) {
  beginRow(ui, "Depth");
  const char* boxLabel = "Auto";
  const float box = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + ImGui::CalcTextSize(boxLabel).x;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - box - ImGui::GetStyle().ItemSpacing.x);
  int depth = before.autoDepth ? ui.state.live->depth() : before.depth;
  const int deepest = std::max(kDepthOfSlider, depth);
  ImGui::BeginDisabled(before.autoDepth);
  beginFilledSlider(ui, static_cast<float>(depth) / static_cast<float>(deepest));
  const bool edited = ImGui::SliderInt("##depth", &depth, 1, deepest, before.autoDepth ? "auto: %d" : "%d",
                                       ImGuiSliderFlags_AlwaysClamp);
  endFilledSlider();
  editField(ui, "smoothing/depth", "Depth", edited && !before.autoDepth,
            [&] { return changed([&](SmoothingSettings& s) { s.depth = depth; }); });
  ImGui::EndDisabled();
  tooltip(ui, "Every triangle of the file becomes depth x depth triangles.");
  ImGui::SameLine();
  bool automatic = before.autoDepth;
  const bool switched = ImGui::Checkbox(boxLabel, &automatic);
  ui.widgets.note("smoothing/auto");
  tooltip(ui, "Chooses the depth from the character's size on screen. Exported files use the depth set here.");
  if (switched) edit(ui.state, "Auto depth", changed([&](SmoothingSettings& s) { s.autoDepth = automatic; }));
}

template <class Changed>
void creaseRow(PanelUi& ui, const SmoothingSettings& before, Changed changed) {
  beginRow(ui, "Crease");
  float degrees = before.creaseAngle;
  beginFilledSlider(ui, degrees / kNoCreases);
  const bool edited = ImGui::SliderFloat("##crease", &degrees, 0.0f, kNoCreases,
                                         degrees >= kNoCreases ? "smooth" : "%.0f deg", ImGuiSliderFlags_AlwaysClamp);
  endFilledSlider();
  editField(ui, "smoothing/crease", "Crease angle", edited,
            [&] { return changed([&](SmoothingSettings& s) { s.creaseAngle = degrees; }); });
  tooltip(ui, "Faces that meet at a sharper angle than this keep a hard edge. 180: smooth everywhere.");
}

/// Why `replace` shows less than the designer placed: it needs muscles that wrap the body.
void replaceNote(PanelUi& ui) {
  const SmoothingReport& report = ui.state.live->surface().report;
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
  choiceRow(ui, "Mode", "surface/mode", before.mode, std::array{SurfaceMode::kSwell, SurfaceMode::kReplace},
            "swell: the skin rises over the muscles. replace: the muscles become the surface.",
            [&](SurfaceMode mode) { return changed([&](SurfaceSettings& s) { s.mode = mode; }); });
  replaceNote(ui);
  beginRow(ui, "Iso value");
  float iso = before.iso;
  beginFilledSlider(ui, (iso - kIsoRange[0]) / (kIsoRange[1] - kIsoRange[0]));
  bool edited = ImGui::SliderFloat("##iso", &iso, kIsoRange[0], kIsoRange[1], "%.3f");
  endFilledSlider();
  editField(ui, "surface/iso", "Iso value", edited, [&] { return changed([&](SurfaceSettings& s) { s.iso = iso; }); });
  tooltip(ui,
          "The value of the field at which blended muscles have their surface. A lone muscle keeps its radii; higher "
          "blends tighter.");
  beginRow(ui, "Skin blend");
  float percent = before.skinBlend * 100.0f;
  beginFilledSlider(ui, std::log(percent / kBlendRange[0]) / std::log(kBlendRange[1] / kBlendRange[0]));
  edited =
      ImGui::SliderFloat("##blend", &percent, kBlendRange[0], kBlendRange[1], "%.1f %%", ImGuiSliderFlags_Logarithmic);
  endFilledSlider();
  editField(ui, "surface/skin-blend", "Skin blend", edited,
            [&] { return changed([&](SurfaceSettings& s) { s.skinBlend = percent / 100.0f; }); });
  tooltip(ui,
          "How softly the skin rises into a muscle, in percent of the character's height. Small muscles blend over "
          "their own size at most.");
}

void drawSmoothingPanel(PanelUi& ui) {
  const SmoothingSettings before = ui.state.document.rig().smoothing;
  const auto changed = [&](auto change) {
    SmoothingSettings settings = before;
    change(settings);
    return setSmoothing(ui.state.document.rig(), settings);
  };
  depthRow(ui, before, changed);
  choiceRow(ui, "Patch", "smoothing/patch", before.patch,
            std::array{PatchKind::kPn, PatchKind::kPhong, PatchKind::kSpherigon, PatchKind::kFlat},
            "How the skin curves between the file's vertices.",
            [&](PatchKind patch) { return changed([&](SmoothingSettings& s) { s.patch = patch; }); });
  choiceRow(ui, "Projection", "smoothing/projection", before.projection,
            std::array{ProjectionKind::kNewton, ProjectionKind::kBisection, ProjectionKind::kAnalytic},
            "How points on the surface are found.",
            [&](ProjectionKind kind) { return changed([&](SmoothingSettings& s) { s.projection = kind; }); });
  creaseRow(ui, before, changed);
}

}  // namespace sinew::app
