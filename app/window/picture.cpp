// app/window/picture.cpp: the viewport's picture, its resolution while it moves, and the frame in the window.

#include "app/window/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <system_error>
#include <utility>
#include <vector>

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <glm/common.hpp>

#include "app/editor/blending_edit.h"
#include "app/editor/commands.h"
#include "app/editor/export_error.h"
#include "app/editor/fit_sculpt_commands.h"
#include "app/editor/visibility_commands.h"
#include "app/ui/style.h"
#include "app/viewport/render/gl_objects.h"
#include "app/viewport/render/picture_files.h"
#include "app/viewport/tools/axis_triad.h"
#include "app/viewport/tools/draw_tools.h"
#include "core/character/skinning.h"
#include "core/files/disk/atomic_file.h"

namespace sinew::app {

namespace {

constexpr int kMarks = 4;

/// @param pixels  low corner and size, rows from below
void clear(const glm::ivec4& pixels, float shade) {
  const Tint back = palette::kBackground;
  glEnable(GL_SCISSOR_TEST);
  glScissor(pixels.x, pixels.y, pixels.z, pixels.w);
  glClearColor(back.r, back.g, back.b + shade, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
}

/// Clears the rectangle outside of `covered`. Both: low x and y, high x and y, from the top left.
void clearAround(const glm::ivec4& rect, const glm::ivec4& covered, int height) {
  const glm::ivec2 low(std::max(rect.x, covered.x), std::max(rect.y, covered.y));
  const glm::ivec2 high(std::min(rect.z, covered.z), std::min(rect.w, covered.w));
  std::array parts{rect, glm::ivec4(0), glm::ivec4(0), glm::ivec4(0)};
  if (low.x < high.x && low.y < high.y) {
    parts = {glm::ivec4(rect.x, rect.y, rect.z, low.y), glm::ivec4(rect.x, high.y, rect.z, rect.w),
             glm::ivec4(rect.x, low.y, low.x, high.y), glm::ivec4(high.x, low.y, rect.z, high.y)};
  }
  for (const glm::ivec4& part : parts) {
    if (part.x >= part.z || part.y >= part.w) continue;
    clear({part.x, height - part.w, part.z - part.x, part.w - part.y}, 0.0f);
  }
}

/// OpenGL leaves the back buffer undefined after a swap. A corner pixel with an invisible step of blue, different in
/// each frame, shows whether it is the last frame.
void leaveMark(int mark) { clear({0, 0, 1, 1}, static_cast<float>(mark) / 255.0f); }

bool hasMark(int mark) {
  std::array<std::uint8_t, 4> pixel{};
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  const Tint back = palette::kBackground;
  const std::array<float, 3> wanted{back.r, back.g, back.b + static_cast<float>(mark) / 255.0f};
  for (std::size_t c = 0; c < wanted.size(); ++c) {
    if (static_cast<long>(pixel[c]) != std::lround(255.0f * wanted[c])) return false;
  }
  return true;
}

}  // namespace

Screen::Screen() : software_(isSoftwareRenderer()) {}

bool Screen::draw(ImDrawData& data, const glm::ivec2& size, std::span<const TextureRevision> textures,
                  std::span<const glm::vec4> parts, const glm::vec4& covered, bool still) {
  if (size.x <= 0 || size.y <= 0) return false;
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, size.x, size.y);
  if (!software_ || data.FramebufferScale.x != 1.0f || data.FramebufferScale.y != 1.0f) {
    clear({0, 0, size}, 0.0f);
    ImGui_ImplOpenGL3_RenderDrawData(&data);
    return true;
  }
  const std::vector<glm::ivec4> changed = tiles_.update(data, size, textures, parts);
  if (changed.empty() && still) return false;
  const glm::ivec4 inside(glm::ceil(covered.x), glm::ceil(covered.y), glm::floor(covered.z), glm::floor(covered.w));
  for (const glm::ivec4& rect : changed) clearAround(rect, inside, size.y);
  clipDrawing(data, changed);
  ImGui_ImplOpenGL3_RenderDrawData(&data);
  mark_ = (mark_ + 1) % kMarks;
  leaveMark(mark_);
  return true;
}

void Screen::noteShown() {
  if (software_ && !hasMark(mark_)) forget();
}

namespace {

constexpr double kTolerance = 1.1;  ///< Accepted multiple of the goal.

double areaRatio(float to, float from) {
  const double ratio = static_cast<double>(to) / static_cast<double>(from);
  return ratio * ratio;
}

}  // namespace

double MovingResolution::room(double other) { return std::max(kFrameGoal - other, 0.5 * kFrameGoal); }

void MovingResolution::change(std::size_t step) {
  step_ = step;
  slow_ = fast_ = 0;
}

void MovingResolution::add(const FrameCost& cost) {
  const double room = MovingResolution::room(cost.other);
  const bool slow = cost.drawing > kTolerance * room;
  least_ = slow_ == 0 ? cost.drawing : std::min(least_, cost.drawing);
  slow_ = slow ? slow_ + 1 : 0;
  // At worst all drawing, the hidden part included, grows with the number of pixels.
  const bool fast =
      step_ > 0 && (cost.drawing + cost.hidden) * areaRatio(kScales[step_ - 1], kScales[step_]) <= room + cost.hidden;
  fast_ = fast ? fast_ + 1 : 0;
  if (slow_ >= kFewFrames && step_ + 1 < kScales.size()) {
    // Two steps at once if all slow frames are far beyond the goal.
    const bool far = least_ * areaRatio(kScales[step_ + 1], kScales[step_]) > kTolerance * room;
    change(std::min(step_ + (far ? 2 : 1), kScales.size() - 1));
  } else if (fast_ >= kManyFrames) {
    change(step_ - 1);
  }
}

namespace {

constexpr double kRestSeconds = 0.2;  ///< Rest before a picture is refined.

PictureKey keyOf(const EditorState& state, const View& view) {
  PictureKey key;
  key.document = state.session.documentsOpened;
  key.surface = shownRevision(state);
  key.view = view;
  key.display = state.view.display;
  key.display.look = state.session.preferences.look;
  if (showsLeft(state)) {
    key.display.shading = Shading::kHeat;
    key.display.surface = true;
    key.display.anatomy = false;
    key.display.heatRange = kLeftRange;
  } else if (showsExportError(state)) {
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

/// Without hover, selection and reference pictures.
PictureKey keyToSave(const EditorState& state) {
  PictureKey key = keyOf(state, state.frame.route.view);
  key.display.skeleton = state.view.display.skeleton;
  key.display.primitives = state.view.display.primitives;
  if (!key.display.primitives && !key.display.influence && !key.display.anatomy) key.shapes.clear();
  for (PrimitiveShape& shape : key.shapes) shape.selected = shape.active = shape.hovered = shape.twin = false;
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

/// The texture shows the current state.
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
  file_ = document.commands.modified() ? std::filesystem::path() : document.file();
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
  const ViewportTools& tools = state.view.tools;
  if (const std::optional<ShownSheet> sheet = shownSheet(state.document, pose); sheet && !addsMuscles(tools.tool)) {
    drawSheetEdges(list, canvas, *sheet, tools.sheetHandles);
  }
  for (const std::vector<glm::vec3>& edge : drawnEdges(tools.sheet, state.character(), pose)) {
    if (!edge.empty()) drawStroke(list, canvas, edge);
  }
  if (const std::optional<LineDrag>& drag = tools.line.drag) {
    for (const int bone : {drag->startBone, drag->endBone}) {
      if (bone < 0) continue;
      const auto index = static_cast<std::size_t>(bone);
      drawBoneMark(list, canvas, state.character().skeleton.bones[index], pose.boneInWorld[index]);
    }
  }
  const bool draws = tools.addMuscle.drag || tools.line.drag || tools.sheet.drag;
  if (addsMuscles(tools.tool) && !draws) {
    drawLanding(list, canvas, tools.hover, state.character(), pose);
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
