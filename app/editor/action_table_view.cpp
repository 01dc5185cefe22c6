// app/editor/action_table_view.cpp: the menus View, Tool and Play.
#include "app/document/listed_muscles.h"
#include "app/editor/action_table.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "app/editor/blending_edit.h"
#include "app/editor/clip_commands.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/export_error.h"
#include "app/editor/muscle_set_commands.h"
#include "app/editor/pose_commands.h"
#include "app/editor/reference_commands.h"
#include "app/editor/visibility_commands.h"
#include "app/viewport/tools/viewport_tools.h"
#include "sinew/rig/rig_edit.h"

namespace sinew::app::table {
namespace {

Possible hasLines(const State& s) {
  return open(s).also(!s.document.rig().lines.empty(), "No muscle has a line: draw one from bone to bone first");
}
bool isFlexed(const State& s) { return s.open.flex.latched; }
void latchFlex(State& s) { s.open.flex.latched = !s.open.flex.latched; }

void frame(State& s) { frameSelection(s, true); }
void frameAll(State& s) {
  if (!frameExportBeside(s)) frameInPicture(s, boundsOf(s.live->surface().positions), true);
}

template <Shading kShading>
bool isShaded(const State& s) {
  return s.view.display.shading == kShading;
}
template <Shading kShading>
void shade(State& s) {
  s.view.display.shading = kShading;
}

template <bool DisplaySettings::*kFlag>
bool isShown(const State& s) {
  return s.view.display.*kFlag;
}
template <bool DisplaySettings::*kFlag>
void toggleShown(State& s) {
  s.view.display.*kFlag = !(s.view.display.*kFlag);
}

template <StandardView kView>
void look(State& s) {
  showStandardView(s.view.tools.camera, kView);
  frameExportBeside(s);
}

bool isReferenceShown(const State& s) { return s.open.reference.shown; }
bool isOrthographic(const State& s) { return s.view.tools.camera.orthographic; }
void toggleOrthographic(State& s) { s.view.tools.camera.orthographic = !s.view.tools.camera.orthographic; }
bool hasAutoDepth(const State& s) { return s.document.rig().smoothing.autoDepth; }
void toggleAutoDepth(State& s) {
  SmoothingSettings smoothing = s.document.rig().smoothing;
  smoothing.autoDepth = !smoothing.autoDepth;
  edit(s, "Auto depth", setSmoothing(s.document.rig(), smoothing));
}
template <LightPreset kLight>
bool isLit(const State& s) {
  return s.session.preferences.look.light == kLight;
}
template <LightPreset kLight>
void light(State& s) {
  s.session.preferences.look.light = kLight;
}
template <Backdrop kBackdrop>
bool isBehind(const State& s) {
  return s.session.preferences.look.backdrop == kBackdrop;
}
template <Backdrop kBackdrop>
void putBehind(State& s) {
  s.session.preferences.look.backdrop = kBackdrop;
}
bool hasOcclusion(const State& s) { return s.session.preferences.look.occlusion; }
void toggleOcclusion(State& s) { s.session.preferences.look.occlusion = !hasOcclusion(s); }

bool hasOverlay(const State& s) { return s.view.layout.overlay; }
void toggleOverlay(State& s) { s.view.layout.overlay = !s.view.layout.overlay; }

Possible hasHelpers(const State& s) {
  const bool any = std::ranges::find(s.open.helperBones, true) != s.open.helperBones.end();
  return open(s).also(any, "Skin follows every bone: there are no helper bones");
}
bool showsHelpers(const State& s) { return s.view.outliner.helperBones; }
void toggleHelpers(State& s) { s.view.outliner.helperBones = !s.view.outliner.helperBones; }

Possible hiddenAny(const State& s) { return open(s).also(anythingHidden(s.document), "Nothing is hidden"); }
bool isIsolated(const State& s) { return s.document.visibility.isolated.has_value(); }
Possible isolatable(const State& s) { return isIsolated(s) ? idle(s) : selected(s); }
Possible lockedAny(const State& s) { return open(s).also(!s.document.visibility.locked.empty(), "Nothing is locked"); }
bool isBare(const State& s) { return s.document.visibility.bare; }

Possible exportedHere(const State& s) { return open(s).also(hasExportError(s), "Export the character first"); }
bool isExportErrorShown(const State& s) { return showsExportError(s); }
bool isExportBesideShown(const State& s) { return showsExportBeside(s); }

Possible reliefOf(const State& s) {
  const Possible clay = open(s).also(s.view.display.shading == Shading::kClay, "Show clay first");
  if (!clay) return clay;
  const auto embossed = [](const Material& material) { return material.normalMap.texture >= 0; };
  return clay.also(std::ranges::any_of(s.character().materials, embossed), "The character has no normal maps");
}

using D = DisplaySettings;

const Action kViewActions[] = {
    {"view/textured", "Textured", "The character's own materials", key(GLFW_KEY_1), kNone, open,
     isShaded<Shading::kTextured>, shade<Shading::kTextured>},
    {"view/clay", "Clay", "One plain material that shows the shape", key(GLFW_KEY_2), kNone, open,
     isShaded<Shading::kClay>, shade<Shading::kClay>},
    {"view/relief", "Relief on clay", "Show the materials' normal maps on clay", kNone, kNone, reliefOf,
     isShown<&D::relief>, toggleShown<&D::relief>},
    {"view/classes", "Zones",
     "Where muscles shape the skin, where they end, plain skin, cloth and rigid parts (triangle classes: implicit, "
     "straddling, normal)",
     key(GLFW_KEY_3), kNone, open, isShaded<Shading::kClasses>, shade<Shading::kClasses>},
    {"view/heat", "Displacement", "How far the skin was lifted or pushed in", key(GLFW_KEY_4), kNone, open,
     isShaded<Shading::kHeat>, shade<Shading::kHeat>},
    {"view/export-error", "Export error",
     "Error of the last export at this time: the live surface or the exported mesh, colored by distance", kNone, kNone,
     exportedHere, isExportErrorShown, toggleExportError},
    {"view/export-beside", "Export beside it",
     "The last export's mesh, as programs play it, beside the live surface; both colored by their distance", kNone,
     kNone, exportedHere, isExportBesideShown, toggleExportBeside},
    {"view/wire", "Wire", "Edges of the smoothed mesh (refined mesh)", key(GLFW_KEY_5), kNone, open, isShown<&D::wire>,
     toggleShown<&D::wire>, true},
    {"view/control-mesh", "Control mesh", "Edges of the mesh in the file", key(GLFW_KEY_6), kNone, open,
     isShown<&D::controlMesh>, toggleShown<&D::controlMesh>},
    {"view/skeleton", "Skeleton", "Bones, seen through the skin", key(GLFW_KEY_7), kNone, open, isShown<&D::skeleton>,
     toggleShown<&D::skeleton>},
    {"view/helper-bones", "Helper bones", "Show bones that no skin follows: targets, poles, sockets, ends", kNone,
     kNone, hasHelpers, showsHelpers, toggleHelpers},
    {"view/primitives", "Muscles", "All ellipsoids, not only the selected ones", key(GLFW_KEY_8), kNone, open,
     isShown<&D::primitives>, toggleShown<&D::primitives>},
    {"view/influence", "Influence", "How far the shown muscles reach", key(GLFW_KEY_9), kNone, open,
     isShown<&D::influence>, toggleShown<&D::influence>},
    {"view/anatomy", "Anatomy", "Muscles as flesh with tendons, the skin as glass over them; with Skeleton, bones too",
     key(GLFW_KEY_V), kNone, open, isShown<&D::anatomy>, toggleShown<&D::anatomy>},
    {"view/ground", "Ground", "Grid and shadow", key(GLFW_KEY_0), kNone, open, isShown<&D::ground>,
     toggleShown<&D::ground>},
    {"view/occlusion", "Ambient occlusion",
     "Darken crevices and folds; without a graphics processor, once nothing moves", kNone, kNone, open, hasOcclusion,
     toggleOcclusion},
    {"view/light-studio", "Studio light", "Soft light that goes around with the camera", kNone, kNone, open,
     isLit<LightPreset::kStudio>, light<LightPreset::kStudio>},
    {"view/light-outdoor", "Outdoor light", "A sun that stands still, under a blue sky", kNone, kNone, open,
     isLit<LightPreset::kOutdoor>, light<LightPreset::kOutdoor>},
    {"view/light-rim", "Rim light", "Strong light from behind that shows the outline", kNone, kNone, open,
     isLit<LightPreset::kRim>, light<LightPreset::kRim>},
    {"view/light-white", "White light", "One white lamp and no tone curve: to compare with other programs", kNone,
     kNone, open, isLit<LightPreset::kWhite>, light<LightPreset::kWhite>},
    {"view/background-studio", "Studio background", "A dark wall, lighter behind the character", kNone, kNone, open,
     isBehind<Backdrop::kStudio>, putBehind<Backdrop::kStudio>},
    {"view/background-dark", "Dark background", "One dark grey", kNone, kNone, open, isBehind<Backdrop::kDark>,
     putBehind<Backdrop::kDark>},
    {"view/background-mid", "Mid-grey background", "One medium grey", kNone, kNone, open, isBehind<Backdrop::kMid>,
     putBehind<Backdrop::kMid>},
    {"view/background-light", "Light background", "One light grey", kNone, kNone, open, isBehind<Backdrop::kLight>,
     putBehind<Backdrop::kLight>},
    {"view/background-gradient", "Gradient background", "Dark below, light above", kNone, kNone, open,
     isBehind<Backdrop::kGradient>, putBehind<Backdrop::kGradient>},
    {"view/background-checker", "Checkered background", "Squares of two greys", kNone, kNone, open,
     isBehind<Backdrop::kChecker>, putBehind<Backdrop::kChecker>},
    {"view/auto-depth", "Auto depth", "Choose the depth from the character's size on screen", kNone, kNone, idle,
     hasAutoDepth, toggleAutoDepth},
    {"view/numbers", "Numbers", "Frame rate and counts over the picture", kNone, kNone, open, hasOverlay,
     toggleOverlay},
    {"view/before", "Without muscles", "Show the character without its muscles while the key is held",
     key(GLFW_KEY_GRAVE_ACCENT), kNone, idle, isBare, latchBare, true},
    {"view/flex", "Flex muscles", "Flex every muscle that has a line while the key is held", shift(GLFW_KEY_F), kNone,
     hasLines, isFlexed, latchFlex, true},
    {"view/hide", "Hide or show", "Hide the selected muscles: they no longer move the skin, but stay in the file",
     key(GLFW_KEY_H), kNone, selected, nullptr, onDocument<toggleHideSelection>},
    {"view/show-all", "Show all", "Show every muscle: hide, solo and isolate end", alt(GLFW_KEY_H), kNone, hiddenAny,
     nullptr, onDocument<showAll>},
    {"view/isolate", "Isolate", "Show only the selected muscles, or show all again", key(GLFW_KEY_SLASH),
     key(GLFW_KEY_KP_DIVIDE), isolatable, isIsolated, onDocument<toggleIsolation>},
    {"view/lock", "Lock or unlock", "Locked muscles cannot be picked or moved in the picture", kNone, kNone, selected,
     nullptr, onDocument<toggleLockSelection>},
    {"view/unlock-all", "Unlock all", "Make every muscle pickable again", kNone, kNone, lockedAny, nullptr,
     onDocument<unlockAll>},
    {"view/frame", "Frame selection", "Fit the selected muscles, or all, into the picture", key(GLFW_KEY_F), kNone,
     open, nullptr, frame, true},
    {"view/frame-all", "Frame all", "Fit the whole character into the picture", key(GLFW_KEY_A), key(GLFW_KEY_HOME),
     open, nullptr, frameAll},
    {"view/front", "Front", "Look at the front", key(GLFW_KEY_KP_1), kNone, open, nullptr, look<StandardView::kFront>},
    {"view/back", "Back", "Look at the back", ctrl(GLFW_KEY_KP_1), kNone, open, nullptr, look<StandardView::kBack>},
    {"view/left", "Left", "Look at the character's left", key(GLFW_KEY_KP_3), kNone, open, nullptr,
     look<StandardView::kLeft>},
    {"view/right", "Right", "Look at the character's right", ctrl(GLFW_KEY_KP_3), kNone, open, nullptr,
     look<StandardView::kRight>},
    {"view/top", "Top", "Look from above", key(GLFW_KEY_KP_7), kNone, open, nullptr, look<StandardView::kTop>},
    {"view/bottom", "Bottom", "Look from below", ctrl(GLFW_KEY_KP_7), kNone, open, nullptr,
     look<StandardView::kBottom>},
    {"view/orthographic", "Orthographic", "No perspective", key(GLFW_KEY_KP_5), kNone, open, isOrthographic,
     toggleOrthographic},
    {"view/reference", "Reference picture...",
     "Reference pictures behind or over the character, from the front, the back, the sides and the top", kNone, kNone,
     open, isReferenceShown, toggleReferencePanel, true},
};

Possible playable(const State& s) {
  const bool any = s.hasCharacter() && !s.character().clips.empty();
  return open(s)
      .also(any, "The character has no clips")
      .also(any && s.open.transport.clip >= 0, "Choose a clip first")
      .also(any && clipDuration(s.open.transport, s.character()) > 0.0, "The clip is a single pose");
}
void togglePlay(State& s) { togglePlaying(s.open.transport, s.character()); }
void next(State& s) { stepFrames(s.open.transport, 1, s.character()); }
void previous(State& s) { stepFrames(s.open.transport, -1, s.character()); }
void toStart(State& s) { s.open.transport.time = playRange(s.open.transport, s.character()).from; }
void toEnd(State& s) {
  s.open.transport.time = playRange(s.open.transport, s.character()).to;
  s.open.transport.playing = false;
}
/// A range is a step of the history: no other edit may be in progress.
Possible rangeable(const State& s) {
  const Possible plays = playable(s);
  return plays ? idle(s) : plays;
}
Possible hasRange(const State& s) {
  return rangeable(s).also(hasPlayRange(s.open.transport), "The whole clip plays already");
}
void startRange(State& s) {
  setPlayRange(s.open.transport, {s.open.transport.time, playRange(s.open.transport, s.character()).to}, s.character());
  keepPlayRange(s);
}
void endRange(State& s) {
  setPlayRange(s.open.transport, {playRange(s.open.transport, s.character()).from, s.open.transport.time},
               s.character());
  keepPlayRange(s);
}
void wholeClip(State& s) {
  s.open.transport.ranges.erase(s.open.transport.clip);
  keepPlayRange(s);
}
bool isLooping(const State& s) { return s.open.transport.loop; }
void toggleLoop(State& s) { s.open.transport.loop = !s.open.transport.loop; }

Possible checkable(const State& s) {
  return idle(s).also(!s.document.rig().primitives.empty(), "There is no muscle to check");
}

Possible hasClipFiles(const State& s) {
  return idle(s).also(!s.document.rig().clipFiles.empty(), "No clip file was added");
}
bool showsClipList(const State& s) { return s.open.clipList.shown; }

const Action kPlayActions[] = {
    {"play/toggle", "Play or pause", "Start or stop the clip", key(GLFW_KEY_SPACE), kNone, playable, nullptr,
     togglePlay},
    {"play/previous", "Previous frame", "One frame back", key(GLFW_KEY_COMMA), key(GLFW_KEY_LEFT), playable, nullptr,
     previous},
    {"play/next", "Next frame", "One frame forward", key(GLFW_KEY_PERIOD), key(GLFW_KEY_RIGHT), playable, nullptr,
     next},
    {"play/start", "To the start", "Jump to the start of what plays", ctrl(GLFW_KEY_LEFT), kNone, playable, nullptr,
     toStart},
    {"play/end", "To the end", "Jump to the end of the clip", ctrl(GLFW_KEY_RIGHT), kNone, playable, nullptr, toEnd},
    {"play/loop", "Loop", "Start again at the end", key(GLFW_KEY_L), kNone, playable, isLooping, toggleLoop, true},
    {"play/range-start", "Begin the range here", "Play only what comes after the current time", key('['), kNone,
     rangeable, nullptr, startRange},
    {"play/range-end", "End the range here", "Play only what comes before the current time", key(']'), kNone, rangeable,
     nullptr, endRange},
    {"play/range-clear", "Play the whole clip", "Clear the range that plays", kNone, kNone, hasRange, nullptr,
     wholeClip},
    {"play/range-of-motion", "Range of motion",
     "Move every joint through its range, one after another: a clip made from the skeleton", kNone, kNone, idle,
     nullptr, playRangeOfMotion, true},
    {"play/clip-files", "Clip files", "Files whose clips were added: see mismatches, remove or locate files", kNone,
     kNone, open, showsClipList, toggleClipList},
    {"play/read-clip-files", "Read clip files again", "Reload clip files that other programs have changed", kNone,
     kNone, hasClipFiles, nullptr, readClipFilesAgain},
    {"play/check", "Check muscles",
     "Check all clips for muscles that leave the body, bulge into a ball or reach another limb", kNone, kNone,
     checkable, nullptr, checkMuscles},
};

template <std::size_t kIndex>
bool isTool(const State& s) {
  return s.view.tools.tool == static_cast<ToolKind>(kIndex);
}
template <std::size_t kIndex>
void chooseTool(State& s) {
  endTerritoryMode(s.view.tools);  // Which would take the tool's clicks.
  setTool(s.view.tools, static_cast<ToolKind>(kIndex));
}

Possible posing(const State& s) {
  return idle(s).also(s.view.tools.tool == ToolKind::kPose, "Choose the Pose tool first");
}
Possible anyPosed(const State& s) { return idle(s).also(isPosed(s), "No joint is turned by hand"); }
Possible jointPosed(const State& s) {
  return idle(s).also(selectedJointIsPosed(s), "Select a joint that is turned by hand first");
}
Possible canPastePose(const State& s) { return idle(s).also(!s.view.copiedPose.empty(), "Copy a pose first"); }
bool holdsPose(const State& s) { return s.open.transport.overrides.from == TurnsFrom::kBindPose; }

bool boxing(const State& s) { return s.view.tools.box.armed; }
void toggleBox(State& s) { armBox(s.view.tools); }
bool pivotsOnAll(const State& s) { return s.view.tools.pivot == GizmoPivot::kCentroid; }
void togglePivot(State& s) { s.view.tools.pivot = pivotsOnAll(s) ? GizmoPivot::kActive : GizmoPivot::kCentroid; }

template <ToolKind kTool>
void dragAtOnce(State& s) {
  startDrag(s.view.tools, kTool);
}

Possible territoryKnown(const State& s) {
  if (editsTerritory(s)) return {};
  return selected(s).also(activeSheet(s.document) < 0, "A sheet moves the skin that it lies on");
}

const Action kOthers[] = {
    {"tool/grab", "Grab", "Move the selected muscle with the pointer, without its handles; a click keeps it", kNone,
     kNone, selected, nullptr, dragAtOnce<ToolKind::kMove>, true},
    {"tool/turn", "Turn", "Turn the selected muscle with the pointer; a click keeps it", kNone, kNone, selected,
     nullptr, dragAtOnce<ToolKind::kRotate>},
    {"tool/size", "Resize", "Scale the selected muscle with the pointer; a click keeps it", kNone, kNone, selected,
     nullptr, dragAtOnce<ToolKind::kScale>},
    {"tool/axes", "Turn handles", "Align the handles with the world, the bone or the muscle", key(GLFW_KEY_X), kNone,
     idle, nullptr, cycleAxes, true},
    {"tool/pivot", "Pivot in the middle", "Rotate several muscles about their center, not about the active one",
     shift(GLFW_KEY_X), kNone, idle, pivotsOnAll, togglePivot},
    {"tool/box-select", "Box select", "Draw a box around muscles: Shift adds, Alt removes. Ctrl+drag does the same",
     shift(GLFW_KEY_B), kNone, idle, boxing, toggleBox},
    {kTerritoryTool.id, kTerritoryTool.label, kTerritoryTool.hint, key(kTerritoryTool.key), kNone, territoryKnown,
     editsTerritory, toggleTerritoryMode, true},
    {"tool/pose-reset-joint", "Reset joint", "Return the selected joint to the clip or the bind pose", alt(GLFW_KEY_P),
     kNone, jointPosed, nullptr, resetJoint, true},
    {"tool/pose-reset", "Reset pose", "Undo every turn made by hand", shift(GLFW_KEY_P), kNone, anyPosed, nullptr,
     resetPose},
    {"tool/pose-mirror", "Mirror pose",
     "Copy the selected joint's side to the other side; with no joint selected, swap left and right",
     ctrlShift(GLFW_KEY_P), kNone, anyPosed, nullptr, mirrorPose},
    {"tool/pose-copy", "Copy pose", "Copy how the joints are turned", kNone, kNone, anyPosed, nullptr, copyPose},
    {"tool/pose-paste", "Paste pose", "Turn the joints as in the copied pose", kNone, kNone, canPastePose, nullptr,
     pastePose},
    {"tool/pose-hold", "Hold turned joints", "Keep turned joints still while the clip moves the others", kNone, kNone,
     idle, holdsPose, toggleHoldPose},
    {"tool/pose-parent", "Parent joint", "Select the parent of the selected joint", key(GLFW_KEY_UP), kNone, posing,
     nullptr, onDocument<selectParentJoint>},
    {"tool/pose-child", "Child joint", "Select the first child of the selected joint", key(GLFW_KEY_DOWN), kNone,
     posing, nullptr, selectChildJoint},
};

/// A row for each tool, then the others.
template <std::size_t... kIndices>
std::vector<Action> withTools(std::index_sequence<kIndices...>) {
  std::vector<Action> all{{tools()[kIndices]->id, tools()[kIndices]->label, tools()[kIndices]->hint,
                           tools()[kIndices]->shift ? shift(tools()[kIndices]->key) : key(tools()[kIndices]->key),
                           kNone, idle, isTool<kIndices>, chooseTool<kIndices>}...};
  all.insert(all.end(), std::begin(kOthers), std::end(kOthers));
  return all;
}

}  // namespace

std::span<const Action> viewActions() { return kViewActions; }
std::span<const Action> playActions() { return kPlayActions; }

std::span<const Action> toolActions() {
  static const std::vector<Action> all = withTools(std::make_index_sequence<kToolCount>());
  return all;
}

}  // namespace sinew::app::table
