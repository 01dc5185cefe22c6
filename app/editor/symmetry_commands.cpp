// app/editor/symmetry_commands.cpp: twins, selecting many, and the clipboard.
#include "app/editor/symmetry_commands.h"

#include <algorithm>
#include <set>
#include <utility>

#include <imgui.h>

#include "app/document/listed_muscles.h"
#include "app/document/shown_names.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "core/geometry/at.h"
#include "core/rig/merge.h"
#include "core/rig/sheet_edit.h"
#include "core/rig/twins.h"
#include "sinew/files/rig_json.h"
#include "sinew/rig/rig_edit.h"

namespace sinew::app {

namespace {

Result<Rig> rigInText(const std::string& text) {
  Result<Rig> rig = rigFromJson(text);
  if (!rig) return errorAt("", "the clipboard holds no muscles");
  if (rig->primitives.empty() && rig->sheets.empty()) return errorAt("", "the rig in the clipboard has no muscles");
  return rig;
}

Result<Pasted> pasteRig(const Rig& rig, const Rig& copied, const Skeleton& skeleton, const MirrorPlan* mirror) {
  Result<Merged> merged = mergeRigs(rig, copied, skeleton, mirror);
  if (!merged) return merged.error();
  Pasted pasted{std::move(merged.value().rig), {}, {}, {}};
  for (const int index : merged->primitives) {
    if (index >= 0) pasted.names.push_back(at(pasted.rig.primitives, index).name);
  }
  pasted.sheets = std::move(merged.value().sheets);
  for (const auto& [sheet, why] : merged->sheetRefusals) {
    pasted.leftOut.push_back('"' + sheet + "\" is not pasted: " + why.plainText());
  }
  for (const auto& [primitive, why] : merged->refusals) {
    pasted.leftOut.push_back('"' + at(copied.primitives, primitive).name + "\" is not pasted: " + why.plainText());
  }
  for (const auto& [owner, line] : merged->lostDrivers) {
    pasted.leftOut.push_back('"' + owner + "\" is pasted without a driver: there is no muscle line \"" + line + '"');
  }
  if (pasted.names.empty() && pasted.sheets.empty()) return errorAt("", pasted.leftOut.front());
  return pasted;
}

}  // namespace

std::string musclesAsText(const Rig& rig, std::span<const int> indices) {
  Rig copied = excerpt(rig, indices);
  if (copied.character.empty()) copied.character = "clipboard";  // A rig file names one.
  return rigToJson(copied);
}

Result<Pasted> pasteText(const Rig& rig, const std::string& text, const Skeleton& skeleton, const MirrorPlan* mirror) {
  const Result<Rig> copied = rigInText(text);
  return copied ? pasteRig(rig, copied.value(), skeleton, mirror) : copied.error();
}

Result<Pasted> pasteTextOnBone(const Rig& rig, const std::string& text, const Skeleton& skeleton, int bone,
                               const MirrorPlan* plan) {
  const Result<Rig> copied = rigInText(text);
  if (!copied) return copied.error();
  const std::optional<Rig> moved = moveToBone(copied.value(), skeleton, bone, plan);
  return pasteRig(rig, moved ? *moved : copied.value(), skeleton, nullptr);
}

namespace {

std::string countText(std::size_t count, const std::string& one) {
  return count == 1 ? one : withCount(count, "muscle");
}

/// Pickable muscles, in rig order.
std::vector<PrimitiveId> pickableMuscles(const Document& document) {
  const Skeleton& skeleton = document.character->skeleton;
  const EffectiveVisibility seen =
      effectiveVisibility(document.visibility, document.rig(), skeleton, boneOfEach(document.rig(), skeleton));
  std::vector<PrimitiveId> muscles;
  for (std::size_t i = 0; i < document.rig().primitives.size(); ++i) {
    if (seen.visible[i] && !seen.locked[i]) muscles.push_back(document.rig().primitives[i].id());
  }
  return muscles;
}

/// Where pasted muscles are: their bone, and a muscle that coincides with the first.
std::string placesOf(const Document& document, const std::vector<std::string>& names) {
  const Rig& rig = document.rig();
  const Primitive& first = at(rig.primitives, findPrimitive(rig, names.front()));
  const bool one = std::ranges::all_of(
      names, [&](const auto& name) { return at(rig.primitives, findPrimitive(rig, name)).bone == first.bone; });
  std::string text =
      one || names.size() == 2 ? shownBoneName(document.character->skeleton, first.bone) : "their own bones";
  for (const Primitive& other : rig.primitives) {
    if (std::ranges::find(names, other.name) != names.end()) continue;
    if (other.bone != first.bone || !(other.placement == first.placement)) continue;
    return text + ", exactly on " + (names.size() == 1 ? other.name : "the originals") + "; drag to move";
  }
  return text;
}

/// Keeps the active muscle active if it is among them.
void selectKeepingActive(Document& document, const std::vector<PrimitiveId>& muscles) {
  Selection& selection = document.selection;
  const PrimitiveId active = selection.active();
  selection.setAll(muscles);
  if (selection.contains(active)) selection.setAll(std::span(&active, 1), true);
}

}  // namespace

std::vector<int> editedIndices(const Document& document) {
  const std::vector<int> selected = selectedIndices(document);
  return document.symmetry ? withTwins(document.rig(), selected) : selected;
}

bool canMirror(const Document& document) { return document.mirror && document.mirror->usable(); }

void toggleSymmetry(Document& document) { document.symmetry = !document.symmetry; }

void mirrorSelection(EditorState& state) {
  Rig rig = state.document.rig();
  std::size_t done = 0;
  std::set<int> twins;
  const auto leads = leadsOf(rig, selectedIndices(state.document));
  for (const int index : leads) {
    if (twins.contains(index)) continue;  // Of a selected pair the first leads.
    const int twin = twinOf(rig, index);
    Result<Rig> mirrored = mirrorToOtherSide(rig, index, *state.document.mirror);
    if (!mirrored) {
      refuse(state, mirrored.error());
      continue;
    }
    rig = std::move(mirrored).value();
    twins.insert(twin >= 0 ? leadOf(rig, twin) : twinOf(rig, index));
    ++done;
  }
  if (done > 0) edit(state, "Mirror " + countText(done, state.document.activeName()), std::move(rig));
}

void flipSelection(EditorState& state) {
  const std::vector<int> selected = selectedIndices(state.document);
  edit(state, "Flip " + namedMuscles(state.document.rig(), selected),
       flipPrimitives(state.document.rig(), selected, *state.document.mirror));
}

void unlinkSelection(EditorState& state) {
  Rig rig = state.document.rig();
  for (const int index : leadsOf(rig, selectedIndices(state.document))) rig = clearMirror(std::move(rig), index);
  edit(state, "Unlink " + namedMuscles(state.document.rig(), selectedIndices(state.document)), std::move(rig));
}

void linkSelection(EditorState& state) {
  const Rig& rig = state.document.rig();
  const int leader = state.document.activePrimitive();
  for (const int index : leadsOf(rig, selectedIndices(state.document))) {
    if (index == leader) continue;
    edit(state, "Link " + muscleName(rig, leader) + " and " + muscleName(rig, index),
         linkTwins(rig, leader, index, *state.document.mirror));
    return;
  }
}

void selectTwins(Document& document) {
  const Rig& rig = document.rig();
  std::vector<PrimitiveId> twins;
  for (const PrimitiveId id : document.selection.primitives) {
    const int index = findPrimitive(rig, id);
    const int twin = index < 0 ? -1 : twinOf(rig, index);
    if (twin >= 0) twins.push_back(at(rig.primitives, twin).id());
  }
  document.selection.setAll(twins);
  completeSheets(document);
}

bool anyTwin(const Document& document) {
  return std::ranges::any_of(selectedIndices(document), [&](int index) { return twinOf(document.rig(), index) >= 0; });
}

bool twoSelected(const Document& document) { return leadsOf(document.rig(), selectedIndices(document)).size() == 2; }

std::string whyTwinStays(const Document& document) {
  const int active = document.activePrimitive();
  if (active < 0 || twinOf(document.rig(), active) < 0) return "";
  if (!document.mirror) return "this character has no symmetry plane";
  const Result<std::string> bone = twinBone(*document.mirror, at(document.rig().primitives, active).bone);
  return bone ? "" : bone.error().reason;
}

void selectAll(Document& document) { selectKeepingActive(document, pickableMuscles(document)); }

void invertSelection(Document& document) { document.selection.invert(pickableMuscles(document)); }

void selectOnBone(Document& document) {
  const Rig& rig = document.rig();
  const Skeleton& skeleton = document.character->skeleton;
  const std::vector<int> boneOf = listedBones(rig, skeleton, boneOfEach(rig, skeleton));
  std::set<int> bones;
  for (const int index : selectedIndices(document)) bones.insert(at(boneOf, index));
  if (bones.empty()) bones.insert(document.selection.bone);
  bones.erase(-1);
  std::vector<PrimitiveId> muscles = pickableMuscles(document);
  std::erase_if(muscles, [&](PrimitiveId id) { return !bones.contains(at(boneOf, findPrimitive(rig, id))); });
  selectKeepingActive(document, muscles);
}

void copySelection(Document& document) {
  const std::vector<int> indices = editedIndices(document);
  if (!indices.empty()) ImGui::SetClipboardText(musclesAsText(document.rig(), indices).c_str());
}

void cutSelection(EditorState& state) {
  const std::vector<int> indices = editedIndices(state.document);
  if (indices.empty()) return;
  const std::string what = namedMuscles(state.document.rig(), indices);
  copySelection(state.document);
  edit(state, "Cut " + what, removePrimitives(state.document.rig(), indices));
}

void pasteMuscles(EditorState& state, bool mirrored) {
  const char* const text = ImGui::GetClipboardText();
  const std::string copied = text ? text : "";
  const Document& document = state.document;
  const Skeleton& skeleton = state.character().skeleton;
  const MirrorPlan* const plan = canMirror(document) ? document.mirror.get() : nullptr;
  const int bone = mirrored ? -1 : document.selection.bone;
  Result<Pasted> pasted = bone >= 0 ? pasteTextOnBone(document.rig(), copied, skeleton, bone, plan)
                                    : pasteText(document.rig(), copied, skeleton, mirrored ? plan : nullptr);
  if (!pasted) {
    refuse(state, pasted.error());
    return;
  }
  for (const std::string& reason : pasted->leftOut) addMessage(state.session, MessageKind::kWarning, reason);
  std::vector<std::string> names = pasted->names;
  const std::vector<std::string> sheets = pasted->sheets;
  const std::string what = countText(names.size() + sheets.size(), names.empty() ? sheets.front() : names.front());
  const std::string left = pasted->leftOut.empty() ? "" : "; " + std::to_string(pasted->leftOut.size()) + " left out";
  const bool done = edit(state, (mirrored ? "Paste mirrored " : "Paste ") + what, std::move(pasted).value().rig);
  for (const std::string& sheet : sheets) {
    for (const int belly : bellies(document.rig(), sheet)) names.push_back(at(document.rig().primitives, belly).name);
  }
  if (done && !names.empty()) say(state, "Pasted " + what + " on " + placesOf(document, names) + left);
  state.document.selection.clear();
  for (const std::string& name : names) {
    state.document.selection.primitives.push_back(state.document.idAt(findPrimitive(state.document.rig(), name)));
  }
}

}  // namespace sinew::app
