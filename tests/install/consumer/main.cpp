// tests/install/consumer/main.cpp: opens a rig, smooths its character in the bind pose, prints what came out.
#include <cstdio>

#include "sinew/sinew.h"

namespace {

int fail(const sinew::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const auto rig = sinew::loadRig(argv[1]);
  if (!rig) return fail(rig.error());
  const auto character = sinew::importGltf(sinew::characterPath(rig.value(), argv[1]));
  if (!character) return fail(character.error());
  sinew::Smoother smoother(character.value());
  if (const auto prepared = smoother.prepare(rig.value()); !prepared) return fail(prepared.error());
  sinew::Surface surface;
  smoother.smooth(sinew::bindPose(character.value()->skeleton), surface);
  std::printf("%zu vertices\n", surface.positions.size());
  return smoother.unattached().empty() ? 0 : 1;
}
