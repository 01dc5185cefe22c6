// app/editor/export_error.cpp: compares the export with the live surface vertex by vertex at the current time.

#include "app/editor/export_error.h"

#include <algorithm>
#include <limits>
#include <span>

#include <glm/geometric.hpp>

#include "app/document/export_report.h"
#include "app/editor/animate.h"
#include "app/editor/commands.h"
#include "app/editor/fit_sculpt_commands.h"
#include "app/viewport/render/occlusion.h"
#include "app/viewport/render/view.h"
#include "core/geometry/at.h"
#include "core/rig/motion_clip.h"

namespace sinew::app {
namespace {

constexpr float kSeenAround = 0.12f;  ///< Fraction of the height framed around the largest error.
constexpr float kGapBeside = 0.15f;   ///< Fraction of the height between the two meshes.
constexpr std::uint64_t kOwnRevisions = std::uint64_t{1} << 40U;  ///< Above the live surface's revisions.

/// Weighted by area.
void findNormals(Surface& surface) {
  std::ranges::fill(surface.normals, glm::vec3(0.0f));
  for (const auto& corners : surface.refinement->triangles) {
    const glm::vec3& a = at(surface.positions, corners[0]);
    const glm::vec3 normal = glm::cross(at(surface.positions, corners[1]) - a, at(surface.positions, corners[2]) - a);
    for (const int corner : corners) at(surface.normals, corner) += normal;
  }
  for (glm::vec3& normal : surface.normals) normal = normalizeOr(normal, glm::vec3(0.0f, 1.0f, 0.0f));
  surface.shadingNormals.clear();
}

/// The exported mesh moved aside, with the live surface's colors.
Surface standingAside(std::vector<glm::vec3> placed, const Surface& live, const glm::vec3& aside) {
  Surface surface;
  surface.refinement = live.refinement;
  surface.displacement = live.displacement;
  surface.positions = std::move(placed);
  surface.normals.resize(surface.positions.size());
  findNormals(surface);
  for (glm::vec3& point : surface.positions) point += aside;
  return surface;
}

/// Spreads positions of control vertices over the refined ones.
std::vector<glm::vec3> onAll(std::vector<glm::vec3> placed, const Surface& surface, const ControlMesh& mesh) {
  if (placed.size() == surface.positions.size()) return placed;
  std::vector<glm::vec3> all(surface.positions.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<float> values;
    for (const glm::vec3& point : placed) values.push_back(point[axis]);
    const std::vector<float> spread = spreadOverRefinement(values, mesh, *surface.refinement);
    for (std::size_t v = 0; v < all.size(); ++v) all[v][axis] = spread[v];
  }
  return all;
}

Bounds both(const Bounds& box, const glm::vec3& aside) {
  return {glm::min(box.low, box.low + aside), glm::max(box.high, box.high + aside)};
}

/// Offset to the camera's right along the floor that separates the meshes in the bind pose and now.
glm::vec3 asideOf(const EditorState& state) {
  const Camera& camera = state.view.tools.camera;
  const CameraStand& stand = camera.transition ? camera.transition->to : camera.stand;
  const glm::vec3 right = cameraAxes(stand.yaw, 0.0f)[0];
  const auto widthOf = [&](std::span<const glm::vec3> points) {
    float least = std::numeric_limits<float>::max(), most = std::numeric_limits<float>::lowest();
    for (const glm::vec3& point : points) {
      const float along = glm::dot(point, right);
      least = std::min(least, along);
      most = std::max(most, along);
    }
    return std::max(most - least, 0.0f);
  };
  const Character& character = state.character();
  const float width = std::max(widthOf(character.mesh.positions), widthOf(state.live->surface().positions));
  return (width + kGapBeside * character.height) * right;
}

}  // namespace

void keepExport(EditorState& state, const ExportOutcome& outcome) {
  if (!outcome.result.ok()) return;
  const ExportReport& report = outcome.result.value();
  const ErrorFigures* const largest = farthestOf(report);
  ExportErrorState& error = state.session.exportError;
  error = {};
  if (largest == nullptr || playedBy(report) == nullptr) return;
  error.last =
      LastExport{outcome.file, outcome.order.source.character, outcome.order.source.rig, playedBy(report), *largest};
  outcome.order.settings.detail.apply(error.last->rig.smoothing);
}

bool hasExportError(const EditorState& state) {
  const auto& last = state.session.exportError.last;
  return state.hasCharacter() && last && last->character == state.document.character;
}

bool showsExportError(const EditorState& state) {
  return hasExportError(state) && state.session.exportError.shown && state.session.exportError.madeOf > 0;
}

void toggleExportError(EditorState& state) { state.session.exportError.shown = !state.session.exportError.shown; }

void showExported(EditorState& state, ExportedView view) {
  state.session.exportError.shown = true;
  state.session.exportError.view = view;
  frameExportBeside(state);
}

bool showsExportBeside(const EditorState& state) {
  const ExportErrorState& error = state.session.exportError;
  return hasExportError(state) && error.shown && error.view == ExportedView::kBoth;
}

void toggleExportBeside(EditorState& state) {
  showExported(state, showsExportBeside(state) ? ExportedView::kLive : ExportedView::kBoth);
}

bool frameExportBeside(EditorState& state) {
  if (!showsExportBeside(state)) return false;
  ExportErrorState& error = state.session.exportError;
  error.aside = asideOf(state);
  frameInPicture(state, both(boundsOf(state.live->surface().positions), error.aside), true);
  return true;
}

void showLargestError(EditorState& state) {
  if (!hasExportError(state)) return;
  ExportErrorState& error = state.session.exportError;
  const ErrorPlace& place = error.last->largest.farthest;
  const int clip = findClip(state.character(), place.clip);
  if (clip < 0) return;
  Transport& transport = state.open.transport;
  chooseClip(transport, clip, state.character());
  transport.time = static_cast<double>(place.time);
  transport.playing = false;
  error.shown = true;
  state.live->movePose(transport);
  std::vector<glm::vec3> placed;
  error.last->played->place(state.live->pose(), place.clip, place.time, placed);
  const glm::vec3 around(kSeenAround * state.character().height);
  const glm::vec3& middle = at(placed, place.vertex);
  if (showsExportBeside(state)) error.aside = asideOf(state);
  const Bounds seen{middle - around, middle + around};
  frameInPicture(state, showsExportBeside(state) ? both(seen, error.aside) : seen, true);
}

void updateExportError(EditorState& state) {
  ExportErrorState& error = state.session.exportError;
  if (!error.shown || !hasExportError(state)) return;
  const std::size_t live = state.live->revision() + 1;
  if (error.madeOf == live && error.madeView == error.view && error.madeAside == error.aside) return;
  if (!error.smoother) {
    error.smoother.emplace(error.last->character);
    if (!error.smoother->prepare(error.last->rig)) return error.last.reset();
  }
  const Pose& pose = state.live->pose();
  error.smoother->smooth(pose, error.surface);
  const float time = static_cast<float>(state.open.transport.time);
  std::vector<glm::vec3> placed;
  error.last->played->place(pose, clipNow(state), time, placed);
  placed = onAll(std::move(placed), error.surface, state.character().mesh);
  error.surface.displacement.resize(placed.size());
  float most = 0.0f;
  for (std::size_t v = 0; v < placed.size(); ++v) {
    error.surface.displacement[v] = glm::distance(placed[v], error.surface.positions[v]);
    most = std::max(most, error.surface.displacement[v]);
  }
  error.largestNow = 100.0f * most / state.character().height;
  if (error.view == ExportedView::kBoth) {
    error.beside = standingAside(std::move(placed), error.surface, error.aside);
  } else if (error.view == ExportedView::kExported) {
    error.surface.positions = std::move(placed);
    findNormals(error.surface);
  }
  error.madeOf = live;
  error.madeView = error.view;
  error.madeAside = error.aside;
  ++error.revision;
}

float exportErrorRange(const EditorState& state) {
  return std::max(static_cast<float>(state.session.exportError.last->largest.largest), 1e-3f);
}

std::string largestErrorText(const EditorState& state) {
  return "largest " + largestText(state.session.exportError.last->largest);
}

const Surface& shownSurface(const EditorState& state) {
  if (showsLeft(state)) return state.open.sculptFit.surface;
  return showsExportError(state) ? state.session.exportError.surface : state.live->surface();
}

const Surface* besideSurface(const EditorState& state) {
  const ExportErrorState& error = state.session.exportError;
  const bool shown = !showsLeft(state) && showsExportError(state) && error.madeView == ExportedView::kBoth;
  return shown ? &error.beside : nullptr;
}

std::uint64_t shownRevision(const EditorState& state) {
  if (showsLeft(state)) return 2 * kOwnRevisions + state.open.sculptFit.pictures;
  return showsExportError(state) ? kOwnRevisions + state.session.exportError.revision : state.live->revision();
}

}  // namespace sinew::app
