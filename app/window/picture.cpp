// app/window/picture.cpp: the viewport's picture.

#include "app/window/picture.h"

#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <system_error>
#include <utility>

#include "app/editor/commands.h"
#include "app/editor/export_error.h"
#include "app/editor/hidden_bones.h"
#include "app/editor/layer_commands.h"
#include "app/editor/territory.h"
#include "app/viewport/render/picture_files.h"
#include "app/viewport/tools/axis_triad.h"
#include "app/viewport/tools/draw_tools.h"
#include "core/character/skinning.h"
#include "core/files/disk/atomic_file.h"

namespace sinew::app {
namespace {

constexpr double kRestSeconds = 0.2;  ///< A picture that has stood so long is refined.

/// All muscles, or the selected ones alone; these are shown whether muscles are switched on or not.
PictureKey keyOf(const EditorState& state, const View& view) {
  PictureKey key;
  key.document = state.session.documentsOpened;
  key.surface = shownRevision(state);
  key.view = view;
  key.display = state.view.display;
  key.display.look = state.session.preferences.look;
  if (showsExportError(state)) {
    key.display.shading = Shading::kHeat;
    key.display.surface = true;
    key.display.anatomy = false;
    key.display.heatRange = exportErrorRange(state) / 100.0f;
  }
  key.display.lineScale =
      state.frame.uiScale * static_cast<float>(state.frame.viewportPixels.x) / std::max(state.frame.viewport.z, 1.0f);
  key.display.skeleton = key.display.skeleton || state.view.tools.tool == ToolKind::kPose;
  key.shapes = shownShapes(state, state.view.display.primitives || state.view.display.anatomy);
  key.display.primitives = !key.shapes.empty();
  key.territory = shownTerritoryWeights(state);
  key.territoryBones = shownTerritory(state);
  key.display.skeleton = key.display.skeleton || !key.territoryBones.empty();
  key.litParts = litParts(state);
  key.selectedBone = state.document.selection.bone;
  key.hoveredBone = state.view.tools.hover.bone;
  key.hiddenBones = hiddenBones(state);
  key.references = referencePlanes(state.open.reference.pictures, state.character());
  return key;
}

/// What a saved picture shows: all but what answers the pointer, marks the selection and is there to work after.
PictureKey keyToSave(const EditorState& state) {
  PictureKey key = keyOf(state, state.frame.route.view);
  key.display.skeleton = state.view.display.skeleton;
  key.display.primitives = state.view.display.primitives;
  if (!key.display.primitives && !key.display.influence && !key.display.anatomy) key.shapes.clear();
  for (PrimitiveShape& shape : key.shapes) shape.selected = shape.hovered = false;
  key.territory.clear();
  key.territoryBones.clear();
  key.references.clear();
  key.litParts.clear();
  key.selectedBone = key.hoveredBone = -1;
  return key;
}

}  // namespace

Scene Picture::sceneOf(const EditorState& state, const PictureKey& key) const {
  Scene scene;
  scene.character = state.document.character.get();
  scene.surface = key.onCard ? &card_->surface() : &shownSurface(state);
  scene.beside = besideSurface(state);
  scene.surfaceRevision = 2 * key.surface + (key.onCard ? 2 : 1);
  scene.pose = &state.live->pose();
  scene.primitives = key.shapes;
  scene.territory = key.territory;
  scene.territoryBones = key.territoryBones;
  scene.litParts = key.litParts;
  if (key.display.shading == Shading::kClasses) scene.layers = partLayers(state);
  scene.selectedBone = key.selectedBone;
  scene.hoveredBone = key.hoveredBone;
  scene.hiddenBones = key.hiddenBones;
  scene.references = key.references;
  if (key.display.controlMesh) {
    SkinnedMesh skinned;
    const Pose& pose = state.live->pose();
    skin(state.character(), pose, state.document.posedRig(pose).morphWeights, skinned);
    scene.skinnedControlPositions = std::move(skinned.positions);
  }
  return scene;
}

void Picture::render(EditorState& state, PictureKey key, double now, std::optional<float> moving) {
  viewport_.setCardVertices(key.onCard ? std::optional(card_->vertices()) : std::nullopt);
  viewport_.draw(sceneOf(state, key), key.view, key.display, moving);
  passing_ = moving.has_value();
  state.frame.pictureScale = moving.value_or(1.0f);
  state.frame.pictureSamples = 1;
  state.session.stats.upload = viewport_.seconds().upload;
  state.session.stats.draw = viewport_.seconds().draw;
  drawn_ = std::move(key);
  drawnAt_ = now;
}

void Picture::noteChange(const glm::vec4& shown, bool whole) {
  const glm::vec2 corner(shown), size(shown.z, shown.w);
  for (const glm::vec4& part : viewport_.changed()) {
    changed_.emplace_back(corner + size * glm::vec2(part), corner + size * glm::vec2(part.z, part.w));
    whole = whole || part == glm::vec4(0.0f, 0.0f, 1.0f, 1.0f);
  }
  if (whole) ++revision_;
}

/// The texture holds what the state is now: nothing has moved since it was drawn.
bool Picture::showsNow(const EditorState& state) const {
  return state.hasCharacter() && drawn_.document == state.session.documentsOpened && drawnAt_ > 0.0 &&
         drawn_.surface == shownRevision(state);
}

std::optional<double> Picture::secondsUntilRefining(const EditorState& state, double now) const {
  if (!showsNow(state) || viewport_.isRefined()) return std::nullopt;
  return std::max(drawnAt_ + kRestSeconds - now, 0.0);
}

bool Picture::refine(EditorState& state) {
  if (!showsNow(state)) return false;
  if (passing_) {
    render(state, PictureKey(drawn_), drawnAt_, std::nullopt);
    ++revision_;
    return true;
  }
  const bool shows = viewport_.refine(sceneOf(state, drawn_), drawn_.view, drawn_.display);
  if (shows) ++revision_;
  if (shows) state.frame.pictureSamples = viewport_.samplesTaken();
  return shows;
}

Result<void> Picture::save(EditorState& state, const std::filesystem::path& file) {
  const PictureKey key = keyToSave(state);
  const Scene scene = sceneOf(state, key);
  viewport_.setCardVertices(std::nullopt);
  viewport_.draw(scene, key.view, key.display);
  while (!viewport_.isRefined()) viewport_.refine(scene, key.view, key.display);
  drawn_ = {};
  ++revision_;
  const Result<std::string> bytes = pngBytes(viewport_.readPixels());
  if (!bytes) return bytes.error();
  return writeFileAtomically(file, bytes.value());
}

void Picture::keepThumbnail() {
  std::error_code failed;
  const std::pair kept(file_, std::filesystem::last_write_time(file_, failed));
  if (failed || kept == thumbnailOf_) return;
  thumbnailOf_ = kept;
  thumbnails_.keep(file_, viewport_.readPixels());
}

void Picture::draw(EditorState& state, const DrawnOnCard* card, const View& view, ImDrawList& list, double now,
                   std::optional<float> moving) {
  card_ = card;
  new_ = false;
  changed_.clear();
  if (!state.hasCharacter()) return;
  if (shownDocument_ != state.session.documentsOpened) {
    keepThumbnail();
    viewport_.setCharacter(state.character());
    shownDocument_ = state.session.documentsOpened;
  }
  PictureKey key = keyOf(state, view);
  key.onCard = card_ != nullptr;
  if (!(key == drawn_)) {
    const unsigned before = viewport_.colorTexture();
    render(state, std::move(key), now, moving);
    new_ = true;
    noteChange(state.frame.viewport, viewport_.colorTexture() != before);
  }
  const Document& document = state.document;
  file_ = document.rigFile.empty() ? document.characterFile : document.rigFile;
  if (document.commands.modified()) file_.clear();
  if (viewport_.isRefined()) keepThumbnail();
  const glm::vec4& v = state.frame.viewport;
  const ImVec2 low{v.x, v.y};
  const ImVec2 high{v.x + v.z, v.y + v.w};
  const auto texture = static_cast<std::uintptr_t>(viewport_.colorTexture());
  list.PushClipRect(low, high);
  list.AddImage(reinterpret_cast<ImTextureID>(texture), low, high, {0.0f, 1.0f}, {1.0f, 0.0f});
  const Canvas canvas{view, {v.x, v.y}, v.z / static_cast<float>(state.frame.viewportPixels.x), state.frame.uiScale};
  if (state.frame.route.gizmo.visible) {
    drawGizmo(list, state.view.tools.gizmo, state.frame.route.gizmo, state.frame.route.gizmoContext, canvas.topLeft,
              canvas.unitsPerPixel);
  }
  if (state.view.tools.box.drag) {
    drawBox(list, *state.view.tools.box.drag, canvas.topLeft, canvas.unitsPerPixel);
  }
  const Pose& pose = state.live->pose();
  const DisplaySettings& display = state.view.display;
  if (const std::optional<ShownLine> line = activeLine(state.document, pose)) {
    drawLine(list, canvas, *line, state.view.tools.lineHandles, !display.primitives && !display.anatomy);
  }
  if (const std::optional<LineDrag>& drag = state.view.tools.line.drag) {
    for (const int bone : {drag->startBone, drag->endBone}) {
      if (bone < 0) continue;
      const auto index = static_cast<std::size_t>(bone);
      drawBoneMark(list, canvas, state.character().skeleton.bones[index], pose.boneInWorld[index]);
    }
  }
  const bool adds = state.view.tools.tool == ToolKind::kAddMuscle || state.view.tools.tool == ToolKind::kMuscleLine;
  if (adds && !state.view.tools.addMuscle.drag && !state.view.tools.line.drag) {
    drawLanding(list, canvas, state.view.tools.hover, state.character(), pose);
  }
  if (const Surface* const beside = besideSurface(state)) {
    drawMeshName(list, canvas, boundsOf(shownSurface(state).positions), "live");
    drawMeshName(list, canvas, boundsOf(beside->positions), state.session.exportError.last->file.filename().string());
  }
  drawTriad(list, state.view.tools.triad,
            layoutTriad(state.view.tools.camera, state.frame.viewportPixels, canvas.scale / canvas.unitsPerPixel),
            canvas.topLeft, canvas.unitsPerPixel);
  list.PopClipRect();
}

}  // namespace sinew::app
