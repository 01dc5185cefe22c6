// core/files/surface_formats.h: a surface as the bytes of each file format.
#pragma once

#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/surface/surface.h"

namespace sinew {

/// Refined triangles [begin, end) of one material.
struct MaterialRun {
  int material = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// In triangle order.
[[nodiscard]] std::vector<MaterialRun> materialRuns(const Surface& surface, const Character& character);

/// Indices of materials in use, ascending, and of their textures.
[[nodiscard]] std::vector<int> usedMaterials(const Surface& surface, const Character& character);
enum class Maps { kBaseColor, kAll };
[[nodiscard]] std::vector<int> usedTextures(const std::vector<int>& materials, const Character& character, Maps maps);

struct ImageFile {
  std::string bytes;
  std::string mimeType;  ///< "image/png" or "image/jpeg".
  std::string ending;    ///< ".png" or ".jpg".
};

/// The texture's original PNG or JPEG, else a PNG made from its pixels.
[[nodiscard]] ImageFile imageFile(const Texture& texture);

struct SideFile {
  std::string name;
  std::string bytes;
};

struct ObjFiles {
  std::string obj;
  std::vector<SideFile> sides;  ///< Textures, then the .mtl.
};

/// A name for .obj and .mtl: one word that does not start a comment.
[[nodiscard]] std::string asWord(std::string name);

/// @param stem  of the .obj's name, for the names of side files
[[nodiscard]] ObjFiles objFiles(const Surface& surface, const Character& character, const std::string& stem);

[[nodiscard]] std::string plyBytes(const Surface& surface);

/// Error: over 4 GiB, the most a .glb can hold.
[[nodiscard]] Result<std::string> glbBytes(const Surface& surface, const Character& character);

}  // namespace sinew
