// app/document/export_kinds.cpp: the table of kinds, the table of their settings, and running one.
#include "app/document/export_kinds.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <new>
#include <system_error>

#include "core/character/clip_names.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"
#include "core/rig/attachment.h"
#include "core/rig/motion_clip.h"

namespace sinew::app {
namespace {

std::string numberWord(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", number);
  return text.data();
}

Result<ExportReport> runJoints(const ExportSource& source, const SkinnedExportSettings& settings,
                               const std::filesystem::path& file, const ExportProgress& progress) {
  const auto moving = withRangeOfMotion(source.character);
  auto report = exportSkinned(source.characterFile, source.character, *moving, source.rig, settings, file, progress);
  if (!report) return report.error();
  return ExportReport(std::move(report).value());
}

Result<ExportReport> runHelpers(const ExportSource& source, const ExportSettings& settings,
                                const std::filesystem::path& file, const ExportProgress& progress) {
  return runJoints(source,
                   {.joints = ExportJoints::kHelpers,
                    .mesh = settings.mesh,
                    .clips = settings.clips,
                    .helpers = settings.helpers,
                    .jointScale = settings.jointScale},
                   file, progress);
}

Result<ExportReport> runSkinned(const ExportSource& source, const ExportSettings& settings,
                                const std::filesystem::path& file, const ExportProgress& progress) {
  return runJoints(source, {.mesh = settings.mesh, .weights = settings.weights, .clips = settings.clips}, file,
                   progress);
}

Result<ExportReport> runBaked(const ExportSource& source, const ExportSettings& settings,
                              const std::filesystem::path& file, const ExportProgress& progress) {
  const BakedExportSettings baked{.clip = settings.clips.front(),
                                  .framesPerSecond = settings.framesPerSecond,
                                  .substeps = settings.substeps,
                                  .bound = settings.bound,
                                  .weights = settings.weights};
  auto report = exportBaked(source.characterFile, source.character, source.rig, baked, file, progress);
  if (!report) return report.error();
  return ExportReport(std::move(report).value());
}

constexpr ExportKind kKinds[] = {
    {"helpers",
     "Muscle joints",
     "Adds joints that move as the muscles do, keyed in every clip: closest to the picture, and plays in every game "
     "engine.",
     ExportForm::kSkin,
     {.mesh = true, .depth = true, .clips = true, .helpers = true},
     {.weights = true},
     runHelpers},
    {"skinned",
     "Skinned",
     "Joints and weights alone, the muscles at rest in the mesh: plays in every game engine and viewer.",
     ExportForm::kSkin,
     {.mesh = true, .depth = true, .weights = true, .clips = true},
     {},
     runSkinned},
    {"baked",
     "Baked clip",
     "One clip as it is in the picture: joints, and morph targets that bring every vertex as near as you ask.",
     ExportForm::kTargets,
     {.depth = true, .weights = true, .oneClip = true, .bound = true},
     {.mesh = true},
     runBaked},
    {"baked",
     "Point cache",
     "One clip as it is in the picture, every vertex in every frame, for Blender, Maya and others; an .obj comes with "
     "it.",
     ExportForm::kCache,
     {.depth = true, .oneClip = true, .motion = true},
     {.mesh = true},
     runBaked},
    {"baked",
     "USD points",
     "One clip as it is in the picture, every vertex in every frame, with materials and textures, for programs that "
     "read USD.",
     ExportForm::kStage,
     {.depth = true, .oneClip = true, .motion = true},
     {.mesh = true},
     runBaked},
};

/// A setting as an option of the command line.
struct SettingWord {
  const char* option;
  bool ExportFields::*field;
  std::string (*valueOf)(const ExportSettings& settings);  ///< "": omitted.
};

constexpr SettingWord kSettings[] = {
    {"--mesh", &ExportFields::mesh, [](const ExportSettings& s) -> std::string { return nameOf(s.mesh); }},
    {"--depth", &ExportFields::depth,
     [](const ExportSettings& s) { return s.detail.depth ? std::to_string(*s.detail.depth) : std::string(); }},
    {"--detail", &ExportFields::depth,
     [](const ExportSettings& s) { return s.detail.kind ? std::string(nameOf(*s.detail.kind)) : std::string(); }},
    {"--tolerance", &ExportFields::depth,
     [](const ExportSettings& s) {
       return s.detail.tolerance ? numberWord(static_cast<double>(*s.detail.tolerance)) : std::string();
     }},
    {"--joints", &ExportFields::helpers, [](const ExportSettings& s) { return std::to_string(s.helpers); }},
    {"--joint-scale", &ExportFields::helpers,
     [](const ExportSettings& s) -> std::string { return nameOf(s.jointScale); }},
    {"--weights", &ExportFields::weights, [](const ExportSettings& s) -> std::string { return nameOf(s.weights); }},
    {"--fps", &ExportFields::oneClip, [](const ExportSettings& s) { return numberWord(s.framesPerSecond); }},
    {"--substeps", &ExportFields::bound, [](const ExportSettings& s) { return std::to_string(s.substeps); }},
    {"--bound", &ExportFields::bound, [](const ExportSettings& s) { return numberWord(s.bound); }},
};

bool isUsual(const SettingWord& setting, const ExportSettings& settings) {
  return setting.valueOf(settings) == setting.valueOf(ExportSettings());
}

/// Kinds that read a setting: endings of the same word, else other words.
std::string readersOf(bool ExportFields::*field, const ExportKind& kind) {
  std::vector<std::string> words;
  std::vector<ExportForm> forms;
  for (const ExportKind& other : kKinds) {
    if (!(other.fields.*field)) continue;
    if (std::string_view(other.word) == kind.word) forms.push_back(other.form);
    const std::string word = std::string("--as ") + other.word;
    if (std::ranges::find(words, word) == words.end()) words.push_back(word);
  }
  return listed(forms.empty() ? words : exportEndings(forms), "and");
}

/// Without clips made in memory.
std::shared_ptr<const Character> asInFile(const std::shared_ptr<const Character>& character) {
  if (std::ranges::none_of(character->clips, &AnimationClip::turnsBindPose)) return character;
  auto own = std::make_shared<Character>(*character);
  std::erase_if(own->clips, [](const AnimationClip& clip) { return clip.turnsBindPose; });
  return own;
}

Result<void> checkBones(const ExportSource& source) {
  const Skeleton& skeleton = source.character->skeleton;
  const auto missing = missingBones(source.rig, skeleton);
  if (missing.empty()) return {};
  Error refusal = refusalOf(missing.front(), skeleton);
  refusal.file = source.rigFile.string();
  return refusal;
}

}  // namespace

std::span<const ExportKind> exportKinds() { return kKinds; }

std::vector<std::string> exportWords() {
  std::vector<std::string> words;
  for (const ExportKind& kind : kKinds) {
    if (std::ranges::find(words, kind.word) == words.end()) words.emplace_back(kind.word);
  }
  return words;
}

std::string exportEndingsOf(const std::string& word) {
  std::vector<ExportForm> forms;
  for (const ExportKind& kind : kKinds) {
    if (word == kind.word) forms.push_back(kind.form);
  }
  return listed(exportEndings(forms), "or");
}

Result<const ExportKind*> findExportKind(const std::string& word, const std::filesystem::path& file) {
  for (const ExportKind& kind : kKinds) {
    if (word == kind.word && hasExportEnding(file, {kind.form})) return &kind;
  }
  return errorAt("--output",
                 "expected a name that ends in " + exportEndingsOf(word) + ", got \"" + file.string() + '"');
}

std::string usualEnding(const ExportKind& kind) { return exportEndings({kind.form}).front(); }

std::filesystem::path withExportEnding(std::filesystem::path file, const ExportKind& kind) {
  if (!hasExportEnding(file, {kind.form})) file += usualEnding(kind);
  return file;
}

std::vector<std::filesystem::path> replacedByExport(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> files = exportedFiles(file);
  std::ranges::rotate(files, files.end() - 1);  // The requested file first.
  std::error_code failed;
  std::erase_if(files, [&](const std::filesystem::path& each) { return !std::filesystem::exists(each, failed); });
  return files;
}

Result<void> checkExportSettings(const ExportKind& kind, const ExportSettings& settings,
                                 const std::function<bool(const char* option)>& isGiven) {
  for (const SettingWord& setting : kSettings) {
    if (!isGiven(setting.option) || kind.fields.*setting.field) continue;
    const bool isSettled = kind.settled.*setting.field;
    if (isSettled && isUsual(setting, settings)) continue;
    return errorAt(isSettled ? setting.option + (' ' + setting.valueOf(settings)) : setting.option,
                   "is for " + readersOf(setting.field, kind) + " alone");
  }
  if (kind.fields.oneClip && settings.clips.size() != 1) return errorAt("--clip", "expected one clip to bake");
  return {};
}

std::vector<std::string> exportArguments(const ExportKind& kind, const ExportSettings& settings) {
  std::vector<std::string> words{"--as", kind.word};
  for (const SettingWord& setting : kSettings) {
    if (!(kind.fields.*setting.field) || isUsual(setting, settings)) continue;
    words.insert(words.end(), {setting.option, setting.valueOf(settings)});
  }
  // In one word: a clip's name may begin with a dash.
  for (const std::string& clip : settings.clips) words.push_back("--clip=" + clip);
  return words;
}

std::vector<std::string> exportableClips(const ExportKind& kind, const Character& character) {
  std::vector<std::string> names;
  for (const AnimationClip& clip : character.clips) {
    if (kind.fields.motion || !clip.turnsBindPose) names.push_back(clip.name);
  }
  return names;
}

Result<void> checkExportSource(const ExportKind& kind, const ExportSource& source, const ExportSettings& settings) {
  const auto moving = kind.fields.motion ? withRangeOfMotion(source.character) : asInFile(source.character);
  const std::vector<std::string> known = exportableClips(kind, *moving);
  for (const std::string& name : settings.clips) {
    if (std::ranges::count(known, name) > 0) continue;
    return Error{source.characterFile.string(), "clip \"" + name + '"', noSuchClip(name, source.character->clips)};
  }
  return checkBones(source);
}

double heldFrames(const ExportKind& kind, const std::shared_ptr<const Character>& character,
                  const ExportSettings& settings) {
  if (!kind.fields.oneClip || settings.clips.empty()) return 0.0;
  const auto moving = withRangeOfMotion(character);
  const int clip = findClip(*moving, settings.clips.front());
  return clip < 0
             ? 0.0
             : static_cast<double>(at(moving->clips, clip).duration) * settings.framesPerSecond * settings.substeps;
}

Result<ExportReport> runExport(const ExportKind& kind, const ExportSource& source, const ExportSettings& settings,
                               const std::filesystem::path& file, const ExportProgress& progress) {
  try {
    ExportSource own{source.characterFile, asInFile(source.character), source.rig, source.rigFile};
    if (kind.fields.motion) own.character = withClipNamed(own.character, settings.clips.front());
    settings.detail.apply(own.rig.smoothing);
    if (const auto able = checkBones(own); !able) return able.error();
    return kind.run(own, settings, file, progress);
  } catch (const std::bad_alloc&) {
    return Error{file.string(), {}, "there is not enough memory to export it"};
  }
}

}  // namespace sinew::app
