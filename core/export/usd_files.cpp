// core/export/usd_files.cpp: glTF in memory, read again, written as USD.
#include "core/export/usd_files.h"

#include <utility>

#include "core/export/out_files.h"
#include "core/io/files/atomic_file.h"

namespace sinew::exporting {
namespace {

Result<usd::Stage> stageOf(const Source& source, const PackedGltf& packed, const std::filesystem::path& file,
                           const usd::PointMoments* moments) {
  const Result<std::string> bytes = glbOf(packed);
  if (!bytes) return Error{file.string(), {}, bytes.error().reason};
  // Images that could not be read are named from the source's folder.
  const std::filesystem::path folder = source.path.parent_path();
  gltf::File again({bytes->begin(), bytes->end()}, folder.empty() ? std::filesystem::path(".") : folder);
  const std::string stem = file.stem().string();
  return moments ? usd::pointStage(again, packed.root, stem, *moments) : usd::skinnedStage(again, packed.root, stem);
}

}  // namespace

Result<std::uint64_t> writeUsd(const Source& source, const PackedGltf& packed, const std::filesystem::path& file,
                               std::vector<std::string>& left, const usd::PointMoments* moments) {
  auto stage = stageOf(source, packed, file, moments);
  if (!stage) return stage.error();
  left.insert(left.end(), stage->left.begin(), stage->left.end());
  std::vector<std::filesystem::path> places;
  std::vector<NamedBytes> files;
  for (const SideFile& texture : stage->textures) {
    files.push_back({file.parent_path() / texture.name, texture.bytes});
  }
  files.push_back({file, stage->text});
  std::uint64_t bytes = 0;
  for (const NamedBytes& each : files) {
    places.push_back(each.file);
    bytes += each.bytes.size();
  }
  if (auto free = checkPlaces(source, places); !free) return free.error();
  if (auto written = files.size() == 1 ? writeFileAtomically(file, files.front().bytes) : writeFilesAtomically(files);
      !written) {
    return written.error();
  }
  return bytes;
}

}  // namespace sinew::exporting
