// app/editor/view_state.h: what stays as it is when another document is opened: how the designer looks and works.
#pragma once

#include <array>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "app/document/preferences.h"
#include "app/viewport/render/scene.h"
#include "app/viewport/tools/input_router.h"

namespace sinew::app {

enum class LeftTab { kMuscles, kGroups, kLibrary, kShapes };

/// What the rows of the muscles stand under: the tree of bones, or a flat list.
enum class OutlinerOrder { kBones, kRegions, kGroups };

/// Rows have keys: "m:" and a muscle's identity, or "b:" and a bone's path.
struct OutlinerState {
  LeftTab tab = LeftTab::kMuscles;
  OutlinerOrder order = OutlinerOrder::kBones;
  bool onlyWithMuscles = false;  ///< Bones without a muscle on them or below are left out.
  std::set<std::string> folded;  ///< Paths of the bones, and names of the parts of a flat list, that are closed.
  bool unattachedFolded = false;
  bool helperBones = false;  ///< Bones that move no skin are shown, in the picture as well.
};

struct InspectorState {
  bool percent = false;        ///< Lengths in per cent of the height, else in character units.
  bool shapeOpen = false;      ///< The rows that change a muscle's shape are unfolded.
  bool territoryOpen = false;  ///< The list of a default territory's bones is unfolded.
  std::string boneFilter;      ///< Typed into the list of bones that is open.
  bool animationOpen = false;  ///< Drivers and keys are unfolded.
};

/// "Before": the character without muscles while a key or a button is held.
struct BareState {
  bool latched = false;  ///< Switched on from a menu; or the key went down and is not up yet.
  bool byKey = false;
};

inline constexpr std::size_t kFirstSteps = 5;

/// Help > First steps.
struct FirstStepsState {
  bool shown = false;
  std::array<bool, kFirstSteps> done{};
  std::size_t document = 0;        ///< SessionState::documentsOpened that what follows is of.
  CameraStand stand;               ///< As the document was opened.
  std::shared_ptr<const Rig> rig;  ///< Likewise.
};

struct ViewState {
  DisplaySettings display;
  ViewportTools tools;
  LayoutState layout;
  OutlinerState outliner;
  std::string outlinerFilter;
  bool groupsAsGraph = false;  ///< Nodes and edges instead of the matrix.
  InspectorState inspector;
  BareState bare;
  FirstStepsState firstSteps;
  std::vector<std::pair<std::string, glm::quat>> copiedPose;  ///< Joints by file name, and their turns.
};

}  // namespace sinew::app
