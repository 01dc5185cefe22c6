// app/export/export_kinds.cpp: the table of kinds, and what they have in common.
#include "app/export/export_kinds.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <new>
#include <system_error>

#include "app/document/folder_listing.h"
#include "core/rig/attachment.h"
#include "core/symmetry/motion_clip.h"

namespace sinew::app {
namespace {

std::string lowerEnding(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

std::string percentText(double percent) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), percent < 0.01 ? "%.1g %%" : "%.2g %%", percent);
  return text.data();
}

/// As the command line reads it back.
std::string numberWord(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", number);
  return text.data();
}

/// How close it comes over its clips; without any over the poses that it was measured in.
std::string figuresOf(const SkinnedExportReport& report) {
  const ErrorFigures& error = report.allClips.poses > 0 ? report.allClips : report.fitted;
  std::string text;
  if (error.poses > 0) {
    text = "RMS " + percentText(error.rms) + " of the height, largest " + percentText(error.largest) + "; ";
  }
  return text + std::to_string(report.joints) + (report.joints == 1 ? " joint; " : " joints; ") +
         sizeText(report.bytes);
}

Result<ExportSummary> runJoints(const ExportSource& source, const SkinnedExportSettings& settings,
                                const std::filesystem::path& file, const ExportProgress& progress) {
  const auto moving = withRangeOfMotion(source.character);
  const auto report =
      exportSkinned(source.characterFile, source.character, *moving, source.rig, settings, file, progress);
  if (!report) return report.error();
  return ExportSummary{figuresOf(report.value()), report->left};
}

Result<ExportSummary> runHelpers(const ExportSource& source, const ExportSettings& settings,
                                 const std::filesystem::path& file, const ExportProgress& progress) {
  return runJoints(source,
                   {.joints = ExportJoints::kHelpers,
                    .mesh = settings.mesh,
                    .clips = settings.clips,
                    .helpers = settings.helpers,
                    .jointScale = settings.jointScale},
                   file, progress);
}

Result<ExportSummary> runSkinned(const ExportSource& source, const ExportSettings& settings,
                                 const std::filesystem::path& file, const ExportProgress& progress) {
  return runJoints(source, {.mesh = settings.mesh, .weights = settings.weights, .clips = settings.clips}, file,
                   progress);
}

Result<ExportSummary> runBaked(const ExportSource& source, const ExportSettings& settings,
                               const std::filesystem::path& file, const ExportProgress& progress) {
  const BakedExportSettings baked{.clip = settings.clips.front(),
                                  .framesPerSecond = settings.framesPerSecond,
                                  .bound = settings.bound,
                                  .weights = settings.weights};
  const auto report = exportBaked(source.characterFile, source.character, source.rig, baked, file, progress);
  if (!report) return report.error();
  std::string figures = std::to_string(report->frames) + " frames; ";
  if (report->targets > 0) {
    figures += "largest distance " + percentText(report->baked.largest) + " of the height; " +
               std::to_string(report->targets) + (report->targets == 1 ? " morph target; " : " morph targets; ");
  }
  return ExportSummary{figures + sizeText(report->bytes), report->left};
}

constexpr std::array kStages{".glb", ".gltf", ".usda"};
constexpr std::array kGltf{".glb", ".gltf"};
constexpr std::array kCaches{".pc2", ".mdd"};
constexpr std::array kPoints{".usda"};

constexpr ExportKind kKinds[] = {
    {"helpers", "Muscle joints",
     "Adds joints that move as the muscles do, keyed in every clip: closest to the picture, and plays in every game "
     "engine.",
     kStages, ExportFields{.mesh = true, .depth = true, .clips = true, .helpers = true}, runHelpers},
    {"skinned", "Skinned",
     "Joints and weights alone, the muscles at rest in the mesh: plays in every game engine and viewer.", kStages,
     ExportFields{.mesh = true, .depth = true, .weights = true, .clips = true}, runSkinned},
    {"baked", "Baked clip",
     "One clip as it is in the picture: joints, and morph targets that bring every vertex as near as you ask.", kGltf,
     ExportFields{.depth = true, .weights = true, .oneClip = true, .bound = true}, runBaked},
    {"baked", "Point cache",
     "One clip as it is in the picture, every vertex in every frame, for Blender, Maya and others; an .obj comes with "
     "it.",
     kCaches, ExportFields{.depth = true, .oneClip = true}, runBaked},
    {"baked", "USD points",
     "One clip as it is in the picture, every vertex in every frame, with materials and textures, for programs that "
     "read USD.",
     kPoints, ExportFields{.depth = true, .oneClip = true}, runBaked},
};

/// The character as its file gives it: clips that were made in memory are at the end.
std::shared_ptr<const Character> asInFile(const std::shared_ptr<const Character>& character) {
  if (std::ranges::none_of(character->clips, &AnimationClip::turnsBindPose)) return character;
  auto own = std::make_shared<Character>(*character);
  std::erase_if(own->clips, [](const AnimationClip& clip) { return clip.turnsBindPose; });
  return own;
}

}  // namespace

std::span<const ExportKind> exportKinds() { return kKinds; }

std::filesystem::path withExportEnding(std::filesystem::path file, const ExportKind& kind) {
  if (std::ranges::find(kind.endings, lowerEnding(file)) == kind.endings.end()) file += kind.endings.front();
  return file;
}

std::vector<std::filesystem::path> replacedByExport(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> files{file};
  std::filesystem::path binary = file;
  if (lowerEnding(file) == ".gltf") files.push_back(binary.replace_extension(".bin"));
  if (std::ranges::find(kCaches, lowerEnding(file)) != kCaches.end()) {
    for (const char* ending : {".obj", ".mtl"}) files.push_back(binary.replace_extension(ending));
  }
  std::error_code failed;
  std::erase_if(files, [&](const std::filesystem::path& each) { return !std::filesystem::exists(each, failed); });
  return files;
}

std::vector<std::string> exportArguments(const ExportKind& kind, const ExportSettings& settings) {
  std::vector<std::string> words{"--as", kind.word};
  const auto add = [&](const char* option, const std::string& value) {
    words.emplace_back(option);
    words.push_back(value);
  };
  if (kind.fields.mesh && settings.mesh == ExportMesh::kOriginal) add("--mesh", "original");
  if (kind.fields.depth && settings.depth) add("--depth", std::to_string(*settings.depth));
  if (kind.fields.helpers && settings.helpers != kDefaultHelpers) add("--joints", std::to_string(settings.helpers));
  if (kind.fields.helpers && settings.jointScale != JointScale::kFull)
    add("--joint-scale", nameOf(settings.jointScale));
  if (kind.fields.weights && settings.weights == ExportWeights::kTransferred) add("--weights", "transferred");
  const ExportSettings plain;
  if (kind.fields.oneClip && settings.framesPerSecond != plain.framesPerSecond)
    add("--fps", numberWord(settings.framesPerSecond));
  if (kind.fields.bound && settings.bound != plain.bound) add("--bound", numberWord(settings.bound));
  // In one word: a clip's name may begin with a dash.
  if (kind.fields.clips || kind.fields.oneClip) {
    for (const std::string& clip : settings.clips) words.push_back("--clip=" + clip);
  }
  return words;
}

std::vector<std::string> exportableClips(const Character& character) {
  std::vector<std::string> names;
  for (const AnimationClip& clip : character.clips) {
    if (!clip.turnsBindPose) names.push_back(clip.name);
  }
  return names;
}

Result<ExportSummary> runExport(const ExportKind& kind, const ExportSource& source, const ExportSettings& settings,
                                const std::filesystem::path& file, const ExportProgress& progress) {
  try {
    ExportSource own{source.characterFile, asInFile(source.character), source.rig};
    if (settings.depth) own.rig.smoothing.depth = *settings.depth;
    if (const auto missing = missingBones(own.rig, own.character->skeleton); !missing.empty()) return missing.front();
    return kind.run(own, settings, file, progress);
  } catch (const std::bad_alloc&) {
    return Error{file.string(), {}, "there is not enough memory to export it"};
  }
}

}  // namespace sinew::app
