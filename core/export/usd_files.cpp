// core/export/usd_files.cpp: glTF in memory, read again, written as USD.
#include "core/export/usd_files.h"

namespace sinew::exporting {

Result<std::vector<OutFile>> usdFiles(const PackedGltf& packed, const std::filesystem::path& folder,
                                      const std::filesystem::path& file, std::vector<std::string>& left,
                                      const usd::PointMoments* moments) {
  const Result<std::string> bytes = glbOf(packed);
  if (!bytes) return Error{file.string(), {}, bytes.error().reason};
  gltf::File again({bytes->begin(), bytes->end()}, folder.empty() ? std::filesystem::path(".") : folder);
  const std::string stem = file.stem().string();
  usd::Stage stage =
      moments ? usd::pointStage(again, packed.root, stem, *moments) : usd::skinnedStage(again, packed.root, stem);
  left.insert(left.end(), stage.left.begin(), stage.left.end());
  std::vector<OutFile> files;
  for (SideFile& texture : stage.textures) {
    files.push_back({file.parent_path() / texture.name, std::move(texture.bytes)});
  }
  files.push_back({file, std::move(stage.text)});
  return files;
}

}  // namespace sinew::exporting
