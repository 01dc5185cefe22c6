// app/editor/sheet_commands.cpp: edits of the selected sheets.
#include "app/editor/sheet_commands.h"

#include <utility>

#include "app/document/listed_muscles.h"
#include "app/document/shown_names.h"
#include "app/editor/edit.h"
#include "app/viewport/tools/sheet_stroke.h"
#include "core/geometry/at.h"
#include "core/rig/sheet_edit.h"

namespace sinew::app {

std::string namedSheets(const Rig& rig, const std::vector<int>& sheets) {
  return sheets.size() == 1 ? at(rig.sheets, sheets.front()).name : withCount(sheets.size(), "sheet");
}

Result<Rig> editSheets(Rig rig, const std::vector<int>& sheets, const std::function<void(MuscleSheet&)>& change) {
  for (const int sheet : sheets) {
    Result<Rig> next = editSheet(std::move(rig), sheet, change);
    if (!next) return next;
    rig = std::move(next).value();
  }
  return rig;
}

void setOnLines(EditorState& state, bool on) {
  const std::vector<int> sheets = selectedSheets(state.document);
  if (sheets.empty()) return;
  const Rig& rig = state.document.rig();
  const std::string what = namedSheets(rig, sheets);
  edit(state, on ? "Put " + what + " on lines" : "Take " + what + " off lines",
       editSheets(rig, sheets, [on](MuscleSheet& sheet) {
         if (!on) sheet.line.reset();
         else if (!sheet.line) sheet.line = linesOfSheets();
       }));
}

bool removeProfilePoint(EditorState& state, const std::string& sheet, bool along, int point) {
  const Rig& rig = state.document.rig();
  const int index = findSheet(rig, sheet);
  if (index < 0) return false;
  const auto profileOf = [along](auto& of) -> auto& { return along ? of.along : of.across; };
  const std::size_t count = profileOf(at(rig.sheets, index)).size();
  if (point < 0 || toIndex(point) >= count) return false;
  if (count == 1) {
    sayRefusal(state, "A profile keeps one point");
    return true;
  }
  edit(state, "Remove point of the profile of " + sheet, editSheet(rig, index, [&](MuscleSheet& edited) {
         Profile& profile = profileOf(edited);
         profile.erase(profile.begin() + point);
       }));
  return true;
}

void breakSelection(EditorState& state) {
  const Rig& rig = state.document.rig();
  const std::vector<int> sheets = selectedSheets(state.document);
  if (sheets.empty()) return;
  Rig broken = rig;
  for (const int sheet : sheets) {
    // With a sheet its twin is broken up.
    const int left = findSheet(broken, at(rig.sheets, sheet).name);
    if (left >= 0) broken = breakIntoStrips(std::move(broken), left);
  }
  edit(state, "Break " + namedSheets(rig, sheets) + " into strips", std::move(broken));
}

}  // namespace sinew::app
