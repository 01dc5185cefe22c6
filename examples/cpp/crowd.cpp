// examples/cpp/crowd.cpp: many instances of one character at once, on all cores. crowd RIG CLIP COUNT
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "sinew/sinew.h"

namespace {

int fail(const sinew::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return 1;
}

/// Instances that walk out of step: each is at another moment of the clip.
std::vector<sinew::Pose> outOfStep(const sinew::Character& character, const sinew::AnimationClip& clip, int count) {
  std::vector<sinew::Pose> poses;
  for (int i = 0; i < count; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(count);
    poses.push_back(sinew::samplePose(character, clip, share * clip.duration));
  }
  return poses;
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc == 4 ? std::atoi(argv[3]) : 0;
  if (count < 1) {
    std::fprintf(stderr, "usage: crowd RIG CLIP COUNT\n");
    return 2;
  }
  const auto rig = sinew::loadRig(argv[1]);
  if (!rig) return fail(rig.error());
  const auto imported = sinew::importGltf(sinew::characterPath(rig.value(), argv[1]));
  if (!imported) return fail(imported.error());
  const sinew::Character& character = *imported.value();
  const auto clip = std::ranges::find(character.clips, std::string(argv[2]), &sinew::AnimationClip::name);
  if (clip == character.clips.end()) return fail(sinew::errorAt(argv[2], "the character has no clip of this name"));

  sinew::CrowdSmoother crowd(imported.value());
  if (const auto prepared = crowd.prepare(rig.value()); !prepared) return fail(prepared.error());
  const std::vector<sinew::Pose> poses = outOfStep(character, *clip, count);
  std::vector<sinew::Surface> surfaces(poses.size());
  crowd.smooth(poses, surfaces);  // The first frame takes memory.
  const auto before = std::chrono::steady_clock::now();
  crowd.smooth(poses, surfaces);
  const std::chrono::duration<double, std::milli> frame = std::chrono::steady_clock::now() - before;
  std::printf("%zu surfaces of %zu vertices, on %d threads: %.2f ms each\n", surfaces.size(),
              surfaces.front().positions.size(), sinew::threadCount(), frame.count() / count);

  // The number of threads cannot be seen in the result: the last surface again, alone on this thread.
  const sinew::ThreadLimit one(1);
  crowd.smooth(std::span(poses).last(1), std::span(surfaces).first(1));
  const bool same = surfaces.front().positions == surfaces.back().positions;
  std::printf("on one thread: %s\n", same ? "the same bits" : "another surface");
  return same ? 0 : 1;
}
