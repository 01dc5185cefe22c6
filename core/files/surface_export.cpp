// core/files/surface_export.cpp: chooses the format; code shared by the formats.
#include "sinew/files/surface_export.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>

#include <stb_image_write.h>

#include "core/files/disk/atomic_file.h"
#include "core/files/gltf/material.h"
#include "core/files/surface_formats.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"

namespace sinew {
namespace {

void appendBytes(void* out, void* bytes, int count) {
  static_cast<std::string*>(out)->append(static_cast<const char*>(bytes), toIndex(count));
}

Result<void> writeObj(const Surface& surface, const Character& character, const std::filesystem::path& file) {
  const ObjFiles files = objFiles(surface, character, file.stem().string());
  if (files.sides.empty()) return writeFileAtomically(file, files.obj);
  std::vector<NamedBytes> all;
  for (const SideFile& side : files.sides) all.push_back({file.parent_path() / side.name, side.bytes});
  all.push_back({file, files.obj});
  return writeFilesAtomically(all);
}

Result<void> writePly(const Surface& surface, const Character& /*character*/, const std::filesystem::path& file) {
  return writeFileAtomically(file, plyBytes(surface));
}

Result<void> writeGlb(const Surface& surface, const Character& character, const std::filesystem::path& file) {
  const auto bytes = glbBytes(surface, character);
  if (!bytes) return Error{file.string(), bytes.error().place, bytes.error().reason};
  return writeFileAtomically(file, bytes.value());
}

/// A new format is one row and its writer. @param file  in an existing folder
struct SurfaceFormat {
  std::string_view ending;  ///< Lower case.
  Result<void> (*write)(const Surface& surface, const Character& character, const std::filesystem::path& file);
};
constexpr SurfaceFormat kSurfaceExportFormats[] = {{".obj", writeObj}, {".ply", writePly}, {".glb", writeGlb}};

const SurfaceFormat* findFormat(const std::filesystem::path& file) {
  const auto* const found = std::ranges::find(kSurfaceExportFormats, lowerEnding(file), &SurfaceFormat::ending);
  return found == std::end(kSurfaceExportFormats) ? nullptr : found;
}

}  // namespace

std::vector<MaterialRun> materialRuns(const Surface& surface, const Character& character) {
  const std::vector<int>& begin = surface.refinement->triangleBegin;
  std::vector<MaterialRun> runs;
  for (std::size_t t = 0; t < character.mesh.triangles.size(); ++t) {
    const int material = character.mesh.triangles[t].material;
    if (runs.empty() || runs.back().material != material) runs.push_back({material, toIndex(begin[t]), 0});
    runs.back().end = toIndex(begin[t + 1]);
  }
  return runs;
}

std::vector<int> usedMaterials(const Surface& surface, const Character& character) {
  std::set<int> used;
  for (const MaterialRun& run : materialRuns(surface, character)) used.insert(run.material);
  return {used.begin(), used.end()};
}

std::vector<int> usedTextures(const std::vector<int>& materials, const Character& character, Maps maps) {
  std::set<int> used;
  for (const int index : materials) {
    const Material& material = at(character.materials, index);
    used.insert(material.baseColorTexture);
    if (maps == Maps::kBaseColor) continue;
    for (const TextureMap* map :
         {&material.metallicRoughnessMap, &material.normalMap, &material.occlusionMap, &material.emissiveMap}) {
      used.insert(map->texture);
    }
  }
  used.erase(-1);
  return {used.begin(), used.end()};
}

ImageFile imageFile(const Texture& texture) {
  const std::string_view encoded(reinterpret_cast<const char*>(texture.encoded.data()), texture.encoded.size());
  const std::string ending(imageEnding(texture.encoded));
  if (!ending.empty()) return {std::string(encoded), ending == ".png" ? "image/png" : "image/jpeg", ending};
  ImageFile made{{}, "image/png", ".png"};
  stbi_write_png_to_func(appendBytes, &made.bytes, texture.width, texture.height, 4, texture.rgba.data(),
                         texture.width * 4);
  return made;
}

bool isExportName(const std::filesystem::path& file) { return findFormat(file) != nullptr; }

std::string exportNameEndings() {
  std::vector<std::string> endings;
  for (const SurfaceFormat& format : kSurfaceExportFormats) endings.emplace_back(format.ending);
  return listed(endings, "or");
}

Result<void> exportSurface(const Surface& surface, const Character& character, const std::filesystem::path& file) {
  const SurfaceFormat* const format = findFormat(file);
  if (!format) return Error{file.string(), {}, "expected a name that ends in " + exportNameEndings()};
  if (!surface.refinement || surface.refinement->triangles.empty()) {
    return Error{file.string(), {}, "cannot be written: the surface has no triangles"};
  }
  if (!std::ranges::all_of(surface.positions, [](const glm::vec3& p) { return isFinite(p); })) {
    return Error{file.string(),
                 {},
                 "cannot be written: bones are moved or scaled so far that places are no longer finite numbers"};
  }
  // Before side files are written, so that the message names the requested file.
  std::error_code unknown;
  if (file.has_parent_path() && !std::filesystem::is_directory(file.parent_path(), unknown)) {
    return Error{file.string(), {}, "cannot be written: there is no such folder"};
  }
  return format->write(surface, character, file);
}

}  // namespace sinew
