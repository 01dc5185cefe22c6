// core/bodies/sheets/keep_sheets.cpp: lays sheets of a rig just read, and again after edits.
#include "core/bodies/sheets/keep_sheets.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "core/bodies/sheets/lay_sheet.h"
#include "core/geometry/at.h"
#include "core/rig/sheet_edit.h"

namespace sinew {
namespace {

/// What follows from one sheet.
struct SheetMembers {
  std::vector<Primitive> bellies;
  std::vector<MuscleLine> lines;

  friend bool operator==(const SheetMembers&, const SheetMembers&) = default;
};

SheetMembers membersOfSheet(const Rig& rig, const std::string& sheet) {
  SheetMembers members;
  for (const Primitive& belly : rig.primitives) {
    if (belly.sheet == sheet) members.bellies.push_back(belly);
  }
  for (const MuscleLine& line : rig.lines) {
    if (line.sheet == sheet) members.lines.push_back(line);
  }
  return members;
}

/// What has kept its name is the same, as after the sheet was renamed with its members.
template <class Item>
void keepIdentities(std::vector<Item>& laid, const std::vector<Item>& before) {
  for (Item& item : laid) {
    const auto same = std::ranges::find(before, item.name, &Item::name);
    if (same != before.end()) item.identity = same->identity;
  }
}

/// Under free names; identities follow from the names (references.h).
void append(Rig& rig, SheetMembers members) {
  for (MuscleLine& line : members.lines) {
    const std::string name = freeLineName(rig, line.name);
    for (Primitive& belly : members.bellies) {
      if (belly.line == line.name) belly.line = name;
    }
    line.name = name;
    rig.lines.push_back(std::move(line));
  }
  for (Primitive& belly : members.bellies) {
    belly.name = freePrimitiveName(rig, belly.name);
    rig.primitives.push_back(std::move(belly));
  }
}

/// The twin of a sheet that was edited becomes its image, if it was not edited itself.
void keepSheetTwins(const Rig& shown, Rig& wanted, const MirrorPlan& plan) {
  const auto isChanged = [&](const MuscleSheet& sheet) {
    const int before = findSheet(shown, sheet.name);
    return before >= 0 && !(at(shown.sheets, before) == sheet);
  };
  for (std::size_t i = 0; i < wanted.sheets.size(); ++i) {
    const int twin = findSheet(wanted, wanted.sheets[i].mirror);
    if (twin < 0 || !isChanged(wanted.sheets[i]) || isChanged(at(wanted.sheets, twin))) continue;
    if (findSheet(shown, wanted.sheets[i].mirror) < 0) continue;
    Result<MuscleSheet> image = mirroredSheet(plan, wanted.sheets[i]);
    if (!image) continue;
    MuscleSheet& other = at(wanted.sheets, twin);
    image.value().name = other.name;
    image.value().mirror = other.mirror;
    if (findGroup(wanted, image.value().group) < 0) image.value().group = other.group;
    other = std::move(image).value();
  }
}

}  // namespace

Rig withSheets(Rig rig, const std::shared_ptr<const Character>& character, std::vector<UnlaidSheet>* unlaid) {
  if (rig.sheets.empty()) return rig;
  const SheetSkin skin(character, rig);
  rig = withoutBellies(std::move(rig));
  for (const MuscleSheet& sheet : rig.sheets) {
    Result<LaidSheet> laid = laySheet(sheet, skin);
    if (laid) append(rig, {std::move(laid.value().bellies), std::move(laid.value().lines)});
    else if (unlaid) unlaid->push_back({sheet.name, laid.error().reason});
  }
  return withBellyTwins(std::move(rig));
}

const SheetSkin& SheetKeeper::skinOf(const Rig& rig) {
  if (!skin_ || layers_ != rig.layers || patch_ != rig.smoothing.patch) {
    skin_ = std::make_unique<SheetSkin>(character_, rig);
    layers_ = rig.layers;
    patch_ = rig.smoothing.patch;
  }
  return *skin_;
}

Rig SheetKeeper::keep(const Rig& shown, Rig wanted, const MirrorPlan& plan) {
  if (wanted.sheets.empty() && shown.sheets.empty()) return wanted;
  if (plan.usable()) keepSheetTwins(shown, wanted, plan);
  const bool sameSkin = shown.layers == wanted.layers && shown.smoothing.patch == wanted.smoothing.patch;
  std::vector<SheetMembers> members;
  for (const MuscleSheet& sheet : wanted.sheets) {
    SheetMembers own = membersOfSheet(wanted, sheet.name);
    const int before = findSheet(shown, sheet.name);
    const bool same = sameSkin && before >= 0 && at(shown.sheets, before) == sheet && !own.bellies.empty() &&
                      own == membersOfSheet(shown, sheet.name);
    if (!same) {
      Result<LaidSheet> laid = laySheet(sheet, skinOf(wanted));
      SheetMembers next;
      if (laid) next = {std::move(laid.value().bellies), std::move(laid.value().lines)};
      keepIdentities(next.bellies, own.bellies);
      keepIdentities(next.lines, own.lines);
      own = std::move(next);
    }
    members.push_back(std::move(own));
  }
  wanted = withoutBellies(std::move(wanted));
  for (SheetMembers& one : members) append(wanted, std::move(one));
  return withBellyTwins(std::move(wanted));
}

}  // namespace sinew
