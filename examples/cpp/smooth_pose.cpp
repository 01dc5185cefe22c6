// examples/cpp/smooth_pose.cpp: the surface of one moment of a clip, as a file. smooth_pose RIG CLIP SECONDS OUT.ply
#include <cstdio>
#include <cstdlib>

#include "sinew/sinew.h"

namespace {

int fail(const sinew::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return 1;
}

const sinew::AnimationClip* findClip(const sinew::Character& character, const std::string& name) {
  for (const sinew::AnimationClip& clip : character.clips) {
    if (clip.name == name) return &clip;
  }
  return nullptr;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fprintf(stderr, "usage: smooth_pose RIG CLIP SECONDS OUT.(ply|obj|glb)\n");
    return 2;
  }
  const auto rig = sinew::loadRig(argv[1]);
  if (!rig) return fail(rig.error());
  const auto imported = sinew::importGltf(sinew::characterPath(rig.value(), argv[1]));
  if (!imported) return fail(imported.error());
  const sinew::Character& character = *imported.value();
  const sinew::AnimationClip* clip = findClip(character, argv[2]);
  if (clip == nullptr) return fail(sinew::errorAt(argv[2], "the character has no clip of this name"));

  sinew::Smoother smoother(imported.value());
  if (const auto prepared = smoother.prepare(rig.value()); !prepared) return fail(prepared.error());
  const auto seconds = static_cast<float>(std::atof(argv[3]));
  sinew::Surface surface;
  smoother.smooth(sinew::samplePose(character, *clip, seconds), surface);

  if (const auto written = sinew::exportSurface(surface, character, argv[4]); !written) return fail(written.error());
  std::printf("%s: %zu vertices, %zu triangles\n", argv[4], surface.positions.size(),
              surface.refinement->triangles.size());
  return 0;
}
