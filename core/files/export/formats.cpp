// core/files/export/formats.cpp: the table of formats, where a new format is one row and its writer; the two exports.
#include "core/files/export/formats.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "core/files/export/skinned_file.h"
#include "core/files/fit/joint_fit.h"
#include "core/files/surface_formats.h"
#include "core/geometry/nearest_name.h"
#include "sinew/files/skinned_export.h"

namespace sinew {
namespace exporting {
namespace {

constexpr ExportFormat kFormats[] = {
    {".glb", ExportForm::kSkin, writeGlb},
    {".gltf", ExportForm::kSkin, writeGltf, nullptr, {".bin"}},
    {".usda", ExportForm::kSkin, writeUsd},
    {".glb", ExportForm::kTargets, nullptr, bakeTargets},
    {".gltf", ExportForm::kTargets, nullptr, bakeTargets, {".bin"}},
    {".usda", ExportForm::kStage, nullptr, bakeStage},
    {".pc2", ExportForm::kCache, nullptr, bakeCache, {".obj", ".mtl"}},
    {".mdd", ExportForm::kCache, nullptr, bakeCache, {".obj", ".mtl"}},
};

bool isOneOf(ExportForm form, const std::vector<ExportForm>& forms) {
  return std::ranges::find(forms, form) != forms.end();
}

}  // namespace

const ExportFormat* findFormat(const std::filesystem::path& file, const std::vector<ExportForm>& forms) {
  const std::string ending = lowerEnding(file);
  const auto* const found = std::ranges::find_if(
      kFormats, [&](const ExportFormat& format) { return format.ending == ending && isOneOf(format.form, forms); });
  return found == std::end(kFormats) ? nullptr : found;
}

}  // namespace exporting

using namespace exporting;

std::vector<std::string> exportEndings(const std::vector<ExportForm>& forms) {
  std::vector<std::string> endings;
  for (const ExportFormat& format : kFormats) {
    if (isOneOf(format.form, forms) && std::ranges::find(endings, format.ending) == endings.end()) {
      endings.emplace_back(format.ending);
    }
  }
  return endings;
}

bool hasExportEnding(const std::filesystem::path& file, const std::vector<ExportForm>& forms) {
  return findFormat(file, forms) != nullptr;
}

std::vector<std::filesystem::path> exportedFiles(const std::filesystem::path& file) {
  const std::string ending = lowerEnding(file);
  const auto* const format = std::ranges::find(kFormats, ending, &ExportFormat::ending);
  std::vector<std::filesystem::path> files;
  if (format != std::end(kFormats)) {
    for (const std::string_view beside : format->besides) {
      std::filesystem::path other = file;
      other.replace_extension(beside);
      if (beside == ".mtl") other.replace_filename(asWord(file.stem().string()) + ".mtl");  // As the .obj names it.
      if (!beside.empty()) files.push_back(std::move(other));
    }
  }
  files.push_back(file);
  return files;
}

// Skinned exports.

namespace {

Error unknownEnding(const std::filesystem::path& file, const std::vector<ExportForm>& forms) {
  return {file.string(), {}, "expected a name that ends in " + listed(exportEndings(forms), "or")};
}

/// Opens the character's file and calls make(Source&) -> Result<Report>.
template <class Report, class Make>
Result<Report> withSource(const std::filesystem::path& characterFile, const Character& character,
                          const std::filesystem::path& file, const Make& make) {
  return catchErrors(characterFile, file, [&]() -> Result<Report> {
    Source source(characterFile);
    requireSame(source, character);
    if (auto free = checkPlaces(source, exportedFiles(file)); !free) return free.error();
    return make(source);
  });
}

constexpr double kMostError = 100.0;  ///< Percent of the height; a larger error is refused.

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
  return withSource<SkinnedExportReport>(characterFile, *character, file, [&](Source& source) {
    JointFit fit(character, moving, rig, settings, progress);
    return fitAndWrite(source, *character, fit, settings, format->writeSkin, file);
  });
}

// Baked exports.

const std::vector<ExportForm> kBakedForms{ExportForm::kTargets, ExportForm::kStage, ExportForm::kCache};

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
  return withSource<BakedExportReport>(characterFile, *character, file, [&](Source& source) {
    return format->bakeClip(source, character, rig, settings, file, progress);
  });
}

}  // namespace sinew
