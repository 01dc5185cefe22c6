// app/panels/animation_menu.cpp: the menu of a number that can be keyed and driven.

#include <algorithm>
#include <functional>
#include <set>

#include "app/document/shown_names.h"
#include "app/editor/animate.h"
#include "app/editor/visibility_commands.h"
#include "app/panels/field_edit.h"
#include "app/ui/reading_order.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

using Chosen = std::function<void(const DriverInput&)>;

bool row(PanelUi& ui, const std::string& label, const std::string& id, const Possible& possible = {},
         const std::string& hint = {}, const char* keys = nullptr) {
  const bool chosen = ImGui::MenuItem(inReadingOrder(label).c_str(), keys, false, possible);
  ui.widgets.note("context/" + id);
  const std::string why = possible ? hint : "Not available: " + std::string(possible.reason());
  if (!why.empty()) tooltip(ui, why);
  return chosen;
}

bool beginSubmenu(PanelUi& ui, const char* label, const std::string& id) {
  const bool open = ImGui::BeginMenu(inReadingOrder(label).c_str());
  if (!open) ui.widgets.note("context/" + id);  // If it is open, the last item is in the submenu's window.
  return open;
}

struct BoneChoice {
  std::vector<int> near;           ///< The bones of the numbers' muscles and lines, and their neighbors.
  std::vector<int> all;            ///< All bones that are not hidden.
  std::vector<std::string> names;  ///< [bones]
};

/// Adds the bone, its parent and its children.
void addNear(const Skeleton& skeleton, const std::string& name, std::vector<int>& near) {
  const std::optional<int> bone = skeleton.findBone(name);
  if (!bone) return;
  const auto add = [&](int candidate) {
    if (candidate >= 0 && std::ranges::find(near, candidate) == near.end()) near.push_back(candidate);
  };
  add(*bone);
  add(at(skeleton.bones, *bone).parent);
  for (int child = 0; child < static_cast<int>(skeleton.bones.size()); ++child) {
    if (at(skeleton.bones, child).parent == *bone) add(child);
  }
}

BoneChoice boneChoice(const PanelUi& ui, const AnimatedField& field) {
  const Rig& rig = ui.state.document.rig();
  const Skeleton& skeleton = ui.state.character().skeleton;
  BoneChoice choice;
  const auto addLine = [&](const MuscleLine& line) {
    addNear(skeleton, line.insertion.bone, choice.near);
    addNear(skeleton, line.origin.bone, choice.near);
  };
  for (const NumberRef& ref : field.refs) {
    const auto index = static_cast<std::size_t>(ref.owner);
    if (ownerOf(ref.parameter) == ParameterOwner::kLine) addLine(rig.lines[index]);
    if (ownerOf(ref.parameter) != ParameterOwner::kPrimitive) continue;
    if (const MuscleLine* line = lineOf(rig, rig.primitives[index])) addLine(*line);
    addNear(skeleton, rig.primitives[index].bone, choice.near);
  }
  const std::vector<bool> hidden = hiddenBones(ui.state);
  for (int bone = 0; bone < static_cast<int>(skeleton.bones.size()); ++bone) {
    if (!isHidden(hidden, bone)) choice.all.push_back(bone);
  }
  choice.names = shownFileNames(skeleton);
  return choice;
}

/// Draws a bone's row in a menu. @param id  of the widget
using BoneRow = std::function<void(int bone, const std::string& label, const std::string& id)>;

void boneRows(const PanelUi& ui, const BoneChoice& choice, const std::string& id, const BoneRow& draw) {
  const Skeleton& skeleton = ui.state.character().skeleton;
  const auto place = [&](int bone, const char* where) {
    ImGui::PushID(where);
    ImGui::PushID(bone);
    draw(bone, at(choice.names, bone), id + where + skeleton.fileName(bone));
    ImGui::PopID();
    ImGui::PopID();
  };
  for (const int bone : choice.near) place(bone, "/near/");
  if (!choice.near.empty()) ImGui::Separator();
  for (const int bone : choice.all) place(bone, "/");
}

void boneMenu(PanelUi& ui, const BoneChoice& choice, const char* label, const std::string& id, const BoneRow& draw) {
  if (!beginSubmenu(ui, label, id)) return;
  boneRows(ui, choice, id, draw);
  ImGui::EndMenu();
}

/// A row for each bone: the input is measured at it.
BoneRow inputRow(PanelUi& ui, DriverInputKind kind, const Chosen& chosen) {
  return [&ui, kind, &chosen](int bone, const std::string& label, const std::string& id) {
    if (!row(ui, label, id)) return;
    DriverInput input;
    input.kind = kind;
    input.bone = ui.state.character().skeleton.fileName(bone);
    chosen(kind == DriverInputKind::kPose ? poseInput(ui.state, bone) : input);
  };
}

/// A submenu for each bone: the axis of its rotation.
BoneRow axisMenu(PanelUi& ui, const Chosen& chosen) {
  return [&ui, &chosen](int bone, const std::string& label, const std::string& id) {
    if (!beginSubmenu(ui, label.c_str(), id)) return;
    for (int axis = 0; axis < 3; ++axis) {
      const char* letter = axis == 0 ? "X" : axis == 1 ? "Y" : "Z";
      if (!row(ui, std::string("About ") + letter, id + "/" + letter, {},
               "The axes are those of the pose tool's rings")) {
        continue;
      }
      DriverInput input;
      input.kind = DriverInputKind::kAxis;
      input.bone = ui.state.character().skeleton.fileName(bone);
      input.axis = glm::vec3(0.0f);
      input.axis[axis] = 1.0f;
      chosen(input);
    }
    ImGui::EndMenu();
  };
}

/// A submenu for each bone: the other end of the distance.
BoneRow distanceMenu(PanelUi& ui, const BoneChoice& choice, const Chosen& chosen) {
  return [&](int from, const std::string& label, const std::string& id) {
    if (!beginSubmenu(ui, label.c_str(), id)) return;
    const Skeleton& skeleton = ui.state.character().skeleton;
    boneRows(ui, choice, id, [&](int to, const std::string& name, const std::string& toId) {
      DriverInput input;
      input.kind = DriverInputKind::kDistance;
      input.from.bone = skeleton.fileName(from);
      input.to.bone = skeleton.fileName(to);
      const Possible apart(inputNow(ui.state, input).has_value(), "In the bind pose both are in one place");
      if (row(ui, "to " + name, toId, apart)) chosen(input);
    });
    ImGui::EndMenu();
  };
}

void lineMenu(PanelUi& ui, const std::string& id, const Chosen& chosen) {
  const std::vector<MuscleLine>& lines = ui.state.document.rig().lines;
  if (lines.empty() || !beginSubmenu(ui, "Length of", id)) return;
  for (const MuscleLine& line : lines) {
    DriverInput input;
    input.kind = DriverInputKind::kLength;
    input.line = line.name;
    if (!row(ui, line.name, id + "/" + line.name)) continue;
    chosen(input);
    break;  // The rig has changed.
  }
  ImGui::EndMenu();
}

void channelMenu(PanelUi& ui, const std::string& id, const Chosen& chosen, const std::function<void()>& made) {
  std::set<std::string> names;
  for (const RigChannel& channel : ui.state.document.rig().channels) names.insert(channel.name);
  if ((names.empty() && !made) || !beginSubmenu(ui, "Channel", id)) return;
  for (const std::string& name : names) {
    DriverInput input;
    input.kind = DriverInputKind::kChannel;
    input.channel = name;
    if (row(ui, name, id + "/" + name)) chosen(input);
  }
  if (made && !names.empty()) ImGui::Separator();
  if (made && row(ui, "New channel", id + "-new", {}, "A track of values over the clip, for drivers to read")) made();
  ImGui::EndMenu();
}

/// All kinds of input. @param made  creates a new channel; empty: not offered
void inputMenu(PanelUi& ui, const AnimatedField& field, const std::string& id, const Chosen& chosen,
               const std::function<void()>& made) {
  const BoneChoice choice = boneChoice(ui, field);
  boneMenu(ui, choice, "Bend of", id + "/bend", inputRow(ui, DriverInputKind::kBend, chosen));
  boneMenu(ui, choice, "Twist of", id + "/twist", inputRow(ui, DriverInputKind::kTwist, chosen));
  boneMenu(ui, choice, "Turn of", id + "/axis", axisMenu(ui, chosen));
  boneMenu(ui, choice, "Pose of", id + "/pose", inputRow(ui, DriverInputKind::kPose, chosen));
  boneMenu(ui, choice, "Distance from", id + "/distance", distanceMenu(ui, choice, chosen));
  lineMenu(ui, id + "/length", chosen);
  channelMenu(ui, id + "/channel", chosen, made);
}

void keyRows(PanelUi& ui, const AnimatedField& field) {
  EditorState& state = ui.state;
  const NumberRef& shown = field.refs.front();
  const KeyTrack* track = trackNow(state, shown);
  const auto text = [&](float value) { return numberText(field.format, value * field.scales.front()); };
  const Possible timed = hasKeyTime(state);
  const std::string drawn = text(numberOf(state.document.rig(), shown));
  const std::string keys = keyText(action("edit/key"), state);
  const bool here = row(ui, field.refs.size() > 1 ? "Key here" : "Key " + drawn + " here", "key", timed,
                        "A key with the number in the field, at this moment of the clip", keys.c_str());
  bool keyed = false;
  if (track != nullptr) {
    const std::string now = text(valueAt(track->curve, timeNow(state)));
    keyed = row(ui, "Key " + now + " here, as the keys have it", "key-now", timed,
                "A key between the others that changes nothing yet");
  }
  const bool stands = track != nullptr && keyNow(state, *track) >= 0;
  const bool remove =
      row(ui, "Remove key here", "key-remove", timed.also(stands, "There is no key of it at this moment"));
  const bool clear =
      row(ui, "Remove keys of this clip", "keys-remove", timed.also(track != nullptr, "It has no keys in this clip"));
  if (here) keyNumbers(state, field.refs, KeyValue::kDrawn);
  if (keyed) keyNumbers(state, field.refs, KeyValue::kKeyed);
  if (remove) removeKeysNow(state, field.refs);
  if (clear) removeClipKeys(state, field.refs);
}

}  // namespace

void animationMenu(PanelUi& ui, const AnimatedField& field) {
  if (field.refs.empty()) return;
  EditorState& state = ui.state;
  keyRows(ui, field);
  ImGui::Separator();
  if (beginSubmenu(ui, "Drive by", "drive")) {
    inputMenu(
        ui, field, "drive", [&](const DriverInput& input) { driveNumbers(state, field.refs, input); },
        [&] { driveByNewChannel(state, field.refs); });
    ImGui::EndMenu();
  }
  if (beginSubmenu(ui, "Set driven key by", "set-driven")) {
    inputMenu(ui, field, "set-driven", [&](const DriverInput& input) { startDrivenKey(state, field.refs, input); }, {});
    ImGui::EndMenu();
  }
  const bool animated = animationOf(state.document.rig(), field.refs.front()) != nullptr;
  const Possible any(animated, "The number has neither keys nor drivers");
  if (row(ui, "Drivers...", "drivers", any, "Shows its drivers and keys")) {
    state.open.animate.sectionWanted = true;
    state.open.animate.chosen = {held(state.document.rig(), field.refs.front()), -1, -1};
  }
  if (row(ui, "Remove keys and drivers", "animation-remove", any)) stopAnimating(state, field.refs);
}

}  // namespace sinew::app
