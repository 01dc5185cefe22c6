// core/body/muscle_set.cpp: a set of muscles added to a rig.
#include "core/body/muscle_set.h"

#include <utility>

#include "core/check/check.h"

namespace sinew {

Result<FittedPreset> addMuscleSetQuickly(Rig rig, const Preset& preset, const PresetTuning& tuning,
                                         const Motions& motions, const MirrorPlan& plan) {
  if (rig.primitives.empty()) rig.surface.skinBlend = preset.skinBlend;
  return fitPreset(std::move(rig), preset, tuning, motions.character(), plan);
}

Result<AddedSet> addMuscleSet(Rig rig, const Preset& preset, const PresetTuning& tuning, const Motions& motions,
                              const MirrorPlan& plan) {
  const std::size_t first = rig.primitives.size();
  Result<FittedPreset> fitted = addMuscleSetQuickly(std::move(rig), preset, tuning, motions, plan);
  if (!fitted) return fitted.error();
  Result<MendedRig> mended = withMendedFrom(std::move(fitted.value().rig), first, motions, plan);
  if (!mended) return mended.error();
  fitted.value().rig = std::move(mended.value().rig);
  return AddedSet{std::move(fitted).value(), std::move(mended.value().said)};
}

Result<MendedRig> withMendedFrom(Rig rig, std::size_t first, const Motions& motions, const MirrorPlan& plan) {
  std::vector<Finding> findings = check(rig, motions);
  std::erase_if(findings, [&](const Finding& finding) { return static_cast<std::size_t>(finding.primitive) < first; });
  return withMendedFindings(std::move(rig), findings, motions, &plan);
}

}  // namespace sinew
