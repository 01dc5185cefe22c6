// core/export/skinned_export.cpp: pose by pose the live surface, then weights, then the file, then how close it comes.
#include "sinew/export/skinned_export.h"

#include <algorithm>
#include <array>

#include "core/export/fit/joint_fit.h"
#include "core/export/guarded.h"
#include "core/export/out_files.h"
#include "core/export/skinned_file.h"
#include "core/export/usd_files.h"

namespace sinew {
namespace {

using namespace exporting;

constexpr std::array kScaleNames{"full", "uniform", "none"};  // In the order of JointScale.

Result<SkinnedExportReport> exported(Source& source, const Character& character, JointFit& fit,
                                     const SkinnedExportSettings& settings, const std::filesystem::path& file) {
  if (auto free = checkPlaces(source, filesOf(file)); !free) return free.error();
  if (auto found = fit.findWeights(); !found) return found.error();
  SkinnedExportReport report;
  fit.measure(report);
  SkinnedFile made = skinnedFile(source, character.mesh, fit, settings);
  report.joints = made.joints;
  report.vertices = made.vertices;
  report.triangles = made.triangles;
  report.left = std::move(made.left);
  const Result<std::uint64_t> bytes =
      lowerEnding(file) == ".usda" ? writeUsd(source, made.packed, file, report.left) : writeGltf(made.packed, file);
  if (!bytes) return bytes.error();
  report.bytes = bytes.value();
  return report;
}

}  // namespace

const char* nameOf(JointScale scale) { return kScaleNames[static_cast<std::size_t>(scale)]; }

std::optional<JointScale> jointScaleNamed(const std::string& name) {
  const auto found = std::ranges::find(kScaleNames, name);
  if (found == kScaleNames.end()) return std::nullopt;
  return static_cast<JointScale>(found - kScaleNames.begin());
}

bool isSkinnedExportName(const std::filesystem::path& file) {
  const std::string ending = lowerEnding(file);
  return ending == ".glb" || ending == ".gltf" || ending == ".usda";
}

Result<SkinnedExportReport> exportSkinned(const std::filesystem::path& characterFile,
                                          const std::shared_ptr<const Character>& character, const Character& moving,
                                          const Rig& rig, const SkinnedExportSettings& settings,
                                          const std::filesystem::path& file, const ExportProgress& progress) {
  if (!isSkinnedExportName(file)) return Error{file.string(), {}, "expected a name that ends in .glb, .gltf or .usda"};
  if (auto known = checkClips(characterFile, *character, settings.clips); !known) return known.error();
  return guarded(characterFile, file, [&]() -> Result<SkinnedExportReport> {
    Source source(characterFile);
    requireSame(source, *character);
    JointFit fit(character, moving, rig, settings, progress);
    return exported(source, *character, fit, settings, file);
  });
}

}  // namespace sinew
