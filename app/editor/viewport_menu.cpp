// app/editor/viewport_menu.cpp: what the picture's context menu does that no other menu does.

#include "app/editor/viewport_menu.h"

#include <array>

#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/symmetry_commands.h"
#include "app/editor/visibility_commands.h"
#include "app/viewport/tools/territory_tool.h"

namespace sinew::app {
namespace {

bool hasMuscle(const EditorState& state) { return state.document.activePrimitive() >= 0; }
bool onBone(const EditorState& state) { return territorySubject(state.document) >= 0; }
bool mirrors(const EditorState& state) { return canMirror(state.document); }
bool hasBone(const EditorState& state) { return state.document.selection.bone >= 0; }
bool hidesSome(const EditorState& state) { return anythingHidden(state.document); }
bool anyMuscle(const EditorState& state) { return !state.document.rig().primitives.empty(); }

/// What an action needs, and what to say where it is missing. The first that fails counts.
struct Need {
  std::string_view action;
  bool (*holds)(const EditorState&);
  const char* otherwise;
};

constexpr const char* kNoMuscle = "There is no muscle here";

constexpr std::array kNeeds{
    Need{"view/isolate", hasMuscle, kNoMuscle},
    Need{"view/hide", hasMuscle, kNoMuscle},
    Need{"view/lock", hasMuscle, kNoMuscle},
    Need{"edit/mirror", hasMuscle, kNoMuscle},
    Need{"edit/mirror", mirrors, "This character's bones do not come in left and right pairs"},
    Need{"edit/duplicate", hasMuscle, kNoMuscle},
    Need{"edit/rename", hasMuscle, kNoMuscle},
    Need{"edit/delete", hasMuscle, kNoMuscle},
    Need{"tool/territory", hasMuscle, kNoMuscle},
    Need{"tool/territory", onBone, "The muscle's bone is not in this character"},
    Need{"edit/add-on-bone", hasBone, "There is no bone here"},
    Need{"edit/select-on-bone", anyMuscle, "There are no muscles yet"},
    Need{"edit/select-all", anyMuscle, "There are no muscles yet"},
    Need{"view/show-all", hidesSome, "Nothing is hidden"},
};

}  // namespace

void selectEntry(Document& document, const PickEntry& entry) {
  if (entry.muscle) {
    document.selection.set(entry.muscle);
  } else {
    document.selection.clear();
    document.selection.bone = entry.bone;
  }
}

void selectForMenu(Document& document, const ViewportHover& target) {
  if (target.here.empty()) return;
  const PickEntry& entry = target.here[target.at];
  if (!entry.muscle || !document.selection.contains(entry.muscle)) selectEntry(document, entry);
}

void addMuscleAt(EditorState& state, const ViewportHover& target) {
  if (!state.hasCharacter() || isBusy(state) || !target.skin) return;
  const Pose& pose = state.live->pose();
  ViewportHover now = target;
  now.pointInWorld = skinPointAt(state.character(), pose, *target.skin).point;
  const ViewportContext context{state.document, pose, *state.live, state.view.display, state.frame.viewportPixels};
  AddMuscleState adding;
  if (const Result<void> begun = beginAddMuscle(adding, context, now, glm::vec2(0.0f)); !begun) {
    refuse(state, begun.error());
    return;
  }
  state.document.commands.endGesture();
  state.open.refusal.clear();
}

std::string whyDisabled(const EditorState& state, std::string_view actionId) {
  if (isBusy(state)) return "Not while something is being dragged or typed";
  for (const Need& need : kNeeds) {
    if (need.action == actionId && !need.holds(state)) return need.otherwise;
  }
  return "";
}

}  // namespace sinew::app
