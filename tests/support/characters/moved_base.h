// tests/support/characters/moved_base.h: a file whose morph targets are applied to its base positions.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sinew::test {

/// The file as .glb with POSITION as the oracle morphs it, without targets and clips. Knows float positions, tightly
/// packed or not, and meshes that one node shows.
/// @param weights  of all targets, node by node
[[nodiscard]] std::string movedBase(const std::filesystem::path& file, const std::vector<float>& weights);

}  // namespace sinew::test
