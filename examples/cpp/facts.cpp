// examples/cpp/facts.cpp: what a file holds, or what is wrong with it. facts CHARACTER.(glb|gltf)|RIG.rig.json
#include <cstdio>
#include <filesystem>

#include "sinew/sinew.h"

namespace {

/// Nothing is thrown: an Error says in which file, where in it and why. Each part may be empty.
int explain(const sinew::Error& error) {
  std::fprintf(stderr, "file: %s\nplace: %s\nreason: %s\n", error.file.c_str(), error.place.c_str(),
               error.reason.c_str());
  return 1;
}

void printCharacter(const sinew::Character& character) {
  std::printf("%s: %zu vertices, %zu triangles, %zu bones, height %.3f\n", character.name.c_str(),
              character.mesh.positions.size(), character.mesh.triangles.size(), character.skeleton.bones.size(),
              static_cast<double>(character.height));
  for (const sinew::AnimationClip& clip : character.clips) {
    std::printf("clip \"%s\", %.2f s\n", clip.name.c_str(), static_cast<double>(clip.duration));
  }
  for (const std::string& ignored : character.ignored) std::printf("not used: %s\n", ignored.c_str());
}

/// A bone that the character lacks is no error: its muscles wait for another character.
int printRig(const sinew::Rig& rig, const std::shared_ptr<const sinew::Character>& character) {
  sinew::Smoother smoother(character);
  if (const auto prepared = smoother.prepare(rig); !prepared) return explain(prepared.error());
  std::printf("%zu muscles, %zu lines, %zu groups, mode %s\n", rig.primitives.size(), rig.lines.size(),
              rig.groups.size(), sinew::nameOf(rig.surface.mode));
  for (const int index : smoother.unattached()) {
    const sinew::Primitive& muscle = rig.primitives[static_cast<std::size_t>(index)];
    std::printf("\"%s\" has no bone \"%s\" here\n", muscle.name.c_str(), muscle.bone.c_str());
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: facts CHARACTER|RIG\n");
    return 2;
  }
  const std::filesystem::path file = argv[1];
  if (file.extension() != ".json") {
    const auto character = sinew::importGltf(file);
    if (!character) return explain(character.error());
    printCharacter(*character.value());
    return 0;
  }
  const auto rig = sinew::loadRig(file);
  if (!rig) return explain(rig.error());
  const auto character = sinew::importGltf(sinew::characterPath(rig.value(), file));
  if (!character) return explain(character.error());
  printCharacter(*character.value());
  return printRig(rig.value(), character.value());
}
