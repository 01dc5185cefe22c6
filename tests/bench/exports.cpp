// tests/bench/exports.cpp: what each kind of export takes of a character with many vertices, beside smoothing it.
#include <unistd.h>
#include <array>
#include <cstdio>

#include "app/command/measuring.h"
#include "app/document/document.h"
#include "app/document/export_kinds.h"
#include "core/geometry/at.h"
#include "core/geometry/stopwatch.h"
#include "sinew/files/gltf_import.h"
#include "sinew/surface/crowd_smoother.h"
#include "tests/bench/parts.h"

namespace sinew::app {
namespace {

/// One kind of export. A kind contains what the one above it does, but for baked ones.
struct ExportWay {
  const char* name;
  const char* word;
  const char* ending;
  ExportWeights weights;
};

constexpr std::array kWays{
    ExportWay{"skinned, transferred", "skinned", ".glb", ExportWeights::kTransferred},
    ExportWay{"skinned, refitted", "skinned", ".glb", ExportWeights::kRefitted},
    ExportWay{"helpers", "helpers", ".glb", ExportWeights::kRefitted},
    ExportWay{"point cache", "baked", ".pc2", ExportWeights::kRefitted},
    ExportWay{"USD points", "baked", ".usda", ExportWeights::kRefitted},
    ExportWay{"morph targets", "baked", ".glb", ExportWeights::kRefitted},
};

constexpr int kSmoothed = 16;  ///< Poses that a smoothing is the mean of.

struct ExportRow {
  std::string scene;
  std::string way;
  std::int64_t vertices = 0;
  double seconds = 0.0;  ///< Median of the rounds.
  double ratio = 0.0;    ///< Over one smoothing in the same round, median.
  double error = 0.0;    ///< Root mean square, percent of the height; 0 where points are the surface itself.
};

/// Removed again with what is in it.
class ScratchFolder {
 public:
  ScratchFolder() : path_(std::filesystem::temp_directory_path() / ("sinew_bench." + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

const ErrorFigures& errorOf(const ExportReport& report) {
  const auto* const baked = std::get_if<BakedExportReport>(&report);
  return baked ? baked->baked : std::get<SkinnedExportReport>(report).allClips;
}

/// The scene's character with every triangle split, and the scene's muscles on it.
Result<ExportSource> manyVertices(const BenchScene& scene, const std::filesystem::path& source, int depth,
                                  const std::filesystem::path& folder) {
  Rig bare;
  bare.smoothing.depth = depth;
  const std::filesystem::path file = folder / "many.glb";
  const auto written =
      exportSkinned(source, scene.character, *scene.character, bare, {.weights = ExportWeights::kTransferred}, file);
  if (!written) return written.error();
  const auto character = importGltf(file);
  if (!character) return character.error();
  return ExportSource{file, character.value(), scene.rig};
}

Result<double> secondsToSmooth(const ExportSource& source) {
  CrowdSmoother smoother(source.character);
  if (const auto prepared = smoother.prepare(source.rig); !prepared) return prepared.error();
  const std::vector<Pose> poses = spreadFrames(*source.character, kSmoothed);
  std::vector<Surface> surfaces(poses.size());
  smoother.smooth(poses, surfaces);  // Warms up.
  Stopwatch watch;
  smoother.smooth(poses, surfaces);
  return watch.lap() / static_cast<double>(poses.size());
}

Result<std::vector<ExportRow>> measureExports(const std::filesystem::path& from, const Effort& effort) {
  progress("reading " + from.string());
  const Result<Document> document = openDocument(from);
  if (!document) return document.error();
  const Result<BenchScene> opened = openScene(from);
  if (!opened) return opened.error();
  const BenchScene& scene = opened.value();
  const ScratchFolder folder;
  const Result<ExportSource> source = manyVertices(scene, document->characterFile, effort.frames, folder.path());
  if (!source) return source.error();
  if (source->character->clips.empty()) return Error{"", scene.name, "no clip to export"};
  std::vector<ExportRow> rows;
  std::vector<double> smoothing(toIndex(effort.rounds));
  for (double& seconds : smoothing) {
    const Result<double> measured = secondsToSmooth(source.value());
    if (!measured) return measured.error();
    seconds = measured.value();
  }
  for (const ExportWay& way : kWays) {
    progress(std::string("exporting ") + scene.name + ": " + way.name);
    const std::filesystem::path file = folder.path() / (std::string("out") + way.ending);
    const auto kind = findExportKind(way.word, file);
    if (!kind) return kind.error();
    ExportSettings settings;
    settings.weights = way.weights;
    if (kind.value()->fields.oneClip) settings.clips = {source->character->clips.front().name};
    ExportRow row{scene.name, way.name, 0, 0.0, 0.0, 0.0};
    std::vector<double> seconds;
    for (int round = 0; round < effort.rounds; ++round) {
      Stopwatch watch;
      const auto report = runExport(*kind.value(), source.value(), settings, file, {});
      if (!report) return report.error();
      seconds.push_back(watch.lap());
      row.vertices = std::visit([](const auto& any) { return any.vertices; }, report.value());
      row.error = errorOf(report.value()).rms;
    }
    row.seconds = median(seconds);
    row.ratio = medianRatio(seconds, smoothing);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string tableOf(const std::vector<ExportRow>& rows) {
  std::string table =
      "Exports of a character that is split before it gets its muscles. Skinned and helpers: all clips, measured at "
      "30\n"
      "poses a second and beside the range of motion; baked: the first clip. Smoothings: as long as so many surfaces\n"
      "of the same size take on the same threads. Error: % of the height, root mean square.\n"
      "\n"
      "scene             export                vertices   seconds  smoothings    error\n";
  char line[160];
  for (const ExportRow& row : rows) {
    std::snprintf(line, sizeof line, "%-16.40s  %-20s  %8lld  %8.2f  %10.1f  %7.3f\n", row.scene.c_str(),
                  row.way.c_str(), static_cast<long long>(row.vertices), row.seconds, row.ratio, row.error);
    table += line;
  }
  return table;
}

Json jsonOf(const std::vector<ExportRow>& rows) {
  Json list = Json::array();
  for (const ExportRow& row : rows) {
    Json item = Json::object();
    item.set("scene", row.scene).set("export", row.way).set("vertices", static_cast<double>(row.vertices));
    item.set("seconds", row.seconds).set("smoothings", row.ratio).set("error_rms", row.error);
    list.push(item);
  }
  return list;
}

}  // namespace

Result<Report> reportExports(Files files, const Effort& effort) {
  std::vector<ExportRow> rows;
  for (const std::filesystem::path& file : files) {
    const auto measured = measureExports(file, effort);
    if (!measured) return measured.error();
    rows.insert(rows.end(), measured->begin(), measured->end());
  }
  return Report{tableOf(rows), jsonOf(rows)};
}

}  // namespace sinew::app
