// app/viewport/tools/pick_cycle.cpp: repeated clicks on one place pick what lies there in turn.

#include "app/viewport/tools/pick_cycle.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "app/document/shown_names.h"
#include "app/ui/code_points.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

constexpr float kSamePlace = 3.0f;  ///< Design pixels.

bool isSelected(const PickEntry& entry, const Selection& selection) {
  if (entry.muscle) return selection.active() == entry.muscle;
  return selection.bone == entry.bone && selection.primitives.empty();
}

bool canStillBeTaken(const PickEntry& entry, const Document& document) {
  if (!entry.muscle) return true;
  const int index = findPrimitive(document.rig(), entry.muscle);
  return index >= 0 && isPickable(document.visibility, document.rig(), document.character->skeleton, index);
}

/// Makes entry `at` the next to be picked.
void aimAt(ViewportHover& hover, std::size_t at, const Document& document) {
  hover.at = at;
  const PickEntry& entry = hover.here[at];
  hover.primitive = entry.muscle ? findPrimitive(document.rig(), entry.muscle) : -1;
  if (!entry.muscle) hover.bone = entry.bone;
}

void followCycle(ViewportHover& hover, const PickCycle& cycle, const Document& document) {
  hover.here = cycle.here;
  hover.taken = static_cast<int>(cycle.taken);
  aimAt(hover, (cycle.taken + 1) % cycle.here.size(), document);
}

}  // namespace

std::string nameOf(const PickEntry& entry, const Document& document) {
  if (!entry.muscle) {
    return "bone " + shownBoneName(document.character->skeleton, entry.bone);
  }
  const int index = findPrimitive(document.rig(), entry.muscle);
  return index < 0 ? "" : shownMuscleName(document.rig(), index);
}

bool goesOn(const PickCycle& cycle, const ViewportContext& context, const View& view, const glm::vec2& pixel) {
  if (cycle.here.size() < 2 || cycle.taken >= cycle.here.size()) return false;
  const Document& document = context.document;
  return glm::distance(pixel, cycle.pixel) <= kSamePlace * context.uiScale && view == cycle.view &&
         cycle.step == document.commands.position() &&
         (context.playing || cycle.boneInWorld == context.pose.boneInWorld) &&
         isSelected(cycle.here[cycle.taken], document.selection) &&
         std::ranges::all_of(cycle.here, [&](const PickEntry& entry) { return canStillBeTaken(entry, document); });
}

void aim(ViewportHover& hover, const PickCycle& cycle, const ViewportContext& context, const View& view,
         const glm::vec2& pixel) {
  if (!goesOn(cycle, context, view, pixel)) return;
  // The clip may have moved something else under the pointer.
  const bool stillHere = std::ranges::any_of(hover.here, [&](const PickEntry& now) {
    return std::ranges::any_of(cycle.here, [&](const PickEntry& entry) { return entry.isSameAs(now); });
  });
  if (stillHere) followCycle(hover, cycle, context.document);
}

void advance(PickCycle& cycle, ViewportHover& hover, const ViewportContext& context, const View& view,
             const glm::vec2& pixel) {
  const bool first = hover.taken < 0;
  if (first) cycle = {hover.here, 0, pixel, view, context.pose.boneInWorld, 0};
  cycle.taken = hover.at;
  cycle.step = context.document.commands.position();
  if (goesOn(cycle, context, view, pixel)) followCycle(hover, cycle, context.document);
}

void aimAtSelected(ViewportHover& hover, const Document& document) {
  const auto found = std::ranges::find_if(
      hover.here, [&](const PickEntry& entry) { return entry.muscle && document.selection.active() == entry.muscle; });
  if (found != hover.here.end()) aimAt(hover, static_cast<std::size_t>(found - hover.here.begin()), document);
}

std::string countHere(const ViewportHover& hover) {
  if (hover.here.size() < 2) return "";
  const std::string count = std::to_string(hover.here.size()) + " here";
  return hover.taken < 0 ? count : std::to_string(hover.taken + 1) + " of " + count;
}

std::string nextHere(const ViewportHover& hover, const Document& document) {
  return nameOf(hover.here[hover.at], document);
}

}  // namespace sinew::app
