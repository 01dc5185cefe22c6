// examples/cpp/play_clip.cpp: a clip frame by frame, as a game would play it. play_clip RIG CLIP FPS
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "sinew/sinew.h"

namespace {

int fail(const sinew::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return 1;
}

/// What a renderer does with a surface. Its topology, `surface.refinement`, is the same in each frame and is uploaded
/// once; only positions and normals change.
void show(int frame, float seconds, const sinew::Surface& surface) {
  float largest = 0.0f;
  for (const float displacement : surface.displacement) largest = std::max(largest, std::abs(displacement));
  std::printf("frame %d, %.3f s: %zu vertices, skin moved by %.4f at most\n", frame, static_cast<double>(seconds),
              surface.positions.size(), static_cast<double>(largest));
}

}  // namespace

int main(int argc, char** argv) {
  const double framesPerSecond = argc == 4 ? std::atof(argv[3]) : 0.0;
  if (!(framesPerSecond > 0.0)) {
    std::fprintf(stderr, "usage: play_clip RIG CLIP FPS\n");
    return 2;
  }
  const auto rig = sinew::loadRig(argv[1]);
  if (!rig) return fail(rig.error());
  const auto imported = sinew::importGltf(sinew::characterPath(rig.value(), argv[1]));
  if (!imported) return fail(imported.error());
  const sinew::Character& character = *imported.value();
  const auto clip = std::ranges::find(character.clips, std::string(argv[2]), &sinew::AnimationClip::name);
  if (clip == character.clips.end()) return fail(sinew::errorAt(argv[2], "the character has no clip of this name"));

  // Prepared once. Another prepare() is due when the rig is edited, not when the pose changes.
  sinew::Smoother smoother(imported.value());
  if (const auto prepared = smoother.prepare(rig.value()); !prepared) return fail(prepared.error());

  sinew::Surface surface;  // Outside the loop: its memory is used again.
  const auto frames = static_cast<int>(std::ceil(static_cast<double>(clip->duration) * framesPerSecond));
  for (int frame = 0; frame < frames; ++frame) {
    const auto seconds = static_cast<float>(frame / framesPerSecond);
    smoother.smooth(sinew::samplePose(character, *clip, seconds), surface);
    show(frame, seconds, surface);
  }
  return 0;
}
