// core/files/export/skinned_export.cpp: pose by pose the live surface, then weights, then the file, then how close it
// comes.
#include "sinew/files/skinned_export.h"

#include <array>
#include <cstdio>
#include <string>

#include "core/files/export/formats.h"
#include "core/files/export/skinned_file.h"
#include "core/files/export/source.h"
#include "core/files/fit/joint_fit.h"

namespace sinew {
namespace {

using namespace exporting;

/// Percent of the height: what is farther off is not the character any more.
constexpr double kMostError = 100.0;

/// That the file would play what was measured.
Result<void> checkError(const std::filesystem::path& file, const SkinnedExportReport& report) {
  const bool isBetween = report.allBetween.largest > report.allClips.largest;
  const ErrorFigures& worst = isBetween ? report.allBetween : report.allClips;
  if (worst.largest <= kMostError) return {};
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "is %.0f %% of the height off at %.3f s; expected at most %.0f %%",
                worst.largest, static_cast<double>(worst.farthest.time), kMostError);
  return Error{file.string(), "clip \"" + worst.farthest.clip + '"',
               text.data() + std::string(": joints and weights cannot follow; does its mesh lie far from bone \"") +
                   worst.farthest.bone + "\"?",
               "not written"};
}

Result<SkinnedExportReport> fitAndWrite(Source& source, const Character& character, JointFit& fit,
                                        const SkinnedExportSettings& settings, WriteSkin* write,
                                        const std::filesystem::path& file) {
  if (auto found = fit.findWeights(); !found) return found.error();
  SkinnedExportReport report;
  fit.measure(report);
  fit.measureBetween(report);
  if (auto near = checkError(file, report); !near) return near.error();
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
  if (auto fits = checkSeconds(characterFile, *character, settings.clips); !fits) return fits.error();
  return catchErrors(characterFile, file, [&]() -> Result<SkinnedExportReport> {
    Source source(characterFile);
    requireSame(source, *character);
    if (auto free = checkPlaces(source, exportedFiles(file)); !free) return free.error();
    JointFit fit(character, moving, rig, settings, progress);
    return fitAndWrite(source, *character, fit, settings, format->writeSkin, file);
  });
}

}  // namespace sinew
