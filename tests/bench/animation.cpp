// tests/bench/animation.cpp: what muscle lines and drivers cost beside skinning their character, on the same poses.
#include <cstdio>
#include <utility>

#include "app/command/measuring.h"
#include "core/character/skinning.h"
#include "core/geometry/stopwatch.h"
#include "core/rig/driver_input.h"
#include "core/rig/line_pose.h"
#include "tests/bench/parts.h"

namespace sinew::app {
namespace {

constexpr int kLines = 4000;
constexpr int kDrivers = 1000;

/// Medians of the rounds; the ratio is to skinning within one round.
struct AnimationCost {
  std::string what;
  int count = 0;
  double seconds = 0.0;  ///< For all of them in one pose.
  double ratio = 1.0;    ///< To skinning.
};

struct Work {
  AnimationCost cost;
  std::vector<double> seconds;
};

/// Bones that have a parent.
std::vector<int> joints(const Skeleton& skeleton) {
  std::vector<int> found;
  for (int bone = 0; bone < static_cast<int>(skeleton.bones.size()); ++bone) {
    if (skeleton.bones[static_cast<std::size_t>(bone)].parent >= 0) found.push_back(bone);
  }
  return found;
}

MuscleLine lineOver(const Character& character, int bone, int number) {
  const Skeleton& skeleton = character.skeleton;
  const float beside = character.height * (0.01f + 0.02f * static_cast<float>(number % 7) / 7.0f);
  MuscleLine line;
  line.name = std::to_string(number);
  line.origin = {skeleton.fileName(skeleton.bones[static_cast<std::size_t>(bone)].parent), {beside, 0.0f, beside}, {}};
  line.insertion = {skeleton.fileName(bone), {beside, beside, beside}, {}};
  return line;
}

Driver driverBy(DriverInputKind kind, const std::string& bone, const Rig& rig) {
  Driver driver;
  driver.input.kind = kind;
  driver.input.bone = bone;
  driver.input.line = rig.lines.front().name;
  driver.input.channel = rig.channels.front().name;
  driver.input.from = {bone, {0.0f, 0.0f, 0.0f}, {}};
  driver.input.to = {bone, {0.0f, 1.0f, 0.0f}, {}};
  driver.curve.points = {{-90.0f, 0.0f}, {0.0f, 0.3f}, {1.0f, 0.6f}, {90.0f, 1.0f}};
  return driver;
}

/// A hundred muscles whose ten numbers have a driver each.
Rig drivenRigOf(const Character& character, const std::vector<int>& bones) {
  Rig rig;
  rig.channels = {{"effort", {{}, {{{0.0f, 0.0f}, {1.0f, 1.0f}}, CurveKind::kSmooth}, {}}}};
  rig.lines = {lineOver(character, bones.front(), 0)};
  for (int i = 0; i < kDrivers / 10; ++i) {
    Primitive primitive;
    primitive.name = std::to_string(i);
    const std::string& bone = character.skeleton.fileName(bones[static_cast<std::size_t>(i) % bones.size()]);
    primitive.bone = bone;
    for (int p = 0; p < 10; ++p) {
      const auto kind = static_cast<DriverInputKind>((i + p) % 7);
      primitive.animated.push_back({static_cast<Parameter>(p), {}, {driverBy(kind, bone, rig)}, {}});
    }
    rig.primitives.push_back(std::move(primitive));
  }
  return rig;
}

template <class Task>
void timed(Work& work, const Task& task) {
  Stopwatch watch;
  task();
  work.seconds.push_back(watch.lap());
}

/// Skinning comes first. The character has bones with parents.
std::vector<AnimationCost> measureAnimation(const Character& character, int rounds) {
  const Skeleton& skeleton = character.skeleton;
  const std::vector<int> bones = joints(skeleton);
  std::vector<std::optional<LineRest>> rests;
  for (int i = 0; i < kLines; ++i) {
    const int bone = bones[static_cast<std::size_t>(i) % bones.size()];
    const Result<LineRest> rest = lineRest(lineOver(character, bone, i), character);
    rests.push_back(rest ? std::optional(rest.value()) : std::nullopt);
  }
  const Rig rig = drivenRigOf(character, bones);
  const DrivenNumbers numbers(rig, character);
  const RigNumbers drawn = drawnNumbers(rig);
  RigNumbers driven;
  DriverScratch drivers;

  std::vector<Work> works{{{"skinning, vertices", static_cast<int>(character.mesh.positions.size()), 0.0, 1.0}, {}},
                          {{"lines", kLines, 0.0, 1.0}, {}},
                          {{"drivers", kDrivers, 0.0, 1.0}, {}}};
  SkinnedMesh skinned;
  LineScratch scratch;
  std::vector<PosedLine> posed;
  const AnimationClip* clip = character.clips.empty() ? nullptr : &character.clips.front();
  for (int round = 0; round < rounds; ++round) {
    const float share = static_cast<float>(round) / static_cast<float>(rounds);
    const Pose pose = clip ? samplePose(skeleton, *clip, share * clip->duration) : restPose(skeleton);
    timed(works[0], [&] { skin(character, pose, skinned); });
    timed(works[1], [&] { poseLines(rests, skeleton, pose, scratch, posed); });
    timed(works[2], [&] {
      driven = drawn;
      numbers.apply(pose, skeleton, drivers, driven);
    });
  }
  std::vector<AnimationCost> costs;
  for (Work& work : works) {
    work.cost.seconds = median(work.seconds);
    work.cost.ratio = medianRatio(work.seconds, works.front().seconds);
    costs.push_back(work.cost);
  }
  return costs;
}

std::string tableOf(const std::vector<AnimationCost>& costs) {
  std::string table =
      "one pose: milliseconds, median; ratio to skinning within one round, median\n"
      "what                  count      ms    ratio\n";
  for (const AnimationCost& cost : costs) {
    char row[120];
    std::snprintf(row, sizeof row, "%-20s %6d  %6.3f  %7.2f\n", cost.what.c_str(), cost.count, 1e3 * cost.seconds,
                  cost.ratio);
    table += row;
  }
  return table;
}

}  // namespace

Result<Report> reportAnimation(Files files, const Effort& effort) {
  const Result<BenchScene> scene = openScene(files.front());
  if (!scene) return scene.error();
  if (joints(scene->character->skeleton).empty()) {
    return Error{files.front().string(), "", "this character has no joint: there is nothing to span or drive"};
  }
  return Report{tableOf(measureAnimation(*scene->character, effort.rounds))};
}

}  // namespace sinew::app
