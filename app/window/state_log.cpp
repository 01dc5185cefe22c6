// app/window/state_log.cpp: the editor's state as JSON.

#include "app/window/state_log.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <set>
#include <utility>

#include "app/document/listed_muscles.h"
#include "app/editor/animate.h"
#include "app/ui/keyboard_focus.h"
#include "app/viewport/render/scene.h"
#include "core/files/json/json.h"
#include "core/files/rig_json_parts.h"
#include "core/geometry/at.h"
#include "core/rig/rig_edit.h"

namespace sinew::app {
namespace {

Json numbers(std::initializer_list<float> values) {
  Json array = Json::array();
  for (const float value : values) array.push(value);
  return array;
}

bool inside(const glm::vec2& point, const glm::vec4& box) {
  return point.x >= box.x && point.y >= box.y && point.x < box.x + box.z && point.y < box.y + box.w;
}

/// Viewport pixels -> window coordinates.
glm::vec2 inWindow(const EditorState& state, const glm::vec2& pixel) {
  const glm::vec2 unitsPerPixel =
      glm::vec2(state.frame.viewport.z, state.frame.viewport.w) / glm::vec2(state.frame.viewportPixels);
  return glm::vec2(state.frame.viewport.x, state.frame.viewport.y) + pixel * unitsPerPixel;
}

Json documentState(const Document& document) {
  Json selection = Json::array();
  const Rig& rig = document.rig();
  for (const PrimitiveId id : document.selection.primitives) {
    const int index = findPrimitive(rig, id);
    if (index >= 0 && leadOf(rig, index) == index) selection.push(muscleName(rig, index));
  }
  return Json::object()
      .set("path", document.file().string())
      .set("modified", document.commands.modified())
      .set("primitives", static_cast<int>(rig.primitives.size()))
      .set("sheets", static_cast<int>(rig.sheets.size()))
      .set("selection", selection)
      .set("bone", document.selection.bone < 0 || document.character == nullptr
                       ? Json("")
                       : Json(document.character->skeleton.fileName(document.selection.bone)))
      .set("undo", static_cast<int>(document.commands.position()))
      .set("redo", static_cast<int>(document.commands.stepCount() - document.commands.position()));
}

Json namesOf(const Rig& rig, const std::set<PrimitiveId>& muscles) {
  Json names = Json::array();
  for (const int lead : allLeads(rig)) {
    if (muscles.contains(at(rig.primitives, lead).id())) names.push(muscleName(rig, lead));
  }
  return names;
}

Json visibilityState(const EditorState& state) {
  const Visibility& visibility = state.document.visibility;
  Json away = Json::array();
  if (state.hasCharacter()) {
    const Rig& rig = state.document.rig();
    for (const int lead : leadsOf(rig, hiddenPrimitives(visibility, rig, state.character().skeleton))) {
      away.push(muscleName(rig, lead));
    }
  }
  return Json::object()
      .set("away", away)
      .set("hidden", namesOf(state.document.rig(), visibility.hidden.muscles))
      .set("locked", namesOf(state.document.rig(), visibility.locked.muscles))
      .set("solo", namesOf(state.document.rig(), visibility.solo.muscles))
      .set("isolated", visibility.isolated ? namesOf(state.document.rig(), *visibility.isolated) : Json())
      .set("bare", visibility.bare);
}

Json groupState(const Rig& rig) {
  Json groups = Json::object();
  for (const Group& group : rig.groups) {
    groups.set(group.name, static_cast<int>(leadsOf(rig, membersOf(rig, group.name)).size()));
  }
  return groups;
}

Json symmetryState(const Document& document) {
  const int active = document.activePrimitive();
  const MirrorPlan* const plan = document.mirror.get();
  return Json::object()
      .set("on", document.symmetry)
      .set("pairs", plan ? plan->pairCount() : 0)
      .set("centre", plan ? plan->centerCount() : 0)
      .set("twin", active < 0 ? std::string() : document.rig().primitives[static_cast<std::size_t>(active)].mirror);
}

Json gizmoState(const EditorState& state) {
  Json handles = Json::object();
  for (const auto& [name, pixel] : state.frame.route.gizmo.namedPixels()) {
    const glm::vec2 point = inWindow(state, pixel);
    if (inside(point, state.frame.viewport)) handles.set(name, numbers({point.x, point.y}));
  }
  return Json::object()
      .set("visible", state.frame.route.gizmo.visible)
      .set("mode", nameOf(state.view.tools.gizmo.mode))
      .set("axes", nameOf(state.view.tools.gizmo.axes))
      .set("pivot", nameOf(state.view.tools.pivot))
      .set("hovered", nameOf(state.view.tools.gizmo.hovered))
      .set("dragging", state.view.tools.gizmo.drag.has_value())
      .set("handles", handles);
}

/// The active muscle's line, with its ends in the window.
Json lineState(const EditorState& state, const View& view) {
  Json line = Json::object();
  const auto shown = state.hasCharacter() ? activeLine(state.document, state.live->pose()) : std::nullopt;
  if (!shown) return line;
  Json ends = Json::object();
  for (const LineEnd end : {LineEnd::kOrigin, LineEnd::kInsertion, LineEnd::kVia}) {
    const std::optional<glm::vec3> point = endPoint(*shown, end);
    if (!point) continue;
    const glm::vec2 pixel = inWindow(state, glm::vec2(view.toPixel(*point)));
    if (inside(pixel, state.frame.viewport)) ends.set(nameOf(end), numbers({pixel.x, pixel.y}));
  }
  const LineHandles& handles = state.view.tools.lineHandles;
  line.set("name", state.document.rig().lines[static_cast<std::size_t>(shown->index)].name)
      .set("ends", ends)
      .set("hovered", nameOf(handles.hovered))
      .set("dragging", handles.drag.has_value())
      .set("stretch", shown->stretch)
      .set("activation", shown->activation);
  return line;
}

/// The active sheet, with the points of its edges in the window.
Json sheetState(const EditorState& state, const View& view) {
  Json sheet = Json::object();
  const auto shown = state.hasCharacter() ? shownSheet(state.document, state.live->pose()) : std::nullopt;
  if (!shown) return sheet;
  const MuscleSheet& own = at(state.document.rig().sheets, shown->index);
  Json edges = Json::array();
  for (const std::vector<glm::vec3>& edge : shown->edges) {
    Json points = Json::array();
    for (const glm::vec3& point : edge) {
      const glm::vec2 pixel = inWindow(state, glm::vec2(view.toPixel(point)));
      points.push(numbers({pixel.x, pixel.y}));
    }
    edges.push(points);
  }
  const SheetHandles& handles = state.view.tools.sheetHandles;
  return sheet.set("name", own.name)
      .set("edges", edges)
      .set("hovered", handles.hovered ? nameOfEdge(own, handles.hovered->edge) : std::string())
      .set("dragging", handles.drag.has_value())
      .set("strips", own.strips)
      .set("bellies", own.bellies)
      .set("crest", own.crest);
}

void addAnimated(const EditorState& state, const std::vector<AnimatedNumber>& animated, int owner, Json& values,
                 std::size_t& keys, std::size_t& drivers) {
  for (const AnimatedNumber& number : animated) {
    const NumberRef ref{number.parameter, owner};
    values.set(nameOf(number.parameter), numberNow(state, ref));
    drivers += number.drivers.size();
    const KeyTrack* track = trackNow(state, ref);
    if (track != nullptr) keys += track->curve.points.size();
  }
}

/// Driven keys being set; keys, drivers and current numbers of the active muscle and its line.
Json animationState(const EditorState& state) {
  Json animation = Json::object();
  if (!state.hasCharacter()) return animation;
  const DrivenKeyMode& mode = state.open.animate.drivenKey;
  if (mode.isOn()) animation.set("setting", wordsFor(mode.input, state.character().skeleton));
  const std::optional<float> x = mode.isOn() ? inputNow(state, mode.input) : std::nullopt;
  if (x) animation.set("input", *x);
  const int active = state.document.activePrimitive();
  if (active < 0) return animation;
  const Rig& rig = state.document.rig();
  const Primitive& primitive = rig.primitives[static_cast<std::size_t>(active)];
  const int line = findLine(rig, primitive.line);
  Json values = Json::object();
  std::size_t keys = 0;
  std::size_t drivers = 0;
  addAnimated(state, primitive.animated, active, values, keys, drivers);
  if (line >= 0) {
    addAnimated(state, rig.lines[static_cast<std::size_t>(line)].animated, line, values, keys, drivers);
  }
  return animation.set("keys", static_cast<int>(keys)).set("drivers", static_cast<int>(drivers)).set("now", values);
}

Json boneState(const EditorState& state, const View& view) {
  Json bones = Json::object();
  if (!state.hasCharacter()) return bones;
  const Skeleton& skeleton = state.character().skeleton;
  const auto& matrices = state.live->pose().boneInWorld;
  for (std::size_t i = 0; i < matrices.size(); ++i) {
    const glm::vec3 pixel = view.toPixel(glm::vec3(matrices[i][3]));
    if (pixel.z > 1.0f || pixel.z < -1.0f) continue;
    const glm::vec2 point = inWindow(state, glm::vec2(pixel));
    if (inside(point, state.frame.viewport))
      bones.set(skeleton.fileName(static_cast<int>(i)), numbers({point.x, point.y}));
  }
  return bones;
}

Json widgetState(const WidgetLog& widgets) {
  Json result = Json::object();
  for (const auto& [id, box] : widgets.rectangles()) result.set(id, numbers({box.x, box.y, box.z, box.w}));
  return result;
}

Json clipNames(const EditorState& state) {
  Json clips = Json::array();
  if (!state.hasCharacter()) return clips;
  for (const AnimationClip& clip : state.character().clips) clips.push(clip.name);
  return clips;
}

/// Start and end, seconds.
Json playedRange(const EditorState& state) {
  if (!state.hasCharacter()) return numbers({});
  const PlayRange range = playRange(state.open.transport, state.character());
  return numbers({static_cast<float>(range.from), static_cast<float>(range.to)});
}

/// Joints rotated by hand.
Json poseState(const EditorState& state) {
  const PoseOverrides& overrides = state.open.transport.overrides;
  Json turns = Json::object();
  for (const JointTurn& turn : overrides.turns) {
    const glm::quat& q = turn.turn;
    if (state.hasCharacter()) turns.set(state.character().skeleton.fileName(turn.bone), numbers({q.x, q.y, q.z, q.w}));
  }
  return Json::object()
      .set("overrides", static_cast<int>(overrides.turns.size()))
      .set("holds", overrides.from == TurnsFrom::kBindPose)
      .set("turns", turns);
}

Json messageState(const EditorState& state) {
  Json messages = Json::array();
  for (const Message& message : state.session.messages) messages.push(message.text);
  return messages;
}

/// Unfinished exports.
Json exportState(const EditorState& state) {
  Json exports = Json::array();
  for (const ExportStand& stand : state.session.exports.stands()) {
    exports.push(Json::object()
                     .set("file", stand.file.string())
                     .set("running", stand.running)
                     .set("share", std::floor(100.0 * stand.share) / 100.0));
  }
  return exports;
}

std::string dialogName(const EditorState& state) {
  if (state.dialogs.conflict.found != OnDisk::kSame) return "conflict";
  if (state.dialogs.question.kind != IntentKind::kNone) return "unsaved";
  if (state.dialogs.exportQuestion) return "export-question";
  const DialogKind file = state.dialogs.file.kind;
  if (file == DialogKind::kSavePicture) return "picture";
  if (file >= DialogKind::kExportPlace && file <= DialogKind::kPicturesPlace) return "export-place";
  if (!state.dialogs.file.locateFor.empty()) return "locate-file";
  const bool opens = file == DialogKind::kOpen || file == DialogKind::kReference || file == DialogKind::kSculpt;
  if (file != DialogKind::kNone) return opens ? "open" : "save";
  if (state.dialogs.exporting.shown == ExportDialog::kCharacter) return "export";
  if (state.dialogs.exporting.shown == ExportDialog::kFarmJob) return "farm";
  if (!state.dialogs.locate.rigFile.empty()) return "locate";
  if (!state.dialogs.keepMuscles.empty()) return "keep-muscles";
  if (state.dialogs.recovery) return "recovery";
  if (state.dialogs.preferences) return "preferences";
  if (state.dialogs.pictures.shown) return "pictures";
  return state.dialogs.palette.shown ? "palette" : (state.dialogs.keySheet ? "keys" : "");
}

Json display(const DisplaySettings& shown, const PictureLook& look) {
  return Json::object()
      .set("shading", nameOf(shown.shading))
      .set("wire", shown.wire)
      .set("skeleton", shown.skeleton)
      .set("primitives", shown.primitives)
      .set("influence", shown.influence)
      .set("anatomy", shown.anatomy)
      .set("glass", shown.glass)
      .set("ground", shown.ground)
      .set("light", nameOf(look.light))
      .set("background", nameOf(look.backdrop))
      .set("ao", look.occlusion);
}

Json cameraState(const Camera& camera) {
  const CameraStand& stand = camera.stand;
  return Json::object()
      .set("target", numbers({stand.target.x, stand.target.y, stand.target.z}))
      .set("distance", stand.distance)
      .set("yaw", stand.yaw)
      .set("pitch", stand.pitch)
      .set("orthographic", camera.orthographic);
}

Json outlinerState(const ViewState& view) {
  return Json::object()
      .set("search", view.outlinerFilter)
      .set("only_with_muscles", view.outliner.onlyWithMuscles)
      .set("helper_bones", view.outliner.helperBones);
}

std::string headText(const EditorState& state, long long frame, double seconds) {
  const FrameStats& stats = state.session.stats;
  const Json milliseconds = Json::object()
                                .set("skin", stats.stages.skin * 1e3)
                                .set("patch", stats.stages.patch * 1e3)
                                .set("project", stats.stages.project * 1e3)
                                .set("folds", stats.stages.folds * 1e3)
                                .set("normals", stats.stages.normals * 1e3)
                                .set("prepare", stats.prepare * 1e3)
                                .set("upload", stats.upload * 1e3)
                                .set("draw", stats.draw * 1e3)
                                .set("ui", stats.ui * 1e3)
                                .set("frame", stats.now());
  return Json::object()
      .set("frame", frame)
      .set("seconds", seconds)
      .set("fps", stats.framesPerSecond())
      .set("ms", milliseconds)
      .dump();
}

/// One line of JSON without what differs in every frame (frame, seconds, fps, ms). Positions are window coordinates;
/// those outside of window or picture are left out.
std::string stateText(const EditorState& state, const WidgetLog& widgets, const View& view) {
  const SmoothingReport report = state.hasCharacter() ? state.live->report() : SmoothingReport{};
  const SmoothingSettings& smoothing = state.document.rig().smoothing;
  const glm::vec4& v = state.frame.viewport;
  const ViewportTools& tools = state.view.tools;
  const glm::vec2 mouse = inWindow(state, tools.lastPixel);
  return Json::object()
      .set("document", documentState(state.document))
      .set("clip", state.hasCharacter() ? clipNow(state) : std::string())
      .set("clips", clipNames(state))
      .set("clip_time", state.open.transport.time)
      .set("playing", state.open.transport.playing)
      .set("range", playedRange(state))
      .set("pose", poseState(state))
      .set("visibility", visibilityState(state))
      .set("groups", groupState(state.document.rig()))
      .set("links", jsonList(state.document.rig().links, linkNode))
      .set("territory", state.view.tools.territoryMode ? state.document.activeName() : std::string())
      .set("depth", state.hasCharacter() ? state.live->depth() : smoothing.depth)
      .set("tolerance", state.hasCharacter() ? state.live->tolerance() : smoothing.tolerance)
      .set("mode", nameOf(state.document.rig().surface.mode))
      .set("surface_on", state.session.surfaceMaker.onCard ? "card" : "processor")
      .set("triangles", report.refinedTriangles)
      .set("tool", nameOf(state.view.tools.tool))
      .set("status", state.frame.route.status)
      .set("display", display(state.view.display, state.session.preferences.look))
      .set("camera", cameraState(state.view.tools.camera))
      .set("outliner", outlinerState(state.view))
      .set("dialog", dialogName(state))
      .set("focus", focusedControl(widgets))
      .set("keymap", nameOf(state.session.preferences.keymap))
      .set("scale", state.frame.uiScale)
      .set("symmetry", symmetryState(state.document))
      .set("box", Json::object().set("armed", tools.box.armed).set("dragging", tools.box.drag.has_value()))
      .set("gizmo", gizmoState(state))
      .set("line", lineState(state, view))
      .set("sheet", sheetState(state, view))
      .set("flex", state.open.flex.shown())
      .set("animation", animationState(state))
      .set("viewport", numbers({v.x, v.y, v.z, v.w}))
      .set("mouse", numbers({mouse.x, mouse.y}))
      .set("samples", state.frame.pictureSamples)
      .set("picture_scale", state.frame.pictureScale)
      .set("camera_moving", isMoving(state.view.tools.camera))
      .set("bones", boneState(state, view))
      .set("widgets", widgetState(widgets))
      .set("messages", messageState(state))
      .set("exports", exportState(state))
      .set("toast", state.session.toast ? state.session.toast->text : std::string())
      .dump();
}

}  // namespace

Result<StateLog> StateLog::open(const std::filesystem::path& file) {
  StateLog log;
  log.file_.reset(std::fopen(file.c_str(), "ae"));
  if (!log.file_) return Error{file.string(), "", std::string("cannot be written: ") + std::strerror(errno)};
  return log;
}

void StateLog::write(const EditorState& state, const WidgetLog& widgets, const View& view, long long frame,
                     double seconds) {
  std::string text = stateText(state, widgets, view);
  if (text == last_) return;
  std::string line = headText(state, frame, seconds);
  line.back() = ',';
  line.append(text, 1);
  line.push_back('\n');
  std::fwrite(line.data(), 1, line.size(), file_.get());
  std::fflush(file_.get());
  last_ = std::move(text);
}

}  // namespace sinew::app
