// core/export/skinned_export.cpp: pose by pose the live surface, then weights, then the file, then how close it comes.
#include "sinew/export/skinned_export.h"

#include <algorithm>
#include <cmath>

#include "core/export/fit/joint_fit.h"
#include "core/export/formats.h"
#include "core/export/guarded.h"
#include "core/export/out_files.h"
#include "core/export/skinned_file.h"

namespace sinew {
namespace {

using namespace exporting;

/// All exported clips together. Each second is 30 poses that are smoothed, fitted and measured.
constexpr double kMostSeconds = 3600.0;

Result<void> checkLength(const std::filesystem::path& file, const Character& character,
                         const std::vector<std::string>& asked) {
  double seconds = 0.0;
  for (const AnimationClip& clip : character.clips) {
    if (asked.empty() || std::ranges::count(asked, clip.name) > 0) seconds += static_cast<double>(clip.duration);
  }
  if (seconds <= kMostSeconds) return {};
  return Error{file.string(), "clips",
               "last " + std::to_string(std::llround(seconds)) + " seconds together; expected at most " +
                   std::to_string(std::llround(kMostSeconds)) + ": choose fewer of them"};
}

Result<SkinnedExportReport> fitAndWrite(Source& source, const Character& character, JointFit& fit,
                                        const SkinnedExportSettings& settings, WriteSkin* write,
                                        const std::filesystem::path& file) {
  if (auto found = fit.findWeights(); !found) return found.error();
  SkinnedExportReport report;
  fit.measure(report);
  fit.measureBetween(report);
  SkinnedFile made = skinnedFile(source, character, fit, settings);
  report.joints = made.joints;
  report.vertices = made.vertices;
  report.triangles = made.triangles;
  report.left = std::move(made.left);
  const Result<std::uint64_t> bytes = write(source, made.packed, file, report.left);
  if (!bytes) return bytes.error();
  report.bytes = bytes.value();
  return report;
}

}  // namespace

const char* nameOf(ExportMesh mesh) { return mesh == ExportMesh::kRefined ? "refined" : "original"; }

const char* nameOf(ExportWeights weights) { return weights == ExportWeights::kRefitted ? "refitted" : "transferred"; }

const char* nameOf(JointScale scale) {
  return scale == JointScale::kFull ? "full" : scale == JointScale::kUniform ? "uniform" : "none";
}

Result<SkinnedExportReport> exportSkinned(const std::filesystem::path& characterFile,
                                          const std::shared_ptr<const Character>& character, const Character& moving,
                                          const Rig& rig, const SkinnedExportSettings& settings,
                                          const std::filesystem::path& file, const ExportProgress& progress) {
  const ExportFormat* const format = findFormat(file, {ExportForm::kSkin});
  if (!format) return unknownEnding(file, {ExportForm::kSkin});
  if (auto known = checkClips(characterFile, *character, settings.clips); !known) return known.error();
  if (auto fits = checkLength(characterFile, *character, settings.clips); !fits) return fits.error();
  return catchErrors(characterFile, file, [&]() -> Result<SkinnedExportReport> {
    Source source(characterFile);
    requireSame(source, *character);
    if (auto free = checkPlaces(source, exportedFiles(file)); !free) return free.error();
    JointFit fit(character, moving, rig, settings, progress);
    return fitAndWrite(source, *character, fit, settings, format->writeSkin, file);
  });
}

}  // namespace sinew
