// examples/cpp/detail.cpp: one character near, far, and near in a part of its body. detail FILE.sinew BONE ...
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

#include "sinew/runtime/runtime.h"

namespace {

int fail(const sinew::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return 1;
}

/// Plays the first clip once and says what a frame takes.
void play(const char* what, sinew::Smoother& smoother) {
  using Clock = std::chrono::steady_clock;
  const sinew::AnimationClip& clip = smoother.character().clips[0];
  constexpr int kFrames = 48;
  sinew::Surface surface;
  smoother.smooth(sinew::samplePose(smoother.character(), clip, 0.0f), surface);  // The first frame takes memory.
  std::chrono::duration<double, std::milli> sum{};
  for (int frame = 0; frame < kFrames; ++frame) {
    const float seconds = clip.duration * static_cast<float>(frame) / kFrames;
    const sinew::Pose pose = sinew::samplePose(smoother.character(), clip, seconds);
    const auto before = Clock::now();
    smoother.smooth(pose, surface);
    sum += Clock::now() - before;
  }
  std::printf("%s: %zu vertices, %.2f ms a frame\n", what, surface.positions.size(), sum.count() / kFrames);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: detail FILE.sinew BONE ...\n");
    return 2;
  }
  std::ifstream in(argv[1], std::ios::binary);
  const std::vector<char> file{std::istreambuf_iterator<char>(in), {}};
  const auto game = sinew::readGameFile(std::as_bytes(std::span(file)));
  if (!game) return fail(game.error());
  const sinew::Character& character = *game->character;
  if (character.clips.empty()) return fail(sinew::errorAt(argv[1], "the character has no clip"));
  std::vector<int> bones;
  for (int i = 2; i < argc; ++i) {
    const auto bone = character.skeleton.findBone(argv[i]);
    if (!bone) return fail(sinew::errorAt(argv[i], "the character has no such bone"));
    bones.push_back(*bone);
  }

  // Twins share what does not depend on the detail.
  sinew::Smoother near(game->character);
  if (const auto prepared = near.prepare(game->rig); !prepared) return fail(prepared.error());
  sinew::Smoother far = near.twin(), part = near.twin();
  sinew::Rig coarse = game->rig;
  coarse.smoothing.detail = sinew::DetailKind::kUniform;
  coarse.smoothing.depth = 1;
  if (const auto prepared = far.prepare(coarse); !prepared) return fail(prepared.error());
  const auto prepared = part.prepare(game->rig, {}, sinew::regionOfBones(character, bones));
  if (!prepared) return fail(prepared.error());
  const sinew::ThreadLimit one(1);
  play("near", near);
  play("far", far);
  play("part", part);
  return 0;
}
