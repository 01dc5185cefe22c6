// app/document/listed_muscles.h: muscles as lists show and count them: a sheet with all its bellies is one.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "sinew/character/skeleton.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

// All indices are rig indices of primitives.

/// The one that stands for a muscle in lists and in the selection: a sheet's first belly, else the primitive itself.
[[nodiscard]] int leadOf(const Rig& rig, int primitive);
[[nodiscard]] std::vector<int> leadsOf(const Rig& rig, std::span<const int> primitives);  ///< Each once, in order.
[[nodiscard]] std::vector<int> allLeads(const Rig& rig);  ///< Of all muscles, ascending.

[[nodiscard]] bool isBelly(const Rig& rig, int primitive);  ///< Of a sheet.
[[nodiscard]] std::vector<int> withoutSheets(const Rig& rig, std::vector<int> primitives);
/// All bellies of a sheet, ascending, or the primitive itself.
[[nodiscard]] std::vector<int> membersOfMuscle(const Rig& rig, int primitive);

[[nodiscard]] const std::string& muscleName(const Rig& rig, int primitive);  ///< A belly's is that of its sheet.
/// The bone under which a muscle is listed; a sheet's is that of its origin's first point.
[[nodiscard]] const std::string& listedBone(const Rig& rig, int primitive);
/// [primitives] listedBone as an index; -1: unattached. @param boneOf  boneOfEach()
[[nodiscard]] std::vector<int> listedBones(const Rig& rig, const Skeleton& skeleton, std::vector<int> boneOf);

/// Where the next muscle that is added to a rig will be: bellies stay behind all others.
[[nodiscard]] int nextIndex(const Rig& rig);

// The selection has sheets with all their bellies, the first belly last.

void completeSheets(Document& document);  ///< After changes of rig or selection.
void selectMuscle(Document& document, int primitive);
void toggleMuscle(Document& document, int primitive);
[[nodiscard]] std::vector<int> selectedSheets(const Document& document);  ///< Indices into Rig::sheets, ascending.
[[nodiscard]] int activeSheet(const Document& document);                  ///< Of the active muscle; -1: it is none.

}  // namespace sinew::app
