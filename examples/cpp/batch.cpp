// examples/cpp/batch.cpp: every rig of a folder as a mesh in the middle of its character's first clip. batch FOLDER OUT
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "sinew/sinew.h"

namespace {

/// A rig's surface as a file; what is wrong with one is no reason to leave out the others.
sinew::Result<void> make(const std::filesystem::path& file, const std::filesystem::path& out) {
  const auto rig = sinew::loadRig(file);
  if (!rig) return rig.error();
  const auto imported = sinew::importGltf(sinew::characterPath(rig.value(), file));
  if (!imported) return imported.error();
  const sinew::Character& character = *imported.value();
  sinew::Smoother smoother(imported.value());
  if (const auto prepared = smoother.prepare(rig.value()); !prepared) return prepared;

  const bool moves = !character.clips.empty();
  const sinew::Pose pose = moves ? sinew::samplePose(character, character.clips[0], 0.5f * character.clips[0].duration)
                                 : sinew::bindPose(character.skeleton);
  sinew::Surface surface;
  if (!smoother.smooth(pose, surface)) return checkPose(character, pose);
  if (const auto written = sinew::exportSurface(surface, character, out); !written) return written;
  std::printf("%s: %s, %zu muscles, %zu vertices\n", out.filename().string().c_str(),
              moves ? character.clips[0].name.c_str() : "bind pose", rig->primitives.size(), surface.positions.size());
  return {};
}

/// Sorted: the same folder makes the same table everywhere.
std::vector<std::filesystem::path> rigsIn(const std::filesystem::path& folder, std::error_code& error) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().string().ends_with(".rig.json")) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: batch FOLDER OUT\n");
    return 2;
  }
  std::error_code error;
  const auto files = rigsIn(argv[1], error);
  if (!error) std::filesystem::create_directories(argv[2], error);
  if (error) {
    std::fprintf(stderr, "%s: %s\n", argv[1], error.message().c_str());
    return 1;
  }
  std::size_t failed = 0;
  for (const auto& file : files) {
    const std::string name = file.filename().string();
    const auto made = make(file, std::filesystem::path(argv[2]) / (name.substr(0, name.size() - 9) + ".ply"));
    if (made) continue;
    std::fprintf(stderr, "%s\n", made.error().text().c_str());
    ++failed;
  }
  std::printf("%zu of %zu rigs\n", files.size() - failed, files.size());
  return failed == 0 ? 0 : 1;
}
