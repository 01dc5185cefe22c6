// app/window/picture.cpp: the viewport's picture.

#include "app/window/picture.h"

#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "app/editor/commands.h"
#include "app/editor/territory.h"
#include "app/tools/axis_triad.h"
#include "app/tools/gizmo_draw.h"
#include "app/tools/hover_draw.h"
#include "core/character/skinning.h"

namespace sinew::app {
namespace {

/// All muscles, or the selected ones alone; these are shown whether muscles are switched on or not.
PictureKey keyOf(const EditorState& state, const View& view) {
  PictureKey key;
  key.document = state.documentsOpened;
  key.surface = state.live->revision();
  key.view = view;
  key.display = state.display;
  key.display.lineScale = state.uiScale * static_cast<float>(state.viewportPixels.x) / std::max(state.viewport.z, 1.0f);
  key.display.skeleton = key.display.skeleton || state.tools.tool == ToolKind::kPose;
  key.shapes = shownShapes(state, state.display.primitives);
  key.display.primitives = !key.shapes.empty();
  key.territory = shownTerritoryWeights(state);
  key.territoryBones = shownTerritory(state);
  key.display.skeleton = key.display.skeleton || !key.territoryBones.empty();
  key.selectedBone = state.document.selection.bone;
  key.hoveredBone = state.tools.hover.bone;
  return key;
}

}  // namespace

void Picture::render(EditorState& state, PictureKey key) {
  Scene scene;
  scene.character = state.document.character.get();
  scene.surface = &state.live->surface();
  scene.surfaceRevision = key.surface + 1;
  scene.pose = &state.live->pose();
  scene.primitives = key.shapes;
  scene.territory = key.territory;
  scene.territoryBones = key.territoryBones;
  scene.selectedBone = key.selectedBone;
  scene.hoveredBone = key.hoveredBone;
  if (key.display.controlMesh) {
    SkinnedMesh skinned;
    skin(state.character(), state.live->pose(), skinned);
    scene.skinnedControlPositions = std::move(skinned.positions);
  }
  viewport_.draw(scene, key.view, key.display);
  state.stats.upload = viewport_.seconds().upload;
  state.stats.draw = viewport_.seconds().draw;
  drawn_ = std::move(key);
}

void Picture::draw(EditorState& state, const View& view, ImDrawList& list) {
  if (!state.hasCharacter()) return;
  if (shownDocument_ != state.documentsOpened) {
    viewport_.setCharacter(state.character());
    shownDocument_ = state.documentsOpened;
  }
  if (PictureKey key = keyOf(state, view); !(key == drawn_)) render(state, std::move(key));
  const glm::vec4& v = state.viewport;
  const ImVec2 low{v.x, v.y};
  const ImVec2 high{v.x + v.z, v.y + v.w};
  const auto texture = static_cast<std::uintptr_t>(viewport_.colorTexture());
  list.PushClipRect(low, high);
  list.AddImage(reinterpret_cast<ImTextureID>(texture), low, high, {0.0f, 1.0f}, {1.0f, 0.0f});
  if (state.route.gizmo.visible) {
    drawGizmo(list, state.tools.gizmo, state.route.gizmo, state.route.gizmoContext, {v.x, v.y},
              v.z / static_cast<float>(state.viewportPixels.x));
  }
  if (state.tools.box.drag) {
    drawBox(list, *state.tools.box.drag, {v.x, v.y}, v.z / static_cast<float>(state.viewportPixels.x));
  }
  if (state.tools.tool == ToolKind::kAddMuscle && !state.tools.addMuscle.drag) {
    drawLanding(list, state.tools.hover, state.character(), state.live->pose(), view, {v.x, v.y},
                v.z / static_cast<float>(state.viewportPixels.x), state.uiScale);
  }
  const float unitsPerPixel = v.z / static_cast<float>(state.viewportPixels.x);
  drawTriad(list, state.tools.triad,
            layoutTriad(state.tools.camera, state.viewportPixels, state.uiScale / unitsPerPixel), {v.x, v.y},
            unitsPerPixel);
  list.PopClipRect();
}

}  // namespace sinew::app
