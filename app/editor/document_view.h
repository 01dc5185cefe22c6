// app/editor/document_view.h: what the editor remembers about the open document; begins anew with each one.
#pragma once

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
#include "app/viewport/render/reference_picture.h"
#include "app/viewport/tools/select.h"
#include "core/bodies/body_map.h"
#include "core/bodies/check.h"
#include "core/bodies/fit_preset.h"
#include "core/bodies/motions.h"
#include "core/rig/line_fitting.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

// What the editor remembers while numbers are keyed and driven.

/// A number of the rig that keeps its owner through renames, undo and redo.
struct HeldNumber {
  Parameter parameter = Parameter::kAmount;
  PrimitiveId primitive;  ///< 0 if it is not a muscle's.
  LineId line;            ///< 0 if it is not a line's.
  std::string morph{};    ///< Name of the shape; empty if it is not one's.

  friend bool operator==(const HeldNumber&, const HeldNumber&) = default;
};

/// Set driven key: an edit of these numbers becomes a point at where the input is now.
struct DrivenKeyMode {
  std::vector<HeldNumber> numbers;  ///< One parameter's, the shown one first; empty: off.
  DriverInput input;

  [[nodiscard]] bool isOn() const { return !numbers.empty(); }
};

/// A drag of a point of a curve, or of a key in the timeline.
struct PointDrag {
  std::string item;      ///< Id of the widget; empty: none.
  int point = -1;        ///< Index when the drag began.
  glm::vec4 axes{0.0f};  ///< Least x, least y, most x, most y that the curve shows meanwhile.
  glm::vec2 grip{0.0f};  ///< From the point to the pointer, window coordinates.
};

/// A point of a driver's curve.
struct CurvePoint {
  HeldNumber number;
  int driver = -1;  ///< Index; -1: none.
  int point = -1;

  friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

/// A number as it was drawn when it was keyed last.
struct KeyedNumber {
  HeldNumber number;
  float drawn = 0.0f;
};

struct AnimateState {
  std::vector<KeyedNumber> keyed;
  std::vector<HeldNumber> pointed;  ///< In the field that was under the pointer last frame, the shown one first.
  DrivenKeyMode drivenKey;
  PointDrag drag;
  CurvePoint chosen;           ///< Its numbers are shown under the curve.
  CurvePoint pointedPoint;     ///< Under the pointer in the last frame: what Delete removes.
  std::string menuRow;         ///< Id of the timeline's row whose menu is open,
  int menuKey = -1;            ///< and which key it was asked for on; -1: beside them.
  bool sectionWanted = false;  ///< The inspector unfolds Animation and scrolls to it with the next frame.
};

/// A muscle's name being typed in the outliner.
struct RenameState {
  PrimitiveId primitive;  ///< 0 if none.
  std::string text;
  bool appearing = false;
};

/// Angles as typed, so that showing them back never changes them. Valid while `rotation` is the primitive's.
struct EulerState {
  PrimitiveId primitive;
  glm::quat rotation{0.0f, 0.0f, 0.0f, 0.0f};
  glm::vec3 degrees{0.0f};
};

/// A group's name being typed.
struct GroupRename {
  GroupId group;  ///< 0 if none.
  std::string text;
  bool appearing = false;
};

/// The groups panel.
struct BlendingState {
  GroupId group;  ///< The chosen one; 0 if none.
  GroupRename rename;
  std::map<GroupId, glm::vec2> places;  ///< Nodes, design pixels; kept for groups that undo may bring back.
  glm::vec2 pan{0.0f};                  ///< Design pixels: what the graph's origin is moved by.
  float zoom = 1.0f;
  bool fitWanted = true;  ///< Bring all nodes into the canvas with the next frame.
  GroupId linkFrom;       ///< A link is being dragged from this group; 0 if none.
};

/// The track. Belongs to one clip; another starts from the defaults.
struct TimelineState {
  int clip = -1;
  PlayRange shown;             ///< The part of the clip that the track spans, seconds.
  PlayRange grabbed;           ///< The range when its bar was grabbed.
  double grabbedAt = 0.0;      ///< Where, seconds.
  std::vector<float> density;  ///< Keys per column of the track, 0..1 of the fullest; made for `densityOf`.
  PlayRange densityOf;
};

/// The context menu of the picture.
struct ViewportMenuState {
  ViewportHover target;  ///< What it was asked for on.
  bool wanted = false;   ///< Opens with the next frame.
};

/// How hard muscle lines are flexed in the picture; not in the file.
struct FlexState {
  float amount = 0.0f;         ///< The slider's, 0..1.
  bool selectedAlone = false;  ///< Those of selected muscles, where any of them is on a line.
  bool latched = false;        ///< Fully: switched on from a menu; or the key went down and is not up yet.
  bool byKey = false;

  [[nodiscard]] float shown() const { return latched ? 1.0f : amount; }
};

/// How long a muscle line gets in the clip that is shown: as long as line and clip stay the same.
struct LineRangeState {
  std::optional<MuscleLine> line;
  int clip = -1;
  LineLengths lengths;
};

/// What Play > Check muscles has found.
struct CheckState {
  bool shown = false;
  std::size_t revision = 0;  ///< CommandStack::revision() of the rig that was checked.
  std::vector<Finding> findings;
  std::vector<PrimitiveId> muscles;  ///< [findings]
  int chosen = -1;                   ///< The finding that was gone to; -1: none.
};

/// The set of muscles that was added last, while its sliders can still change it.
struct MuscleSetState {
  bool shown = false;
  std::size_t revision = 0;  ///< CommandStack::revision() of the rig as the set left it.
  std::vector<Preset> sets;  ///< For this kind of body.
  int chosen = 0;            ///< Index into sets.
  PresetTuning tuning;
  PresetTuning kept;                 ///< As the step has it; `tuning` differs while a slider is dragged.
  bool previews = false;             ///< A slider is being dragged.
  std::vector<std::string> muscles;  ///< Without sides.
  std::vector<FittedPreset::LeftOut> leftOut;
  std::vector<std::string> mended;
  std::shared_ptr<const Motions> motions;  ///< Of the character; made once.
};

/// Muscles > Parts of the body.
struct BodyPartsState {
  bool shown = false;
  bool asAnimal = false;                ///< Which parts are listed while the kind of body is unknown.
  int hovered = -1;                     ///< Index into allBodySlots(), of the row or dot under the pointer.
  std::optional<std::size_t> revision;  ///< CommandStack::revision() that `slots` were found for.
  BodySlots slots;
};

/// Play > Clip files.
struct ClipListState {
  bool shown = false;
  std::set<std::string> changed;  ///< Files that hold something else than was read, as the rig names them.
  /// The last ones at files, since they were read; at buffers of a .gltf by its name, a line break and their path. The
  /// character's own have no name.
  std::map<std::string, DiskLook> looks;
};

/// View > Reference picture.
struct ReferenceState {
  bool shown = false;                          ///< The panel.
  ReferenceSide side = ReferenceSide::kFront;  ///< That it is about.
  ReferencePictures pictures;

  [[nodiscard]] ReferencePicture& chosen() { return pictures[static_cast<std::size_t>(side)]; }
};

/// The tab Shapes.
struct ShapesState {
  std::string search;
  std::set<std::string> folded;  ///< First parts of names.
  std::string chosen;            ///< The shape whose keys and drivers are unfolded; empty: none.
};

/// The panel Layers.
struct LayersState {
  int chosen = -1;             ///< Index into Character::parts, of the part that is marked in the picture; -1: none.
  std::vector<int> triangles;  ///< [parts] of the file; counted when they are first shown.
};

/// The tab Library: the sets for this kind of body, to lay muscles of one at a time.
struct LibraryState {
  std::optional<std::vector<SlotCorrection>> readFor;  ///< Rig::slots that all below is for; nullopt: nothing is read.
  std::size_t reads = 0;                               ///< How often.
  std::vector<Preset> sets;
  std::string why;                           ///< There are no sets.
  std::shared_ptr<const MeasuredBody> body;  ///< Of the character.
  std::vector<FittedPreset> laid;            ///< [sets] as they would lie on this body: for pictures of them.
  std::set<std::string> folded;              ///< Names of sets.
  std::string search;

  /// A muscle that is being dragged out of it; set -1: none is.
  struct Drag {
    int set = -1;
    int muscle = -1;
    std::string says;  ///< What letting go would do.
  } drag;

  bool naming = false;  ///< A name for a new set is being typed.
  bool appearing = false;
  std::string name;
  std::string notice;      ///< Why it is not saved yet.
  bool replacing = false;  ///< The notice was that a set of that name would be replaced.
};

struct DocumentView {
  Transport transport;
  FlexState flex;
  LineRangeState lineRange;
  CheckState check;
  MuscleSetState muscleSet;
  BodyPartsState bodyParts;
  ClipListState clipList;
  ReferenceState reference;
  ShapesState shapes;
  LayersState layers;
  LibraryState library;
  std::vector<bool> helperBones;  ///< [bones] core/character/bindings.h
  TimelineState timeline;
  RenameState rename;
  EulerState euler;
  BlendingState blending;
  AnimateState animate;
  std::string rowAnchor;  ///< Key of the outliner's row where a range of rows starts.
  ViewportMenuState viewportMenu;
  PrimitiveId revealed;          ///< The muscle the outliner has scrolled to last.
  std::size_t historyShown = 0;  ///< The step the history has scrolled to last.
  unsigned gestureItem = 0;      ///< ImGui id of the field whose drag or typing is one undo step; 0: none.
  std::string refusal;           ///< Why the last edit was refused; "" after an accepted one.
  DiskLook disk;                 ///< The last look at the rig's file.
  DiskLook characterLook;        ///< ... at the character's.
  std::size_t messagesSeen = 0;  ///< SessionState::messagesSaid when the list was drawn last.
  bool frameWanted = false;      ///< Frame the character as soon as the viewport's size is known.
};

}  // namespace sinew::app
