// python/module/bone_nodes.h: which nodes of its file a character's bones are.
#pragma once

#include <filesystem>
#include <vector>

#include "sinew/character/skeleton.h"
#include "sinew/geometry/result.h"

namespace sinew::python {

/// [bones] number of the node in the file. A character keeps no numbers of its file: it is opened again, and refused if
/// its bones are others now.
[[nodiscard]] Result<std::vector<int>> nodesOfBones(const std::filesystem::path& file, const Skeleton& skeleton);

}  // namespace sinew::python
