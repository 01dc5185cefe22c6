// app/editor/document_view.h: state of the editor that resets with each document.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "app/document/file_stamp.h"
#include "app/document/playback.h"
#include "app/document/sculpt_fit_job.h"
#include "app/viewport/render/reference_picture.h"
#include "app/viewport/tools/select.h"
#include "core/bodies/body_map.h"
#include "core/bodies/check.h"
#include "core/bodies/fit_preset.h"
#include "core/bodies/motions.h"
#include "core/rig/line_edit.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/surface.h"

namespace sinew::app {

// Keys and drivers.

/// A number of the rig whose owner survives renames, undo and redo.
struct HeldNumber {
  Parameter parameter = Parameter::kAmount;
  PrimitiveId primitive;          ///< 0: not a muscle's.
  LineId line;                    ///< 0: not a line's.
  std::string morph{};            ///< Name of the shape; "": not a shape's.
  std::array<GroupId, 2> link{};  ///< Groups of the link; 0: not a link's.

  friend bool operator==(const HeldNumber&, const HeldNumber&) = default;
};

/// Set driven key: edits of these numbers become points at the current input.
struct DrivenKeyMode {
  std::vector<HeldNumber> numbers;  ///< Of one parameter, the shown one first; empty: off.
  DriverInput input;

  [[nodiscard]] bool isOn() const { return !numbers.empty(); }
};

/// A drag of a curve's point or of a key in the timeline.
struct PointDrag {
  std::string item;      ///< Id of the widget; "": none.
  int point = -1;        ///< Index when the drag began.
  glm::vec4 axes{0.0f};  ///< Low x, low y, high x, high y of the curve during the drag.
  glm::vec2 grip{0.0f};  ///< From the point to the pointer, window coordinates.
};

/// A point of a driver's curve.
struct CurvePoint {
  HeldNumber number;
  int driver = -1;  ///< Index; -1: none.
  int point = -1;
  std::string sheet = {};  ///< A profile of this sheet instead;
  bool along = false;      ///< along its strips, else across.

  friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

/// A number with its drawn value at the last key.
struct KeyedNumber {
  HeldNumber number;
  float drawn = 0.0f;
};

struct AnimateState {
  std::vector<KeyedNumber> keyed;
  std::vector<HeldNumber> pointed;  ///< Under the pointer in the last frame, the shown one first.
  DrivenKeyMode drivenKey;
  PointDrag drag;
  CurvePoint chosen;           ///< Its numbers are shown under the curve.
  CurvePoint pointedPoint;     ///< Under the pointer in the last frame, for Delete.
  std::string menuRow;         ///< Id of the timeline's row with an open menu,
  int menuKey = -1;            ///< and its key; -1: none.
  bool sectionWanted = false;  ///< The inspector unfolds Animation and scrolls to it.
};

/// A muscle's name being typed in the outliner.
struct RenameState {
  PrimitiveId primitive;  ///< 0 if none.
  std::string text;
  bool appearing = false;
};

/// Angles as typed, so that they do not change when shown. Valid while `rotation` is the primitive's.
struct EulerState {
  PrimitiveId primitive;
  glm::quat rotation{0.0f, 0.0f, 0.0f, 0.0f};
  glm::vec3 degrees{0.0f};
};

struct GroupRename {
  GroupId group;  ///< 0 if none.
  std::string text;
  bool appearing = false;
};

/// The groups panel.
struct BlendingState {
  GroupId group;  ///< The chosen one; 0: none.
  GroupRename rename;
  std::map<GroupId, glm::vec2> places;  ///< Nodes, design pixels; kept for removed groups.
  glm::vec2 pan{0.0f};                  ///< Of the graph, design pixels.
  float zoom = 1.0f;
  bool fitWanted = true;                  ///< Fit all nodes into the canvas.
  GroupId linkFrom;                       ///< A link is being dragged from this group; 0: none.
  std::array<GroupId, 2> shownLink{};     ///< Whose amount the graph's menu shows.
  std::array<GroupId, 2> animatedLink{};  ///< Whose keys and drivers are shown below; 0: of none.
};

/// The track of one clip.
struct TimelineState {
  int clip = -1;
  PlayRange shown;             ///< Visible part of the clip, seconds.
  PlayRange grabbed;           ///< The range when its bar was grabbed.
  double grabbedAt = 0.0;      ///< Where, seconds.
  std::vector<float> density;  ///< Keys per column of the track, 0..1 of the fullest, for `densityOf`.
  PlayRange densityOf;
};

struct ViewportMenuState {
  ViewportHover target;
  bool wanted = false;  ///< Opens with the next frame.
};

/// Flexing of muscle lines in the picture.
struct FlexState {
  float amount = 0.0f;         ///< Of the slider, 0..1.
  bool selectedAlone = false;  ///< Only lines of selected muscles, if there are any.
  bool latched = false;        ///< Fully flexed, by menu or while the key is held.
  bool byKey = false;

  [[nodiscard]] float shown() const { return latched ? 1.0f : amount; }
};

/// Lengths of a muscle line over the shown clip.
struct LineRangeState {
  std::optional<MuscleLine> line;
  int clip = -1;
  LineLengths lengths;
};

/// Play > Check muscles.
struct CheckState {
  bool shown = false;
  std::size_t revision = 0;  ///< CommandStack::revision() of the checked rig.
  std::vector<Finding> findings;
  std::vector<PrimitiveId> muscles;  ///< [findings]
  int chosen = -1;                   ///< Index into findings; -1: none.
};

/// The last added set of muscles, while its sliders can still change it.
struct MuscleSetState {
  bool shown = false;
  std::size_t revision = 0;  ///< CommandStack::revision() with the set.
  std::vector<Preset> sets;  ///< For this kind of body.
  int chosen = 0;            ///< Index into sets.
  PresetTuning tuning;
  PresetTuning kept;                 ///< In the step; `tuning` differs while a slider is dragged.
  bool previews = false;             ///< A slider is being dragged.
  std::vector<std::string> muscles;  ///< Without sides.
  std::vector<FittedPreset::LeftOut> leftOut;
  std::vector<std::string> mended;
  std::shared_ptr<const Motions> motions;  ///< The character's; made when first needed.
};

/// Muscles > Fit to a sculpt.
struct SculptFitState {
  bool shown = false;
  std::filesystem::path file;
  std::shared_ptr<const ControlMesh> sculpt;
  float hold = kDefaultHold;  ///< As SculptFitOptions, and so are the next two.
  int carves = 0;
  bool mirror = true;

  Rig start;                        ///< Before the panel's step.
  std::optional<SculptFitJob> job;  ///< The running fit.
  bool again = false;               ///< It replaces the panel's step.
  std::size_t revision = 0;         ///< CommandStack::revision() when it began; afterwards that with its step.
  std::string complaint;            ///< Why the last fit failed; "": it did not.
  std::optional<SculptFit> result;  ///< Of the panel's step.
  std::vector<Finding> findings;    ///< Of the result.
  std::size_t made = 0;             ///< Number of results.

  bool showsLeft = false;
  Surface surface;           ///< The live surface, with what is left as displacement.
  std::size_t leftOf = 0;    ///< 1 + revision of the live surface; 0: none.
  std::size_t leftMade = 0;  ///< `made` of that.
  std::size_t pictures = 0;  ///< Grows with each update of `surface`.
};

/// Muscles > Parts of the body.
struct BodyPartsState {
  bool shown = false;
  bool asAnimal = false;                ///< Lists an animal's parts while the kind of body is unknown.
  int hovered = -1;                     ///< Index into allBodySlots(), under the pointer.
  std::optional<std::size_t> revision;  ///< CommandStack::revision() for `slots`.
  BodySlots slots;
};

/// Play > Clip files.
struct ClipListState {
  bool shown = false;
  std::set<std::string> changed;  ///< Files changed since they were read, as in the rig.
  /// Last looks by file, and by "file\npath" for buffers of a .gltf; the file is "" for the character's buffers.
  std::map<std::string, DiskLook> looks;
};

/// View > Reference picture.
struct ReferenceState {
  bool shown = false;  ///< The panel.
  ReferenceSide side = ReferenceSide::kFront;
  ReferencePictures pictures;

  [[nodiscard]] ReferencePicture& chosen() { return pictures[static_cast<std::size_t>(side)]; }
};

struct ShapesState {
  std::string search;
  std::set<std::string> folded;  ///< First parts of names.
  std::string chosen;            ///< The shape with unfolded keys and drivers; "": none.
};

struct LayersState {
  int chosen = -1;             ///< Index into Character::parts, highlighted in the picture; -1: none.
  std::vector<int> triangles;  ///< [parts] of the file; counted when first shown.
};

struct LibraryState {
  std::optional<std::vector<SlotCorrection>> readFor;  ///< Rig::slots when read; nullopt: read again.
  std::size_t reads = 0;                               ///< Number of reads.
  std::vector<Preset> sets;                            ///< For this kind of body.
  std::string why;                                     ///< Why there are no sets.
  std::shared_ptr<const MeasuredBody> body;
  std::vector<FittedPreset> laid;  ///< [sets] Fitted to this body, for their pictures.
  std::set<std::string> folded;    ///< Names of sets.
  std::string search;

  /// A muscle being dragged out of it; set -1: none.
  struct Drag {
    int set = -1;
    int muscle = -1;
    std::string says;  ///< Effect of a drop.
  } drag;

  bool naming = false;  ///< The name of a new set is being typed.
  bool appearing = false;
  std::string name;
  std::string notice;      ///< Why it is not saved yet.
  bool replacing = false;  ///< The notice warns about replacing a set.
};

struct DocumentView {
  Transport transport;
  FlexState flex;
  LineRangeState lineRange;
  CheckState check;
  MuscleSetState muscleSet;
  SculptFitState sculptFit;
  BodyPartsState bodyParts;
  ClipListState clipList;
  ReferenceState reference;
  ShapesState shapes;
  LayersState layers;
  LibraryState library;
  std::vector<bool> helperBones;  ///< [bones] From core/character/bindings.h.
  TimelineState timeline;
  RenameState rename;
  EulerState euler;
  BlendingState blending;
  AnimateState animate;
  std::string rowAnchor;  ///< Key of the outliner's row where a range starts.
  ViewportMenuState viewportMenu;
  PrimitiveId revealed;          ///< The outliner last scrolled to this muscle.
  std::size_t historyShown = 0;  ///< The history last scrolled to this step.
  unsigned gestureItem = 0;      ///< ImGui id of the field being dragged or typed into; 0: none.
  std::string refusal;           ///< Why the last edit was refused; "" after an accepted one.
  DiskLook disk;                 ///< Of the rig's file.
  DiskLook characterLook;        ///< Of the character's file.
  std::size_t messagesSeen = 0;  ///< SessionState::messagesSaid when the list was last drawn.
  bool frameWanted = false;      ///< Frame the character in the next frame.
};

}  // namespace sinew::app
