// app/command/bench.cpp: `sinew bench`: opens the scenes of both surface modes, measures, prints.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/command/console.h"
#include "app/command/measuring.h"
#include "app/command/verbs.h"
#include "app/command/whole.h"
#include "app/document/folder_listing.h"
#include "app/ui/data_files.h"
#include "app/ui/offscreen.h"
#include "app/viewport/gpu/card_figures.h"
#include "app/viewport/render/gl_objects.h"
#include "core/files/disk/atomic_file.h"

namespace sinew::app {
namespace {

struct BenchOptions {
  std::vector<std::filesystem::path> files;   ///< Rigs or characters; none: the bundled ones.
  std::optional<std::filesystem::path> json;  ///< Empty path: on stdout in place of the table. nullopt: none.
  int rounds = 7;
  std::optional<int> crowd;  ///< `bench gpu`: bodies.
  int frames = 10;           ///< `bench gpu`.
  bool progress = false;     ///< Even where stderr is not a terminal.
};

/// Bundled rigs made for one mode.
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
  return name.ends_with(".rig.json") || isCharacterName(name);
}

Result<ModeScenes> scenesOf(const Bundled& bundled, std::vector<std::filesystem::path> files) {
  if (files.empty()) {
    for (const char* file : bundled.files) files.push_back(dataFile(file));
  }
  ModeScenes scenes;
  for (const std::filesystem::path& file : files) {
    Result<BenchScene> scene = openScene(file);
    if (!scene) return scene.error();
    scenes.push_back(std::move(scene.value()));
    scenes.back().rig.surface.mode = bundled.mode;
  }
  return scenes;
}

/// Checked before measuring, which takes minutes.
bool hasFolder(const std::filesystem::path& file) {
  std::error_code failed;
  return file.parent_path().empty() || std::filesystem::is_directory(file.parent_path(), failed);
}

/// `--json` alone prints the numbers on stdout, as for other verbs.
void addBenchOptions(CLI::App& verb, BenchOptions& options) {
  verb.add_option_function<std::vector<std::string>>(
      "FILE", [&options](const std::vector<std::string>& files) { options.files.assign(files.begin(), files.end()); },
      "Rigs (.rig.json), or characters, which get 12 muscles by rule; none: humanoid and horse, made for each mode. "
      "The word gpu before them: the graphics card beside the processor");
  verb.add_option_function<std::vector<std::string>>(
          "--json",
          [&options](const std::vector<std::string>& files) { options.json = files.empty() ? "" : files.front(); },
          "Print JSON, for programs; or write it to FILE.json beside the table")
      ->type_name("FILE.json")
      ->expected(0, 1);
  verb.add_option("--rounds", options.rounds, "Times everything is timed (7)")
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  verb.add_option("--crowd", options.crowd,
                  "With gpu: bodies, each in a moment of its own (1000; none where there is no graphics card)")
      ->type_name("N")
      ->check(CLI::Range(1, 100'000));
  verb.add_option("--frames", options.frames, "With gpu: moments of the first clip (10)")
      ->type_name("N")
      ->check(CLI::Range(1, 10'000));
  verb.add_flag("--progress", options.progress,
                "Report progress on stderr every 5 percent; a terminal always shows it");
}

constexpr double kFrameStep = 1.0 / 30.0;  ///< Seconds between the moments of `bench gpu`.

constexpr int kCrowd = 1000;

/// Prints text or JSON, or writes JSON beside the text.
int putFigures(const BenchOptions& options, const std::string& text, const Json& json) {
  if (!options.json) return putResult(text);
  const std::string bytes = json.dump(true) + '\n';
  if (options.json->empty()) return putResult(bytes);
  if (const auto written = writeFileAtomically(*options.json, bytes); !written) return badInput(written.error());
  return putResult(text);
}

/// The word after --json may be an input; the folder of an output must exist.
std::optional<Error> settleJson(BenchOptions& options) {
  if (options.json && isInput(*options.json)) options.files.push_back(std::exchange(*options.json, {}));
  if (!options.json || hasFolder(*options.json)) return std::nullopt;
  return Error{options.json->string(), "", "cannot be written: its folder does not exist"};
}

/// Compares the graphics card with the processor: one body, then a crowd.
int runGpuBench(const BenchOptions& options) {
  std::vector<std::filesystem::path> files = options.files;
  if (files.empty()) files = {dataFile("assets/humanoid.rig.json"), dataFile("assets/horse.rig.json")};
  const auto context = OffscreenContext::create();
  if (!context) return badInput(context.error());
  const Result<StagePrograms> programs = StagePrograms::create();
  if (!programs) return badInput(programs.error());
  std::string text = "card: " + rendererName() + "\n";
  Json scenes = Json::array();
  const int crowd = options.crowd.value_or(isSoftwareRenderer() ? 1 : kCrowd);
  for (const std::filesystem::path& file : files) {
    const Result<BenchScene> scene = openScene(file);
    if (!scene) return badInput(scene.error());
    BlendingGraphMemo graphs;
    const auto preparation = prepare(characterTables(scene->character), scene->rig, {}, nullptr, graphs);
    if (!preparation) return badInput({file.string(), preparation.error().place, preparation.error().reason});
    const std::vector<Pose> frames = steadyFrames(*scene->character, options.frames, kFrameStep);
    for (const int bodies : crowd > 1 ? std::vector{1, crowd} : std::vector{1}) {
      const auto figures = measureCard(programs.value(), preparation.value(), frames, bodies);
      if (!figures) return badInput({file.string(), "", "not computed on the card: " + figures.error().reason});
      text += textOf(scene->name, figures.value());
      scenes.push(jsonOf(scene->name, figures.value()));
    }
  }
  return putFigures(options, text, Json::object().set("card", rendererName()).set("scenes", scenes));
}

int runBench(BenchOptions options) {
  if (!options.files.empty() && options.files.front() == "gpu") {
    options.files.erase(options.files.begin());
    if (const auto bad = settleJson(options)) return badInput(*bad);
    return runGpuBench(options);
  }
  if (options.crowd || options.frames != 10) return badCommandLine("--crowd and --frames go with `bench gpu`");
  if (const auto bad = settleJson(options)) return badInput(*bad);
  std::vector<ModeScenes> modes;
  for (const Bundled& bundled : kBundled) {
    Result<ModeScenes> scenes = scenesOf(bundled, options.files);
    if (!scenes) return badInput(scenes.error());
    modes.push_back(std::move(scenes.value()));
  }
  ProgressLine line("measuring", options.progress);
  const Result<Whole> whole =
      measureWhole(modes, options.rounds, [&](int done, int all) { line.show(static_cast<double>(done) / all); });
  if (whole) line.show(1.0);
  line.end();
  if (!whole) return badInput(whole.error());
  return putFigures(options, textOf(whole.value()), jsonOf(whole.value()));
}

}  // namespace

Verb benchVerb() { return makeVerb<BenchOptions>("bench", "Measure on this machine", addBenchOptions, runBench); }

}  // namespace sinew::app
