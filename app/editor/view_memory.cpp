// app/editor/view_memory.cpp: a document's view as JSON.

#include "app/editor/view_memory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "app/document/view_files.h"
#include "app/editor/edit.h"
#include "app/editor/session.h"
#include "app/viewport/render/scene.h"
#include "core/rig/motion_clip.h"

namespace sinew::app {
namespace {

struct Flag {
  const char* key;
  bool DisplaySettings::*shown;
};
constexpr std::array kFlags{
    Flag{"wire", &DisplaySettings::wire},           Flag{"control_mesh", &DisplaySettings::controlMesh},
    Flag{"skeleton", &DisplaySettings::skeleton},   Flag{"primitives", &DisplaySettings::primitives},
    Flag{"influence", &DisplaySettings::influence}, Flag{"ground", &DisplaySettings::ground},
    Flag{"anatomy", &DisplaySettings::anatomy},     Flag{"relief", &DisplaySettings::relief}};

/// Takes a number within the range.
template <class Number>
void read(const Json& json, double least, double most, Number& value) {
  const double number = json.number(std::nan(""));
  if (number >= least && number <= most) value = static_cast<Number>(number);
}

Json clipToJson(const EditorState& state, bool withPlayingTime) {
  const Transport& transport = state.open.transport;
  Json clip = Json::object();
  clip.set("name",
           transport.clip < 0 ? Json() : Json(state.character().clips[static_cast<std::size_t>(transport.clip)].name));
  clip.set("time", transport.playing && !withPlayingTime ? 0.0 : transport.time);
  clip.set("playing", transport.playing).set("loop", transport.loop).set("speed", transport.speed);
  const PlayRange range =
      hasPlayRange(transport) ? playRange(transport, state.character()) : PlayRange{};  // 0, 0: the whole clip.
  return clip.set("range", Json::array().push(range.from).push(range.to));
}

/// With the character's height, to recognize another character in the same file.
Json cameraToJson(const EditorState& state) {
  const Camera& camera = state.view.tools.camera;
  const CameraStand& stand = camera.transition ? camera.transition->to : camera.stand;
  Json target = Json::array();
  for (int axis = 0; axis < 3; ++axis) target.push(stand.target[axis]);
  return Json::object()
      .set("target", target)
      .set("distance", stand.distance)
      .set("yaw", stand.yaw)
      .set("pitch", stand.pitch)
      .set("aim", Json::array().push(stand.aim.x).push(stand.aim.y))
      .set("orthographic", camera.orthographic)
      .set("height", state.character().height);
}

void restoreCamera(EditorState& state, const Json& json) {
  Camera& camera = state.view.tools.camera;
  const double height = camera.characterHeight;
  const std::vector<Json>& target = json.at("target").items();
  const double was = json.at("height").number(0.0);
  if (target.size() != 3 || !(std::abs(was - height) <= 0.01 * height)) return;
  CameraStand stand = camera.stand;
  const double far = kFarthestView * height;
  for (int axis = 0; axis < 3; ++axis) read(target[static_cast<std::size_t>(axis)], -far, far, stand.target[axis]);
  read(json.at("distance"), kNearestView * height, far, stand.distance);
  read(json.at("yaw"), -std::numbers::pi, std::numbers::pi, stand.yaw);
  read(json.at("pitch"), -0.5 * std::numbers::pi, 0.5 * std::numbers::pi, stand.pitch);
  stand.aim = {};
  if (const std::vector<Json>& aim = json.at("aim").items(); aim.size() == 2) {
    for (int axis = 0; axis < 2; ++axis) read(aim[static_cast<std::size_t>(axis)], -1.0, 1.0, stand.aim[axis]);
  }
  camera.transition.reset();
  camera.stand = stand;
  camera.orthographic = json.at("orthographic").boolean(camera.orthographic);
  state.open.frameWanted = false;
}

Json displayToJson(const DisplaySettings& display) {
  Json json = Json::object().set("shading", nameOf(display.shading));
  for (const Flag& flag : kFlags) json.set(flag.key, display.*flag.shown);
  return json.set("glass", display.glass);
}

void restoreDisplay(DisplaySettings& display, const Json& json) {
  const auto shading = std::ranges::find(kShadingNames, json.at("shading").text(""));
  if (shading != kShadingNames.end()) display.shading = static_cast<Shading>(shading - kShadingNames.begin());
  for (const Flag& flag : kFlags) display.*flag.shown = json.at(flag.key).boolean(display.*flag.shown);
  read(json.at("glass"), 0.0, 1.0, display.glass);
}

Json textsToJson(const std::set<std::string>& texts) {
  Json json = Json::array();
  for (const std::string& text : texts) json.push(text);
  return json;
}

std::set<std::string> textsFromJson(const Json& json) {
  std::set<std::string> texts;
  for (const Json& text : json.items()) texts.insert(text.text(""));
  texts.erase("");
  return texts;
}

constexpr std::array kOrders{"bones", "regions", "groups"};  ///< By OutlinerOrder.

Json outlinerToJson(const ViewState& view) {
  return Json::object()
      .set("search", view.outlinerFilter)
      .set("only_with_muscles", view.outliner.onlyWithMuscles)
      .set("helper_bones", view.outliner.helperBones)
      .set("order", kOrders[static_cast<std::size_t>(view.outliner.order)])
      .set("folded", textsToJson(view.outliner.folded));
}

void restoreOutliner(ViewState& view, const Json& json) {
  view.outlinerFilter = json.at("search").text("");
  view.outliner.onlyWithMuscles = json.at("only_with_muscles").boolean(view.outliner.onlyWithMuscles);
  view.outliner.helperBones = json.at("helper_bones").boolean(view.outliner.helperBones);
  const auto order = std::ranges::find(kOrders, json.at("order").text("bones"));
  if (order != kOrders.end()) view.outliner.order = static_cast<OutlinerOrder>(order - kOrders.begin());
  view.outliner.folded = textsFromJson(json.at("folded"));
}

/// Muscles by name, because identities last only while the document is open.
Json marksToJson(const Visibility::Marks& marks, const Rig& rig) {
  std::set<std::string> muscles;
  for (const Primitive& primitive : rig.primitives) {
    if (marks.muscles.contains(primitive.id())) muscles.insert(primitive.name);
  }
  return Json::object().set("muscles", textsToJson(muscles)).set("bones", textsToJson(marks.bones));
}

void restoreMarks(Visibility::Marks& marks, const Json& json, const Document& document) {
  const std::set<std::string> muscles = textsFromJson(json.at("muscles"));
  const std::set<std::string> bones = textsFromJson(json.at("bones"));
  for (const Primitive& primitive : document.rig().primitives) {
    if (muscles.contains(primitive.name)) marks.muscles.insert(primitive.id());
  }
  for (const Bone& bone : document.character->skeleton.bones) {
    if (bones.contains(bone.path)) marks.bones.insert(bone.path);
  }
}

void restoreReferences(EditorState& state, const Json& json) {
  std::vector<Error> missing;
  state.open.reference.pictures = referencesFromJson(json, missing);
  for (const Error& error : missing) {
    addMessage(state.session, MessageKind::kWarning, "A reference picture is not shown: " + error.plainText());
  }
}

}  // namespace

Json viewToJson(const EditorState& state, bool withPlayingTime) {
  const Visibility& visibility = state.document.visibility;
  return Json::object()
      .set("clip", clipToJson(state, withPlayingTime))
      .set("camera", cameraToJson(state))
      .set("display", displayToJson(state.view.display))
      .set("outliner", outlinerToJson(state.view))
      .set("references", referencesToJson(state.open.reference.pictures))
      .set("hidden", marksToJson(visibility.hidden, state.document.rig()))
      .set("locked", marksToJson(visibility.locked, state.document.rig()));
}

std::optional<Json> rememberedView(const SessionState& session, const Document& document) {
  if (session.viewsFolder.empty() || isSample(document.file())) return std::nullopt;
  return loadView(session.viewsFolder, document.file());
}

void rememberView(const EditorState& state) {
  const std::filesystem::path& file = state.document.file();
  if (state.session.viewsFolder.empty() || !state.hasCharacter() || file.empty() || isSample(file)) return;
  static_cast<void>(storeView(state.session.viewsFolder, file, viewToJson(state, true)));
}

Transport transportOf(const Json& view, const Character& character, const Transport& otherwise) {
  const Json& json = view.at("clip");
  const std::string name = json.at("name").text("");
  const bool bindPose = json.find("name") != nullptr && json.at("name").isNull();
  const int clip = bindPose ? -1 : findClip(character, name);
  if (!bindPose && clip < 0) return otherwise;
  Transport transport = otherwise;
  chooseClip(transport, clip, character);
  const double duration = clipDuration(transport, character);
  read(json.at("time"), 0.0, duration, transport.time);
  transport.playing = duration > 0.0 && json.at("playing").boolean(transport.playing);
  transport.loop = json.at("loop").boolean(transport.loop);
  read(json.at("speed"), 0.1, 4.0, transport.speed);
  if (const std::vector<Json>& range = json.at("range").items(); range.size() == 2) {
    PlayRange played;
    read(range[0], 0.0, duration, played.from);
    read(range[1], 0.0, duration, played.to);
    if (played.to > played.from) setPlayRange(transport, played, character);
  }
  return transport;
}

void restoreView(EditorState& state, const Json& view) {
  restoreCamera(state, view.at("camera"));
  restoreDisplay(state.view.display, view.at("display"));
  if (view.find("outliner") != nullptr) restoreOutliner(state.view, view.at("outliner"));
  restoreReferences(state, view.at("references"));
  restoreMarks(state.document.visibility.hidden, view.at("hidden"), state.document);
  restoreMarks(state.document.visibility.locked, view.at("locked"), state.document);
}

}  // namespace sinew::app
