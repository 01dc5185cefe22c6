// app/document/listed_muscles.cpp: muscles as lists show and count them: a sheet with all its bellies is one.
#include "app/document/listed_muscles.h"

#include <algorithm>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "core/geometry/at.h"

namespace sinew::app {

bool isBelly(const Rig& rig, int primitive) { return !at(rig.primitives, primitive).sheet.empty(); }

int leadOf(const Rig& rig, int primitive) {
  const std::string& sheet = at(rig.primitives, primitive).sheet;
  if (sheet.empty()) return primitive;
  while (primitive > 0 && at(rig.primitives, primitive - 1).sheet == sheet) --primitive;
  return primitive;
}

std::vector<int> leadsOf(const Rig& rig, std::span<const int> primitives) {
  std::vector<int> leads;
  std::unordered_set<int> seen;
  for (const int primitive : primitives) {
    const int lead = leadOf(rig, primitive);
    if (seen.insert(lead).second) leads.push_back(lead);
  }
  return leads;
}

std::vector<int> allLeads(const Rig& rig) {
  std::vector<int> leads;
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const std::string& sheet = rig.primitives[i].sheet;
    if (sheet.empty() || i == 0 || rig.primitives[i - 1].sheet != sheet) leads.push_back(static_cast<int>(i));
  }
  return leads;
}

std::vector<int> withoutSheets(const Rig& rig, std::vector<int> primitives) {
  std::erase_if(primitives, [&](int primitive) { return isBelly(rig, primitive); });
  return primitives;
}

std::vector<int> membersOfMuscle(const Rig& rig, int primitive) {
  std::vector<int> members{leadOf(rig, primitive)};
  if (!isBelly(rig, primitive)) return members;
  const std::string& sheet = at(rig.primitives, primitive).sheet;
  while (static_cast<std::size_t>(members.back()) + 1 < rig.primitives.size() &&
         at(rig.primitives, members.back() + 1).sheet == sheet) {
    members.push_back(members.back() + 1);
  }
  return members;
}

const std::string& muscleName(const Rig& rig, int primitive) {
  const Primitive& muscle = at(rig.primitives, primitive);
  return muscle.sheet.empty() ? muscle.name : muscle.sheet;
}

const std::string& listedBone(const Rig& rig, int primitive) {
  const Primitive& muscle = at(rig.primitives, primitive);
  const int sheet = findSheet(rig, muscle.sheet);
  return sheet < 0 ? muscle.bone : at(rig.sheets, sheet).edges.front().points.front().bone;
}

std::vector<int> listedBones(const Rig& rig, const Skeleton& skeleton, std::vector<int> boneOf) {
  if (rig.sheets.empty()) return boneOf;
  for (std::size_t i = 0; i < boneOf.size(); ++i) {
    const std::string& sheet = rig.primitives[i].sheet;
    if (sheet.empty()) continue;
    const bool further = i > 0 && rig.primitives[i - 1].sheet == sheet;
    boneOf[i] = further ? boneOf[i - 1] : skeleton.findBone(listedBone(rig, static_cast<int>(i))).value_or(boneOf[i]);
  }
  return boneOf;
}

int nextIndex(const Rig& rig) {
  const auto first = std::ranges::find_if(rig.primitives, [](const Primitive& one) { return !one.sheet.empty(); });
  return static_cast<int>(first - rig.primitives.begin());
}

void completeSheets(Document& document) {
  const Rig& rig = document.rig();
  std::vector<PrimitiveId>& selected = document.selection.primitives;
  if (rig.sheets.empty() || selected.empty()) return;
  std::unordered_map<std::uint32_t, int> indexOf;
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    indexOf.emplace(rig.primitives[i].id().value, static_cast<int>(i));
  }
  // From the end: a sheet is where its last selected belly was, and begins, in this order, with its first belly.
  std::vector<PrimitiveId> reversed;
  std::unordered_set<int> sheets;
  for (auto id = selected.rbegin(); id != selected.rend(); ++id) {
    const auto found = indexOf.find(id->value);
    if (found == indexOf.end() || !isBelly(rig, found->second)) {
      reversed.push_back(*id);
    } else if (sheets.insert(leadOf(rig, found->second)).second) {
      for (const int belly : membersOfMuscle(rig, found->second)) reversed.push_back(document.idAt(belly));
    }
  }
  selected.assign(reversed.rbegin(), reversed.rend());
}

void selectMuscle(Document& document, int primitive) {
  document.selection.set(document.idAt(primitive));
  completeSheets(document);
}

void toggleMuscle(Document& document, int primitive) {
  const PrimitiveId lead = document.idAt(leadOf(document.rig(), primitive));
  if (!isBelly(document.rig(), primitive) || !document.selection.contains(lead)) {
    document.selection.toggle(lead);
    return completeSheets(document);
  }
  std::vector<PrimitiveId> members;
  for (const int belly : membersOfMuscle(document.rig(), primitive)) members.push_back(document.idAt(belly));
  document.selection.remove(members);
}

std::vector<int> selectedSheets(const Document& document) {
  std::set<int> sheets;
  for (const PrimitiveId id : document.selection.primitives) {
    const int index = findPrimitive(document.rig(), id);
    if (index < 0 || leadOf(document.rig(), index) != index) continue;
    sheets.insert(findSheet(document.rig(), at(document.rig().primitives, index).sheet));
  }
  sheets.erase(-1);
  return {sheets.begin(), sheets.end()};
}

int activeSheet(const Document& document) {
  const int active = document.activePrimitive();
  return active < 0 ? -1 : findSheet(document.rig(), at(document.rig().primitives, active).sheet);
}

}  // namespace sinew::app
