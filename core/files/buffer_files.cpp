// core/files/buffer_files.cpp: by the JSON alone.
#include "core/files/buffer_files.h"

#include <cstdint>
#include <exception>
#include <string>
#include <system_error>

#include "core/files/gltf/file.h"
#include "core/files/gltf/uri.h"
#include "core/geometry/lower_case.h"

namespace sinew {

std::vector<std::filesystem::path> bufferFilesOf(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> files;
  if (lowerCase(file.extension().string()) != ".gltf") return files;
  try {
    const std::vector<std::uint8_t> contents = gltf::contentsOf(file);
    const Json root = gltf::parseJson(gltf::openContainer(contents).json, "extras");
    for (const Json& buffer : root.at("buffers").items()) {
      const std::string uri = buffer.at("uri").text("");
      if (uri.empty() || gltf::isDataUri(uri) || gltf::isFallback(buffer)) continue;
      const Result<std::filesystem::path> relative = gltf::relativePathOf(uri);
      if (!relative) continue;
      const std::filesystem::path folder = gltf::folderOf(file);
      const std::filesystem::path named = folder / relative.value();
      std::error_code failed;
      if (gltf::placeInside(folder, relative.value()) || !std::filesystem::exists(named, failed))
        files.push_back(named);
    }
  } catch (const gltf::Refusal&) {
    files.clear();
  } catch (const std::exception&) {
    files.clear();
  }
  return files;
}

}  // namespace sinew
