// core/export/baked_export.cpp: which form a baked clip takes, and what may be asked for.
#include "sinew/export/baked_export.h"

#include <algorithm>
#include <cmath>

#include "core/export/baked_points.h"
#include "core/export/baked_targets.h"
#include "core/export/guarded.h"
#include "core/export/out_files.h"

namespace sinew {

using namespace exporting;

bool isBakedPointsName(const std::filesystem::path& file) {
  const std::string ending = lowerEnding(file);
  return ending == ".pc2" || ending == ".mdd" || ending == ".usda";
}

bool isBakedExportName(const std::filesystem::path& file) {
  return isSkinnedExportName(file) || isBakedPointsName(file);
}

Result<BakedExportReport> exportBaked(const std::filesystem::path& characterFile,
                                      const std::shared_ptr<const Character>& character, const Rig& rig,
                                      const BakedExportSettings& settings, const std::filesystem::path& file,
                                      const ExportProgress& progress) {
  if (!isBakedExportName(file)) {
    return Error{file.string(), {}, "expected a name that ends in .glb, .gltf, .usda, .pc2 or .mdd"};
  }
  if (!(settings.framesPerSecond > 0.0) || !std::isfinite(settings.framesPerSecond)) {
    return errorAt("frames per second", "expected a number above 0");
  }
  if (!(settings.bound >= kLeastBound && settings.bound <= kMostBound)) {
    return errorAt("bound", "expected percent of the height from 0.001 to 100");
  }
  if (auto known = checkClips(characterFile, *character, {settings.clip}); !known) return known.error();
  if (std::ranges::count(character->clips, settings.clip, &AnimationClip::name) > 1) {
    return Error{characterFile.string(), "clip \"" + settings.clip + '"',
                 "there are several of that name; expected one"};
  }
  return guarded(characterFile, file, [&]() -> Result<BakedExportReport> {
    Source source(characterFile);
    requireSame(source, *character);
    return isBakedPointsName(file) ? bakePoints(source, character, rig, settings, file, progress)
                                   : bakeTargets(source, character, rig, settings, file, progress);
  });
}

}  // namespace sinew
