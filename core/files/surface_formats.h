// core/files/surface_formats.h: a surface as the bytes of each file format; surface_export.h writes them.
#pragma once

#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/surface/surface.h"

namespace sinew {

/// A run of refined triangles [begin, end) of one material.
struct MaterialRun {
  int material = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// In triangle order; neighbors differ in material.
[[nodiscard]] std::vector<MaterialRun> materialRuns(const Surface& surface, const Character& character);

/// Indices of the materials that some triangle has, ascending; and of the textures these materials have, likewise.
[[nodiscard]] std::vector<int> usedMaterials(const Surface& surface, const Character& character);
enum class Maps { kBaseColor, kAll };
[[nodiscard]] std::vector<int> usedTextures(const std::vector<int>& materials, const Character& character, Maps maps);

/// An image as other programs read it.
struct ImageFile {
  std::string bytes;
  std::string mimeType;  ///< "image/png" or "image/jpeg".
  std::string ending;    ///< ".png" or ".jpg".
};

/// The PNG or JPEG the texture came from; a PNG made from its pixels if it was another kind of file or none.
[[nodiscard]] ImageFile imageFile(const Texture& texture);

/// A file beside the one that was asked for.
struct SideFile {
  std::string name;
  std::string bytes;
};

struct ObjFiles {
  std::string obj;
  std::vector<SideFile> sides;  ///< Textures, then the .mtl.
};

/// A name as .obj and .mtl can hold it: one word that starts no comment.
[[nodiscard]] std::string asWord(std::string name);

/// @param stem of the .obj's name: side files are called after it.
[[nodiscard]] ObjFiles objFiles(const Surface& surface, const Character& character, const std::string& stem);

[[nodiscard]] std::string plyBytes(const Surface& surface);

/// Error: over 4 GiB, the most a .glb can hold.
[[nodiscard]] Result<std::string> glbBytes(const Surface& surface, const Character& character);

}  // namespace sinew
