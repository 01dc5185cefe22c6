// tests/bench/parts.h: what sinew_bench measures, part by part.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/command/console.h"
#include "app/command/measuring.h"
#include "core/files/json/json.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

using Files = std::span<const std::filesystem::path>;

/// How much is measured. What a frame and a round are is up to the part.
struct Effort {
  int frames = 0;
  int rounds = 0;
};

struct Report {
  std::string table;  ///< For people.
  Json rows = {};     ///< For programs; null where there are none.
};

// Error: a file cannot be opened, or what is in it cannot be measured.

/// The field of ellipsoids, spheres and shapes, at points and along rays. Reads no file.
[[nodiscard]] Result<Report> reportField(Files files, const Effort& effort);
/// 4,000 lines and 1,000 drivers beside skinning the first file's character. A round is a pose of its first clip.
[[nodiscard]] Result<Report> reportAnimation(Files files, const Effort& effort);
/// Frames of a drag with short and long history, few and many muscles.
[[nodiscard]] Result<Report> reportDrag(Files files, const Effort& effort);
/// How often the skin steps far, and pops, over all clips. A round is a random rig, frames are at most so many a clip.
[[nodiscard]] Result<Report> reportPops(Files files, const Effort& effort);
/// What each stage takes of a frame in `swell`.
[[nodiscard]] Result<Report> reportStages(Files files, const Effort& effort);
/// Every kind of export beside smoothing. Frames: the depth at which the character is split before.
[[nodiscard]] Result<Report> reportExports(Files files, const Effort& effort);

/// How far flat triangles lie off the surface with uniform and with adaptive detail, and what both cost.
[[nodiscard]] Result<Report> reportDetail(Files files, const Effort& effort);

/// How much of the surface is shaded otherwise than a much finer one. Frames: moments of each clip.
[[nodiscard]] Result<Report> reportShading(Files files, const Effort& effort);

/// Frames of a drag with adaptive detail, and the frame after it. Frames: muscles; a round is a drag of each.
[[nodiscard]] Result<Report> reportSettling(Files files, const Effort& effort);

/// Moments of each clip, evenly spaced: at most so many, and thirty a second.
[[nodiscard]] std::vector<Pose> momentsOf(const Character& character, int most);

/// One line on stderr if that is a terminal: what takes a while now.
void progress(const std::string& text);

/// The rows of all files. @param measure  (const BenchScene&) -> Result<std::vector<Row>>
template <class Row, class Measure>
Result<std::vector<Row>> rowsOf(Files files, const Measure& measure) {
  std::vector<Row> rows;
  for (const std::filesystem::path& file : files) {
    progress("reading " + file.string());
    const Result<BenchScene> scene = openScene(file);
    if (!scene) return scene.error();
    const Result<std::vector<Row>> measured = measure(scene.value());
    if (!measured) return Error{file.string(), measured.error().place, measured.error().reason};
    rows.insert(rows.end(), measured->begin(), measured->end());
  }
  return rows;
}

}  // namespace sinew::app
