// core/io/surface_export.cpp: picks the format; what the formats share.
#include "sinew/io/surface_export.h"
#include "core/base/lower_case.h"

#include <algorithm>
#include <set>
#include <string_view>

#include <stb_image_write.h>

#include "core/io/files/atomic_file.h"
#include "core/io/surface_formats.h"

namespace sinew {
namespace {

bool startsWith(const std::vector<std::uint8_t>& bytes, std::initializer_list<std::uint8_t> magic) {
  return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

void appendBytes(void* out, void* bytes, int count) {
  static_cast<std::string*>(out)->append(static_cast<const char*>(bytes), static_cast<std::size_t>(count));
}

Result<void> writeObj(const Surface& surface, const Character& character, const std::filesystem::path& file) {
  const ObjFiles files = objFiles(surface, character, file.stem().string());
  for (const SideFile& side : files.sides) {
    if (auto written = writeFileAtomically(file.parent_path() / side.name, side.bytes); !written) return written;
  }
  return writeFileAtomically(file, files.obj);
}

}  // namespace

std::vector<MaterialRun> materialRuns(const Surface& surface, const Character& character) {
  const auto split =
      static_cast<std::size_t>(surface.refinement->depth) * static_cast<std::size_t>(surface.refinement->depth);
  std::vector<MaterialRun> runs;
  for (std::size_t t = 0; t < character.mesh.triangles.size(); ++t) {
    const int material = character.mesh.triangles[t].material;
    if (runs.empty() || runs.back().material != material) runs.push_back({material, t * split, t * split});
    runs.back().end += split;
  }
  return runs;
}

std::vector<int> usedMaterials(const Surface& surface, const Character& character) {
  std::set<int> used;
  for (const MaterialRun& run : materialRuns(surface, character)) used.insert(run.material);
  return {used.begin(), used.end()};
}

std::vector<int> usedTextures(const std::vector<int>& materials, const Character& character) {
  std::set<int> used;
  for (const int material : materials) {
    const int texture = character.materials[static_cast<std::size_t>(material)].baseColorTexture;
    if (texture >= 0) used.insert(texture);
  }
  return {used.begin(), used.end()};
}

ImageFile imageFile(const Texture& texture) {
  const std::string_view encoded(reinterpret_cast<const char*>(texture.encoded.data()), texture.encoded.size());
  if (startsWith(texture.encoded, {0x89, 'P', 'N', 'G'})) return {std::string(encoded), "image/png", ".png"};
  if (startsWith(texture.encoded, {0xFF, 0xD8, 0xFF})) return {std::string(encoded), "image/jpeg", ".jpg"};
  ImageFile made{{}, "image/png", ".png"};
  stbi_write_png_to_func(appendBytes, &made.bytes, texture.width, texture.height, 4, texture.rgba.data(),
                         texture.width * 4);
  return made;
}

bool isExportName(const std::filesystem::path& file) {
  const std::string ending = lowerEnding(file);
  return ending == ".obj" || ending == ".ply" || ending == ".glb";
}

Result<void> exportSurface(const Surface& surface, const Character& character, const std::filesystem::path& file) {
  if (!isExportName(file)) return Error{file.string(), {}, "expected a name that ends in .obj, .ply or .glb"};
  if (!surface.refinement || surface.refinement->triangles.empty()) {
    return Error{file.string(), {}, "cannot be written: the surface has no triangles"};
  }
  // Before files beside it are written: the message names what was asked for.
  std::error_code unknown;
  if (file.has_parent_path() && !std::filesystem::is_directory(file.parent_path(), unknown)) {
    return Error{file.string(), {}, "cannot be written: there is no such folder"};
  }
  const std::string ending = lowerEnding(file);
  if (ending == ".obj") return writeObj(surface, character, file);
  if (ending == ".ply") return writeFileAtomically(file, plyBytes(surface));
  const auto bytes = glbBytes(surface, character);
  if (!bytes) return Error{file.string(), bytes.error().place, bytes.error().reason};
  return writeFileAtomically(file, bytes.value());
}

}  // namespace sinew
