// tests/bench/swell_bench.cpp: `swell` by every instruction set, side by side. Usage: swell_bench [ROUNDS]
//
// In every round each moment is smoothed by all sets in turn, so that a slow moment of the machine meets them alike.
// The least times are printed: what the machine does when nothing else runs.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "core/lanes/instruction_set.h"
#include "sinew/io/gltf_import.h"
#include "sinew/io/rig_json.h"
#include "sinew/smoothing/smoother.h"
#include "tests/support/rigs/trial_scenes.h"

namespace sinew::test {
namespace {

constexpr int kDepth = 5;
constexpr int kMoments = 6;

/// One set's times, a row a frame: seconds over projected vertices, and of the whole frame.
struct Times {
  std::vector<double> project;
  std::vector<double> frame;
};

void measure(const std::string& name, const Character& character, Smoother& smoother, bool cuts, int rounds) {
  const auto sets = availableInstructionSets();
  const std::vector<Pose> poses = spreadPoses(character, kMoments);
  std::vector<Times> times(sets.size());
  Surface surface;
  for (int round = 0; round <= rounds; ++round) {
    for (std::size_t p = 0; p < poses.size(); ++p) {
      for (std::size_t s = 0; s < sets.size(); ++s) {
        const InstructionSetScope scope(sets[s]);
        // What was smoothed just before: another moment, or this one.
        smoother.smooth(poses[cuts ? (p + poses.size() / 2) % poses.size() : p], surface);
        smoother.smooth(poses[p], surface);
        if (round == 0) continue;
        const double vertices = std::max(1, surface.report.projected);
        times[s].project.push_back(surface.report.seconds.project / vertices);
        times[s].frame.push_back(surface.report.seconds.total());
      }
    }
  }
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const double project = std::ranges::min(times[s].project);
    const double frame = std::ranges::min(times[s].frame);
    std::printf("%-10s %-7s %-7s %9d %10.1f %8.1f %9.3f %8.2f\n", name.c_str(), cuts ? "cut" : "steady",
                nameOf(sets[s]), surface.report.projected, 1e9 * project, std::ranges::min(times[0].project) / project,
                1e3 * frame, std::ranges::min(times[0].frame) / frame);
  }
}

int run(int rounds) {
  std::printf("%-10s %-7s %-7s %9s %10s %8s %9s %8s\n", "scene", "before", "set", "vertices", "ns/vertex", "x scalar",
              "frame ms", "x scalar");
  for (const std::string name : {"humanoid", "horse", "demo", "wrapped", "tangle"}) {
    const std::filesystem::path file = std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / (name + ".rig.json");
    const auto rig = loadRig(file);
    if (!rig) return std::fprintf(stderr, "%s\n", rig.error().text().c_str()), 1;
    const auto character = importGltf(characterPath(rig.value(), file));
    if (!character) return std::fprintf(stderr, "%s\n", character.error().text().c_str()), 1;
    Rig swelling = withMode(rig.value(), SurfaceMode::kSwell);
    swelling.smoothing.depth = kDepth;
    Smoother smoother(character.value());
    const auto prepared = smoother.prepare(swelling);
    if (!prepared) return std::fprintf(stderr, "%s\n", prepared.error().text().c_str()), 1;
    for (const bool cuts : {false, true}) measure(name, *character.value(), smoother, cuts, rounds);
  }
  return 0;
}

}  // namespace
}  // namespace sinew::test

int main(int count, char** arguments) {
  int rounds = 15;
  if (count > 1) std::from_chars(arguments[1], arguments[1] + std::strlen(arguments[1]), rounds);
  return sinew::test::run(std::max(rounds, 1));
}
