// core/bodies/muscle_set.cpp: a set of muscles added to a rig.
#include "core/bodies/muscle_set.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/bodies/mend_rig.h"
#include "core/character/side_names.h"
#include "core/geometry/at.h"
#include "core/rig/twins.h"
#include "sinew/rig/rig_edit.h"

namespace sinew {

Result<FittedPreset> addMuscleSetQuickly(Rig rig, const Preset& preset, const PresetTuning& tuning,
                                         const Motions& motions, const MirrorPlan& plan) {
  if (rig.primitives.empty()) rig.surface.skinBlend = preset.skinBlend;
  return fitPreset(std::move(rig), preset, tuning, motions.character(), plan);
}

namespace {

/// Muscles that nothing keeps in the flesh, with their twins; then groups that nothing is in any more.
void leaveOutFound(AddedSet& added, std::size_t first, std::size_t firstGroup, const Motions& motions) {
  Rig& rig = added.fitted.rig;
  std::vector<int> gone;
  const auto go = [&](int index) {
    if (index >= 0 && std::ranges::find(gone, index) == gone.end()) gone.push_back(index);
  };
  for (const Finding& finding : findingsFrom(rig, first, motions)) {
    if (std::ranges::find(gone, finding.primitive) != gone.end()) continue;
    const int twin = twinOf(rig, finding.primitive);
    const std::string& name = at(rig.primitives, twin < 0 ? finding.primitive : std::min(finding.primitive, twin)).name;
    const std::string own = withoutSide(name);
    added.fitted.leftOut.push_back({own, "it " + textOf(finding) + " in " + finding.clip});
    std::erase(added.fitted.muscles, own);
    std::erase_if(added.mended, [&](const std::string& line) { return line.starts_with(name + ":"); });
    go(finding.primitive);
    go(twin);
  }
  rig = removePrimitives(std::move(rig), gone);
  for (std::size_t i = rig.groups.size(); i-- > firstGroup;) {
    const auto isIn = [&](const Primitive& primitive) { return primitive.group == rig.groups[i].name; };
    if (std::ranges::none_of(rig.primitives, isIn))
      rig.groups.erase(rig.groups.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace

Result<AddedSet> addMuscleSet(Rig rig, const Preset& preset, const PresetTuning& tuning, const Motions& motions,
                              const MirrorPlan& plan) {
  const std::size_t first = rig.primitives.size();
  const std::size_t firstGroup = rig.groups.size();
  Result<FittedPreset> fitted = addMuscleSetQuickly(std::move(rig), preset, tuning, motions, plan);
  if (!fitted) return fitted.error();
  Result<MendedRig> mended = withMendedRig(std::move(fitted.value().rig), first, motions, &plan);
  if (!mended) return mended.error();
  fitted.value().rig = std::move(mended.value().rig);
  AddedSet added{std::move(fitted).value(), std::move(mended.value().said)};
  leaveOutFound(added, first, firstGroup, motions);
  return added;
}

}  // namespace sinew
