// core/export/skinned_export.cpp: pose by pose the live surface, then weights, then the file, then how close it comes.
#include "sinew/export/skinned_export.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <exception>
#include <new>
#include <set>

#include "core/base/at.h"
#include "core/export/fit/joint_fit.h"
#include "core/export/skinned_file.h"
#include "core/io/files/atomic_file.h"

namespace sinew {
namespace {

using namespace exporting;

constexpr std::array kScaleNames{"full", "uniform", "none"};  // In the order of JointScale.

std::string lowerEnding(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

Result<void> checkClips(const std::filesystem::path& file, const Character& character,
                        const std::vector<std::string>& asked) {
  for (const std::string& name : asked) {
    if (std::ranges::find(character.clips, name, &AnimationClip::name) != character.clips.end()) continue;
    std::string known;
    for (const AnimationClip& clip : character.clips) known += (known.empty() ? "\"" : ", \"") + clip.name + '"';
    return Error{
        file.string(), "clip \"" + name + '"',
        known.empty() ? "it has no clips" : "expected " + (character.clips.size() > 1 ? "one of " + known : known)};
  }
  return {};
}

/// Files that an export writes, the one named last.
std::vector<std::filesystem::path> filesOf(const std::filesystem::path& file) {
  if (lowerEnding(file) == ".glb") return {file};
  std::filesystem::path binary = file;
  return {binary.replace_extension(".bin"), file};
}

Result<void> checkPlaces(const Source& source, const std::filesystem::path& file) {
  std::error_code unknown;
  if (file.has_parent_path() && !std::filesystem::is_directory(file.parent_path(), unknown)) {
    return Error{file.string(), {}, "cannot be written: there is no such folder"};
  }
  for (const std::filesystem::path& place : filesOf(file)) {
    if (std::filesystem::is_directory(place, unknown)) {
      return Error{place.string(), {}, "cannot be written: it is a folder"};
    }
    if (source.reads(place)) {
      return Error{place.string(), {}, "cannot be written: the character is read from it"};
    }
  }
  return {};
}

Result<std::uint64_t> write(const PackedGltf& packed, const std::filesystem::path& file) {
  const std::vector<std::filesystem::path> files = filesOf(file);
  if (files.size() == 1) {
    const Result<std::string> bytes = glbOf(packed);
    if (!bytes) return Error{file.string(), {}, bytes.error().reason};
    if (auto written = writeFileAtomically(file, bytes.value()); !written) return written.error();
    return std::uint64_t{bytes->size()};
  }
  const std::string text = gltfOf(packed, files.front().filename().string());
  if (auto written = writeFilesAtomically({{files.front(), packed.binary}, {file, text}}); !written) {
    return written.error();
  }
  return std::uint64_t{text.size() + packed.binary.size()};
}

Result<SkinnedExportReport> exported(Source& source, const Character& character, JointFit& fit,
                                     const SkinnedExportSettings& settings, const std::filesystem::path& file) {
  if (auto free = checkPlaces(source, file); !free) return free.error();
  if (auto found = fit.findWeights(); !found) return found.error();
  SkinnedExportReport report;
  fit.measure(report);
  SkinnedFile made = skinnedFile(source, character.mesh, fit, settings);
  report.joints = made.joints;
  report.vertices = made.vertices;
  report.triangles = made.triangles;
  report.left = std::move(made.left);
  const Result<std::uint64_t> bytes = write(made.packed, file);
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
  return ending == ".glb" || ending == ".gltf";
}

Result<SkinnedExportReport> exportSkinned(const std::filesystem::path& characterFile,
                                          const std::shared_ptr<const Character>& character, const Character& moving,
                                          const Rig& rig, const SkinnedExportSettings& settings,
                                          const std::filesystem::path& file, const ExportProgress& progress) {
  if (!isSkinnedExportName(file)) return Error{file.string(), {}, "expected a name that ends in .glb or .gltf"};
  if (auto known = checkClips(characterFile, *character, settings.clips); !known) return known.error();
  try {
    Source source(characterFile);
    requireSame(source, *character);
    JointFit fit(character, moving, rig, settings, progress);
    return exported(source, *character, fit, settings, file);
  } catch (const gltf::Refusal& refusal) {
    return Error{characterFile.string(), refusal.error.place, refusal.error.reason};
  } catch (const Cancelled&) {
    return Error{file.string(), {}, std::string(kCancelled)};
  } catch (const std::bad_alloc&) {
    return Error{characterFile.string(), {}, "there is not enough memory to export it"};
  } catch (const std::exception& error) {
    return Error{characterFile.string(), {}, shortened(error.what())};
  }
}

}  // namespace sinew
