// core/files/export/baked_export.cpp: which form a baked clip takes, and what may be asked for.
#include "sinew/files/baked_export.h"

#include <algorithm>
#include <cmath>

#include "core/files/export/formats.h"
#include "core/files/export/source.h"

namespace sinew {

using namespace exporting;

namespace {

const std::vector<ExportForm> kBakedForms{ExportForm::kTargets, ExportForm::kStage, ExportForm::kCache};

}  // namespace

Result<BakedExportReport> exportBaked(const std::filesystem::path& characterFile,
                                      const std::shared_ptr<const Character>& character, const Rig& rig,
                                      const BakedExportSettings& settings, const std::filesystem::path& file,
                                      const ExportProgress& progress) {
  const ExportFormat* const format = findFormat(file, kBakedForms);
  if (!format) return unknownEnding(file, kBakedForms);
  if (!(settings.framesPerSecond > 0.0) || !std::isfinite(settings.framesPerSecond)) {
    return errorAt("frames per second", "expected a number above 0");
  }
  if (settings.substeps < 1 || settings.substeps > kMostSubsteps) {
    return errorAt("substeps", "expected 1 to " + std::to_string(kMostSubsteps));
  }
  if (settings.substeps > 1 && !hasExportEnding(file, {ExportForm::kTargets})) {
    return errorAt("substeps", "are for morph targets alone");
  }
  if (!(settings.bound >= kLeastBound && settings.bound <= kMostBound)) {
    return errorAt("bound", "expected percent of the height from 0.001 to 100");
  }
  if (auto known = checkClips(characterFile, *character, {settings.clip}); !known) return known.error();
  if (std::ranges::count(character->clips, settings.clip, &AnimationClip::name) > 1) {
    return Error{characterFile.string(), "clip \"" + settings.clip + '"',
                 "there are several of that name; expected one"};
  }
  if (format->form != ExportForm::kCache) {
    if (auto fits = checkSeconds(characterFile, *character, {settings.clip}); !fits) return fits.error();
  }
  return catchErrors(characterFile, file, [&]() -> Result<BakedExportReport> {
    Source source(characterFile);
    requireSame(source, *character);
    if (auto free = checkPlaces(source, exportedFiles(file)); !free) return free.error();
    return format->bakeClip(source, character, rig, settings, file, progress);
  });
}

}  // namespace sinew
