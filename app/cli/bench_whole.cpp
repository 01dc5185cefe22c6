// app/cli/bench_whole.cpp: scenes of both surface modes from the files, and where the figures go.
#include "app/cli/bench_whole.h"

#include <array>
#include <string>
#include <system_error>
#include <utility>

#include "app/bench/rig_or_trial.h"
#include "app/bench/whole.h"
#include "app/cli/console.h"
#include "app/document/document.h"
#include "app/platform/data_files.h"
#include "core/io/files/atomic_file.h"

namespace sinew::app {
namespace {

constexpr int kRounds = 7;

/// The files of one mode, where none were given: rigs made for it.
struct Bundled {
  SurfaceMode mode;
  std::array<const char*, 2> files;
};
constexpr std::array kBundled{
    Bundled{SurfaceMode::kSwell, {"assets/humanoid.rig.json", "assets/horse.rig.json"}},
    Bundled{SurfaceMode::kReplace, {"assets/humanoid-wrapped.rig.json", "assets/horse-wrapped.rig.json"}}};

/// `--json humanoid.rig.json` measures that rig: it is never written over.
bool isInput(const std::filesystem::path& file) {
  const std::string name = file.string();
  return name.ends_with(".rig.json") || name.ends_with(".glb") || name.ends_with(".gltf");
}

Result<ModeScenes> scenesOf(SurfaceMode mode, const std::vector<std::filesystem::path>& files) {
  ModeScenes scenes;
  for (const std::filesystem::path& file : files) {
    progress("reading " + file.string());
    const auto document = openDocument(file);
    if (!document) return document.error();
    BenchScene scene{sceneName(file), document->character, rigOrTrial(document.value())};
    scene.rig.surface.mode = mode;
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

/// Nobody waits a minute for figures that have no place to go.
bool hasFolder(const std::filesystem::path& file) {
  std::error_code failed;
  return file.parent_path().empty() || std::filesystem::is_directory(file.parent_path(), failed);
}

void tellProgress(int done, int all, const std::string& now) {
  constexpr int kWidth = 24;
  const auto filled = static_cast<std::size_t>(kWidth * done / all);
  progress('[' + std::string(filled, '#') + std::string(kWidth - filled, '.') + "] " + now);
}

}  // namespace

int benchWhole(WholeOptions options) {
  if (options.json && isInput(*options.json)) options.files.push_back(std::exchange(*options.json, {}));
  if (options.json && !hasFolder(*options.json)) {
    return badInput({options.json->string(), "", "cannot be written: its folder does not exist"});
  }
  std::vector<ModeScenes> modes;
  for (const Bundled& bundled : kBundled) {
    std::vector<std::filesystem::path> files = options.files;
    if (files.empty()) {
      for (const char* file : bundled.files) files.push_back(dataFile(file));
    }
    Result<ModeScenes> scenes = scenesOf(bundled.mode, files);
    if (!scenes) return badInput(scenes.error());
    modes.push_back(std::move(scenes.value()));
  }
  const Result<Whole> whole = measureWhole(modes, options.rounds > 0 ? options.rounds : kRounds, tellProgress);
  if (!whole) return badInput(whole.error());
  if (!options.json) return putResult(textOf(whole.value()));
  const std::string json = jsonOf(whole.value()).dump(true) + '\n';
  if (options.json->empty()) return putResult(json);
  if (const auto written = writeFileAtomically(*options.json, json); !written) return badInput(written.error());
  return putResult(textOf(whole.value()));
}

}  // namespace sinew::app
