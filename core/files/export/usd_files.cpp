// core/files/export/usd_files.cpp: glTF in memory, read again, written as USD.
#include "core/files/export/usd_files.h"

#include <utility>

#include "core/files/export/formats.h"
#include "core/files/export/out_files.h"

namespace sinew::exporting {
namespace {

Result<usd::Stage> stageOf(const Source& source, const PackedGltf& packed, const std::filesystem::path& file,
                           const usd::PointMoments* moments) {
  const Result<std::string> bytes = glbOf(packed);
  if (!bytes) return Error{file.string(), {}, bytes.error().reason};
  // Images that could not be read are named from the source's folder.
  gltf::File again({bytes->begin(), bytes->end()}, gltf::folderOf(source.path));
  const std::string stem = file.stem().string();
  return moments ? usd::pointStage(again, packed.root, stem, *moments) : usd::skinnedStage(again, packed.root, stem);
}

}  // namespace

Result<std::uint64_t> writeStage(const Source& source, const PackedGltf& packed, const std::filesystem::path& file,
                                 std::vector<std::string>& left, const usd::PointMoments* moments) {
  auto stage = stageOf(source, packed, file, moments);
  if (!stage) return stage.error();
  left.insert(left.end(), stage->left.begin(), stage->left.end());
  std::vector<NamedBytes> files;
  for (const SideFile& texture : stage->textures) {
    files.push_back({file.parent_path() / texture.name, texture.bytes});
  }
  files.push_back({file, stage->text});
  return writeFiles(source, files);
}

Result<std::uint64_t> writeUsd(const Source& source, const PackedGltf& packed, const std::filesystem::path& file,
                               std::vector<std::string>& left) {
  return writeStage(source, packed, file, left, nullptr);
}

}  // namespace sinew::exporting
