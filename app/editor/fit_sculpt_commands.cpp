// app/editor/fit_sculpt_commands.cpp: the file, the job and its step, and the picture of what is left.
#include "app/editor/fit_sculpt_commands.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <system_error>
#include <utility>

#include "app/document/shown_names.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/muscle_set_commands.h"
#include "core/files/sculpt_file.h"
#include "core/surface/patches/patch.h"

namespace sinew::app {
namespace {

constexpr const char* kFitLabel = "Fit to a sculpt";

void tell(EditorState& state, const SculptFitState& fit) {
  for (const std::string& name : fit.result->heldBack)
    addQuietly(state.session, MessageKind::kNote, name + " is held back: it would leave the flesh");
  if (!fit.findings.empty())
    addMessage(state.session, MessageKind::kWarning,
               withCount(fit.findings.size(), "finding") + " after the fit: see Play > Check muscles");
}

}  // namespace

void showSculptDialog(EditorState& state) {
  const std::filesystem::path& last = state.open.sculptFit.file;
  std::error_code ignored;
  const auto folder = std::filesystem::absolute(state.document.file(), ignored).parent_path();
  showPathDialog(state, DialogKind::kSculpt, last.empty() ? folder : last.parent_path(), last.filename().string());
}

std::string takeSculpt(EditorState& state, const std::filesystem::path& file) {
  Result<ControlMesh> sculpt = loadSculpt(file);
  if (!sculpt) return sculpt.error().plainText();
  closePanels(state);
  SculptFitState& fit = state.open.sculptFit;
  fit.shown = true;
  fit.file = file;
  fit.sculpt = std::make_shared<const ControlMesh>(std::move(sculpt).value());
  fit.result.reset();
  startFit(state);
  return "";
}

bool isFitting(const EditorState& state) { return state.open.sculptFit.job.has_value(); }

double fitShare(const EditorState& state) { return isFitting(state) ? state.open.sculptFit.job->share() : 0.0; }

bool fitIsCurrent(const EditorState& state) {
  const SculptFitState& fit = state.open.sculptFit;
  return fit.result && fit.revision == state.document.commands.revision();
}

void startFit(EditorState& state) {
  SculptFitState& fit = state.open.sculptFit;
  if (!fit.sculpt) return;
  fit.again = fitIsCurrent(state);
  if (!fit.again) fit.start = state.document.rig();
  fit.revision = state.document.commands.revision();
  fit.complaint.clear();
  SculptFitOrder order;
  order.rig = fit.start;
  order.character = state.document.character;
  order.plan = state.document.mirror ? state.document.mirror : std::make_shared<const MirrorPlan>();
  order.motions = motionsOf(state);
  order.sculpt = fit.sculpt;
  order.options = {fit.hold, fit.carves, fit.mirror, {}};
  fit.job.emplace(std::move(order));
}

void cancelFit(EditorState& state) {
  if (isFitting(state)) state.open.sculptFit.job->cancel();
}

void followFit(EditorState& state) {
  SculptFitState& fit = state.open.sculptFit;
  if (!isFitting(state) || !fit.job->isDone() || isBusy(state)) return;
  SculptFitOutcome outcome = fit.job->take();
  fit.job.reset();
  if (!outcome.fit) {
    const bool canceled = outcome.fit.error().reason == kFitCanceled;
    if (!canceled) fit.complaint = outcome.fit.error().plainText();
    if (canceled) say(state, "The fit was cancelled");
    return;
  }
  CommandStack& commands = state.document.commands;
  if (fit.revision != commands.revision()) {
    fit.complaint = "The rig was edited meanwhile: fit again";
    return;
  }
  if (fit.again) commands.undo();
  Rig fitted = outcome.fit.value().rig;
  if (!edit(state, kFitLabel, std::move(fitted))) return;
  fit.result = std::move(outcome.fit).value();
  fit.findings = std::move(outcome.findings);
  fit.revision = commands.revision();
  ++fit.made;
  tell(state, fit);
}

void closeFit(EditorState& state) {
  cancelFit(state);
  state.open.sculptFit.shown = state.open.sculptFit.showsLeft = false;
}

bool showsLeft(const EditorState& state) {
  const SculptFitState& fit = state.open.sculptFit;
  return state.hasCharacter() && fit.shown && fit.showsLeft && fitIsCurrent(state) && fit.leftOf > 0;
}

void updateLeft(EditorState& state) {
  SculptFitState& fit = state.open.sculptFit;
  if (!fit.shown || !fit.showsLeft || !fitIsCurrent(state)) return;
  const std::size_t live = state.live->revision() + 1;
  if (fit.leftOf == live && fit.leftMade == fit.made) return;
  const Surface& surface = state.live->surface();
  if (!surface.refinement || fit.result->left.size() != state.character().mesh.positions.size()) return;
  fit.surface = surface;
  interpolateValues(state.character().mesh, *surface.refinement, fit.result->left, fit.surface.displacement);
  for (float& each : fit.surface.displacement) each *= state.character().height;
  fit.leftOf = live;
  fit.leftMade = fit.made;
  ++fit.pictures;
}

}  // namespace sinew::app
